//! Sums of slopes, the inner loop of a step: weights known to the compiler, numbers side by side.

/// Numbers of y that are computed side by side; y is filled up with zeros to a whole number of blocks.
pub type Block = [f64; WIDTH];
pub const WIDTH: usize = 4;

/// A sum over stages: from the slopes of all stages, each as long as the result.
pub type Sum = fn(&[Block], &mut [Block]);

/// `Σ weight · slope`, in the order of the weights. To be inlined where these are literals.
#[inline(always)]
pub fn sum<const N: usize>(weights: [(usize, f64); N], slopes: &[Block], out: &mut [Block]) {
    let length = out.len();
    let rows: [&[Block]; N] = std::array::from_fn(|k| &slopes[weights[k].0 * length..][..length]);
    for (i, out) in out.iter_mut().enumerate() {
        let mut sum = [0.0; WIDTH];
        for (row, (_, weight)) in rows.iter().zip(weights) {
            sum.iter_mut().zip(row[i]).for_each(|(sum, slope)| *sum += weight * slope);
        }
        *out = sum;
    }
}
