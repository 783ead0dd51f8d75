//! The starts that a stepper goes back to.

use crate::dynamics::{State, System};
use crate::model::{SceneRef, Start};
use crate::simulate::SetupError;
use crate::simulate::inputs::given::give;

/// The start of a simulation and the last other one, both assembled: to go back to them is a copy.
pub(in crate::simulate) struct Starts {
    /// Inputs of the simulation.
    inputs: Vec<f64>,
    /// Start of the simulation.
    home: Assembled,
    /// The last other one.
    other: Assembled,
    /// The next other one.
    wished: Start,
}

/// A state and what it was assembled from.
#[derive(Clone)]
struct Assembled {
    from: Start,
    state: State,
}

impl Starts {
    /// Those of a simulation with these inputs, whose start `from` was assembled to `state`.
    pub(in crate::simulate) fn new(inputs: &[f64], from: Start, state: State) -> Self {
        let home = Assembled { from: from.clone(), state };
        Self { inputs: inputs.to_vec(), other: home.clone(), home, wished: from }
    }

    /// The start of the simulation.
    pub(in crate::simulate) fn home(&self) -> &State {
        &self.home.state
    }

    /// The start of the simulation with these values, by name; the system has the inputs of the simulation when it was assembled now.
    ///
    /// # Errors
    /// [`SetupError`] when a name is not known or the rows cannot be met.
    pub(in crate::simulate) fn with<P: SceneRef>(
        &mut self,
        given: &[(&str, f64)],
        system: &mut System<P>,
    ) -> Result<&State, SetupError> {
        self.wished.copy_from(&self.home.from);
        for (name, value) in given {
            give(system.info(), &mut self.wished, name, *value)?;
        }
        if self.wished != self.other.from {
            // constraints may follow inputs: those of the start
            let present = system.integrated_inputs().keep();
            self.set_inputs(self.wished.t, system);
            match system.consistent_start(&self.wished) {
                Ok(state) => self.other.state = state,
                Err(error) => {
                    system.integrated_inputs().restore(&present);
                    return Err(error.into());
                }
            }
            self.other.from.copy_from(&self.wished);
        }
        Ok(&self.other.state)
    }

    /// Sets the inputs of the simulation, from which it begins at `t`.
    pub(in crate::simulate) fn set_inputs<P: SceneRef>(&self, t: f64, system: &mut System<P>) {
        system.inputs_mut().copy_from_slice(&self.inputs);
        system.integrated_inputs().begin(t);
    }
}
