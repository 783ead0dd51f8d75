//! The factors of K at one configuration, and what they are made of.

use super::solved::Rows;
use crate::linalg::{DampedKkt, KktFactorization, NullSpaceKkt, RankRevealing};

/// How K is solved.
pub(super) enum Solver {
    Generated,
    Dense,
    Sparse(Box<dyn KktFactorization>),
}

/// The factors of one configuration, kept until another one is asked for.
pub(super) struct Factors {
    /// Where they were made; NaN where they are not good.
    pub(super) t: f64,
    pub(super) q: Vec<f64>,
    pub(super) rows: Rows,
    pub(super) made: Made,
    /// Entries of G there.
    pub jacobian: Vec<f64>,
    /// Made when it is first needed.
    pub(super) dense: Option<Box<NullSpaceKkt>>,
    pub(super) damped: Option<Box<DampedKkt>>,
    /// The independent rows at the start of a step, where others were redundant.
    pub(super) held: Vec<usize>,
    /// Answers questions of rank beside the factors; made when it is first needed.
    pub(super) rank: Option<Box<RankRevealing>>,
    /// `n_q + n_c`.
    pub right_side: Vec<f64>,
}

/// By which method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Made {
    Dense,
    Sparse,
    /// With the row at which the factorisation without damping failed, where that is known.
    Damped(Option<usize>),
}

impl Factors {
    pub(super) fn new(n_q: usize, n_rows: usize, jacobian: Vec<f64>) -> Self {
        Self {
            t: f64::NAN,
            q: vec![0.0; n_q],
            rows: Rows::Exact,
            made: Made::Dense,
            jacobian,
            dense: None,
            damped: None,
            held: Vec::with_capacity(n_rows),
            rank: None,
            right_side: vec![0.0; n_q + n_rows],
        }
    }

    /// What was computed with other inputs is not good.
    pub(super) fn forget(&mut self) {
        self.t = f64::NAN;
    }

    pub(super) fn holds_no_rows(&self) -> bool {
        self.held.is_empty()
    }

    #[inline]
    pub(super) fn are_of(&self, t: f64, q: &[f64], rows: Rows) -> bool {
        self.t == t && self.rows == rows && self.q == q
    }
}
