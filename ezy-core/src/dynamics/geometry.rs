//! How large a mechanism is, so that a watch and a crane are held to the same digits.

use super::in_four;
use super::tolerances::geometry::{LARGEST_VALUE, ROUNDING_OF_ROWS, TOLERANCE};
use crate::model::{BodyKind, Component, SceneInfo, Start, body_kind};

/// Lengths that say what is small, read once off the slopes of the rows at the scene's start.
#[derive(Clone)]
pub(super) struct Geometry {
    /// Length that goes with an angle of one radian, m: the longest lever of a row.
    pub length: f64,
    /// Change of each row, `n_c`, when bodies move by that length and turn by a radian.
    pub sizes: Vec<f64>,
    /// Lever of each turn, m; 1 for displacements. As many as velocities.
    pub units: Vec<f64>,
    /// Which velocities are those of turns.
    pub turns: Vec<bool>,
    /// Which coordinates are lengths.
    pub lengths: Vec<bool>,
    /// The coordinate that each velocity moves; none where all bodies are planar.
    moved: Vec<usize>,
}

impl Geometry {
    /// From the entries of G at the coordinates of a start; those that are not finite there say nothing.
    pub(super) fn new(info: &SceneInfo, jacobian: &[f64], start: &Start) -> Self {
        let turns: Vec<bool> = info.components(BodyKind::velocities).map(Component::is_angle).collect();
        let lengths: Vec<bool> = info.components(BodyKind::positions).map(Component::is_length).collect();
        debug_assert_eq!([lengths.len(), turns.len()], [info.n_coordinates(), info.n_velocities()]);
        let entries = || info.jacobian.entries().map(|(k, row, column)| (jacobian[k].abs(), row, column));
        let mut longest = vec![0.0_f64; info.n_rows()];
        for (g, row, _) in entries().filter(|(g, _, column)| g.is_finite() && !turns[*column]) {
            longest[row] = longest[row].max(g);
        }
        let mut levers = vec![0.0_f64; turns.len()];
        for (g, row, column) in
            entries().filter(|(g, row, column)| turns[*column] && longest[*row] > 0.0 && g.is_finite())
        {
            levers[column] = levers[column].max(g / longest[row]);
        }
        let places =
            start.q.iter().zip(&lengths).filter(|(x, is_length)| **is_length && x.is_finite()).map(|(x, _)| x.abs());
        let length =
            [largest(levers.iter().copied()), largest(places)].into_iter().find(|length| *length > 0.0).unwrap_or(1.0);
        for (i, lever) in levers.iter_mut().enumerate() {
            match turns[i] {
                true if *lever == 0.0 => *lever = length,
                true => {}
                false => *lever = 1.0,
            }
        }
        let mut sizes = vec![0.0_f64; info.n_rows()];
        for (g, row, column) in entries().filter(|(g, ..)| g.is_finite()) {
            sizes[row] = sizes[row].max(if turns[column] { g } else { g * length });
        }
        sizes.iter_mut().filter(|size| **size == 0.0).for_each(|size| *size = 1.0);
        let moved =
            if info.is_planar() { Vec::new() } else { body_kind::coordinates_moved(&info.kinds, info.n_velocities()) };
        Self { length, sizes, units: levers, turns, lengths, moved }
    }

    /// The coordinate that a velocity moves.
    pub(super) fn coordinate_of(&self, velocity: usize) -> usize {
        self.moved.get(velocity).copied().unwrap_or(velocity)
    }

    /// Largest of coordinates, in units of the length; angles and parts of quaternions as they are.
    pub(super) fn extent(&self, q: &[f64]) -> f64 {
        in_four(q, &self.lengths, |x, is_length| x.abs() / if is_length { self.length } else { 1.0 }, larger)
    }

    /// Largest of velocities, or of displacements, in units of the length and of radians.
    pub(super) fn extent_of_velocities(&self, v: &[f64]) -> f64 {
        in_four(v, &self.turns, |x, turns| x.abs() / if turns { 1.0 } else { self.length }, larger)
    }

