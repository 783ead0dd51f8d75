//! The factors of K at one configuration, and what they are made of.

use super::sines::Sines;
use super::solved::Rows;
use crate::archive::Archive;
use crate::linalg::{DampedKkt, KktFactorization, NullSpaceKkt, RankRevealing};
use crate::model::{Equations as _, SceneRef};

/// How K is solved.
pub(super) enum Solver {
    Generated,
    Dense,
    Sparse(Box<dyn KktFactorization>),
}

/// G and the factors of one configuration, kept until another one is asked for.
pub(super) struct Factors {
    /// Where that is; NaN where nothing is good.
    pub(super) t: f64,
    pub(super) q: Vec<f64>,
    /// Entries of G there.
    pub jacobian: Vec<f64>,
    /// With which rows K was factored there; none where it was not.
    pub(super) factored: Option<Rows>,
    pub(super) made: Made,
    /// Made when it is first needed.
    pub(super) dense: Option<Box<NullSpaceKkt>>,
    pub(super) damped: Option<Box<DampedKkt>>,
    /// What one elimination gave besides, for who asks next.
    pub ahead: Ahead,
    /// Answers questions of rank beside the factors; made when it is first needed.
    pub(super) rank: Option<Box<RankRevealing>>,
    /// The last correction, `n_v`.
    pub delta: Vec<f64>,
    /// `[r; s]` and `[x; y]` of solvers that take them one behind the other; sized when it is first needed.
    pub(super) both: Vec<f64>,
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
    /// `eliminates`: whether the scene has an elimination that gives more than what was asked for.
    pub(super) fn new([n_q, n_v]: [usize; 2], n_rows: usize, jacobian: Vec<f64>, eliminates: bool) -> Self {
        Self {
            t: f64::NAN,
            q: vec![0.0; n_q],
            jacobian,
            factored: None,
            made: Made::Dense,
            dense: None,
            damped: None,
            ahead: if eliminates { Ahead::new([n_q, n_v], n_rows) } else { Ahead::new([0; 2], 0) },
            rank: None,
            delta: vec![0.0; n_v],
            both: Vec::new(),
        }
    }

    /// What was computed with other inputs is not good.
    pub(super) fn forget(&mut self) {
        (self.t, self.factored) = (f64::NAN, None);
        self.ahead.t = f64::NAN;
    }

    #[inline]
    pub(super) fn are_of(&self, t: f64, q: &[f64], rows: Rows) -> bool {
        self.factored == Some(rows) && self.are_at(t, q)
    }

    #[inline]
    fn are_at(&self, t: f64, q: &[f64]) -> bool {
        self.t == t && self.q == q
    }

    /// Entries of G at a configuration; factors of another one are not good behind it.
    #[inline]
    pub(super) fn jacobian_at<P: SceneRef>(
        &mut self,
        scene: &P,
        fixed: &[f64],
        sines: &mut Sines,
        t: f64,
        q: &[f64],
    ) -> &[f64] {
        if !self.are_at(t, q) {
            scene.velocity_jacobian_with_sines(fixed, t, q, sines.at(q), &mut self.jacobian);
            (self.t, self.factored) = (t, None);
            self.q.copy_from_slice(q);
        }
        &self.jacobian
    }
}

/// Projected velocities and the accelerations there, from one elimination.
pub(super) struct Ahead {
    /// Where they were found; NaN where they are not good.
    t: f64,
    q: Vec<f64>,
    n_v: usize,
    smallest_pivot: f64,
    /// As [`Derived::projected_accelerations`](crate::model::Derived::projected_accelerations) wrote them.
    out: Vec<f64>,
}

impl Ahead {
    fn new([n_q, n_v]: [usize; 2], n_rows: usize) -> Self {
        Self { t: f64::NAN, q: vec![0.0; n_q], n_v, smallest_pivot: 0.0, out: vec![0.0; 2 * (n_v + n_rows)] }
    }

    pub(super) fn forget(&mut self) {
        self.t = f64::NAN;
    }

    /// Where to write what is found next; what was found before is not good.
    pub(super) fn begin(&mut self) -> &mut [f64] {
        self.t = f64::NAN;
        &mut self.out
    }

    pub(super) fn remember(&mut self, archive: &mut Archive) {
        archive.number(&mut self.t);
        archive.number(&mut self.smallest_pivot);
        archive.numbers(&mut self.q);
        archive.numbers(&mut self.out);
    }

    pub(super) fn keep(&mut self, t: f64, q: &[f64], smallest_pivot: f64) {
        (self.t, self.smallest_pivot) = (t, smallest_pivot);
        self.q.copy_from_slice(q);
    }

    /// Residuals of the velocity constraints before, and the velocities after the projection.
    pub(super) fn velocities(&self) -> (&[f64], &[f64]) {
        let (residual, solution) = self.out.split_at(self.out.len() / 2 - self.n_v);
        (residual, &solution[..self.n_v])
    }

    /// Smallest pivot, and a and λ one behind the other, where they were found at this state.
    #[inline]
    pub(super) fn accelerations(&self, t: f64, q: &[f64], v: &[f64]) -> Option<(f64, &[f64])> {
        let is_here = self.t == t && self.q == q && self.velocities().1 == v;
        is_here.then(|| (self.smallest_pivot, &self.out[self.out.len() / 2..]))
    }
}
