//! Elimination of `A = G M⁻¹ Gᵀ` over blocks: a joint is a block, its rows are the rows of the block.

mod columns;
mod form;
mod fraction;
#[cfg(test)]
mod tests;

use super::joints::{BODIES, Plan};
use super::tolerances::blocks::REFINED;
use super::{KktFactorization, VanishedPivot};
use crate::model::coordinate::{N_OF_BODY, body_and_component, n_bodies};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use columns::{Below, Columns, Node};
use form::{Aligned, Form, Full};
use fraction::Fraction;
use std::array::from_fn;
use std::marker::PhantomData;

/// A column of a block: one number for each row of a joint.
type Column<const B: usize> = [f64; B];

/// The columns of a block of A.
type Block<const B: usize> = [Column<B>; B];

/// LDLᵀ factors of `A = G M⁻¹ Gᵀ`, which is what remains of K without its masses, for joints of up to `B` rows. Joints with fewer rows have ones on
/// the rest of their diagonal.
///
/// Nothing is filled in where bodies form trees, whatever their shape: the cost grows as their number.
struct BlockKkt<F, const B: usize, const N: usize> {
    form: PhantomData<F>,
    /// Where each entry of G stands among the slots.
    places: Vec<u32>,
    nodes: Vec<Node<B>>,
    /// The part of Γ of each body of a joint.
    slots: Vec<[[f64; N]; BODIES]>,
    /// What eliminated columns leave on the diagonal.
    pending: Vec<Block<B>>,
    below: Vec<Below>,
    /// Columns that have not just one block below the diagonal, or to whose block others add, one after the other: what eliminated columns leave
    /// below the diagonal; of a column that is eliminated, the blocks of L.
    lower: Vec<Block<B>>,
    /// The blocks below the diagonal that the elimination of each column changes, from the last row to the first, counted from the column
    /// behind it.
    targets: Vec<u32>,
    /// Masses that the roots were made of.
    mass: Vec<f64>,
    /// M^−½ by body.
    roots: Vec<[f64; N_OF_BODY]>,
    /// That of the column of each entry of G.
    entry_roots: Vec<f64>,
    /// The column of each entry of G, for new masses.
    columns: Vec<u32>,
    /// M^½ x of the right side and of the solution, by body.
    x: Vec<[f64; N_OF_BODY]>,
    /// y of the right side and of the solution, by joint.
    y: Vec<Column<B>>,
    /// That before it is refined.
    first: Vec<Column<B>>,
    smallest_pivot: f64,
    /// Whether solutions are refined once.
    refines: bool,
}

/// The elimination over blocks of a system with `n_q` coordinates, those of each body together; none where another one costs less.
pub(crate) fn by_joints(n_q: usize, jacobian: &SparsityPattern, n_rows: usize) -> Option<Box<dyn KktFactorization>> {
    let plan = Plan::new(n_q, jacobian, n_rows)?;
    Some(match plan.joints.iter().map(|joint| joint.n_rows).max() {
        None | Some(0 | 1) => Box::new(BlockKkt::<Full, 1, 3>::new(n_q, jacobian, &plan)),
        Some(2) if are_aligned(jacobian, &plan) => Box::new(BlockKkt::<Aligned, 2, 4>::new(n_q, jacobian, &plan)),
        Some(2) => Box::new(BlockKkt::<Full, 2, 6>::new(n_q, jacobian, &plan)),
        Some(_) => Box::new(BlockKkt::<Full, 3, 9>::new(n_q, jacobian, &plan)),
    })
}

fn are_aligned(pattern: &SparsityPattern, plan: &Plan) -> bool {
    plan.joints.iter().all(|joint| {
        let mut entries = joint.entries(pattern);
        joint.n_rows == 2 && entries.all(|(_, row, column)| Aligned::place(row, body_and_component(column).1).is_some())
    })
}

