//! Equations in quasi-velocities of random mechanisms against those of rows.

use super::mechanism::mechanism;
use super::oracle::State;
use super::run::outputs;
use super::solutions::{PER_CONDITION, admissible, dense_solution};
use super::{Trial, trials};
use crate::mechanics::quasi::QuasiVelocities;
use crate::symbolic::Symbol;

/// Small mechanisms, since loops have no such form.
const SEEDS: std::ops::Range<u64> = 1_000..1_070;
const MOST_BODIES: u64 = 4;
/// Those that are met among these and the mechanisms of all sizes.
const LEAST_FORMS: usize = 25;

/// u at a state.
fn quasi_velocities(trial: &Trial, of: &QuasiVelocities, state: &State) -> Vec<f64> {
    trial.values(&of.values, state)
}

/// d/dt of u where v changes by the accelerations: u is linear in v, and its coefficients change with q.
fn rates(trial: &Trial, of: &QuasiVelocities, state: &State, a: &[f64]) -> Vec<f64> {
    let by_v = quasi_velocities(trial, of, &State { v: a.to_vec(), ..state.clone() });
    let [before, behind] = [-STEP_S, STEP_S].map(|tau| quasi_velocities(trial, of, &state.ahead(tau)));
    by_v.iter().zip(before.iter().zip(behind)).map(|(a, (x, y))| a + (y - x) / (2.0 * STEP_S)).collect()
}

/// Step of a central difference, s, and its error: its square over six times the third derivative of v cos φ, of order ten for rates of order one.
const STEP_S: f64 = 1e-4;
const DIFFERENCE: f64 = 2e-8;

#[test]
fn cross_quasi_velocities_of_random_mechanisms_give_the_motion_of_the_rows() {
    let more = SEEDS.filter_map(|seed| Trial::new(seed, mechanism(seed, 1 + (seed % MOST_BODIES) as usize)));
    let more: Vec<Trial> = more.collect();
    let mut n_forms = 0;
    for trial in trials().iter().chain(&more) {
        let Some(of) = &trial.quasi else { continue };
        let mut is_compared = false;
        for state in trial.states().iter().filter(|state| trial.is_regular(state)) {
            let state = admissible(trial, state);
            let u = quasi_velocities(trial, of, &state);
            let other = |symbol: Symbol| of.symbols.iter().position(|&own| own == symbol).map_or(f64::NAN, |k| u[k]);
            let (k, solved) = dense_solution(trial, &state);
            let tolerance = PER_CONDITION * k.condition();
            trial.compare("velocities", &outputs(trial, &of.velocities, &state, &other), &state.v, tolerance);
            let of_time = outputs(trial, &of.of_time, &state, &|_| f64::NAN);
            let other = |symbol: Symbol| {
                let place = of.time_symbols.iter().position(|&own| own == symbol);
                place.map_or_else(|| other(symbol), |k| of_time[k])
            };
            let found = outputs(trial, &of.accelerations, &state, &other);
            let (u_rates, q_rates) = found.split_at(u.len());
            let expected: Vec<f64> = of.feedback.iter().map(|&i| state.v[i]).collect();
            trial.compare("rates of coordinates", q_rates, &expected, tolerance);
            let (found, expected): (Vec<f64>, Vec<f64>) = of.integrals.iter().map(|&(i, k)| (u[k], state.v[i])).unzip();
            trial.compare("rates that are quasi-velocities", &found, &expected, tolerance);
            let expected = rates(trial, of, &state, &solved[..state.q.len()]);
            trial.compare("rates of quasi-velocities", u_rates, &expected, tolerance + DIFFERENCE);
            is_compared = true;
        }
        n_forms += usize::from(is_compared);
    }
    assert!(n_forms >= LEAST_FORMS, "{n_forms}");
}