    /// Largest of displacements, or of velocities, as lengths: angles times their levers.
    pub(super) fn length_of(&self, x: &[f64]) -> f64 {
        in_four(x, &self.units, |x, unit| (x * unit).abs(), larger)
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
    #[inline]
    pub(super) fn is_met(&self, residual: &[f64]) -> bool {
        self.is_met_by(residual.iter().map(|c| c.abs()))
    }

    /// Whether they are met but for the rounding of the largest coordinates of `q`.
    pub(super) fn is_nearly_met(&self, residual: &[f64], q: &[f64]) -> bool {
        let extent = self.extent(q);
        residual.iter().enumerate().all(|(row, c)| c.abs() <= self.position_tolerance(row, extent))
    }

    /// [`Self::is_met`] by the sizes of the residuals.
    #[inline]
    pub(super) fn is_met_by(&self, residual: impl Iterator<Item = f64>) -> bool {
        residual.zip(&self.sizes).all(|(c, size)| c <= TOLERANCE * size.min(1.0))
    }

    /// The smallest entry of M as a share of the largest, inertias by the mass that their lever feels.
    pub(super) fn lightness(&self, mass: &[f64]) -> f64 {
        let felt = || mass.iter().zip(&self.units).map(|(m, lever)| m / lever / lever);
        let heaviest = largest(felt());
        if heaviest > 0.0 { felt().fold(heaviest, f64::min) / heaviest } else { 0.0 }
    }
}

fn worst(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, |worst: f64, x| if x > worst || x.is_nan() { x } else { worst })
}

/// The larger one, whatever is NaN of the second; one instruction, where `f64::max` asks of both.
fn larger(largest: f64, x: f64) -> f64 {
    if x > largest { x } else { largest }
}

