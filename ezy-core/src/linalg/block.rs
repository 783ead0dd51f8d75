//! Elimination of `A = G M⁻¹ Gᵀ` over blocks: a joint is a block, its rows are the rows of the block.

#![allow(clippy::needless_range_loop, reason = "the triangles of a block are read by row and column")]

use super::joints::{Joint, Plan};
use super::tolerances::blocks::REFINED;
use super::{KktFactorization, VanishedPivot};
use crate::model::coordinate::{N_OF_BODY, body_and_component, n_bodies, place};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};

/// A column of a block: one number for each row of a joint.
type Column<const B: usize> = [f64; B];

/// The columns of a block of A.
type Block<const B: usize> = [Column<B>; B];

/// The part of G that one joint has of one body: a column for each coordinate.
type Slot<const B: usize> = [Column<B>; N_OF_BODY];

/// What one joint leaves of another, later one.
struct Coupling {
    /// Slots of a body that both hold: of the later joint and of the earlier one.
    slots: [u32; 2],
    block: u32,
    /// Whether another body of both was before it.
    adds: bool,
}

/// LDLᵀ factors of `A = G M⁻¹ Gᵀ`, which is what remains of K without its masses, for joints of up to `B` rows. Joints with fewer rows have ones on
/// the rest of their diagonal.
///
/// Nothing is filled in where bodies form trees, whatever their shape: the cost grows as their number.
struct BlockKkt<const B: usize> {
    /// Where each entry of G stands among the slots.
    places: Vec<u32>,
    joints: Vec<Rows>,
    /// Slots of each joint, and one more start.
    slot_starts: Vec<u32>,
    slots: Vec<Slot<B>>,
    /// The body of each slot.
    slot_bodies: Vec<u32>,
    /// Blocks of each column of A, the one on the diagonal first, and one more start.
    block_starts: Vec<u32>,
    /// The row of each block.
    block_rows: Vec<u32>,
    couplings: Vec<Coupling>,
    /// Blocks of joints that share no body.
    filled: Vec<u32>,
    /// The blocks that the elimination of each column changes, row after row.
    targets: Vec<u32>,
    blocks: Vec<Block<B>>,
    /// Diagonal of A, by joint.
    starts: Vec<Column<B>>,
    /// Inverses of the blocks on the diagonal of D.
    inverses: Vec<Block<B>>,
    /// One column of L.
    lower: Vec<Block<B>>,
    /// 1/m of the coordinates of each body.
    mobility: Vec<[f64; N_OF_BODY]>,
    /// Right side and solution, by joint.
    multipliers: Vec<Column<B>>,
    /// Multipliers before they are refined.
    first: Vec<Column<B>>,
    smallest_pivot: f64,
    /// Whether solutions are refined once.
    refines: bool,
}

/// Rows of a joint among those of G.
#[derive(Debug, Clone, Copy)]
struct Rows {
    first: u32,
    n: u32,
}

/// The elimination over blocks of a system with `n_q` coordinates, those of each body together; none where another one costs less.
pub(crate) fn by_joints(n_q: usize, jacobian: &SparsityPattern, n_rows: usize) -> Option<Box<dyn KktFactorization>> {
    let plan = Plan::new(n_q, jacobian, n_rows)?;
    Some(match plan.joints.iter().map(|joint| joint.n_rows).max() {
        None | Some(0 | 1) => Box::new(BlockKkt::<1>::new(n_q, jacobian, &plan)),
        Some(2) => Box::new(BlockKkt::<2>::new(n_q, jacobian, &plan)),
        Some(_) => Box::new(BlockKkt::<3>::new(n_q, jacobian, &plan)),
    })
}

