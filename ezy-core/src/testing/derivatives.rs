//! Derived equations against differences of the expressions that they come from.

use super::Check;
use super::probe::{Probe, RandomState, Worst};
use crate::dynamics::max_abs;
use crate::model::Scene;

/// Shorter step of central differences at two steps, extrapolated: truncation is then step⁴/30 times a fifth derivative,
/// which even a short spring keeps below rounding.
const STEP: f64 = 6e-6;

/// Rounding relative to what is differentiated: 1.5 ε/step = 5e-11, for a few terms. The rounding of the time itself, ε t,
/// counts with the rate of change.
pub(super) const TOLERANCE: f64 = 2e-10;
pub(super) const REASON: &str = "rounding of extrapolated central differences";

/// Largest truncation error of a difference that is compared: half of the tolerance. Near a singular point, such as a distance
/// of zero, the fifth derivative is unbounded, and differences say nothing about the model.
const LARGEST_TRUNCATION: f64 = 0.5 * TOLERANCE;

/// Between differences of fourth order at a step and at twice the step are 2⁴ − 1 truncations of the former.
const TRUNCATIONS: f64 = 15.0;

/// Differences of rows that are linear in v, and sums of products, leave rounding: ε times the number of terms and
/// the size of the velocities.
const LINEAR_TOLERANCE: f64 = 1e-13;
const LINEAR_REASON: &str = "rounding";

/// C_q against differences of C in each coordinate.
pub(super) fn jacobian_of_positions<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let (info, n_h) = (&probe.info, probe.info.n_position_rows);
    let mut worst = Worst::default();
    let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
    let directions = probe.directions();
    for RandomState { t, q, .. } in &probe.states {
        probe.scene.velocity_jacobian(&probe.fixed, *t, q, &mut entries);
        for d in &directions {
            let difference = slope(n_h, |e, out| {
                probe.scene.position_constraint(&probe.fixed, *t, &probe.moved(q, e, d), out);
            });
            let size = max_abs(&entries).max(max_abs(q)).max(difference.size);
            difference.compare(&probe.product(&entries, d), size, &mut worst);
        }
    }
    worst.check("C_q against differences of C", TOLERANCE, REASON)
}

/// C_q v + C_t against differences of C along the motion.
pub(super) fn velocity_rows<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let n_h = probe.info.n_position_rows;
    let mut worst = Worst::default();
    let mut rows = vec![0.0; probe.info.n_rows()];
    for RandomState { t, q, v } in &probe.states {
        probe.scene.velocity_constraint(&probe.fixed, *t, q, v, &mut rows);
        let difference = slope(n_h, |e, out| {
            probe.scene.position_constraint(&probe.fixed, t + e, &probe.moved(q, e, v), out);
        });
        let size = (max_abs(&rows) * t.max(1.0)).max(max_abs(q)).max(difference.size);
        difference.compare(&rows, size, &mut worst);
    }
    worst.check("C_q v + C_t against differences of C", TOLERANCE, REASON)
}

/// [h; s] against differences of all velocity constraints along the motion at constant velocity.
pub(super) fn convective_term<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let n_c = probe.info.n_rows();
    let mut worst = Worst::default();
    let mut h = vec![0.0; n_c];
    let mut entries = vec![0.0; probe.info.jacobian.n_nonzeros()];
    for RandomState { t, q, v } in &probe.states {
        probe.scene.convective_term(&probe.fixed, *t, q, v, &mut h);
        probe.scene.velocity_jacobian(&probe.fixed, *t, q, &mut entries);
        let difference = slope(n_c, |e, out| {
            probe.scene.velocity_constraint(&probe.fixed, t + e, &probe.moved(q, e, v), v, out);
        });
        // what is differentiated is a sum of products of these: its rounding counts even where h is small
        let size = (max_abs(&h) * t.max(1.0)).max(max_abs(&entries) * max_abs(v)).max(difference.size);
        difference.compare(&h, size, &mut worst);
    }
    worst.check("h, s against differences of the velocity constraints", TOLERANCE, REASON)
}

/// G against differences of the velocity constraints in each velocity, which are linear in them.
pub(super) fn jacobian_of_velocities<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let (info, n_c) = (&probe.info, probe.info.n_rows());
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
    worst.check("G against the velocity constraints", LINEAR_TOLERANCE, LINEAR_REASON)
}

