//! One sample of a run.

use super::{UnknownName, columns, find_name};
use crate::model::SceneInfo;

/// The motion at one time: a view into the record.
#[derive(Debug, Clone, Copy)]
pub struct Sample<'r> {
    /// Names and sizes.
    pub info: &'static SceneInfo,
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
    /// Work of each effect since the start, J, `n_e`.
    pub work: &'r [f64],
    /// Energies, J.
    pub energy: EnergyState,
    /// Largest |C| over the position rows.
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
    /// Work of all effects since the start.
    pub work: f64,
    /// `kinetic + potential − work`, less its value at the start: zero but for the error of the method.
    pub balance: f64,
}

/// Numbers of a sample besides those that the scene counts: time, four energies, two residuals.
const N_FIXED: usize = 7;

impl<'r> Sample<'r> {
    /// Numbers in a sample of this scene.
    pub(super) fn n_numbers(info: &SceneInfo) -> usize {
        N_FIXED + 3 * info.n_coordinates() + info.n_rows() + info.n_effects()
    }

    /// Reads a stored sample.
    pub(super) fn from_numbers(info: &'static SceneInfo, numbers: &'r [f64]) -> Self {
        let (n_q, n_c, n_e) = (info.n_coordinates(), info.n_rows(), info.n_effects());
        let (coordinates, rest) = numbers[1..].split_at(n_q);
        let (velocities, rest) = rest.split_at(n_q);
        let (accelerations, rest) = rest.split_at(n_q);
        let (multipliers, rest) = rest.split_at(n_c);
        let (work, rest) = rest.split_at(n_e);
        Self {
            info,
            t: numbers[0],
            coordinates,
            velocities,
            accelerations,
            multipliers,
            work,
            energy: EnergyState { work: rest[0], kinetic: rest[1], potential: rest[2], balance: rest[3] },
            position_residual: rest[4],
            velocity_residual: rest[5],
        }
    }

    /// All numbers in the order of [`columns`].
    pub fn numbers(&self) -> impl Iterator<Item = f64> + '_ {
        let e = self.energy;
        std::iter::once(self.t)
            .chain(self.coordinates.iter().copied())
            .chain(self.velocities.iter().copied())
            .chain(self.accelerations.iter().copied())
            .chain(self.multipliers.iter().copied())
            .chain(self.work.iter().copied())
            .chain([e.work, e.kinetic, e.potential, e.balance, self.position_residual, self.velocity_residual])
    }

    /// The number in the named column: `t`, `seat.x`, `seat.omega`, `lambda.rear`, `work`, … (all in [`columns`]).
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub fn get(&self, name: &str) -> Result<f64, UnknownName> {
        let all = columns(self.info);
        let i = find_name("column", name, all.iter().map(|c| c.name.as_str()))?;
        Ok(self.numbers().nth(i).unwrap_or(f64::NAN))
    }
}
