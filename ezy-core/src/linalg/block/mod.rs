//! Elimination of `A = G M⁻¹ Gᵀ` over blocks: a joint is a block, its rows are the rows of the block.

mod columns;
mod form;
mod fraction;
mod paths;
#[cfg(test)]
mod tests;
mod two;

use super::joints::{BODIES, Plan};
use super::tolerances::blocks::{NEGLIGIBLE, REFINED};
use super::{KktFactorization, VanishedPivot};
use crate::model::coordinate::{N_OF_BODY, body_and_component, n_bodies};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use columns::{Below, Columns, Node};
use form::{Aligned, Form, Full, Layout, turned};
use fraction::Fraction;
use paths::{Given, Paths};
use std::array::from_fn;
use std::marker::PhantomData;
use std::ops::Range;
use two::Number;

/// A column of a block: one number for each row of a joint.
type Column<const B: usize, T = f64> = [T; B];

/// The columns of a block of A.
type Block<const B: usize, T = f64> = [Column<B, T>; B];

/// Numbers of a body.
type OfBody<T = f64> = [T; N_OF_BODY];

/// r by body, which substitution scales by the roots.
#[derive(Clone, Copy)]
struct Bodies<'a> {
    of: &'a [OfBody],
    roots: &'a [OfBody],
}

impl Bodies<'_> {
    #[inline(always)]
    fn at(&self, body: u32) -> OfBody {
        let (of, roots) = (&self.of[body as usize], &self.roots[body as usize]);
        from_fn(|i| of[i] * roots[i])
    }
}

/// A right side `[r; s]`.
type RightSide<'a> = (Bodies<'a>, &'a [f64]);

/// LDLᵀ factors of `A = G M⁻¹ Gᵀ`, which is what remains of K without its masses, for joints of up to `B` rows. Joints with fewer rows have ones on
/// the rest of their diagonal.
///
/// Nothing is filled in where bodies form trees, whatever their shape: the cost grows as their number.
struct BlockKkt<F, const B: usize, const N: usize> {
    form: PhantomData<F>,
    paths: Vec<Paths<B, N>>,
    /// Joints that are in no path.
    nodes: Vec<Node<B, N>>,
    /// How entries of joints stand in G; the usual one first, then that one turned.
    layouts: Vec<Layout<N>>,
    below: Vec<Below>,
    /// Columns that have not just one block below the diagonal, or to whose block others add, one after the other: what eliminated columns leave
    /// below the diagonal; of a column that is eliminated, the blocks of L.
    lower: Vec<Block<B>>,
    /// The blocks below the diagonal that the elimination of each column changes, from the last row to the first, counted from the column
    /// behind it.
    targets: Vec<u32>,
    /// M^−½ by body.
    roots: Vec<OfBody>,
    /// Bodies that do not lie within a path.
    others: Vec<Range<usize>>,
    smallest_pivot: f64,
    /// Whether solutions are refined once.
    refines: bool,
}

/// The elimination over blocks of a system with these masses, the coordinates of each body together; none where another one costs less.
pub(crate) fn by_joints(mass: &[f64], jacobian: &SparsityPattern, n_rows: usize) -> Option<Box<dyn KktFactorization>> {
    let plan = Plan::new(mass.len(), jacobian, n_rows)?;
    Some(match plan.joints.iter().map(|joint| joint.n_rows).max() {
        None | Some(0 | 1) => Box::new(BlockKkt::<Full, 1, 3>::new(mass, jacobian, &plan)),
        Some(2) if are_aligned(jacobian, &plan) => Box::new(BlockKkt::<Aligned, 2, 4>::new(mass, jacobian, &plan)),
        Some(2) => Box::new(BlockKkt::<Full, 2, 6>::new(mass, jacobian, &plan)),
        Some(_) => Box::new(BlockKkt::<Full, 3, 9>::new(mass, jacobian, &plan)),
    })
}

fn are_aligned(pattern: &SparsityPattern, plan: &Plan) -> bool {
    plan.joints.iter().all(|joint| {
        let mut entries = joint.entries(pattern);
        joint.n_rows == 2 && entries.all(|(_, row, column)| Aligned::place(row, body_and_component(column).1).is_some())
    })
}

