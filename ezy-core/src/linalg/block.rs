//! Elimination of `A = G M⁻¹ Gᵀ` over blocks: a joint is a block, its rows are the rows of the block.

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
    joints: Vec<Parts>,
    /// Those of each joint one behind the other.
    slots: Vec<Slot<B>>,
    /// The body of each slot.
    slot_bodies: Vec<u32>,
    couplings: Vec<Coupling>,
    /// Blocks below the diagonal whose joints share no body.
    filled: Vec<u32>,
    /// Blocks on the diagonal of A; of a column that is eliminated, the inverse of its block of D.
    diagonal: Vec<Block<B>>,
    /// Diagonal of A, by joint.
    starts: Vec<Column<B>>,
    /// Blocks below the diagonal of A, column after column; of a column that is eliminated, those of L.
    lower: Vec<Block<B>>,
    /// The row of each.
    lower_rows: Vec<u32>,
    /// The blocks below the diagonal that the elimination of each column changes, from the last row to the first, counted from the column
    /// behind it.
    targets: Vec<u32>,
    /// Masses that `mobility` was made of.
    mass: Vec<f64>,
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

/// What belongs to a joint.
#[derive(Debug, Clone, Copy)]
struct Parts {
    /// Among the rows of G.
    first_row: u32,
    n_rows: u32,
    n_slots: u32,
    /// Blocks below the diagonal in its column.
    n_lower: u32,
}