impl<F: Form<B, N>, const B: usize, const N: usize> BlockKkt<F, B, N> {
    fn new(n_q: usize, pattern: &SparsityPattern, plan: &Plan) -> Self {
        let Columns { nodes, below, targets } = Columns::new(plan);
        let mut places = vec![0; pattern.n_nonzeros()];
        for (k, joint) in plan.joints.iter().enumerate() {
            for (entry, row, column) in joint.entries(pattern) {
                let (body, component) = body_and_component(column);
                if let (Some(side), Some(at)) = (joint.side_of(body), F::place(row, component)) {
                    places[entry] = ((k * BODIES + side) * N + at) as u32;
                }
            }
        }
        let n_blocks = below.len();
        Self {
            form: PhantomData,
            places,
            pending: vec![[[0.0; B]; B]; nodes.len()],
            x: vec![[0.0; N_OF_BODY]; n_bodies(n_q)],
            y: vec![[0.0; B]; nodes.len()],
            first: vec![[0.0; B]; nodes.len()],
            slots: vec![[[0.0; N]; BODIES]; nodes.len()],
            nodes,
            lower: vec![[[0.0; B]; B]; n_blocks],
            below,
            targets,
            mass: vec![f64::NAN; n_q],
            roots: vec![[0.0; N_OF_BODY]; n_bodies(n_q)],
            entry_roots: vec![0.0; pattern.n_nonzeros()],
            columns: pattern.columns.iter().map(|&column| column as u32).collect(),
            smallest_pivot: 1.0,
            refines: false,
        }
    }

    /// Writes Γ by joints.
    fn place(&mut self, mass: &[f64], jacobian: &[f64]) {
        // all are compared, without a branch at each
        if self.mass.iter().zip(mass).fold(false, |differ, (known, m)| differ | (known != m)) {
            self.mass.copy_from_slice(mass);
            let roots = self.roots.as_flattened_mut();
            roots.iter_mut().zip(mass).for_each(|(root, m)| *root = 1.0 / m.sqrt());
            self.entry_roots.iter_mut().zip(&self.columns).for_each(|(root, &column)| *root = roots[column as usize]);
        }
        let entries = self.slots.as_flattened_mut().as_flattened_mut();
        let (places, more) = self.places.as_chunks::<4>();
        let (roots, more_roots) = self.entry_roots.as_chunks::<4>();
        let (jacobian, more_of_g) = jacobian.as_chunks::<4>();
        for ((places, roots), g) in places.iter().zip(roots).zip(jacobian) {
            (0..4).for_each(|i| entries[places[i] as usize] = g[i] * roots[i]);
        }
        for ((&place, root), g) in more.iter().zip(more_roots).zip(more_of_g) {
            entries[place as usize] = g * root;
        }
    }

    /// Factors A; `damping` is added to its diagonal. The pivot of each row has to be more than the part `least` of what it started from.
    ///
    /// Where `s` is given, forward substitution ([`Self::forward`]) is done in the same sweep: both are chains of dependent operations, and the
    /// processor overlaps them.
    fn eliminate(&mut self, damping: Option<&[f64]>, least: f64, s: Option<&[f64]>) -> Result<(), VanishedPivot> {
        let Self { nodes, slots, pending, below, lower, targets, smallest_pivot, x, y, .. } = self;
        let (mut lower, mut below, mut targets) = (&mut lower[..], &below[..], targets.iter());
        let mut smallest = 1.0;
        pending.fill([[0.0; B]; B]);
        lower.iter_mut().zip(below).filter(|(_, of)| of.is_filled).for_each(|(block, _)| *block = [[0.0; B]; B]);
        y.fill([0.0; B]);
        for (k, (joint, own_slots)) in nodes.iter_mut().zip(&*slots).enumerate() {
            let [first, second] = own_slots;
            let mut own = sum(&F::product(first, first), &F::product(second, second));
            if !F::WHOLE {
                (joint.n_rows as usize..B).for_each(|r| own[r][r] = 1.0);
            }
            if let Some(damping) = damping {
                let damping = rows::<F, B, N>(joint, damping);
                (0..B).for_each(|r| own[r][r] += damping[r]);
            }
            let start = from_fn(|r| own[r][r]);
            let Fraction { numerator, denominator, pivots } = Fraction::inverse(&sum(&own, &pending[k]), &start);
            if !(pivots.iter().all(|&pivot| pivot > least) && denominator.is_normal()) {
                return Err(joint.vanished(&pivots, least));
            }
            for pivot in pivots {
                smallest = if pivot < smallest { pivot } else { smallest };
            }
            // the products do not wait for the division
            let reciprocal = 1.0 / denominator;
            joint.inverse = times(&numerator, reciprocal);
            if joint.next > 0 {
                let later = k + joint.next as usize;
                let [here, there] = joint.shared.map(usize::from);
                let block = F::product(&slots[later][there], &own_slots[here]);
                let scaled = numerator.map(|of_row| apply(&block, &of_row));
                subtract_product(&mut pending[later], &scaled, &block, reciprocal);
                joint.lower = times(&scaled, reciprocal);
                if let Some(s) = s {
                    forward::<F, B, N, _>(k, joint, own_slots, std::iter::empty, x, s, y);
                }
                continue;
            }
            let (column, of_column);
            (column, lower) = lower.split_at_mut(joint.n_lower as usize);
            (of_column, below) = below.split_at(joint.n_lower as usize);
            for (block, of) in column.iter_mut().zip(of_column) {
                let mut entries = if of.is_filled { *block } else { [[0.0; B]; B] };
                for (early, &late) in own_slots.iter().zip(&of.late) {
                    if let Some(late) = slots[of.row as usize].get(late as usize) {
                        entries = sum(&entries, &F::product(late, early));
                    }
                }
                *block = entries;
            }
            // the products of a row take the blocks above it as they were
            for (i, of) in of_column.iter().enumerate().rev() {
                let (above, block) = (&column[..i], column[i]);
                let scaled = numerator.map(|of_row| apply(&block, &of_row));
                for (above, &target) in above.iter().zip(&mut targets) {
                    subtract_product(&mut lower[target as usize], &scaled, above, reciprocal);
                }
                subtract_product(&mut pending[of.row as usize], &scaled, &block, reciprocal);
                column[i] = times(&scaled, reciprocal);
            }
            if let Some(s) = s {
                forward::<F, B, N, _>(k, joint, own_slots, || column.iter().zip(of_column), x, s, y);
            }
        }
        *smallest_pivot = smallest;
        Ok(())
    }

