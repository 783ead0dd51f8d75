//! The error of a step, from the Legendre coefficients of its slopes and from what these are at its ends.

use super::tableau::{N, NODES};
use crate::integrate::tolerances::gauss::{OF_SWEEPS, ROUNDING, UNEXPECTED};
use crate::model::{Eight, N_LANES};
use crate::scalar::{Lanes, Scalar, in_wide};

/// 15!! = 15 · 13 · … · 1
const DOUBLE_FACTORIAL_OF_15: f64 = 2_027_025.0;

/// What is known of the error of the step that was tried last, over the tolerance.
#[derive(Debug)]
pub(super) struct StepError {
    of_eight: Vec<OfEight>,
    /// What rounding leaves of slopes.
    rounding: f64,
}

/// Of up to eight numbers of the state, one a lane.
#[derive(Debug, Clone)]
struct OfEight {
    weights: Eight,
    /// What the polynomial lacks at the start of the step, and its slope at the end.
    lacks: Eight,
    at_end: Eight,
    /// By one decay.
    next: Next<Eight>,
}

impl StepError {
    /// For so many numbers.
    pub(super) fn new(n: usize) -> Self {
        let zero = Eight::from_f64(0.0);
        let none =
            OfEight { weights: zero, lacks: zero, at_end: zero, next: Next { square: zero, decay_squared: zero } };
        Self { of_eight: vec![none; n.div_ceil(N_LANES)], rounding: 0.0 }
    }

    /// The error of the end of the step, and the size of the Legendre coefficient of degree 8 of its slopes, by the coefficients before, the largest of
    /// each degree, and the slopes at the start.
    ///
    /// Between the nodes the equations are not met: by the polynomial P_8 times the coefficient that comes next, and what follows. The
    /// end of the step is off by the integral of that, times what a change of a slope at each time makes of the end. That factor
    /// is smooth, too, so that P_8 sees of it only its own coefficient of degree 8: of the linear motion z^8/(2^8 15!!), of the change of its
    /// rate over the step as much as of the slopes of the number that is least smooth, and where slopes do not depend on the state what their own
    /// coefficients leave: of all of them together, and of each one, be it far smaller than another one that is smooth.
    ///
    /// The slopes at the start of the step are known: what the polynomial lacks there is the sum of all coefficients to come. Where
    /// it is more than predicted, coefficients fall as much more slowly; a fall that slows down is believed as far as it shows there.
    pub(super) fn of_slopes(
        &mut self,
        coefficients: &[Eight],
        weights: &[f64],
        sizes: &[f64; N],
        at_start: &[f64],
        steepness: f64,
    ) -> [f64; 2] {
        self.rounding = ROUNDING * sizes.iter().copied().fold(0.0, f64::max);
        // what is lacking at the start, the square of the coefficient of degree 8 over the largest one of the least smooth number, and that of degree 16
        let [mut defect, mut roughest, mut own] = [Eight::from_f64(0.0); 3];
        let (of_eight, mut largest) = (&mut self.of_eight, [0.0; 3]);
        let eights = coefficients.chunks(N_LANES).zip(weights.chunks(N_LANES)).zip(at_start.chunks(N_LANES));
        in_wide(
            #[inline(always)]
            || {
                for (of_eight, ((coefficients, weights), at_start)) in of_eight.iter_mut().zip(eights) {
                    let weights = in_lanes(weights);
                    let mut degrees = by_degree(coefficients);
                    let even = (degrees[0] + degrees[2]) + (degrees[4] + degrees[6]);
                    let odd = (degrees[1] + degrees[3]) + (degrees[5] + degrees[7]);
                    let lacks = (even - odd - in_lanes(at_start)).abs() * weights;
                    // what changes a number by less than its tolerance changes no other
                    let mut size = Eight::from_f64(1.0);
                    for degree in &mut degrees {
                        *degree = degree.abs() * weights;
                        size = size.max(*degree);
                    }
                    let rough = next_by_two_decays(&degrees, Eight::from_f64(f64::INFINITY)).square / (size * size);
                    let next = next_by_one_decay(&degrees);
                    defect = defect.max(lacks);
                    roughest = roughest.max(rough);
                    own = own.max(next.left(lacks - Eight::from_f64(OF_SWEEPS)));
                    *of_eight = OfEight { weights, lacks, at_end: even + odd, next };
                }
                largest = [defect.magnitude(), roughest.magnitude(), own.magnitude()];
            },
        );
        let [defect, roughest, own] = largest;
        // sweeps leave a part of the tolerance
        let defect = defect - OF_SWEEPS;
        let (mut next, mut decay) = next_coefficient(sizes, defect);
        if defect > next {
            decay = (decay * defect / next.max(f64::MIN_POSITIVE)).min(1.0);
            next = defect;
        }
        let linear = (0.5 * steepness).powi(N as i32) / DOUBLE_FACTORIAL_OF_15;
        let seen = linear + steepness * roughest.sqrt() + decay.powi(N as i32);
        [(next * seen).max(own.sqrt() - self.rounding) / (2.0 * N as f64 + 1.0), next]
    }

