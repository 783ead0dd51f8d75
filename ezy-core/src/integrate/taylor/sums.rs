//! The sums of all products of one order: a third of the time of a step.

use crate::model::{PRODUCT_GROUP, SeriesStore};
use crate::scalar::{Scalar, in_wide};

/// `sums = Σ left_j right_{n−j}` over j = 1 … n − 1, for `n` ≥ 2.
///
/// # Cost
/// n − 1 multiplications and additions for each product, eight products at a time in vector registers.
pub(super) fn sum_products<T: Scalar>(store: &mut SeriesStore<T>, n: usize) {
    if size_of::<T>() == size_of::<f64>() {
        in_wide(
            #[inline(always)]
            || sum_groups::<T, PRODUCT_GROUP>(store, n),
        );
    } else {
        // a wider number fills the registers by itself
        sum_groups::<T, 1>(store, n);
    }
}

#[inline(always)]
fn sum_groups<T: Scalar, const WIDTH: usize>(store: &mut SeriesStore<T>, n: usize) {
    let SeriesStore { left, right, sums, .. } = store;
    let (sums, _) = sums.as_chunks_mut::<WIDTH>();
    let (left, right) = (left.as_chunks::<WIDTH>().0, right.as_chunks::<WIDTH>().0);
    let n_groups = sums.len();
    if n_groups == 0 {
        return;
    }
    // the newest coefficients come last, so that the processor adds up the others while it still solves for these
    let middle = 2 * n_groups..(n - 1).max(2) * n_groups;
    let (middle_left, middle_right) = (&left[middle.clone()], &right[middle]);
    let pairs = middle_left.chunks_exact(n_groups).zip(middle_right.chunks_exact(n_groups).rev());
    for (group, sum) in sums.iter_mut().enumerate() {
        let mut total = [T::from_f64(0.0); WIDTH];
        for (left, right) in pairs.clone() {
            total = fused(&left[group], &right[group], total);
        }
        let newest = (n - 1) * n_groups + group;
        total = fused(&left[n_groups + group], &right[newest], total);
        if n > 2 {
            total = fused(&left[newest], &right[n_groups + group], total);
        }
        *sum = total;
    }
}

/// `left · right + total`
#[inline(always)]
fn fused<T: Scalar, const WIDTH: usize>(left: &[T; WIDTH], right: &[T; WIDTH], mut total: [T; WIDTH]) -> [T; WIDTH] {
    for i in 0..WIDTH {
        total[i] = left[i].fused_in_loop(right[i], total[i]);
    }
    total
}
