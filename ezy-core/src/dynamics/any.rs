//! A scene in other numbers than `f64`: several trajectories side by side, or one with its derivatives.

use super::geometry::Geometry;
use super::tolerances::projection::{MAX_PASSES, PASSES_TO_ROUNDING};
use super::{MotionError, Rows, System};
use crate::model::body_kind;
use crate::model::{Derived as _, Eight, Equations, EquationsInLanes, Pivots, SceneInfo, SceneRef};
use crate::scalar::Scalar;
use std::sync::Arc;

/// What a method needs of a scene in numbers `T`.
pub(crate) trait Dynamics<T: Scalar> {
    /// Accelerations and multipliers, as [`System::accelerations`].
    ///
    /// # Errors
    /// [`MotionError`] when K is singular.
    fn accelerations(&mut self, t: f64, q: &[T], v: &[T], a: &mut [T], lambda: &mut [T]) -> Result<(), MotionError>;

    /// q' = N(q) v: the velocities themselves where all bodies are planar. Writes `n_q`.
    fn position_rates(&self, q: &[T], v: &[T], out: &mut [T]);

    /// Sets the first-order states (`n_z`) that all that follows is computed with.
    fn place_states(&mut self, z: &[T]);

    /// Rates of the first-order states at a state, `n_z`.
    fn state_rates(&self, t: f64, q: &[T], v: &[T], out: &mut [T]);

    /// Power of each effect, W, as [`System::power`].
    fn power(&self, t: f64, q: &[T], v: &[T], lambda: &[T], out: &mut [T]);

    /// Slopes of coordinates, velocities, first-order states and works at a state (q, v, z). Leaves the multipliers in `lambda`.
    ///
    /// # Errors
    /// Those of [`Dynamics::accelerations`].
    #[inline(always)]
    fn slopes(
        &mut self,
        t: f64,
        [q, v, z]: [&[T]; 3],
        lambda: &mut [T],
        [of_q, of_v, of_z, of_work]: [&mut [T]; 4],
    ) -> Result<(), MotionError> {
        self.place_states(z);
        self.position_rates(q, v, of_q);
        self.accelerations(t, q, v, of_v, lambda)?;
        self.state_rates(t, q, v, of_z);
        self.power(t, q, v, lambda, of_work);
        Ok(())
    }

    /// Takes from `x` (`n_q`) what a projection at `q` would take from an error of positions or velocities; `false` where
    /// that is not known.
    fn project_onto_null_space(&mut self, _t: f64, _q: &[T], _x: &mut [T]) -> bool {
        false
    }
}

/// What a motion in numbers `T` needs besides a method.
pub(crate) trait Projecting<T: Scalar>: Dynamics<T> {
    /// Brings `q` and `v` back onto the rows, in the metric of the masses: positions, then velocities at the projected positions.
    ///
    /// # Errors
    /// As [`System::project`].
    fn project(&mut self, t: f64, q: &mut [T], v: &mut [T]) -> Result<(), MotionError>;
}

impl<P: SceneRef> Dynamics<f64> for System<P> {
    #[inline]
    fn accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        self.at_with(t, q, Rows::Held).accelerations(v, a, lambda).map(|_| ())
    }

    #[inline]
    fn position_rates(&self, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.position_rates(q, v, out);
    }

    #[inline]
    fn place_states(&mut self, z: &[f64]) {
        if !z.is_empty() {
            self.place_states(z);
        }
    }

    #[inline]
    fn state_rates(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.state_rates(t, q, v, out);
    }

    #[inline]
    fn power(&self, t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.power(t, q, v, lambda, out);
    }

    fn project_onto_null_space(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> bool {
        self.at_with(t, q, Rows::Projected).project_onto_null_space(x).is_ok()
    }
}

