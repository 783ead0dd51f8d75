//! The equations of a scene, in any number.

use super::{Pivots, Series};
use crate::scalar::{DoubleDouble, Scalar};

/// The kernels of a scene on numbers `T`.
///
/// `c` holds the present inputs, then the present first-order states, then what [`Equations::constants`] wrote; `t` is the time in s, `q` and `v` are the `n_q`
/// coordinates and velocities.
pub trait Equations<T: Scalar>: Send + Sync {
    /// Everything that depends on parameters alone, from their values in the order of
    /// [`SceneInfo::parameters`](super::SceneInfo::parameters), behind which [`SceneInfo::switches`](super::SceneInfo::switches) stand. Writes `n_constants` numbers behind inputs and first-order states in
    /// `c`, which it neither reads nor changes.
    fn constants(&self, parameters: &[T], c: &mut [T]);

    /// Diagonal of M (kg, kg·m²). Writes `n_q`.
    fn mass_matrix(&self, c: &[T], m: &mut [T]);

    /// C(q, t). Writes `n_h`.
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]);

    /// All rows at velocity level: C_q v + C_t, then S v + s_t. Writes `n_c`.
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]);

    /// Entries of G = [C_q; S] in the order of [`SceneInfo::jacobian`](super::SceneInfo::jacobian).
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]);

    /// [h; s], so that G a = −[h; s]. Writes `n_c`.
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]);

    /// F. Writes `n_q`.
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]);

    /// Whether kernels take sines and cosines of the angles of all bodies, [sin φ, cos φ] of one after the other, so that those of a configuration
    /// are computed once: in scenes with counts. Kernels of other scenes call one sine an angle by themselves.
    fn takes_sines(&self) -> bool {
        false
    }

    /// As [`Equations::position_constraint`], with sine and cosine of the angle of each body where [`Equations::takes_sines`].
    fn position_constraint_with_sines(&self, c: &[T], t: T, q: &[T], sines: &[[T; 2]], out: &mut [T]) {
        let _ = sines;
        self.position_constraint(c, t, q, out);
    }

    /// As [`Equations::velocity_constraint`], with sine and cosine of the angle of each body where [`Equations::takes_sines`].
    fn velocity_constraint_with_sines(&self, c: &[T], t: T, q: &[T], v: &[T], sines: &[[T; 2]], out: &mut [T]) {
        let _ = sines;
        self.velocity_constraint(c, t, q, v, out);
    }

    /// As [`Equations::velocity_jacobian`], with sine and cosine of the angle of each body where [`Equations::takes_sines`].
    fn velocity_jacobian_with_sines(&self, c: &[T], t: T, q: &[T], sines: &[[T; 2]], out: &mut [T]) {
        let _ = sines;
        self.velocity_jacobian(c, t, q, out);
    }

    /// As [`Equations::convective_term`], with sine and cosine of the angle of each body where [`Equations::takes_sines`].
    fn convective_term_with_sines(&self, c: &[T], t: T, q: &[T], v: &[T], sines: &[[T; 2]], out: &mut [T]) {
        let _ = sines;
        self.convective_term(c, t, q, v, out);
    }

    /// As [`Equations::applied_force`], with sine and cosine of the angle of each body where [`Equations::takes_sines`].
    fn applied_force_with_sines(&self, c: &[T], t: T, q: &[T], v: &[T], sines: &[[T; 2]], out: &mut [T]) {
        let _ = sines;
        self.applied_force(c, t, q, v, out);
    }

    /// Rates of the first-order states, in their units over s. Writes `n_z`; nothing in a scene without any.
    fn state_rates(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let _ = (c, t, q, v, out);
    }

    /// Outputs, each in its unit. Writes `n_o`; nothing in a scene without any.
    fn outputs(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let _ = (c, t, q, v, out);
    }

    /// Values of [`SceneInfo::events`](super::SceneInfo::events), which pass zero where the event takes place. Writes `n_s`; nothing in a
    /// scene without any.
    fn events(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        let _ = (c, t, q, v, out);
    }

    /// Generated straight-line solution of `[M Gᵀ; G 0] [a; λ] = [F; −[h; s]]`; needs M > 0.
    /// Writes `n_q` accelerations and `n_c` multipliers, meaningless when a pivot vanished. A scene without
    /// elimination ([`SceneInfo::has_elimination`](super::SceneInfo::has_elimination)) writes nothing and marks every row.
    fn accelerations(&self, c: &[T], t: T, q: &[T], v: &[T], a: &mut [T], lambda: &mut [T]) -> Pivots {
        let _ = (c, t, q, v, a, lambda);
        Pivots::ALL_VANISHED
    }

    /// Generated mass-weighted correction: the `delta` of smallest `deltaᵀ M delta` with `G(q, t) delta = −residual`.
    /// Reads `n_c` residuals, writes `n_q`; needs M > 0, meaningless when a pivot vanished. A scene without
    /// elimination writes nothing and marks every row.
    fn correction(&self, c: &[T], t: T, q: &[T], residual: &[T], delta: &mut [T]) -> Pivots {
        let _ = (c, t, q, residual, delta);
        Pivots::ALL_VANISHED
    }
}

/// Powers of a scene with a generated elimination, on numbers `T`.
pub trait Powers<T: Scalar>: Send + Sync {
    /// [`Scene::power`](super::Scene::power), which calls it.
    fn powers(&self, c: &[T], t: T, q: &[T], v: &[T], lambda: &[T], out: &mut [T]);
}

/// Declares [`PreciseScene`], whose methods are those of [`Equations`] by the same names.
macro_rules! precise_scene {
    ($($name:ident($($read:ident: $kind:ty),*; $written:ident) $(-> $result:ty)?;)*) => {
        /// A scene in numbers of twice the length of `f64`, as one trait object: its Taylor series, and of [`Equations`] what a motion of such numbers
        /// and its checks ask for, since each kernel is compiled for each scene.
        pub trait PreciseScene: Series<DoubleDouble> {
            $(#[doc = concat!("[`Equations::", stringify!($name), "`].")]
            fn $name(&self, $($read: $kind,)* $written: &mut [DoubleDouble]) $(-> $result)?;)*
        }

        impl<S: Equations<DoubleDouble> + Series<DoubleDouble>> PreciseScene for S {
            $(fn $name(&self, $($read: $kind,)* $written: &mut [DoubleDouble]) $(-> $result)? {
                Equations::$name(self, $($read,)* $written)
            })*
        }
    };
}
precise_scene!(
    constants(parameters: &[DoubleDouble]; c);
    mass_matrix(c: &[DoubleDouble]; m);
    position_constraint(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble]; out);
    velocity_constraint(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble], v: &[DoubleDouble]; out);
    velocity_jacobian(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble]; out);
    convective_term(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble], v: &[DoubleDouble]; out);
    applied_force(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble], v: &[DoubleDouble]; out);
    correction(c: &[DoubleDouble], t: DoubleDouble, q: &[DoubleDouble], residual: &[DoubleDouble]; delta) -> Pivots;
);
