//! Checks of a scene against finite differences and against itself, for one line in a user's test.
//!
//! ```text
//! ezy_core::testing::check_scene(&scene)?;
//! ezy_core::testing::check_model(&pendulum::MODEL)?;      // every scene of a model
//! ```

// matrices keep the capital letters of the notation
#![allow(non_snake_case)]

mod derivatives;
mod energy;
mod jacobians;
mod probe;
mod quasi;
mod report;
mod series;
mod solvers;
mod steps;

use crate::dynamics::RankLoss;
pub use report::{Check, CheckError, CheckReport};
pub use steps::{GivenSteps, StepsBy};

use crate::dynamics::System;
use crate::linalg::Backend;
use crate::model::{ModelInfo, Scene};
use probe::Probe;

/// Checks the equations of a scene by independent routes.
///
/// At 1,000 random states, the same ones each time: C_q and the velocity constraints against central differences of C;
/// [h; s] against central differences of the velocity constraints along the motion; G against the velocity constraints; powers and
/// the growth of the potential energy against F·v and λ·g_t; the Jacobians of the equations of motion against central
/// differences of their residual; accelerations, multipliers and mass-weighted corrections
/// of the generated elimination and the sparse backend against the dense one, at fewer states in large scenes; the equations in
/// quasi-velocities against those of the rows; the Taylor series against the equations a little later. At the
/// start: whether rows that depend on each other agree. Over a short run: the energy balance, extrapolated to step zero.
///
/// # Errors
/// [`CheckError::Failed`] with the report when a check failed, others when the scene cannot be set up or started.
pub fn check_scene(scene: &dyn Scene) -> Result<CheckReport, CheckError> {
    let mut system = System::new(scene, Backend::Auto)?;
    let info = scene.info();
    let is_integrated = |i: usize| info.integrated_inputs.iter().any(|first| (*first..first + 4).contains(&i));
    // inputs that differ from each other and from zero; constraints at the start have those that are declared
    let differ = |inputs: &mut [f64], integrated: bool| {
        let chosen = inputs.iter_mut().enumerate().filter(|(i, _)| is_integrated(*i) == integrated);
        chosen.for_each(|(i, input)| *input += 1.0 + 0.5 * i as f64);
    };
    differ(system.inputs_mut(), false);
    let given = system.scene_start();
    let start = system.consistent_start(&given)?;
    let moved = system.moved_values(&given, &start);
    let mut fixed = system.fixed().to_vec();
    differ(&mut fixed[..info.n_inputs()], true);
    let states = fixed[info.n_inputs()..].iter_mut().take(info.n_states());
    states.enumerate().for_each(|(i, state)| *state += 1.0 + 0.5 * i as f64);
    let probe = Probe::new(scene, &fixed);
    let agreement = solvers::agreement_at_start(&mut system, &start);
    let rank = Some(system.rank_loss(start.t, &start.q)).filter(RankLoss::is_lost);
    let mut checks = vec![
        agreement,
        derivatives::jacobian_of_positions(&probe),
        derivatives::velocity_rows(&probe),
        derivatives::convective_term(&probe),
        derivatives::jacobian_of_velocities(&probe),
        derivatives::power(&probe),
    ];
    checks.extend(jacobians::of_residual(&probe));
    checks.extend(solvers::backends(&probe)?);
    checks.extend(quasi::against_rows(&probe)?);
    checks.extend(series::ahead(&probe)?);
    checks.push(energy::balance(scene, start.t)?);
    let report = CheckReport { model: info.model, scene: info.name, checks, rank, moved };
    if report.passed() { Ok(report) } else { Err(CheckError::Failed(Box::new(report))) }
}

/// [`check_scene`] for every scene of a model, with the declared parameters; a report for each scene.
///
/// # Errors
/// As [`check_scene`], at the first scene that has one.
pub fn check_model(model: &ModelInfo) -> Result<Vec<CheckReport>, CheckError> {
    model.scenes.iter().map(|entry| check_scene(&*(entry.new)())).collect()
}
