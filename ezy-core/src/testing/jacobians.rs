//! The Jacobians of the equations of motion against differences of their residual.

use super::Check;
use super::derivatives::{along, slope};
use super::probe::{Probe, RandomState, Worst};
use crate::dynamics::{ResidualPlaces, max_abs};
use crate::model::Scene;
use std::borrow::Cow;

/// Rounding relative to what is differentiated, 1.5 ε/step = 5e-11, for terms that cancel within R: next to a corner of
/// radius r the convective term sums 1/r and has a size of 1 at a distance of a hundred r.
const TOLERANCE: f64 = 2e-9;
const REASON: &str = "rounding of differences of terms that cancel";

/// What a Jacobian differentiates by.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Positions,
    Velocities,
    States,
}

/// R_q, R_v and R_z along random directions; `None` for a scene that does not know its Jacobians.
pub(super) fn of_residual<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Option<Check> {
    let ResidualPlaces { by_motion: places, by_z: places_by_z } = ResidualPlaces::of(probe.scene)?;
    let (n_q, n_c, n_z) = (probe.info.n_coordinates(), probe.info.n_rows(), probe.info.n_states());
    let states = probe.info.n_inputs()..probe.info.n_inputs() + n_z;
    let z = &probe.fixed[states.clone()];
    let mut worst = Worst::default();
    let [mut by_q, mut by_v, mut by_z] =
        [&places.by_q, &places.by_v, &places_by_z].map(|places| vec![0.0; places.len()]);
    for RandomState { t, q, v } in &probe.states {
        // any accelerations and multipliers will do, and any directions
        let a: Vec<f64> = v.iter().rev().map(|v| 2.0 * v).collect();
        let lambda: Vec<f64> = (0..n_c).map(|i| v[i % n_q] + 0.5 * (i % 3) as f64).collect();
        let of_z: Vec<f64> = (0..n_z).map(|i| q[i % n_q] + 0.5 * (i % 3) as f64).collect();
        probe.scene.jacobians(&probe.fixed, *t, q, v, &a, &lambda, &mut by_q, &mut by_v);
        if n_z > 0 {
            probe.scene.state_jacobians(&probe.fixed, *t, q, v, &mut by_z);
        }
        let terms = size_of_terms(probe, *t, q, &a, &lambda);
        let size_of_state = max_abs(q) + max_abs(v) + max_abs(z);
        let by_states = (Of::States, &places_by_z, &by_z, &of_z);
        let by_all = [(Of::Positions, &places.by_q, &by_q, v), (Of::Velocities, &places.by_v, &by_v, q), by_states];
        for (of, places, entries, d) in by_all.into_iter().take(if n_z > 0 { 3 } else { 2 }) {
            let at = |e: f64| {
                let moved = |is_moved: bool, x: &[f64]| if is_moved { along(x, e, d) } else { x.to_vec() };
                let mut c = Cow::from(&probe.fixed);
                if of == Of::States {
                    c.to_mut()[states.clone()].copy_from_slice(&along(z, e, d));
                }
                (c, moved(of == Of::Positions, q), moved(of == Of::Velocities, v))
            };
            let motion = slope(n_q + n_c, |e, out| {
                let (c, q, v) = at(e);
                residual(probe, (&c, *t, &q, &v), &a, &lambda, out);
            });
            let rates = slope(n_z, |e, out| {
                let (c, q, v) = at(e);
                if n_z > 0 {
                    probe.scene.state_rates(&c, *t, &q, &v, out);
                }
            });
            for (difference, rows, terms) in [(motion, 0..n_q + n_c, terms), (rates, n_q + n_c..n_q + n_c + n_z, 0.0)] {
                let mut product = vec![0.0; rows.len()];
                let mut largest: f64 = 0.0;
                for (&(row, column), x) in places.iter().zip(entries).filter(|((row, _), _)| rows.contains(row)) {
                    product[row - rows.start] += x * d[column];
                    largest = max_abs(&[largest, *x]);
                }
                // terms of R may cancel: their rounding counts, not that of R; and that of the state, times the Jacobians
                let size = terms.max(largest * size_of_state).max(difference.size);
                difference.compare(&product, size, &mut worst);
            }
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
    (c, t, q, v): (&[f64], f64, &[f64], &[f64]),
    a: &[f64],
    lambda: &[f64],
    out: &mut [f64],
) {
    let (scene, info) = (probe.scene, &probe.info);
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
