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

/// Positions that constraints give obey these, the others stay, and velocities there obey the rows.
fn check_whole_state(trial: &Trial, of: &QuasiVelocities, state: &State, of_u: &dyn Fn(Symbol) -> f64, tolerance: f64) {
    let constraints = &trial.equations.constraints;
    let mut found = outputs(trial, &of.whole_state, state, of_u);
    let v = found.split_off(state.q.len());
    let whole = State { q: found, v, ..state.clone() };
    let moved: Vec<usize> = (0..state.q.len()).filter(|&i| whole.q[i].to_bits() != state.q[i].to_bits()).collect();
    assert!(moved.len() <= constraints.n_position_rows, "seed {}", trial.seed);
    for sums in [&constraints.position, &constraints.velocity] {
        let residual = trial.values(sums, &whole);
        trial.compare("residuals of the whole state", &residual, &vec![0.0; residual.len()], tolerance);
    }
    // another one is the same again
    let same = outputs(trial, &of.velocities, &whole, of_u);
    trial.compare("velocities of the whole state", &whole.v, &same, tolerance);
    let free = moved.iter().all(|i| !of.integrated[of.n_read..].contains(i));
    assert!(free, "seed {}: a coordinate that constraints give is integrated for itself", trial.seed);
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
            let (u_rates, rest) = found.split_at(u.len());
            let (q_rates, sines) = rest.split_at(of.feedback.len());
            let expected: Vec<f64> = of.feedback.iter().map(|&i| state.v[i]).collect();
            trial.compare("rates of coordinates", q_rates, &expected, tolerance);
            let angles = outputs(trial, &of.angles, &state, &other);
            let expected: Vec<f64> = angles.iter().flat_map(|angle| [angle.sin(), angle.cos()]).collect();
            trial.compare("sines that rates read", sines, &expected, tolerance);
            let of_sines = |symbol: Symbol| {
                let place = of.sine_symbols.iter().position(|&own| own == symbol);
                place.map_or_else(|| other(symbol), |k| sines[k])
            };
            trial.compare("rates by these sines", &outputs(trial, &of.rates, &state, &of_sines), q_rates, tolerance);
            let (found, expected): (Vec<f64>, Vec<f64>) = of.integrals.iter().map(|&(i, k)| (u[k], state.v[i])).unzip();
            trial.compare("rates that are quasi-velocities", &found, &expected, tolerance);
            let expected = rates(trial, of, &state, &solved[..state.q.len()]);
            trial.compare("rates of quasi-velocities", u_rates, &expected, tolerance + DIFFERENCE);

            // the same with the rates of other coordinates, by a program of its own
            let of_u = |symbol: Symbol| of.symbols.iter().position(|&own| own == symbol).map_or(f64::NAN, |k| u[k]);
            let found = outputs(trial, &of.motion, &state, &of_u);
            let rates = of.integrated.iter().map(|&i| state.v[i]);
            let expected: Vec<f64> = u_rates.iter().copied().chain(rates).collect();
            trial.compare("rates of what is integrated", &found, &expected, tolerance);
            check_whole_state(trial, of, &state, &of_u, tolerance);
            is_compared = true;
        }
        n_forms += usize::from(is_compared);
    }
    assert!(n_forms >= LEAST_FORMS, "{n_forms}");
}
