//! Event functions over a step.

use super::double_root::double_root;
use super::event_function::EventFunction;
use crate::dynamics::{MotionError, State};
use crate::integrate::side_of;
use crate::model::SceneRef;
use crate::simulate::stepping::stepper_state::StepperState;

/// Samples of event functions at the ends of parts of a step.
pub(super) struct StepSamples {
    function: EventFunction,
    /// Times of the samples.
    times: Vec<f64>,
    /// Values there.
    values: Vec<Vec<f64>>,
    /// Values at a time that is tried.
    tried: Vec<f64>,
    /// A state within the step; none without functions.
    place: State,
}

impl StepSamples {
    /// Of `n` functions.
    pub(super) fn new<P: SceneRef>(function: EventFunction, n: usize, stepper: &StepperState<P>) -> Self {
        let n_places = stepper.n_event_parts() + 1;
        Self {
            function,
            times: vec![0.0; n_places],
            values: vec![vec![0.0; n]; n_places],
            tried: vec![0.0; n],
            place: if n > 0 { stepper.now.state.clone() } else { State::zeros([0; 2], 0, 0) },
        }
    }

    /// Number of parts.
    pub(super) fn n_parts(&self) -> usize {
        self.values.len() - 1
    }

    /// Values at the start of the step, then at the end of each part.
    pub(super) fn values(&self) -> impl DoubleEndedIterator<Item = &[f64]> {
        self.values.iter().map(Vec::as_slice)
    }

    /// Time and value of function `i` at the end of part `k`, at the start of the step for `k = 0`.
    pub(super) fn at(&self, k: usize, i: usize) -> (f64, f64) {
        (self.times[k], self.values[k][i])
    }

    /// Samples the functions over a step.
    pub(super) fn sample<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        let (from, to) = (stepper.now.state.t, stepper.next.state.t);
        let n_parts = self.n_parts();
        for part in 0..=n_parts {
            let t = from + (to - from) * part as f64 / n_parts as f64;
            let state = if part == 0 {
                &stepper.now.state
            } else if part == n_parts {
                &stepper.next.state
            } else {
                stepper.inside(t, &mut self.place)?;
                &self.place
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
        let others: [Option<usize>; 2] = [part.checked_sub(2), (part < self.n_parts()).then_some(part + 1)];
        let others = others.map(|k| k.map(place));
        let lowest = double_root(place(part - 1), place(part), others.into_iter().flatten(), |t| {
            self.value(stepper, i, t).map(|value| side * value)
        })?;
        Ok(lowest.map(|t| (t, self.tried[i])))
    }
}
