//! Stick–slip friction: a skate that holds up to a limit and slides beyond it.

use super::{Law, Modes};
use crate::dynamics::{MotionError, System};
use crate::model::{EventInfo, SceneRef};
use crate::simulate::events::{EventFunction, laws};
use crate::simulate::stepping::stepper_state::StepperState;

const HOLDS: usize = 0;
const SLIDES_LEFT: usize = 1;
const SLIDES_RIGHT: usize = 2;

/// Side to which the skate slides: 1 for the left of its direction, -1 for the right.
pub(super) fn side(mode: usize) -> Option<f64> {
    match mode {
        SLIDES_LEFT => Some(1.0),
        SLIDES_RIGHT => Some(-1.0),
        _ => None,
    }
}

/// Switches of a mode: whether the row holds, and the side to which the skate slides.
pub(super) fn switches(mode: usize) -> (bool, f64) {
    (mode == HOLDS, side(mode).unwrap_or(0.0))
}

/// A limit that is no number, or not positive.
pub(super) fn fault<P: SceneRef>(system: &System<P>, t: f64, q: &[f64], v: &[f64]) -> Option<MotionError> {
    let mut values = Vec::new();
    let n_skates = system.info().limited_skates.len();
    (0..n_skates).find_map(|skate| laws::limited_skate(system, skate, t, q, v, &mut values).err())
}

/// Whether the reaction of the holding skate exceeds the limit.
pub(super) fn ends<P: SceneRef>(
    mode: usize,
    skate: usize,
    row: usize,
    stepper: &StepperState<P>,
) -> Result<bool, MotionError> {
    let [limit, _] = limit_and_velocity(skate, stepper)?;
    Ok(mode == HOLDS && stepper.now.lambda[row].abs() > limit)
}

/// Stick to slip against the reaction; slip to stick, or to slip to the other side when the reaction exceeds the limit.
pub(super) fn change<P: SceneRef>(
    modes: &mut Modes,
    i: usize,
    skate: usize,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    let info = &stepper.system.info().limited_skates[skate];
    let held = modes.rows[i].mode == HOLDS;
    if !held {
        modes.tell(&info.stops, stepper);
        modes.switch(i, HOLDS, stepper)?;
    }
    let reaction = stepper.now.lambda[info.row];
    let [limit, _] = limit_and_velocity(skate, stepper)?;
    if held || reaction.abs() > limit {
        modes.tell(&info.slides, stepper);
        modes.switch(i, if reaction > 0.0 { SLIDES_LEFT } else { SLIDES_RIGHT }, stepper)?;
    }
    Ok(())
}

/// Before an impact: none holds against it, since that would take a force without bound.
pub(super) fn let_go<P: SceneRef>(modes: &Modes, stepper: &mut StepperState<P>) {
    skates(modes).for_each(|(i, _)| stepper.system.switch(modes.rows[i].row, false, 0.0));
}

/// Switches skates as velocities after an impact are, and evaluates the state where there are some.
pub(super) fn switch_after_impact<P: SceneRef>(
    modes: &Modes,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    let mut is_any = false;
    for (i, skate) in skates(modes) {
        let (holds, side) = switches(mode_of_velocity(skate, stepper)?);
        stepper.system.switch(modes.rows[i].row, holds, side);
        is_any = true;
    }
    if is_any { stepper.evaluate_now() } else { Ok(()) }
}

/// Enters the modes of skates after an impact, and tells which changed.
pub(super) fn tell_after_impact<P: SceneRef>(
    modes: &mut Modes,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    for (i, skate) in skates(modes).collect::<Vec<_>>() {
        let info = &stepper.system.info().limited_skates[skate];
        let (before, mode) = (modes.rows[i].mode, mode_of_velocity(skate, stepper)?);
        if mode == before {
            continue;
        }
        if before != HOLDS {
            modes.tell(&info.stops, stepper);
        }
        if mode != HOLDS {
            modes.tell(&info.slides, stepper);
        }
        modes.enter(i, mode, stepper);
    }
    Ok(())
}

/// Rows of skates, with their places among the skates with a limit.
fn skates(modes: &Modes) -> impl Iterator<Item = (usize, usize)> {
    modes.rows.iter().enumerate().filter_map(|(i, of)| match of.law {
        Law::Skate(skate) => Some((i, skate)),
        Law::Stop(_) => None,
    })
}

/// The mode of a skate that moves so: to a side, or held where what is left across it is rounding.
fn mode_of_velocity<P: SceneRef>(skate: usize, stepper: &mut StepperState<P>) -> Result<usize, MotionError> {
    let [_, velocity] = limit_and_velocity(skate, stepper)?;
    let row = stepper.system.info().limited_skates[skate].row;
    if velocity.abs() <= stepper.system.diagnosis().velocity_tolerance(row, &stepper.now.state.v) {
        return Ok(HOLDS);
    }
    Ok(if velocity > 0.0 { SLIDES_LEFT } else { SLIDES_RIGHT })
}

/// What ends a mode.
pub(super) fn function<P: SceneRef>(
    skate: usize,
    mode: usize,
    stepper: &StepperState<P>,
) -> (EventFunction, &'static [EventInfo]) {
    let info = &stepper.system.info().limited_skates[skate];
    let values = Vec::new();
    match side(mode) {
        None => {
            let (a, lambda) = (stepper.now.a.clone(), stepper.now.lambda.clone());
            (EventFunction::Reserve { skate, a, lambda, values }, std::slice::from_ref(&info.slides))
        }
        Some(side) => (EventFunction::Slide { skate, side, values }, std::slice::from_ref(&info.stops)),
    }
}

fn limit_and_velocity<P: SceneRef>(skate: usize, stepper: &StepperState<P>) -> Result<[f64; 2], MotionError> {
    let state = &stepper.now.state;
    laws::limited_skate(&stepper.system, skate, state.t, &state.q, &state.v, &mut Vec::new())
}