impl<F: Form<B, N>, const B: usize, const N: usize> BlockKkt<F, B, N> {
    fn new(mass: &[f64], pattern: &SparsityPattern, plan: &Plan) -> Self {
        let mut layouts = vec![F::USUAL, turned(F::USUAL)];
        let negligible = NEGLIGIBLE * mass.iter().copied().fold(f64::INFINITY, f64::min);
        let paths = paths::paths::<F, B, N>(plan, pattern, &mut layouts, negligible);
        let Columns { nodes, layouts, below, targets } = Columns::new::<F>(plan, pattern, layouts);
        Self {
            form: PhantomData,
            others: others(&paths, n_bodies(mass.len())),
            paths,
            nodes,
            layouts,
            lower: vec![[[0.0; B]; B]; below.len()],
            below,
            targets,
            roots: mass.as_chunks().0.iter().map(|mass: &OfBody| mass.map(|m| 1.0 / m.sqrt())).collect(),
            smallest_pivot: 1.0,
            refines: false,
        }
    }

    /// Factors A; `damping` is added to its diagonal. The pivot of each row has to be more than the part `least` of what it started from.
    ///
    /// Where a right side is given, forward substitution ([`Self::forward`]) is done in the same sweep: both are chains of dependent operations, and the
    /// processor overlaps them.
    fn eliminate(
        &mut self,
        jacobian: &[f64],
        damping: Option<&[f64]>,
        least: f64,
        right_side: Option<(&[f64], &[f64])>,
    ) -> Result<(), VanishedPivot> {
        let Self { paths, nodes, layouts, roots, below, lower, targets, smallest_pivot, .. } = self;
        let right_side = right_side.map(|(r, s)| (Bodies { of: r.as_chunks().0, roots }, s));
        lower.iter_mut().zip(&*below).filter(|(_, of)| of.is_filled).for_each(|(block, _)| *block = [[0.0; B]; B]);
        let mut list = List { lower, below, targets };
        begin::<F, B, N>(nodes, layouts, jacobian, roots);
        let given = Given { layouts, jacobian, roots, damping, least };
        let mut smallest = 1.0;
        for paths in paths {
            smallest = paths.eliminate::<F>(nodes, &given, right_side)?.min(smallest);
        }
        let mut rest = &mut nodes[..];
        while let Some((joint, later)) = rest.split_first_mut() {
            let [first, second] = &joint.slots;
            let mut own = sum(&F::product(first, first), &F::product(second, second));
            if !F::WHOLE {
                (joint.rows.n as usize..B).for_each(|r| own[r][r] = 1.0);
            }
            if let Some(damping) = damping {
                let damping = joint.rows.of::<F, B, N>(damping);
                (0..B).for_each(|r| own[r][r] += damping[r]);
            }
            let start = from_fn(|r| own[r][r]);
            let inverse = Fraction::inverse(&sum(&own, &joint.pending), &start);
            if !(inverse.pivots.iter().all(|&pivot| pivot > least) && inverse.denominator.is_normal()) {
                return Err(joint.rows.vanished(&inverse.pivots, least));
            }
            for pivot in inverse.pivots {
                smallest = if pivot < smallest { pivot } else { smallest };
            }
            // the products do not wait for the division
            let reciprocal = 1.0 / inverse.denominator;
            joint.inverse = times(&inverse.numerator, reciprocal);
            if joint.next > 0 {
                let late = &mut later[joint.next as usize - 1];
                let [here, there] = joint.shared.map(usize::from);
                let block = F::product(&late.slots[there], &joint.slots[here]);
                let scaled = inverse.numerator.map(|of_row| apply(&block, &of_row));
                subtract_product(&mut late.pending, &scaled, &block, reciprocal);
                joint.lower = times(&scaled, reciprocal);
                if let Some((x, s)) = right_side {
                    let sum = forward::<F, B, N>(joint, x, s);
                    subtract(&mut late.y, &apply(&joint.lower, &sum));
                }
            } else {
                list.eliminate::<F, N>(joint, later, &inverse.numerator, reciprocal, right_side);
            }
            rest = later;
        }
        *smallest_pivot = smallest;
        Ok(())
    }

