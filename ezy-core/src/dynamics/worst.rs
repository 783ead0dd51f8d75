//! Which row is farthest from being met.

use super::max_abs;
use super::solved::Solved;

/// A residual and the row that has it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Worst {
    /// Magnitude of the residual; NaN when there is one.
    pub value: f64,
    /// Index of the row, the first of several; 0 where all are zero.
    pub row: usize,
}

impl Worst {
    /// Of all residuals; zero without any.
    pub(crate) fn of(residual: &[f64]) -> Self {
        let value = max_abs(residual);
        let row = residual.iter().position(|x| x.abs() == value || x.is_nan());
        Self { value, row: row.unwrap_or(0) }
    }
}

/// What a projection found, and what it left.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Projected {
    /// Position constraints before.
    pub positions_before: Worst,
    /// Position constraints after.
    pub positions_after: Worst,
    /// All rows at velocity level before, at the projected positions.
    pub velocities_before: Worst,
    /// How velocities were corrected, where they were.
    pub solved: Option<Solved>,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first of equal ones; what is not a number is worst.
    #[test]
    fn analytic_worst_row() {
        for (residual, value, row) in
            [(&[1.0, -3.0, 3.0][..], 3.0, 1), (&[0.0, 0.0], 0.0, 0), (&[], 0.0, 0), (&[-2.0, 1.0], 2.0, 0)]
        {
            assert_eq!(Worst::of(residual), Worst { value, row }, "{residual:?}");
        }
        let worst = Worst::of(&[7.0, f64::NAN, 2.0]);
        assert!(worst.value.is_nan() && worst.row == 1, "{worst:?}");
    }
}
