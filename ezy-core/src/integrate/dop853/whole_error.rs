//! The error of a step in quasi-velocities, by what it makes of the whole state.

use super::{scale, scale_of};
use crate::integrate::reduced::Numbers;
use crate::integrate::tolerances::dop853::ROUNDING;
use crate::scalar::Scalar;

impl Numbers {
    /// Tolerance for number `i`, of this size.
    #[inline(always)]
    pub(super) fn scale<T: Scalar>(&self, i: usize, size: T) -> T {
        match i.checked_sub(self.n_u) {
            Some(i) => scale_of(self.tolerance, self.integrated[i], self.n_q, size),
            None => scale(self.tolerance, size),
        }
    }

    /// Adds the squares of the errors of number `i` over its tolerance, those of orders 5 and 3 and the sixth difference, from its values at both ends.
    #[inline(always)]
    pub(super) fn add<T: Scalar>(&self, i: usize, [start, end]: [T; 2], errors: [T; 3], shares: &mut [T; 3]) {
        let weight = T::from_f64(1.0) / self.scale(i, start.abs().max(end.abs()));
        for (share, error) in shares.iter_mut().zip(errors) {
            let error = error * weight;
            *share = *share + error * error;
        }
    }

    /// The error over the tolerance of a step of length `h`, from [`Numbers::add`] of all numbers, and from the coordinates and velocities at the start, at the end, and at the
    /// end with its error of order 5.
    ///
    /// The other estimates count in the share that they have of the numbers that are integrated.
    #[inline(always)]
    pub(super) fn error<T: Scalar>(&self, h: f64, shares: [T; 3], [start, end, off]: [[&[T]; 2]; 3]) -> T {
        let (n_q, mut sum) = (self.n_q, T::from_f64(0.0));
        for (i, ((start, end), off)) in start[0].iter().zip(end[0]).zip(off[0]).enumerate() {
            let error = (*off - *end) / scale_of(self.tolerance, i, n_q, start.abs().max(end.abs()));
            sum = sum + error * error;
        }
        for ((start, end), off) in start[1].iter().zip(end[1]).zip(off[1]) {
            let error = (*off - *end) / scale(self.tolerance, start.abs().max(end.abs()));
            sum = sum + error * error;
        }
        let tiny = T::from_f64(f64::MIN_POSITIVE);
        let [five, three, six] = shares;
        let larger = if self.tolerance.relative >= ROUNDING { five.max(six) } else { five };
        let n = T::from_f64((2 * n_q) as f64);
        // a part of `five` below the rounding of a number moves none of them
        let moved = (sum / five.max(tiny)).max(T::from_f64(h * h));
        let whole = (larger + T::from_f64(0.01) * three).max(tiny);
        (moved * larger / n * (larger / whole)).sqrt()
    }
}
