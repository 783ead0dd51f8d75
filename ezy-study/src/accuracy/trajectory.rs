//! A motion at the times of a grid.

use ezy_core::model::SceneInfo;
use ezy_core::simulate::Run;
use std::sync::Arc;

/// Positions, velocities and multipliers at each time of a grid.
#[derive(Debug, Clone)]
pub(super) struct Trajectory {
    info: Arc<SceneInfo>,
    times: Vec<f64>,
    /// `n_q` numbers a time.
    q: Vec<f64>,
    /// `n_q` numbers a time.
    v: Vec<f64>,
    /// `n_c` numbers a time.
    lambda: Vec<f64>,
}

/// The numbers of one time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<'t> {
    pub q: &'t [f64],
    pub v: &'t [f64],
    pub lambda: &'t [f64],
}

impl Trajectory {
    /// Nothing yet.
    pub(super) fn empty(info: Arc<SceneInfo>) -> Self {
        Self { info, times: Vec::new(), q: Vec::new(), v: Vec::new(), lambda: Vec::new() }
    }

    /// The samples of a run.
    pub(super) fn of(run: &Run) -> Self {
        let mut all = Self::empty(Arc::clone(run.info()));
        for sample in run.samples() {
            all.push(sample.t, sample.coordinates, sample.velocities, sample.multipliers);
        }
        all
    }

    pub(super) fn push(&mut self, t: f64, q: &[f64], v: &[f64], lambda: &[f64]) {
        self.times.push(t);
        self.q.extend(q);
        self.v.extend(v);
        self.lambda.extend(lambda);
    }

    /// Names and units.
    pub(super) fn info(&self) -> &Arc<SceneInfo> {
        &self.info
    }

    /// The grid, s.
    pub(super) fn times(&self) -> &[f64] {
        &self.times
    }

    pub(super) fn row(&self, i: usize) -> Row<'_> {
        let [n_q, n_v, n_c] = [self.info.n_coordinates(), self.info.n_velocities(), self.info.n_rows()];
        Row { q: &self.q[i * n_q..][..n_q], v: &self.v[i * n_v..][..n_v], lambda: &self.lambda[i * n_c..][..n_c] }
    }

    /// `self + factor (self − other)`, time by time: Richardson's extrapolation.
    pub(super) fn extrapolated(mut self, other: &Self, factor: f64) -> Self {
        for (fine, coarse) in [(&mut self.q, &other.q), (&mut self.v, &other.v), (&mut self.lambda, &other.lambda)] {
            fine.iter_mut().zip(coarse).for_each(|(fine, coarse)| *fine += factor * (*fine - coarse));
        }
        self
    }
}
