//! Completes states to samples.

use crate::dynamics::{Rows, State, System};
use crate::model::{Derived as _, SceneInfo, SceneRef};
use crate::record::{EnergyState, Record, RecordError, Recorder, Sample, Wanted};
use crate::simulate::stepping::snapshot::Snapshot;
use std::sync::Arc;

/// Completes states to samples and keeps them.
pub(in crate::simulate) struct Sampler<'s> {
    /// Names and sizes of what is kept.
    pub info: Arc<SceneInfo>,
    pub record: Record,
    /// One that the caller gave.
    recorder: Option<&'s mut dyn Recorder>,
    /// Kinetic and potential energy of the first sample, J.
    initial_energy: Option<f64>,
    pub wanted: Wanted,
    /// Empty unless wanted.
    outputs: Vec<f64>,
    /// Empty unless wanted.
    power: Vec<f64>,
    pub sliding: SlidingSkates,
    /// Those of the last sample.
    inputs: Vec<f64>,
}

/// The skates that slide, and what is told of them in place of their multipliers.
#[derive(Default)]
pub(in crate::simulate) struct SlidingSkates {
    pub skates: Vec<Sliding>,
    /// Of [`Derived::limited_skates`](crate::model::Derived::limited_skates).
    limits: Vec<f64>,
    multipliers: Vec<f64>,
}

impl SlidingSkates {
    /// Multipliers with the forces of the skates that slide.
    fn multipliers<'m, P: SceneRef>(&'m mut self, system: &System<P>, at: &'m Snapshot) -> &'m [f64] {
        let Self { skates, limits, multipliers } = self;
        if skates.is_empty() {
            return &at.lambda;
        }
        let (info, State { t, q, v, .. }) = (system.info(), &at.state);
        limits.resize(2 * info.limited_skates.len(), 0.0);
        system.scene().limited_skates(system.fixed(), *t, q, v, limits);
        multipliers.clone_from(&at.lambda);
        for Sliding { skate, side } in skates {
            multipliers[info.limited_skates[*skate].row] = *side * limits[2 * *skate];
        }
        multipliers
    }
}

/// A skate that slides: its multiplier is the limit, on this side.
#[derive(Debug, Clone, Copy)]
pub(in crate::simulate) struct Sliding {
    /// Place in [`SceneInfo::limited_skates`].
    pub skate: usize,
    /// 1 while it slides to the left, -1 to the right.
    pub side: f64,
}

impl<'s> Sampler<'s> {
    pub(in crate::simulate) fn new(
        info: Arc<SceneInfo>,
        wanted: Wanted,
        recorder: Option<&'s mut dyn Recorder>,
    ) -> Self {
        Self {
            record: Record::new(Arc::clone(&info), wanted),
            recorder,
            initial_energy: None,
            wanted,
            outputs: vec![0.0; if wanted.outputs { info.n_outputs() } else { 0 }],
            power: vec![0.0; if wanted.power { info.n_effects() + 1 } else { 0 }],
            sliding: SlidingSkates::default(),
            inputs: vec![0.0; info.n_inputs()],
            info,
        }
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
        let energy = match self.wanted.work {
            true => EnergyState::with_work(kinetic, potential, works, initial),
            false => EnergyState::without_work(kinetic, potential),
        };
        if self.wanted.outputs {
            system.outputs(*t, q, v, &mut self.outputs);
        }
        let (position_residual, velocity_residual) =
            (system.position_residual(*t, q), system.velocity_residual(*t, q, v));
        let multipliers = self.sliding.multipliers(system, at);
        if let Some((of_potential, of_effects)) = self.power.split_last_mut() {
            system.power(*t, q, v, multipliers, of_effects);
            // vᵀ M a is the power of all of them together
            let kinetic = system.mass_matrix().iter().zip(v).zip(&at.a).map(|((m, v), a)| m * v * a).sum::<f64>();
            *of_potential = kinetic - of_effects.iter().sum::<f64>();
        }
        system.integrated_inputs().write_at(*t, &mut self.inputs);
        let sample = Sample {
            info: &self.info,
            wanted: self.wanted,
            t: *t,
            coordinates: q,
            velocities: v,
            // of the sample only: recording must not change the motion
            accelerations: system.at_with(*t, q, Rows::Projected).refined_accelerations(v, &at.a),
            multipliers,
            inputs: &self.inputs,
            states: z,
            outputs: &self.outputs,
            work: works,
            power: &self.power,
            energy,
            position_residual,
            velocity_residual,
        };
        self.record.push(&sample);
        self.recorder.as_mut().map_or(Ok(()), |recorder| recorder.record(&sample))
    }
}
