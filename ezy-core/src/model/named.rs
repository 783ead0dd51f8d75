//! Bodies, inputs and outputs of a scene by their names in the model file.

use super::Scene;

/// A scene whose bodies, inputs and outputs are fields of Rust types, so that a wrong name is a compile error.
///
/// `model!` implements it for every scene. The types stand in the module `names` of the model; programs reach them by
/// [`Simulation::control`](crate::simulate::Simulation::control) and [`Stepper::now`](crate::simulate::Stepper::now).
#[diagnostic::on_unimplemented(
    message = "the names of `{Self}` are not known when the program is compiled",
    note = "only scenes of `model!` have names; of a `dyn Scene` and of a scene written by hand use `Simulation::control_by_index`, \
            `Stepper::inputs_mut`, `Stepper::state` and `Stepper::outputs`"
)]
pub trait NamedScene: Scene {
    /// Every body of the model: a [`BodyState`](super::BodyState), or a [`BodyArray`](super::BodyArray).
    type Bodies<'a>;

    /// Every input of the scene: a number in its unit.
    type Inputs: NamedInputs;

    /// Every output of the scene: a number in its unit, a [`Vector`](super::Vector), or an [`OutputArray`](super::OutputArray).
    type Outputs<'a>;

    /// The bodies at coordinates `q` and velocities `v`, `n_q` each.
    fn bodies_by_name<'a>(&self, q: &'a [f64], v: &'a [f64]) -> Self::Bodies<'a>;

    /// The outputs from their `n_o` values.
    fn outputs_by_name<'a>(&self, values: &'a [f64]) -> Self::Outputs<'a>;
}

/// The inputs of a scene as fields.
pub trait NamedInputs {
    /// From their `n_i` values.
    fn read(values: &[f64]) -> Self;

    /// Writes their `n_i` values.
    fn write(&self, values: &mut [f64]);
}

/// The inputs of a scene that declares none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoInputs;

impl NamedInputs for NoInputs {
    fn read(_: &[f64]) -> Self {
        Self
    }

    fn write(&self, _: &mut [f64]) {}
}

/// The outputs of a scene that declares none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoOutputs;