impl Parts {
    /// The first row whose pivot is not more than `least`; where each is, the last one, whose pivot left the range of numbers.
    #[cold]
    fn vanished<const B: usize>(&self, pivots: &Column<B>, least: f64) -> VanishedPivot {
        let last = self.n_rows as usize - 1;
        let row = pivots.iter().position(|pivot| pivot.is_nan() || *pivot <= least).unwrap_or(last);
        VanishedPivot { relative: pivots[row], row: Some(self.first_row as usize + row) }
    }
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
                    let entries = pattern.starts[row]..pattern.starts[row + 1];
                    for (at, &column) in places[entries.clone()].iter_mut().zip(&pattern.columns[entries]) {
                        let (of, c) = body_and_component(column);
                        if of == body {
                            *at = (place(slot_bodies.len(), c) * B + r) as u32;
                        }
                    }
                }
                slot_bodies.push(body as u32);
            }
            slot_starts.push(slot_bodies.len() as u32);
        }
        let lower_rows: Vec<u32> = later.iter().flatten().map(|&row| row as u32).collect();
        let mut lower_starts = vec![0];
        later.iter().for_each(|list| lower_starts.push(lower_starts[lower_starts.len() - 1] + list.len()));
        let block_at =
            |column: usize, row: usize| later[column].binary_search(&row).ok().map(|at| lower_starts[column] + at);
        let mut targets = Vec::new();
        for (k, list) in later.iter().enumerate() {
            for (i, &row) in list.iter().enumerate().rev() {
                let blocks = list[..i].iter().filter_map(|&column| block_at(column, row));
                targets.extend(blocks.map(|block| (block - lower_starts[k + 1]) as u32));
            }
        }
        let slot_of = |k: usize, body: usize| {
            let Joint { bodies, .. } = &joints[k];
            bodies.iter().position(|&other| other == body).map(|at| slot_starts[k] + at as u32)
        };
        let (mut couplings, mut filled) = (Vec::new(), Vec::new());
        for (k, list) in later.iter().enumerate() {
            for (&row, block) in list.iter().zip(lower_starts[k] as u32..) {
                let mut adds = false;
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
        let parts = |(joint, later): (&Joint, &Vec<usize>)| Parts {
            first_row: joint.first_row as u32,
            n_rows: joint.n_rows as u32,
            n_slots: joint.bodies.len() as u32,
            n_lower: later.len() as u32,
        };
        Self {
            places,
            joints: joints.iter().zip(later).map(parts).collect(),
            slots: vec![[[0.0; B]; N_OF_BODY]; slot_bodies.len()],
            slot_bodies,
            couplings,
            filled,
            diagonal: vec![zero; joints.len()],
            starts: vec![[1.0; B]; joints.len()],
            lower: vec![zero; lower_rows.len()],
            lower_rows,
            targets,
            mass: vec![f64::NAN; n_q],
            mobility: vec![[0.0; N_OF_BODY]; n_bodies(n_q)],
            multipliers: vec![[0.0; B]; joints.len()],
            first: vec![[0.0; B]; joints.len()],
            smallest_pivot: 1.0,
            refines: false,
        }
    }

    /// Writes G by joints, and A; `damping` is added to its diagonal.
    fn assemble(&mut self, mass: &[f64], jacobian: &[f64], damping: Option<&[f64]>) {
        // all are compared, without a branch at each
        if self.mass.iter().zip(mass).fold(false, |differ, (known, m)| differ | (known != m)) {
            self.mass.copy_from_slice(mass);
            self.mobility.as_flattened_mut().iter_mut().zip(mass).for_each(|(mobility, m)| *mobility = 1.0 / m);
        }
        let entries = self.slots.as_flattened_mut().as_flattened_mut();
        for (&place, g) in self.places.iter().zip(jacobian) {
            entries[place as usize] = *g;
        }
        let Self { joints, slots, slot_bodies, diagonal, starts, lower, mobility, .. } = self;
        let mut held = Pairs(slots, slot_bodies);
        for ((joint, block), start) in joints.iter().zip(diagonal).zip(starts) {
            *block = [[0.0; B]; B];
            for (slot, &body) in held.take_first(joint.n_slots) {
                add_product(block, slot, &mobility[body as usize], slot);
            }
            let n_rows = joint.n_rows as usize;
            (n_rows..B).for_each(|r| block[r][r] = 1.0);
            if let Some(damping) = damping {
                (0..n_rows).for_each(|r| block[r][r] += damping[joint.first_row as usize + r]);
            }
            *start = std::array::from_fn(|r| block[r][r]);
        }
        self.filled.iter().for_each(|&block| lower[block as usize] = [[0.0; B]; B]);
        for Coupling { slots: [late, early], block, adds } in &self.couplings {
            let block = &mut lower[*block as usize];
            let mut sum = if *adds { *block } else { [[0.0; B]; B] };
            let mobility = &mobility[slot_bodies[*early as usize] as usize];
            add_product(&mut sum, &slots[*late as usize], mobility, &slots[*early as usize]);
            *block = sum;
        }
    }

    /// Factors A. The pivot of each row has to be more than the part `least` of what it started from.
    fn eliminate(&mut self, least: f64) -> Result<(), VanishedPivot> {
        let Self { joints, diagonal, starts, lower, lower_rows, targets, smallest_pivot, .. } = self;
        let (mut lower, mut rows, mut targets) = (&mut lower[..], &lower_rows[..], targets.iter());
        let mut smallest = 1.0;
        for ((k, joint), start) in joints.iter().enumerate().zip(starts) {
            let Fraction { numerator, denominator, pivots } = Fraction::inverse(&diagonal[k], start);
            if !(pivots.iter().all(|&pivot| pivot > least) && denominator.is_normal()) {
                return Err(joint.vanished(&pivots, least));
            }
            for pivot in pivots {
                smallest = if pivot < smallest { pivot } else { smallest };
            }
            // the products do not wait for the division
            let reciprocal = 1.0 / denominator;
            diagonal[k] = times(&numerator, reciprocal);
            let (column, own_rows);
            (column, lower) = lower.split_at_mut(joint.n_lower as usize);
            (own_rows, rows) = rows.split_at(joint.n_lower as usize);
            // the products of a row take the blocks above it as they were
            for (i, &row) in own_rows.iter().enumerate().rev() {
                let (above, block) = (&column[..i], column[i]);
                let scaled = numerator.map(|of_row| apply(&block, &of_row));
                for (above, &target) in above.iter().zip(&mut targets) {
                    subtract_product(&mut lower[target as usize], &scaled, above, reciprocal);
                }
                subtract_product(&mut diagonal[row as usize], &scaled, &block, reciprocal);
                column[i] = times(&scaled, reciprocal);
            }
        }
        *smallest_pivot = smallest;
        Ok(())
    }

    /// Takes from `x` what leaves `s` of its rows, by the multipliers that it writes: `L D Lᵀ y = G x − s`, then `x −= M⁻¹ Gᵀ y`.
    fn correct(&mut self, x: &mut [[f64; N_OF_BODY]], s: &[f64]) {
        let Self { joints, slots, slot_bodies, diagonal, lower, lower_rows, multipliers, mobility, .. } = self;
        let (mut held, mut column) = (Pairs(slots, slot_bodies), Pairs(lower, lower_rows));
        multipliers.fill([0.0; B]);
        for (k, joint) in joints.iter().enumerate() {
            let mut sum = multipliers[k];
            sum.iter_mut().zip(&s[joint.first_row as usize..][..joint.n_rows as usize]).for_each(|(sum, s)| *sum -= s);
            for (slot, &body) in held.take_first(joint.n_slots) {
                for (column, x) in slot.iter().zip(&x[body as usize]) {
                    sum.iter_mut().zip(column).for_each(|(sum, g)| *sum += g * x);
                }
            }
            multipliers[k] = sum;
            for (block, &row) in column.take_first(joint.n_lower) {
                let change = apply(block, &sum);
                multipliers[row as usize].iter_mut().zip(change).for_each(|(later, change)| *later -= change);
            }
        }
        let (mut held, mut column) = (Pairs(slots, slot_bodies), Pairs(lower, lower_rows));
        for ((k, joint), inverse) in joints.iter().enumerate().zip(diagonal).rev() {
            let mut solved = apply(inverse, &multipliers[k]);
            for (block, &row) in column.take_last(joint.n_lower) {
                let later = multipliers[row as usize];
                solved.iter_mut().zip(block).for_each(|(solved, of_row)| *solved -= dot(of_row, &later));
            }
            multipliers[k] = solved;
            for (slot, &body) in held.take_last(joint.n_slots) {
                let (x, mobility) = (x[body as usize].iter_mut(), &mobility[body as usize]);
                x.zip(mobility).zip(slot).for_each(|((x, mobility), column)| *x -= mobility * dot(column, &solved));
            }
        }
    }
}

