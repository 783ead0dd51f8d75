//! The equations of a scene on numbers with derivatives.

use super::Equations;
use crate::scalar::Dual;

/// Quantities by which kernels differentiate at once.
pub(crate) const N_DERIVATIVES: usize = 8;

/// A number with its derivatives by eight quantities.
pub type Derivatives = Dual<N_DERIVATIVES>;

/// What an analysis differentiates of a scene: its kernels on numbers with eight derivatives. Every scene whose [`Equations`] are of any
/// number, or of these, has it.
///
/// Arguments and shapes are those of [`Equations`]. No elimination is among them: what follows from the equations of motion is solved
/// with their derivatives.
pub trait EquationsWithDerivatives: Send + Sync {
    /// [`Equations::constants`].
    fn constants_with_derivatives(&self, parameters: &[Derivatives], c: &mut [Derivatives]);

    /// [`Equations::mass_matrix`].
    fn mass_matrix_with_derivatives(&self, c: &[Derivatives], m: &mut [Derivatives]);

    /// [`Equations::position_constraint`].
    fn position_constraint_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::velocity_constraint`].
    fn velocity_constraint_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::velocity_jacobian`].
    fn velocity_jacobian_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::convective_term`].
    fn convective_term_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::applied_force`].
    fn applied_force_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::state_rates`].
    fn state_rates_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    );

    /// [`Equations::outputs`].
    fn outputs_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    );
}

impl<S: Equations<Derivatives>> EquationsWithDerivatives for S {
    fn constants_with_derivatives(&self, parameters: &[Derivatives], c: &mut [Derivatives]) {
        Equations::constants(self, parameters, c);
    }

    fn mass_matrix_with_derivatives(&self, c: &[Derivatives], m: &mut [Derivatives]) {
        Equations::mass_matrix(self, c, m);
    }

    fn position_constraint_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::position_constraint(self, c, t, q, out);
    }

    fn velocity_constraint_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::velocity_constraint(self, c, t, q, v, out);
    }

    fn velocity_jacobian_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::velocity_jacobian(self, c, t, q, out);
    }

    fn convective_term_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::convective_term(self, c, t, q, v, out);
    }

    fn applied_force_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::applied_force(self, c, t, q, v, out);
    }

    fn state_rates_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::state_rates(self, c, t, q, v, out);
    }

    fn outputs_with_derivatives(
        &self,
        c: &[Derivatives],
        t: Derivatives,
        q: &[Derivatives],
        v: &[Derivatives],
        out: &mut [Derivatives],
    ) {
        Equations::outputs(self, c, t, q, v, out);
    }
}