    /// The error of the end by the slopes there. A force that changes behind the last node is seen by nothing else: what the
    /// polynomial lacks at the end, beyond many times what its coefficients tell and what it lacks at the start, it lacks from that node on. Of smooth slopes it lacks
    /// as much at both ends, where P_8 is 1, also where the last coefficients are small by chance.
    pub(super) fn by_end(&self, at_end: &[f64]) -> f64 {
        let rounding = OF_SWEEPS + self.rounding;
        let [mut unexpected, mut own] = [0.0; 2];
        in_wide(
            #[inline(always)]
            || {
                let [mut surprises, mut left] = [Eight::from_f64(0.0); 2];
                for (OfEight { weights, lacks, at_end: found, next }, at_end) in
                    self.of_eight.iter().zip(at_end.chunks(N_LANES))
                {
                    let defect = (*found - in_lanes(at_end)).abs() * *weights - Eight::from_f64(rounding);
                    let expected = Eight::from_f64(UNEXPECTED) * next.to_come().max(*lacks);
                    left = left.max(next.left(defect));
                    surprises = surprises.max(defect - expected);
                }
                [unexpected, own] = [surprises.magnitude(), left.magnitude()];
            },
        );
        ((1.0 - NODES.0[N - 1]) * unexpected).max((own.sqrt() - rounding) / (2.0 * N as f64 + 1.0))
    }
}

/// Up to eight numbers; zeros behind them.
#[inline(always)]
fn in_lanes(numbers: &[f64]) -> Eight {
    let mut lanes = [0.0; N_LANES];
    lanes[..numbers.len()].copy_from_slice(numbers);
    Lanes(lanes)
}

/// The coefficients of each degree of up to eight numbers.
#[inline(always)]
fn by_degree(coefficients: &[Eight]) -> [Eight; N] {
    let mut degrees = [Eight::from_f64(0.0); N];
    for (i, coefficients) in coefficients.iter().enumerate() {
        for (degree, coefficient) in degrees.iter_mut().zip(coefficients.0) {
            degree.0[i] = coefficient;
        }
    }
    degrees
}

/// The square of the Legendre coefficient of degree 8, which is not known, by those of lower degrees: so one root is taken in the end, and not one a number.
#[derive(Debug, Clone)]
struct Next<T> {
    square: T,
    /// Square of each coefficient over the one before.
    decay_squared: T,
}

impl<T: Scalar> Next<T> {
    #[inline(always)]
    fn new(sizes: &[T; N], decay_squared: T) -> Self {
        let square = decay_squared * (sizes[7] * sizes[7]).max(decay_squared * sizes[6] * sizes[6]);
        Self { square, decay_squared }
    }

    /// The square of the coefficient of degree 16 of a number that lacks so much at an end, or nothing below zero: that is the coefficient of degree 8, and
    /// more.
    #[inline(always)]
    fn left(&self, defect: T) -> T {
        let defect = defect.max(T::from_f64(0.0));
        let of_four = (self.decay_squared * self.decay_squared) * (self.decay_squared * self.decay_squared);
        self.square.max(defect * defect) * (of_four * of_four)
    }

