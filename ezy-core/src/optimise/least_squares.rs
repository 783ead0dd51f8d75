//! The least squares, by Levenberg and Marquardt's method of the crate `basin`.

use super::model::Model;
use basin::{DenseMatrix, Executor, Jacobian, LevenbergMarquardt, PointState, Residual, Termination};
use std::convert::Infallible;

/// Steps of the method, rejected ones included, after which it gives up.
const MOST_STEPS: u64 = 300;

/// Why a fit ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum FitEnd {
    /// The residuals are as small as they become: their gradient, or the next step, is as small as the error of the runs.
    Converged,
    /// No step makes the residuals smaller, though their gradient is not yet small. The values are the best that were found.
    NoProgress,
    /// After so many steps the residuals still become smaller. The values are the best that were found.
    TooManySteps,
}

impl std::fmt::Display for FitEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Converged => "converged",
            Self::NoProgress => "stopped: no step makes the residuals smaller; take a smaller tolerance of the runs, or start elsewhere",
            Self::TooManySteps => "stopped after many steps, while the residuals still become smaller; start with the values that it found",
        })
    }
}

/// Residuals over the unbounded `u` of each free quantity.
struct Problem<'m, 'f>(&'m Model<'f>);

impl Problem<'_, '_> {
    fn values(&self, u: &[f64]) -> Vec<f64> {
        self.0.free.iter().zip(u).map(|(free, u)| free.value(*u)).collect()
    }
}

impl Residual for Problem<'_, '_> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    /// Infinite where a run fails: the step is rejected.
    fn residual(&self, u: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        let data = self.0.data;
        let failed = || vec![f64::INFINITY; data.n_values()];
        Ok(self.0.predicted(&self.values(u)).map_or_else(failed, |predicted| residuals(self.0, &predicted)))
    }
}

impl Jacobian for Problem<'_, '_> {
    type Jacobian = DenseMatrix<f64>;

    fn jacobian(&self, u: &Vec<f64>) -> Result<DenseMatrix<f64>, Infallible> {
        let columns = self.0.jacobian(&self.values(u));
        let slopes: Vec<f64> = self.0.free.iter().zip(u).map(|(free, u)| free.slope(*u)).collect();
        Ok(DenseMatrix::from_fn(self.0.data.n_values(), u.len(), |i, j| columns[j][i] * slopes[j]))
    }
}

/// Predicted less measured, over σ.
pub(super) fn residuals(model: &Model<'_>, predicted: &[f64]) -> Vec<f64> {
    model.data.points().zip(predicted).map(|(point, predicted)| predicted - point.value / point.column.sigma).collect()
}

/// The values of least squares, and why the method ended.
pub(super) fn solve(model: &Model<'_>) -> (Vec<f64>, FitEnd) {
    // what is smaller than the error of the runs is not seen
    let solver = LevenbergMarquardt::new()
        .with_absolute_gradient_tolerance(None)
        .with_gradient_orthogonality_tolerance(model.tolerance)
        .with_relative_step_tolerance(model.tolerance);
    let start: Vec<f64> = model.free.iter().map(|free| free.start_inside()).collect();
    let problem = Problem(model);
    let Ok(result) = Executor::new(problem, solver, PointState::new(start)).max_iter(MOST_STEPS).run();
    let end = match result.report.termination {
        Termination::Converged(_) => FitEnd::Converged,
        Termination::Limit(_) => FitEnd::TooManySteps,
        _ => FitEnd::NoProgress,
    };
    (Problem(model).values(result.param()), end)
}
