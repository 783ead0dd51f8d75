//! Values over a rectangular grid of two parameters.

use super::range;

/// Cells that a picture shows along one side at most: each is wider than a point.
const MOST_CELLS: usize = 256;

/// Beyond this size spans and sums are no numbers.
const LARGEST: f64 = 1e300;

fn is_drawable(value: f64) -> bool {
    value.abs() <= LARGEST
}

/// A map as it is drawn.
#[derive(Debug, Clone)]
pub(super) struct Map {
    /// Name and unit of the values.
    pub z_label: String,
    /// Its cells, or why there are none.
    pub grid: Result<Grid, String>,
}

impl Map {
    /// A map of at most [`MOST_CELLS`] by [`MOST_CELLS`] cells.
    pub(super) fn new(z_label: &str, x: Vec<f64>, y: Vec<f64>, z: Vec<f64>) -> Self {
        let grid = Grid::new(x, y, z).map(|grid| grid.coarse(MOST_CELLS));
        Self { z_label: z_label.to_owned(), grid }
    }
}

/// Cells of one side, in ascending order.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Side {
    pub centers: Vec<f64>,
    /// Between the centres and beyond the outer ones: one more than cells.
    pub edges: Vec<f64>,
}

impl Side {
    fn new(name: &str, centers: Vec<f64>) -> Result<Self, String> {
        let (Some(&first), Some(&last)) = (centers.first(), centers.last()) else {
            return Err(format!("{name} has no values"));
        };
        if let Some(k) = centers.iter().position(|center| !is_drawable(*center)) {
            return Err(format!("{name}[{k}] is {}", centers[k]));
        }
        if let Some(k) = centers.windows(2).position(|pair| pair[0] >= pair[1]) {
            return Err(format!("{name} does not increase from {} to {}", centers[k], centers[k + 1]));
        }
        let edges = if let &[center] = &centers[..] {
            range::widened([center, center], 0.0).to_vec()
        } else {
            let between: Vec<f64> = centers.windows(2).map(|pair| 0.5 * pair[0] + 0.5 * pair[1]).collect();
            let (below, above) = (first - (between[0] - first), last + (last - between[between.len() - 1]));
            [below].into_iter().chain(between).chain([above]).collect()
        };
        Ok(Self { centers, edges })
    }

    pub(super) fn len(&self) -> usize {
        self.centers.len()
    }

    /// The outer edges.
    pub(super) fn limits(&self) -> [f64; 2] {
        [self.edges[0], self.edges[self.len()]]
    }

    /// The cell at a part of the way from one outer edge to the other.
    pub(super) fn cell_at(&self, part: f64) -> usize {
        let [low, high] = self.limits();
        let value = low * (1.0 - part) + high * part;
        self.edges.partition_point(|edge| *edge <= value).saturating_sub(1).min(self.len() - 1)
    }

    /// Groups of `n` cells as cells, the last one of what is left.
    fn grouped(&self, n: usize) -> Self {
        let mean = |group: &[f64]| group.iter().map(|center| center / group.len() as f64).sum();
        let inner = self.edges[..self.len()].iter().copied().step_by(n);
        Self {
            centers: self.centers.chunks(n).map(mean).collect(),
            edges: inner.chain([self.edges[self.len()]]).collect(),
        }
    }
}

/// The values of cells.
#[derive(Debug, Clone)]
pub(super) struct Grid {
    pub x: Side,
    pub y: Side,
    /// Row by row in the direction of y; NaN where there is no value.
    z: Vec<f64>,
}

impl Grid {
    fn new(x: Vec<f64>, y: Vec<f64>, z: Vec<f64>) -> Result<Self, String> {
        let (x, y) = (Side::new("x", x)?, Side::new("y", y)?);
        if z.len() != x.len() * y.len() {
            return Err(format!("z has {} values in place of {} × {}", z.len(), x.len(), y.len()));
        }
        let z = z.into_iter().map(|value| if is_drawable(value) { value } else { f64::NAN }).collect();
        Ok(Self { x, y, z })
    }

    /// The value of a cell, NaN if there is none.
    pub(super) fn value(&self, i_x: usize, i_y: usize) -> f64 {
        self.z[i_y * self.x.len() + i_x]
    }

    pub(super) fn has_missing(&self) -> bool {
        self.z.iter().any(|value| value.is_nan())
    }

