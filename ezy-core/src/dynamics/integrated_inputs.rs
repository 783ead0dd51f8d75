//! Inputs `by acceleration`: value s and rate ṡ at a time t₀, and the acceleration s̈ from there on. Kernels read these four numbers and
//! compute s + ṡ τ + s̈ τ²/2 with τ = t − t₀, so that the constraints have a rate and an acceleration.

use super::System;
use crate::model::{SceneInfo, SceneRef};

/// An input that a run integrates was set beside its motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jump {
    /// Index of the input.
    pub index: usize,
    /// Where its motion is.
    pub is: f64,
    /// What was set.
    pub set: f64,
}

/// The inputs of a system that a run integrates.
pub(crate) struct IntegratedInputs<'s, P: SceneRef> {
    system: &'s mut System<P>,
}

/// The inputs as they were set, and the motion of the integrated ones.
pub(crate) struct KeptInputs {
    inputs: Vec<f64>,
    motion: Vec<[f64; 3]>,
}

impl<P: SceneRef> System<P> {
    /// The inputs that a run integrates.
    #[inline]
    pub(crate) fn integrated_inputs(&mut self) -> IntegratedInputs<'_, P> {
        IntegratedInputs { system: self }
    }
}

impl<P: SceneRef> IntegratedInputs<'_, P> {
    /// Lets them move from `t` on, with the present values and rates.
    pub(crate) fn begin(&mut self, t: f64) {
        let System { info, fixed, integrated, .. } = &mut *self.system;
        for (&i, integrated) in info.integrated_inputs.iter().zip(integrated) {
            let [value, rate, since] = SceneInfo::integrated_places(i);
            fixed[since] = t;
            *integrated = [fixed[value], fixed[rate], t];
        }
    }

    /// All present inputs, and the motion of these.
    pub(crate) fn keep(&self) -> KeptInputs {
        KeptInputs { inputs: self.system.inputs().to_vec(), motion: self.system.integrated.clone() }
    }

    /// Takes back what [`Self::keep`] gave.
    pub(crate) fn restore(&mut self, KeptInputs { inputs, motion }: &KeptInputs) {
        self.system.inputs_mut().copy_from_slice(inputs);
        self.system.integrated.copy_from_slice(motion);
    }

    /// Moves value and rate to `t`, with the acceleration that was set. An input that jumped is left as it is.
    pub(crate) fn integrate(&mut self, t: f64) {
        if self.system.integrated.is_empty() || self.jump().is_some() {
            return;
        }
        let System { info, fixed, integrated, factors, .. } = &mut *self.system;
        factors.forget();
        for (&i, integrated) in info.integrated_inputs.iter().zip(integrated) {
            *integrated = at(t, fixed, i);
            SceneInfo::integrated_places(i).iter().zip(&*integrated).for_each(|(&place, part)| fixed[place] = *part);
        }
    }

    /// The first one whose value, rate or time was set to something else than its motion.
    pub(crate) fn jump(&self) -> Option<Jump> {
        let System { info, fixed, integrated, .. } = &*self.system;
        let inputs = info.integrated_inputs.iter().zip(integrated);
        let parts = inputs.flat_map(|(&i, integrated)| SceneInfo::integrated_places(i).into_iter().zip(*integrated));
        let mut parts = parts.map(|(index, is)| Jump { index, is, set: fixed[index] });
        parts.find(|jump| jump.is != jump.set)
    }

    /// All inputs, with value and rate of these at `t`; writes `n_i`.
    pub(crate) fn write_at(&self, t: f64, out: &mut [f64]) {
        out.copy_from_slice(self.system.inputs());
        for &i in self.system.info.integrated_inputs {
            let parts = at(t, &self.system.fixed, i);
            SceneInfo::integrated_places(i).iter().zip(parts).for_each(|(&place, part)| out[place] = part);
        }
    }
}

/// Value and rate at `t` of the input at place `i`, and `t`.
fn at(t: f64, inputs: &[f64], i: usize) -> [f64; 3] {
    let [value, rate, acceleration, since] = std::array::from_fn(|part| inputs[i + part]);
    let elapsed = t - since;
    let gained = acceleration * elapsed;
    [value + (rate + 0.5 * gained) * elapsed, rate + gained, t]
}
