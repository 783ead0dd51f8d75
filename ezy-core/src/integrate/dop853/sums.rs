//! Sums of slopes, the inner loop of a step: weights known to the compiler, numbers side by side.

use crate::scalar::Scalar;

/// Numbers of y that are computed together; y is padded with zeros to a whole number of blocks.
pub(super) type Block<T> = [T; WIDTH];
pub(super) const WIDTH: usize = 4;

/// A sum over stages: from the slopes of all stages, each as long as the result.
pub(super) type Sum<T> = fn(&[Block<T>], &mut [Block<T>]);

/// `Σ weight · slope`, in the order of the weights. To be inlined where these are literals.
#[allow(
    clippy::needless_range_loop,
    reason = "counted loops become vector instructions, iterators of this length do not"
)]
#[inline(always)]
pub(super) fn sum<const N: usize, T: Scalar>(weights: [(usize, f64); N], slopes: &[Block<T>], out: &mut [Block<T>]) {
    T::in_widest(
        #[inline(always)]
        || {
            let length = out.len();
            let rows: [&[Block<T>]; N] = std::array::from_fn(|k| &slopes[weights[k].0 * length..][..length]);
            for (i, out) in out.iter_mut().enumerate() {
                let mut sum = [T::from_f64(0.0); WIDTH];
                for (row, (_, weight)) in rows.iter().zip(weights) {
                    let block = row[i];
                    for k in 0..WIDTH {
                        sum[k] = sum[k] + T::from_f64(weight) * block[k];
                    }
                }
                *out = sum;
            }
        },
    );
}