    /// The least and the largest value; `None` where all are missing.
    pub(super) fn extent(&self) -> Option<[f64; 2]> {
        let mut values = self.z.iter().filter(|value| !value.is_nan());
        let first = *values.next()?;
        Some(values.fold([first; 2], |[low, high], value| [low.min(*value), high.max(*value)]))
    }

    /// The grid with at most `n` cells along each side: means of groups of cells, without those that are missing.
    fn coarse(self, n: usize) -> Self {
        let [across, up] = [&self.x, &self.y].map(|side| side.len().div_ceil(n));
        if across == 1 && up == 1 {
            return self;
        }
        let (x, y) = (self.x.grouped(across), self.y.grouped(up));
        let mut z = Vec::with_capacity(x.len() * y.len());
        for rows in self.z.chunks(up * self.x.len()) {
            for i in 0..x.len() {
                let columns = i * across..((i + 1) * across).min(self.x.len());
                let of_group = rows.chunks(self.x.len()).flat_map(|row| &row[columns.clone()]);
                z.push(mean(of_group.copied().filter(|value| !value.is_nan())));
            }
        }
        Self { x, y, z }
    }
}

/// The mean; NaN of none.
fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (n, sum) = values.fold((0_u32, 0.0), |(n, sum), value| (n + 1, sum + value));
    sum / f64::from(n)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a mean of a hundred thousand values of size one.
    const ROUNDING: f64 = 1e-12;

    fn count(n: usize) -> Vec<f64> {
        (0..n).map(|k| k as f64).collect()
    }

    #[test]
    fn analytic_edges_lie_between_the_centres_and_as_far_beyond_them() {
        let side = Side::new("x", vec![0.0, 2.0, 3.0]).unwrap();
        assert_eq!(side.edges, [-1.0, 1.0, 2.5, 3.5]);
        assert_eq!([0.0, 0.4, 0.5, 0.8, 1.0].map(|part| side.cell_at(part)), [0, 0, 1, 2, 2]);
        let single = Side::new("x", vec![0.0]).unwrap();
        assert_eq!(single.limits(), [-1.0, 1.0]);
    }

    #[test]
    fn invariant_coarse_grid_keeps_the_mean_and_the_limits() {
        let (n_x, n_y) = (600, 400);
        let z: Vec<f64> = (0..n_x * n_y).map(|k| (k as f64 * 0.37).sin() + 0.5).collect();
        let mean_of = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
        let grid = Grid::new(count(n_x), count(n_y), z.clone()).unwrap();
        let coarse = grid.clone().coarse(200);
        assert_eq!((coarse.x.len(), coarse.y.len(), coarse.z.len()), (200, 200, 40_000));
        assert!((mean_of(&coarse.z) - mean_of(&z)).abs() < ROUNDING);
        assert_eq!((coarse.x.limits(), coarse.y.limits()), (grid.x.limits(), grid.y.limits()));
        // the place of a plane stays, too
        assert_eq!(coarse.x.edges[..3], [-0.5, 2.5, 5.5]);
        assert!((coarse.x.centers[1] - 4.0).abs() < ROUNDING);
    }

    #[test]
    fn analytic_group_with_missing_cells_is_the_mean_of_those_that_are_there() {
        let z = vec![1.0, f64::NAN, 7.0, 3.0, 5.0, f64::INFINITY, f64::NAN, f64::NAN, f64::NAN];
        let coarse = Grid::new(count(3), count(3), z).unwrap().coarse(2);
        assert_eq!((coarse.z[0], coarse.z[1]), (3.0, 7.0));
        assert!(coarse.z[2].is_nan() && coarse.z[3].is_nan() && coarse.has_missing());
    }

    #[test]
    fn invariant_faults_of_a_grid_are_named() {
        let fault = |x: &[f64], y: &[f64], n_z: usize| Grid::new(x.to_vec(), y.to_vec(), vec![0.0; n_z]).unwrap_err();
        assert_eq!(fault(&[], &[1.0], 0), "x has no values");
        assert_eq!(fault(&[1.0], &[0.0, f64::NAN], 2), "y[1] is NaN");
        assert_eq!(fault(&[1.0, 2.0, 2.0], &[0.0], 3), "x does not increase from 2 to 2");
        assert_eq!(fault(&[1.0, 2.0], &[0.0], 3), "z has 3 values in place of 2 × 1");
    }
}
