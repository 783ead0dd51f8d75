//! Equations in units of their own.

use super::row_space::RowSpace;
use super::steady_equations::Evaluated;
use super::tolerances::search::FREE;
use nalgebra::{DMatrix, DVector};

/// Rows and columns of the equations in units of their own, from a point on.
pub(super) struct Scaling {
    pub rows: Vec<f64>,
    /// Zero where an unknown is held.
    pub columns: Vec<f64>,
}

impl Scaling {
    pub(super) fn of(jacobian: &DMatrix<f64>, held: &[bool]) -> Self {
        let of_column = jacobian.column_iter().zip(held);
        let columns: Vec<f64> =
            of_column.map(|(column, held)| if *held { 0.0 } else { reciprocal(column.norm()) }).collect();
        let rows = (jacobian.row_iter())
            .map(|row| reciprocal(row.iter().zip(&columns).map(|(x, c)| (x * c).powi(2)).sum::<f64>().sqrt()))
            .collect();
        Self { rows, columns }
    }

    pub(super) fn residual(&self, at: &Evaluated) -> DVector<f64> {
        DVector::from_fn(self.rows.len(), |i, _| self.rows[i] * at.residual[i])
    }

    /// What the rows hold, and the step that they ask for; none where they are not finite.
    pub(super) fn step(&self, jacobian: &DMatrix<f64>, residual: &DVector<f64>) -> Option<(RowSpace, DVector<f64>)> {
        let Self { rows, columns } = self;
        let scaled = DMatrix::from_fn(rows.len(), columns.len(), |i, j| rows[i] * jacobian[(i, j)] * columns[j]);
        let mut space = RowSpace::of(&scaled, FREE)?;
        let step = space.shortest(&-residual).unwrap_or_else(|| DVector::zeros(columns.len()));
        Some((space, step.component_mul(&DVector::from_column_slice(columns))))
    }
}

pub(super) fn reciprocal(x: f64) -> f64 {
    if x > 0.0 { x.recip() } else { 1.0 }
}