    /// `L y = Γ x − s`.
    fn forward(&mut self, s: &[f64]) {
        let Self { nodes, slots, lower, below, x, y, .. } = self;
        y.fill([0.0; B]);
        let mut column = Pairs(lower, below);
        for (k, (joint, slots)) in nodes.iter().zip(slots).enumerate() {
            forward::<F, B, N, _>(k, joint, slots, || column.take_first(joint.n_lower), x, s, y);
        }
    }

    /// `D Lᵀ y = y`, then `x −= Γᵀ y`.
    fn backward(&mut self) {
        let Self { nodes, slots, lower, below, x, y, .. } = self;
        let mut column = Pairs(lower, below);
        for (k, (joint, slots)) in nodes.iter().zip(slots).enumerate().rev() {
            let mut solved = apply(&joint.inverse, &y[k]);
            let mut pull =
                |block: &Block<B>, later: usize| subtract(&mut solved, &block.map(|of_row| dot(&of_row, &y[later])));
            match joint.next {
                0 => column.take_last(joint.n_lower).for_each(|(block, of)| pull(block, of.row as usize)),
                next => pull(&joint.lower, k + next as usize),
            }
            y[k] = solved;
            for (slot, &body) in slots.iter().zip(&joint.bodies) {
                F::subtract_transposed(&mut x[body as usize], slot, &solved);
            }
        }
    }

    /// Takes from x what leaves s of its rows, by `M^−½ Γᵀ y` with `A y = G x − s`: with x = M⁻¹ r it gives the solution; once more, with y = 0, it
    /// gives back the digits that small pivots cost. [`Self::forward`] was called before.
    fn finish(&mut self, right_side: &mut [f64]) {
        let (r, s) = right_side.split_at_mut(self.roots.as_flattened().len());
        self.backward();
        if self.refines {
            self.first.copy_from_slice(&self.y);
            self.forward(s);
            self.backward();
            let sums = self.y.as_flattened_mut().iter_mut();
            sums.zip(self.first.as_flattened()).for_each(|(sum, first)| *sum += first);
        }
        let x = self.x.as_flattened().iter().zip(self.roots.as_flattened());
        r.iter_mut().zip(x).for_each(|(r, (x, root))| *r = x * root);
        for (joint, y) in self.nodes.iter().zip(&self.y) {
            if F::WHOLE {
                s.as_chunks_mut::<B>().0[joint.first_row as usize / B] = *y;
            } else {
                let s = &mut s[joint.first_row as usize..][..joint.n_rows as usize];
                s.iter_mut().zip(y).for_each(|(s, y)| *s = *y);
            }
        }
    }