impl<const B: usize> BlockKkt<B> {
    fn new(n_q: usize, pattern: &SparsityPattern, plan: &Plan) -> Self {
        let Plan { joints, later } = plan;
        let mut places = vec![0; pattern.n_nonzeros()];
        let (mut slot_starts, mut slot_bodies) = (vec![0], Vec::new());
        for joint in joints {
            for &body in &joint.bodies {
                for (r, row) in (joint.first_row..joint.first_row + joint.n_rows).enumerate() {
                    for k in pattern.starts[row]..pattern.starts[row + 1] {
                        let (of, c) = body_and_component(pattern.columns[k]);
                        if of == body {
                            places[k] = (place(slot_bodies.len(), c) * B + r) as u32;
                        }
                    }
                }
                slot_bodies.push(body as u32);
            }
            slot_starts.push(slot_bodies.len() as u32);
        }
        let (mut block_starts, mut block_rows) = (Vec::with_capacity(joints.len() + 1), Vec::new());
        for (k, list) in later.iter().enumerate() {
            block_starts.push(block_rows.len() as u32);
            block_rows.push(k as u32);
            block_rows.extend(list.iter().map(|&row| row as u32));
        }
        block_starts.push(block_rows.len() as u32);
        let block_at = |column: usize, row: usize| {
            let behind = later[column].binary_search(&row).map_or(0, |at| at + 1);
            block_starts[column] + behind as u32
        };
        let mut targets = Vec::new();
        for list in later {
            for (i, &row) in list.iter().enumerate() {
                targets.extend(list[..=i].iter().map(|&column| block_at(column, row)));
            }
        }
        let slot_of = |k: usize, body: usize| {
            let Joint { bodies, .. } = &joints[k];
            bodies.iter().position(|&other| other == body).map(|at| slot_starts[k] + at as u32)
        };
        let (mut couplings, mut filled) = (Vec::new(), Vec::new());
        for (k, list) in later.iter().enumerate() {
            for &row in list {
                let (block, mut adds) = (block_at(k, row), false);
                for &body in &joints[k].bodies {
                    if let (Some(late), Some(early)) = (slot_of(row, body), slot_of(k, body)) {
                        couplings.push(Coupling { slots: [late, early], block, adds });
                        adds = true;
                    }
                }
                if !adds {
                    filled.push(block);
                }
            }
        }
        let zero = [[0.0; B]; B];
        Self {
            places,
            joints: joints.iter().map(|of| Rows { first: of.first_row as u32, n: of.n_rows as u32 }).collect(),
            slot_starts,
            slots: vec![[[0.0; B]; N_OF_BODY]; slot_bodies.len()],
            slot_bodies,
            blocks: vec![zero; block_rows.len()],
            block_starts,
            block_rows,
            couplings,
            filled,
            targets,
            starts: vec![[1.0; B]; joints.len()],
            inverses: vec![zero; joints.len()],
            lower: vec![zero; later.iter().map(Vec::len).max().unwrap_or(0)],
            mobility: vec![[0.0; N_OF_BODY]; n_bodies(n_q)],
            multipliers: vec![[0.0; B]; joints.len()],
            first: vec![[0.0; B]; joints.len()],
            smallest_pivot: 1.0,
            refines: false,
        }
    }

    /// Writes G by joints, and A; `damping` is added to its diagonal.
    fn assemble(&mut self, mass: &[f64], jacobian: &[f64], damping: Option<&[f64]>) {
        self.mobility.as_flattened_mut().iter_mut().zip(mass).for_each(|(mobility, m)| *mobility = 1.0 / m);
        let entries = self.slots.as_flattened_mut().as_flattened_mut();
        for (&place, g) in self.places.iter().zip(jacobian) {
            entries[place as usize] = *g;
        }
        let Self { joints, slot_starts, slots, slot_bodies, block_starts, blocks, starts, mobility, .. } = self;
        for ((k, joint), start) in joints.iter().enumerate().zip(starts) {
            let mut block = [[0.0; B]; B];
            let own = slot_starts[k] as usize..slot_starts[k + 1] as usize;
            for (slot, &body) in slots[own.clone()].iter().zip(&slot_bodies[own]) {
                add_product(&mut block, slot, &mobility[body as usize], slot);
            }
            for (r, column) in block.iter_mut().enumerate() {
                if r < joint.n as usize {
                    column[r] += damping.map_or(0.0, |damping| damping[joint.first as usize + r]);
                } else {
                    column[r] = 1.0;
                }
                start[r] = column[r];
            }
            blocks[block_starts[k] as usize] = block;
        }
        self.filled.iter().for_each(|&block| blocks[block as usize] = [[0.0; B]; B]);
        for Coupling { slots: [late, early], block, adds } in &self.couplings {
            let block = &mut blocks[*block as usize];
            let mut sum = if *adds { *block } else { [[0.0; B]; B] };
            let mobility = &mobility[slot_bodies[*early as usize] as usize];
            add_product(&mut sum, &slots[*late as usize], mobility, &slots[*early as usize]);
            *block = sum;
        }
    }

