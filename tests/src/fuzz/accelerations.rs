//! Accelerations and multipliers at one state against the oracle.

use ezy_core::__private::PIVOT_TOLERANCE;
use ezy_core::prelude::*;
use ezy_core::scalar::{DoubleDouble, Scalar};

use super::draw::Draw;
use super::oracle::Oracle;
use super::tally::Verdict;
use std::sync::Arc;

/// The oracle takes n³ operations of 20 ns each.
const LARGEST: usize = 60;

/// Roundings of each term while `n` unknowns are eliminated and found again, in units of ε (Higham, Accuracy and Stability of
/// Numerical Algorithms, 2002, theorem 9.4).
const ROUNDINGS: f64 = 3.0;

/// The part of the largest number of a kind that a pivot next to the threshold loses: what the elimination promises at least.
const PROMISED: f64 = f64::EPSILON / PIVOT_TOLERANCE;

/// Accelerations and reactions whose squares underflow are zero.
const NOTHING: f64 = 1e-154;

/// What a term is rounded by at least.
const SMALLEST: f64 = f64::EPSILON * f64::MIN_POSITIVE;

/// Roundings of the state that are tried, each with other signs.
const N_ROUNDINGS: usize = 3;

/// K and r at a state, computed in 31 digits; none of a scene without that arithmetic.
pub fn exact_equations(
    system: &System<&(dyn Scene + '_)>,
    t: f64,
    q: &[f64],
    v: &[f64],
) -> Option<(Vec<Vec<DoubleDouble>>, Vec<DoubleDouble>)> {
    let wide = |x: &[f64]| x.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let zeros = |n: usize| wide(&vec![0.0; n]);
    let (scene, info) = (system.scene().precise()?, system.info());
    let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
    let (mut c, t, q, v) = (wide(system.fixed()), DoubleDouble::from_f64(t), wide(q), wide(v));
    scene.constants(&wide(&system.scene().parameters()), &mut c);
    let (mut mass, mut entries) = (zeros(n_q), zeros(info.jacobian.n_nonzeros()));
    let mut right = zeros(n_q + n_c);
    let (force, rows) = right.split_at_mut(n_q);
    scene.mass_matrix(&c, &mut mass);
    scene.velocity_jacobian(&c, t, &q, &mut entries);
    scene.applied_force(&c, t, &q, &v, force);
    scene.convective_term(&c, t, &q, &v, rows);
    rows.iter_mut().for_each(|h| *h = -*h);
    let mut matrix = vec![zeros(n_q + n_c); n_q + n_c];
    mass.iter().enumerate().for_each(|(i, m)| matrix[i][i] = *m);
    for (k, row, column) in info.jacobian.entries() {
        matrix[n_q + row][column] = matrix[n_q + row][column] + entries[k];
        matrix[column][n_q + row] = matrix[column][n_q + row] + entries[k];
    }
    Some((matrix, right))
}

/// K and r at a state, in the numbers that the scene computes itself.
struct Equations {
    matrix: Vec<Vec<f64>>,
    right: Vec<f64>,
}

impl Equations {
    fn at(system: &System<&(dyn Scene + '_)>, t: f64, q: &[f64], v: &[f64]) -> Self {
        let (scene, info, c) = (system.scene(), system.info(), system.fixed());
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let mut matrix = vec![vec![0.0; n_q + n_c]; n_q + n_c];
        system.mass_matrix().iter().enumerate().for_each(|(i, m)| matrix[i][i] = *m);
        let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
        scene.velocity_jacobian(c, t, q, &mut entries);
        for (k, row, column) in info.jacobian.entries() {
            matrix[n_q + row][column] += entries[k];
            matrix[column][n_q + row] += entries[k];
        }
        let mut right = vec![0.0; n_q + n_c];
        let (force, rows) = right.split_at_mut(n_q);
        scene.applied_force(c, t, q, v, force);
        scene.convective_term(c, t, q, v, rows);
        rows.iter_mut().for_each(|h| *h = -*h);
        Self { matrix, right }
    }

    /// At a state that is rounded otherwise.
    fn perturbed(system: &System<&(dyn Scene + '_)>, state: &State, draw: &mut Draw) -> Self {
        let mut perturb = |x: &f64| if draw.once_in(2) { x * (1.0 + f64::EPSILON) } else { x * (1.0 - f64::EPSILON) };
        let (q, v): (Vec<f64>, Vec<f64>) =
            (state.q.iter().map(&mut perturb).collect(), state.v.iter().map(&mut perturb).collect());
        Self::at(system, state.t, &q, &v)
    }

    /// What rounding of its terms changes in each number: the difference from the same in 31 digits. An extreme lever along its rod is a
    /// number of the size of one that is the difference of large ones. None of a scene without that arithmetic.
    fn off(&self, system: &System<&(dyn Scene + '_)>, state: &State) -> Option<Self> {
        let (exact, right) = exact_equations(system, state.t, &state.q, &state.v)?;
        let off = |(x, exact): (&f64, &DoubleDouble)| (*exact - DoubleDouble::from_f64(*x)).high();
        let matrix = self.matrix.iter().zip(&exact).map(|(x, exact)| x.iter().zip(exact).map(off).collect()).collect();
        Some(Self { matrix, right: self.right.iter().zip(&right).map(off).collect() })
    }

    /// r − K x
    fn residual(&self, x: &[f64]) -> Vec<f64> {
        let product = self.matrix.iter().map(|row| row.iter().zip(x).map(|(k, x)| k * x).sum::<f64>());
        product.zip(&self.right).map(|(product, r)| r - product).collect()
    }

    /// |r| + |K| |x|
    fn magnitude(&self, x: &[f64]) -> Vec<f64> {
        let product = self.matrix.iter().map(|row| row.iter().zip(x).map(|(k, x)| (k * x).abs()).sum::<f64>());
        product.zip(&self.right).map(|(product, r)| r.abs() + product).collect()
    }

    /// The same where accelerations are what reactions leave of forces, over the mass: G a is then a sum of G M⁻¹ F and
    /// G M⁻¹ Gᵀ λ, however small a is.
    fn magnitude_over_mass(&self, x: &[f64]) -> Vec<f64> {
        let size = self.magnitude(x);
        let n_q = (0..x.len()).take_while(|&i| self.matrix[i][i] > 0.0).count();
        let summed: Vec<f64> = (0..n_q).map(|j| size[j] / self.matrix[j][j]).collect();
        let row = |i: usize| summed.iter().zip(&self.matrix[i]).map(|(x, g)| g.abs() * x).sum::<f64>();
        size.iter().enumerate().map(|(i, size)| if i < n_q { *size } else { size + row(i) }).collect()
    }
}

/// Solves at a state and compares.
///
/// # Errors
/// What is wrong with the accelerations, in numbers.
pub fn check(system: &mut System<&(dyn Scene + '_)>, state: &State, draw: &mut Draw) -> Result<Verdict, String> {
    let info = Arc::clone(system.info());
    let n_q = info.n_coordinates();
    let mut x = vec![0.0; info.n_unknowns()];
    let (a, lambda) = x.split_at_mut(n_q);
    let Ok(solved) = system.accelerations(state.t, &state.q, &state.v, a, lambda) else {
        return Ok(Verdict::AccelerationsRefused);
    };
    let here = Equations::at(system, state.t, &state.q, &state.v);
    // without pivoting numbers grow on the way by the inverse of the smallest pivot; other solutions are refined
    let growth = if system.uses_elimination() { 1.0 / solved.smallest_pivot } else { 1.0 };
    if info.n_unknowns() > LARGEST || x.iter().chain(&here.right).any(|x| !x.is_finite()) {
        return Ok(Verdict::AccelerationsNotCompared);
    }
    let Some(oracle) = Oracle::new(&here.matrix) else { return Ok(Verdict::AccelerationsNotCompared) };
    let units = info.coordinates.iter().map(|c| c.unit).chain(info.rows.iter().map(|row| row.multiplier_unit));
    let units: Vec<&str> = units.collect();
    let (perturbed, zeros): (Vec<Equations>, Vec<f64>) =
        ((0..N_ROUNDINGS).map(|_| Equations::perturbed(system, state, draw)).collect(), vec![0.0; x.len()]);
    let largest_of = |most: Vec<f64>, x: Vec<f64>| most.iter().zip(&x).map(|(most, x)| most.max(x.abs())).collect();
    if !oracle.is_regular {
        let residual = here.residual(&x);
        let change = |perturbed: &Equations| perturbed.residual(&x).iter().zip(&residual).map(|(x, y)| x - y).collect();
        let rounding = perturbed.iter().map(change).fold(zeros, largest_of);
        let sizes = here.magnitude(&x);
        let largest = sizes.iter().fold(0.0, |m: f64, x| m.max(*x));
        let rounding: Vec<f64> = rounding.iter().map(|rounding| rounding + f64::EPSILON * largest).collect();
        return compare("residual", &residual, &sizes, &units, &rounding, growth);
    }
    let exact = oracle.solve(&here.right);
    let divides = system.uses_elimination() || !info.has_elimination();
    let magnitude = if divides { here.magnitude_over_mass(&exact) } else { here.magnitude(&exact) };
    let moved = |perturbed: &Equations| {
        let change: Vec<f64> =
            perturbed.residual(&exact).iter().zip(here.residual(&exact)).map(|(x, y)| x - y).collect();
        oracle.solve(&change)
    };
    let mut terms: Vec<f64> = magnitude.iter().map(|size| SMALLEST.max(f64::EPSILON * size)).collect();
    if let Some(off) = here.off(system, state) {
        terms.iter_mut().zip(off.magnitude(&exact)).for_each(|(term, off)| *term += off);
    }
    let of_terms = oracle.at_most(&terms);
    let of_state = perturbed.iter().map(moved).fold(zeros, largest_of);
    let of_largest = oracle.rounding(&exact);
    let rounding: Vec<f64> = (0..x.len()).map(|i| of_terms[i] + of_state[i] + of_largest[i]).collect();
    if exact.iter().chain(&rounding).any(|x| !x.is_finite()) {
        return Ok(Verdict::AccelerationsNotCompared);
    }
    let error: Vec<f64> = x.iter().zip(&exact).map(|(x, exact)| x - exact).collect();
    compare("error", &error, &exact, &units, &rounding, growth)
}

/// Errors against what rounding of each term does, and of the largest number of a kind, times what it grows to in an elimination.
fn compare(
    what: &str,
    error: &[f64],
    sizes: &[f64],
    units: &[&str],
    rounding: &[f64],
    growth: f64,
) -> Result<Verdict, String> {
    let times = ROUNDINGS * error.len() as f64 * growth;
    let mut verdict = Verdict::AccelerationsConfirmed;
    for (i, unit) in units.iter().enumerate() {
        let of_kind = sizes.iter().zip(units).filter(|(_, other)| *other == unit);
        let size = of_kind.fold(0.0, |m: f64, (x, _)| m.max(x.abs()));
        let allowed = NOTHING + times * (rounding[i] + f64::EPSILON * size);
        let error = error[i].abs();
        if error.is_nan() || error > allowed + PROMISED * size {
            let does = format!("size {size:.1e}, rounding does {:.1e}, {times:.1e} times", rounding[i]);
            return Err(format!("{what} {error:.1e} of number {i}; {does}"));
        }
        if error > allowed {
            verdict = Verdict::AccelerationsLoseDigits;
        }
    }
    Ok(verdict)
}