/// The kernels of a scene that a motion in numbers `T` takes, with its generated elimination.
pub(crate) trait Eliminating<T> {
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]);
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]);
    fn accelerations(&self, c: &[T], t: T, q: &[T], v: &[T], a: &mut [T], lambda: &mut [T]) -> Pivots;
    fn correction(&self, c: &[T], t: T, q: &[T], residual: &[T], delta: &mut [T]) -> Pivots;
    fn state_rates(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]);
}

impl<T: Scalar, S: Equations<T> + ?Sized> Eliminating<T> for &S {
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        Equations::position_constraint(*self, c, t, q, out);
    }

    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        Equations::velocity_constraint(*self, c, t, q, v, out);
    }

    fn accelerations(&self, c: &[T], t: T, q: &[T], v: &[T], a: &mut [T], lambda: &mut [T]) -> Pivots {
        Equations::accelerations(*self, c, t, q, v, a, lambda)
    }

    fn correction(&self, c: &[T], t: T, q: &[T], residual: &[T], delta: &mut [T]) -> Pivots {
        Equations::correction(*self, c, t, q, residual, delta)
    }

    fn state_rates(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        Equations::state_rates(*self, c, t, q, v, out);
    }
}

/// A scene that knows its kernels in lanes, and whose type need not be known.
pub(crate) struct InLanes<P>(pub P);

impl<P: SceneRef> InLanes<P> {
    fn kernels(&self) -> &dyn EquationsInLanes {
        self.0.in_lanes().expect("who makes this has asked")
    }
}

impl<P: SceneRef> Eliminating<Eight> for InLanes<P> {
    fn position_constraint(&self, c: &[Eight], t: Eight, q: &[Eight], out: &mut [Eight]) {
        self.kernels().position_constraint_in_lanes(c, &t, q, out);
    }

    fn velocity_constraint(&self, c: &[Eight], t: Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]) {
        self.kernels().velocity_constraint_in_lanes(c, &t, q, v, out);
    }

    fn accelerations(
        &self,
        c: &[Eight],
        t: Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots {
        self.kernels().accelerations_in_lanes(c, &t, q, v, a, lambda)
    }

    fn correction(&self, c: &[Eight], t: Eight, q: &[Eight], residual: &[Eight], delta: &mut [Eight]) -> Pivots {
        self.kernels().correction_in_lanes(c, &t, q, residual, delta)
    }

    fn state_rates(&self, c: &[Eight], t: Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]) {
        self.kernels().state_rates_in_lanes(c, &t, q, v, out);
    }
}

/// A scene in numbers `T`, solved by its generated elimination; it integrates no works.
pub(crate) struct SystemOf<K, T> {
    kernels: K,
    info: Arc<SceneInfo>,
    /// Inputs, first-order states, then constants.
    pub fixed: Vec<T>,
    /// What a time of the scene is ahead of that of the motion, s.
    pub ahead_s: T,
    /// The smallest pivot so far.
    pub smallest_pivot: f64,
    geometry: Geometry,
    residual: Vec<T>,
    delta: Vec<T>,
}

impl<K: Eliminating<T>, T: Scalar> SystemOf<K, T> {
    /// With `fixed` as what the kernels read as `c`: inputs, then constants; sizes of rows are those of `system`.
    pub(crate) fn new<P: SceneRef>(kernels: K, system: &System<P>, fixed: Vec<T>) -> Self {
        let zeros = |n: usize| vec![T::from_f64(0.0); n];
        let (info, geometry) = (Arc::clone(&system.info), system.geometry.clone());
        let (residual, delta) = (zeros(info.n_rows()), zeros(info.n_velocities()));
        let ahead_s = T::from_f64(0.0);
        Self { kernels, info, fixed, ahead_s, smallest_pivot: f64::INFINITY, geometry, residual, delta }
    }

    fn time(&self, t: f64) -> T {
        T::from_f64(t) + self.ahead_s
    }

    /// Correction for the residual in the buffer, into the buffer.
    fn correct(&mut self, t: f64, q: &[T]) -> Result<(), MotionError> {
        let time = self.time(t);
        let pivots = self.kernels.correction(&self.fixed, time, q, &self.residual, &mut self.delta);
        check_pivots(&self.info, pivots, t)
    }
}

