//! Pivots of a generated elimination.

/// A pivot of the generated elimination counts as vanished when it is below this fraction of the diagonal
/// entry that it started from. Rounding leaves 1e-16 to 1e-14 of an exactly dependent row; a row that keeps
/// 1e-9 still has seven digits.
pub const PIVOT_TOLERANCE: f64 = 1e-10;

/// The smallest pivot of a generated elimination, and the rows whose pivot vanished.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pivots {
    /// Bit `i` is row `i`, bit 63 stands for every row from 63 on.
    vanished: u64,
    /// Over its threshold.
    smallest: f64,
}

impl Pivots {
    /// Of an elimination that has not begun.
    #[inline(always)]
    #[must_use]
    pub const fn new() -> Self {
        Self { vanished: 0, smallest: 1.0 / PIVOT_TOLERANCE }
    }

    /// Every row counts as vanished.
    pub const ALL_VANISHED: Self = Self { vanished: u64::MAX, smallest: 0.0 };

    /// Takes note of the pivot of some rows, given as its ratio to [`PIVOT_TOLERANCE`] of the diagonal that it started from, or
    /// of the square of a trace; one that is not a number counts as vanished. Free of branches, so that a kernel can call it
    /// for each pivot.
    #[inline(always)]
    #[must_use]
    pub const fn see(self, rows: &[usize], ratio: f64) -> Self {
        let mut bits = 0;
        let mut i = 0;
        while i < rows.len() {
            bits |= 1_u64 << if rows[i] < 63 { rows[i] } else { 63 };
            i += 1;
        }
        let keeps = ratio > 1.0;
        Self {
            vanished: self.vanished | if keeps { 0 } else { bits },
            smallest: if ratio < self.smallest { ratio } else { self.smallest },
        }
    }

    /// Of two eliminations.
    pub(crate) const fn and(self, other: Self) -> Self {
        let smallest = if other.smallest < self.smallest { other.smallest } else { self.smallest };
        Self { vanished: self.vanished | other.vanished, smallest }
    }

    /// No pivot vanished.
    #[inline(always)]
    pub const fn all_keep(self) -> bool {
        self.vanished == 0
    }

    /// The first row whose pivot vanished.
    pub(crate) const fn first_vanished(self) -> Option<usize> {
        if self.all_keep() { None } else { Some(self.vanished.trailing_zeros() as usize) }
    }

    /// The smallest pivot, relative to the diagonal that it started from; the determinant of a pair of rows to the square of
    /// its trace. 1 without any.
    #[inline(always)]
    pub(crate) const fn smallest(self) -> f64 {
        PIVOT_TOLERANCE * self.smallest
    }
}

impl Default for Pivots {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_pivots_name_the_first_row_that_vanished() {
        let pivots = Pivots::new().see(&[4], 3e9).see(&[2, 3], 0.5).see(&[70], f64::NAN);
        assert_eq!((pivots.first_vanished(), pivots.smallest()), (Some(2), 0.5 * PIVOT_TOLERANCE));
        assert_eq!(Pivots::new().see(&[70], f64::NAN).first_vanished(), Some(63));
        assert!(Pivots::new().see(&[0], 2.0).all_keep());
    }
}