    /// Sum of this coefficient and those that follow.
    #[inline(always)]
    fn to_come(&self) -> T {
        self.square.sqrt() / (T::from_f64(1.0) - self.decay_squared.sqrt()).max(T::from_f64(f64::MIN_POSITIVE))
    }
}

/// What a size is multiplied by from one to the next, at most 1: also of two that vanish.
#[inline(always)]
fn decay<T: Scalar>(from: T, to: T) -> T {
    let least = T::from_f64(f64::MIN_POSITIVE);
    ((to + least) / (from + least)).min(T::from_f64(1.0))
}

/// The larger one of two neighbours.
#[inline(always)]
fn larger<T: Scalar>(sizes: &[T; N], m: usize) -> T {
    sizes[m].max(sizes[m + 1])
}

/// Each coefficient is smaller by the same factor, which stands behind it: that of the last four degrees, since coefficients between may be
/// small by chance.
#[inline(always)]
fn next_by_one_decay<T: Scalar>(sizes: &[T; N]) -> Next<T> {
    let (first, last) = (larger(sizes, 2), larger(sizes, 6));
    Next::new(sizes, decay(first, last).sqrt())
}

/// Each coefficient is smaller by the same factor, which stands behind it, or by a factor that grows as it did, where a force is less smooth than what
/// stands out in the first coefficients: as far as the slopes at an end lack it, where that is known, and it is not infinite. Those of even or odd degree may be
/// small by symmetry.
#[inline(always)]
fn next_by_two_decays<T: Scalar>(sizes: &[T; N], lacks: T) -> Next<T> {
    let (first, earlier, later) = (larger(sizes, 2), larger(sizes, 4), larger(sizes, 6));
    // over two degrees
    let (before, last) = (decay(first, earlier), decay(earlier, later));
    let slower = (last * last / before).min(T::from_f64(1.0)).max(last);
    Next::new(sizes, slower.min((lacks / later).max(last)))
}

