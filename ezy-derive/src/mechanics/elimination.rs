//! Elimination of `A λ = r` with `A = G M⁻¹ Gᵀ`, the symbolic part.
//!
//! A row whose pivot depends on parameters alone (a skate, anything fixed to one body) is eliminated here, so
//! that its pivot and couplings become constants or products with them. What remains is a small matrix whose
//! entries move with the bodies; [`super::block`] eliminates it operation by operation.
//!
//! No pivoting is needed: A is positive definite wherever G has full rank, and so is every Schur complement.

use std::collections::{BTreeMap, BTreeSet};

use super::scene::Equations;
use crate::model::Coordinate;
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::{Algebra, SumId, Symbol};
use crate::work;

/// A row eliminated with a constant pivot.
#[derive(Debug)]
pub struct ConstantStep {
    pub row: usize,
    pub pivot: Coefficient,
    /// A_kk before any elimination.
    pub diagonal: SumId,
    /// Right side when the row is eliminated, and the symbol that stands for it afterwards.
    pub right_side: SumId,
    pub symbol: Symbol,
    /// (row, coupling) for rows eliminated later.
    couplings: Vec<(usize, SumId)>,
}

/// The system after the constant pivots.
#[derive(Debug)]
pub struct Reduced {
    pub steps: Vec<ConstantStep>,
    /// Rows that are left, in declared order.
    pub rest: Vec<usize>,
    /// Symmetric matrix of the rows that are left, each row by column without zeros, and the diagonal of A before any
    /// elimination.
    pub matrix: Vec<Vec<(usize, SumId)>>,
    pub diagonal: Vec<SumId>,
    pub right_side: Vec<SumId>,
    /// Symbols that stand for the multipliers.
    pub multipliers: Vec<Symbol>,
    /// λ of each constant step, from multipliers found before it; in the order of `steps` reversed.
    pub back_substitution: Vec<(usize, SumId)>,
}

impl Reduced {
    /// Eliminates what has a constant pivot from `A λ = r`.
    pub fn new(equations: &mut Equations, right_side: Vec<SumId>) -> Self {
        let n = right_side.len();
        let mut matrix = NormalMatrix::new(equations);
        let diagonal: Vec<SumId> = (0..n).map(|i| matrix.get(i, i)).collect();
        let mut right_side = right_side;
        let mut left: BTreeSet<usize> = (0..n).collect();
        let mut steps = Vec::new();
        for row in 0..n {
            if !on_one_body(equations, row) {
                continue;
            }
            let algebra = &mut equations.algebra;
            let Some(pivot) = algebra.as_coefficient(matrix.get(row, row)).filter(|k| !k.is_zero()) else { continue };
            left.remove(&row);
            let symbol = equations.symbols.new_named(format!("right_side_{}", code_name(equations, row)));
            let algebra = &mut equations.algebra;
            let value = algebra.symbol(symbol);
            let inverse = algebra.coefficients.div(Coefficient::ONE, pivot);
            let coupled: Vec<usize> = matrix.rows[row].keys().copied().filter(|i| left.contains(i)).collect();
            work::count(matrix.rows[row].len());
            for &i in &coupled {
                let entry = matrix.get(i, row);
                if entry.is_zero() {
                    continue;
                }
                work::count(coupled.len());
                let factor = algebra.scale(entry, inverse);
                right_side[i] = subtract_product(algebra, right_side[i], factor, value);
                for &j in &coupled {
                    let difference = subtract_product(algebra, matrix.get(i, j), factor, matrix.get(row, j));
                    matrix.set(i, j, difference);
                }
            }
            let couplings =
                coupled.into_iter().map(|j| (j, matrix.get(row, j))).filter(|(_, a)| !a.is_zero()).collect();
            steps.push(ConstantStep {
                row,
                pivot,
                diagonal: diagonal[row],
                right_side: right_side[row],
                symbol,
                couplings,
            });
        }
        let multipliers: Vec<Symbol> = (0..n)
            .map(|row| {
                let name = format!("lambda_{}", code_name(equations, row));
                equations.symbols.new_named(name)
            })
            .collect();
        let back_substitution = back_substitution(&mut equations.algebra, &steps, &multipliers);
        let rest: Vec<usize> = left.into_iter().collect();
        let place: BTreeMap<usize, usize> = rest.iter().enumerate().map(|(place, &row)| (row, place)).collect();
        let restrict = |i: &usize| {
            let entries = matrix.rows[*i].iter().filter(|(_, entry)| !entry.is_zero());
            entries.filter_map(|(j, &entry)| Some((*place.get(j)?, entry))).collect()
        };
        Self {
            matrix: rest.iter().map(restrict).collect(),
            diagonal: rest.iter().map(|&i| diagonal[i]).collect(),
            right_side: rest.iter().map(|&i| right_side[i]).collect(),
            rest,
            steps,
            multipliers,
            back_substitution,
        }
    }
}

