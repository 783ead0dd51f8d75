//! The energy balance over a run.

use crate::dynamics::{State, System};
use crate::model::SceneRef;
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
    pub(super) fn new<P: SceneRef>(system: &System<P>, start: &State) -> Self {
        let initial_kinetic = system.kinetic_energy(&start.v);
        let initial_potential = system.potential_energy(start.t, &start.q);
        let largest = EnergyError { joules: 0.0, relative: 0.0, t: start.t };
        Self { initial_kinetic, initial_potential, turned_over: 0.0, largest }
    }

    /// The balance at a state.
    pub(super) fn balance<P: SceneRef>(&mut self, system: &System<P>, state: &State) -> EnergyError {
        let State { t, q, v, work, .. } = state;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A stone of 2 kg that falls.
        pub model Stone {
            body stone { mass: 2, inertia: 1 }
            gravity (0, -10);
            start high { stone at (0, 5) angle 0; at rest; }
            scene falls { start high; until 1 s; }
        }
    }

    fn at(y: f64, vy: f64, work: [f64; 2]) -> State {
        State { t: 0.25, q: vec![0.0, y, 0.0], v: vec![0.0, vy, 0.0], z: Vec::new(), work: work.to_vec() }
    }

    /// But for rounding of 100 J. From 5 m at 1 m/s: kinetic and potential energy less works less 101 J, over the largest kinetic energy, change of potential and works, all
    /// without signs, so far.
    #[test]
    fn analytic_balance_over_what_was_turned_over() {
        let scene = stone::Falls::default();
        let system = system_of(&scene, Backend::Auto).unwrap();
        let mut watch = EnergyWatch::new(&system, &at(5.0, 1.0, [0.0; 2]));
        // 9 J + 80 J + 3 J − 10 J − 101 J over 9 J + 20 J + 13 J
        let first = watch.balance(&system, &at(4.0, 3.0, [10.0, -3.0]));
        assert_eq!((first.joules, first.t), (-19.0, 0.25));
        assert!((first.relative / (19.0 / 42.0) - 1.0).abs() <= 1e-12, "{first:?}");
        // less is turned over then
        let second = watch.balance(&system, &at(5.0, 2.0, [0.0; 2]));
        assert!(second.joules == 3.0 && (second.relative / (3.0 / 42.0) - 1.0).abs() <= 1e-12, "{second:?}");
        for balance in [first, second, EnergyError { joules: 1.0, ..first }] {
            watch.keep(balance);
        }
        assert_eq!(watch.largest, first);
        // the first of equal ones
        watch.keep(EnergyError { joules: -first.joules, t: 0.5, ..first });
        assert_eq!(watch.largest, first);
        watch.keep(EnergyError { joules: f64::NAN, ..first });
        assert!(watch.largest.joules.is_nan());
    }

    /// At rest at 5 m the balance is rounding of 100 J: up to 16 roundings count as none.
    #[test]
    fn analytic_rounding_of_the_potential_energy_is_no_error() {
        let scene = stone::Falls::default();
        let system = system_of(&scene, Backend::Auto).unwrap();
        for (roundings, counts) in [(10.0, false), (40.0, true)] {
            let mut watch = EnergyWatch::new(&system, &at(5.0, 0.0, [0.0; 2]));
            let now = watch.balance(&system, &at(5.0 * (1.0 + roundings * f64::EPSILON), 0.0, [0.0; 2]));
            assert_eq!(now.relative > 0.0, counts, "{now:?}");
        }
    }

    #[test]
    fn regress_fixed_steps_are_trusted_to_three_digits() {
        let of = |relative: f64| EnergyError { joules: 1.0, relative, t: 0.0 }.may_be_of_fixed_steps();
        assert!(of(0.0) && of(0.99e-3) && !of(1.01e-3) && !of(f64::NAN));
    }
}