/// The size of the Legendre coefficient of degree 8, and of each over the one before: [`next_by_two_decays`].
pub(super) fn next_coefficient(sizes: &[f64; N], lacks: f64) -> (f64, f64) {
    let Next { square, decay_squared } = next_by_two_decays(sizes, lacks);
    (square.sqrt(), decay_squared.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::gauss::lanes;

    /// Legendre polynomials at the ends of a step.
    const AT_START: Eight = Lanes([1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
    const AT_END: Eight = Lanes([1.0; N]);

    fn error_of_slopes(
        coefficients: &[Eight],
        weights: &[f64],
        sizes: &[f64; N],
        at_start: &[f64],
        steepness: f64,
    ) -> [f64; 2] {
        StepError::new(weights.len()).of_slopes(coefficients, weights, sizes, at_start, steepness)
    }

    /// Rounding of some twenty operations.
    const ROUNDING_OF_SUMS: f64 = 1e-14;

    /// Legendre coefficients that fall by `decay` from the last one, of this size.
    fn falling(decay: f64, last: f64) -> [f64; N] {
        std::array::from_fn(|m| last * decay.powi(m as i32 - (N as i32 - 1)))
    }

    #[test]
    fn analytic_coefficients_that_fall_by_a_factor_go_on_so() {
        let (next, decay) = next_coefficient(&falling(0.1, 4.0), f64::INFINITY);
        assert!((next / 0.4 - 1.0).abs() <= ROUNDING_OF_SUMS && (decay / 0.1 - 1.0).abs() <= ROUNDING_OF_SUMS);
    }

    /// From 1e6 over 1 to 1e-3 in steps of two degrees: by 1e-3, then by 10^-1.5 a degree. The latter is 10^1.5 times as large as the one before, and
    /// the next one would be 1.
    #[test]
    fn analytic_coefficients_that_fall_ever_more_slowly_go_on_so() {
        let sizes = [1e9, 1e9, 1e6, 1e6, 1.0, 1.0, 1e-3, 1e-3];
        let (next, decay) = next_coefficient(&sizes, f64::INFINITY);
        assert!((decay - 1.0).abs() <= ROUNDING_OF_SUMS, "{decay}");
        assert!((next / 1e-3 - 1.0).abs() <= ROUNDING_OF_SUMS, "{next}");
    }

    /// The same where slopes at the start lack a tenth of the last coefficients, so that those two degrees later are that; and where they lack nothing, so
    /// that coefficients fall as they did last.
    #[test]
    fn analytic_fall_that_slows_down_is_believed_as_far_as_the_start_shows_it() {
        let sizes = [1e9, 1e9, 1e6, 1e6, 1.0, 1.0, 1e-3, 1e-3];
        for (lacks, over_two) in [(1e-4_f64, 0.1), (0.0, 1e-3), (-1.0, 1e-3), (1.0, 1.0)] {
            let (next, decay) = next_coefficient(&sizes, lacks);
            assert!((decay * decay / over_two - 1.0).abs() <= ROUNDING_OF_SUMS, "{lacks}: {decay}");
            assert!((next / (1e-3 * decay) - 1.0).abs() <= ROUNDING_OF_SUMS, "{lacks}: {next}");
        }
    }

    /// A slope of c · P_8 is 0 at all nodes and c at the start.
    #[test]
    fn analytic_slope_that_vanishes_at_all_nodes_is_seen_at_the_start() {
        let zero = [Eight::from_f64(0.0)];
        let [error, next] = error_of_slopes(&zero, &[1.0], &[0.0; N], &[1e3], 0.0);
        assert!((next / (1e3 - 0.1) - 1.0).abs() <= ROUNDING_OF_SUMS, "{next}");
        // nothing says that what follows is smaller
        assert!((error / (next / 17.0) - 1.0).abs() <= ROUNDING_OF_SUMS, "{error}");
    }

    /// A force that jumps within the step: its coefficients do not fall, and what they leave at the end is not hidden by slopes a million times as large that
    /// are smooth. Nothing depends on the state.
    #[test]
    fn analytic_number_that_jumps_beside_larger_smooth_ones_is_off_by_its_own_coefficients() {
        let coefficients = [Lanes(falling(0.01, 1e-8)), Lanes([50.0; N])];
        let start = coefficients.map(|of| lanes::sum(&AT_START, &of));
        let weights = [1.0; 2];
        let sizes = lanes::sizes(&coefficients, &weights);
        let [error, _] = error_of_slopes(&coefficients, &weights, &sizes, &start, 0.0);
        assert!((error / (50.0 / 17.0) - 1.0).abs() <= ROUNDING_OF_SUMS, "{error}");
    }

    /// By 0.1 a degree from 1 at degree 7 on, also where two of the coefficients before it are small by chance.
    #[test]
    fn analytic_coefficient_of_degree_16_follows_from_those_that_are_known() {
        for small in [None, Some(4)] {
            let mut sizes = falling(0.1, 1.0);
            small.into_iter().for_each(|m| sizes[m..m + 2].fill(1e-3));
            let left = next_by_one_decay(&sizes).left(0.0).sqrt();
            assert!((left / 1e-9 - 1.0).abs() <= ROUNDING_OF_SUMS, "{small:?}: {left}");
        }
    }

    /// Coefficients that fall by 0.1 from 1e-6 on: those to come add up to 1e-7/0.9. Ten times as much at the end is no surprise; what is more lasts from the
    /// last node on, for the 0.01986th part of the step (Abramowitz and Stegun 1972, table 25.4).
    #[test]
    fn analytic_jump_behind_the_last_node_is_seen_at_the_end() {
        let falls = falling(0.1, 1e-6);
        let to_come = 1e-7 / 0.9;
        let error_of = |sizes: [f64; N], lacks_at_start: f64, lacks: f64| {
            let coefficients = [Lanes(sizes)];
            let start = [lanes::sum(&AT_START, &coefficients[0]) + lacks_at_start];
            let end = [lanes::sum(&AT_END, &coefficients[0]) + lacks];
            let mut step = StepError::new(1);
            step.of_slopes(&coefficients, &[1e9], &[0.0; N], &start, 0.0);
            step.by_end(&end)
        };
        let error = |sizes: [f64; N], lacks: f64| error_of(sizes, 0.0, lacks);
        // but for what it leaves at degree 16
        assert!(error(falls, 9.9 * to_come) < 1e9 * 9.9 * to_come * 0.1_f64.powi(8) / 17.0);
        let expected = 0.019_855_071_751_231_9 * (1e9 * 10.0 * to_come - OF_SWEEPS);
        assert!((error(falls, 20.0 * to_come) / expected - 1.0).abs() <= 1e-6, "{}", error(falls, 20.0 * to_come));
        // as much at the start: the slopes are smooth, and only what they leave at degree 16 counts
        let left = 1e9 * 20.0 * to_come * 0.1_f64.powi(8) / 17.0;
        assert!(error_of(falls, -20.0 * to_come, 20.0 * to_come) < left);
        // of a steady force nothing tells that what is to come falls
        let steady = error([1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 1e-3);
        assert!((steady / ((1e6 - 2.0 * OF_SWEEPS) / 17.0) - 1.0).abs() <= 1e-6, "{steady}");
    }

    /// A light number whose coefficients do not fall, beside a heavy one a million times as large whose coefficients do.
    #[test]
    fn invariant_fast_number_beside_slow_heavy_ones_counts() {
        let heavy = Lanes(falling(0.01, 1e-6));
        let light = Lanes(falling(0.5, 1e3));
        let weights = [1.0, 1.0];
        let both = [heavy, light];
        let start = both.map(|coefficients| lanes::sum(&AT_START, &coefficients));
        let error = |coefficients: &[Eight]| {
            error_of_slopes(coefficients, &weights, &lanes::sizes(coefficients, &weights), &start, 1.0)[0]
        };
        // of its own coefficient of degree 8 over its first one, 2^-8, the end sees the 17th part, times what comes next: 500
        assert!(error(&both) >= 500.0 * 0.5_f64.powi(8) / 17.0, "{}", error(&both));
    }

    /// The ninth number stands in lanes of its own: it counts as it does alone.
    #[test]
    fn invariant_error_of_many_numbers_is_that_of_the_one_that_moves() {
        let rough = Lanes(falling(0.5, 1e3));
        let [alone, ninth] = [1, 9].map(|n| {
            let mut coefficients = vec![Eight::from_f64(0.0); n];
            coefficients[n - 1] = rough;
            let weights = vec![1.0; n];
            let start: Vec<f64> = coefficients.iter().map(|of| lanes::sum(&AT_START, of)).collect();
            let mut end: Vec<f64> = coefficients.iter().map(|of| lanes::sum(&AT_END, of)).collect();
            end[n - 1] += 1e9;
            let mut step = StepError::new(n);
            let sizes = lanes::sizes(&coefficients, &weights);
            let [error, next] = step.of_slopes(&coefficients, &weights, &sizes, &start, 1.0);
            [error, next, step.by_end(&end)]
        });
        assert!(alone == ninth && alone.iter().all(|error| *error > 0.1), "{alone:?} {ninth:?}");
    }

    /// Changes of the state by less than the tolerance make no step shorter, be they as rough as rounding.
    #[test]
    fn invariant_number_that_hardly_moves_does_not_count() {
        let smooth = Lanes(falling(0.1, 1e2));
        let rough = Lanes([1e-7; N]);
        let error = |coefficients: &[Eight]| {
            let start: Vec<f64> = coefficients.iter().map(|of| lanes::sum(&AT_START, of)).collect();
            let weights = vec![1.0; coefficients.len()];
            error_of_slopes(coefficients, &weights, &lanes::sizes(coefficients, &weights), &start, 1.0)[0]
        };
        let more = error(&[smooth, rough]) - error(&[smooth]);
        // of the smooth one 1e2 · 0.1 comes next; relative to its own size the rough number would add 10/17
        assert!(more > 0.0 && more <= 10.0 * 1e-7 / 17.0, "{more}");
    }
}
