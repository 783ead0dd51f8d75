//! Steps of work, counted in tests: they show how the macro's time grows without measuring it.

#[cfg(test)]
thread_local! {
    static STEPS: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Counts entries that are visited or written.
#[cfg(test)]
pub fn count(steps: usize) {
    STEPS.set(STEPS.get() + steps);
}

/// Counts nothing outside of tests.
#[cfg(not(test))]
pub fn count(_: usize) {}

/// The steps of this thread so far.
#[cfg(test)]
pub fn steps() -> usize {
    STEPS.get()
}
