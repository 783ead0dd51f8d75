//! The way to a rest that is far from the start.

use super::scaling::Scaling;
use super::steady_equations::{Evaluated, SteadyEquations, Unknowns};
use super::tolerances::relaxation::{FURTHER, MAX_STEPS, NEAR, SHORTER, STRIDE};
use crate::model::SceneRef;

/// Where a mechanism at rest comes to when everything is resisted as it is inert: M q' = f − Gᵀ λ with C = 0, by implicit Euler steps that grow as it
/// slows down, until they are Newton steps. None where it does not come to rest.
///
/// # Source
/// Pseudo-transient continuation: Kelley, Keyes, SIAM J. Numer. Anal. 35 (1998); of constrained problems: Coffey, Kelley, Keyes, SIAM J. Sci. Comput. 25 (2003).
pub(super) fn relaxed<P: SceneRef>(
    equations: &mut SteadyEquations<'_, P>,
    start: &Unknowns,
    held: &[bool],
) -> Option<Unknowns> {
    let mass = equations.system.mass_matrix().to_vec();
    let mut point = start.clone();
    let mut at = equations.at(&point);
    // 1/τ, 1/s²
    let mut rate = first_rate(&at, &mass, &equations.strides(&point, STRIDE));
    for _ in 0..MAX_STEPS {
        let mut resisted = at.jacobian.clone();
        (0..mass.len()).for_each(|i| resisted[(i, i)] -= rate * mass[i]);
        let scaling = Scaling::of(&resisted, held);
        let (_, step) = scaling.step(&resisted, &scaling.residual(&at))?;
        let reach = equations.reach(&point, &step) / STRIDE;
        if !reach.is_finite() {
            return None;
        }
        if reach <= 1.0 {
            point = equations.moved(&point, &step, 1.0);
            at = equations.at(&point);
            if !at.is_finite() {
                return None;
            }
            if reach <= NEAR {
                return Some(point);
            }
        }
        rate *= (2.0 * reach).clamp(FURTHER, SHORTER);
    }
    None
}

/// The first 1/τ: neither forces nor their slopes move anything by more than a stride.
fn first_rate(at: &Evaluated, mass: &[f64], strides: &[f64]) -> f64 {
    let of = |i: usize| {
        let slope = at.jacobian.row(i).columns(0, mass.len()).amax();
        f64::max(slope, at.residual[i].abs() / strides[i]) / mass[i]
    };
    (0..mass.len()).map(of).filter(|rate| rate.is_finite()).fold(0.0, f64::max)
}
