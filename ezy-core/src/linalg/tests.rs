//! Each solver on random systems, put into the equations that it solves, and solutions that are known.

use super::damped::{weights, write_diagonal};
use super::equation_residual::EquationResidual;
use super::*;
use crate::model::SparsityPattern;
use nalgebra::{Complex, ComplexField};

const ALL: Independent<'static> = Independent::Above(INDEPENDENT);

/// A few tens of operations on numbers of one, with pivots of a hundredth at least.
const ROUNDING: f64 = 1e-11;

/// Numbers between -1 and 1 that repeat (Knuth, MMIX).
pub(super) struct Numbers(pub(super) u64);

impl Numbers {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Away from zero, of either sign.
    fn entry(&mut self) -> f64 {
        let x = self.next();
        x.signum() * (0.2 + x.abs())
    }

    fn vector(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }
}

/// Rows that touch the given columns.
fn pattern(rows: &[&[usize]]) -> SparsityPattern {
    let mut starts = vec![0];
    rows.iter().for_each(|row| starts.push(starts[starts.len() - 1] + row.len() as u32));
    SparsityPattern::of(starts, rows.concat().iter().map(|column| *column as u32).collect())
}

/// Replaces `[r; s]` by `[x; y]`.
fn solve(kkt: &mut dyn KktFactorization, n_q: usize, both: &mut [f64]) {
    let (r, s) = both.split_at_mut(n_q);
    kkt.solve(r, s);
}

