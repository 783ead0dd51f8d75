//! What goes on from a time, as numbers: written and read by one function for each type, so that both keep to one order.

use crate::scalar::Scalar;

/// Counts below it are exact as doubles.
pub(crate) const LARGEST_COUNT: u64 = 1 << f64::MANTISSA_DIGITS;

/// Numbers to write or to read: in `f64`, and in the numbers `T` of a motion.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Archive<T = f64> {
    numbers: Vec<f64>,
    scalars: Vec<T>,
    /// How many of both were read; none while it is written.
    read: Option<[usize; 2]>,
    /// Whether there were as many as were asked for.
    is_whole: bool,
}

impl<T: Scalar> Archive<T> {
    /// To be written.
    pub(crate) fn new() -> Self {
        Self { numbers: Vec::new(), scalars: Vec::new(), read: None, is_whole: true }
    }

    /// To be read.
    pub(crate) fn of(numbers: Vec<f64>, scalars: Vec<T>) -> Self {
        Self { numbers, scalars, read: Some([0; 2]), is_whole: true }
    }

    /// What was written.
    pub(crate) fn into_parts(self) -> (Vec<f64>, Vec<T>) {
        (self.numbers, self.scalars)
    }

    /// Whether what is asked for is overwritten by what was kept.
    pub(crate) fn is_read(&self) -> bool {
        self.read.is_some()
    }

    /// Whether everything was read that was written, and nothing else.
    pub(crate) fn is_read_whole(&self) -> bool {
        self.is_whole && self.read == Some([self.numbers.len(), self.scalars.len()])
    }

    pub(crate) fn numbers(&mut self, x: &mut [f64]) {
        match &mut self.read {
            None => self.numbers.extend_from_slice(x),
            Some([read, _]) => self.is_whole &= take(&self.numbers, read, x),
        }
    }

    pub(crate) fn scalars(&mut self, x: &mut [T]) {
        match &mut self.read {
            None => self.scalars.extend_from_slice(x),
            Some([_, read]) => self.is_whole &= take(&self.scalars, read, x),
        }
    }

    pub(crate) fn number(&mut self, x: &mut f64) {
        self.numbers(std::slice::from_mut(x));
    }

    pub(crate) fn flag(&mut self, x: &mut bool) {
        let mut number = f64::from(*x);
        self.number(&mut number);
        *x = number != 0.0;
    }

    /// A number of things, exact up to [`LARGEST_COUNT`].
    pub(crate) fn count(&mut self, x: &mut u64) {
        let mut number = *x as f64;
        self.number(&mut number);
        *x = number as u64;
    }

    pub(crate) fn count_of_few(&mut self, x: &mut u32) {
        let mut count = u64::from(*x);
        self.count(&mut count);
        *x = u32::try_from(count).unwrap_or(u32::MAX);
    }

    pub(crate) fn option(&mut self, x: &mut Option<f64>) {
        let (mut is_some, mut number) = (x.is_some(), x.unwrap_or_default());
        self.flag(&mut is_some);
        self.number(&mut number);
        *x = is_some.then_some(number);
    }

    /// Places in a list of `n` things.
    pub(crate) fn places(&mut self, x: &mut Vec<usize>, n: usize) {
        let mut is_in = vec![false; n];
        x.iter().for_each(|&i| is_in[i] = true);
        is_in.iter_mut().for_each(|is_in| self.flag(is_in));
        x.clear();
        x.extend((0..n).filter(|&i| is_in[i]));
    }
}

/// Copies the next ones; whether there are as many.
fn take<T: Copy>(from: &[T], read: &mut usize, x: &mut [T]) -> bool {
    let Some(next) = from.get(*read..*read + x.len()) else { return false };
    x.copy_from_slice(next);
    *read += x.len();
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of one thing of each kind.
    type Things = (bool, u64, u32, Option<f64>, Option<f64>, Vec<usize>, [f64; 2]);

    fn remember((flag, count, few, some, none, places, scalars): &mut Things, archive: &mut Archive) {
        archive.flag(flag);
        archive.count(count);
        archive.count_of_few(few);
        archive.option(some);
        archive.option(none);
        archive.places(places, 5);
        archive.scalars(scalars);
    }

    #[test]
    fn invariant_what_is_read_is_what_was_written() {
        let mut things = (true, 1 << 53, 7, Some(f64::INFINITY), None, vec![0, 3, 4], [-0.0, 1e-308]);
        let mut archive = Archive::new();
        remember(&mut things, &mut archive);
        let (numbers, scalars) = archive.into_parts();
        let read = |numbers: &[f64], scalars: &[f64]| {
            let mut archive = Archive::of(numbers.to_vec(), scalars.to_vec());
            let mut found = (false, 0, 0, None, Some(1.0), vec![1], [1.0; 2]);
            remember(&mut found, &mut archive);
            (found, archive.is_read_whole())
        };
        let (found, is_whole) = read(&numbers, &scalars);
        assert!(is_whole && found == things && found.6[0].is_sign_negative(), "{found:?}");
        // one too few, one too many
        assert!(!read(&numbers[1..], &scalars).1 && !read(&numbers, &scalars[1..]).1);
        assert!(!read(&[&numbers[..], &[0.0]].concat(), &scalars).1);
    }
}
