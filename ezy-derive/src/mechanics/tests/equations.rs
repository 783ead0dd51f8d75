//! C, G, h, s, F and V of random mechanisms.

use super::differences::{DIFFERENCE, curvature, slope};
use super::oracle::{State, forces, position_rows, velocity_rows};
use super::{ROUNDING, trials};

#[test]
fn cross_rows_of_random_mechanisms_are_what_plain_kinematics_says() {
    for trial in trials() {
        let constraints = &trial.equations.constraints;
        for state in trial.states() {
            let c = trial.values(&constraints.position, &state);
            trial.compare("C", &c, &position_rows(&trial.made, &state.q, state.t), ROUNDING);
            let rates = trial.values(&constraints.velocity[constraints.n_position_rows..], &state);
            trial.compare("S v + s_t", &rates, &velocity_rows(&trial.made, &state), ROUNDING);
        }
    }
}

#[test]
fn fd_jacobians_of_random_mechanisms_match_differences() {
    for trial in trials() {
        let made = &trial.made;
        for state in trial.states() {
            let jacobian = trial.jacobian(&state);
            for j in 0..state.q.len() {
                let moved = |of: &[f64], tau: f64| {
                    let mut moved = of.to_vec();
                    moved[j] += tau;
                    moved
                };
                let mut column = slope(|tau| position_rows(made, &moved(&state.q, tau), state.t));
                column.extend(slope(|tau| velocity_rows(made, &State { v: moved(&state.v, tau), ..state.clone() })));
                let found: Vec<f64> = jacobian.iter().map(|row| row[j]).collect();
                trial.compare("column of G", &found, &column, DIFFERENCE);
            }
        }
    }
}

#[test]
fn fd_rates_of_random_mechanisms_match_differences_along_the_motion() {
    for trial in trials() {
        let (made, constraints) = (&trial.made, &trial.equations.constraints);
        let n_h = constraints.n_position_rows;
        for state in trial.states() {
            let rows = |tau: f64| position_rows(made, &state.ahead(tau).q, state.ahead(tau).t);
            let rates = trial.values(&constraints.velocity[..n_h], &state);
            trial.compare("C_q v + C_t", &rates, &slope(rows), DIFFERENCE);
            let mut convective = curvature(rows);
            convective.extend(slope(|tau| velocity_rows(made, &state.ahead(tau))));
            trial.compare("[h; s]", &trial.values(&constraints.convective, &state), &convective, DIFFERENCE);
        }
    }
}

#[test]
fn cross_forces_of_random_mechanisms_are_what_plain_mechanics_says() {
    for trial in trials() {
        for state in trial.states() {
            let (force, potential) = forces(&trial.made, &state);
            trial.compare("F", &trial.values(&trial.equations.force, &state), &force, ROUNDING);
            trial.compare("V", &[trial.value(trial.equations.potential, &state)], &[potential], ROUNDING);
        }
    }
}