/// `[r; s] − [M Gᵀ; G −Δ] [x; y]`, the largest entry.
fn left(pattern: &SparsityPattern, mass: &[f64], jacobian: &[f64], damping: &[f64], right: &[f64], x: &[f64]) -> f64 {
    let n_q = mass.len();
    let mut left = right.to_vec();
    mass.iter().enumerate().for_each(|(i, m)| left[i] -= m * x[i]);
    damping.iter().enumerate().for_each(|(i, d)| left[n_q + i] += d * x[n_q + i]);
    for (k, row, column) in pattern.entries() {
        left[column] -= jacobian[k] * x[n_q + row];
        left[n_q + row] -= jacobian[k] * x[column];
    }
    left.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

/// Chains, stars and loops of bodies on a line.
fn systems() -> Vec<SparsityPattern> {
    vec![
        pattern(&[&[0]]),
        pattern(&[&[0, 1], &[1, 2], &[2, 3]]),
        pattern(&[&[0, 1], &[0, 2], &[0, 3], &[0, 4]]),
        pattern(&[&[3, 0], &[1, 3], &[2, 0, 4], &[4, 1, 5]]),
        pattern(&[&[0, 1, 2], &[3, 4, 5], &[0, 3, 6], &[1, 4, 6], &[2, 5]]),
    ]
}

#[test]
fn invariant_sparse_solutions_fulfil_their_equations() {
    let mut numbers = Numbers(1);
    for pattern in systems() {
        let (n_q, n_rows) = (7, pattern.n_rows());
        for _ in 0..20 {
            let mass: Vec<f64> = numbers.vector(n_q).iter().map(|x| 1.5 + x).collect();
            let mut kkt = SparseKkt::new(&mass, &pattern, n_rows).unwrap();
            let jacobian: Vec<f64> = (0..pattern.n_nonzeros()).map(|_| numbers.entry()).collect();
            let right = numbers.vector(n_q + n_rows);
            kkt.factor(&jacobian).unwrap();
            let mut x = right.clone();
            solve(&mut kkt, n_q, &mut x);
            let found = left(&pattern, &mass, &jacobian, &[], &right, &x);
            assert!(found <= ROUNDING, "{pattern:?}: {found:e}");
            let damping: Vec<f64> = numbers.vector(n_rows).iter().map(|x| 1.1 + x).collect();
            kkt.factor_damped(&jacobian, &damping).unwrap();
            let mut x = right.clone();
            solve(&mut kkt, n_q, &mut x);
            let found = left(&pattern, &mass, &jacobian, &damping, &right, &x);
            assert!(found <= ROUNDING, "{pattern:?}, damped: {found:e}");
        }
    }
}

/// Bodies of three coordinates that joints hold: chains, trees, closed loops, nets, with one, two and three rows, some of one body alone.
fn mechanisms() -> Vec<Vec<(usize, Vec<usize>)>> {
    vec![
        vec![(2, vec![0])],
        (0..9).map(|i| (2, if i == 0 { vec![0] } else { vec![i - 1, i] })).collect(),
        // loose at both ends, with one to three rows; and numbered inwards
        (0..8).map(|i| (2, vec![i, i + 1])).collect(),
        (0..7).map(|i| (1, vec![i, i + 1])).collect(),
        (0..6).map(|i| (3, vec![i, i + 1])).collect(),
        vec![(2, vec![0, 2]), (2, vec![2, 4]), (2, vec![4, 5]), (2, vec![3, 5]), (2, vec![1, 3]), (2, vec![1])],
        legs(&[5, 4, 4, 2, 1, 1]),
        vec![(2, vec![0, 3]), (3, vec![1, 3]), (1, vec![3, 2]), (1, vec![2]), (2, vec![2, 4]), (2, vec![4, 5])],
        vec![(2, vec![0]), (2, vec![0, 1]), (2, vec![1, 2]), (2, vec![2]), (1, vec![5, 6])],
        // two joints between the same bodies, which are not one behind the other
        vec![(2, vec![0, 1]), (1, vec![1, 2]), (1, vec![0, 1]), (1, vec![0, 3]), (2, vec![3, 4])],
        // a branch, and a closed loop
        vec![(2, vec![0]), (2, vec![0, 1]), (2, vec![0, 2]), (2, vec![2, 3]), (2, vec![2, 4]), (2, vec![4])],
        // two hinges between the same bodies
        vec![(2, vec![0, 1]), (2, vec![1, 2]), (2, vec![0, 1])],
        net(4),
    ]
}

/// Legs of so many joints about one body.
fn legs(lengths: &[usize]) -> Vec<(usize, Vec<usize>)> {
    let mut joints = Vec::new();
    for &length in lengths {
        let first = 1 + joints.len();
        joints.extend((first..first + length).map(|body| (2, vec![if body == first { 0 } else { body - 1 }, body])));
    }
    joints
}

/// Knots in a square of n × n that rods join.
fn net(n: usize) -> Vec<(usize, Vec<usize>)> {
    let at = |i: usize, j: usize| n * i + j;
    let along = (0..n).flat_map(|i| (1..n).map(move |j| (1, vec![at(i, j - 1), at(i, j)])));
    let across = (1..n).flat_map(|i| (0..n).map(move |j| (1, vec![at(i - 1, j), at(i, j)])));
    along.chain(across).collect()
}

/// Patterns of G of the mechanisms: with entries of all coordinates, and, where each joint has two rows, with those of hinges.
fn patterns() -> impl Iterator<Item = (Vec<(usize, Vec<usize>)>, SparsityPattern)> {
    mechanisms().into_iter().flat_map(|joints| {
        let of_hinges = joints.iter().all(|(n, _)| *n == 2).then(|| {
            let row = |bodies: &[usize], r: usize| bodies.iter().flat_map(|b| [3 * b + r, 3 * b + 2]).collect();
            let rows: Vec<Vec<usize>> =
                joints.iter().flat_map(|(_, bodies)| [row(bodies, 0), row(bodies, 1)]).collect();
            pattern(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
        });
        let all = pattern_of(&joints);
        std::iter::once(all).chain(of_hinges).map(move |pattern| (joints.clone(), pattern))
    })
}

/// Entries of all coordinates of the bodies of a joint.
fn pattern_of(joints: &[(usize, Vec<usize>)]) -> SparsityPattern {
    let columns = |bodies: &[usize]| -> Vec<usize> { bodies.iter().flat_map(|b| 3 * b..3 * b + 3).collect() };
    let rows: Vec<Vec<usize>> = joints.iter().flat_map(|(n, bodies)| vec![columns(bodies); *n]).collect();
    pattern(&rows.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

/// Over blocks as by the general sparse solver, which takes the unknowns one by one; and both fulfil the equations.
#[test]
fn cross_blocks_of_joints_give_what_the_sparse_factors_give() {
    let mut numbers = Numbers(11);
    for (joints, pattern) in patterns() {
        let n_rows = pattern.n_rows();
        let n_q = 3 * (1 + joints.iter().flat_map(|of| &of.1).max().unwrap());
        for _ in 0..20 {
            let mass: Vec<f64> = numbers.vector(n_q).iter().map(|x| 1.5 + x).collect();
            let mut blocks = by_joints(&mass, &pattern, n_rows).unwrap();
            let mut sparse = SparseKkt::new(&mass, &pattern, n_rows).unwrap();
            let jacobian: Vec<f64> = (0..pattern.n_nonzeros()).map(|_| numbers.entry()).collect();
            let right = numbers.vector(n_q + n_rows);
            let damping: Vec<f64> = numbers.vector(n_rows).iter().map(|x| 1.1 + x).collect();
            for damping in [None, Some(&damping)] {
                let found = [&mut *blocks, &mut sparse as &mut dyn KktFactorization].map(|kkt| {
                    match damping {
                        None => kkt.factor(&jacobian).unwrap(),
                        Some(damping) => kkt.factor_damped(&jacobian, damping).unwrap(),
                    }
                    let mut x = right.clone();
                    solve(kkt, n_q, &mut x);
                    x
                });
                if damping.is_none() {
                    let mut at_once = right.clone();
                    let (r, s) = at_once.split_at_mut(n_q);
                    blocks.factor_and_solve(&jacobian, r, s).unwrap();
                    assert_eq!(at_once, found[0], "{joints:?}");
                }
                let none = Vec::new();
                for x in &found {
                    let left = left(&pattern, &mass, &jacobian, damping.unwrap_or(&none), &right, x);
                    assert!(left <= ROUNDING * largest(x), "{joints:?}: {left:e}");
                }
                // rounding of some hundreds of operations, over the smallest pivot
                let scale = largest(&found[0]) / blocks.smallest_pivot();
                for (x, y) in found[0].iter().zip(&found[1]) {
                    assert!((x - y).abs() <= 500.0 * f64::EPSILON * scale, "{joints:?}: {x} {y}, {scale:e}");
                }
            }
        }
    }
}

/// Masses that differ by up to 1e10: what is left of an equation is rounding of its terms, times the
/// ratio of masses, over the smallest pivot.
#[test]
fn invariant_blocks_keep_their_equations_whatever_the_masses() {
    let mut numbers = Numbers(13);
    for (joints, pattern) in patterns() {
        let n_rows = pattern.n_rows();
        let n_q = 3 * (1 + joints.iter().flat_map(|of| &of.1).max().unwrap());
        let mut equations = EquationResidual::new(n_q, n_rows, &pattern);
        for trial in 0..60 {
            let decades = f64::from(trial % 6);
            let mass: Vec<f64> = (0..n_q).map(|_| 10_f64.powf(decades * numbers.next())).collect();
            let mut blocks = by_joints(&mass, &pattern, n_rows).unwrap();
            let jacobian: Vec<f64> = (0..pattern.n_nonzeros()).map(|_| numbers.entry()).collect();
            let right = numbers.vector(n_q + n_rows);
            blocks.factor(&jacobian).unwrap();
            let mut x = right.clone();
            solve(&mut *blocks, n_q, &mut x);
            equations.write(&mass, &jacobian, &right, &x);
            let ratio = mass.iter().fold(0.0_f64, |m, x| m.max(*x)) / mass.iter().fold(f64::MAX, |m, x| m.min(*x));
            let bound = 64.0 * f64::EPSILON * ratio / blocks.smallest_pivot();
            assert!(equations.share() <= bound, "{joints:?}: {:e}, {bound:e}", equations.share());
        }
    }
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(1.0, |largest, x| x.abs().max(largest))
}

/// Rows [1 0 0] and [cos sin 0] of one joint: what the first leaves of the second is sin². Where one repeats the other, its number is told.
#[test]
fn analytic_pivots_within_a_block_are_those_of_its_rows() {
    let pattern = pattern_of(&[(2, vec![1])]);
    let mut kkt = by_joints(&[4.0; 6], &pattern, 2).unwrap();
    for angle in [0.1_f64, 0.7, 1.5] {
        kkt.factor(&[1.0, 0.0, 0.0, angle.cos(), angle.sin(), 0.0]).unwrap();
        let expected = angle.sin().powi(2);
        assert!((kkt.smallest_pivot() - expected).abs() <= 1e-14, "{} {expected}", kkt.smallest_pivot());
    }
    let vanished = kkt.factor(&[1.0, 2.0, 0.0, 2.0, 4.0, 0.0]).expect_err("twice the first row");
    assert!(vanished.row == Some(1) && vanished.relative.abs() <= 1e-14, "{vanished:?}");
    assert!(kkt.factor(&[f64::NAN; 6]).is_err() && kkt.factor(&[0.0; 6]).is_err());
}

/// In a chain each joint in turn repeats a row of its own: its number is told, whether it is eliminated alone or beside another one.
#[test]
fn invariant_a_vanished_pivot_is_that_of_its_row() {
    let mut numbers = Numbers(17);
    let joints: Vec<(usize, Vec<usize>)> = (0..9).map(|i| (2, vec![i, i + 1])).collect();
    let pattern = pattern_of(&joints);
    let of_mass = |mass: f64| by_joints(&[mass; 30], &pattern, 18).unwrap();
    let mut kkt = of_mass(2.0);
    let jacobian: Vec<f64> = (0..pattern.n_nonzeros()).map(|_| numbers.entry()).collect();
    kkt.factor(&jacobian).unwrap();
    for joint in 0..9 {
        let mut repeated = jacobian.clone();
        let [first, second] = [2 * joint, 2 * joint + 1].map(|row| pattern.row(row));
        let (first, second, third) = (first.start, second.start, second.end);
        (second..third).for_each(|entry| repeated[entry] = 2.0 * jacobian[entry - second + first]);
        let vanished = kkt.factor(&repeated).expect_err("twice the first row");
        assert!(vanished.row == Some(2 * joint + 1) && vanished.relative.abs() <= 1e-13, "{joint}: {vanished:?}");
        for wrong in [0.0, f64::NAN, f64::INFINITY] {
            let mut of = jacobian.clone();
            of[first..second].fill(wrong);
            let refused = kkt.factor(&of).expect_err("a row without numbers");
            assert!(wrong != 0.0 || refused.row == Some(2 * joint), "{joint}: {refused:?}");
        }
    }
    // products of three entries of A have to be numbers
    for (mass, is_taken) in [(1e100, true), (1e-100, true), (1e160, false), (1e-160, false), (f64::NAN, false)] {
        assert_eq!(of_mass(mass).factor(&jacobian).is_ok(), is_taken, "{mass:e}");
    }
}

/// A body in many joints, an entry that stands twice, a joint of three bodies, and a net with more than 50 products a joint are left to other factors.
#[test]
fn invariant_blocks_refuse_what_they_cannot_take() {
    let star: Vec<(usize, Vec<usize>)> = (1..=13).map(|i| (2, vec![0, i])).collect();
    assert!(by_joints(&[1.0; 42], &pattern_of(&star[..12]), 24).is_some());
    assert!(by_joints(&[1.0; 42], &pattern_of(&star), 26).is_none());
    assert!(by_joints(&[1.0; 3], &pattern(&[&[0, 0, 1]]), 1).is_none());
    assert!(by_joints(&[1.0; 9], &pattern_of(&[(1, vec![0, 1, 2])]), 1).is_none());
    for (n, is_taken) in [(8_usize, true), (24, false)] {
        assert_eq!(by_joints(&vec![1.0; 3 * n * n], &pattern_of(&net(n)), 2 * n * (n - 1)).is_some(), is_taken, "{n}");
    }
}

/// Rows [1 0] and [cos sin]: what the first leaves of the second is sin², whatever the masses are.
#[test]
fn analytic_smallest_pivot_of_two_rows_is_the_square_of_the_sine() {
    let pattern = pattern(&[&[0, 1], &[0, 1]]);
    let mut kkt = SparseKkt::new(&[4.0, 4.0], &pattern, 2).unwrap();
    for angle in [0.1_f64, 0.7, 1.5] {
        kkt.factor(&[1.0, 0.0, angle.cos(), angle.sin()]).unwrap();
        let expected = angle.sin().powi(2);
        assert!((kkt.smallest_pivot() - expected).abs() <= 1e-14, "{} {expected}", kkt.smallest_pivot());
    }
    let vanished = kkt.factor(&[1.0, 2.0, 2.0, 4.0]).expect_err("the second row is twice the first");
    assert!(vanished.row.is_some() && vanished.relative.abs() <= 1e-14, "{vanished:?}");
}

/// A body in 200 rows: taken after them, so that the factors grow as the number of rows, and still the solution.
#[test]
fn invariant_a_hub_comes_after_its_rows() {
    let n = 200;
    let rows: Vec<[usize; 2]> = (1..=n).map(|i| [0, i]).collect();
    let rows: Vec<&[usize]> = rows.iter().map(|row| &row[..]).collect();
    let pattern = pattern(&rows);
    let (mut numbers, mass) = (Numbers(7), vec![2.0; n + 1]);
    let mut kkt = SparseKkt::new(&mass, &pattern, n).unwrap();
    assert!(kkt.n_factor_entries() <= 8 * n, "{} entries", kkt.n_factor_entries());
    let jacobian: Vec<f64> = (0..2 * n).map(|_| numbers.entry()).collect();
    let right = numbers.vector(2 * n + 1);
    kkt.factor(&jacobian).unwrap();
    let mut x = right.clone();
    solve(&mut kkt, n + 1, &mut x);
    let found = left(&pattern, &mass, &jacobian, &[], &right, &x);
    assert!(found <= ROUNDING, "{found:e}");
    // a row on the hub alone has no other coordinate to stand on: it comes behind it
    let mut rows = rows;
    rows.push(&[0]);
    let pattern = self::pattern(&rows);
    let mut kkt = SparseKkt::new(&mass, &pattern, n + 1).unwrap();
    assert!(kkt.n_factor_entries() <= 9 * n, "{} entries", kkt.n_factor_entries());
    let jacobian: Vec<f64> = (0..2 * n + 1).map(|_| numbers.entry()).collect();
    let right = numbers.vector(2 * n + 2);
    kkt.factor(&jacobian).unwrap();
    let mut x = right.clone();
    solve(&mut kkt, n + 1, &mut x);
    let found = left(&pattern, &mass, &jacobian, &[], &right, &x);
    assert!(found <= ROUNDING, "{found:e}");
}

/// Angles of levers of a tenth and of ten, masses from 1e-3 to 1e3.
#[test]
fn invariant_null_space_solutions_fulfil_their_equations_in_any_units() {
    let mut numbers = Numbers(3);
    for pattern in systems() {
        let (n_q, n_rows) = (7, pattern.n_rows());
        for unit in [[1.0; 7], [1.0, 0.1, 10.0, 1.0, 0.1, 10.0, 1.0]] {
            let mut kkt = NullSpaceKkt::new(&unit, &pattern, n_rows);
            for _ in 0..10 {
                let mass: Vec<f64> = numbers.vector(n_q).iter().map(|x| 10_f64.powf(3.0 * x)).collect();
                let jacobian: Vec<f64> = (0..pattern.n_nonzeros()).map(|_| numbers.entry()).collect();
                let right = numbers.vector(n_q + n_rows);
                kkt.factor(&mass, &jacobian, ALL, &[]).unwrap();
                let mut x = right.clone();
                kkt.solve(&mut x);
                let mut equations = EquationResidual::new(n_q, n_rows, &pattern);
                equations.write(&mass, &jacobian, &right, &x);
                assert!(equations.share() <= 1e-14, "{pattern:?} {unit:?}: {:e}", equations.share());
                // without refinement as well, to the rounding of its factors
                let [mut once, mut damped] = [right.clone(), right.clone()];
                let mut sparse = SparseKkt::new(&mass, &pattern, n_rows).unwrap();
                sparse.factor(&jacobian).unwrap();
                solve(&mut sparse, n_q, &mut once);
                let mut of_rows = DampedKkt::new(&mass, &pattern);
                of_rows.factor(&mut sparse, &pattern, &jacobian).unwrap();
                of_rows.solve(&mut sparse, &mass, &jacobian, &unit, &mut damped);
                for ((x, once), damped) in x.iter().zip(&once).zip(&damped) {
                    let bound = 1e-8 * (1.0 + x.abs());
                    assert!((x - once).abs() <= bound && (x - damped).abs() <= bound, "{x} {once} {damped}");
                }
            }
        }
    }
}

/// Rows 1 to 3 are independent, row 4 is row 1 + row 2 − 2 row 3: with n = (1, 1, −2, −1) all y + c n belong to one x. The smallest one, each
/// multiplier in units of its row scaled to one, fulfils Σ n y / s² = 0 with s = 1/max |g|.
#[test]
fn analytic_multipliers_of_redundant_rows_are_the_smallest() {
    let pattern = pattern(&[&[0, 1, 2, 3], &[0, 1, 2, 3], &[0, 1, 2, 3], &[0, 1, 2, 3]]);
    let rows = [[1.0, 0.5, 0.0, 0.2], [0.0, 2.0, 0.3, 0.0], [0.4, 0.0, 1.5, 0.1]];
    let last: [f64; 4] = std::array::from_fn(|i| rows[0][i] + rows[1][i] - 2.0 * rows[2][i]);
    let jacobian = [rows[0], rows[1], rows[2], last].concat();
    let mut kkt = NullSpaceKkt::new(&[1.0; 4], &pattern, 4);
    let mass = [1.0, 2.0, 3.0, 4.0];
    kkt.factor(&mass, &jacobian, ALL, &[]).unwrap();
    assert_eq!((kkt.rank().rank(), kkt.rank().n_redundant()), (3, 1));
    let right = [1.0, -2.0, 0.5, 3.0, 0.0, 0.0, 0.0, 0.0];
    let mut x = right;
    let told = kkt.solve(&mut x);
    assert!(told.rows <= 1e-14 && left(&pattern, &mass, &jacobian, &[], &right, &x) <= 1e-13, "{x:?}");
    let size = |row: usize| jacobian[4 * row..4 * row + 4].iter().fold(0.0, |m: f64, g| m.max(g.abs()));
    let along: f64 = [1.0, 1.0, -2.0, -1.0].iter().enumerate().map(|(i, n)| n * x[4 + i] * size(i).powi(2)).sum();
    assert!(along.abs() <= 1e-12, "{along:e}: {x:?}");
}

/// What rounding leaves of multipliers that rows share: ε over the share of their diagonal that is added, 1e-9, times forces of 6.
const SHARED: f64 = 2e-6;

/// Of two rows g and 2 g the smallest Σ D y², with D = g²/m of each, has y₁ = c/2 and y₂ = c/4.
#[test]
fn analytic_damped_rows_share_a_force_by_their_diagonal() {
    let pattern = pattern(&[&[0], &[0]]);
    for m in [0.25, 9.0] {
        let (mass, jacobian) = ([m, 1.0], [1.0, 2.0]);
        let mut kkt = SparseKkt::new(&mass, &pattern, 2).unwrap();
        let mut damped = DampedKkt::new(&mass, &pattern);
        damped.factor(&mut kkt, &pattern, &jacobian).unwrap();
        let mut x = [6.0, 5.0, 0.0, 0.0];
        let told = damped.solve(&mut kkt, &mass, &jacobian, &[1.0, 1.0], &mut x);
        for (x, expected) in x.iter().zip([0.0, 5.0, 3.0, 1.5]) {
            assert!((x - expected).abs() <= SHARED, "m = {m}: {x} {expected}");
        }
        assert!(told.rows <= SHARED, "{told:?}");
    }
}

#[test]
fn analytic_substitutes_of_masses_are_the_least_of_their_kind() {
    assert_eq!(weights(&[0.0, 2.0, 0.0, 4.0, 0.0, 7.0, 3.0, 5.0, 9.0]), [2.0, 2.0, 7.0, 4.0, 2.0, 7.0, 3.0, 5.0, 9.0]);
    assert_eq!(weights(&[0.0, 0.0, 3.0]), [1.0, 1.0, 3.0]);
    assert_eq!(weights(&[2.0, 0.0, 0.0]), [2.0, 2.0, 1.0]);
    let mut diagonal = [7.0; 3];
    let pattern = pattern(&[&[0, 1], &[], &[1]]);
    write_diagonal(pattern.entries(), &[4.0, 0.5], &[3.0, 1.0, 2.0], &mut diagonal);
    assert_eq!(diagonal, [9.0 / 4.0 + 2.0, 1.0, 8.0]);
}

/// By hand: rows scaled by their largest entry in units of the levers, and with them what is left of the equations.
#[test]
fn analytic_what_is_left_of_rows_is_scaled_by_their_entries() {
    let pattern = pattern(&[&[0, 1], &[]]);
    let mut equations = EquationResidual::new(2, 2, &pattern);
    let (mass, jacobian, unit) = ([2.0, 0.0], [4.0, 3.0], [1.0, 0.5]);
    // the first row has the entries 4 and 3/0.5 = 6; the second one none
    let (right, solution) = ([3.0, 0.0, 1.0, 0.25], [0.25, 0.5, 0.0, 0.0]);
    equations.write(&mass, &jacobian, &right, &solution);
    assert_eq!(equations.left, [3.0 - 0.5, 0.0, 1.0 - 1.0 - 1.5, 0.25]);
    assert_eq!(equations.size, [3.5, 0.0, 1.0 + 1.0 + 1.5, 0.25]);
    let left = equations.rows_left(&mass, &jacobian, &unit, &right, &solution, |_| true);
    // rows: 1.5/6 and 0.25; scale: 3.5/6, and the free acceleration 3/2
    assert_eq!((left.rows, left.scale), (0.25, 1.5));
    let counted = equations.rows_left(&mass, &jacobian, &unit, &right, &[0.25, 9.0, 0.0, 0.0], |row| row == 1);
    assert_eq!((counted.rows, counted.scale), (0.25, 4.5), "an angle of 9 on a lever of 0.5");
    // a massless coordinate has no free acceleration
    let still = equations.rows_left(&mass, &jacobian, &unit, &[0.0, 8.0, 0.0, 0.0], &[0.0; 4], |_| false);
    assert_eq!((still.rows, still.scale), (0.0, 3.5 / 6.0));
}

/// A x of a dense matrix.
fn times<T: ComplexField<RealField = f64> + Copy>(rows: &[Vec<T>], x: &[T]) -> Vec<T> {
    rows.iter().map(|row| row.iter().zip(x).fold(T::zero(), |sum, (a, x)| sum + *a * *x)).collect()
}

fn assert_lu_solves<T: ComplexField<RealField = f64> + Copy>(mut number: impl FnMut() -> T) {
    for n in 1..=8 {
        let rows: Vec<Vec<T>> = (0..n).map(|_| (0..n).map(|_| number()).collect()).collect();
        let expected: Vec<T> = (0..n).map(|_| number()).collect();
        let mut lu = Lu::new(n);
        for (i, row) in rows.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, a)| lu.matrix_mut()[(i, j)] = *a);
        }
        assert!(lu.factor());
        let mut x = times(&rows, &expected);
        lu.solve(&mut x);
        assert!(x.iter().zip(&expected).all(|(x, y)| (*x - *y).modulus() <= 1e-9), "{n}: {x:?}");
    }
}

#[test]
fn invariant_dense_factors_solve() {
    let mut numbers = Numbers(5);
    assert_lu_solves(|| numbers.next());
    let mut numbers = Numbers(6);
    assert_lu_solves(|| Complex::new(numbers.next(), numbers.next()));
    for entry in [0.0, f64::NAN, f64::INFINITY] {
        let mut lu = Lu::new(2);
        lu.matrix_mut().fill(entry);
        assert!(!lu.factor(), "{entry}");
    }
    let mut lu = Lu::<f64>::new(2);
    lu.matrix_mut().fill(1.0);
    assert!(!lu.factor(), "two equal rows");
}

fn assert_sparse_lu_solves<T>(mut number: impl FnMut() -> T)
where
    T: ComplexField<RealField = f64> + Copy + faer::traits::ComplexField,
{
    // a band, a full first row, and zeros on the diagonal, so that pivots are sought
    let n = 9;
    let columns = |i: usize| -> Vec<usize> {
        (0..n).filter(|&j| i == 0 || j + 1 == i || j == i + 1 || (j == i && i.is_multiple_of(2))).collect()
    };
    let (mut starts, mut all) = (vec![0], Vec::new());
    for i in 0..n {
        all.extend(columns(i));
        starts.push(all.len());
    }
    let mut lu = SparseLu::new(&starts, &all).unwrap();
    for _ in 0..5 {
        let values: Vec<T> = all.iter().map(|_| number()).collect();
        let mut rows = vec![vec![T::zero(); n]; n];
        for i in 0..n {
            (starts[i]..starts[i + 1]).for_each(|k| rows[i][all[k]] = values[k]);
        }
        let expected: Vec<T> = (0..n).map(|_| number()).collect();
        lu.values_mut().copy_from_slice(&values);
        assert!(lu.factor());
        let mut x = times(&rows, &expected);
        lu.solve(&mut x);
        assert!(x.iter().zip(&expected).all(|(x, y)| (*x - *y).modulus() <= 1e-9), "{x:?} {expected:?}");
    }
}

#[test]
fn invariant_sparse_factors_solve() {
    let mut numbers = Numbers(8);
    assert_sparse_lu_solves(|| numbers.entry());
    let mut numbers = Numbers(9);
    assert_sparse_lu_solves(|| Complex::new(numbers.entry(), numbers.entry()));
}
