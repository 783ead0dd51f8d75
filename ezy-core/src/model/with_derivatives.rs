//! The equations of a scene on numbers with derivatives.

use super::Equations;
use crate::scalar::Dual;

/// Quantities by which kernels differentiate at once where nobody says by how many.
pub const N_DERIVATIVES: usize = 8;

/// A number with its derivatives by eight quantities.
#[cfg(feature = "analysis")]
pub type Derivatives = Dual<N_DERIVATIVES>;

/// Writes a trait whose methods are those of [`Equations`] on these numbers, and what implements it.
macro_rules! with_derivatives {
    ($($name:ident as $of:ident($($argument:ident: $type:ty),*);)*) => {
        /// What is differentiated of a scene: its kernels on numbers with `N` derivatives. Every scene whose [`Equations`] are of any number, or
        /// of these, has it.
        ///
        /// Arguments and shapes are those of [`Equations`]. No elimination is among them: what follows from the equations of motion is solved
        /// with their derivatives.
        pub trait EquationsWithDerivatives<const N: usize = N_DERIVATIVES>: Send + Sync {
            $(
                #[doc = concat!("[`Equations::", stringify!($of), "`].")]
                fn $name(&self, $($argument: $type),*);
            )*
        }

        impl<S: Equations<Dual<N>>, const N: usize> EquationsWithDerivatives<N> for S {
            $(
                fn $name(&self, $($argument: $type),*) {
                    Equations::$of(self, $($argument),*);
                }
            )*
        }
    };
}

with_derivatives! {
    constants_with_derivatives as constants(parameters: &[Dual<N>], c: &mut [Dual<N>]);
    mass_matrix_with_derivatives as mass_matrix(c: &[Dual<N>], m: &mut [Dual<N>]);
    position_constraint_with_derivatives as position_constraint(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], out: &mut [Dual<N>]
    );
    velocity_constraint_with_derivatives as velocity_constraint(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]
    );
    velocity_jacobian_with_derivatives as velocity_jacobian(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], out: &mut [Dual<N>]
    );
    convective_term_with_derivatives as convective_term(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]
    );
    applied_force_with_derivatives as applied_force(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]
    );
    state_rates_with_derivatives as state_rates(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]
    );
    outputs_with_derivatives as outputs(
        c: &[Dual<N>], t: Dual<N>, q: &[Dual<N>], v: &[Dual<N>], out: &mut [Dual<N>]
    );
}