    /// `L y = Γ x − s` for a right side `[r; s]`.
    fn forward(&mut self, r: &[f64], s: &[f64]) {
        let x = Bodies { of: r.as_chunks().0, roots: &self.roots };
        self.nodes.iter_mut().for_each(|joint| joint.y = [0.0; B]);
        self.paths.iter_mut().for_each(|paths| paths.forward::<F>(&mut self.nodes, x, s));
        forward_nodes(&mut self.nodes, Pairs(&self.lower, &self.below), |joint| forward::<F, B, N>(joint, x, s));
    }

    /// `L y = y`.
    fn forward_again(&mut self) {
        self.paths.iter_mut().for_each(|paths| paths.forward_again(&mut self.nodes));
        forward_nodes(&mut self.nodes, Pairs(&self.lower, &self.below), |joint| joint.y);
    }

    /// `D Lᵀ y = y`, then `x −= Γᵀ y`; y is written into s, or added to it by the second pass of a refined solution. Of bodies within paths x is scaled by the
    /// roots before where it `BEGINS`, and behind where it `ENDS`. Where it does not, what is left of the rows comes to stand in y.
    #[inline]
    fn backward<const BEGINS: bool, const ENDS: bool>(&mut self, x: &mut [OfBody], s: &mut [f64]) {
        let Self { paths, nodes, lower, below, roots, .. } = self;
        let mut column = Pairs(lower, below);
        for k in (0..nodes.len()).rev() {
            let Some((joint, later)) = nodes[k..].split_first_mut() else { continue };
            let mut solved = apply(&joint.inverse, &joint.y);
            let mut pull = |block: &Block<B>, late: &Node<B, N>| {
                subtract(&mut solved, &block.map(|of_row| dot(&of_row, &late.y)));
            };
            match joint.next {
                0 => column.take_last(joint.n_lower).for_each(|(block, of)| pull(block, &later[of.row as usize - 1])),
                next => pull(&joint.lower, &later[next as usize - 1]),
            }
            joint.y = solved;
            for (slot, &body) in joint.slots.iter().zip(&joint.bodies) {
                F::subtract_transposed(&mut x[body as usize], slot, &solved);
            }
            if ENDS {
                joint.rows.put::<F, B, N, BEGINS>(&solved, s);
            }
        }
        paths.iter_mut().for_each(|paths| paths.backward::<F, BEGINS, ENDS>(nodes, x, roots, s));
        if !ENDS {
            paths.iter_mut().for_each(|paths| paths.leave::<F>(x, s));
            for joint in nodes {
                let mut left = joint.rows.of::<F, B, N>(s).map(|s| -s);
                for (slot, &body) in joint.slots.iter().zip(&joint.bodies) {
                    F::add(&mut left, slot, &x[body as usize]);
                }
                joint.rows.put::<F, B, N, true>(&joint.y, s);
                joint.y = left;
            }
        }
    }

    /// Takes from x what leaves s of its rows, by `M^−½ Γᵀ y` with `A y = G x − s`: with x = M⁻¹ r it gives the solution; once more, with y = 0, it
    /// gives back the digits that small pivots cost. [`Self::forward`] was called before.
    fn finish(&mut self, r: &mut [f64], s: &mut [f64]) {
        let x = r.as_chunks_mut().0;
        self.scale(x);
        if self.refines {
            self.backward::<true, false>(x, s);
            self.forward_again();
            self.backward::<false, true>(x, s);
        } else {
            self.backward::<true, true>(x, s);
        }
        self.scale(x);
    }

    /// `x = M^−½ x` of the bodies that do not lie within a path.
    fn scale(&self, x: &mut [OfBody]) {
        for others in &self.others {
            let roots = self.roots[others.clone()].as_flattened();
            x[others.clone()].as_flattened_mut().iter_mut().zip(roots).for_each(|(x, root)| *x *= root);
        }
    }
}

