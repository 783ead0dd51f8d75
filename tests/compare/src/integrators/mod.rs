//! One integrator a file, each as its documentation shows it, with one number for relative and absolute tolerance.

mod differential_equations;
mod diffsol;
mod ezy;
mod ode_solvers;
mod russell_ode;

pub use differential_equations::{dop853 as differential_equations_dop853, rkv98 as differential_equations_rkv98};
pub use diffsol::tsit45 as diffsol_tsit45;
pub use ezy::ezy;
pub use ode_solvers::dop853 as ode_solvers_dop853;
pub use russell_ode::dopri8 as russell_ode_dopri8;

use crate::right_side::{N_Q, State};

/// From where to when.
#[derive(Clone, Copy)]
pub struct Task {
    pub start: State,
    pub until_s: f64,
}

/// What an integrator says when it has arrived.
pub struct Arrival {
    pub q: [f64; N_Q],
    /// Steps taken and steps tried in vain, where it tells.
    pub steps: u64,
    pub rejected: Option<u64>,
}

/// Steps after which a run is given up.
const MAX_STEPS: u32 = 1_000_000;

fn coordinates(y: &[f64]) -> [f64; N_Q] {
    std::array::from_fn(|i| y[i])
}