/// Sum of the powers of all effects, less the growth of the potential energy, against F·v and λ·g_t, where g_t is what
/// the velocity constraints are at rest: both are what the kinetic energy gains. Any λ will do.
pub(super) fn power<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Check {
    let info = &probe.info;
    let mut worst = Worst::default();
    let (rest, mut rows) = (vec![0.0; info.n_velocities()], vec![0.0; info.n_rows()]);
    let mut F = vec![0.0; info.n_velocities()];
    let mut powers = vec![0.0; info.n_effects()];
    let mut has_potential = false;
    for RandomState { t, q, v } in &probe.states {
        let lambda: Vec<f64> = (0..info.n_rows()).map(|i| v[i % v.len()] + i as f64).collect();
        probe.scene.applied_force(&probe.fixed, *t, q, v, &mut F);
        probe.scene.velocity_constraint(&probe.fixed, *t, q, &rest, &mut rows);
        probe.scene.power(&probe.fixed, *t, q, v, &lambda, &mut powers);
        let potential = |e: f64| probe.scene.potential_energy(&probe.fixed, t + e, &probe.moved(q, e, v));
        let growth = slope(1, |e, out| out[0] = potential(e));
        has_potential |= growth.slopes[0] != 0.0;
        let terms = F.iter().zip(v).chain(rows.iter().zip(&lambda)).map(|(F, v)| F * v);
        let size = terms.clone().map(f64::abs).sum::<f64>().max(potential(0.0).abs());
        growth.compare(&[powers.iter().sum::<f64>() - terms.sum::<f64>()], size, &mut worst);
    }
    let (tolerance, reason) = if has_potential { (TOLERANCE, REASON) } else { (LINEAR_TOLERANCE, LINEAR_REASON) };
    worst.check("powers and potential against F v and lambda g_t", tolerance, reason)
}

/// Difference quotients, their truncation error, and the largest of the numbers, whose rounding they contain.
pub(super) struct Difference {
    slopes: Vec<f64>,
    truncation: f64,
    pub size: f64,
}

impl Difference {
    /// Compares with derivatives, except where the difference quotients are too inaccurate.
    pub(super) fn compare(&self, derivatives: &[f64], size: f64, worst: &mut Worst) {
        if self.truncation > LARGEST_TRUNCATION * size.max(1.0) {
            worst.n_left_out += self.slopes.len();
            return;
        }
        for (derivative, slope) in derivatives.iter().zip(&self.slopes) {
            worst.compare(*derivative, *slope, size);
        }
    }
}

/// f'(0) for `n` numbers: `(f(e) − f(−e)) / 2e` at two steps, extrapolated to step zero; a third step tells how good it is.
pub(super) fn slope(n: usize, f: impl Fn(f64, &mut [f64])) -> Difference {
    let (mut ahead, mut behind) = (vec![0.0; n], vec![0.0; n]);
    let (mut slopes, mut coarser_slopes) = (vec![0.0; n], vec![0.0; n]);
    let mut size = 0.0;
    for (step, weight, coarser_weight) in
        [(STEP, 4.0 / 3.0, 0.0), (2.0 * STEP, -1.0 / 3.0, 4.0 / 3.0), (4.0 * STEP, 0.0, -1.0 / 3.0)]
    {
        f(step, &mut ahead);
        f(-step, &mut behind);
        for (i, difference) in ahead.iter().zip(&behind).map(|(a, b)| (a - b) / (2.0 * step)).enumerate() {
            slopes[i] += weight * difference;
            coarser_slopes[i] += coarser_weight * difference;
        }
        size = max_abs(&[size, max_abs(&ahead), max_abs(&behind)]);
    }
    let differences = slopes.iter().zip(&coarser_slopes).map(|(fine, coarse)| (fine - coarse).abs());
    Difference { truncation: differences.fold(0.0, f64::max) / TRUNCATIONS, slopes, size }
}

pub(super) fn along(q: &[f64], e: f64, v: &[f64]) -> Vec<f64> {
    q.iter().zip(v).map(|(q, v)| q + e * v).collect()
}