/// Those of `n` bodies that do not lie within a path.
fn others<const B: usize, const N: usize>(paths: &[Paths<B, N>], n: usize) -> Vec<Range<usize>> {
    let mut within = vec![false; n];
    paths.iter().flat_map(Paths::within).for_each(|body| within[body] = true);
    let starts = (0..n).filter(|&body| !within[body] && (body == 0 || within[body - 1]));
    starts.map(|start| start..(start..n).find(|&body| within[body]).unwrap_or(n)).collect()
}

/// Writes Γ.
fn begin<F: Form<B, N>, const B: usize, const N: usize>(
    joints: &mut [Node<B, N>],
    layouts: &[Layout<N>],
    jacobian: &[f64],
    roots: &[OfBody],
) {
    for joint in joints {
        let entries = &jacobian[joint.first_entry as usize..];
        let roots = joint.bodies.map(|body| &roots[body as usize]);
        match joint.layout {
            // without a question at each entry
            0 => F::scale(&F::USUAL, &entries[..BODIES * N], roots, &mut joint.slots),
            other => F::scale(&layouts[other as usize], entries, roots, &mut joint.slots),
        }
        (joint.pending, joint.y) = ([[0.0; B]; B], [0.0; B]);
    }
}

/// What a joint and those before it have in `L y = Γ x − s`.
#[inline]
fn forward<F: Form<B, N>, const B: usize, const N: usize>(
    joint: &mut Node<B, N>,
    x: Bodies<'_>,
    s: &[f64],
) -> Column<B> {
    let mut sum = joint.rows.of::<F, B, N>(s).map(|s| -s);
    for (slot, &body) in joint.slots.iter().zip(&joint.bodies) {
        F::add(&mut sum, slot, &x.at(body));
    }
    // what waits for earlier joints comes last
    sum.iter_mut().zip(joint.y).for_each(|(sum, y)| *sum += y);
    joint.y = sum;
    sum
}

/// Forward substitution along these joints, of which `y_of` says what each and those before it have.
#[inline]
fn forward_nodes<const B: usize, const N: usize>(
    nodes: &mut [Node<B, N>],
    mut column: Pairs<'_, Block<B>, Below>,
    y_of: impl Fn(&mut Node<B, N>) -> Column<B>,
) {
    let mut rest = nodes;
    while let Some((joint, later)) = rest.split_first_mut() {
        let y = y_of(joint);
        match joint.next {
            0 => column
                .take_first(joint.n_lower)
                .for_each(|(block, of)| subtract(&mut later[of.row as usize - 1].y, &apply(block, &y))),
            next => subtract(&mut later[next as usize - 1].y, &apply(&joint.lower, &y)),
        }
        rest = later;
    }
}

/// The columns that stand in the list, from the one on that is eliminated next.
struct List<'a, const B: usize> {
    lower: &'a mut [Block<B>],
    below: &'a [Below],
    targets: &'a [u32],
}

impl<const B: usize> List<'_, B> {
    /// Eliminates the column of a joint whose inverse is `numerator · reciprocal`; with a right side forward substitution, too.
    fn eliminate<F: Form<B, N>, const N: usize>(
        &mut self,
        joint: &mut Node<B, N>,
        later: &mut [Node<B, N>],
        numerator: &Block<B>,
        reciprocal: f64,
        right_side: Option<RightSide<'_>>,
    ) {
        let (column, of_column);
        (column, self.lower) = std::mem::take(&mut self.lower).split_at_mut(joint.n_lower as usize);
        (of_column, self.below) = self.below.split_at(joint.n_lower as usize);
        for (block, of) in column.iter_mut().zip(of_column) {
            let mut entries = if of.is_filled { *block } else { [[0.0; B]; B] };
            for (early, &late) in joint.slots.iter().zip(&of.late) {
                if let Some(late) = later[of.row as usize - 1].slots.get(late as usize) {
                    entries = sum(&entries, &F::product(late, early));
                }
            }
            *block = entries;
        }
        // the products of a row take the blocks above it as they were
        for (i, of) in of_column.iter().enumerate().rev() {
            let (above, block) = (&column[..i], column[i]);
            let scaled = numerator.map(|of_row| apply(&block, &of_row));
            let targets;
            (targets, self.targets) = self.targets.split_at(i);
            for (above, &target) in above.iter().zip(targets) {
                subtract_product(&mut self.lower[target as usize], &scaled, above, reciprocal);
            }
            subtract_product(&mut later[of.row as usize - 1].pending, &scaled, &block, reciprocal);
            column[i] = times(&scaled, reciprocal);
        }
        if let Some((x, s)) = right_side {
            let sum = forward::<F, B, N>(joint, x, s);
            let column = column.iter().zip(of_column);
            column.for_each(|(block, of)| subtract(&mut later[of.row as usize - 1].y, &apply(block, &sum)));
        }
    }
}

