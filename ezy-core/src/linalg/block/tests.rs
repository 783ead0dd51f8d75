use super::two::{Number as _, Two};
use super::*;
use crate::linalg::tests::Numbers;

/// What is no number is kept: it ends an elimination.
#[test]
fn analytic_numbers_below_a_size_are_zero() {
    let kept = |x: f64| Two::new([x, 5.0]).or_zero_below(Two::from_f64(2.0)).lanes();
    for (x, expected) in [(1.0, 0.0), (-1.0, 0.0), (2.0, 2.0), (-3.0, -3.0)] {
        assert_eq!(kept(x), [expected, 5.0]);
    }
    assert!(kept(f64::NAN)[0].is_nan());
}

/// Two rows of one body that are `angle` apart, so that the second pivot is sin²: x = 0, whatever pushes, and y with the digits that the
/// angle has. Where the pivot is not small nothing is spent on it.
#[test]
fn analytic_small_pivots_cost_no_digits() {
    const ROWS: SparsityPattern = SparsityPattern::new(&[0, 3, 6], &[0, 1, 2, 0, 1, 2]);
    let mut kkt = BlockKkt::<Full, 2, 6>::new(&[1.0; 3], &ROWS, &Plan::new(3, &ROWS, 2).unwrap());
    for (angle, refines) in [(0.5_f64, false), (0.1, false), (1e-2, true), (1e-4, true)] {
        let (sin, cos) = angle.sin_cos();
        kkt.factor(&[1.0, 0.0, 0.0, cos, sin, 0.0]).unwrap();
        assert_eq!(kkt.refines, refines, "{angle}");
        // y_2 sin = 3, and y_1 + y_2 cos = 2
        let mut x = [2.0, 3.0, 0.0, 0.0, 0.0];
        let (r, s) = x.split_at_mut(3);
        kkt.solve(r, s);
        let second = 3.0 / sin;
        let first = 2.0 - second * cos;
        let lost = ((x[4] - second) / second).abs().max(((x[3] - first) / first).abs());
        let bound = f64::EPSILON * if refines { 8.0 / angle } else { 8.0 / (sin * sin) };
        assert!(lost <= bound && x[0].abs().max(x[1].abs()) <= 6.0 * bound, "{angle}: {lost:e}, {x:?}");
    }
}

/// Inverse and pivots by L D Lᵀ, one row after the other.
fn by_rows<const B: usize>(block: &Block<B>) -> (Block<B>, Column<B>) {
    let (mut lower, mut pivots, mut inverse) = (*block, [0.0; B], [[0.0; B]; B]);
    for j in 0..B {
        pivots[j] = lower[j][j];
        let column = lower[j];
        for i in j + 1..B {
            lower[j][i] = column[i] / pivots[j];
            (i..B).for_each(|c| lower[i][c] -= lower[j][i] * column[c]);
        }
    }
    for (c, x) in inverse.iter_mut().enumerate() {
        x[c] = 1.0;
        (c + 1..B).for_each(|i| x[i] -= (c..i).map(|j| lower[j][i] * x[j]).sum::<f64>());
        for i in (0..B).rev() {
            x[i] = x[i] / pivots[i] - (i + 1..B).map(|j| lower[i][j] * x[j]).sum::<f64>();
        }
    }
    (inverse, pivots)
}

/// Of some tens of operations with entries of one.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

fn largest<const B: usize>(block: &Block<B>) -> f64 {
    block.as_flattened().iter().fold(0.0, |largest, x| x.abs().max(largest))
}

