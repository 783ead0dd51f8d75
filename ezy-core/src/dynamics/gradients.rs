//! Exact derivatives of the equations of motion and of the outputs, eight columns a call of a kernel.

use super::with_derivatives::Motion;
use super::{System, SystemError};
use crate::model::{Derivatives, Derived as _, EquationsWithDerivatives, N_DERIVATIVES, SceneInfo, SceneRef};
use crate::scalar::Dual;
use std::sync::Arc;

/// What is differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// C, `n_h`.
    PositionRows,
    /// `[C_q q' + C_t; S v + s_t]`, `n_c`.
    VelocityRows,
    /// R of [`JacobianPlaces`](crate::model::JacobianPlaces), the residual of the equations of motion and of the first-order states,
    /// `n_v + n_c + n_z`.
    Motion,
    /// Outputs, `n_o`.
    Outputs,
}

/// By what it is differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// The `n_q` coordinates themselves, those of a quaternion as four independent numbers: along a displacement δ in the axes of the
    /// velocities a change is the product with N(q) δ.
    Positions,
    /// `n_v`.
    Velocities,
    /// First-order states, `n_z`.
    States,
    /// Inputs, `n_i`: with value, rate, acceleration and time of one that a run integrates as four of them.
    Inputs,
    /// Parameters of the scene, in its order.
    Parameters,
}

/// Where a scene is differentiated.
#[derive(Debug, Clone, Copy)]
pub struct OperatingPoint<'a> {
    /// Inputs, first-order states and constants: [`System::fixed`].
    pub fixed: &'a [f64],
    /// Time, s.
    pub t: f64,
    /// Coordinates, `n_q`.
    pub q: &'a [f64],
    /// Velocities, `n_v`; for [`Of::PositionRows`] they may be empty.
    pub v: &'a [f64],
    /// Accelerations, `n_v`; for all but [`Of::Motion`] they may be empty.
    pub accelerations: &'a [f64],
    /// Multipliers, `n_c`; for all but [`Of::Motion`] they may be empty.
    pub multipliers: &'a [f64],
}

/// Derivatives of a scene, with their buffers.
///
/// They are exact but for rounding. Where a law has none at a point, they are those of the side that is taken, as [`Dual`] says,
/// and where the slope is infinite, such as that of a square root at zero, they are not finite.
///
/// ```
/// use ezy_core::dynamics::{By, OperatingPoint, Gradients, Of};
/// use ezy_core::prelude::*;
/// # ezy_core::model! {
/// #     model Cart {
/// #         param k: N/m = 3;
/// #         body cart { mass: 2, inertia: 1 }
/// #         effect held { force at cart(0, 0): (-k*cart.x, 0); }
/// #         start home { cart at (0, 0) angle 0; at rest; }
/// #         scene run { start home; until 2 s; with held; }
/// #     }
/// # }
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let scene = cart::Run::default();
/// let system = System::new(&scene, Backend::Auto)?;
/// let mut gradients = Gradients::new(&system)?;
/// let zeros = [0.0; 3];
/// let at = OperatingPoint { fixed: system.fixed(), t: 0.0, q: &zeros, v: &zeros, accelerations: &zeros, multipliers: &[] };
/// let mut by_q = vec![0.0; gradients.n_entries(Of::Motion, By::Positions)];
/// gradients.write(&at, Of::Motion, By::Positions, &mut by_q);
/// assert_eq!(by_q[0], -3.0); // of the force along x by x
/// # Ok(())
/// # }
/// ```
pub struct Gradients<P: SceneRef> {
    scene: P,
    info: Arc<SceneInfo>,
    /// What the kernels read.
    parameters: Vec<Derivatives>,
    fixed: Vec<Derivatives>,
    q: Vec<Derivatives>,
    v: Vec<Derivatives>,
    /// What they wrote.
    motion: Motion<N_DERIVATIVES>,
    out: Vec<Derivatives>,
}

impl<P: SceneRef> Gradients<P> {
    /// Those of the scene of `system`, with its parameters and its rows as they are switched now.
    ///
    /// # Errors
    /// [`SystemError::WithoutDerivatives`] for a scene whose kernels run on `f64` alone.
    pub fn new(system: &System<P>) -> Result<Self, SystemError> {
        let (scene, info) = (system.scene_ref().clone(), Arc::clone(system.info()));
        if scene.with_derivatives().is_none() {
            return Err(SystemError::WithoutDerivatives { scene: info.name });
        }
        let zeros = |n: usize| vec![Dual::constant(0.0); n];
        let n_out = [Of::PositionRows, Of::VelocityRows, Of::Motion, Of::Outputs].map(|of| n_rows(&info, of));
        Ok(Self {
            parameters: system.active.parameters().iter().copied().map(Dual::constant).collect(),
            fixed: zeros(info.n_fixed()),
            q: zeros(info.n_coordinates()),
            v: zeros(info.n_velocities()),
            motion: Motion::new(&info),
            out: zeros(n_out.into_iter().fold(0, usize::max)),
            scene,
            info,
        })
    }

    /// The parameters of the scene in its order, and behind them which of its rows are switched on.
    pub(crate) fn parameters(&self) -> Vec<f64> {
        self.parameters.iter().map(|number| number.value).collect()
    }

