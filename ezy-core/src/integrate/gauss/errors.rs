//! The error of a step, from the Legendre coefficients of its slopes and from what these are at its ends.

use super::lanes;
use super::tableau::{N, NODES};
use crate::integrate::tolerances::gauss::{OF_SWEEPS, ROUNDING, UNEXPECTED};
use crate::model::Eight;
use crate::scalar::{Lanes, Scalar};

/// Legendre polynomials at the ends of a step.
const AT_START: Eight = Lanes([1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
const AT_END: Eight = Lanes([1.0; N]);

/// 15!! = 15 · 13 · … · 1
const DOUBLE_FACTORIAL_OF_15: f64 = 2_027_025.0;

/// The error of the end of a step over the tolerance, and the size of the Legendre coefficient of degree 8 of its slopes.
///
/// Between the nodes the equations are not met: by the polynomial P_8 times the coefficient that comes next, and what follows. The
/// end of the step is off by the integral of that, times what a change of a slope at each time makes of the end. That factor
/// is smooth, too, so that P_8 sees of it only its own coefficient of degree 8: of the linear motion z^8/(2^8 15!!), of the change of its
/// rate over the step as much as of the slopes of the number that is least smooth, and where slopes do not depend on the state what their own
/// coefficients leave: of all of them together, and of each one, be it far smaller than another one that is smooth.
///
/// The slopes at the start of the step are known: what the polynomial lacks there is the sum of all coefficients to come. Where
/// it is more than predicted, coefficients fall as much more slowly.
pub(super) fn error_of_slopes(
    coefficients: &[Eight],
    weights: &[f64],
    sizes: &[f64; N],
    at_start: &[f64],
    steepness: f64,
) -> [f64; 2] {
    let (mut next, mut decay) = next_coefficient(sizes);
    let (mut defect, mut own) = (0.0_f64, 0.0_f64);
    // squares of the coefficient of degree 8 of the number that is least smooth, and of its largest one
    let mut roughest = [0.0, 1.0];
    for ((coefficients, weight), at_start) in coefficients.iter().zip(weights).zip(at_start) {
        let lacks = weight * (lanes::sum(&AT_START, coefficients) - at_start).abs();
        defect = defect.max(lacks);
        let sizes = (coefficients.abs() * Eight::from_f64(*weight)).0;
        // what changes a number by less than its tolerance changes no other
        let largest = sizes.iter().copied().fold(1.0, f64::max).powi(2);
        let next = next_by_two_decays(&sizes).square;
        if next * roughest[1] > roughest[0] * largest {
            roughest = [next, largest];
        }
        own = own.max(next_by_one_decay(&sizes).left(lacks - OF_SWEEPS));
    }
    // sweeps leave a part of the tolerance
    defect -= OF_SWEEPS;
    if defect > next {
        decay = (decay * defect / next.max(f64::MIN_POSITIVE)).min(1.0);
        next = defect;
    }
    let linear = (0.5 * steepness).powi(N as i32) / DOUBLE_FACTORIAL_OF_15;
    let seen = linear + steepness * (roughest[0] / roughest[1]).sqrt() + decay.powi(N as i32);
    [(next * seen).max(own.sqrt() - rounding_of(sizes)) / (2.0 * N as f64 + 1.0), next]
}

/// The error of the end of a step over the tolerance by the slopes there. A force that changes behind the last node is seen by nothing else: what the
/// polynomial lacks at the end, beyond many times what its coefficients tell and what it lacks at the start, it lacks from that node on. Of smooth slopes it lacks
/// as much at both ends, where P_8 is 1, also where the last coefficients are small by chance.
pub(super) fn error_at_end(
    coefficients: &[Eight],
    weights: &[f64],
    sizes: &[f64; N],
    at_start: &[f64],
    at_end: &[f64],
) -> f64 {
    let rounding = OF_SWEEPS + rounding_of(sizes);
    let (mut unexpected, mut own) = (0.0_f64, 0.0_f64);
    let ends = at_start.iter().zip(at_end);
    for ((coefficients, weight), (at_start, at_end)) in coefficients.iter().zip(weights).zip(ends) {
        let defect = weight * (lanes::sum(&AT_END, coefficients) - at_end).abs() - rounding;
        let next = next_by_one_decay(&(coefficients.abs() * Eight::from_f64(*weight)).0);
        own = own.max(next.left(defect));
        // what is to come is more than what comes next, which needs no roots
        if defect > unexpected && defect * defect > UNEXPECTED * UNEXPECTED * next.square {
            let lacks = weight * (lanes::sum(&AT_START, coefficients) - at_start).abs();
            unexpected = unexpected.max(defect - UNEXPECTED * next.to_come().max(lacks));
        }
    }
    ((1.0 - NODES.0[N - 1]) * unexpected).max((own.sqrt() - rounding) / (2.0 * N as f64 + 1.0))
}

/// What rounding leaves of slopes whose Legendre coefficients are of these sizes at most.
fn rounding_of(sizes: &[f64; N]) -> f64 {
    ROUNDING * sizes.iter().copied().fold(0.0, f64::max)
}

/// The square of the Legendre coefficient of degree 8, which is not known, by those of lower degrees: so one root is taken in the end, and not one a number.
struct Next {
    square: f64,
    /// Square of each coefficient over the one before.
    decay_squared: f64,
}

impl Next {
    fn new(sizes: &[f64; N], decay_squared: f64) -> Self {
        let square = decay_squared * (sizes[7] * sizes[7]).max(decay_squared * sizes[6] * sizes[6]);
        Self { square, decay_squared }
    }

    /// The square of the coefficient of degree 16 of a number that lacks so much at an end, or nothing below zero: that is the coefficient of degree 8, and
    /// more.
    fn left(&self, defect: f64) -> f64 {
        self.square.max(defect.max(0.0).powi(2)) * self.decay_squared.powi(N as i32)
    }

    /// Sum of this coefficient and those that follow.
    fn to_come(&self) -> f64 {
        if self.square > 0.0 { self.square.sqrt() / (1.0 - self.decay_squared.sqrt()) } else { 0.0 }
    }
}

/// Of one number. Each coefficient is smaller by the same factor, which stands behind it: that of the last four degrees, since coefficients between may be
/// small by chance.
fn next_by_one_decay(sizes: &[f64; N]) -> Next {
    let [first, last] = [2, 6].map(|m| sizes[m].max(sizes[m + 1]));
    Next::new(sizes, if first > last { (last / first).sqrt() } else { 1.0 })
}

/// Each coefficient is smaller by the same factor, which stands behind it, or by a factor that grows as it did, where a force is less smooth than what
/// stands out in the first coefficients. Those of even or odd degree may be small by symmetry.
fn next_by_two_decays(sizes: &[f64; N]) -> Next {
    let [first, earlier, later] = [2, 4, 6].map(|m| sizes[m].max(sizes[m + 1]));
    // over two degrees
    let decay = |from: f64, to: f64| if from > to { to / from } else { 1.0 };
    let (before, last) = (decay(first, earlier), decay(earlier, later));
    Next::new(sizes, if last > before { (last * last / before).min(1.0) } else { last })
}

/// The size of the Legendre coefficient of degree 8, and of each over the one before: [`next_by_two_decays`].
pub(super) fn next_coefficient(sizes: &[f64; N]) -> (f64, f64) {
    let Next { square, decay_squared } = next_by_two_decays(sizes);
    (square.sqrt(), decay_squared.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of some twenty operations.
    const ROUNDING_OF_SUMS: f64 = 1e-14;

    /// Legendre coefficients that fall by `decay` from the last one, of this size.
    fn falling(decay: f64, last: f64) -> [f64; N] {
        std::array::from_fn(|m| last * decay.powi(m as i32 - (N as i32 - 1)))
    }

    #[test]
    fn analytic_coefficients_that_fall_by_a_factor_go_on_so() {
        let (next, decay) = next_coefficient(&falling(0.1, 4.0));
        assert!((next / 0.4 - 1.0).abs() <= ROUNDING_OF_SUMS && (decay / 0.1 - 1.0).abs() <= ROUNDING_OF_SUMS);
    }

    /// From 1e6 over 1 to 1e-3 in steps of two degrees: by 1e-3, then by 10^-1.5 a degree. The latter is 10^1.5 times as large as the one before, and
    /// the next one would be 1.
    #[test]
    fn analytic_coefficients_that_fall_ever_more_slowly_go_on_so() {
        let sizes = [1e9, 1e9, 1e6, 1e6, 1.0, 1.0, 1e-3, 1e-3];
        let (next, decay) = next_coefficient(&sizes);
        assert!((decay - 1.0).abs() <= ROUNDING_OF_SUMS, "{decay}");
        assert!((next / 1e-3 - 1.0).abs() <= ROUNDING_OF_SUMS, "{next}");
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
            error_at_end(&coefficients, &[1e9], &[0.0; N], &start, &end)
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

    /// Changes of the state by less than the tolerance make no step shorter, be they as rough as rounding.
    #[test]
    fn invariant_number_that_hardly_moves_does_not_count() {
        let smooth = Lanes(falling(0.01, 1e3));
        let rough = Lanes([1e-9; N]);
        let error = |coefficients: &[Eight]| {
            let start: Vec<f64> = coefficients.iter().map(|of| lanes::sum(&AT_START, of)).collect();
            let weights = vec![1.0; coefficients.len()];
            error_of_slopes(coefficients, &weights, &lanes::sizes(coefficients, &weights), &start, 1.0)[0]
        };
        let more = error(&[smooth, rough]) - error(&[smooth]);
        // of the smooth one 1e3 · 0.01 comes next; relative to its own size the rough number would add 10/17
        assert!(more <= 10.0 * 1e-9 / 17.0 * (1.0 + ROUNDING_OF_SUMS), "{more}");
    }
}
