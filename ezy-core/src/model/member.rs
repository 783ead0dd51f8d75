//! Where a member of an array stands.

/// The `D` indices of a member: a number, or an array of numbers.
pub trait ArrayIndex<const D: usize> {
    /// Outermost first.
    fn indices(self) -> [usize; D];
}

impl ArrayIndex<1> for usize {
    fn indices(self) -> [usize; 1] {
        [self]
    }
}

impl<const D: usize> ArrayIndex<D> for [usize; D] {
    fn indices(self) -> [usize; D] {
        self
    }
}

/// Place of a member when each index has a first value and a number of values, and the last one changes first.
pub(super) fn place<const D: usize>(index: [usize; D], ranges: [(usize, usize); D]) -> Option<usize> {
    index.into_iter().zip(ranges).try_fold(0, |place, (index, (from, n))| {
        let i = index.checked_sub(from)?;
        (i < n).then_some(place * n + i)
    })
}

/// A whole number of the model file as a size: nothing when it is negative.
pub(super) fn size(number: i64) -> usize {
    usize::try_from(number).unwrap_or(0)
}