    /// Rows of the matrix of derivatives: the quantities that are differentiated.
    pub fn n_rows(&self, of: Of) -> usize {
        n_rows(&self.info, of)
    }

    /// Columns of the matrix of derivatives: the quantities by which it is differentiated.
    pub fn n_columns(&self, by: By) -> usize {
        match by {
            By::Positions => self.info.n_coordinates(),
            By::Velocities => self.info.n_velocities(),
            By::States => self.info.n_states(),
            By::Inputs => self.info.n_inputs(),
            By::Parameters => self.info.parameters.len(),
        }
    }

    /// Entries of the matrix of derivatives.
    pub fn n_entries(&self, of: Of, by: By) -> usize {
        self.n_rows(of) * self.n_columns(by)
    }

    /// The matrix of derivatives at `at`, each in the unit of `of` over that of `by`, column by column
    /// ([`Gradients::n_rows`] × [`Gradients::n_columns`]).
    ///
    /// R is differentiated at the given accelerations and multipliers, so that `K [δa; δλ] = R_x δx` is how they follow a change of
    /// x = `by`.
    ///
    /// # Cost
    /// For every eight columns, or what remains of them, one call of each kernel that belongs to `of`; no allocation.
    ///
    /// # Panics
    /// When a slice has another length than the scene has.
    pub fn write(&mut self, at: &OperatingPoint<'_>, of: Of, by: By, out: &mut [f64]) {
        assert_eq!(out.len(), self.n_entries(of, by), "entries of the derivatives");
        let n_rows = self.n_rows(of);
        if n_rows == 0 {
            return;
        }
        for (numbers, values) in [(&mut self.fixed, at.fixed), (&mut self.q, at.q)] {
            assert_eq!(numbers.len(), values.len(), "constants and coordinates of the scene");
            numbers.iter_mut().zip(values).for_each(|(number, value)| *number = Dual::constant(*value));
        }
        if of != Of::PositionRows {
            assert_eq!(self.v.len(), at.v.len(), "velocities of the scene");
            self.v.iter_mut().zip(at.v).for_each(|(number, value)| *number = Dual::constant(*value));
        }
        self.parameters.iter_mut().for_each(|number| *number = Dual::constant(number.value));
        for (i, columns) in out.chunks_mut(n_rows * N_DERIVATIVES).enumerate() {
            self.vary(by, i * N_DERIVATIVES);
            self.evaluate(of, by, at.t);
            self.read(at, of, columns);
        }
    }

    /// Lets the eight quantities from `first` on vary, and no other one.
    fn vary(&mut self, by: By, first: usize) {
        let n_inputs = self.info.n_inputs();
        let numbers = match by {
            By::Positions => &mut self.q[..],
            By::Velocities => &mut self.v,
            By::States => &mut self.fixed[n_inputs..][..self.info.n_states()],
            By::Inputs => &mut self.fixed[..n_inputs],
            By::Parameters => &mut self.parameters[..self.info.parameters.len()],
        };
        // those before have varied
        for (i, number) in
            numbers.iter_mut().enumerate().skip(first.saturating_sub(N_DERIVATIVES)).take(2 * N_DERIVATIVES)
        {
            *number = match i.checked_sub(first) {
                Some(direction) => Dual::variable(number.value, direction),
                None => Dual::constant(number.value),
            };
        }
    }

    fn evaluate(&mut self, of: Of, by: By, t: f64) {
        let Self { scene, info, parameters, fixed, q, v, motion, out } = self;
        let scene = kernels(scene);
        let time = Dual::constant(t);
        if by == By::Parameters {
            scene.constants_with_derivatives(parameters, fixed);
        }
        let out = &mut out[..n_rows(info, of)];
        match of {
            Of::PositionRows => scene.position_constraint_with_derivatives(fixed, time, q, out),
            Of::VelocityRows => scene.velocity_constraint_with_derivatives(fixed, time, q, v, out),
            Of::Outputs => scene.outputs_with_derivatives(fixed, time, q, v, out),
            Of::Motion => {
                motion.evaluate(scene, fixed, t, q, v);
                let rates = &mut out[info.n_unknowns()..];
                if !rates.is_empty() {
                    scene.state_rates_with_derivatives(fixed, time, q, v, rates);
                }
            }
        }
    }

    /// The columns of what was evaluated.
    fn read(&self, at: &OperatingPoint<'_>, of: Of, columns: &mut [f64]) {
        let Self { info, motion, out, .. } = self;
        for (direction, column) in columns.chunks_exact_mut(n_rows(info, of)).enumerate() {
            column.iter_mut().zip(out).for_each(|(x, number)| *x = number.derivatives[direction]);
            if of == Of::Motion {
                let column = &mut column[..info.n_unknowns()];
                motion.write(info, direction, at.accelerations, at.multipliers, column);
            }
        }
    }
}

fn n_rows(info: &SceneInfo, of: Of) -> usize {
    match of {
        Of::PositionRows => info.n_position_rows,
        Of::VelocityRows => info.n_rows(),
        Of::Motion => info.n_unknowns() + info.n_states(),
        Of::Outputs => info.n_outputs(),
    }
}

fn kernels<P: SceneRef>(scene: &P) -> &dyn EquationsWithDerivatives {
    scene.with_derivatives().expect("`Gradients::new` has seen them")
}
