//! Equations in quasi-velocities against those of the rows.

use super::derivatives::{REASON, TOLERANCE, along, slope};
use super::probe::{Probe, RandomState, Worst};
use super::solvers::{is_redundant_anywhere, is_regular, solve_motion};
use super::{Check, CheckError};
use crate::dynamics::max_abs;
use crate::linalg::Backend;
use crate::model::quasi_in_lanes::{AtStage, EquationsInQuasiVelocities, Nodes, Stages, Start, Times};
use crate::model::{Eight, N_LANES, QuasiVelocitiesInfo, Scene};
use crate::scalar::Scalar;

/// States at which accelerations are compared: each is solved for twice and differentiated.
const N_STATES: usize = 100;

/// Rounding of the rows at velocities of order one over pivots of a tenth: 1e-16 times the square of lengths over pivots, with a margin of a hundred.
const ROUNDING: f64 = 1e-12;

/// Velocities that random quasi-velocities give, against the rows and against these quasi-velocities; differences of such velocities along the motion
/// against the accelerations of the rows. Nothing for a scene without such equations, or with parameters for which a pivot vanishes.
pub(super) fn against_rows<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Result<Vec<Check>, CheckError> {
    let Some((equations, info)) = probe.scene.in_quasi_velocities().zip(probe.info.quasi_velocities) else {
        return Ok(Vec::new());
    };
    let (n_q, n_u) = (probe.info.n_coordinates(), info.formulas.len());
    let in_lanes = InLanes { equations, fixed: eights(&probe.fixed) };
    let mut system = probe.system(Backend::Auto)?;
    let (mut of_rows, mut of_motion) = (Worst::default(), Worst::default());
    let (mut residual, mut same, mut v) = (vec![0.0; probe.info.n_rows()], vec![0.0; n_u], vec![0.0; n_q]);
    for RandomState { t, q, v: random } in probe.states.iter().take(N_STATES) {
        let u = &random[..n_u];
        in_lanes.velocities(*t, q, u, &mut v);
        if v.iter().any(|v| !v.is_finite()) {
            // a pivot vanishes with these parameters
            return Ok(Vec::new());
        }
        let size = max_abs(&v);
        probe.scene.velocity_constraint(&probe.fixed, *t, q, &v, &mut residual);
        residual.iter().for_each(|residual| of_rows.compare(*residual, 0.0, size));
        equations.of_one().quasi_velocities(&probe.fixed, q, &v, &mut same);
        same.iter().zip(u).for_each(|(same, u)| of_rows.compare(*same, *u, size));
        let (whole_q, whole_v) = in_lanes.whole_state(*t, q, u);
        let (mut of_positions, at) = (vec![0.0; probe.info.n_position_rows], max_abs(&whole_q).max(1.0));
        probe.scene.position_constraint(&probe.fixed, *t, &whole_q, &mut of_positions);
        of_positions.iter().for_each(|residual| of_rows.compare(*residual, 0.0, at));
        probe.scene.velocity_constraint(&probe.fixed, *t, &whole_q, &whole_v, &mut residual);
        residual.iter().for_each(|residual| of_rows.compare(*residual, 0.0, max_abs(&whole_v)));

        let state = RandomState { t: *t, q: q.clone(), v: v.clone() };
        if !is_regular(&mut system, &state) {
            of_motion.n_left_out += 1;
            continue;
        }
        let Some(oracle) = solve_motion(&mut system, &state) else { continue };
        let (a, both_rates) = in_lanes.accelerations(*t, q, u, &info);
        for rates in both_rates {
            rates.iter().zip(info.feedback).for_each(|(rate, &i)| of_rows.compare(*rate, v[i], size));
        }
        info.integrals.iter().for_each(|&(i, k)| of_rows.compare(u[k], v[i], size));
        let of_stage = in_lanes.stage(*t, q, u, &info);
        let (of_stage, stage_rates) = of_stage.split_at(n_u);
        stage_rates.iter().zip(info.integrated).for_each(|(rate, &i)| of_rows.compare(*rate, v[i], size));
        let largest = max_abs(&a);
        of_stage.iter().zip(&a).for_each(|(of_stage, a)| of_rows.compare(*of_stage, *a, largest));
        let difference = slope(n_q, |e, out| {
            in_lanes.velocities(t + e, &probe.moved(q, e, &v), &along(u, e, &a), out);
        });
        // the rounding of the time counts with the rate of change
        let size = (max_abs(&oracle[..n_q]) * t.max(1.0)).max(difference.size);
        difference.compare(&oracle[..n_q], size, &mut of_motion);
    }
    let mut checks = vec![of_rows.check_of_some(
        "velocities, quasi-velocities against the rows",
        ROUNDING,
        "rounding over the pivots",
    )];
    // redundant rows have no accelerations at random states
    if of_motion.n_compared > 0 || !is_redundant_anywhere(&mut system, &probe.states) {
        checks.push(of_motion.check_of_some("accelerations, quasi-velocities against the rows", TOLERANCE, REASON));
    }
    Ok(checks)
}

