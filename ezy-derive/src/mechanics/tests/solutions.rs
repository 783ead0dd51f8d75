//! Generated solutions of random mechanisms against dense ones, and the balance of their energy.

use super::dense::Matrix;
use super::differences::{DIFFERENCE, slope};
use super::oracle::{State, forces};
use super::run::solution;
use super::{At, ROUNDING, Trial, trials};
use crate::mechanics::solve::Solutions;

/// Elimination and comparison each err by some hundred roundings times the condition of K.
pub const PER_CONDITION: f64 = 1e-13;

/// a and λ of the dense solution.
pub fn dense_solution(trial: &Trial, state: &State) -> (Matrix, Vec<f64>) {
    let k = trial.kkt(state);
    let mut right_side = trial.values(&trial.equations.force, state);
    right_side.extend(trial.values(&trial.equations.constraints.convective, state).iter().map(|x| -x));
    let solved = k.solve(&right_side).expect("the state is regular");
    (k, solved)
}

#[test]
fn cross_generated_accelerations_of_random_mechanisms_are_the_dense_ones() {
    for trial in trials() {
        for state in trial.states().iter().filter(|state| trial.is_regular(state)) {
            let (k, expected) = dense_solution(trial, state);
            let found = solution(trial, &trial.solutions.accelerations, state, &|_| f64::NAN);
            trial.compare("a and λ", &found, &expected, PER_CONDITION * k.condition());
        }
    }
}

#[test]
fn cross_generated_corrections_of_random_mechanisms_are_the_dense_ones() {
    for trial in trials() {
        let Solutions { correction, residuals, .. } = &trial.solutions;
        for state in trial.states().iter().filter(|state| trial.is_regular(state)) {
            let residual: Vec<f64> = (0..residuals.len()).map(|i| 0.3 * i as f64 - 1.0).collect();
            let k = trial.kkt(state);
            let n_q = state.q.len();
            let right_side: Vec<f64> = std::iter::repeat_n(0.0, n_q).chain(residual.iter().map(|r| -r)).collect();
            let expected = k.solve(&right_side).expect("the state is regular");
            let other = |symbol| residuals.iter().position(|&r| r == symbol).map_or(f64::NAN, |i| residual[i]);
            let found = solution(trial, correction, state, &other);
            trial.compare("delta", &found, &expected[..n_q], PER_CONDITION * k.condition());
        }
    }
}

/// What projects and solves at once gives the residuals, the nearest velocities that obey the rows, and their accelerations.
#[test]
fn cross_projected_accelerations_of_random_mechanisms_are_the_dense_ones() {
    for trial in trials() {
        for state in trial.states().iter().filter(|state| trial.is_regular(state)) {
            let found = solution(trial, &trial.solutions.projected, state, &|_| f64::NAN);
            let (residual, found) = found.split_at(trial.equations.constraints.rows.len());
            let (v, found) = found.split_at(state.v.len());
            trial.compare("residual", residual, &trial.values(&trial.equations.constraints.velocity, state), ROUNDING);
            let (k, expected) = dense_solution(trial, &State { v: v.to_vec(), ..state.clone() });
            let tolerance = PER_CONDITION * k.condition();
            trial.compare("velocities", v, &admissible(trial, state).v, tolerance);
            trial.compare("a and λ", found, &expected, tolerance);
        }
    }
}

/// The nearest velocities, in the metric of the masses, that obey the rows.
pub fn admissible(trial: &Trial, state: &State) -> State {
    let rates = trial.values(&trial.equations.constraints.velocity, state);
    let right_side: Vec<f64> = state.q.iter().map(|_| 0.0).chain(rates.iter().map(|r| -r)).collect();
    let change = trial.kkt(state).solve(&right_side).expect("the state is regular");
    State { v: state.v.iter().zip(&change).map(|(v, change)| v + change).collect(), ..state.clone() }
}

/// At any state whose velocities obey the rows; d/dt of the potential energy is a difference along the motion.
#[test]
fn invariant_power_of_random_mechanisms_is_the_rate_of_their_energy() {
    for trial in trials() {
        for state in trial.states().iter().filter(|state| trial.is_regular(state)) {
            let state = admissible(trial, state);
            let (k, solved) = dense_solution(trial, &state);
            let (acceleration, lambda) = solved.split_at(state.q.len());
            let momenta = trial.masses().into_iter().zip(&state.v).map(|(m, v)| m * v);
            let kinetic: Vec<f64> = momenta.zip(acceleration).map(|(p, a)| p * a).collect();
            let potential = slope(|tau| vec![forces(&trial.made, &state.ahead(tau)).1])[0];
            let at = At { trial, state: &state, lambda };
            let power = trial.equations.power.iter().map(|&(_, power)| trial.equations.algebra.evaluate(power, &at));
            let (rate, power) = (kinetic.iter().sum::<f64>() + potential, power.sum::<f64>());
            // sums of products whose signs differ
            let size = kinetic.iter().map(|x| x.abs()).sum::<f64>() + power.abs();
            let scaled = [rate / size.max(1.0), power / size.max(1.0)];
            trial.compare("power", &scaled[..1], &scaled[1..], DIFFERENCE + PER_CONDITION * k.condition());
        }
    }
}