#[inline]
fn subtract<const B: usize, T: Number>(sum: &mut Column<B, T>, x: &Column<B, T>) {
    sum.iter_mut().zip(x).for_each(|(sum, x)| *sum = *sum - *x);
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
    fn factor(&mut self, jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.eliminate(jacobian, None, PIVOT_TOLERANCE, None)?;
        self.refines = self.smallest_pivot < REFINED;
        Ok(())
    }

    fn factor_damped(&mut self, jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.refines = false;
        self.eliminate(jacobian, Some(damping), 0.0, None)
    }

    fn factor_and_solve(&mut self, jacobian: &[f64], r: &mut [f64], s: &mut [f64]) -> Result<(), VanishedPivot> {
        self.eliminate(jacobian, None, PIVOT_TOLERANCE, Some((r, s)))?;
        self.refines = self.smallest_pivot < REFINED;
        self.finish(r, s);
        Ok(())
    }

    fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    fn solve(&mut self, r: &mut [f64], s: &mut [f64]) {
        self.forward(r, s);
        self.finish(r, s);
    }

    fn describe(&self) -> String {
        let n_alone = self.nodes.iter().filter(|node| node.next > 0).count();
        let n_in_paths = self.paths.iter().map(Paths::n_joints).sum::<usize>();
        let (n, n_lower) = (self.nodes.len() + n_in_paths, self.lower.len() + n_alone + n_in_paths);
        let n_products = n_lower + self.targets.len();
        format!("blocks of {B} x {B}, {n} on the diagonal, {n_lower} below it, {n_products} products of blocks")
    }
}

#[inline]
fn sum<const B: usize, T: Number>(a: &Block<B, T>, b: &Block<B, T>) -> Block<B, T> {
    from_fn(|c| from_fn(|r| a[c][r] + b[c][r]))
}

/// `a bᵀ factor`.
#[inline]
fn product_times<const B: usize, T: Number>(a: &Block<B, T>, b: &Block<B, T>, factor: T) -> Block<B, T> {
    from_fn(|c| apply(a, &b.map(|of_row| of_row[c])).map(|entry| entry * factor))
}

/// `block −= a bᵀ factor`.
#[inline]
fn subtract_product<const B: usize>(block: &mut Block<B>, a: &Block<B>, b: &Block<B>, factor: f64) {
    let product = product_times(a, b, factor);
    block.iter_mut().zip(&product).for_each(|(column, product)| subtract(column, product));
}

#[inline]
fn times<const B: usize, T: Number>(block: &Block<B, T>, factor: T) -> Block<B, T> {
    block.map(|column| column.map(|entry| entry * factor))
}

#[inline]
fn dot<const B: usize, T: Number>(a: &Column<B, T>, b: &Column<B, T>) -> T {
    (1..B).fold(a[0] * b[0], |sum, i| sum + a[i] * b[i])
}

#[inline]
fn apply<const B: usize, T: Number>(a: &Block<B, T>, x: &Column<B, T>) -> Column<B, T> {
    from_fn(|r| (1..B).fold(a[0][r] * x[0], |sum, i| sum + a[i][r] * x[i]))
}
