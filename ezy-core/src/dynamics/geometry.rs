//! How large a mechanism is, so that a watch and a crane are held to the same digits.

use super::tolerances::geometry::{LARGEST_VALUE, ROUNDING_OF_ROWS, TOLERANCE};
use crate::model::coordinate::is_angle;
use crate::model::{SceneInfo, Start};

/// Lengths that say what is small, read once off the slopes of the rows at the scene's start.
pub(super) struct Geometry {
    /// Length that goes with an angle of one radian, m: the longest lever of a row.
    pub length: f64,
    /// Change of each row, `n_c`, when bodies move by that length and turn by a radian.
    pub sizes: Vec<f64>,
    /// Lever of each angle, m; 1 for lengths.
    pub units: Vec<f64>,
}

impl Geometry {
    /// From the entries of G at the coordinates of a start; those that are not finite there say nothing.
    pub(super) fn new(info: &SceneInfo, jacobian: &[f64], start: &Start) -> Self {
        let n_q = info.n_coordinates();
        let entries = || info.jacobian.entries().map(|(k, row, column)| (jacobian[k].abs(), row, column));
        let mut longest = vec![0.0_f64; info.n_rows()];
        for (g, row, _) in entries().filter(|(g, _, column)| g.is_finite() && !is_angle(*column)) {
            longest[row] = longest[row].max(g);
        }
        let mut levers = vec![0.0_f64; n_q];
        for (g, row, column) in
            entries().filter(|(g, row, column)| is_angle(*column) && longest[*row] > 0.0 && g.is_finite())
        {
            levers[column] = levers[column].max(g / longest[row]);
        }
        let places = start.q.iter().enumerate().filter(|(i, x)| !is_angle(*i) && x.is_finite()).map(|(_, x)| x.abs());
        let length =
            [largest(levers.iter().copied()), largest(places)].into_iter().find(|length| *length > 0.0).unwrap_or(1.0);
        for (i, lever) in levers.iter_mut().enumerate() {
            match is_angle(i) {
                true if *lever == 0.0 => *lever = length,
                true => {}
                false => *lever = 1.0,
            }
        }
        let mut sizes = vec![0.0_f64; info.n_rows()];
        for (g, row, column) in entries().filter(|(g, ..)| g.is_finite()) {
            sizes[row] = sizes[row].max(if is_angle(column) { g } else { g * length });
        }
        sizes.iter_mut().filter(|size| **size == 0.0).for_each(|size| *size = 1.0);
        Self { length, sizes, units: levers }
    }

    /// Largest of coordinates, or of velocities, in units of the length and of radians.
    pub(super) fn extent(&self, x: &[f64]) -> f64 {
        largest(x.iter().enumerate().map(|(i, x)| if is_angle(i) { x.abs() } else { x.abs() / self.length }))
    }

    /// Largest of displacements, or of velocities, as lengths: angles times their levers.
    pub(super) fn length_of(&self, x: &[f64]) -> f64 {
        largest(x.iter().zip(&self.units).map(|(x, unit)| (x * unit).abs()))
    }

    /// Largest residual of a position constraint, in units of what counts as zero at `q`; NaN when there is one.
    pub(super) fn position_excess(&self, residual: &[f64], q: &[f64]) -> f64 {
        let extent = self.extent(q);
        let rows = residual.iter().enumerate();
        worst(rows.map(|(row, c)| c.abs() / self.position_tolerance(row, extent)))
    }

    /// Largest residual of a row of velocities, in units of what counts as zero where velocities have this extent.
    pub(super) fn velocity_excess(&self, residual: &[f64], extent: f64) -> f64 {
        let rows = residual.iter().enumerate().filter(|(_, r)| **r != 0.0);
        worst(rows.map(|(row, r)| r.abs() / self.velocity_tolerance(row, extent)))
    }

    /// Largest residual in units of the sizes of the rows; NaN when there is one.
    pub(super) fn share(&self, residual: &[f64]) -> f64 {
        worst(residual.iter().zip(&self.sizes).map(|(r, size)| r.abs() / size))
    }

    /// |C| of a row that counts as zero where coordinates have this extent.
    pub(super) fn position_tolerance(&self, row: usize, extent: f64) -> f64 {
        let size = self.sizes[row];
        (TOLERANCE * size.min(1.0)).max(ROUNDING_OF_ROWS * extent.min(LARGEST_VALUE) * size)
    }

    /// Residual of a row of velocities that counts as zero where velocities have this extent.
    pub(super) fn velocity_tolerance(&self, row: usize, extent: f64) -> f64 {
        let size = self.sizes[row] * extent;
        (TOLERANCE * size.min(1.0)).max(ROUNDING_OF_ROWS * size)
    }

    /// Whether position constraints are met without regard to rounding.
    pub(super) fn is_met(&self, residual: &[f64]) -> bool {
        residual.iter().zip(&self.sizes).all(|(c, size)| c.abs() <= TOLERANCE * size.min(1.0))
    }

    /// The smallest entry of M as a share of the largest, inertias by the mass that their lever feels.
    pub(super) fn lightness(&self, mass: &[f64]) -> f64 {
        let felt = || mass.iter().zip(&self.units).map(|(m, lever)| m / lever / lever);
        let heaviest = largest(felt());
        if heaviest > 0.0 { felt().fold(heaviest, f64::min) / heaviest } else { 0.0 }
    }
}

/// |C| that counts as zero where the largest coordinate is `size`, of rows whose sizes are not known.
pub(super) fn tolerance_at(size: f64) -> f64 {
    TOLERANCE.max(ROUNDING_OF_ROWS * size.min(LARGEST_VALUE))
}

fn worst(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, |worst: f64, x| if x > worst || x.is_nan() { x } else { worst })
}

/// Largest number, whatever is NaN.
fn largest(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, f64::max)
}
