//! What an answer of the solvers says of itself.

use crate::archive::Archive;
use crate::linalg::Left;

/// How a linear system at one configuration was solved.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Solved {
    /// Smallest pivot of an independent row, relative to what it started from: falls with the square of the distance to a
    /// position in which constraints depend on each other. What a pivot is differs between backends.
    pub smallest_pivot: f64,
    /// Whether constraints depend on each other.
    pub is_rank_deficient: bool,
    /// What redundant rows leave.
    pub(super) left: Left,
}

impl Solved {
    /// By an elimination whose pivots were all found.
    pub(crate) fn regular(smallest_pivot: f64) -> Self {
        Self { smallest_pivot, is_rank_deficient: false, left: Left::default() }
    }

    /// Writes it, or reads another one over it.
    pub(crate) fn remember(&mut self, archive: &mut Archive) {
        archive.number(&mut self.smallest_pivot);
        archive.flag(&mut self.is_rank_deficient);
        archive.number(&mut self.left.rows);
        archive.number(&mut self.left.scale);
    }
}

/// Which rows a system takes for independent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rows {
    /// Those that are so at the configuration, which is taken as exact.
    Exact,
    /// Those that are so at the configuration, which was projected and carries rounding.
    Projected,
    /// Where rows were redundant at the start of a step, those that were independent there: beside the constraints, redundant rows
    /// contradict the others, by as much as a stage leaves the constraints.
    Held,
}