/// Kernels in lanes, at one state.
struct InLanes<'s> {
    equations: &'s dyn EquationsInQuasiVelocities,
    fixed: Vec<Eight>,
}

impl InLanes<'_> {
    fn velocities(&self, t: f64, q: &[f64], u: &[f64], v: &mut [f64]) {
        let mut out = vec![Eight::from_f64(0.0); v.len()];
        self.equations.velocities_in_lanes(&self.fixed, &Eight::from_f64(t), &eights(q), &eights(u), &mut out);
        v.iter_mut().zip(out).for_each(|(v, out)| *v = out.0[0]);
    }

    /// Coordinates that obey the position constraints, and velocities there.
    fn whole_state(&self, t: f64, q: &[f64], u: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (mut of_q, mut v) = (eights(q), eights(q));
        let t = Eight::from_f64(t);
        self.equations.whole_state_in_lanes(&self.fixed, &t, &eights(q), &eights(u), &mut of_q, &mut v);
        let first = |of: Vec<Eight>| of.into_iter().map(|of| of.0[0]).collect();
        (first(of_q), first(v))
    }

    /// u̇ and the rates of what is integrated, at the first stage of a step.
    fn stage(&self, t: f64, q: &[f64], u: &[f64], info: &QuasiVelocitiesInfo) -> Vec<f64> {
        let start: Vec<f64> = u.iter().copied().chain(info.integrated.iter().map(|&i| q[i])).collect();
        let start = eights(&start);
        let (mut values, mut slopes, mut at) = (start.clone(), start.clone(), eights(q));
        let of = Stages { c: &self.fixed, t, h: 0.0, nodes: &[0.0], weights: &[&[]], first: 0, end: 1 };
        self.equations.stages_in_lanes(of, &start, AtStage { values: &mut values, q: &mut at }, &mut slopes);
        slopes.into_iter().map(|slope| slope.0[0]).collect()
    }

    /// u̇, and the rates of coordinates, with it and by themselves.
    fn accelerations(&self, t: f64, q: &[f64], u: &[f64], info: &QuasiVelocitiesInfo) -> (Vec<f64>, [Vec<f64>; 2]) {
        let n = u.len() + info.feedback.len();
        let [mut values, mut slopes, mut of_time] = [n, n, info.n_of_time].map(|n| vec![Eight::from_f64(0.0); n]);
        let (t, mut before, mut at, mut v) = (Eight::from_f64(t), slopes.clone(), eights(q), eights(q));
        self.equations.values_of_time_in_lanes(&self.fixed, &t, &mut of_time);
        // a sweep of no length
        let integrals = [Eight::from_f64(0.0); N_LANES];
        let of = Times { c: &self.fixed, of_time: &of_time, t: &t, h: 0.0, integrals: &integrals };
        let start: Vec<f64> = u.iter().copied().chain(info.feedback.iter().map(|&i| q[i])).collect();
        let mut turned = vec![Eight::from_f64(0.0); 4 * info.n_angles];
        let nodes = Nodes {
            values: &mut values,
            slopes: &mut slopes,
            before: &mut before,
            turned: &mut turned,
            q: &mut at,
            v: &mut v,
        };
        let first = |of: &[Eight]| -> Vec<f64> { of.iter().map(|of| of.0[0]).collect() };
        let mut of_sweep = Vec::new();
        self.equations.sweeps_in_lanes(of, Start { values: &start, q }, &vec![0.0; n], nodes, &mut |_, slopes| {
            of_sweep = first(slopes);
            false
        });
        let rates = of_sweep.split_off(u.len());
        (of_sweep, [rates, first(&slopes[u.len()..])])
    }
}

fn eights(x: &[f64]) -> Vec<Eight> {
    x.iter().map(|&x| Eight::from_f64(x)).collect()
}
