//! Differences of two motions.

use super::trajectory::{Row, Trajectory};

/// A difference, absolute and relative to the size of its quantity.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Size {
    /// Largest magnitude of a component, in its unit: metres and radians side by side.
    pub absolute: f64,
    /// Largest magnitude of a component over its [`Scales`].
    pub scaled: f64,
}

/// Differences of positions, velocities and reactions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// m, rad
    pub position: Size,
    /// m/s, rad/s
    pub velocity: Size,
    /// Of the multipliers: N, N m.
    pub reaction: Size,
}

/// Differences of two motions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Comparison {
    /// At the end.
    pub end: Errors,
    /// The largest over the grid, end included.
    pub grid: Errors,
}

impl Comparison {
    /// Whether every difference is a number.
    pub(super) fn is_finite(&self) -> bool {
        let of = |errors: &Errors| [errors.position, errors.velocity, errors.reaction];
        of(&self.end).iter().chain(&of(&self.grid)).all(|size| size.absolute.is_finite() && size.scaled.is_finite())
    }
}

/// Sizes for relative differences: the largest magnitude of any component with the same unit, over the whole reference.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scales {
    /// For each coordinate, m or rad.
    pub position: Vec<f64>,
    /// For each velocity, m/s or rad/s.
    pub velocity: Vec<f64>,
    /// For each multiplier, N or N m.
    pub reaction: Vec<f64>,
}

impl Scales {
    /// The scales of a motion.
    pub(super) fn of(motion: &Trajectory) -> Self {
        let info = motion.info();
        let [units, rates] =
            [&info.coordinates, &info.velocities].map(|of| of.iter().map(|c| c.unit).collect::<Vec<_>>());
        let row_units: Vec<&str> = info.rows.iter().map(|row| row.multiplier_unit).collect();
        Self {
            position: largest_of_unit(motion, &units, |row| row.q),
            velocity: largest_of_unit(motion, &rates, |row| row.v),
            reaction: largest_of_unit(motion, &row_units, |row| row.lambda),
        }
    }
}

/// For each component the largest magnitude among those of its unit; 1 where nothing moves.
fn largest_of_unit(motion: &Trajectory, units: &[&str], pick: for<'t> fn(&Row<'t>) -> &'t [f64]) -> Vec<f64> {
    let mut own = vec![0.0; units.len()];
    for i in 0..motion.times().len() {
        own.iter_mut().zip(pick(&motion.row(i))).for_each(|(most, x)| *most = f64::max(*most, x.abs()));
    }
    let of = |unit: &str| units.iter().zip(&own).filter(|(u, _)| **u == unit).fold(0.0, |m, (_, x)| f64::max(m, *x));
    units.iter().map(|unit| of(unit)).map(|most| if most > 0.0 { most } else { 1.0 }).collect()
}

/// Differences of two motions on the same grid; `None` when one of them is shorter.
pub(super) fn compare(one: &Trajectory, other: &Trajectory, scales: &Scales) -> Option<Comparison> {
    let n = one.times().len();
    if n == 0 || other.times().len() != n {
        return None;
    }
    let mut grid = Errors::default();
    for i in 0..n {
        grid = grid.max(difference(one.row(i), other.row(i), scales));
    }
    Some(Comparison { end: difference(one.row(n - 1), other.row(n - 1), scales), grid })
}

/// Differences at one time.
pub(super) fn difference(one: Row<'_>, other: Row<'_>, scales: &Scales) -> Errors {
    Errors {
        position: size(one.q, other.q, &scales.position),
        velocity: size(one.v, other.v, &scales.velocity),
        reaction: size(one.lambda, other.lambda, &scales.reaction),
    }
}

fn size(one: &[f64], other: &[f64], scales: &[f64]) -> Size {
    let differences = one.iter().zip(other).zip(scales);
    differences.fold(Size::default(), |most, ((one, other), scale)| {
        let absolute = (one - other).abs();
        most.max(Size { absolute, scaled: absolute / scale })
    })
}

impl Size {
    fn max(self, other: Self) -> Self {
        Self { absolute: larger(self.absolute, other.absolute), scaled: larger(self.scaled, other.scaled) }
    }
}

impl Errors {
    fn max(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            velocity: self.velocity.max(other.velocity),
            reaction: self.reaction.max(other.reaction),
        }
    }
}

/// The larger one; NaN counts as larger.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_size_is_the_largest_component_and_keeps_what_is_not_a_number() {
        let found = size(&[1.0, 2.0, 5.0], &[1.5, 2.0, 4.0], &[0.5, 1.0, 10.0]);
        assert_eq!(found, Size { absolute: 1.0, scaled: 1.0 });
        let lost = size(&[1.0, f64::NAN, 5.0], &[1.5, 2.0, 4.0], &[1.0; 3]);
        assert!(lost.absolute.is_nan() && lost.scaled.is_nan());
    }
}
