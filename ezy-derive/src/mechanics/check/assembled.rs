//! Constraints that are redundant once the model is assembled with its declared parameters, such as two hinges between the
//! same two bodies, which fit only if their distances agree. A warning: with other parameters they may be independent.

use super::basis::Row;
use super::{RandomState, dependent_rows};
use crate::diag::{Diagnostics, equations as message};
use crate::mechanics::Equations;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::model::Model;
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::Point;
use crate::work;

/// Number of assemblies, from different guesses: what holds in all of them is no accident of one position.
const SEEDS: [u64; 3] = [11, 12, 13];
/// Passes of Gauss–Newton; it converges in a few where the model can be assembled at all.
const MAX_PASSES: usize = 60;
/// A constraint with a smaller residual is satisfied.
const MET: f64 = 1e-10;
/// Keeps the matrix of dependent rows regular; slows convergence by as little.
const DAMPING: f64 = 1e-9;

pub fn rows(model: &Model, equations: &Equations, reported: &mut Vec<usize>, diag: &mut Diagnostics) {
    let defaults = model.defaults();
    if defaults.iter().any(|value| value.is_nan()) {
        return;
    }
    let states = SEEDS.iter().filter_map(|&seed| assemble(equations, &defaults, seed));
    let found: Vec<Vec<(usize, Vec<usize>)>> = states.map(|state| dependent_rows(equations, &state)).collect();
    let Some(first) = found.first() else { return };
    for (i, others) in first {
        let rows = &equations.constraints.rows;
        let family = rows[*i].family;
        let always = found.iter().all(|sample| sample.iter().any(|(row, _)| row == i));
        if always && !reported.contains(&family) {
            let names: Vec<&str> = others.iter().map(|&row| rows[row].name.as_str()).collect();
            diag.warning(message::dependent_as_declared(&model.rows[family].name, &rows[*i].name, &names));
            reported.push(family);
        }
    }
}

/// The declared parameters, and coordinates that meet the position constraints.
struct Assembled<'a> {
    symbols: &'a Symbols,
    defaults: &'a [f64],
    q: Vec<f64>,
}

impl Point for Assembled<'_> {
    fn symbol(&self, symbol: Symbol) -> f64 {
        match self.symbols.meaning(symbol) {
            Meaning::Coordinate(i) => self.q[i],
            _ => 0.0,
        }
    }

    fn parameter(&self, index: usize) -> f64 {
        self.defaults[index]
    }
}

fn assemble<'a>(equations: &'a Equations, defaults: &'a [f64], seed: u64) -> Option<Assembled<'a>> {
    let symbols = &equations.symbols;
    let random = RandomState { symbols, seed };
    let q = (0..equations.mass.len()).map(|i| random.symbol(symbols.coordinate_at(i))).collect();
    let mut state = Assembled { symbols, defaults, q };
    let constraints = &equations.constraints;
    for _ in 0..MAX_PASSES {
        let residual: Vec<f64> = constraints.position.iter().map(|&c| equations.algebra.evaluate(c, &state)).collect();
        let largest = residual.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        if largest <= MET {
            return Some(state);
        }
        if !largest.is_finite() {
            return None;
        }
        let value = |entry| equations.algebra.evaluate(entry, &state);
        let row = |entries: &Vec<(usize, _)>| entries.iter().map(|&(column, entry)| (column, value(entry))).collect();
        let jacobian: Vec<Row> = constraints.jacobian[..residual.len()].iter().map(row).collect();
        let multipliers = solve_normal(&jacobian, residual, state.q.len());
        for (row, multiplier) in jacobian.iter().zip(&multipliers) {
            row.iter().for_each(|(&column, entry)| state.q[column] -= entry * multiplier);
        }
    }
    None
}

/// Columns with more rows would make J Jᵀ dense.
const MOST_ROWS_OF_A_COLUMN: usize = 36;

