//! The energy balance over a run.

use crate::dynamics::{State, System};
use crate::model::Scene;
use crate::simulate::tolerances::monitors::{LARGEST_ENERGY_ERROR, ROUNDING};

/// The largest energy balance of a run: kinetic and potential energy less work, less the value at the start. Zero but for
/// the error of the method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyError {
    /// The balance, J.
    pub joules: f64,
    /// Its magnitude, as far as it is not rounding of its terms, over the energy turned over until then: the largest sum so
    /// far of kinetic energy, change of potential energy and works of all effects, each without its sign.
    pub relative: f64,
    /// Its time, s.
    pub t: f64,
}

impl EnergyError {
    /// Largest `relative` of a run with fixed steps whose result is trusted: the least that a result is good for, three digits.
    pub const LARGEST_OF_FIXED_STEPS: f64 = LARGEST_ENERGY_ERROR;

    /// Whether a run with fixed steps is to be trusted; not where the balance is no number.
    pub(in crate::simulate) fn may_be_of_fixed_steps(&self) -> bool {
        self.relative <= Self::LARGEST_OF_FIXED_STEPS
    }
}

/// The balance step by step.
pub(super) struct EnergyWatch {
    initial_kinetic: f64,
    initial_potential: f64,
    turned_over: f64,
    pub largest: EnergyError,
}

impl EnergyWatch {
    pub(super) fn new<S: Scene + ?Sized>(system: &System<'_, S>, start: &State) -> Self {
        let initial_kinetic = system.kinetic_energy(&start.v);
        let initial_potential = system.potential_energy(start.t, &start.q);
        let largest = EnergyError { joules: 0.0, relative: 0.0, t: start.t };
        Self { initial_kinetic, initial_potential, turned_over: 0.0, largest }
    }

    /// The balance at a state.
    pub(super) fn balance<S: Scene + ?Sized>(&mut self, system: &System<'_, S>, state: &State) -> EnergyError {
        let State { t, q, v, work } = state;
        let (kinetic, potential) = (system.kinetic_energy(v), system.potential_energy(*t, q));
        let (mut done, mut turned_over) = (0.0, kinetic + (potential - self.initial_potential).abs());
        for work in work {
            done += work;
            turned_over += work.abs();
        }
        self.turned_over = self.turned_over.max(turned_over);
        let joules = kinetic + potential - done - (self.initial_kinetic + self.initial_potential);
        // where nothing moves yet, the balance is rounding of a potential energy that may be large
        let excess = joules.abs() - ROUNDING * (kinetic + potential.abs() + turned_over);
        let relative = if excess <= 0.0 { 0.0 } else { excess / self.turned_over };
        EnergyError { joules, relative, t: *t }
    }

    /// Keeps a balance when it is the largest.
    pub(super) fn keep(&mut self, now: EnergyError) {
        if now.joules.is_nan() || now.joules.abs() > self.largest.joules.abs() {
            self.largest = now;
        }
    }
}
