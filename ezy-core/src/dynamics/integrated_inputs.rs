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

impl<P: SceneRef> System<P> {
    /// Lets integrated inputs move from `t` on, with the present values and rates.
    pub(crate) fn begin_inputs(&mut self, t: f64) {
        for (&i, integrated) in self.info.integrated_inputs.iter().zip(&mut self.integrated) {
            let [value, rate, since] = SceneInfo::integrated_places(i);
            self.fixed[since] = t;
            *integrated = [self.fixed[value], self.fixed[rate], t];
        }
    }

    /// The present inputs, and the motion of the integrated ones.
    pub(crate) fn keep_inputs(&self) -> (Vec<f64>, Vec<[f64; 3]>) {
        (self.inputs().to_vec(), self.integrated.clone())
    }

    /// Takes back what [`Self::keep_inputs`] gave.
    pub(crate) fn restore_inputs(&mut self, (inputs, integrated): &(Vec<f64>, Vec<[f64; 3]>)) {
        self.inputs_mut().copy_from_slice(inputs);
        self.integrated.copy_from_slice(integrated);
    }

    /// Moves value and rate of integrated inputs to `t`, with the acceleration that was set. An input that jumped is left as it is.
    pub(crate) fn integrate_inputs(&mut self, t: f64) {
        if self.integrated.is_empty() || self.jump().is_some() {
            return;
        }
        self.factors.forget();
        for (&i, integrated) in self.info.integrated_inputs.iter().zip(&mut self.integrated) {
            *integrated = at(t, &self.fixed, i);
            SceneInfo::integrated_places(i)
                .iter()
                .zip(&*integrated)
                .for_each(|(&place, part)| self.fixed[place] = *part);
        }
    }

    /// The first integrated input whose value, rate or time was set to something else than its motion.
    pub(crate) fn jump(&self) -> Option<Jump> {
        let inputs = self.info.integrated_inputs.iter().zip(&self.integrated);
        let parts = inputs.flat_map(|(&i, integrated)| SceneInfo::integrated_places(i).into_iter().zip(*integrated));
        let mut parts = parts.map(|(index, is)| Jump { index, is, set: self.fixed[index] });
        parts.find(|jump| jump.is != jump.set)
    }

    /// The inputs with value and rate at `t` of those that are integrated; writes `n_i`.
    pub(crate) fn inputs_at(&self, t: f64, out: &mut [f64]) {
        out.copy_from_slice(self.inputs());
        for &i in self.info.integrated_inputs {
            let parts = at(t, &self.fixed, i);
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