/// λ_k = (r_k − Σ A_kj λ_j) / A_kk, last step first.
fn back_substitution(algebra: &mut Algebra, steps: &[ConstantStep], multipliers: &[Symbol]) -> Vec<(usize, SumId)> {
    let mut out = Vec::new();
    for step in steps.iter().rev() {
        let mut total = algebra.symbol(step.symbol);
        for &(j, coupling) in &step.couplings {
            let lambda = algebra.symbol(multipliers[j]);
            total = subtract_product(algebra, total, coupling, lambda);
        }
        let inverse = algebra.coefficients.div(Coefficient::ONE, step.pivot);
        out.push((step.row, algebra.scale(total, inverse)));
    }
    out
}

/// A = G M⁻¹ Gᵀ, by rows; an entry stands at both of its places.
struct NormalMatrix {
    rows: Vec<BTreeMap<usize, SumId>>,
}

impl NormalMatrix {
    fn new(equations: &mut Equations) -> Self {
        let (algebra, jacobian) = (&mut equations.algebra, &equations.constraints.jacobian);
        let mut rows_of_column: Vec<Vec<(usize, SumId)>> = vec![Vec::new(); equations.mass.len()];
        for (row, entries) in jacobian.iter().enumerate() {
            entries.iter().for_each(|&(column, entry)| rows_of_column[column].push((row, entry)));
        }
        let mut matrix = Self { rows: vec![BTreeMap::new(); jacobian.len()] };
        let holds = equations.constraints.rows.iter().map(|row| row.holds);
        for ((i, entries), holds) in jacobian.iter().enumerate().zip(holds) {
            let mut products: BTreeMap<usize, Vec<(usize, SumId, SumId)>> = BTreeMap::new();
            for &(k, a) in entries {
                let others = rows_of_column[k].iter().filter(|&&(j, _)| j >= i);
                others.for_each(|&(j, b)| products.entry(j).or_default().push((k, a, b)));
            }
            for (j, products) in products {
                let mut parts = Vec::new();
                for (k, a, b) in products {
                    let product = algebra.mul(a, b);
                    let inverse = algebra.coefficients.div(Coefficient::ONE, equations.mass[k]);
                    parts.push(algebra.scale(product, inverse));
                }
                // a row that is switched off is 0 = 0 but for this pivot
                if let Some(holds) = holds.filter(|_| i == j) {
                    let off = algebra.coefficients.add(Coefficient::ONE, holds.neg());
                    parts.push(algebra.constant(off));
                }
                let entry = algebra.total(&parts);
                matrix.set(i, j, entry);
                matrix.set(j, i, entry);
            }
        }
        matrix
    }

    fn get(&self, i: usize, j: usize) -> SumId {
        self.rows[i].get(&j).copied().unwrap_or(SumId::ZERO)
    }

    /// The other place gets an entry, too, if it has none.
    fn set(&mut self, i: usize, j: usize, entry: SumId) {
        self.rows[i].insert(j, entry);
        self.rows[j].entry(i).or_insert(SumId::ZERO);
    }
}

fn subtract_product(algebra: &mut Algebra, a: SumId, b: SumId, c: SumId) -> SumId {
    if b.is_zero() || c.is_zero() {
        return a;
    }
    let product = algebra.mul(b, c);
    algebra.sub(a, product)
}

fn on_one_body(equations: &Equations, row: usize) -> bool {
    let entries = &equations.constraints.jacobian[row];
    let mut bodies = entries.iter().map(|&(column, _)| Coordinate::at(column).body);
    bodies.next().is_some_and(|first| bodies.all(|body| body == first))
}

fn code_name(equations: &Equations, row: usize) -> String {
    equations.constraints.rows[row].name.replace('.', "_")
}