/// Largest number, whatever is NaN.
fn largest(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A rod on a hinge 0.75 m from its centre, a wheel on it, and a block that nothing holds.
        pub model Lever {
            param ratio: m = 3;
            body rod { mass: 1, inertia: 0.2 }
            body block { mass: 1, inertia: 0.2 }
            hinge pivot: ground(0, 0) ~ rod(-0.75, 0);
            constraint rolls: block.x = ratio * rod.phi;
            start level { rod angle 0; block at (0, 5) angle 0; at rest; }
            scene swings { start level; until 1 s; }
        }
    }

    /// Rows of sizes 4, 1/2 and 1 of a mechanism of 2 m, with a lever of 3 m.
    fn geometry() -> Geometry {
        let (turns, lengths) = (vec![false, false, true], vec![true, true, false]);
        let units = vec![1.0, 1.0, 3.0];
        Geometry { length: 2.0, sizes: vec![4.0, 0.5, 1.0], units, turns, lengths, moved: Vec::new() }
    }

    /// Rounding of a product or two.
    const ROUNDING: f64 = 1e-14;

    fn close(x: f64, y: f64) {
        assert!((x - y).abs() <= ROUNDING * y.abs(), "{x:e} {y:e}");
    }

    /// Slopes of the hinge are 1 along x and y, and 0.75 m for a turn; of the second constraint 1 for x, 3 m for a turn. Lengths are measured by the
    /// longest lever, angles by their own; one without rows by the longest.
    #[test]
    fn analytic_lengths_are_levers_of_the_rows() {
        let scene = lever::Swings::default();
        let geometry = system_of(&scene, Backend::Auto).unwrap().geometry;
        close(geometry.length, 3.0);
        assert_eq!(geometry.units, [1.0, 1.0, 3.0, 1.0, 1.0, 3.0]);
        // a row changes by 3 m where a body moves by that; a turn changes the hinge by 0.75 m
        assert_eq!(geometry.sizes, [3.0; 3]);
        let short = lever::Swings { ratio: 0.25 };
        let geometry = system_of(&short, Backend::Auto).unwrap().geometry;
        close(geometry.length, 0.75);
        assert_eq!((geometry.units[2], geometry.units[5]), (0.75, 0.75));
        assert_eq!(geometry.sizes, [0.75; 3]);
    }

    #[test]
    fn analytic_extent_and_length_of_coordinates() {
        let geometry = geometry();
        assert_eq!(
            [[-4.0, 1.0, 1.5], [1.0, -3.0, 1.0], [0.5, 0.5, -7.0]].map(|x| geometry.extent(&x)),
            [2.0, 1.5, 7.0]
        );
        assert_eq!([[-4.0, 1.0, 1.5], [9.0, -3.0, 1.0]].map(|x| geometry.length_of(&x)), [4.5, 9.0]);
    }

    /// 1e-12 of the size of a row, at most 1e-12, or eight roundings of coordinates up to 1e9 times its size.
    #[test]
    fn analytic_residuals_that_count_as_zero() {
        let (geometry, rounding) = (geometry(), 8.0 * f64::EPSILON);
        for (row, extent, expected) in [
            (0, 0.0, 1e-12),
            (1, 0.0, 0.5e-12),
            (0, 1e6, rounding * 1e6 * 4.0),
            (1, 1e6, rounding * 1e6 * 0.5),
            (1, 1e12, rounding * 1e9 * 0.5),
        ] {
            close(geometry.position_tolerance(row, extent), expected);
        }
        for (row, extent, expected) in [
            (1, 1.0, 0.5e-12),
            (1, 0.1, 0.05e-12),
            (0, 10.0, 1e-12),
            (0, 1e6, rounding * 4e6),
            (2, 1e12, rounding * 1e12),
        ] {
            close(geometry.velocity_tolerance(row, extent), expected);
        }
    }

    /// The worst row in units of its tolerance, or of its size.
    #[test]
    fn analytic_residuals_in_units_of_what_counts_as_zero() {
        let geometry = geometry();
        let rest = [0.0; 3];
        close(geometry.position_excess(&[2e-12, -3e-12, 1e-12], &rest), 6.0);
        close(geometry.position_excess(&[-8e-12, 3e-12, 1e-12], &rest), 8.0);
        close(geometry.velocity_excess(&[2e-12, -3e-12, 1e-12], 1.0), 6.0);
        assert_eq!(geometry.velocity_excess(&[0.0; 3], 0.0), 0.0, "what rests and leaves nothing");
        assert_eq!(geometry.velocity_excess(&[0.0, 1e-300, 0.0], 0.0), f64::INFINITY);
        close(geometry.share(&[2.0, -3.0, 1.0]), 6.0);
        assert!(
            geometry.share(&[2.0, f64::NAN, 1.0]).is_nan()
                && geometry.position_excess(&[f64::NAN, 0.0, 0.0], &rest).is_nan()
        );
        for (residual, is_met) in [
            ([1e-12, 0.5e-12, -1e-12], true),
            ([1.1e-12, 0.0, 0.0], false),
            ([0.0, -0.6e-12, 0.0], false),
            ([0.0, 0.0, f64::NAN], false),
        ] {
            assert_eq!(geometry.is_met(&residual), is_met, "{residual:?}");
            assert_eq!(geometry.is_nearly_met(&residual, &[1e6, 0.0, 0.0]), residual[2].is_finite(), "{residual:?}");
        }
    }

    /// The inertia of 18 kg m² on a lever of 3 m is felt like 2 kg.
    #[test]
    fn analytic_lightest_mass_by_what_levers_feel() {
        let lightness = |mass: [f64; 3]| geometry().lightness(&mass);
        close(lightness([4.0, 4.0, 18.0]), 0.5);
        close(lightness([1.0, 4.0, 18.0]), 0.25);
        close(lightness([1.0, 1.0, 90.0]), 0.1);
        assert_eq!((lightness([0.0, 1.0, 9.0]), lightness([0.0; 3])), (0.0, 0.0));
    }
}
