//! Positions over a grid of held coordinates, from neighbour to neighbour.

use super::orientation::Orientation;
use super::position_rows::{PositionRows, bordered, solve};
use super::tolerances::workspace::{AHEAD, ASTRAY, SHORTEST};
use crate::model::SceneRef;
use nalgebra::{DMatrix, DVector};
use std::collections::VecDeque;

/// Two coordinates over a grid.
pub(super) struct Grid<'r, 's, P: SceneRef> {
    pub rows: &'r PositionRows<'s, P>,
    /// Places of the coordinates among those that may move.
    pub held: [usize; 2],
    /// Ascending values of both.
    pub values: [&'r [f64]; 2],
}

impl<P: SceneRef> Grid<'_, '_, P> {
    /// The position at each place, the first coordinate slowest; none where that is not reached from `start` without a singular position on the way.
    pub(super) fn positions(&self, start: &[f64]) -> Vec<Option<Vec<f64>>> {
        let [n, m] = self.values.map(<[f64]>::len);
        let mut found: Vec<Option<Vec<f64>>> = vec![None; n * m];
        let borders = self.borders();
        let mut by_distance: Vec<(f64, usize)> = (0..n * m)
            .map(|i| ((borders.tr_mul(&self.rows.apart(start, &self.at(start, self.place(i))))).norm(), i))
            .collect();
        by_distance.sort_by(|a, b| a.0.total_cmp(&b.0));
        let first = by_distance.into_iter().find_map(|(_, i)| Some((i, self.reached(start, self.place(i))?)));
        let Some((first, q)) = first else { return found };
        found[first] = Some(q);
        let mut next = VecDeque::from([first]);
        while let Some(i) = next.pop_front() {
            let Some(from) = found[i].clone() else { continue };
            let (row, column) = (i / m, i % m);
            let neighbours = [
                (row > 0).then(|| i - m),
                (row + 1 < n).then_some(i + m),
                (column > 0).then(|| i - 1),
                (column + 1 < m).then_some(i + 1),
            ];
            for j in neighbours.into_iter().flatten() {
                if found[j].is_none()
                    && let Some(q) = self.reached(&from, self.place(j))
                {
                    found[j] = Some(q);
                    next.push_back(j);
                }
            }
        }
        found
    }

    fn place(&self, i: usize) -> [f64; 2] {
        let [x, y] = self.values;
        [x[i / y.len()], y[i % y.len()]]
    }

    /// A column for each held coordinate.
    fn borders(&self) -> DMatrix<f64> {
        let mut borders = DMatrix::zeros(self.rows.active().len(), self.held.len());
        self.held.iter().enumerate().for_each(|(k, &j)| borders[(j, k)] = 1.0);
        borders
    }

    /// With the held coordinates at a place.
    fn at(&self, q: &[f64], place: [f64; 2]) -> Vec<f64> {
        let mut q = q.to_vec();
        self.held.iter().zip(place).for_each(|(&j, value)| q[self.rows.active()[j]] = value);
        q
    }

    /// The position at a place, on a straight way there, with the same way of assembly.
    fn reached(&self, from: &[f64], place: [f64; 2]) -> Option<Vec<f64>> {
        let (mut q, mut done, mut share) = (from.to_vec(), 0.0, 1.0_f64);
        let borders = self.borders();
        while done < 1.0 {
            let part = share.min(1.0 - done);
            // of the way that is left
            let step = borders.tr_mul(&self.rows.apart(&q, &self.at(&q, place))) * (part / (1.0 - done));
            match self.step(&q, &borders, &step) {
                Some(to) => {
                    q = to;
                    done += part;
                    share *= 2.0;
                }
                None if share <= SHORTEST => return None,
                None => share *= 0.5,
            }
        }
        Some(self.at(&q, place))
    }

    /// A step of the held coordinates, along the tangent and back to the rows.
    fn step(&self, q: &[f64], borders: &DMatrix<f64>, step: &DVector<f64>) -> Option<Vec<f64>> {
        let first = bordered(&self.rows.at(q)?.jacobian, borders);
        let mut right = DVector::zeros(first.nrows());
        right.rows_mut(first.nrows() - step.len(), step.len()).copy_from(step);
        let ahead = solve(first.clone(), &DMatrix::from_columns(&[right]))?;
        let ahead = ahead.column(0).into_owned();
        // also where that is not a number
        if !ahead.iter().all(|x| x.abs() <= AHEAD) {
            return None;
        }
        let to = self.rows.corrected(q, borders, &ahead, ASTRAY)?;
        let last = bordered(&self.rows.at(&to)?.jacobian, borders);
        (Orientation::of(first).smallest(&last) > 0.0).then_some(to)
    }
}
