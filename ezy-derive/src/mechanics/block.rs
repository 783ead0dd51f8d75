//! Elimination of the rows whose pivots move, in blocks of one or two rows, operation by operation.

use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

use crate::symbolic::program::{Program, Value};
use crate::work;

/// Symmetric matrix and right side, as values of a program.
pub struct System<'a> {
    program: &'a mut Program,
    /// Rows of the matrix by column. An entry that vanished stays where it was.
    matrix: Vec<FxHashMap<usize, Value>>,
    right_side: Vec<Value>,
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
    /// For each block, in the order of elimination: its place among the blocks, and the determinant of its pivot.
    pub pivots: Vec<(usize, Value)>,
}

impl<'a> System<'a> {
    /// `matrix` by rows as (column, entry), at both places of each entry.
    pub fn new(program: &'a mut Program, matrix: Vec<Vec<(usize, Value)>>, right_side: Vec<Value>) -> Self {
        let mut by_column: Vec<FxHashMap<usize, Value>> =
            matrix.iter().map(|row| row.iter().copied().collect()).collect();
        for (i, row) in matrix.into_iter().enumerate() {
            for (j, _) in row {
                // an entry may vanish at one of its places alone
                by_column[j].entry(i).or_insert_with(|| program.literal(0.0));
            }
        }
        Self { program, matrix: by_column, right_side }
    }

    /// Solves with the given blocks of rows, ascending, in the order that creates least fill.
    pub fn solve(mut self, blocks: &[Vec<usize>]) -> Solved {
        let mut queue = Queue::new(&self, blocks);
        let (mut eliminated, mut pivots) = (Vec::new(), Vec::new());
        while let Some(next) = queue.take(&self) {
            let later: Vec<usize> = queue.coupled.iter().flat_map(|&block| blocks[block].iter().copied()).collect();
            let (done, pivot) = self.eliminate(blocks[next].clone(), &later);
            queue.update(&self);
            eliminated.push(done);
            pivots.push((next, pivot));
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

    fn entry(&mut self, i: usize, j: usize) -> Value {
        self.matrix[i].get(&j).copied().unwrap_or_else(|| self.program.literal(0.0))
    }

    fn eliminate(&mut self, rows: Vec<usize>, later: &[usize]) -> (EliminatedBlock, Value) {
        let is_coupled = |j: &usize| {
            let entries = rows.iter().filter_map(|&i| self.matrix[i].get(j));
            entries.into_iter().any(|&entry| !self.program.is_zero(entry))
        };
        let coupled: Vec<usize> = later.iter().copied().filter(is_coupled).collect();
        let (inverse, pivot) = self.inverse(&rows);
        let right_side: Vec<Value> = rows.iter().map(|&i| self.right_side[i]).collect();
        let solution = self.apply(&inverse, &right_side);
        let scaled: Vec<(usize, Vec<Value>)> = coupled
            .iter()
            .map(|&j| {
                let column: Vec<Value> = rows.iter().map(|&i| self.entry(i, j)).collect();
                (j, self.apply(&inverse, &column))
            })
            .collect();
        for (j, column) in &scaled {
            for (k, &row) in rows.iter().enumerate() {
                // r_j −= Wᵀ r_p and A_ji −= Wᵀ A_pi, once for each pair
                let product = self.program.mul(column[k], self.right_side[row]);
                self.right_side[*j] = self.program.sub(self.right_side[*j], product);
                for &i in coupled.iter().filter(|&i| i >= j) {
                    let (of_pivot, before) = (self.entry(row, i), self.entry(*j, i));
                    let product = self.program.mul(column[k], of_pivot);
                    let entry = self.program.sub(before, product);
                    self.matrix[*j].insert(i, entry);
                    self.matrix[i].insert(*j, entry);
                }
            }
        }
        (EliminatedBlock { rows, scaled, solution }, pivot)
    }

    /// D⁻¹ of a pivot block as (adjugate, reciprocal of the determinant), and the determinant.
    fn inverse(&mut self, rows: &[usize]) -> (Inverse, Value) {
        let one = self.program.literal(1.0);
        if let [i] = *rows {
            let pivot = self.entry(i, i);
            let reciprocal = self.program.div(one, pivot);
            return (Inverse { adjugate: vec![vec![one]], reciprocal }, pivot);
        }
        let (i, j) = (rows[0], rows[1]);
        let (a, b, c) = (self.entry(i, i), self.entry(i, j), self.entry(j, j));
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

/// The blocks that are left, by the number of others that they are coupled to (minimum degree).
struct Queue<'b> {
    blocks: &'b [Vec<usize>],
    /// The block of each row.
    block_of: Vec<usize>,
    /// (degree, block)
    waiting: BTreeSet<(usize, usize)>,
    /// Of each block that waits.
    degrees: Vec<Option<usize>>,
    /// The blocks that the one taken last shares entries with, ascending.
    coupled: Vec<usize>,
}

impl<'b> Queue<'b> {
    fn new(system: &System<'_>, blocks: &'b [Vec<usize>]) -> Self {
        let mut block_of = vec![0; system.right_side.len()];
        for (block, rows) in blocks.iter().enumerate() {
            rows.iter().for_each(|&row| block_of[row] = block);
        }
        let degrees = vec![Some(0); blocks.len()];
        let waiting = (0..blocks.len()).map(|block| (0, block)).collect();
        let mut queue = Self { blocks, block_of, waiting, degrees, coupled: (0..blocks.len()).collect() };
        queue.update(system);
        queue
    }

    /// The block with the fewest couplings to others; the first of several.
    fn take(&mut self, system: &System<'_>) -> Option<usize> {
        let (_, block) = self.waiting.pop_first()?;
        self.degrees[block] = None;
        let columns = self.blocks[block].iter().flat_map(|&row| system.matrix[row].keys());
        let mut coupled: Vec<usize> = columns.map(|&column| self.block_of[column]).collect();
        coupled.sort_unstable();
        coupled.dedup();
        coupled.retain(|&other| self.degrees[other].is_some());
        self.coupled = coupled;
        Some(block)
    }

    /// Counts the couplings of the blocks that the one taken last was coupled to.
    fn update(&mut self, system: &System<'_>) {
        for &block in &self.coupled {
            let entries = self.blocks[block].iter().flat_map(|&row| &system.matrix[row]);
            let entries = entries.filter(|&(_, &entry)| !system.program.is_zero(entry));
            let mut others: Vec<usize> = entries.map(|(&column, _)| self.block_of[column]).collect();
            work::count(others.len());
            others.sort_unstable();
            others.dedup();
            let left = others.iter().filter(|&&other| other != block && self.degrees[other].is_some());
            let degree = left.count();
            if let Some(before) = self.degrees[block].replace(degree) {
                self.waiting.remove(&(before, block));
            }
            self.waiting.insert((degree, block));
        }
    }
}