impl<K: Eliminating<T>, T: Scalar> Dynamics<T> for SystemOf<K, T> {
    #[inline]
    fn accelerations(&mut self, t: f64, q: &[T], v: &[T], a: &mut [T], lambda: &mut [T]) -> Result<(), MotionError> {
        let pivots = self.kernels.accelerations(&self.fixed, self.time(t), q, v, a, lambda);
        self.smallest_pivot = self.smallest_pivot.min(pivots.smallest());
        check_pivots(&self.info, pivots, t)
    }

    fn position_rates(&self, q: &[T], v: &[T], out: &mut [T]) {
        body_kind::position_rates(&self.info.kinds, q, v, out);
    }

    fn place_states(&mut self, z: &[T]) {
        let n_inputs = self.info.n_inputs();
        self.fixed[n_inputs..][..z.len()].copy_from_slice(z);
    }

    fn state_rates(&self, t: f64, q: &[T], v: &[T], out: &mut [T]) {
        if !out.is_empty() {
            self.kernels.state_rates(&self.fixed, self.time(t), q, v, out);
        }
    }

    fn power(&self, _t: f64, _q: &[T], _v: &[T], _lambda: &[T], _out: &mut [T]) {}
}

impl<K: Eliminating<T>, T: Scalar> Projecting<T> for SystemOf<K, T> {
    /// Derivatives follow the rows, too.
    fn project(&mut self, t: f64, q: &mut [T], v: &mut [T]) -> Result<(), MotionError> {
        let n_h = self.info.n_position_rows;
        body_kind::normalize(&self.info.kinds, q);
        let mut passes = 0;
        loop {
            let time = self.time(t);
            self.kernels.position_constraint(&self.fixed, time, q, &mut self.residual[..n_h]);
            let (rows, extent) = (&self.residual[..n_h], largest(q));
            let tolerance = |row| self.geometry.position_tolerance(row, extent);
            // one lane far away does not spare the others their passes
            let is_rounded = passes >= PASSES_TO_ROUNDING && (0..n_h).all(|row| rows[row].extent() <= tolerance(row));
            if is_rounded || self.geometry.is_met_by(rows.iter().map(|row| row.extent())) {
                break;
            }
            let residual = largest(rows);
            if !residual.is_finite() {
                return Err(MotionError::NotFinite { t, quantity: "a position constraint".into() });
            }
            if passes == MAX_PASSES {
                let worst = rows.iter().position(|c| c.extent() == residual).unwrap_or(0);
                let (row, tolerance) = (self.info.rows.item(worst).name, tolerance(worst));
                return Err(MotionError::ProjectionStalled { t, residual, row, passes, tolerance });
            }
            self.residual[n_h..].fill(T::from_f64(0.0));
            self.correct(t, q)?;
            body_kind::retract(&self.info.kinds, q, &self.delta);
            passes += 1;
        }
        let time = self.time(t);
        self.kernels.velocity_constraint(&self.fixed, time, q, v, &mut self.residual);
        self.correct(t, q)?;
        v.iter_mut().zip(&self.delta).for_each(|(v, delta)| *v = *v + *delta);
        Ok(())
    }
}

/// That an elimination kept all pivots.
///
/// # Errors
/// [`MotionError::LostPivot`].
pub(crate) fn check_pivots(info: &SceneInfo, pivots: Pivots, t: f64) -> Result<(), MotionError> {
    let Some(vanished) = pivots.first_vanished() else { return Ok(()) };
    let row = vanished.min(info.n_rows().saturating_sub(1));
    Err(MotionError::LostPivot { t, row: info.rows.item(row).name })
}

/// Largest extent; NaN when there is one.
fn largest<T: Scalar>(x: &[T]) -> f64 {
    x.iter().fold(0.0, |m: f64, x| {
        let extent = x.extent();
        if extent > m || extent.is_nan() { extent } else { m }
    })
}
