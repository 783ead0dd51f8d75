//! Where the Jacobians of the equations of motion stand.

/// Row and column of each entry that [`Derived::jacobians`](super::Derived::jacobians) writes, in its order. Entries at one place add
/// up.
///
/// The equations of motion as one residual of `n_q + n_c` rows that vanishes along the motion:
///
/// ```text
/// R(q, v, a, λ, t) = [F − M a − Gᵀ λ; −(G a + [h; s])]
/// ```
///
/// so that `K [δa; δλ] = R_q δq + R_v δv` says how accelerations and multipliers follow changes of the state.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct JacobianPlaces {
    /// (row, column) of each entry of R_q = ∂R/∂q, `(n_q + n_c) × n_q`.
    pub by_q: Vec<(usize, usize)>,
    /// The same of R_v = ∂R/∂v.
    pub by_v: Vec<(usize, usize)>,
}
