//! The motion of one scene at one state: accelerations, reactions, projections, energies, a consistent start.
//! Knows no integration method and no files.

// matrices keep the capital letters of the notation
#![allow(non_snake_case)]

mod acceleration;
mod active_set;
mod any;
mod assembly;
mod assembly_mode;
mod configuration;
mod counters;
mod diagnosis;
mod eight_states;
mod energy;
mod error;
mod euclidean;
mod factors;
mod free_correction;
mod free_values;
mod geometry;
#[cfg(feature = "analysis")]
mod gradients;
mod integrated_inputs;
mod moved;
mod no_derivative;
mod on_rows;
mod projection;
mod rank;
mod remembered;
mod residual;
mod row;
mod sines;
mod singular_position;
mod solved;
mod start;
mod strain;
mod system;
#[cfg(test)]
mod tests;
mod tolerances;
mod with_derivatives;
mod worst;

pub(crate) use any::{Dynamics, InLanes, Projecting, SystemOf};
pub(crate) use configuration::Configuration;
pub(crate) use eight_states::EightStates;
pub use error::{MotionError, StartError, SystemError};
#[cfg(feature = "analysis")]
pub use gradients::{By, Gradients, Of, OperatingPoint};
pub(crate) use integrated_inputs::Jump;
pub use moved::MovedValue;
pub(crate) use on_rows::OnRows;
pub use projection::{Metric, Projection};
pub use rank::RankLoss;
pub(crate) use residual::{Jacobians, ResidualPlaces};
pub(crate) use row::SystemRow;
pub(crate) use solved::Rows;
pub use solved::Solved;
pub use strain::{Strain, StrainSource};
pub use system::System;
pub use system::described_solver;
pub(crate) use system::eliminated_constants;
#[cfg(test)]
pub(crate) use system::system_of;
pub(crate) use with_derivatives::{Kernels, SystemWithDerivatives};
pub use worst::{Projected, Worst};

use crate::archive::Archive;
use crate::model::{Name, SceneInfo};
use crate::scalar::Scalar;

/// The state that is integrated.
#[derive(Debug, Clone, PartialEq)]
pub struct State<T = f64> {
    /// Time, s.
    pub t: f64,
    /// Coordinates, `n_q`.
    pub q: Vec<T>,
    /// Velocities, `n_v`.
    pub v: Vec<T>,
    /// First-order states, `n_z`, each in its unit.
    pub z: Vec<T>,
    /// Work of each effect since the start, J, `n_e`.
    pub work: Vec<T>,
}

impl State {
    /// Everything zero, without first-order states and with as many velocities as coordinates.
    pub fn zero(n_coordinates: usize, n_effects: usize) -> Self {
        Self::zeros([n_coordinates; 2], 0, n_effects)
    }
}

impl<T: Scalar> State<T> {
    /// Everything zero, in numbers `T`, for n_q coordinates and n_v velocities.
    pub(crate) fn zeros(n_q_and_v: [usize; 2], n_states: usize, n_effects: usize) -> Self {
        let zeros = |n: usize| vec![T::from_f64(0.0); n];
        let [q, v] = n_q_and_v.map(zeros);
        Self { t: 0.0, q, v, z: zeros(n_states), work: zeros(n_effects) }
    }

    /// Writes it, or reads another one over it.
    pub(crate) fn remember(&mut self, archive: &mut Archive<T>) {
        let Self { t, q, v, z, work } = self;
        archive.number(t);
        [q, v, z, work].into_iter().for_each(|numbers| archive.scalars(numbers));
    }

    /// Takes the numbers of a state of the same scene, without allocation.
    pub(crate) fn copy_from(&mut self, other: &Self) {
        self.t = other.t;
        self.q.copy_from_slice(&other.q);
        self.v.copy_from_slice(&other.v);
        if !other.z.is_empty() {
            self.z.copy_from_slice(&other.z);
        }
        self.work.copy_from_slice(&other.work);
    }
}

/// Largest magnitude; NaN when there is one.
pub(crate) fn max_abs(x: &[f64]) -> f64 {
    // four at a time become vector instructions; a sum of magnitudes is not a number where one of them is none
    let (chunks, rest) = x.as_chunks::<4>();
    let (mut largest, mut sum) = ([0.0; 4], [0.0; 4]);
    let mut see = |i: usize, x: f64| {
        let x = x.abs();
        largest[i] = if x > largest[i] { x } else { largest[i] };
        sum[i] += x;
    };
    chunks.iter().for_each(|chunk| (0..4).for_each(|i| see(i, chunk[i])));
    rest.iter().enumerate().for_each(|(i, x)| see(i, *x));
    match sum.iter().any(|sum| sum.is_nan()) {
        true => f64::NAN,
        false => largest.into_iter().fold(0.0, f64::max),
    }
}

/// Zero joined with the number of each pair of `x` and `of`, four at a time: they do not wait for each other, and become vector instructions.
#[inline(always)]
fn in_four<A: Copy, B: Copy>(x: &[A], of: &[B], number: impl Fn(A, B) -> f64, join: impl Fn(f64, f64) -> f64) -> f64 {
    let ((x, more_x), (of, more_of)) = (x.as_chunks::<4>(), of.as_chunks::<4>());
    let mut joined = [0.0; 4];
    for (x, of) in x.iter().zip(of) {
        (0..4).for_each(|i| joined[i] = join(joined[i], number(x[i], of[i])));
    }
    let more = more_x.iter().zip(more_of).map(|(x, of)| number(*x, *of));
    joined.into_iter().chain(more).fold(0.0, join)
}

/// Whether coordinates, velocities and the kinetic energy with this diagonal of M are finite.
#[inline]
pub(crate) fn moves_finitely(mass: &[f64], q: &[f64], v: &[f64]) -> bool {
    let energy = in_four(v, mass, |v, m| m * v * v, |sum, x| sum + x);
    (energy + in_four(q, q, |x, _| 0.0 * x, |sum, x| sum + x)).is_finite()
}

/// Name of the first coordinate or velocity that is not finite.
pub(crate) fn not_finite<T: Scalar>(info: &SceneInfo, q: &[T], v: &[T]) -> Option<Name> {
    // all are asked, without a branch at each
    let are_finite = |x: &[T]| x.iter().fold(true, |all, x| all & x.is_finite());
    let first = |x: &[T]| x.iter().position(|x| !x.is_finite());
    match (are_finite(q), are_finite(v)) {
        (true, true) => None,
        (true, false) => first(v).map(|i| info.velocities.item(i).name),
        (false, _) => first(q).map(|i| info.coordinates.item(i).name),
    }
}

/// Name of the first coordinate, velocity or first-order state that is not finite.
pub(crate) fn state_not_finite<T: Scalar>(info: &SceneInfo, at: &State<T>) -> Option<Name> {
    let state = || at.z.iter().position(|z| !z.is_finite()).map(|i| info.states[i].name.into());
    not_finite(info, &at.q, &at.v).or_else(state)
}
