//! Results of the checks of a scene.

use crate::dynamics::{MotionError, MovedValue, RankLoss, StartError, SystemError};
use crate::simulate::SetupError;

/// One check.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// Name of the check: `Jacobian against finite differences`, …
    pub name: &'static str,
    /// Comparisons made.
    pub n_compared: usize,
    /// Comparisons that were left out, close to points where the equations are singular; at most as many as were made.
    pub n_left_out: usize,
    /// Largest error found; relative where `tolerance` is.
    pub largest_error: f64,
    /// Largest error that is accepted.
    pub tolerance: f64,
    /// Reason for the tolerance.
    pub reason: &'static str,
}

impl Check {
    /// Whether the error is within the tolerance, and at least half of the comparisons could be made.
    pub(crate) fn passed(&self) -> bool {
        self.largest_error <= self.tolerance && self.n_left_out <= self.n_compared
    }
}

/// All checks of one scene.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckReport {
    /// Name of the model.
    pub model: &'static str,
    /// Name of the scene.
    pub scene: &'static str,
    /// In the order in which they were made.
    pub checks: Vec<Check>,
    /// Rows that depend on each other at the start.
    pub rank: Option<RankLoss>,
    /// Start values that were near and changed by more than their last digits.
    pub moved: Vec<MovedValue>,
}

impl CheckReport {
    /// Whether all checks passed.
    pub(crate) fn passed(&self) -> bool {
        self.checks.iter().all(Check::passed)
    }
}

impl std::fmt::Display for CheckReport {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{}/{}", self.model, self.scene)?;
        let width = self.checks.iter().map(|c| c.name.len()).max().unwrap_or(0);
        for c in &self.checks {
            let verdict = match (c.passed(), c.n_compared) {
                (true, 0) => "nothing to compare",
                (true, _) => "ok",
                (false, _) => "FAILED",
            };
            write!(
                f,
                "  {:width$}  largest error {:8.1e}  tolerance {:8.1e}  {:>6} compared  {verdict}",
                c.name, c.largest_error, c.tolerance, c.n_compared
            )?;
            match c.n_left_out {
                0 => writeln!(f)?,
                n => writeln!(f, "; {n} left out next to singular points")?,
            }
        }
        if let Some(loss) = &self.rank {
            writeln!(f, "  rows at the start: {loss}")?;
        }
        self.moved.iter().try_for_each(|value| writeln!(f, "  gave way at the start: {value}"))
    }
}

/// A scene that is wrong, or that cannot be checked.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// Some checks failed; the report holds all of them.
    #[error("some checks failed:\n{0}")]
    Failed(Box<CheckReport>),
    /// Parameters or masses cannot be used.
    #[error(transparent)]
    System(#[from] SystemError),
    /// There is no consistent start.
    #[error(transparent)]
    Start(#[from] StartError),
    /// The equations are singular.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The short run of the energy check could not start.
    #[error(transparent)]
    Setup(#[from] SetupError),
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_check_without_comparisons_is_not_called_ok() {
        let check = |n_compared, largest_error| Check {
            name: "C_q against differences of C",
            n_compared,
            n_left_out: 0,
            largest_error,
            tolerance: 1e-10,
            reason: "rounding",
        };
        let checks = vec![check(0, 0.0), check(2, 0.0), check(2, 1.0), check(0, f64::NAN)];
        let text = CheckReport { model: "Body", scene: "free", checks, moved: Vec::new(), rank: None }.to_string();
        let ends: Vec<&str> = text.lines().skip(1).filter_map(|line| Some(line.split_once("compared  ")?.1)).collect();
        assert_eq!(ends, ["nothing to compare", "ok", "FAILED", "FAILED"]);
    }
}
