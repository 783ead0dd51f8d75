//! Elimination of the rows whose pivots move, in blocks of one or two rows, operation by operation.

use crate::symbolic::program::{Program, Value};

/// Symmetric matrix and right side, as values of a program.
pub struct System<'a> {
    pub program: &'a mut Program,
    pub matrix: Vec<Vec<Value>>,
    pub right_side: Vec<Value>,
}

/// Inverse pivot of an eliminated block, and its couplings scaled by it.
struct EliminatedBlock {
    rows: Vec<usize>,
    /// `W = D⁻¹ A_pj` for the rows j eliminated later.
    scaled: Vec<(usize, Vec<Value>)>,
    /// `D⁻¹ r_p`
    solution: Vec<Value>,
}

/// Result of an elimination.
pub struct Solved {
    pub solution: Vec<Value>,
    /// For each block: its rows and the determinant of its pivot.
    pub pivots: Vec<(Vec<usize>, Value)>,
}

impl System<'_> {
    /// Solves with the given blocks of rows, in the order that creates least fill.
    pub fn solve(mut self, blocks: Vec<Vec<usize>>) -> Solved {
        let mut eliminated = Vec::new();
        let mut pivots = Vec::new();
        let mut left = blocks;
        while !left.is_empty() {
            let next = self.least_coupled(&left);
            let block = left.remove(next);
            let later: Vec<usize> = left.iter().flatten().copied().collect();
            let (done, pivot) = self.eliminate(block.clone(), &later);
            eliminated.push(done);
            pivots.push((block, pivot));
        }
        let zero = self.program.literal(0.0);
        let mut solution = vec![zero; self.right_side.len()];
        for block in eliminated.iter().rev() {
            for (i, &row) in block.rows.iter().enumerate() {
                let mut value = block.solution[i];
                for (j, column) in &block.scaled {
                    let product = self.program.mul(column[i], solution[*j]);
                    value = self.program.sub(value, product);
                }
                solution[row] = value;
            }
        }
        Solved { solution, pivots }
    }

    /// The block with the fewest couplings to others (minimum degree); the first of several.
    fn least_coupled(&self, blocks: &[Vec<usize>]) -> usize {
        let coupled =
            |a: &[usize], b: &[usize]| a.iter().any(|&i| b.iter().any(|&j| !self.program.is_zero(self.matrix[i][j])));
        let degree = |i: usize| (0..blocks.len()).filter(|&j| j != i && coupled(&blocks[i], &blocks[j])).count();
        (0..blocks.len()).min_by_key(|&i| (degree(i), i)).unwrap_or(0)
    }

    fn eliminate(&mut self, rows: Vec<usize>, later: &[usize]) -> (EliminatedBlock, Value) {
        let coupled: Vec<usize> =
            later.iter().copied().filter(|&j| rows.iter().any(|&i| !self.program.is_zero(self.matrix[i][j]))).collect();
        let (inverse, pivot) = self.inverse(&rows);
        let right_side: Vec<Value> = rows.iter().map(|&i| self.right_side[i]).collect();
        let solution = self.apply(&inverse, &right_side);
        let scaled: Vec<(usize, Vec<Value>)> = coupled
            .iter()
            .map(|&j| {
                let column: Vec<Value> = rows.iter().map(|&i| self.matrix[i][j]).collect();
                (j, self.apply(&inverse, &column))
            })
            .collect();
        for (j, column) in &scaled {
            for (k, &row) in rows.iter().enumerate() {
                // r_j −= Wᵀ r_p and A_ji −= Wᵀ A_pi, once for each pair
                let product = self.program.mul(column[k], self.right_side[row]);
                self.right_side[*j] = self.program.sub(self.right_side[*j], product);
                for &i in coupled.iter().filter(|&i| i >= j) {
                    let product = self.program.mul(column[k], self.matrix[row][i]);
                    let entry = self.program.sub(self.matrix[*j][i], product);
                    self.matrix[*j][i] = entry;
                    self.matrix[i][*j] = entry;
                }
            }
        }
        (EliminatedBlock { rows, scaled, solution }, pivot)
    }

    /// D⁻¹ of a pivot block as (adjugate, reciprocal of the determinant), and the determinant.
    fn inverse(&mut self, rows: &[usize]) -> (Inverse, Value) {
        let one = self.program.literal(1.0);
        if let [i] = *rows {
            let pivot = self.matrix[i][i];
            let reciprocal = self.program.div(one, pivot);
            return (Inverse { adjugate: vec![vec![one]], reciprocal }, pivot);
        }
        let (i, j) = (rows[0], rows[1]);
        let (a, b, c) = (self.matrix[i][i], self.matrix[i][j], self.matrix[j][j]);
        let product = self.program.mul(a, c);
        let square = self.program.mul(b, b);
        let determinant = self.program.sub(product, square);
        let reciprocal = self.program.div(one, determinant);
        (Inverse { adjugate: vec![vec![c, b.neg()], vec![b.neg(), a]], reciprocal }, determinant)
    }

    fn apply(&mut self, inverse: &Inverse, x: &[Value]) -> Vec<Value> {
        inverse
            .adjugate
            .iter()
            .map(|row| {
                let mut total = self.program.literal(0.0);
                for (&a, &x) in row.iter().zip(x) {
                    let product = self.program.mul(a, x);
                    total = self.program.add(total, product);
                }
                self.program.mul(total, inverse.reciprocal)
            })
            .collect()
    }
}

struct Inverse {
    adjugate: Vec<Vec<Value>>,
    reciprocal: Value,
}
