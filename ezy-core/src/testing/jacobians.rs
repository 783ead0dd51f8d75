//! The Jacobians of the equations of motion against differences of their residual.

use super::Check;
use super::derivatives::{along, slope};
use super::probe::{Probe, RandomState, Worst};
use crate::dynamics::max_abs;
use crate::model::Scene;

/// Rounding relative to what is differentiated, 1.5 ε/step = 5e-11, for terms that cancel within R: next to a corner of
/// radius r the convective term sums 1/r and has a size of 1 at a distance of a hundred r.
const TOLERANCE: f64 = 2e-9;
const REASON: &str = "rounding of differences of terms that cancel";

/// R_q along a random direction and R_v along another one; `None` for a scene that does not know its Jacobians.
pub(super) fn of_residual<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Option<Check> {
    let places = probe.scene.jacobian_places()?;
    let (n_q, n_c) = (probe.info.n_coordinates(), probe.info.n_rows());
    let mut worst = Worst::default();
    let (mut by_q, mut by_v) = (vec![0.0; places.by_q.len()], vec![0.0; places.by_v.len()]);
    for RandomState { t, q, v } in &probe.states {
        // any accelerations and multipliers will do, and any directions
        let a: Vec<f64> = v.iter().rev().map(|v| 2.0 * v).collect();
        let lambda: Vec<f64> = (0..n_c).map(|i| v[i % n_q] + 0.5 * (i % 3) as f64).collect();
        probe.scene.jacobians(&probe.fixed, *t, q, v, &a, &lambda, &mut by_q, &mut by_v);
        let along_q = slope(n_q + n_c, |e, out| residual(probe, *t, &along(q, e, v), v, &a, &lambda, out));
        let along_v = slope(n_q + n_c, |e, out| residual(probe, *t, q, &along(v, e, q), &a, &lambda, out));
        let terms = size_of_terms(probe, *t, q, &a, &lambda);
        for (difference, places, entries, d) in [(along_q, &places.by_q, &by_q, v), (along_v, &places.by_v, &by_v, q)] {
            let mut product = vec![0.0; n_q + n_c];
            places.iter().zip(entries).for_each(|(&(row, column), x)| product[row] += x * d[column]);
            // terms of R may cancel: their rounding counts, not that of R; and that of the state, times the Jacobians
            let size = terms.max(max_abs(entries) * (max_abs(q) + max_abs(v))).max(difference.size);
            difference.compare(&product, size, &mut worst);
        }
    }
    Some(worst.check("Jacobians against differences of the equations of motion", TOLERANCE, REASON))
}

/// Largest entry of G times the sum of what it multiplies.
fn size_of_terms<S: Scene + ?Sized>(probe: &Probe<'_, S>, t: f64, q: &[f64], a: &[f64], lambda: &[f64]) -> f64 {
    let mut jacobian = vec![0.0; probe.info.jacobian.n_nonzeros()];
    probe.scene.velocity_jacobian(&probe.fixed, t, q, &mut jacobian);
    max_abs(&jacobian) * (max_abs(a) + max_abs(lambda))
}

/// R = [F − M a − Gᵀ λ; −(G a + [h; s])].
fn residual<S: Scene + ?Sized>(
    probe: &Probe<'_, S>,
    t: f64,
    q: &[f64],
    v: &[f64],
    a: &[f64],
    lambda: &[f64],
    out: &mut [f64],
) {
    let (scene, c, info) = (probe.scene, &probe.fixed[..], &probe.info);
    let (force, rows) = out.split_at_mut(info.n_coordinates());
    let (mut mass, mut jacobian) = (vec![0.0; a.len()], vec![0.0; info.jacobian.n_nonzeros()]);
    scene.mass_matrix(c, &mut mass);
    scene.velocity_jacobian(c, t, q, &mut jacobian);
    scene.applied_force(c, t, q, v, force);
    scene.convective_term(c, t, q, v, rows);
    rows.iter_mut().for_each(|h| *h = -*h);
    force.iter_mut().zip(mass.iter().zip(a)).for_each(|(force, (m, a))| *force -= m * a);
    for (k, row, column) in info.jacobian.entries() {
        force[column] -= jacobian[k] * lambda[row];
        rows[row] -= jacobian[k] * a[column];
    }
}
