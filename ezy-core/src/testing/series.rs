//! The Taylor series against the equations of motion along it.

use super::Check;
use super::probe::{Probe, RandomState, Worst};
use super::solvers::{is_redundant_anywhere, is_regular, solve_motion};
use crate::dynamics::{State, max_abs};
use crate::integrate::Taylor;
use crate::linalg::Backend;
use crate::model::{Scene, SeriesStore};

/// Orders of the accelerations that are compared.
const N_ORDERS: usize = 12;

/// States at which the series starts.
const N_STATES: usize = 12;

/// The step is so much shorter than the radius of convergence that the terms left out, e^-36, are rounding.
const STEPS_TO_RADIUS: f64 = 3.0;

/// ε times the condition of K, 1e4, with a margin of a thousand for a dozen orders of sums.
const TOLERANCE: f64 = 1e-9;

/// Accelerations, multipliers and rates of first-order states that the series give a little later, against those of the equations at the
/// state that they give then; `None` for a scene without series, or with redundant rows at all states.
pub(super) fn ahead<S: Scene + ?Sized>(probe: &Probe<'_, S>) -> Result<Option<Check>, super::CheckError> {
    let (n_q, n_c, n_z) = (probe.info.n_coordinates(), probe.info.n_rows(), probe.info.n_states());
    let z = &probe.fixed[probe.info.n_inputs()..][..n_z];
    let Some(mut taylor) = Taylor::new(probe.scene, N_ORDERS, 0) else { return Ok(None) };
    let mut system = probe.system(Backend::Auto)?;
    let mut worst = Worst::default();
    let (mut a, mut lambda, mut rates) = (vec![0.0; n_q], vec![0.0; n_c], vec![0.0; n_z]);
    let mut states = probe.states.iter();
    for _ in 0..N_STATES {
        let Some(RandomState { t, q, v }) = states.find(|state| is_regular(&mut system, state)) else { break };
        let state = State { t: *t, q: q.clone(), v: v.clone(), z: z.to_vec(), work: Vec::new() };
        if taylor.expand(&mut system, &state, &mut a, &mut lambda).is_err() {
            worst.n_left_out += 1;
            continue;
        }
        let series = Coefficients { taylor: &taylor, store: taylor.coefficients(), n_q, n_c, n_z };
        let h = series.step();
        let ahead = RandomState { t: t + h, q: series.positions(h), v: series.velocities(h) };
        system.place_states(&series.states(h));
        let Some(oracle) = solve_motion(&mut system, &ahead) else {
            worst.n_left_out += 1;
            continue;
        };
        system.state_rates(ahead.t, &ahead.q, &ahead.v, &mut rates);
        let solution = series.solution(h);
        // an angle may have turned by a whole turn, as `atan2` behind its body does: terms say how far numbers can go
        let goes = |i: usize, there: f64| (there - series.of_solution(0, i)).abs();
        let rounding = TOLERANCE * max_abs(&oracle).max(max_abs(&rates));
        let mut numbers = oracle.iter().chain(&rates).enumerate();
        if numbers.any(|(i, there)| goes(i, *there) > 2.0 * series.reach(i, h) + rounding) {
            worst.n_left_out += 1;
            continue;
        }
        for (found, oracle) in [(&solution[..n_q + n_c], &oracle), (&solution[n_q + n_c..], &rates)] {
            let size = max_abs(oracle);
            found.iter().zip(oracle).for_each(|(x, y)| worst.compare(*x, *y, size));
        }
    }
    if worst.n_compared + worst.n_left_out == 0 && is_redundant_anywhere(&mut system, &probe.states) {
        // redundant rows: at random states, which do not meet them, they contradict each other
        return Ok(None);
    }
    let reason = "rounding of all orders times the condition of K";
    Ok(Some(worst.check_of_some("Taylor series against the equations ahead", TOLERANCE, reason)))
}

/// Coefficients by their meaning.
struct Coefficients<'t> {
    taylor: &'t Taylor,
    store: &'t SeriesStore<f64>,
    n_q: usize,
    n_c: usize,
    n_z: usize,
}

impl Coefficients<'_> {
    /// Order `k` of `a`, of the multipliers, then of the rates of first-order states.
    fn of_solution(&self, k: usize, i: usize) -> f64 {
        match i.checked_sub(self.n_q) {
            None => self.store.q[(k + 2) * self.n_q + i] * ((k + 1) * (k + 2)) as f64,
            Some(i) if i < self.n_c => self.store.lambda[k * self.n_c + i],
            Some(i) => (k + 1) as f64 * self.taylor.state_coefficients(k + 1)[i - self.n_c],
        }
    }

    /// So short that what lies beyond the orders is rounding.
    fn step(&self) -> f64 {
        let last = |i: usize| self.of_solution(N_ORDERS - 1, i).abs() / self.of_solution(0, i).abs().max(1.0);
        let largest = (0..self.n_solution()).map(last).fold(1.0, f64::max);
        (-STEPS_TO_RADIUS).exp() / largest.powf(1.0 / (N_ORDERS - 1) as f64)
    }

    fn positions(&self, h: f64) -> Vec<f64> {
        (0..self.n_q).map(|i| horner(&|k| self.store.q[k * self.n_q + i], N_ORDERS + 2, h)).collect()
    }

    fn velocities(&self, h: f64) -> Vec<f64> {
        let coefficient = |k: usize, i: usize| (k + 1) as f64 * self.store.q[(k + 1) * self.n_q + i];
        (0..self.n_q).map(|i| horner(&|k| coefficient(k, i), N_ORDERS + 1, h)).collect()
    }

    fn solution(&self, h: f64) -> Vec<f64> {
        (0..self.n_solution()).map(|i| horner(&|k| self.of_solution(k, i), N_ORDERS, h)).collect()
    }

    fn states(&self, h: f64) -> Vec<f64> {
        (0..self.n_z).map(|i| horner(&|k| self.taylor.state_coefficients(k)[i], N_ORDERS + 1, h)).collect()
    }

    /// Sum of the sizes of all terms but the first.
    fn reach(&self, i: usize, h: f64) -> f64 {
        h * horner(&|k| self.of_solution(k + 1, i).abs(), N_ORDERS - 1, h)
    }

    const fn n_solution(&self) -> usize {
        self.n_q + self.n_c + self.n_z
    }
}

fn horner(coefficient: &dyn Fn(usize) -> f64, n: usize, h: f64) -> f64 {
    (0..n).rev().fold(0.0, |sum, k| sum * h + coefficient(k))
}