    /// Takes x of a right side, and returns the other part.
    fn take<'r>(&mut self, right_side: &'r [f64]) -> &'r [f64] {
        let (r, s) = right_side.split_at(self.roots.as_flattened().len());
        let of_x = self.x.as_flattened_mut().iter_mut().zip(self.roots.as_flattened());
        of_x.zip(r).for_each(|((x, root), r)| *x = r * root);
        s
    }
}

/// The rows of a joint in a vector that has one number for each row of G.
#[inline]
fn rows<F: Form<B, N>, const B: usize, const N: usize>(joint: &Node<B>, of: &[f64]) -> Column<B> {
    let first = joint.first_row as usize;
    if F::WHOLE {
        return of.as_chunks::<B>().0[first / B];
    }
    let mut rows = [0.0; B];
    rows.iter_mut().zip(&of[first..][..joint.n_rows as usize]).for_each(|(row, of)| *row = *of);
    rows
}

/// The part of a joint in `L y = Γ x − s`, with its column in the list.
#[inline]
fn forward<'a, F: Form<B, N>, const B: usize, const N: usize, I: Iterator<Item = (&'a Block<B>, &'a Below)>>(
    k: usize,
    joint: &Node<B>,
    slots: &[[f64; N]; BODIES],
    column: impl FnOnce() -> I,
    x: &[[f64; N_OF_BODY]],
    s: &[f64],
    y: &mut [Column<B>],
) {
    let mut sum = rows::<F, B, N>(joint, s).map(|s| -s);
    for (slot, &body) in slots.iter().zip(&joint.bodies) {
        F::add(&mut sum, slot, &x[body as usize]);
    }
    // what waits for earlier joints comes last
    sum.iter_mut().zip(y[k]).for_each(|(sum, y)| *sum += y);
    y[k] = sum;
    if joint.next > 0 {
        subtract(&mut y[k + joint.next as usize], &apply(&joint.lower, &sum));
    } else {
        column().for_each(|(block, of)| subtract(&mut y[of.row as usize], &apply(block, &sum)));
    }
}

#[inline]
fn subtract<const B: usize>(sum: &mut Column<B>, x: &Column<B>) {
    sum.iter_mut().zip(x).for_each(|(sum, x)| *sum -= x);
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

impl<F: Form<B, N>, const B: usize, const N: usize> KktFactorization for BlockKkt<F, B, N> {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.place(mass, jacobian);
        self.eliminate(None, PIVOT_TOLERANCE, None)?;
        self.refines = self.smallest_pivot < REFINED;
        Ok(())
    }

    fn factor_damped(&mut self, mass: &[f64], jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.place(mass, jacobian);
        self.refines = false;
        self.eliminate(Some(damping), 0.0, None)
    }

    fn factor_and_solve(
        &mut self,
        mass: &[f64],
        jacobian: &[f64],
        right_side: &mut [f64],
    ) -> Result<(), VanishedPivot> {
        self.place(mass, jacobian);
        let s = self.take(right_side);
        self.eliminate(None, PIVOT_TOLERANCE, Some(s))?;
        self.refines = self.smallest_pivot < REFINED;
        self.finish(right_side);
        Ok(())
    }

    fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    fn solve(&mut self, right_side: &mut [f64]) {
        let s = self.take(right_side);
        self.forward(s);
        self.finish(right_side);
    }

    fn describe(&self) -> String {
        let n_alone = self.nodes.iter().filter(|node| node.next > 0).count();
        let (n, n_lower) = (self.nodes.len(), self.lower.len() + n_alone);
        let n_products = n_lower + self.targets.len();
        format!("blocks of {B} x {B}, {n} on the diagonal, {n_lower} below it, {n_products} products of blocks")
    }
}

#[inline]
fn sum<const B: usize>(a: &Block<B>, b: &Block<B>) -> Block<B> {
    from_fn(|c| from_fn(|r| a[c][r] + b[c][r]))
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
    from_fn(|r| a.iter().zip(x).map(|(column, x)| column[r] * x).sum())
}
