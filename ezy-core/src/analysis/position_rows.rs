//! The position rows of a scene over some of its coordinates, scaled to one.

use super::error::AnalysisError;
use super::row_space::RowSpace;
use super::scaling::reciprocal;
use super::tolerances::continuation::{CORRECTIONS, LAST_CORRECTION, STRIDE};
use super::tolerances::search::MET;
use crate::dynamics::System;
use crate::model::{Equations as _, SceneRef};
use nalgebra::{DMatrix, DVector};

/// Rows C(q) = 0 over the coordinates that may move, at one time. Angles count in rad, lengths in lengths of the mechanism; each row is divided by
/// the norm of its slopes.
pub(super) struct PositionRows<'s, P: SceneRef> {
    system: &'s System<P>,
    t: f64,
    /// Rows that are not left out.
    kept: Vec<usize>,
    /// Coordinates that may move.
    active: Vec<usize>,
    /// Unit of each of them.
    units: Vec<f64>,
}

/// The rows at a place.
pub(super) struct ScaledRows {
    /// By the coordinates that may move.
    pub jacobian: DMatrix<f64>,
    pub residual: DVector<f64>,
}

/// How well the held coordinates determine the others.
#[derive(Debug, Clone, Copy)]
pub(super) struct Condition {
    pub smallest: f64,
    pub transmission: f64,
}

impl Condition {
    pub(super) const NONE: Self = Self { smallest: f64::NAN, transmission: f64::NAN };
}

impl<'s, P: SceneRef> PositionRows<'s, P> {
    pub(super) fn new(system: &'s System<P>, t: f64, left_out: &[usize], active: Vec<usize>) -> Self {
        let kept = (0..system.info().n_position_rows).filter(|row| !left_out.contains(row)).collect();
        let coordinates = &system.info().coordinates;
        let units = active.iter().map(|&i| if coordinates[i].is_length() { system.length() } else { 1.0 }).collect();
        Self { system, t, kept, active, units }
    }

    pub(super) fn active(&self) -> &[usize] {
        &self.active
    }

    pub(super) fn kept(&self) -> &[usize] {
        &self.kept
    }

    /// Residual and Jacobian; none where they are not finite.
    pub(super) fn at(&self, q: &[f64]) -> Option<ScaledRows> {
        let (scene, info, fixed) = (self.system.scene(), self.system.info(), self.system.fixed());
        let mut residuals = vec![0.0; info.n_position_rows];
        scene.position_constraint(fixed, self.t, q, &mut residuals);
        let mut g = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(fixed, self.t, q, &mut g);
        let mut all = DMatrix::zeros(self.kept.len(), info.n_coordinates());
        for (k, row, column) in info.jacobian.entries() {
            if let Ok(i) = self.kept.binary_search(&row) {
                all[(i, column)] = g[k];
            }
        }
        let mut jacobian = all.select_columns(&self.active);
        jacobian.column_iter_mut().zip(&self.units).for_each(|(mut column, unit)| column *= *unit);
        let mut residual = DVector::from_iterator(self.kept.len(), self.kept.iter().map(|&row| residuals[row]));
        for (mut row, residual) in jacobian.row_iter_mut().zip(residual.iter_mut()) {
            let scale = reciprocal(row.norm());
            row *= scale;
            *residual *= scale;
        }
        let is_finite = residual.iter().chain(&jacobian).all(|x| x.is_finite());
        is_finite.then_some(ScaledRows { jacobian, residual })
    }

    /// What moves, as a scaled vector.
    fn vector(&self, q: &[f64]) -> DVector<f64> {
        DVector::from_iterator(self.active.len(), self.active.iter().zip(&self.units).map(|(&i, unit)| q[i] / unit))
    }

    /// The place a scaled step on.
    pub(super) fn moved(&self, q: &[f64], step: &DVector<f64>) -> Vec<f64> {
        let mut to = q.to_vec();
        self.active.iter().zip(&self.units).zip(step).for_each(|((&i, unit), step)| to[i] += unit * step);
        to
    }

    /// The scaled step between two places.
    pub(super) fn apart(&self, from: &[f64], to: &[f64]) -> DVector<f64> {
        self.vector(to) - self.vector(from)
    }

    /// Newton's method from a step on, whose components along the borders stay: none where it does not converge, or goes further than `far`.
    pub(super) fn corrected(
        &self,
        from: &[f64],
        borders: &DMatrix<f64>,
        step: &DVector<f64>,
        far: f64,
    ) -> Option<Vec<f64>> {
        let goal = borders.tr_mul(step);
        let first = self.moved(from, step);
        let mut q = first.clone();
        for _ in 0..CORRECTIONS {
            let ScaledRows { jacobian, residual } = self.at(&q)?;
            let left = &goal - borders.tr_mul(&self.apart(from, &q));
            let mut right = DVector::zeros(residual.len() + left.len());
            right.rows_mut(0, residual.len()).copy_from(&-residual);
            right.rows_mut(jacobian.nrows(), left.len()).copy_from(&left);
            let change = solve(bordered(&jacobian, borders), &DMatrix::from_columns(&[right]))?.column(0).into_owned();
            q = self.moved(&q, &change);
            if self.apart(&first, &q).amax() > far {
                return None;
            }
            if change.amax() <= LAST_CORRECTION * STRIDE {
                let size = self.vector(&q).amax().max(1.0);
                return (self.at(&q)?.residual.amax() <= MET * size).then_some(q);
            }
        }
        None
    }

    /// The condition at a place where the coordinates at `held`, places among those that may move, are held.
    pub(super) fn condition(&self, q: &[f64], held: &[usize]) -> Condition {
        let Some(ScaledRows { jacobian, .. }) = self.at(q) else { return Condition::NONE };
        let free: Vec<usize> = (0..self.active.len()).filter(|j| !held.contains(j)).collect();
        if free.is_empty() {
            return Condition { smallest: 1.0, transmission: 0.0 };
        }
        let (by_free, by_held) = (jacobian.select_columns(&free), jacobian.select_columns(held));
        let svd = by_free.svd(true, true);
        let smallest = svd.singular_values.min();
        let moves = svd.solve(&by_held, 0.0).ok();
        let transmission = moves.map_or(f64::INFINITY, |moves| moves.singular_values().max());
        Condition { smallest, transmission: if transmission.is_finite() { transmission } else { f64::INFINITY } }
    }
}

impl<P: SceneRef> PositionRows<'_, P> {
    /// Directions that the rows leave free at a place, as orthonormal columns.
    pub(super) fn null_space(&self, q: &[f64], independent: f64) -> Result<DMatrix<f64>, AnalysisError> {
        let scene = self.system.info().name;
        let at = self.at(q).ok_or(AnalysisError::NotFinite { scene })?;
        let mut rows = RowSpace::of(&at.jacobian, independent).ok_or(AnalysisError::NotFinite { scene })?;
        Ok(rows.null_space())
    }
}

/// The Jacobian with one row more for each direction.
pub(super) fn bordered(jacobian: &DMatrix<f64>, directions: &DMatrix<f64>) -> DMatrix<f64> {
    let n = jacobian.nrows();
    let mut all = DMatrix::zeros(n + directions.ncols(), jacobian.ncols());
    all.rows_mut(0, n).copy_from(jacobian);
    all.rows_mut(n, directions.ncols()).copy_from(&directions.transpose());
    all
}

/// In least squares; the rows are consistent. None where a column depends on others.
pub(super) fn solve(matrix: DMatrix<f64>, right: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let qr = matrix.qr();
    qr.r().solve_upper_triangular(&qr.q().tr_mul(right))
}
