//! What the field of an output is.

use super::member::{ArrayIndex, place, size};

/// The two components of an output, along the axes of the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Vector<T = f64> {
    /// First component.
    pub x: T,
    /// Second component.
    pub y: T,
}

/// The outputs of a declaration inside `D` loops.
#[derive(Debug, Clone, Copy)]
pub struct OutputArray<'a, const D: usize> {
    /// First index and number of passes of each loop.
    ranges: [(usize, usize); D],
    values: &'a [f64],
}

impl<const D: usize> OutputArray<'_, D> {
    /// An output by the indices of the model file: `bend.at(1)` is `output bend[1]`.
    ///
    /// # Panics
    /// When there is no such output, as for a slice.
    #[track_caller]
    pub fn at(&self, index: impl ArrayIndex<D>) -> f64 {
        let index = index.indices();
        match self.get(index) {
            Some(value) => value,
            None => {
                let ranges = self.ranges.map(|(from, n)| from..from + n);
                panic!("no output has the index {index:?}: the indices are those of {ranges:?}")
            }
        }
    }

    /// An output, if there is one with this index.
    pub fn get(&self, index: impl ArrayIndex<D>) -> Option<f64> {
        self.values.get(place(index.indices(), self.ranges)?).copied()
    }

    /// All outputs; the last index changes first.
    pub fn iter(&self) -> impl Iterator<Item = f64> {
        self.values.iter().copied()
    }
}

/// Hands out the outputs of a state in their order.
pub struct OutputReader<'a> {
    values: &'a [f64],
}

impl<'a> OutputReader<'a> {
    /// Of `n_o` values.
    #[inline]
    pub fn new(values: &'a [f64]) -> Self {
        Self { values }
    }

    /// The next output.
    #[inline]
    pub fn number(&mut self) -> f64 {
        self.take(1)[0]
    }

    /// The outputs of the next declaration inside loops, each from its first index to before its last one.
    pub fn array<const D: usize>(&mut self, ranges: [[i64; 2]; D]) -> OutputArray<'a, D> {
        let ranges = ranges.map(|[from, to]| (size(from), size(to - from)));
        let n = ranges.iter().map(|(_, n)| n).product();
        OutputArray { ranges, values: self.take(n) }
    }

    #[inline]
    fn take(&mut self, n: usize) -> &'a [f64] {
        let (values, later) = self.values.split_at(n);
        self.values = later;
        values
    }
}
