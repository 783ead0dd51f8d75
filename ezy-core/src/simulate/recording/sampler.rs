//! Completes samples and keeps them.

use crate::dynamics::{State, System};
use crate::model::{SceneInfo, SceneRef};
use crate::record::{EnergyState, Record, RecordError, Recorder, Sample, Wanted};
use crate::simulate::stepping::snapshot::Snapshot;
use std::sync::Arc;

/// The record of a run and, when there is one, the recorder that a caller gave.
pub(in crate::simulate) struct Sampler<'s> {
    info: Arc<SceneInfo>,
    record: Record,
    recorder: Option<&'s mut dyn Recorder>,
    /// Whether the record keeps the first and the last sample only.
    streamed: bool,
    n_kept: usize,
    /// Kinetic and potential energy of the first sample, J.
    initial_energy: Option<f64>,
    /// Refined accelerations.
    a: Vec<f64>,
    wanted: Wanted,
    /// Empty unless wanted.
    outputs: Vec<f64>,
    /// The constraint that the active mode does not have, and its multiplier as a multiple of the skate's limit.
    pub lacking: Option<(usize, f64)>,
    /// Those of the last sample.
    inputs: Vec<f64>,
    /// Multipliers, with that of this constraint.
    multipliers: Vec<f64>,
}

impl<'s> Sampler<'s> {
    pub(in crate::simulate) fn new(
        info: Arc<SceneInfo>,
        wanted: Wanted,
        recorder: Option<&'s mut dyn Recorder>,
        streamed: bool,
    ) -> Self {
        Self {
            record: Record::new(Arc::clone(&info), wanted),
            recorder,
            streamed,
            n_kept: 0,
            initial_energy: None,
            a: vec![0.0; info.n_velocities()],
            wanted,
            outputs: vec![0.0; if wanted.outputs { info.n_outputs() } else { 0 }],
            lacking: None,
            inputs: vec![0.0; info.n_inputs()],
            multipliers: Vec::new(),
            info,
        }
    }

    /// Samples so far, whether or not they are still in the record.
    pub(in crate::simulate) fn n_kept(&self) -> usize {
        self.n_kept
    }

    /// Time of the last sample, s.
    pub(in crate::simulate) fn last_time(&self) -> f64 {
        self.record.samples().next_back().map_or(f64::NEG_INFINITY, |last| last.t)
    }

    /// Names and sizes of what is kept.
    pub(in crate::simulate) fn info(&self) -> &Arc<SceneInfo> {
        &self.info
    }

    pub(in crate::simulate) fn into_record(self) -> Record {
        self.record
    }

    /// Adds energies, residuals and outputs to an evaluated state and keeps the sample. The system holds the inputs of
    /// this state.
    pub(in crate::simulate) fn keep<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        at: &Snapshot,
    ) -> Result<(), RecordError> {
        let State { t, q, v, z, work: works } = &at.state;
        system.place_states(z);
        let (kinetic, potential) = (system.kinetic_energy(v), system.potential_energy(*t, q));
        let initial = *self.initial_energy.get_or_insert(kinetic + potential);
        let energy = if self.wanted.work {
            let work = works.iter().fold(0.0, |sum, work| sum + work);
            EnergyState { kinetic, potential, work, balance: kinetic + potential - work - initial }
        } else {
            EnergyState::without_work(kinetic, potential)
        };
        if self.wanted.outputs {
            system.outputs(*t, q, v, &mut self.outputs);
        }
        self.a.copy_from_slice(&at.a);
        // for the sample only: recording must not change the motion. The matrix was regular before; if the correction fails all
        // the same, the accelerations are good without it
        let _ = system.refine_accelerations(*t, q, v, &mut self.a);
        let (position_residual, velocity_residual) =
            (system.position_residual(*t, q), system.velocity_residual(*t, q, v));
        let multipliers = match self.lacking {
            None => &at.lambda,
            Some((row, multiple)) => {
                let [limit, _] = system.stick_slip(*t, q, v);
                self.multipliers.clone_from(&at.lambda);
                self.multipliers.insert(row, multiple * limit);
                &self.multipliers
            }
        };
        system.inputs_at(*t, &mut self.inputs);
        let sample = Sample {
            info: &self.info,
            wanted: self.wanted,
            t: *t,
            coordinates: q,
            velocities: v,
            accelerations: &self.a,
            multipliers,
            inputs: &self.inputs,
            states: z,
            outputs: &self.outputs,
            work: works,
            energy,
            position_residual,
            velocity_residual,
        };
        if self.streamed {
            self.record.keep_first();
        }
        self.record.push(&sample);
        self.n_kept += 1;
        self.recorder.as_mut().map_or(Ok(()), |recorder| recorder.record(&sample))
    }
}
