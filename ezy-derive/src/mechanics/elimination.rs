//! Elimination of `A λ = r` with `A = G M⁻¹ Gᵀ`, the symbolic part.
//!
//! A row whose pivot depends on parameters alone (a skate, anything fixed to one body) is eliminated here, so
//! that its pivot and couplings become constants or products with them. What remains is a small matrix whose
//! entries move with the bodies; [`super::block`] eliminates it operation by operation.
//!
//! No pivoting is needed: A is positive definite wherever G has full rank, and so is every Schur complement.

use super::scene::Equations;
use crate::model::Coordinate;
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::{Algebra, SumId, Symbol};

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
    /// Full symmetric matrix of the rows that are left, and the diagonal of A before any elimination.
    pub matrix: Vec<Vec<SumId>>,
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
        let mut matrix = normal_matrix(equations);
        let diagonal: Vec<SumId> = (0..n).map(|i| matrix[i][i]).collect();
        let mut right_side = right_side;
        let mut left: Vec<usize> = (0..n).collect();
        let mut steps = Vec::new();
        for row in 0..n {
            if !on_one_body(equations, row) {
                continue;
            }
            let algebra = &mut equations.algebra;
            let Some(pivot) = algebra.as_coefficient(matrix[row][row]).filter(|k| !k.is_zero()) else { continue };
            left.retain(|&other| other != row);
            let symbol = equations.symbols.new_named(format!("right_side_{}", code_name(equations, row)));
            let algebra = &mut equations.algebra;
            let value = algebra.symbol(symbol);
            let inverse = algebra.coefficients.div(Coefficient::ONE, pivot);
            for &i in &left {
                if matrix[i][row].is_zero() {
                    continue;
                }
                let factor = algebra.scale(matrix[i][row], inverse);
                right_side[i] = subtract_product(algebra, right_side[i], factor, value);
                for &j in &left {
                    let coupling = matrix[row][j];
                    matrix[i][j] = subtract_product(algebra, matrix[i][j], factor, coupling);
                }
            }
            let couplings = left.iter().map(|&j| (j, matrix[row][j])).filter(|(_, a)| !a.is_zero()).collect();
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
        let restrict = |i: usize| left.iter().map(|&j| matrix[i][j]).collect();
        Self {
            matrix: left.iter().map(|&i| restrict(i)).collect(),
            diagonal: left.iter().map(|&i| diagonal[i]).collect(),
            right_side: left.iter().map(|&i| right_side[i]).collect(),
            rest: left,
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

/// A = G M⁻¹ Gᵀ
fn normal_matrix(equations: &mut Equations) -> Vec<Vec<SumId>> {
    let (algebra, jacobian) = (&mut equations.algebra, &equations.constraints.jacobian);
    let n = jacobian.len();
    let mut matrix = vec![vec![SumId::ZERO; n]; n];
    for i in 0..n {
        for j in i..n {
            let mut parts = Vec::new();
            for &(k, a) in &jacobian[i] {
                for &(_, b) in jacobian[j].iter().filter(|(column, _)| *column == k) {
                    let product = algebra.mul(a, b);
                    let inverse = algebra.coefficients.div(Coefficient::ONE, equations.mass[k]);
                    parts.push(algebra.scale(product, inverse));
                }
            }
            matrix[i][j] = algebra.total(&parts);
            matrix[j][i] = matrix[i][j];
        }
    }
    matrix
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
