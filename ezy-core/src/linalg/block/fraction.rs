//! Inverses of small blocks.

use super::two::Number;
use super::{Block, Column};

/// A block over a number.
pub(super) struct Fraction<const B: usize, T = f64> {
    pub numerator: Block<B, T>,
    pub denominator: T,
    /// Of each row, relative to what it started from.
    pub pivots: Column<B, T>,
}

impl<const B: usize, T: Number> Fraction<B, T> {
    /// Inverse of a positive definite block of one to three rows, of which the lower triangle is read.
    ///
    /// Of two rows it is the adjugate over the determinant a b − c², which loses the digits that the second pivot loses. The determinant of
    /// three would lose those of two pivots: a body that is light to turn, welded at a lever, makes both small. So the first row is
    /// eliminated, and the adjugate is that of what it leaves of the others.
    #[inline]
    pub(super) fn inverse(block: &Block<B, T>, start: &Column<B, T>) -> Self {
        let (mut numerator, mut pivots) = ([[T::from_f64(0.0); B]; B], [T::from_f64(1.0); B]);
        let first = block[0][0];
        pivots[0] = first / start[0];
        let denominator = match B {
            1 => {
                numerator[0][0] = T::from_f64(1.0);
                first
            }
            2 => {
                let (c, b) = (block[0][1], block[1][1]);
                let determinant = first * b - c * c;
                pivots[1] = determinant / (first * start[1]);
                [numerator[0][0], numerator[0][1]] = [b, -c];
                [numerator[1][0], numerator[1][1]] = [-c, first];
                determinant
            }
            _ => {
                // [1 −lᵀ; 0 1] [1/first 0; 0 adjugate/determinant] [1 0; −l 1]
                let reciprocal = T::from_f64(1.0) / first;
                let l = [block[0][1] * reciprocal, block[0][2] * reciprocal];
                let a = block[1][1] - l[0] * block[0][1];
                let c = block[1][2] - l[0] * block[0][2];
                let b = block[2][2] - l[1] * block[0][2];
                let determinant = a * b - c * c;
                pivots[1] = a / start[1];
                pivots[2] = determinant / (a * start[2]);
                let [x, y] = [c * l[1] - b * l[0], c * l[0] - a * l[1]];
                let corner = determinant * reciprocal - x * l[0] - y * l[1];
                [numerator[0][0], numerator[0][1], numerator[0][2]] = [corner, x, y];
                [numerator[1][0], numerator[1][1], numerator[1][2]] = [x, b, -c];
                [numerator[2][0], numerator[2][1], numerator[2][2]] = [y, -c, a];
                determinant
            }
        };
        Self { numerator, denominator, pivots }
    }
}