    /// Factors A. The pivot of each row has to be more than the part `least` of what it started from.
    fn eliminate(&mut self, least: f64) -> Result<(), VanishedPivot> {
        let Self { joints, block_starts, targets, blocks, starts, inverses, lower, smallest_pivot, .. } = self;
        let mut targets = targets.iter();
        *smallest_pivot = 1.0;
        for ((k, joint), (start, inverse)) in joints.iter().enumerate().zip(starts.iter().zip(inverses)) {
            let first = block_starts[k] as usize;
            let (diagonal, rest) = blocks.split_at_mut(first + 1);
            let pivots = invert(&diagonal[first], inverse);
            for r in 0..B {
                let relative = pivots[r] / start[r];
                if relative.is_nan() || relative <= least {
                    return Err(VanishedPivot { relative, row: Some(joint.first as usize + r) });
                }
                *smallest_pivot = smallest_pivot.min(relative);
            }
            let column = &rest[..block_starts[k + 1] as usize - first - 1];
            let lower = &mut lower[..column.len()];
            for (l, block) in lower.iter_mut().zip(column) {
                *l = inverse.map(|of_row| apply(block, &of_row));
            }
            for (i, l) in lower.iter().enumerate() {
                for (j, &target) in (0..=i).zip(&mut targets) {
                    let block = rest[j];
                    subtract_product(&mut rest[target as usize - first - 1], l, &block);
                }
            }
        }
        Ok(())
    }

    /// Takes from `x` what leaves `s` of its rows, by the multipliers that it writes.
    fn correct(&mut self, x: &mut [[f64; N_OF_BODY]], s: &[f64]) {
        let Self { joints, slot_starts, slots, slot_bodies, multipliers, .. } = self;
        for ((k, joint), sum) in joints.iter().enumerate().zip(multipliers) {
            let given = &s[joint.first as usize..][..joint.n as usize];
            *sum = std::array::from_fn(|r| given.get(r).map_or(0.0, |s| -s));
            let own = slot_starts[k] as usize..slot_starts[k + 1] as usize;
            for (slot, &body) in slots[own.clone()].iter().zip(&slot_bodies[own]) {
                for (column, x) in slot.iter().zip(&x[body as usize]) {
                    sum.iter_mut().zip(column).for_each(|(sum, g)| *sum += g * x);
                }
            }
        }
        self.substitute();
        let Self { slot_starts, slots, slot_bodies, multipliers, mobility, .. } = self;
        for (k, solved) in multipliers.iter().enumerate() {
            let own = slot_starts[k] as usize..slot_starts[k + 1] as usize;
            for (slot, &body) in slots[own.clone()].iter().zip(&slot_bodies[own]) {
                let (x, mobility) = (x[body as usize].iter_mut(), &mobility[body as usize]);
                x.zip(mobility).zip(slot).for_each(|((x, mobility), column)| *x -= mobility * dot(column, solved));
            }
        }
    }

    /// Solves `A y = b` in `multipliers`.
    fn substitute(&mut self) {
        let Self { blocks, inverses, block_starts, block_rows, multipliers, .. } = self;
        let column = |k: usize| block_starts[k] as usize + 1..block_starts[k + 1] as usize;
        for (k, inverse) in inverses.iter().enumerate() {
            let solved = apply(inverse, &multipliers[k]);
            for (&row, block) in block_rows[column(k)].iter().zip(&blocks[column(k)]) {
                let change = apply(block, &solved);
                multipliers[row as usize].iter_mut().zip(change).for_each(|(x, change)| *x -= change);
            }
        }
        for (k, inverse) in inverses.iter().enumerate().rev() {
            let mut left = multipliers[k];
            for (&row, block) in block_rows[column(k)].iter().zip(&blocks[column(k)]) {
                let solved = multipliers[row as usize];
                left.iter_mut().zip(block).for_each(|(left, of_row)| *left -= dot(of_row, &solved));
            }
            multipliers[k] = apply(inverse, &left);
        }
    }
}

impl<const B: usize> KktFactorization for BlockKkt<B> {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.assemble(mass, jacobian, None);
        self.eliminate(PIVOT_TOLERANCE)?;
        self.refines = self.smallest_pivot < REFINED;
        Ok(())
    }

    fn factor_damped(&mut self, mass: &[f64], jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.assemble(mass, jacobian, Some(damping));
        self.refines = false;
        self.eliminate(0.0)
    }

    fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    /// From x = M⁻¹ r and y = 0 on: what x leaves of its rows, `A δ = G x − s`, is taken from x by `M⁻¹ Gᵀ δ`. Once gives the solution; once more
    /// gives back the digits that small pivots cost.
    fn solve(&mut self, right_side: &mut [f64]) {
        let (x, y) = right_side.split_at_mut(N_OF_BODY * self.mobility.len());
        let x = x.as_chunks_mut::<N_OF_BODY>().0;
        for (x, mobility) in x.iter_mut().zip(&self.mobility) {
            x.iter_mut().zip(mobility).for_each(|(x, mobility)| *x *= *mobility);
        }
        if self.refines {
            self.correct(x, y);
            self.first.copy_from_slice(&self.multipliers);
        }
        self.correct(x, y);
        if self.refines {
            let multipliers = self.multipliers.as_flattened_mut().iter_mut();
            multipliers.zip(self.first.as_flattened()).for_each(|(sum, first)| *sum += first);
        }
        for (joint, solved) in self.joints.iter().zip(&self.multipliers) {
            y[joint.first as usize..][..joint.n as usize].iter_mut().zip(solved).for_each(|(y, solved)| *y = *solved);
        }
    }

    fn describe(&self) -> String {
        let (n, n_blocks, n_products) = (self.joints.len(), self.blocks.len(), self.targets.len());
        format!("blocks of {B} x {B}, {n} on the diagonal, {} below it, {n_products} products of blocks", n_blocks - n)
    }
}

