//! One sample of a run.

use super::{UnknownName, Wanted, column_index};
use crate::model::SceneInfo;

/// The motion at one time: a view into the record.
///
/// Slices are in the order of [`SceneInfo`]; [`Sample::get`] reads a number by its name.
///
/// ```
/// # use ezy_core::prelude::*;
/// model! {
///     pub model Throw {
///         body ball { mass: 1, inertia: 1 }
///         gravity (0, -10);
///         output height: cm = ball.y;
///         start up { ball at (0, 0) velocity (3, 12); }
///         scene flight { start up; until 2 s; }
///     }
/// }
/// let run = Simulation::new(&throw::Flight::default()).outputs().every(0.5).run()?;
/// for sample in run.samples() {
///     println!("{} s: {} cm, {} m/s", sample.t, sample.get("output.height")?, sample.get("ball.vy")?);
/// }
/// assert!((run.last().get("output.height")? - 400.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Sample<'r> {
    /// Names and sizes.
    pub info: &'r SceneInfo,
    /// Its optional parts.
    pub wanted: Wanted,
    /// Time, s.
    pub t: f64,
    /// q, `n_q`.
    pub coordinates: &'r [f64],
    /// v, `n_q`.
    pub velocities: &'r [f64],
    /// a, `n_q`.
    pub accelerations: &'r [f64],
    /// λ, `n_c`; the reaction on the bodies is −Gᵀ λ.
    pub multipliers: &'r [f64],
    /// Inputs that hold from here on, `n_i`; by name: `get("input.torque")`.
    pub inputs: &'r [f64],
    /// First-order states, `n_z`, each in its unit; by name: `get("state.current")`.
    pub states: &'r [f64],
    /// Outputs, `n_o`; empty unless wanted ([`Simulation::outputs`](crate::simulate::Simulation::outputs)). By name: `get("output.speed")`.
    pub outputs: &'r [f64],
    /// Work of each effect since the start, J, `n_e`; empty unless wanted.
    pub work: &'r [f64],
    /// Power of each effect, then that of the forces with a potential, W, `n_e + 1`; empty unless wanted
    /// ([`Simulation::power`](crate::simulate::Simulation::power)). By name: `get("power.pump")`, `get("power.potential")`.
    pub power: &'r [f64],
    /// Energies, J.
    pub energy: EnergyState,
    /// Largest |C| over the position constraints.
    pub position_residual: f64,
    /// Largest residual over all rows at velocity level.
    pub velocity_residual: f64,
}

/// Energies at one time, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EnergyState {
    /// ½ vᵀ M v.
    pub kinetic: f64,
    /// Potential energy; zero where no force has a potential.
    pub potential: f64,
    /// Work of all effects since the start; NaN unless wanted.
    pub work: f64,
    /// `kinetic + potential − work`, less its value at the start: zero but for the error of the method. NaN unless
    /// work is wanted.
    pub balance: f64,
}

/// Numbers of a sample besides those that the scene counts: time, two energies, two residuals.
const N_ALWAYS: usize = 5;

impl EnergyState {
    /// Energies with the works of all effects; `initial`: kinetic and potential energy at the start.
    pub(crate) fn with_work(kinetic: f64, potential: f64, works: &[f64], initial: f64) -> Self {
        let work = works.iter().fold(0.0, |sum, work| sum + work);
        Self { kinetic, potential, work, balance: kinetic + potential - work - initial }
    }

    /// Energies without work.
    pub(crate) const fn without_work(kinetic: f64, potential: f64) -> Self {
        Self { kinetic, potential, work: f64::NAN, balance: f64::NAN }
    }
}

fn n_powers(info: &SceneInfo, wanted: Wanted) -> usize {
    if wanted.power { info.n_effects() + 1 } else { 0 }
}

fn n_outputs(info: &SceneInfo, wanted: Wanted) -> usize {
    if wanted.outputs { info.n_outputs() } else { 0 }
}

impl<'r> Sample<'r> {
    /// Numbers in a sample of this scene.
    pub(super) fn n_numbers(info: &SceneInfo, wanted: Wanted) -> usize {
        let works = if wanted.work { info.n_effects() + 2 } else { 0 };
        let of_motion =
            info.n_coordinates() + 2 * info.n_velocities() + info.n_rows() + info.n_inputs() + info.n_states();
        N_ALWAYS + of_motion + n_outputs(info, wanted) + works + n_powers(info, wanted)
    }

    /// Reads a stored sample.
    pub(super) fn from_numbers(info: &'r SceneInfo, wanted: Wanted, numbers: &'r [f64]) -> Self {
        let (n_q, n_v, n_c) = (info.n_coordinates(), info.n_velocities(), info.n_rows());
        let (coordinates, rest) = numbers[1..].split_at(n_q);
        let (velocities, rest) = rest.split_at(n_v);
        let (accelerations, rest) = rest.split_at(n_v);
        let (multipliers, rest) = rest.split_at(n_c);
        let (inputs, rest) = rest.split_at(info.n_inputs());
        let (states, rest) = rest.split_at(info.n_states());
        let (outputs, rest) = rest.split_at(n_outputs(info, wanted));
        let (work, rest) = rest.split_at(if wanted.work { info.n_effects() } else { 0 });
        let (power, rest) = rest.split_at(n_powers(info, wanted));
        let (energy, rest) = if wanted.work {
            (EnergyState { work: rest[0], kinetic: rest[1], potential: rest[2], balance: rest[3] }, &rest[4..])
        } else {
            (EnergyState::without_work(rest[0], rest[1]), &rest[2..])
        };
        Self {
            info,
            wanted,
            t: numbers[0],
            coordinates,
            velocities,
            accelerations,
            multipliers,
            inputs,
            states,
            outputs,
            work,
            power,
            energy,
            position_residual: rest[0],
            velocity_residual: rest[1],
        }
    }

    /// All numbers in the order of [`columns`](super::columns).
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let EnergyState { kinetic, potential, work, balance } = self.energy;
        let of_work = |x: f64| self.wanted.work.then_some(x);
        std::iter::once(self.t)
            .chain(self.coordinates.iter().copied())
            .chain(self.velocities.iter().copied())
            .chain(self.accelerations.iter().copied())
            .chain(self.multipliers.iter().copied())
            .chain(self.inputs.iter().copied())
            .chain(self.states.iter().copied())
            .chain(self.outputs.iter().copied())
            .chain(self.work.iter().copied())
            .chain(self.power.iter().copied())
            .chain(of_work(work))
            .chain([kinetic, potential])
            .chain(of_work(balance))
            .chain([self.position_residual, self.velocity_residual])
    }

    /// The number in the named column: `t`, `seat.x`, `seat.omega`, `lambda.rear`, `output.speed`, … (all in
    /// [`columns`](super::columns)).
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub fn get(&self, name: &str) -> Result<f64, UnknownName> {
        let i = column_index(self.info, self.wanted, name)?;
        Ok(self.numbers().nth(i).unwrap_or(f64::NAN))
    }
}
