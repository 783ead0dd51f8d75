//! Unilateral contact: impacts where the quantity of a stop reaches an end, and rest there.
//!
//! An impact is an impulse along the row that the stop would be. With v₀ the velocity at which the scene would rest on the
//! stop, the nearest one in the metric of the masses, the velocity after it is v₀ + e (v₀ − v): every other row is kept, since
//! v and v₀ keep it, and the rate of the quantity becomes −e times what it was. Skates with a limit are no such rows: a force
//! that is bounded has no impulse.

use super::{Modes, stick_slip};
use crate::dynamics::{MotionError, System, SystemRow};
use crate::integrate::resolution_at;
use crate::model::{Derived as _, EventInfo, SceneRef, StopInfo};
use crate::simulate::events::{EventFunction, laws};
use crate::simulate::stepping::stepper_state::StepperState;
use crate::simulate::tolerances::modes::{LOWEST_FLIGHT, SHORTEST_FLIGHT};
use crate::simulate::{SetupError, SoftestImpact};

pub(super) const FREE: usize = 0;

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
    modes: &mut Modes,
    i: usize,
    info: &'static StopInfo,
    stepper: &mut StepperState<P>,
) -> Result<(), SetupError> {
    let Contact { end, gap, rate, .. } = nearest(info, stepper)?;
    let state = &stepper.now.state;
    let row = SystemRow { row: info.row, t: state.t, q: &state.q, v: &state.v };
    let touching = stepper.system.diagnosis().position_tolerance(&row);
    if gap < -touching {
        let scene = stepper.system.info().name;
        return Err(SetupError::BeyondStop { scene, stop: info.name, end: info.end(end), beyond: -gap });
    }
    if gap > touching {
        return Ok(());
    }
    check_rate(info, end, state.t, rate)?;
    let stands = rate == 0.0 || flight_is_too_short(info, end, stepper);
    if stands {
        modes.change(i, stepper)?;
        modes.occurred.clear();
        modes.softest = None;
    }
    modes.rows[i].is_due = !stands && rate < 0.0;
    Ok(())
}

/// A distance, or a rate of one, that is no number.
pub(super) fn fault<P: SceneRef>(
    info: &StopInfo,
    system: &System<P>,
    t: f64,
    q: &[f64],
    v: &[f64],
) -> Option<MotionError> {
    let mut values = vec![0.0; n_values(info)];
    let read = laws::stop(system, info, t, q, v, &mut values);
    read.err().or_else(|| (0..info.hits.len()).find_map(|end| check_rate(info, end, t, values[2 * end + 1]).err()))
}

/// Switches of a mode: whether the row holds, and its side.
pub(super) fn switches(info: &StopInfo, mode: usize) -> (bool, f64) {
    match mode {
        FREE => (false, 0.0),
        _ => (true, side(info, mode)),
    }
}

/// Whether the closed contact would have to pull.
pub(super) fn ends<P: SceneRef>(mode: usize, info: &StopInfo, stepper: &StepperState<P>) -> bool {
    mode != FREE && push(info, mode, stepper) < 0.0
}

/// Free to free or to contact, by an impact; contact to free.
pub(super) fn change<P: SceneRef>(
    modes: &mut Modes,
    i: usize,
    info: &'static StopInfo,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    if modes.rows[i].mode == FREE {
        return arrive(modes, i, info, stepper);
    }
    modes.tell(&info.lets_go, stepper);
    modes.switch(i, FREE, stepper)
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
    (EventFunction::Push { row: info.row, side: side(info, mode), a, lambda }, std::slice::from_ref(&info.lets_go))
}

/// The impact, and the choice of the next mode.
fn arrive<P: SceneRef>(
    modes: &mut Modes,
    i: usize,
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
        if modes.softest.is_none_or(|softest| -rate < softest.speed) {
            modes.softest = Some(SoftestImpact { speed: -rate, t: stepper.now.state.t });
        }
    }
    let e = if comes { restitution } else { 0.0 };
    modes.attempt(stepper, |modes, stepper| land(modes, i, info, end, e, stepper))
}

