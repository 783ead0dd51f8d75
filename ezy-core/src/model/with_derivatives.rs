//! The equations of a scene on numbers with derivatives.

use super::Equations;
use crate::scalar::Dual;

/// Quantities by which kernels differentiate at once.
pub(crate) const N_DERIVATIVES: usize = 8;

/// A number with its derivatives by eight quantities.
pub type Derivatives = Dual<N_DERIVATIVES>;

/// Writes a trait whose methods are those of [`Equations`] on these numbers, and what implements it.
macro_rules! with_derivatives {
    ($($name:ident as $of:ident($($argument:ident: $type:ty),*);)*) => {
        /// What an analysis differentiates of a scene: its kernels on numbers with eight derivatives. Every scene whose [`Equations`] are
        /// of any number, or of these, has it.
        ///
        /// Arguments and shapes are those of [`Equations`]. No elimination is among them: what follows from the equations of motion is solved
        /// with their derivatives.
        pub trait EquationsWithDerivatives: Send + Sync {
            $(
                #[doc = concat!("[`Equations::", stringify!($of), "`].")]
                fn $name(&self, $($argument: $type),*);
            )*
        }

        impl<S: Equations<Derivatives>> EquationsWithDerivatives for S {
            $(
                fn $name(&self, $($argument: $type),*) {
                    Equations::$of(self, $($argument),*);
                }
            )*
        }
    };
}

with_derivatives! {
    constants_with_derivatives as constants(parameters: &[Derivatives], c: &mut [Derivatives]);
    mass_matrix_with_derivatives as mass_matrix(c: &[Derivatives], m: &mut [Derivatives]);
    position_constraint_with_derivatives as position_constraint(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], out: &mut [Derivatives]
    );
    velocity_constraint_with_derivatives as velocity_constraint(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], v: &[Derivatives], out: &mut [Derivatives]
    );
    velocity_jacobian_with_derivatives as velocity_jacobian(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], out: &mut [Derivatives]
    );
    convective_term_with_derivatives as convective_term(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], v: &[Derivatives], out: &mut [Derivatives]
    );
    applied_force_with_derivatives as applied_force(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], v: &[Derivatives], out: &mut [Derivatives]
    );
    state_rates_with_derivatives as state_rates(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], v: &[Derivatives], out: &mut [Derivatives]
    );
    outputs_with_derivatives as outputs(
        c: &[Derivatives], t: Derivatives, q: &[Derivatives], v: &[Derivatives], out: &mut [Derivatives]
    );
}