/// Two lists side by side, taken from either end.
struct Pairs<'a, A, C>(&'a [A], &'a [C]);

impl<'a, A, C> Pairs<'a, A, C> {
    #[inline]
    fn take_first(&mut self, n: u32) -> impl Iterator<Item = (&'a A, &'a C)> + use<'a, A, C> {
        let (first, second);
        (first, self.0) = self.0.split_at(n as usize);
        (second, self.1) = self.1.split_at(n as usize);
        first.iter().zip(second)
    }

    #[inline]
    fn take_last(&mut self, n: u32) -> impl Iterator<Item = (&'a A, &'a C)> + use<'a, A, C> {
        let (first, second);
        (self.0, first) = self.0.split_at(self.0.len() - n as usize);
        (self.1, second) = self.1.split_at(self.1.len() - n as usize);
        first.iter().zip(second)
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
            (0..joint.n_rows as usize).for_each(|r| y[joint.first_row as usize + r] = solved[r]);
        }
    }

    fn describe(&self) -> String {
        let (n, n_lower) = (self.joints.len(), self.lower.len());
        let n_products = n_lower + self.targets.len();
        format!("blocks of {B} x {B}, {n} on the diagonal, {n_lower} below it, {n_products} products of blocks")
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

/// `block −= a bᵀ factor`.
#[inline]
fn subtract_product<const B: usize>(block: &mut Block<B>, a: &Block<B>, b: &Block<B>, factor: f64) {
    for (c, column) in block.iter_mut().enumerate() {
        let product = apply(a, &b.map(|of_row| of_row[c]));
        column.iter_mut().zip(product).for_each(|(entry, product)| *entry -= product * factor);
    }
}

#[inline]
fn times<const B: usize>(block: &Block<B>, factor: f64) -> Block<B> {
    block.map(|column| column.map(|entry| entry * factor))
}

#[inline]
fn dot<const B: usize>(a: &Column<B>, b: &Column<B>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[inline]
fn apply<const B: usize>(a: &Block<B>, x: &Column<B>) -> Column<B> {
    std::array::from_fn(|r| a.iter().zip(x).map(|(column, x)| column[r] * x).sum())
}

/// A block over a number.
struct Fraction<const B: usize> {
    numerator: Block<B>,
    denominator: f64,
    /// Of each row, relative to what it started from.
    pivots: Column<B>,
}

impl<const B: usize> Fraction<B> {
    /// Inverse of a positive definite block of one to three rows, of which the lower triangle is read.
    ///
    /// Of two rows it is the adjugate over the determinant a b − c², which loses the digits that the second pivot loses. The determinant of
    /// three would lose those of two pivots: a body that is light to turn, welded at a lever, makes both small. So the first row is
    /// eliminated, and the adjugate is that of what it leaves of the others.
    #[inline]
    fn inverse(block: &Block<B>, start: &Column<B>) -> Self {
        let (mut numerator, mut pivots) = ([[0.0; B]; B], [1.0; B]);
        let first = block[0][0];
        pivots[0] = first / start[0];
        let denominator = match B {
            1 => {
                numerator[0][0] = 1.0;
                first
            }
            2 => {
                let (c, b) = (block[0][1], block[1][1]);
                let determinant = first * b - c * c;
                pivots[1] = determinant / (first * start[1]);
                [numerator[0][0], numerator[0][1]] = [b, -c];
                [numerator[1][0], numerator[1][1]] = [-c, first];
                determinant
            }
            _ => {
                // [1 −lᵀ; 0 1] [1/first 0; 0 adjugate/determinant] [1 0; −l 1]
                let reciprocal = 1.0 / first;
                let l = [block[0][1] * reciprocal, block[0][2] * reciprocal];
                let a = block[1][1] - l[0] * block[0][1];
                let c = block[1][2] - l[0] * block[0][2];
                let b = block[2][2] - l[1] * block[0][2];
                let determinant = a * b - c * c;
                pivots[1] = a / start[1];
                pivots[2] = determinant / (a * start[2]);
                let [x, y] = [c * l[1] - b * l[0], c * l[0] - a * l[1]];
                let corner = determinant * reciprocal - x * l[0] - y * l[1];
                [numerator[0][0], numerator[0][1], numerator[0][2]] = [corner, x, y];
                [numerator[1][0], numerator[1][1], numerator[1][2]] = [x, b, -c];
                [numerator[2][0], numerator[2][1], numerator[2][2]] = [y, -c, a];
                determinant
            }
        };
        Self { numerator, denominator, pivots }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::tests::Numbers;

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
    fn assert_inverts<const B: usize>(numbers: &mut Numbers) {
        for trial in 0..2_000 {
            let mut block = [[0.0; B]; B];
            let mobility = std::array::from_fn(|_| 10_f64.powf(f64::from(trial % 6) * numbers.next()));
            let slot: Slot<B> = std::array::from_fn(|_| std::array::from_fn(|_| numbers.next()));
            add_product(&mut block, &slot, &mobility, &slot);
            let start = std::array::from_fn(|r| block[r][r]);
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
                std::array::from_fn(|c| std::array::from_fn(|r| block[c][r] * (start[c] * start[r]).powf(power)))
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
        assert_inverts::<1>(&mut numbers);
        assert_inverts::<2>(&mut numbers);
        assert_inverts::<3>(&mut numbers);
    }

    /// A body of inertia δ, welded with a lever: the block is 1 + g gᵀ/δ, its inverse 1 − g gᵀ/(δ + g²). Both last pivots are as small as δ,
    /// and only one of them costs digits.
    #[test]
    fn analytic_a_weld_with_a_lever_loses_one_pivot() {
        let g = [0.5, -0.75, 1.0];
        let square: f64 = g.iter().map(|g| g * g).sum();
        for delta in [1.0, 1e-3, 1e-6, 1e-10] {
            let one = |r: usize, c: usize| f64::from(u8::from(r == c));
            let block: Block<3> = std::array::from_fn(|c| std::array::from_fn(|r| one(r, c) + g[r] * g[c] / delta));
            let start = std::array::from_fn(|r| block[r][r]);
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
        let mut kkt = BlockKkt::<2>::new(3, &ROWS, &Plan::new(3, &ROWS, 2).unwrap());
        for (mass, is_taken) in [(1e150, true), (1e-150, true), (1e160, false), (1e-160, false), (f64::NAN, false)] {
            let factored = kkt.factor(&[mass; 3], &[1.0, 0.5, 1.0, 0.5]);
            assert_eq!(factored.is_ok(), is_taken, "{mass:e}: {factored:?}");
        }
    }
}
