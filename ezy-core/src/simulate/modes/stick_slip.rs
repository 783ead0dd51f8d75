//! Stick–slip friction: a skate that holds up to a limit and slides beyond it.

use super::Modes;
use crate::dynamics::MotionError;
use crate::model::{EventInfo, SceneRef, StickSlipInfo};
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

/// Whether the reaction of the holding skate exceeds the limit.
pub(super) fn ends<P: SceneRef>(
    modes: &Modes,
    info: &StickSlipInfo,
    stepper: &StepperState<P>,
) -> Result<bool, MotionError> {
    let limit = limit(info, stepper)?;
    Ok(modes.mode == HOLDS && reaction(info, stepper).abs() > limit)
}

/// Stick to slip against the reaction; slip to stick, or to slip to the other side when the reaction exceeds the limit.
/// Returns whether the skate then slides, so that its velocity begins at zero.
pub(super) fn change<P: SceneRef>(
    modes: &mut Modes,
    info: &'static StickSlipInfo,
    stepper: &mut StepperState<P>,
) -> Result<bool, MotionError> {
    let held = modes.mode == HOLDS;
    if !held {
        modes.tell(&info.stops, stepper);
        modes.switch(HOLDS, stepper)?;
    }
    let (reaction, limit) = (reaction(info, stepper), limit(info, stepper)?);
    if held || reaction.abs() > limit {
        modes.tell(&info.slides, stepper);
        modes.switch(if reaction > 0.0 { SLIDES_LEFT } else { SLIDES_RIGHT }, stepper)?;
    }
    Ok(modes.mode != HOLDS)
}

/// What ends a mode.
pub(super) fn function<P: SceneRef>(
    info: &'static StickSlipInfo,
    mode: usize,
    stepper: &StepperState<P>,
) -> (EventFunction, &'static [EventInfo]) {
    match side(mode) {
        None => {
            let (a, lambda) = (stepper.now.a.clone(), stepper.now.lambda.clone());
            (EventFunction::Reserve { info, a, lambda }, std::slice::from_ref(&info.slides))
        }
        Some(side) => (EventFunction::Slide { info, side }, std::slice::from_ref(&info.stops)),
    }
}

/// Force of the skate that holds, N.
fn reaction<P: SceneRef>(info: &StickSlipInfo, stepper: &StepperState<P>) -> f64 {
    stepper.now.lambda[info.row]
}

fn limit<P: SceneRef>(info: &StickSlipInfo, stepper: &StepperState<P>) -> Result<f64, MotionError> {
    let state = &stepper.now.state;
    Ok(laws::stick_slip(&stepper.system, info, state.t, &state.q, &state.v)?[0])
}
