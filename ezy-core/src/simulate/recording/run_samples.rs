//! Which states of a run become samples.

use super::sample_times::{SampleTimes, Sampling};
use super::sampler::Sampler;
use crate::model::SceneRef;
use crate::record::{RecordError, Recorder};
use crate::simulate::StopReason;
use crate::simulate::stepping::snapshot::Snapshot;
use crate::simulate::stepping::stepper_state::StepperState;
use crate::simulate::tolerances::samples::ON_STEP;
use std::sync::Arc;

/// The samples of a run, in the steps in which they are due.
pub(in crate::simulate) struct RunSamples<'s> {
    pub sampler: Sampler<'s>,
    times: SampleTimes,
    /// Start of the run, s.
    start_s: f64,
    /// Samples so far, whether or not they are still in the record.
    n_kept: usize,
    /// Whether the record keeps the first and the last sample only.
    streamed: bool,
    /// A state within a step; made when it is first needed.
    within: Option<Box<Snapshot>>,
}

impl<'s> RunSamples<'s> {
    /// Of a run that starts where the stepper is.
    pub(in crate::simulate) fn new<P: SceneRef>(
        stepper: &StepperState<P>,
        sampling: Sampling,
        recorder: Option<&'s mut dyn Recorder>,
    ) -> Self {
        let Sampling { times, wanted, streamed } = sampling;
        let info = stepper.system.info();
        Self {
            sampler: Sampler::new(Arc::clone(info), wanted, recorder),
            times,
            start_s: stepper.now.state.t,
            n_kept: 0,
            streamed,
            within: None,
        }
    }

    /// Whether a sample falls into the step from `now` to `next`, not on its end.
    pub(in crate::simulate) fn is_due_within<P: SceneRef>(&self, stepper: &StepperState<P>) -> bool {
        self.next_time() <= stepper.next.state.t && !self.is_due_at_end(stepper)
    }

    /// Whether the next sample is the end of the step from `now` to `next`.
    pub(in crate::simulate) fn is_due_at_end<P: SceneRef>(&self, stepper: &StepperState<P>) -> bool {
        let (now, next) = (stepper.now.state.t, stepper.next.state.t);
        (self.next_time() - next).abs() <= ON_STEP * (next - now)
    }

    /// Time of the next sample; infinite when only start and end are kept.
    fn next_time(&self) -> f64 {
        self.times.next(self.start_s, self.n_kept)
    }

    /// Room for a state within a step.
    pub(in crate::simulate) fn within(&mut self) -> &mut Snapshot {
        let Sampler { info, wanted, .. } = &self.sampler;
        self.within.get_or_insert_with(|| Box::new(Snapshot::zero(info, wanted.work)))
    }

    /// Keeps what falls between `now` and `next` and before `end`, both evaluated with the inputs of this step.
    pub(in crate::simulate) fn keep_within<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        end: f64,
    ) -> Result<(), StopReason> {
        while self.is_due_within(stepper) && self.next_time() < end {
            let time = self.next_time();
            stepper.between(time, self.within())?;
            self.count();
            let Self { sampler, within, .. } = self;
            within.as_ref().map_or(Ok(()), |within| sampler.keep(&mut stepper.system, within))?;
        }
        Ok(())
    }

    /// Keeps the state `now`.
    pub(in crate::simulate) fn keep_now<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
    ) -> Result<(), RecordError> {
        self.count();
        self.sampler.keep(&mut stepper.system, &stepper.now)
    }

    /// Time of the last sample, s.
    pub(in crate::simulate) fn last_time(&self) -> f64 {
        self.sampler.record.samples().next_back().map_or(f64::NEG_INFINITY, |last| last.t)
    }

    /// Counts the sample that comes, and makes room for it.
    fn count(&mut self) {
        if self.streamed {
            self.sampler.record.keep_first();
        }
        self.n_kept += 1;
    }
}
