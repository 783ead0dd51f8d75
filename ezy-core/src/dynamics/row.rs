//! One row at a state that need not meet it.

use super::System;
use crate::model::Scene;

/// A position constraint of a system, and a state.
pub(crate) struct SystemRow<'a> {
    /// Its place among the rows.
    pub row: usize,
    /// Time, s.
    pub t: f64,
    /// Coordinates, `n_q`.
    pub q: &'a [f64],
    /// Velocities, `n_q`.
    pub v: &'a [f64],
}

impl<S: Scene + ?Sized> System<'_, S> {
    /// What counts as zero of the row, in its unit.
    pub(crate) fn position_tolerance(&self, of: &SystemRow<'_>) -> f64 {
        self.geometry.position_tolerance(of.row, self.geometry.extent(of.q))
    }

    /// Second derivative in time of the row under accelerations that need not keep it, in its unit per s²; and what rounding of
    /// the coordinates makes of the row.
    pub(crate) fn row_acceleration(&mut self, of: &SystemRow<'_>, a: &[f64]) -> (f64, f64) {
        let SystemRow { row, t, q, v } = *of;
        let Self { scene, info, fixed, buffers, .. } = self;
        scene.velocity_jacobian(fixed, t, q, &mut buffers.jacobian);
        scene.convective_term(fixed, t, q, v, &mut buffers.residual);
        let places = info.jacobian.starts[row]..info.jacobian.starts[row + 1];
        let entries = places.map(|k| (buffers.jacobian[k], info.jacobian.columns[k]));
        let (mut acceleration, mut terms) = (buffers.residual[row], 0.0);
        for (g, j) in entries {
            acceleration += g * a[j];
            terms += (g * q[j]).abs();
        }
        (acceleration, f64::EPSILON * terms)
    }
}