/// `block += G_a M⁻¹ G_bᵀ`.
#[inline]
fn add_product<const B: usize>(block: &mut Block<B>, a: &Slot<B>, mobility: &[f64; N_OF_BODY], b: &Slot<B>) {
    for ((a, b), mobility) in a.iter().zip(b).zip(mobility) {
        for (column, b) in block.iter_mut().zip(b) {
            let b = b * mobility;
            column.iter_mut().zip(a).for_each(|(entry, a)| *entry += a * b);
        }
    }
}

/// `block −= a bᵀ`.
#[inline]
fn subtract_product<const B: usize>(block: &mut Block<B>, a: &Block<B>, b: &Block<B>) {
    for (a, b) in a.iter().zip(b) {
        for (column, b) in block.iter_mut().zip(b) {
            column.iter_mut().zip(a).for_each(|(entry, a)| *entry -= a * b);
        }
    }
}

#[inline]
fn dot<const B: usize>(a: &Column<B>, b: &Column<B>) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

#[inline]
fn apply<const B: usize>(a: &Block<B>, x: &Column<B>) -> Column<B> {
    let mut product = [0.0; B];
    for (column, x) in a.iter().zip(x) {
        product.iter_mut().zip(column).for_each(|(sum, a)| *sum += a * x);
    }
    product
}

/// Inverse of a symmetric block, and its pivots from the first row to the last.
#[inline]
fn invert<const B: usize>(block: &Block<B>, inverse: &mut Block<B>) -> Column<B> {
    let mut lower = *block;
    let [mut pivots, mut reciprocals] = [[0.0; B]; 2];
    for j in 0..B {
        pivots[j] = lower[j][j];
        reciprocals[j] = 1.0 / pivots[j];
        for i in j + 1..B {
            let l = lower[j][i] * reciprocals[j];
            for c in i..B {
                lower[i][c] -= l * lower[j][c];
            }
        }
        for i in j + 1..B {
            lower[j][i] *= reciprocals[j];
        }
    }
    // L⁻ᵀ D⁻¹ L⁻¹, column after column
    for c in 0..B {
        let mut x = [0.0; B];
        x[c] = 1.0;
        for i in c + 1..B {
            for j in c..i {
                x[i] -= lower[j][i] * x[j];
            }
        }
        for i in (0..B).rev() {
            x[i] *= reciprocals[i];
            for j in i + 1..B {
                x[i] -= lower[i][j] * x[j];
            }
        }
        inverse[c] = x;
    }
    pivots
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows of one body that are `angle` apart, so that the second pivot is sin²: x = 0, whatever pushes, and y with the digits that the
    /// angle has. Where the pivot is not small nothing is spent on it.
    #[test]
    fn analytic_small_pivots_cost_no_digits() {
        const ROWS: SparsityPattern = SparsityPattern::new(&[0, 3, 6], &[0, 1, 2, 0, 1, 2]);
        let mut kkt = BlockKkt::<2>::new(3, &ROWS, &Plan::new(3, &ROWS, 2).unwrap());
        for (angle, refines) in [(0.5_f64, false), (0.1, false), (1e-2, true), (1e-4, true)] {
            let (sin, cos) = angle.sin_cos();
            kkt.factor(&[1.0; 3], &[1.0, 0.0, 0.0, cos, sin, 0.0]).unwrap();
            assert_eq!(kkt.refines, refines, "{angle}");
            // y_2 sin = 3, and y_1 + y_2 cos = 2
            let mut x = [2.0, 3.0, 0.0, 0.0, 0.0];
            kkt.solve(&mut x);
            let second = 3.0 / sin;
            let first = 2.0 - second * cos;
            let lost = ((x[4] - second) / second).abs().max(((x[3] - first) / first).abs());
            let bound = f64::EPSILON * if refines { 8.0 / angle } else { 8.0 / (sin * sin) };
            assert!(lost <= bound && x[0].abs().max(x[1].abs()) <= 6.0 * bound, "{angle}: {lost:e}, {x:?}");
        }
    }
}
