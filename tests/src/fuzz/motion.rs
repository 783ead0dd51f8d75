//! A short run: it comes to its end with sound numbers, or says why not.

use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;

use super::draw::Draw;
use super::tally::Verdict;

/// Steps of a method with a fixed step.
const N_STEPS: f64 = 5.0;

/// Steps after which a method that chooses them is ended.
const MOST_STEPS: u64 = 30;

/// Residuals on the rows after a projection, of positions and velocities of this size; ten times what runs promise.
const ON_THE_ROWS: f64 = 1e-9;

/// Share of the energy turned over that may be missing.
const LARGEST_IMBALANCE: f64 = 1e-3;

/// What a run is ordered with.
#[derive(Debug, Clone)]
pub struct Order {
    method: Method,
    until_s: f64,
    backend: Backend,
    /// Start values by name.
    pub given: Vec<(String, f64)>,
    /// Inputs by name.
    pub inputs: Vec<(String, f64)>,
}

impl Order {
    /// Method, step, tolerance and solver by chance.
    pub fn new(draw: &mut Draw, wild: bool) -> Self {
        let step_s = draw.instead_of(1e-3, wild);
        let relative = draw.instead_of(1e-8, wild);
        let tolerance = Tolerance::new(relative, draw.instead_of(relative, wild));
        let (method, until_s) = match draw.below(6) {
            0 => (Method::dop853(relative).with_tolerance(tolerance), draw.instead_of(1e-2, false)),
            1 => (Method::taylor(relative).with_tolerance(tolerance), draw.instead_of(1e-2, false)),
            2 => (Method::radau(relative).with_tolerance(tolerance), draw.instead_of(1e-2, false)),
            _ => (Method::rk4(step_s), N_STEPS * step_s),
        };
        let backends = [Backend::Auto, Backend::Auto, Backend::Generated, Backend::Dense, Backend::Sparse];
        Self { method, until_s, backend: backends[draw.below(backends.len())], given: Vec::new(), inputs: Vec::new() }
    }
}

/// Runs.
///
/// # Errors
/// What is wrong with the numbers of a run that says nothing of it.
pub fn check(scene: &dyn Scene, order: &Order) -> Result<Verdict, String> {
    let mut simulation = simulation(scene)
        .method(order.method)
        .until(order.until_s)
        .backend(order.backend)
        .max_steps(MOST_STEPS)
        .work()
        .outputs();
    for (name, value) in &order.given {
        simulation = simulation.start(name, *value);
    }
    for (name, value) in &order.inputs {
        simulation = simulation.input(name, *value);
    }
    let run = match simulation.run() {
        Ok(run) => run,
        Err(SetupError::Start(_)) => return Ok(Verdict::StartRefused),
        Err(_) => return Ok(Verdict::RunRefused),
    };
    let last = run.last();
    if last.coordinates.iter().chain(last.velocities).any(|x| !x.is_finite()) {
        return Err(format!("the last state is not finite; the run {}", run.outcome));
    }
    if matches!(run.outcome, Outcome::Stopped { .. }) {
        return Ok(Verdict::RunStopped);
    }
    let moving = last.accelerations.iter().chain(last.multipliers);
    if moving.chain([&last.position_residual, &last.velocity_residual]).any(|x| !x.is_finite()) {
        return Err(
            "the run reached its end with accelerations, multipliers or residuals that are not finite".to_owned()
        );
    }
    let size = |x: &[f64]| x.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
    let residual = last.position_residual / size(last.coordinates);
    if residual > ON_THE_ROWS {
        return Err(format!("the run reached its end with a position residual of {residual:.1e}"));
    }
    let energy = last.energy;
    let share = energy.balance.abs() / (energy.kinetic + energy.work.abs());
    let unbalanced = !share.is_finite() && energy.balance != 0.0 || share > LARGEST_IMBALANCE;
    Ok(if unbalanced { Verdict::RunEndedUnbalanced } else { Verdict::RunEnded })
}
