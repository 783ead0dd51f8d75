//! Sums of slopes, the inner loop of a step: weights known to the compiler, numbers side by side.

use super::tableau::{
    AT_END, DENSE_14, DENSE_15, DENSE_16, N_STAGES_OF_DENSE_OUTPUT, N_SUMS, STAGE_2, STAGE_3, STAGE_4, STAGE_5,
    STAGE_6, STAGE_7, STAGE_8, STAGE_9, STAGE_10, STAGE_11, STAGE_12, STEP,
};
use crate::scalar::{Scalar, in_wide};

/// Numbers of y that are computed together; y is padded with zeros to a whole number of blocks.
pub(super) type Block<T> = [T; WIDTH];
pub(super) const WIDTH: usize = 4;

/// `start + length · sum` with the weights of a stage: from the slopes of all stages, each as long as the result.
pub(super) type Sum<T> = fn(&[Block<T>], &[Block<T>], f64, &mut [Block<T>]);

/// `start + length · Σ weight · slope`, in the order of the weights. To be inlined where these are literals.
#[inline(always)]
pub(super) fn advance<const N: usize, T: Scalar>(
    weights: [(usize, f64); N],
    slopes: &[Block<T>],
    start: &[Block<T>],
    length: f64,
    out: &mut [Block<T>],
) {
    let n = out.len();
    for i in 0..n {
        let mut sum = [T::from_f64(0.0); WIDTH];
        // a slope that may be missing keeps the compiler from taking several blocks at once: there are few, and a block fills a register
        for (stage, weight) in weights {
            add(&mut sum, weight, &slopes[stage * n + i]);
        }
        for k in 0..WIDTH {
            out[i][k] = start[i][k] + T::from_f64(length) * sum[k];
        }
    }
}

/// Sums with these weights, which stay literals where they are compiled for wide registers.
macro_rules! wide {
    ($($weights:ident),*) => {
        [$(|slopes, start, h, out| {
            in_wide(
                #[inline(always)]
                || advance($weights, slopes, start, h, out),
            )
        }),*]
    };
}

/// From the start to each stage from the second on; the thirteenth is the end of the step.
pub(super) const fn stages<T: Scalar>() -> [Sum<T>; N_STAGES_OF_DENSE_OUTPUT - 1] {
    wide![
        STAGE_2, STAGE_3, STAGE_4, STAGE_5, STAGE_6, STAGE_7, STAGE_8, STAGE_9, STAGE_10, STAGE_11, STAGE_12, STEP,
        DENSE_14, DENSE_15, DENSE_16
    ]
}

/// The step over its length, its errors of orders 5 and 3, and the sixth difference, from the slopes of the stages of a step.
pub(super) fn at_end<T: Scalar>(slopes: &[Block<T>], step: &mut [Block<T>], errors: &mut [Vec<Block<T>>; 3]) {
    in_wide(
        #[inline(always)]
        || {
            let n = step.len();
            for i in 0..n {
                let mut sums = [[T::from_f64(0.0); WIDTH]; N_SUMS];
                for (stage, weights) in AT_END {
                    let slope = &slopes[stage * n + i];
                    for k in 0..N_SUMS {
                        add(&mut sums[k], weights[k], slope);
                    }
                }
                let [of_step, fives, threes, sixes] = sums;
                step[i] = of_step;
                for (errors, sums) in errors.iter_mut().zip([fives, threes, sixes]) {
                    errors[i] = sums;
                }
            }
        },
    );
}

#[inline(always)]
fn add<T: Scalar>(sum: &mut Block<T>, weight: f64, slope: &Block<T>) {
    for k in 0..WIDTH {
        sum[k] = sum[k] + T::from_f64(weight) * slope[k];
    }
}
