//! Inputs of a stepper as fields.

use crate::model::NamedInputs;
use std::ops::{Deref, DerefMut};

/// The inputs of a [`Stepper`](crate::simulate::Stepper) by their names: `roller.set().torque = 3.0`. They are those of the stepper once this
/// is dropped.
pub struct InputsGuard<'a, I: NamedInputs> {
    inputs: I,
    values: &'a mut [f64],
}

impl<'a, I: NamedInputs> InputsGuard<'a, I> {
    pub(in crate::simulate) fn new(values: &'a mut [f64]) -> Self {
        Self { inputs: I::read(values), values }
    }
}

impl<I: NamedInputs> Deref for InputsGuard<'_, I> {
    type Target = I;

    fn deref(&self) -> &I {
        &self.inputs
    }
}

impl<I: NamedInputs> DerefMut for InputsGuard<'_, I> {
    fn deref_mut(&mut self) -> &mut I {
        &mut self.inputs
    }
}

impl<I: NamedInputs> Drop for InputsGuard<'_, I> {
    fn drop(&mut self) {
        self.inputs.write(self.values);
    }
}
