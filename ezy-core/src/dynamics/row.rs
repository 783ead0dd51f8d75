//! One row at a state that need not meet it.

use super::System;
use super::diagnosis::Diagnosis;
use crate::model::{Equations as _, SceneRef};

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

impl<P: SceneRef> Diagnosis<'_, P> {
    /// What counts as zero of the row, in its unit.
    pub(crate) fn position_tolerance(&self, of: &SystemRow<'_>) -> f64 {
        self.system.geometry.position_tolerance(of.row, self.system.geometry.extent(of.q))
    }

    /// What counts as zero of the velocity of a row, where velocities are `v`.
    pub(crate) fn velocity_tolerance(&self, row: usize, v: &[f64]) -> f64 {
        let geometry = &self.system.geometry;
        geometry.velocity_tolerance(row, geometry.extent_of_velocities(v))
    }

    /// Second derivative in time of the row under accelerations that need not keep it, in its unit per s²; and what rounding of
    /// the coordinates makes of the row.
    pub(crate) fn row_acceleration(&mut self, of: &SystemRow<'_>, a: &[f64]) -> (f64, f64) {
        let SystemRow { row, t, q, v } = *of;
        let System { scene, info, fixed, factors, residual, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        scene.convective_term_with_sines(fixed, t, q, v, sines.at(q), residual);
        let entries = jacobian[info.jacobian.row(row)].iter().zip(info.jacobian.columns_of(row));
        let (mut acceleration, mut terms) = (residual[row], 0.0);
        for (g, j) in entries {
            acceleration += g * a[j];
            terms += (g * q[j]).abs();
        }
        (acceleration, f64::EPSILON * terms)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::dynamics::tests::linkage;
    use crate::linalg::Backend;

    /// The coupler's end at 1.5 m from its centre is on the crank's at 1 m: both accelerate by a − ω² r along, and α r across, their directions.
    #[test]
    fn analytic_acceleration_of_a_hinge_and_its_rounding() {
        let scene = linkage::Turns::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let (crank, coupler) = (0.4_f64, -0.3_f64);
        let q = [0.1, 0.2, crank, 2.0, 0.5, coupler, 0.0, 0.0, 0.0];
        let v = [0.0, 0.0, 2.0, 0.0, 0.0, -3.0, 0.0, 0.0, 0.0];
        let a = [0.5, -0.7, 1.1, 0.2, 0.3, -0.4, 0.0, 0.0, 0.0];
        let row = system.info.rows.iter().position(|row| row.name == "B.x").unwrap();
        let (acceleration, rounding) =
            system.diagnosis().row_acceleration(&SystemRow { row, t: 0.0, q: &q, v: &v }, &a);
        let of_crank = a[0] - a[2] * crank.sin() - 4.0 * crank.cos();
        let of_coupler = a[3] + 1.5 * (a[5] * coupler.sin() + 9.0 * coupler.cos());
        assert!((acceleration.abs() - (of_crank - of_coupler).abs()).abs() <= 1e-14, "{acceleration}");
        // each coordinate times its slope
        let terms = q[0] + crank.sin() * crank + q[3] + 1.5 * (coupler.sin() * coupler).abs();
        assert!((rounding / (f64::EPSILON * terms) - 1.0).abs() <= 1e-14, "{rounding:e}");
    }
}
