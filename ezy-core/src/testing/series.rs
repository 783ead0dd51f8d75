//! The Taylor series against the equations of motion along it.

use super::Check;
use super::probe::{Probe, RandomState, Worst};
use super::solvers::{is_regular, solve_motion};
use crate::dynamics::max_abs;
use crate::linalg::Backend;
use crate::model::{Scene, Series, SeriesStore};

/// Orders of the accelerations that are compared.
const N_ORDERS: usize = 12;

/// States at which the series starts.
const N_STATES: usize = 12;

/// The step is so much shorter than the radius of convergence that the terms left out, e^-36, are rounding.
const STEPS_TO_RADIUS: f64 = 3.0;

/// ε times the condition of K, 1e4, with a margin of a thousand for a dozen orders of sums.
const TOLERANCE: f64 = 1e-9;

/// Accelerations and multipliers that the series give a little later, against those of the equations at the state that
/// they give then; `None` for a scene without series, and for one with massless bodies, which its own factors do not solve.
pub fn ahead<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Result<Option<Check>, super::CheckError> {
    let Some(series) = probe.scene.series() else { return Ok(None) };
    let mut system = probe.system(Backend::Auto)?;
    if system.mass_matrix().contains(&0.0) {
        return Ok(None);
    }
    let mut worst = Worst::default();
    let mut store = SeriesStore::new(series.series_size(), N_ORDERS + 1);
    let mut states = probe.states.iter();
    for _ in 0..N_STATES {
        let Some(state) = states.find(|state| is_regular(&mut system, state)) else { break };
        if !expand(series, &probe.fixed, state, &mut store) {
            worst.n_left_out += 1;
            continue;
        }
        let (n_q, n_c) = (state.q.len(), probe.info.n_rows());
        let n = (N_ORDERS - 1) as f64;
        let a_at = |k: usize, i: usize| store.q[(k + 2) * n_q + i] * ((k + 1) * (k + 2)) as f64;
        let last_a = (0..n_q).map(|i| a_at(N_ORDERS - 1, i).abs() / a_at(0, i).abs().max(1.0));
        let lambda_at = |k: usize, i: usize| store.lambda[k * n_c + i];
        let last_lambda = (0..n_c).map(|i| lambda_at(N_ORDERS - 1, i).abs() / lambda_at(0, i).abs().max(1.0));
        let growth = last_a.chain(last_lambda).fold(1.0, f64::max).powf(1.0 / n);
        let h = (-STEPS_TO_RADIUS).exp() / growth;
        let sum = |term: &dyn Fn(usize) -> f64, n: usize| (0..n).rev().fold(0.0, |sum, k| sum * h + term(k));
        let ahead = RandomState {
            t: state.t + h,
            q: (0..n_q).map(|i| sum(&|k| store.q[k * n_q + i], N_ORDERS + 2)).collect(),
            v: (0..n_q).map(|i| sum(&|k| (k + 1) as f64 * store.q[(k + 1) * n_q + i], N_ORDERS + 1)).collect(),
        };
        let Some(oracle) = solve_motion(&mut system, &ahead) else {
            worst.n_left_out += 1;
            continue;
        };
        let size = max_abs(&oracle);
        let a = (0..n_q).map(|i| sum(&|k| a_at(k, i), N_ORDERS));
        let lambda = (0..n_c).map(|i| sum(&|k| lambda_at(k, i), N_ORDERS));
        a.chain(lambda).zip(&oracle).for_each(|(x, y)| worst.compare(x, *y, size));
    }
    if worst.n_compared == 0 {
        // nothing was comparable: that is a failure, not a pass
        worst.error = f64::NAN;
    }
    Ok(Some(Check {
        name: "Taylor series against the equations ahead",
        n_compared: worst.n_compared,
        n_left_out: worst.n_left_out,
        largest_error: worst.error,
        tolerance: TOLERANCE,
        reason: "rounding of all orders times the condition of K",
    }))
}

/// The coefficients at a state, plainly; false where a pivot vanished.
fn expand(series: &dyn Series<f64>, c: &[f64], state: &RandomState, store: &mut SeriesStore<f64>) -> bool {
    let n_q = state.q.len();
    store.q[..n_q].copy_from_slice(&state.q);
    store.q[n_q..2 * n_q].copy_from_slice(&state.v);
    if !series.begin(c, state.t, store).none() {
        return false;
    }
    series.solve(c, 0, store);
    form_sums(2, store);
    series.finish(c, 0, store);
    for k in 1..N_ORDERS {
        form_sums(k + 2, store);
        series.advance(c, k, store);
    }
    true
}

fn form_sums(n: usize, store: &mut SeriesStore<f64>) {
    let n_products = store.sums.len();
    for p in 0..n_products {
        let term = |j: usize| store.left[j * n_products + p] * store.right[(n - j) * n_products + p];
        store.sums[p] = (1..n).map(term).sum();
    }
}
