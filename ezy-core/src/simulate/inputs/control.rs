//! Tables and control laws that set the inputs of a run.

use super::input_table::InputTable;
use crate::dynamics::{Jump, MotionError, State, System};
use crate::model::SceneRef;

/// Sets inputs at the start of a step from the state and itself.
pub(in crate::simulate) type Law<'s> = Box<dyn FnMut(&State, &mut dyn Controlled) + Send + 's>;

/// What a law acts on: the system, whatever its scene.
pub(in crate::simulate) trait Controlled {
    /// Present inputs, `n_i`.
    fn inputs(&self) -> &[f64];

    /// The inputs, to set them.
    fn inputs_mut(&mut self) -> &mut [f64];

    /// Outputs with the present inputs; writes `n_o`.
    fn outputs(&self, state: &State, out: &mut [f64]);
}

impl<P: SceneRef> Controlled for System<P> {
    fn inputs(&self) -> &[f64] {
        self.inputs()
    }

    fn inputs_mut(&mut self) -> &mut [f64] {
        self.inputs_mut()
    }

    fn outputs(&self, state: &State, out: &mut [f64]) {
        self.outputs(state.t, &state.q, &state.v, out);
    }
}

/// The tables of a run, and its control law, which acts after them.
#[derive(Default)]
pub(in crate::simulate) struct Control<'s> {
    /// Index of the input.
    pub tables: Vec<(usize, InputTable)>,
    pub law: Option<Law<'s>>,
}

impl Control<'_> {
    /// Whether inputs stay constant.
    pub(in crate::simulate) fn is_idle(&self) -> bool {
        self.tables.is_empty() && self.law.is_none()
    }

    /// Sets the inputs for the step of length `h` from `state`, and holds them over the step. A table is read in the
    /// middle of the step: that is its mean where it is straight, and safe from rounding where it jumps between steps.
    ///
    /// # Errors
    /// [`MotionError::InputNotFinite`].
    pub(in crate::simulate) fn act<P: SceneRef>(
        &mut self,
        state: &State,
        h: f64,
        system: &mut System<P>,
    ) -> Result<(), MotionError> {
        system.place_states(&state.z);
        let t = state.t;
        system.integrated_inputs().integrate(t);
        let inputs = system.inputs_mut();
        for (i, table) in &self.tables {
            inputs[*i] = table.at(t + 0.5 * h);
        }
        if let Some(law) = &mut self.law {
            law(state, system);
        }
        check_inputs(t, system)
    }
}

/// An error with the name of the first input that is not finite, or that a run integrates and that jumped.
pub(in crate::simulate) fn check_inputs<P: SceneRef>(t: f64, system: &mut System<P>) -> Result<(), MotionError> {
    let named = system.info().inputs.iter().zip(system.inputs());
    match named.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((input, &value)) => Err(MotionError::InputNotFinite { t, name: input.name, value }),
        None => match system.integrated_inputs().jump() {
            Some(jump) => Err(jumps(t, system, jump)),
            None => Ok(()),
        },
    }
}

#[cold]
fn jumps<P: SceneRef>(t: f64, system: &System<P>, Jump { index, is, set }: Jump) -> MotionError {
    let info = system.info();
    let first = info.integrated_inputs.iter().rev().find(|first| **first <= index).copied().unwrap_or(index);
    let (part, input) = (&info.inputs[index], info.inputs[first].name);
    MotionError::InputJumps { t, name: part.name, input, unit: part.unit, is, set }
}
