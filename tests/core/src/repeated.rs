//! What is repeated to count its instructions: in this package, since it is compiled in one unit, and its counts do not change with what
//! stands beside it.

use ezy_core::integrate::Method;
use ezy_core::linalg::Backend;
use ezy_core::model::Scene;
use ezy_core::prelude::State;
use ezy_core::testing::{GivenSteps, StepsBy};
use std::error::Error;
use std::hint::black_box;

use crate::{simulation, system_of};

/// Step of RK4, s.
const STEP_S: f64 = 1e-3;
/// Where a right side and a series are evaluated, s: nothing is zero by symmetry there.
const AT_S: f64 = 0.5;
/// Tolerance of collocation, whose steps differ in length: a part of the motion is counted, s.
const RTOL: f64 = 1e-9;
const PART_S: f64 = 0.01;
/// Orders of Taylor's method at tolerances of about 1e-9 and 1e-16.
const ORDERS: [usize; 2] = [12, 20];

/// What is counted: the columns of the table.
pub const COLUMNS: [&str; 5] = ["right side", "step of RK4", "Taylor, order 12", "Taylor, order 20", "10 ms of gauss"];

/// Does what column `i` counts `n` times, of a scene behind its trait, as the command line runs it. False when it cannot.
///
/// # Errors
/// Those of the runs and steps.
pub fn repeat(scene: &dyn Scene, column: usize, n: u64) -> Result<bool, Box<dyn Error>> {
    let run = |until_s: f64| simulation(scene).method(Method::rk4(STEP_S)).until(until_s).run();
    if column == 1 {
        run(STEP_S * n as f64)?;
        return Ok(true);
    }
    if column == 4 {
        simulation(scene).method(Method::gauss(RTOL)).until(PART_S * n as f64).run()?;
        return Ok(true);
    }
    let at = run(AT_S)?;
    let state = State {
        t: AT_S,
        q: at.last().coordinates.to_vec(),
        v: at.last().velocities.to_vec(),
        z: Vec::new(),
        work: Vec::new(),
    };
    let system = system_of(scene, Backend::Generated)?;
    if column == 0 {
        let (mut a, mut lambda) = (vec![0.0; state.q.len()], vec![0.0; scene.info().n_rows()]);
        for _ in 0..n {
            black_box(scene.accelerations(system.fixed(), state.t, &state.q, &state.v, &mut a, &mut lambda));
        }
        return Ok(true);
    }
    let order = StepsBy::Taylor(ORDERS[column - 2]);
    let Some(mut steps) = GivenSteps::new(system, state, order) else { return Ok(false) };
    for _ in 0..n {
        black_box(steps.attempt(black_box(STEP_S))?);
    }
    Ok(true)
}

/// Step of RK4 of scenes with counts, s.
const SHORT_STEP_S: f64 = 1e-6;
/// By how much an angle differs from that of the last evaluation, rad.
const TURN_RAD: f64 = 1e-9;

/// What is counted of scenes with counts: columns of a table of their own.
pub const OF_COUNTS: [&str; 3] = ["set-up and a step", "right side", "step of RK4"];

/// Does what column `i` of [`OF_COUNTS`] counts `n` times. But for the set-up, angles differ from member to member: small pivots of straight chains
/// cost more.
///
/// # Errors
/// Those of the runs and evaluations.
pub fn repeat_with_counts(scene: &dyn Scene, column: usize, n: u64) -> Result<(), Box<dyn Error>> {
    let order = |n_steps: u64| simulation(scene).method(Method::rk4(SHORT_STEP_S)).until(SHORT_STEP_S * n_steps as f64);
    if column == 0 {
        for _ in 0..n {
            order(1).run()?;
        }
        return Ok(());
    }
    let info = scene.info();
    let angles = info.coordinates.iter().filter(|coordinate| coordinate.is_angle()).enumerate();
    let bent = |n_steps: u64| {
        angles.clone().fold(order(n_steps), |order, (i, angle)| order.start(&*angle.name, 0.3 * (0.7 * i as f64).sin()))
    };
    if column == 2 {
        bent(n).run()?;
        return Ok(());
    }
    let start = bent(1).run()?;
    let (mut q, v) = (start.last().coordinates.to_vec(), start.last().velocities.to_vec());
    let (mut a, mut lambda) = (vec![0.0; v.len()], vec![0.0; info.n_rows()]);
    let mut system = system_of(scene, Backend::Auto)?;
    for _ in 0..n {
        q[2] += TURN_RAD;
        black_box(system.accelerations(0.0, &q, &v, &mut a, &mut lambda)?);
    }
    Ok(())
}
