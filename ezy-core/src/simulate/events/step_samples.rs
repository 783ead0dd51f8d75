//! Event functions over a step.

use super::double_root::double_root;
use super::event_function::EventFunction;
use crate::dynamics::{MotionError, State};
use crate::integrate::side_of;
use crate::model::SceneRef;
use crate::simulate::stepping::stepper_state::StepperState;
use crate::simulate::tolerances::events::N_PARTS;

/// Samples of event functions at the ends of [`N_PARTS`] parts of a step.
pub(super) struct StepSamples {
    function: EventFunction,
    /// Times of the samples.
    times: [f64; N_PARTS + 1],
    /// Values there.
    pub values: [Vec<f64>; N_PARTS + 1],
    /// Values at a time that is tried.
    tried: Vec<f64>,
    place: State,
}

impl StepSamples {
    /// Of `n` functions; `like`: any state of the scene.
    pub(super) fn new(function: EventFunction, n: usize, like: &State) -> Self {
        let zeros = || vec![0.0; n];
        Self {
            function,
            times: [0.0; N_PARTS + 1],
            values: std::array::from_fn(|_| zeros()),
            tried: zeros(),
            place: like.clone(),
        }
    }

    /// Time and value of function `i` at the end of part `k`, at the start of the step for `k = 0`.
    pub(super) fn at(&self, k: usize, i: usize) -> (f64, f64) {
        (self.times[k], self.values[k][i])
    }

    /// Samples the functions over a step.
    pub(super) fn sample<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        let (from, to) = (stepper.now.state.t, stepper.next.state.t);
        for part in 0..=N_PARTS {
            let t = from + (to - from) * part as f64 / N_PARTS as f64;
            let state = match part {
                0 => &stepper.now.state,
                N_PARTS => &stepper.next.state,
                _ => {
                    stepper.inside(t, &mut self.place)?;
                    &self.place
                }
            };
            self.times[part] = state.t;
            self.function.read(&mut stepper.system, state, &mut self.values[part])?;
        }
        Ok(())
    }

    /// Function `i` at `t` within the step.
    pub(super) fn value<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        i: usize,
        t: f64,
    ) -> Result<f64, MotionError> {
        stepper.inside(t, &mut self.place)?;
        self.function.read(&mut stepper.system, &self.place, &mut self.tried)?;
        Ok(self.tried[i])
    }

    /// A time within a part of the step, and the value there, whose sign differs from both ends of the part.
    pub(super) fn double_root<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        i: usize,
        part: usize,
    ) -> Result<Option<(f64, f64)>, MotionError> {
        let side = side_of(self.values[part][i]);
        if side == 0.0 || side != side_of(self.values[part - 1][i]) {
            return Ok(None);
        }
        let place = |k: usize| (self.times[k], side * self.values[k][i]);
        let others: [Option<usize>; 2] = [part.checked_sub(2), (part < N_PARTS).then_some(part + 1)];
        let others = others.map(|k| k.map(place));
        let lowest = double_root(place(part - 1), place(part), others.into_iter().flatten(), |t| {
            self.value(stepper, i, t).map(|value| side * value)
        })?;
        Ok(lowest.map(|t| (t, self.tried[i])))
    }
}