/// Of G W Gᵀ with mobilities that differ by up to 1e10, the inverse and the pivots are those that rows give one after the other, and the
/// block times its inverse is one.
fn assert_inverts<const B: usize, const N: usize>(numbers: &mut Numbers) {
    for trial in 0..2_000 {
        let root: [f64; N_OF_BODY] = from_fn(|_| 10_f64.powf(f64::from(trial % 6) * 0.5 * numbers.next()));
        let slot: [f64; N] = from_fn(|i| root[i / B] * numbers.next());
        let block: Block<B> = Full::product(&slot, &slot);
        let start = from_fn(|r| block[r][r]);
        let Fraction { numerator, denominator, pivots } = Fraction::inverse(&block, &start);
        let inverse = times(&numerator, 1.0 / denominator);
        let (expected, of_rows) = by_rows(&block);
        let mut smallest = 1.0_f64;
        for r in 0..B {
            let relative = of_rows[r] / start[r];
            assert!((pivots[r] - relative).abs() <= ROUNDING / smallest, "{block:?}: {pivots:?}, {of_rows:?}");
            smallest = smallest.min(relative);
        }
        if smallest <= PIVOT_TOLERANCE {
            continue;
        }
        // rows of different size: each in units of its own
        let scaled = |block: &Block<B>, power: f64| -> Block<B> {
            from_fn(|c| from_fn(|r| block[c][r] * (start[c] * start[r]).powf(power)))
        };
        let [inverse, expected, block] = [scaled(&inverse, 0.5), scaled(&expected, 0.5), scaled(&block, -0.5)];
        // rounding of a block of ones, through the inverse
        let size = largest(&expected);
        for c in 0..B {
            let product = apply(&block, &inverse[c]);
            for r in 0..B {
                assert!(
                    (inverse[c][r] - expected[c][r]).abs() <= ROUNDING * size * size,
                    "{block:?}: {inverse:?} {expected:?}"
                );
                let one = f64::from(u8::from(r == c));
                assert!((product[r] - one).abs() <= ROUNDING * size, "{block:?}: {product:?}");
            }
        }
    }
}

#[test]
fn cross_inverses_of_blocks_are_those_by_rows() {
    let mut numbers = Numbers(12);
    assert_inverts::<1, 3>(&mut numbers);
    assert_inverts::<2, 6>(&mut numbers);
    assert_inverts::<3, 9>(&mut numbers);
}

/// A body of inertia δ, welded with a lever: the block is 1 + g gᵀ/δ, its inverse 1 − g gᵀ/(δ + g²). Both last pivots are as small as δ,
/// and only one of them costs digits.
#[test]
fn analytic_a_weld_with_a_lever_loses_one_pivot() {
    let g = [0.5, -0.75, 1.0];
    let square: f64 = g.iter().map(|g| g * g).sum();
    for delta in [1.0, 1e-3, 1e-6, 1e-10] {
        let one = |r: usize, c: usize| f64::from(u8::from(r == c));
        let block: Block<3> = from_fn(|c| from_fn(|r| one(r, c) + g[r] * g[c] / delta));
        let start = from_fn(|r| block[r][r]);
        let Fraction { numerator, denominator, .. } = Fraction::inverse(&block, &start);
        let inverse = times(&numerator, 1.0 / denominator);
        for c in 0..3 {
            for r in 0..3 {
                let expected = one(r, c) - g[r] * g[c] / (delta + square);
                let error = (inverse[c][r] - expected).abs();
                assert!(error <= ROUNDING * (1.0 + 1.0 / delta), "{delta:e}: {error:e}");
            }
        }
    }
}

/// Masses whose squares no number holds are refused, as a pivot of the last row.
#[test]
fn invariant_blocks_out_of_the_range_of_numbers_are_refused() {
    const ROWS: SparsityPattern = SparsityPattern::new(&[0, 2, 4], &[0, 2, 1, 2]);
    for (mass, is_taken) in [(1e150, true), (1e-150, true), (1e160, false), (1e-160, false), (f64::NAN, false)] {
        let mut kkt = BlockKkt::<Full, 2, 6>::new(&[mass; 3], &ROWS, &Plan::new(3, &ROWS, 2).unwrap());
        let factored = kkt.factor(&[1.0, 0.5, 1.0, 0.5]);
        assert_eq!(factored.is_ok(), is_taken, "{mass:e}: {factored:?}");
    }
}
