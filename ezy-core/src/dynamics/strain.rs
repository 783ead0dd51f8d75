//! What moves a scene hardest at one state: for messages about runs that cannot be continued.

use super::System;
use super::diagnosis::Diagnosis;
use crate::model::{Equations as _, Name, SceneRef, body_kind};
use std::f64::consts::SQRT_2;
use std::sync::Arc;

/// The coordinate with the largest acceleration at one state and what causes it, both in the metric of the masses.
///
/// Accelerations are the projection of those of the applied forces, `M⁻¹ F`, onto the null space of G, and orthogonal to it those of
/// the convective terms. So where their square is more than twice that of `M⁻¹ F`, more than half of it comes from the speeds, by
/// way of a reaction.
#[derive(Debug, Clone, PartialEq)]
pub struct Strain {
    /// Name of the coordinate.
    pub coordinate: Name,
    /// Its acceleration, m/s² or rad/s².
    pub acceleration: f64,
    /// Unit of the coordinate, m or rad.
    pub unit: &'static str,
    /// What causes it.
    pub source: StrainSource,
}

/// What causes an acceleration.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum StrainSource {
    /// The speeds: the largest reaction in the equation of motion of the coordinate.
    Reaction {
        /// Name of the row.
        row: Name,
        /// The force or torque, N or N·m.
        force: f64,
    },
    /// The largest applied force.
    Applied {
        /// Name of the coordinate that it acts on.
        coordinate: Name,
        /// The force or torque, N or N·m.
        force: f64,
        /// Name of the effect of largest power, if one has any.
        effect: Option<&'static str>,
    },
}

impl std::fmt::Display for Strain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { coordinate, acceleration, unit, source } = self;
        write!(f, "the largest acceleration then is that of {coordinate}, {acceleration:.3e} {unit}/s^2, by ")?;
        match source {
            StrainSource::Reaction { row, force } => write!(f, "the reaction of constraint `{row}`, {force:.3e}"),
            StrainSource::Applied { coordinate, force, effect } => {
                write!(f, "the force on {coordinate}, {force:.3e}")?;
                effect.map_or(Ok(()), |effect| write!(f, "; of the effects `{effect}` has the largest power"))
            }
        }
    }
}

impl<P: SceneRef> Diagnosis<'_, P> {
    /// What moves the scene hardest at a state with accelerations `a` (`n_q`) and multipliers `lambda` (`n_c`); none where
    /// nothing with a mass is accelerated by a finite amount.
    ///
    /// # Cost
    /// One evaluation of forces and Jacobian, and allocations.
    pub(crate) fn strain(&mut self, t: f64, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64]) -> Option<Strain> {
        let mut applied = vec![0.0; a.len()];
        self.system.scene.applied_force(&self.system.fixed, t, q, v, &mut applied);
        let root = |i: usize| self.system.mass[i].sqrt();
        let accelerations = || (0..a.len()).map(|i| root(i) * a[i].abs());
        let forces = || applied.iter().enumerate().map(|(i, force)| force.abs() / root(i));
        let (i, _) = largest(accelerations())?;
        let info = Arc::clone(&self.system.info);
        let moved = body_kind::coordinates_moved(&info.kinds, a.len());
        let coordinate = |i: usize| info.coordinates.item(moved[i]).name;
        let source = match largest(forces()) {
            Some((j, _)) if SQRT_2 * norm(forces()) >= norm(accelerations()) => {
                let effect = self.busiest_effect(t, q, v, lambda);
                StrainSource::Applied { coordinate: coordinate(j), force: applied[j], effect }
            }
            _ => self.largest_reaction(t, q, i, lambda)?,
        };
        let unit = if self.system.geometry.turns[i] { "rad" } else { "m" };
        Some(Strain { coordinate: coordinate(i), acceleration: a[i], unit, source })
    }

    /// On coordinate `i`; none without rows.
    fn largest_reaction(&mut self, t: f64, q: &[f64], i: usize, lambda: &[f64]) -> Option<StrainSource> {
        let System { scene, info, fixed, factors, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        let entries = info.jacobian.entries().filter(|(_, _, column)| *column == i);
        let reactions = entries.map(|(k, row, _)| (row, -jacobian[k] * lambda[row]));
        let (row, force) = reactions.max_by(|(_, x), (_, y)| x.abs().total_cmp(&y.abs()))?;
        Some(StrainSource::Reaction { row: self.system.info.rows.item(row).name, force })
    }

    fn busiest_effect(&self, t: f64, q: &[f64], v: &[f64], lambda: &[f64]) -> Option<&'static str> {
        let mut power = vec![0.0; self.system.info.n_effects()];
        self.system.power(t, q, v, lambda, &mut power);
        largest(power.iter().map(|power| power.abs())).map(|(i, _)| self.system.info.effects[i].name)
    }
}

/// Of the finite numbers.
fn norm(x: impl Iterator<Item = f64>) -> f64 {
    x.filter(|x| x.is_finite()).fold(0.0, f64::hypot)
}

/// The largest positive and finite number, with its index.
fn largest(x: impl Iterator<Item = f64>) -> Option<(usize, f64)> {
    x.enumerate().filter(|(_, x)| x.is_finite() && *x > 0.0).max_by(|(_, x), (_, y)| x.total_cmp(y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_largest_of_the_finite_and_positive() {
        assert_eq!(largest([1.0, f64::INFINITY, 3.0, 2.0, f64::NAN].into_iter()), Some((2, 3.0)));
        assert_eq!(largest([0.0, -1.0].into_iter()), None);
        assert_eq!(norm([3.0, f64::INFINITY, -4.0, f64::NAN].into_iter()), 5.0);
    }
}
