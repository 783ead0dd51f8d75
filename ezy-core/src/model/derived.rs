//! What `model!` derives besides the equations.

#[cfg(feature = "analysis")]
use super::EquationsWithDerivatives;
use super::{
    ElementInfo, Equations, EquationsInLanes, EquationsInQuasiVelocities, ForceElement, List, Pivots, PreciseScene,
    Series,
};
#[cfg(feature = "export")]
use crate::scalar::Recorded;

/// What a scene may know besides its equations of motion; `model!` derives it.
///
/// Each method has a default that says "not known", so that a scene written by hand may leave the block empty. What it then
/// does without: Radau needs the Jacobians and Taylor's method the series; events, stops, sliding skates and counts are none.
pub trait Derived: Equations<f64> {
    /// Value of count `index` of [`SceneInfo::counts`](super::SceneInfo::counts); zero past the last.
    fn count(&self, index: usize) -> usize {
        let _ = index;
        0
    }

    /// Changes count `index`, and with it the description and all constants.
    fn set_count(&mut self, index: usize, value: usize) {
        let _ = (index, value);
    }

    /// What the end of a step needs, with one elimination for all of it: [`Equations::velocity_constraint`] at `v`, the velocities
    /// after [`Equations::correction`], and [`Equations::accelerations`] at these. Writes them one behind the other:
    /// `n_c` residuals, `n_q` velocities, `n_q` accelerations, `n_c` multipliers.
    ///
    /// A run in `f64` alone asks for it: in other numbers it is not compiled.
    fn projected_accelerations(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) -> Pivots {
        let (residual, out) = out.split_at_mut(out.len() / 2 - v.len());
        let (projected, out) = out.split_at_mut(v.len());
        let (a, lambda) = out.split_at_mut(v.len());
        self.velocity_constraint(c, t, q, v, residual);
        // the pivots are those of the accelerations
        let _ = self.correction(c, t, q, residual, projected);
        projected.iter_mut().zip(v).for_each(|(delta, v)| *delta += v);
        self.accelerations(c, t, q, projected, a, lambda)
    }

    /// Row and column of each entry of the Jacobians of the equations of motion; `None` for a scene without them. Scenes that
    /// `model!` generates have them.
    fn jacobian_places(&self) -> Option<JacobianPlaces> {
        None
    }

    /// R_q and R_v in the order of [`Derived::jacobian_places`], for accelerations `a` (`n_q`) and multipliers `lambda` (`n_c`).
    /// At a discontinuity of a law a derivative is the mean of those on both sides.
    #[expect(clippy::too_many_arguments, reason = "the variables of R and its two derivatives")]
    fn jacobians(
        &self,
        c: &[f64],
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        lambda: &[f64],
        by_q: &mut [f64],
        by_v: &mut [f64],
    ) {
        let _ = (c, t, q, v, a, lambda, by_q, by_v);
    }

    /// Row and column of each entry of R_z, how the residual of [`JacobianPlaces`] depends on the first-order states z: `(n_q + n_c + n_z) × n_z`.
    fn state_jacobian_places(&self) -> Vec<(usize, usize)> {
        Vec::new()
    }

    /// R_z in the order of [`Derived::state_jacobian_places`], at the states in `c`. At a discontinuity as [`Derived::jacobians`].
    fn state_jacobians(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let _ = (c, t, q, v, out);
    }

    /// What each skate of [`SceneInfo::limited_skates`](super::SceneInfo::limited_skates) holds up to, N, and the velocity across it, to the left of
    /// its direction, m/s. Writes 2 for each.
    fn limited_skates(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let _ = (c, t, q, v, out);
    }

    /// For each end of the stop of [`SceneInfo::stop`](super::SceneInfo::stop) the distance to it, negative beyond, and its rate;
    /// last the restitution. Writes `2 n_ends + 1`.
    fn stop(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let _ = (c, t, q, v, out);
    }

    /// What a picture of the scene shows: its points, constraints and forces, in declared order. A scene written by hand shows its
    /// bodies and named points.
    fn elements(&self) -> List<ElementInfo> {
        List::Borrowed(&[])
    }

    /// Numbers of [`Derived::elements`], one element after the other: points and directions in the axes of their bodies, m, then the
    /// load, N or N m. Writes [`ElementInfo::n_values`] of each.
    fn element_values(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let _ = (c, t, q, v, out);
    }

    /// What gives power to the mechanism and takes it: its forces in declared order, then its skates with a limit. All members that a force
    /// has in a `for` over a count are one. A scene written by hand does not tell.
    fn force_elements(&self) -> &'static [ForceElement] {
        &[]
    }

    /// Power Q · v, W, that each of [`Derived::force_elements`] gives to the mechanism, in a `for` over a count that of all members; −∂V/∂q · v of one
    /// with a potential. All of them, and the constraints that move with time, add up to vᵀ M a. Writes one number for each.
    fn element_powers(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let _ = (c, t, q, v, out);
    }

    /// Its kernels at eight states at once, where it has a generated elimination.
    fn in_lanes(&self) -> Option<&dyn EquationsInLanes> {
        None
    }

    /// The equations of motion in quasi-velocities, where `model!` derived them.
    fn in_quasi_velocities(&self) -> Option<&dyn EquationsInQuasiVelocities> {
        None
    }

    /// Its kernels on numbers with eight derivatives (feature `analysis`). Scenes that `model!` generates have them, those with counts too. One
    /// written by hand for any [`Scalar`](crate::scalar::Scalar) returns `Some(self)`.
    #[cfg(feature = "analysis")]
    fn with_derivatives(&self) -> Option<&dyn EquationsWithDerivatives> {
        None
    }

    /// Its kernels on numbers that record what is computed (feature `export`). Scenes that `model!` generates have them; one written by hand for
    /// any [`Scalar`](crate::scalar::Scalar) returns `Some(self)`.
    #[cfg(feature = "export")]
    fn recorded(&self) -> Option<&dyn Equations<Recorded>> {
        None
    }

    /// The recurrences of its Taylor series; none when a law of the scene is not analytic.
    fn series(&self) -> Option<&dyn Series<f64>> {
        None
    }

    /// The scene in double-double arithmetic, when it has a Taylor series.
    fn precise(&self) -> Option<&dyn PreciseScene> {
        None
    }
}

/// Row and column of each entry that [`Derived::jacobians`] writes, in its order. Entries at one place add
/// up.
///
/// The equations of motion as one residual of `n_q + n_c` rows that vanishes along the motion, with `n_z` rows more for the rates r of
/// first-order states z:
///
/// ```text
/// R(q, v, z, a, λ, z', t) = [F − M a − Gᵀ λ; −(G a + [h; s]); r − z']
/// ```
///
/// so that `K [δa; δλ] = R_q δq + R_v δv + R_z δz` says how accelerations and multipliers follow changes of the state.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct JacobianPlaces {
    /// (row, column) of each entry of R_q = ∂R/∂q, `(n_q + n_c + n_z) × n_q`.
    pub by_q: Vec<(usize, usize)>,
    /// The same of R_v = ∂R/∂v.
    pub by_v: Vec<(usize, usize)>,
}