/// The impact on an end with the restitution `e`, and whether it rests there.
fn land<P: SceneRef>(
    modes: &mut Modes,
    i: usize,
    info: &'static StopInfo,
    end: usize,
    e: f64,
    stepper: &mut StepperState<P>,
) -> Result<(), MotionError> {
    let mode = end + 1;
    let (before, v) = (stepper.energy(), stepper.now.state.v.clone());
    stick_slip::let_go(modes, stepper);
    stepper.apply_impact(info.row, side(info, mode))?;
    stick_slip::switch_after_impact(modes, stepper)?;
    let (landed, pushes) = (stepper.now.state.v.clone(), push(info, mode, stepper) >= 0.0);
    let mut rests = pushes && e == 0.0;
    if !rests {
        let velocities: Vec<f64> = landed.iter().zip(&v).map(|(v0, v)| v0 + e * (v0 - v)).collect();
        stepper.system.switch(info.row, false, 0.0);
        stepper.go_on_with(&velocities)?;
        stick_slip::switch_after_impact(modes, stepper)?;
        rests = pushes && flight_is_too_short(info, end, stepper);
        if rests {
            stepper.system.switch(info.row, true, side(info, mode));
            stepper.go_on_with(&landed)?;
            stick_slip::switch_after_impact(modes, stepper)?;
        }
    }
    let lost = stepper.energy() - before;
    if let Some(work) = stepper.now.state.work.last_mut() {
        *work += lost;
    }
    if rests {
        modes.tell(&info.holds, stepper);
    }
    modes.enter(i, if rests { mode } else { FREE }, stepper);
    stick_slip::tell_after_impact(modes, stepper)
}

/// Whether the flight from an end back to it, under the acceleration at its start, is too short to be followed; not when the acceleration
/// points away from the end.
fn flight_is_too_short<P: SceneRef>(info: &StopInfo, end: usize, stepper: &mut StepperState<P>) -> bool {
    let state = &stepper.now.state;
    let row = SystemRow { row: info.row, t: state.t, q: &state.q, v: &state.v };
    // the row says how fast its quantity falls
    stepper.system.switch(info.row, true, side(info, end + 1));
    let (acceleration, rounding) = stepper.system.diagnosis().row_acceleration(&row, &stepper.now.a);
    stepper.system.switch(info.row, false, 0.0);
    let fall = -f64::from(info.sides[end]) * acceleration;
    if fall.is_nan() || fall <= 0.0 {
        return false;
    }
    let mut values = vec![0.0; n_values(info)];
    let system = &stepper.system;
    system.scene().stop(system.fixed(), state.t, &state.q, &state.v, &mut values);
    let rate = values[2 * end + 1];
    let (length_s, height) = (2.0 * rate.abs() / fall, 0.5 * rate * rate / fall);
    let shortest_s = SHORTEST_FLIGHT * resolution_at(state.t);
    length_s < shortest_s || height < LOWEST_FLIGHT * rounding
}

/// The nearest end.
fn nearest<P: SceneRef>(info: &StopInfo, stepper: &StepperState<P>) -> Result<Contact, MotionError> {
    let (state, mut values) = (&stepper.now.state, vec![0.0; n_values(info)]);
    laws::stop(&stepper.system, info, state.t, &state.q, &state.v, &mut values)?;
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

/// Of the end that holds in a mode: 1 for the lower one, -1 for the upper one.
fn side(info: &StopInfo, mode: usize) -> f64 {
    f64::from(info.sides[mode - 1])
}

fn n_values(info: &StopInfo) -> usize {
    2 * info.hits.len() + 1
}

/// Force of the stop that holds, away from the end.
fn push<P: SceneRef>(info: &StopInfo, mode: usize, stepper: &StepperState<P>) -> f64 {
    -side(info, mode) * stepper.now.lambda[info.row]
}
