//! Unilateral contact: impacts where the quantity of a stop reaches an end, and rest there.
//!
//! An impact is an impulse along the row that the stop would be. With v₀ the velocity at which the scene would rest on the
//! stop, the nearest one in the metric of the masses, the velocity after it is v₀ + e (v₀ − v): every other row is kept, since
//! v and v₀ keep it, and the rate of the quantity becomes −e times what it was.

use super::Modes;
use crate::dynamics::{MotionError, SystemRow};
use crate::integrate::resolution_at;
use crate::model::{EventInfo, SceneRef, StopInfo};
use crate::simulate::SetupError;
use crate::simulate::events::EventFunction;
use crate::simulate::stepping::stepper_state::StepperState;
use crate::simulate::tolerances::modes::{LOWEST_FLIGHT, SHORTEST_FLIGHT};

const FREE: usize = 0;

/// The end of the stop that is nearest.
struct Contact {
    /// Index of the end.
    end: usize,
    /// Distance from the end, positive inside, and its rate.
    gap: f64,
    rate: f64,
    restitution: f64,
}

/// Begins in contact when the start is at rest on an end. Refuses a start beyond an end.
pub(super) fn start<P: SceneRef>(
    modes: &mut Modes<P>,
    info: &'static StopInfo,
    stepper: &mut StepperState<P>,
) -> Result<(), SetupError> {
    let Contact { end, gap, rate, .. } = nearest(info, stepper)?;
    let state = &stepper.now.state;
    let row = SystemRow { row: info.row, t: state.t, q: &state.q, v: &state.v };
    let Some(rest) = modes.parked_in(end + 1) else { return Ok(()) };
    let touching = rest.system.position_tolerance(&row);
    if gap < -touching {
        let scene = stepper.system.info().name;
        return Err(SetupError::BeyondStop { scene, stop: info.name, end: info.end(end), beyond: -gap });
    }
    if gap > touching {
        return Ok(());
    }
    check_rate(info, end, state.t, rate)?;
    let stands = rate == 0.0 || flight_is_too_short(info, end, stepper, rest);
    if stands {
        modes.change(stepper)?;
        modes.occurred.clear();
    }
    modes.is_due = !stands && rate < 0.0;
    Ok(())
}

/// Whether the closed contact would have to pull.
pub(super) fn ends<P: SceneRef>(modes: &Modes<P>, info: &StopInfo, stepper: &StepperState<P>) -> bool {
    modes.mode != FREE && push(info, modes.mode, stepper) < 0.0
}

/// Free to free or to contact, by an impact; contact to free. Returns whether the distance then begins at zero.
pub(super) fn change<P: SceneRef>(
    modes: &mut Modes<P>,
    info: &'static StopInfo,
    stepper: &mut StepperState<P>,
) -> Result<bool, MotionError> {
    if modes.mode == FREE {
        arrive(modes, info, stepper)?;
    } else {
        modes.tell(&info.lets_go, stepper);
        modes.switch(FREE, stepper)?;
    }
    Ok(modes.mode == FREE)
}

/// What ends a mode.
pub(super) fn function<P: SceneRef>(
    info: &'static StopInfo,
    mode: usize,
    stepper: &StepperState<P>,
) -> (EventFunction, &'static [EventInfo]) {
    if mode == FREE {
        return (EventFunction::Gaps { info, values: vec![0.0; n_values(info)] }, info.hits);
    }
    let (a, lambda) = (stepper.now.a.clone(), stepper.now.lambda.clone());
    let side = f64::from(info.sides[mode - 1]);
    (EventFunction::Push { row: info.row, side, a, lambda }, std::slice::from_ref(&info.lets_go))
}

/// The impact, and the choice of the next mode.
fn arrive<P: SceneRef>(
    modes: &mut Modes<P>,
    info: &'static StopInfo,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    let Contact { end, rate, restitution, .. } = nearest(info, stepper)?;
    check_rate(info, end, stepper.now.state.t, rate)?;
    if !(0.0..=1.0).contains(&restitution) {
        return Err(MotionError::Restitution { t: stepper.now.state.t, stop: info.name, value: restitution });
    }
    let comes = rate < 0.0;
    if comes {
        modes.tell(&info.hits[end], stepper);
    }
    let mode = end + 1;
    let Some(rest) = modes.parked_in(mode) else { return Ok(()) };
    rest.apply_impact(stepper)?;
    let e = if comes { restitution } else { 0.0 };
    let (before, landed) = (stepper.energy(), &rest.now.state);
    let velocities = landed.v.iter().zip(&stepper.now.state.v).map(|(v0, v)| v0 + e * (v0 - v)).collect();
    stepper.apply_restitution(&landed.q, velocities)?;
    let stays = e == 0.0 || flight_is_too_short(info, end, stepper, rest);
    let rests = stays && push(info, mode, rest) >= 0.0;
    let arrived = if rests { &mut *rest } else { &mut *stepper };
    let lost = arrived.energy() - before;
    if let Some(work) = arrived.now.state.work.last_mut() {
        *work += lost;
    }
    if rests {
        modes.swap(mode, stepper);
        modes.tell(&info.holds, stepper);
    }
    Ok(())
}

/// Whether the flight from an end back to it, under the acceleration at its start, is too short to be followed; not when the acceleration
/// points away from the end.
fn flight_is_too_short<P: SceneRef>(
    info: &StopInfo,
    end: usize,
    stepper: &StepperState<P>,
    rest: &mut StepperState<P>,
) -> bool {
    let state = &stepper.now.state;
    let row = SystemRow { row: info.row, t: state.t, q: &state.q, v: &state.v };
    let (acceleration, rounding) = rest.system.row_acceleration(&row, &stepper.now.a);
    let fall = -f64::from(info.sides[end]) * acceleration;
    if fall.is_nan() || fall <= 0.0 {
        return false;
    }
    let mut values = vec![0.0; n_values(info)];
    stepper.system.stop(state.t, &state.q, &state.v, &mut values);
    let rate = values[2 * end + 1];
    let (length_s, height) = (2.0 * rate.abs() / fall, 0.5 * rate * rate / fall);
    let shortest_s = SHORTEST_FLIGHT * resolution_at(state.t);
    length_s < shortest_s || height < LOWEST_FLIGHT * rounding
}

/// The nearest end.
fn nearest<P: SceneRef>(info: &StopInfo, stepper: &StepperState<P>) -> Result<Contact, MotionError> {
    let (state, mut values) = (&stepper.now.state, vec![0.0; n_values(info)]);
    stepper.system.checked_stop(info, state.t, &state.q, &state.v, &mut values)?;
    let gap = |end: &usize| values[2 * end];
    let ends = 0..info.hits.len();
    let end = ends.min_by(|a, b| gap(a).total_cmp(&gap(b))).unwrap_or_default();
    Ok(Contact { end, gap: gap(&end), rate: values[2 * end + 1], restitution: values[2 * info.hits.len()] })
}

/// The rate at an end must be finite: its sign says whether the scene approaches or leaves.
fn check_rate(info: &StopInfo, end: usize, t: f64, rate: f64) -> Result<(), MotionError> {
    if rate.is_finite() {
        return Ok(());
    }
    Err(MotionError::StopNotFinite { t, stop: info.name, end: info.end(end), what: "speed", value: rate })
}

fn n_values(info: &StopInfo) -> usize {
    2 * info.hits.len() + 1
}

/// Force of the stop that holds, away from the end.
fn push<P: SceneRef>(info: &StopInfo, mode: usize, stepper: &StepperState<P>) -> f64 {
    -f64::from(info.sides[mode - 1]) * stepper.now.lambda[info.row]
}
