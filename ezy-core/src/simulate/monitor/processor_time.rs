//! The time that a processor has worked for this thread.

use std::time::Duration;

/// Whether the system tells processor time in steps short enough to time a run. Windows has steps of 16 ms.
pub const IS_KNOWN: bool = cfg!(unix);

/// Processor time of this thread since some beginning; wall time where it is not known.
#[cfg(unix)]
pub fn processor_time() -> Duration {
    cpu_time::ThreadTime::try_now().map_or_else(|_| wall_time(), |time| time.as_duration())
}

/// Processor time of this thread since some beginning; wall time where it is not known.
#[cfg(not(unix))]
pub fn processor_time() -> Duration {
    wall_time()
}

fn wall_time() -> Duration {
    use std::sync::LazyLock;
    use std::time::Instant;
    static BEGINNING: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGINNING.elapsed()
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::time::Instant;

    #[test]
    fn invariant_processor_time_does_not_pass_in_sleep() {
        let (began, wall) = (processor_time(), Instant::now());
        std::thread::sleep(Duration::from_millis(50));
        assert!(processor_time() - began < wall.elapsed() / 2);
        while processor_time() - began < Duration::from_millis(5) {
            std::hint::spin_loop();
        }
        assert!(wall.elapsed() >= Duration::from_millis(55));
    }
}
