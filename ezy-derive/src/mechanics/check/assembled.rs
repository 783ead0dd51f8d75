//! Constraints that are redundant once the model is assembled with its declared parameters, such as two hinges between the
//! same two bodies, which fit only if their distances agree. A warning: with other parameters they may be independent.

use super::{RandomState, dependent_rows};
use crate::diag::{Diagnostics, equations as message};
use crate::mechanics::Equations;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::model::Model;
use crate::symbolic::Symbol;
use crate::symbolic::evaluate::Point;

/// Number of assemblies, from different guesses: what holds in all of them is no accident of one position.
const SEEDS: [u64; 3] = [11, 12, 13];
/// Passes of Gauss–Newton; it converges in a few where the model can be assembled at all.
const MAX_PASSES: usize = 60;
/// A constraint with a smaller residual is satisfied.
const MET: f64 = 1e-10;
/// Keeps the matrix of dependent rows regular; slows convergence by as little.
const DAMPING: f64 = 1e-9;

pub fn rows(model: &Model, equations: &Equations, reported: &mut Vec<usize>, diag: &mut Diagnostics) {
    let defaults: Vec<f64> = model.parameters.iter().map(|parameter| parameter.default).collect();
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

/// The declared parameters, and coordinates that meet the position rows.
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
        let jacobian: Vec<Vec<f64>> = (constraints.jacobian[..residual.len()].iter())
            .map(|entries| {
                let mut row = vec![0.0; state.q.len()];
                for &(column, entry) in entries {
                    row[column] = equations.algebra.evaluate(entry, &state);
                }
                row
            })
            .collect();
        let multipliers = solve_normal(&jacobian, residual);
        for (row, multiplier) in jacobian.iter().zip(&multipliers) {
            state.q.iter_mut().zip(row).for_each(|(q, entry)| *q -= entry * multiplier);
        }
    }
    None
}

/// x with (J Jᵀ + damping) x = r.
fn solve_normal(jacobian: &[Vec<f64>], mut right_side: Vec<f64>) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let mut matrix: Vec<Vec<f64>> = jacobian.iter().map(|a| jacobian.iter().map(|b| dot(a, b)).collect()).collect();
    let n = matrix.len();
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += DAMPING * row[i].max(f64::MIN_POSITIVE);
    }
    // positive definite: no pivoting
    for k in 0..n {
        let pivot = matrix[k].clone();
        for i in k + 1..n {
            let factor = matrix[i][k] / pivot[k];
            matrix[i].iter_mut().zip(&pivot).for_each(|(x, y)| *x -= factor * y);
            right_side[i] -= factor * right_side[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| matrix[k][j] * right_side[j]).sum();
        right_side[k] = (right_side[k] - known) / matrix[k][k];
    }
    right_side
}
