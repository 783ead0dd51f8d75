//! Rows that hold on one side, or up to a limit: which of them hold where a motion is steady.

use super::error::AnalysisError;
use super::newton::with_rows;
use super::steady_motion::SteadyMotion;
use super::tolerances::search::{LONGEST, MET};
use crate::dynamics::{State, System};
use crate::model::{Derived as _, SceneRef, Start, StopInfo};
use std::sync::Arc;

impl SteadyMotion {
    /// The steady motion near the consistent state of a start. Where all velocities of that are zero, it is rest; else a frame may travel
    /// and turn. Coordinates, velocities and first-order states that are named in `hold` keep their values of the start; what else the
    /// equations leave free stays as near to the start as it can.
    ///
    /// A scene with a stop is free of it or rests on one of its ends, which then pushes; skates with a limit hold.
    ///
    /// # Errors
    /// [`AnalysisError`]; [`AnalysisError::NotFound`] names the equation that is left most.
    pub fn near<P: SceneRef>(system: &mut System<P>, start: &Start, hold: &[&str]) -> Result<Self, AnalysisError> {
        if !system.info().is_planar() {
            return Err(AnalysisError::Spatial { scene: system.info().name });
        }
        near(system, start, hold, LONGEST)
    }
}

/// The steady motion near a start, free of the stop of the scene, if there is one, or on an end that then pushes. The first of these that there is:
/// where the start is on an end that one; free; on the other ends, the nearest first. The system stays switched as it was found.
pub(super) fn near<P: SceneRef>(
    system: &mut System<P>,
    start: &Start,
    hold: &[&str],
    longest: f64,
) -> Result<SteadyMotion, AnalysisError> {
    let info = Arc::clone(system.info());
    let Some(stop) = &info.stop else {
        let found = with_rows(system, start, hold, longest)?;
        return below_limits(system, found);
    };
    release(system);
    let state = system.consistent_start(start)?;
    let gaps = gaps(system, stop, &state);
    let touching = touching(system);
    let mut ends: Vec<usize> = (0..gaps.len()).collect();
    ends.sort_by(|a, b| gaps[*a].abs().total_cmp(&gaps[*b].abs()));
    let mut modes: Vec<Option<usize>> = ends.into_iter().map(Some).collect();
    modes.insert(usize::from(gaps.iter().any(|gap| gap.abs() <= touching)), None);
    let mut beyond = AnalysisError::BeyondStop { scene: info.name, stop: stop.name };
    for mode in modes {
        switch(system, stop, mode);
        let mut start = start.clone();
        if mode.is_some() {
            // from where the stop does not hold, to it
            start.q.clone_from(&state.q);
            let names = info.coordinates.iter().map(|of| hold.contains(&&*of.name));
            start.q_given.iter_mut().zip(names).for_each(|(given, held)| *given &= held);
        }
        match with_rows(system, &start, hold, longest) {
            Ok(found) if is_admissible(system, stop, mode, &found) => return below_limits(system, found),
            Ok(_) => {}
            Err(error @ AnalysisError::NotFound { .. }) if mode.is_none() => beyond = error,
            Err(AnalysisError::NotFound { .. } | AnalysisError::Start(_)) => {}
            Err(error) => return Err(error),
        }
    }
    release(system);
    Err(beyond)
}

/// Frees the scene of its stop.
pub(super) fn release<P: SceneRef>(system: &mut System<P>) {
    if let Some(stop) = system.info().stop {
        switch(system, stop, None);
    }
}

fn switch<P: SceneRef>(system: &mut System<P>, stop: &StopInfo, end: Option<usize>) {
    system.switch(stop.row, end.is_some(), end.map_or(0.0, |end| f64::from(stop.sides[end])));
}

/// Distances from the ends, negative beyond.
fn gaps<P: SceneRef>(system: &System<P>, stop: &StopInfo, state: &State) -> Vec<f64> {
    let mut values = vec![0.0; 2 * stop.hits.len() + 1];
    system.scene().stop(system.fixed(), state.t, &state.q, &state.v, &mut values);
    (0..stop.hits.len()).map(|end| values[2 * end]).collect()
}

/// Distances that rounding leaves.
fn touching<P: SceneRef>(system: &System<P>) -> f64 {
    MET * system.length().max(1.0)
}

/// Whether the motion is before all ends, and the one that holds pushes.
fn is_admissible<P: SceneRef>(system: &System<P>, stop: &StopInfo, end: Option<usize>, found: &SteadyMotion) -> bool {
    let pushes = end.is_none_or(|end| f64::from(stop.sides[end]) * found.multipliers[stop.row] <= 0.0);
    pushes && gaps(system, stop, &found.state).iter().all(|gap| *gap >= -touching(system))
}

/// The end of the stop that pushes.
pub(super) fn pushing(stop: Option<&StopInfo>, motion: &SteadyMotion) -> Option<usize> {
    let stop = stop?;
    (0..stop.sides.len()).find(|&end| f64::from(stop.sides[end]) * motion.multipliers[stop.row] < 0.0)
}

/// Whether a motion with the rows as they are switched, where `end` of the stop pushes, if one does, is before all ends and needs no more of a skate
/// than it can hold.
pub(super) fn is_kept<P: SceneRef>(system: &System<P>, end: Option<usize>, motion: &SteadyMotion) -> bool {
    let stop = system.info().stop;
    stop.is_none_or(|stop| is_admissible(system, stop, end, motion)) && overloaded(system, motion).is_none()
}

/// Refuses a motion in which a skate has to hold more than it can.
fn below_limits<P: SceneRef>(system: &System<P>, found: SteadyMotion) -> Result<SteadyMotion, AnalysisError> {
    match overloaded(system, &found) {
        Some(error) => Err(error),
        None => Ok(found),
    }
}

fn overloaded<P: SceneRef>(system: &System<P>, found: &SteadyMotion) -> Option<AnalysisError> {
    let info = system.info();
    let State { t, q, v, .. } = &found.state;
    let mut values = vec![0.0; 2 * info.limited_skates.len()];
    system.scene().limited_skates(system.fixed(), *t, q, v, &mut values);
    info.limited_skates.iter().zip(values.iter().step_by(2)).find_map(|(skate, limit)| {
        let force = found.multipliers[skate.row].abs();
        let error = AnalysisError::Slides { scene: info.name, skate: skate.name, force, limit: *limit };
        (force > *limit).then_some(error)
    })
}
