//! Name, order and needs of a method, and how it is made.

use super::integrator::Integrator;
use super::step_control::Tolerance;
use crate::dynamics::{Dynamics, System, SystemError};
use crate::model::{SceneInfo, SceneRef};
use crate::scalar::Scalar;

/// Name, order and needs of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MethodInfo {
    /// Name on the command line and in reports.
    pub name: &'static str,
    /// What it is, in a line without a stop.
    pub summary: &'static str,
    /// Order of its steps; none where the tolerance decides it.
    pub order: Option<u32>,
    /// Whether it chooses the lengths of its steps by a tolerance.
    pub chooses_steps: bool,
    /// Whether it is for stiff scenes: its steps are limited by accuracy alone.
    pub is_implicit: bool,
    /// What it needs of a scene besides accelerations.
    pub needs: Needs,
    /// Whether it integrates bodies of any kind; others take planar bodies alone, of which q' = v.
    pub takes_any_body: bool,
    /// Whether it integrates first-order states.
    pub takes_states: bool,
    /// Tolerance of a second run that shows the error of a first one, over that of the first.
    pub(crate) tighter: f64,
    /// Below this tolerance a second run is made by another method: a smaller one would leave the errors as they are.
    pub(crate) rounding: f64,
}

/// What a method needs of a scene besides accelerations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Needs {
    /// Nothing.
    Nothing,
    /// The recurrences of its Taylor series.
    Series,
    /// The Jacobians of its equations of motion.
    Jacobians,
}

/// An entry of the table of methods.
///
/// The tolerance is what the method chooses its steps by; one with a fixed step leaves it out.
pub(crate) trait Family {
    /// Name, order and needs of the method.
    const INFO: MethodInfo;

    /// For numbers of any type; none where it needs more than accelerations.
    fn in_any_number<D: Dynamics<T>, T: Scalar>(
        _sizes: Sizes,
        _tolerance: Tolerance,
    ) -> Option<Box<dyn Integrator<D, T>>> {
        None
    }

    /// For a system; none where its scene lacks what the method needs. `is_projected`: whether the ends of steps are projected, positions and velocities in the
    /// metric of the masses.
    ///
    /// # Errors
    /// [`SystemError`] when there is no memory for the analysis of a large scene.
    fn of_system<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        tolerance: Tolerance,
        _is_projected: bool,
    ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
        Ok(Self::in_any_number(Sizes::new(system.info(), n_works), tolerance))
    }
}

/// Numbers of coordinates, velocities, rows, first-order states and works.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sizes {
    pub n_q: usize,
    pub n_v: usize,
    pub n_c: usize,
    pub n_z: usize,
    pub n_works: usize,
}

impl Sizes {
    pub(crate) fn new(info: &SceneInfo, n_works: usize) -> Self {
        Self { n_q: info.n_coordinates(), n_v: info.n_velocities(), n_c: info.n_rows(), n_z: info.n_states(), n_works }
    }
}