/// x with (J Jᵀ + damping) x = r.
///
/// J = [L H] with H the few columns that many rows share: for B = L Lᵀ + damping, B X = H and B y = r,
/// x = y − X (1 + Hᵀ X)⁻¹ Hᵀ y (Woodbury).
fn solve_normal(jacobian: &[Row], right_side: Vec<f64>, n_columns: usize) -> Vec<f64> {
    let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); n_columns];
    for (i, row) in jacobian.iter().enumerate() {
        row.iter().for_each(|(&column, &x)| columns[column].push((i, x)));
    }
    let (heavy, light): (Vec<_>, Vec<_>) = columns.into_iter().partition(|column| column.len() > MOST_ROWS_OF_A_COLUMN);
    let mut right_sides = vec![right_side];
    for column in &heavy {
        let mut dense = vec![0.0; jacobian.len()];
        column.iter().for_each(|&(i, x)| dense[i] = x);
        right_sides.push(dense);
    }
    solve_sparse(&mut normal_matrix(jacobian, &light), &mut right_sides);
    let dot = |column: &[(usize, f64)], x: &[f64]| column.iter().map(|&(i, y)| x[i] * y).sum::<f64>();
    let (known, of_heavy) = right_sides.split_at_mut(1);
    let shares = heavy.iter().enumerate().map(|(i, column)| {
        let entry = |(j, x): (usize, &Vec<f64>)| (j, dot(column, x) + f64::from(u8::from(i == j)));
        of_heavy.iter().enumerate().map(entry).filter(|(j, _)| *j >= i).collect::<Row>()
    });
    let mut shares: Vec<Row> = shares.collect();
    let mut weights = vec![heavy.iter().map(|column| dot(column, &known[0])).collect()];
    solve_sparse(&mut shares, &mut weights);
    let mut found = std::mem::take(&mut known[0]);
    for (weight, x) in weights[0].iter().zip(of_heavy) {
        found.iter_mut().zip(x).for_each(|(found, x)| *found -= weight * *x);
    }
    found
}

/// The upper triangle of L Lᵀ from the columns of L, with damping by the diagonal of J Jᵀ.
fn normal_matrix(jacobian: &[Row], columns: &[Vec<(usize, f64)>]) -> Vec<Row> {
    let size = |row: &Row| row.values().map(|x| x * x).sum::<f64>().max(f64::MIN_POSITIVE);
    let mut matrix: Vec<Row> =
        jacobian.iter().enumerate().map(|(i, row)| Row::from([(i, DAMPING * size(row))])).collect();
    for column in columns {
        for (place, &(i, x)) in column.iter().enumerate() {
            work::count(column.len() - place);
            column[place..].iter().for_each(|&(j, y)| *matrix[i].entry(j).or_insert(0.0) += x * y);
        }
    }
    matrix
}

/// Solves with a positive definite matrix, given by its upper triangle: without pivoting, in place.
fn solve_sparse(matrix: &mut [Row], right_sides: &mut [Vec<f64>]) {
    let n = matrix.len();
    for k in 0..n {
        let coupled: Vec<(usize, f64)> = matrix[k].iter().map(|(&j, &x)| (j, x)).collect();
        let pivot = coupled[0].1;
        for (place, &(i, x)) in coupled.iter().enumerate().skip(1) {
            let factor = x / pivot;
            work::count(coupled.len() - place);
            coupled[place..].iter().for_each(|&(j, y)| *matrix[i].entry(j).or_insert(0.0) -= factor * y);
            right_sides.iter_mut().for_each(|side| side[i] -= factor * side[k]);
        }
    }
    for side in right_sides {
        for k in (0..n).rev() {
            let known: f64 = matrix[k].range(k + 1..).map(|(&j, x)| x * side[j]).sum();
            side[k] = (side[k] - known) / matrix[k][&k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Some tens of operations on numbers of one, with pivots down to 1e-3.
    const ROUNDING: f64 = 1e-10;

    /// x with (J Jᵀ + 1e-9 of its diagonal) x = r: few rows, and forty that share two columns, which are taken apart.
    #[test]
    fn analytic_normal_equations_are_solved() {
        for (n_rows, n_columns, shared) in [(1, 3, 0), (5, 8, 0), (12, 20, 0), (40, 90, 1), (45, 100, 2)] {
            let mut random = Random::new(n_rows as u64);
            let jacobian: Vec<Row> = (0..n_rows)
                .map(|i| {
                    let own = (0..3).map(|k| (shared + (2 * i + k) % (n_columns - shared), random.between(0.5, 2.0)));
                    let mut row: Row = own.collect();
                    row.extend((0..shared).map(|column| (column, 1.0 + (i + column) as f64 / 50.0)));
                    row
                })
                .collect();
            let right_side: Vec<f64> = (0..n_rows).map(|i| (1.0 + i as f64).sin()).collect();
            let x = solve_normal(&jacobian, right_side.clone(), n_columns);
            assert_eq!(x.len(), n_rows);
            let mut forces = vec![0.0; n_columns];
            for (row, x) in jacobian.iter().zip(&x) {
                row.iter().for_each(|(&column, g)| forces[column] += g * x);
            }
            let size = x.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
            for (i, row) in jacobian.iter().enumerate() {
                let diagonal: f64 = row.values().map(|g| g * g).sum();
                let product: f64 = row.iter().map(|(&column, g)| g * forces[column]).sum();
                let product = product + DAMPING * diagonal * x[i];
                let error = (product - right_side[i]).abs();
                assert!(error <= ROUNDING * size * n_rows as f64, "{n_rows} rows, {shared} shared: {error:.1e}");
            }
        }
    }
}
