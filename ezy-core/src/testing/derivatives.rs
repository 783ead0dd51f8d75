//! Derived equations against differences of the expressions that they come from.

use super::Check;
use super::probe::{Probe, RandomState, Worst};
use crate::dynamics::max_abs;
use crate::model::Scene;

/// Step of central differences, ε^(1/3): truncation and rounding are then both about ε^(2/3).
const STEP: f64 = 6e-6;

/// Relative to rows and coordinates: truncation step²/6 times a third derivative, which for lengths, sines and speeds
/// up to two is at most 10 times as large, plus rounding ε/step: 10 · 6e-12 + 4e-11, doubled.
const TOLERANCE: f64 = 2e-10;
const REASON: &str = "central differences at step eps^(1/3)";

/// Differences of rows that are linear in v, and sums of products, leave rounding: ε times the number of terms and
/// the size of the velocities.
const LINEAR_TOLERANCE: f64 = 1e-13;
const LINEAR_REASON: &str = "rounding";

/// C_q against differences of C in each coordinate.
pub fn jacobian_of_positions<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let (info, n_h) = (probe.info, probe.info.n_position_rows);
    let mut worst = Worst::default();
    let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
    let directions = probe.directions();
    for RandomState { t, q, .. } in &probe.states {
        probe.scene.velocity_jacobian(&probe.fixed, *t, q, &mut entries);
        for d in &directions {
            let difference = central(n_h, |e, out| {
                probe.scene.position_constraint(&probe.fixed, *t, &along(q, e, d), out);
            });
            for (slope, oracle) in probe.product(&entries, d).iter().zip(&difference) {
                worst.compare(*slope, *oracle, max_abs(&entries).max(max_abs(q)));
            }
        }
    }
    check("C_q against differences of C", worst, TOLERANCE, REASON)
}

/// C_q v + C_t against differences of C along the motion.
pub fn velocity_rows<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let n_h = probe.info.n_position_rows;
    let mut worst = Worst::default();
    let mut rows = vec![0.0; probe.info.n_rows()];
    for RandomState { t, q, v } in &probe.states {
        probe.scene.velocity_constraint(&probe.fixed, *t, q, v, &mut rows);
        let difference = central(n_h, |e, out| {
            probe.scene.position_constraint(&probe.fixed, t + e, &along(q, e, v), out);
        });
        for (row, oracle) in rows.iter().zip(&difference) {
            worst.compare(*row, *oracle, max_abs(&rows).max(max_abs(q)));
        }
    }
    check("C_q v + C_t against differences of C", worst, TOLERANCE, REASON)
}

/// [h; s] against differences of all velocity rows along the motion at constant velocity.
pub fn convective_term<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let n_c = probe.info.n_rows();
    let mut worst = Worst::default();
    let mut h = vec![0.0; n_c];
    for RandomState { t, q, v } in &probe.states {
        probe.scene.convective_term(&probe.fixed, *t, q, v, &mut h);
        let difference = central(n_c, |e, out| {
            probe.scene.velocity_constraint(&probe.fixed, t + e, &along(q, e, v), v, out);
        });
        for (row, oracle) in h.iter().zip(&difference) {
            worst.compare(*row, *oracle, max_abs(&h));
        }
    }
    check("h, s against differences of the velocity rows", worst, TOLERANCE, REASON)
}

/// G against differences of the velocity rows in each velocity, which are linear in them.
pub fn jacobian_of_velocities<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let (info, n_c) = (probe.info, probe.info.n_rows());
    let mut worst = Worst::default();
    let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
    let directions = probe.directions();
    let (mut rows, mut moved_rows) = (vec![0.0; n_c], vec![0.0; n_c]);
    for RandomState { t, q, v } in &probe.states {
        probe.scene.velocity_jacobian(&probe.fixed, *t, q, &mut entries);
        probe.scene.velocity_constraint(&probe.fixed, *t, q, v, &mut rows);
        let size = max_abs(&rows).max(max_abs(&entries));
        for d in &directions {
            probe.scene.velocity_constraint(&probe.fixed, *t, q, &along(v, 1.0, d), &mut moved_rows);
            for (row, slope) in probe.product(&entries, d).iter().enumerate() {
                worst.compare(*slope, moved_rows[row] - rows[row], size);
            }
        }
    }
    check("G against the velocity rows", worst, LINEAR_TOLERANCE, LINEAR_REASON)
}

/// Sum of the powers of all effects, less the growth of the potential energy, against F·v and λ·g_t, where g_t is what
/// the velocity rows are at rest: both are what the kinetic energy gains. Any λ will do.
pub fn power<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let info = probe.info;
    let mut worst = Worst::default();
    let (rest, mut rows) = (vec![0.0; info.n_coordinates()], vec![0.0; info.n_rows()]);
    let mut F = vec![0.0; info.n_coordinates()];
    let mut powers = vec![0.0; info.n_effects()];
    let mut has_potential = false;
    for RandomState { t, q, v } in &probe.states {
        let lambda: Vec<f64> = (0..info.n_rows()).map(|i| v[i % v.len()] + i as f64).collect();
        probe.scene.applied_force(&probe.fixed, *t, q, v, &mut F);
        probe.scene.velocity_constraint(&probe.fixed, *t, q, &rest, &mut rows);
        probe.scene.power(&probe.fixed, *t, q, v, &lambda, &mut powers);
        let potential = |e: f64| probe.scene.potential_energy(&probe.fixed, t + e, &along(q, e, v));
        let growth = steep_slope(potential);
        has_potential |= growth != 0.0;
        let terms = F.iter().zip(v).chain(rows.iter().zip(&lambda)).map(|(F, v)| F * v);
        let size = terms.clone().map(f64::abs).sum::<f64>().max(potential(0.0).abs());
        worst.compare(powers.iter().sum::<f64>() - growth, terms.sum(), size);
    }
    let (tolerance, reason) = if has_potential { (TOLERANCE, REASON) } else { (LINEAR_TOLERANCE, LINEAR_REASON) };
    check("powers and potential against F v and lambda g_t", worst, tolerance, reason)
}

fn check(name: &'static str, worst: Worst, tolerance: f64, reason: &'static str) -> Check {
    Check { name, n_compared: worst.n_compared, largest_error: worst.error, tolerance, reason }
}

/// `(f(e) − f(−e)) / 2e` for `n` numbers.
fn central(n: usize, f: impl Fn(f64, &mut [f64])) -> Vec<f64> {
    let (mut ahead, mut behind) = (vec![0.0; n], vec![0.0; n]);
    f(STEP, &mut ahead);
    f(-STEP, &mut behind);
    ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * STEP)).collect()
}

/// f'(0) by central differences at two steps, extrapolated: a spring that is random and short is too curved for one.
fn steep_slope(f: impl Fn(f64) -> f64) -> f64 {
    let slope = |step: f64| (f(step) - f(-step)) / (2.0 * step);
    (4.0 * slope(STEP) - slope(2.0 * STEP)) / 3.0
}

fn along(q: &[f64], e: f64, v: &[f64]) -> Vec<f64> {
    q.iter().zip(v).map(|(q, v)| q + e * v).collect()
}
