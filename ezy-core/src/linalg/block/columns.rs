//! The columns of the factors: which blocks stand below the diagonal, and which of them the elimination of each changes.

use super::form::{Form, Layout, turned};
use super::{Block, Column};
use crate::linalg::VanishedPivot;
use crate::linalg::joints::{BODIES, Joint, Plan};
use crate::model::SparsityPattern;
use crate::model::coordinate::body_and_component;
use crate::pages::in_large_pages;
use std::array::from_fn;

/// A joint, and what is its own in the factors: together, so that a sweep reads one list.
#[derive(Debug, Clone)]
pub(super) struct Node<const B: usize, const N: usize> {
    /// Its part of Γ, for each body.
    pub slots: [[f64; N]; BODIES],
    /// What eliminated columns leave on the diagonal.
    pub pending: Block<B>,
    /// Of its block of D.
    pub inverse: Block<B>,
    /// The only block below the diagonal in its column, of L; not of columns that stand in the list.
    pub lower: Block<B>,
    /// y of the right side and of the solution.
    pub y: Column<B>,
    /// Those that it holds; one that is held alone stands twice, the second time with zeros for Γ.
    pub bodies: [u32; BODIES],
    /// Among the entries of G.
    pub first_entry: u32,
    /// How its entries stand in G, among the layouts.
    pub layout: u32,
    pub rows: Rows,
    /// How many joints later the row of the only block stands; zero where its blocks stand in the list.
    pub next: u32,
    /// The place of the body that both hold, here and there.
    pub shared: [u8; BODIES],
    /// Blocks below the diagonal in the list.
    pub n_lower: u32,
}

/// The rows of a joint among those of G.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rows {
    pub first: u32,
    pub n: u32,
}

impl Rows {
    pub(super) fn new(joint: &Joint) -> Self {
        Self { first: joint.first_row as u32, n: joint.n_rows as u32 }
    }

    /// Those of a vector that has one number for each row of G.
    #[inline(always)]
    pub(super) fn of<F: Form<B, N>, const B: usize, const N: usize>(self, of: &[f64]) -> Column<B> {
        let first = self.first as usize;
        if F::WHOLE {
            return of.as_chunks::<B>().0[first / B];
        }
        let mut rows = [0.0; B];
        rows.iter_mut().zip(&of[first..][..self.n as usize]).for_each(|(row, of)| *row = *of);
        rows
    }

    /// Writes y into those of such a vector, or adds it to them.
    #[inline(always)]
    pub(super) fn put<F: Form<B, N>, const B: usize, const N: usize, const REPLACES: bool>(
        self,
        y: &Column<B>,
        out: &mut [f64],
    ) {
        let first = self.first as usize;
        let put = |(out, y): (&mut f64, &f64)| *out = if REPLACES { *y } else { *out + y };
        if F::WHOLE {
            out.as_chunks_mut::<B>().0[first / B].iter_mut().zip(y).for_each(put);
        } else {
            out[first..][..self.n as usize].iter_mut().zip(y).for_each(put);
        }
    }

    /// The first row whose pivot is not more than `least`; where each is, the last one, whose pivot left the range of numbers.
    #[cold]
    pub(super) fn vanished<const B: usize>(self, pivots: &Column<B>, least: f64) -> VanishedPivot {
        let last = self.n as usize - 1;
        let row = pivots.iter().position(|pivot| pivot.is_nan() || *pivot <= least).unwrap_or(last);
        VanishedPivot { relative: pivots[row], row: Some(self.first as usize + row) }
    }
}

/// A block below the diagonal, in the list.
#[derive(Debug, Clone, Copy)]
pub(super) struct Below {
    /// How many joints later its row stands.
    pub row: u32,
    /// For each body of the earlier joint, its place among those of the later one; [`NOT_SHARED`] where that does not hold it.
    pub late: [u8; BODIES],
    /// Whether another column adds to it before.
    pub is_filled: bool,
}

const NOT_SHARED: u8 = BODIES as u8;

/// All of them.
pub(super) struct Columns<const B: usize, const N: usize> {
    pub nodes: Vec<Node<B, N>>,
    /// The usual one first, then that one turned.
    pub layouts: Vec<Layout<N>>,
    /// Of the columns in the list, one after the other.
    pub below: Vec<Below>,
    /// The blocks in the list that the elimination of each column changes, from the last row to the first, counted from the column behind it.
    pub targets: Vec<u32>,
}

impl<const B: usize, const N: usize> Columns<B, N> {
    /// Of the joints that are in no path.
    pub(super) fn new<F: Form<B, N>>(plan: &Plan, pattern: &SparsityPattern, layouts: Vec<Layout<N>>) -> Self {
        let n_in_paths = plan.n_in_paths();
        let joints = &plan.joints[n_in_paths..];
        let behind = |list: &Vec<usize>| list.iter().map(|k| k - n_in_paths).collect();
        let later: Vec<Vec<usize>> = plan.later[n_in_paths..].iter().map(behind).collect();
        let place = |column: usize, row: usize| later[column].binary_search(&row).ok();
        // columns add to the blocks of later ones, whose rows stand in them, too
        let mut is_filled: Vec<Vec<bool>> = later.iter().map(|list| vec![false; list.len()]).collect();
        for list in &later {
            for (i, &column) in list.iter().enumerate() {
                for place in list[i + 1..].iter().filter_map(|&row| place(column, row)) {
                    is_filled[column][place] = true;
                }
            }
        }
        let mut columns = Self {
            nodes: in_large_pages(Vec::with_capacity(joints.len())),
            layouts,
            below: Vec::new(),
            targets: Vec::new(),
        };
        let mut starts = Vec::with_capacity(joints.len());
        for (k, joint) in joints.iter().enumerate() {
            let side = |i: usize, row: usize| joint.bodies.get(i).and_then(|&body| joints[row].side_of(body));
            let late = |row| from_fn(|i| side(i, row).map_or(NOT_SHARED, |side| side as u8));
            let (next, shared) = match (&later[k][..], &is_filled[k][..]) {
                (&[row], [false]) => match late(row) {
                    [side, NOT_SHARED] if side != NOT_SHARED => (row - k, [0, side]),
                    [NOT_SHARED, side] if side != NOT_SHARED => (row - k, [1, side]),
                    _ => (0, [0; BODIES]),
                },
                _ => (0, [0; BODIES]),
            };
            let start = columns.below.len();
            if next == 0 {
                let blocks = later[k].iter().zip(&is_filled[k]);
                let blocks =
                    blocks.map(|(&row, &is_filled)| Below { row: (row - k) as u32, late: late(row), is_filled });
                columns.below.extend(blocks);
            }
            starts.push(start);
            let layout = layout::<F, B, N>(joint, false, pattern, &mut columns.layouts);
            columns.nodes.push(Node {
                slots: [[0.0; N]; BODIES],
                pending: [[0.0; B]; B],
                inverse: [[0.0; B]; B],
                lower: [[0.0; B]; B],
                y: [0.0; B],
                bodies: bodies(joint),
                first_entry: pattern.row(joint.first_row).start as u32,
                layout,
                rows: Rows::new(joint),
                next: next as u32,
                shared,
                n_lower: (columns.below.len() - start) as u32,
            });
        }
        for (k, list) in later.iter().enumerate() {
            for (i, &row) in list.iter().enumerate().rev() {
                let blocks = list[..i].iter().filter_map(|&column| Some(starts[column] + place(column, row)?));
                columns.targets.extend(blocks.map(|block| (block - starts[k + 1]) as u32));
            }
        }
        columns
    }
}

/// Those that a joint holds; one that is held alone stands twice.
pub(super) fn bodies(joint: &Joint) -> [u32; BODIES] {
    from_fn(|i| joint.bodies.get(i).or(joint.bodies.first()).copied().unwrap_or_default())
}

/// Where the entries of a joint stand, among the layouts; `is_turned`: with the second body first.
pub(super) fn layout<F: Form<B, N>, const B: usize, const N: usize>(
    joint: &Joint,
    is_turned: bool,
    pattern: &SparsityPattern,
    layouts: &mut Vec<Layout<N>>,
) -> u32 {
    let mut own = [[u32::MAX; N]; BODIES];
    for (entry, row, column) in joint.entries(pattern) {
        let (body, component) = body_and_component(column);
        if let (Some(side), Some(at)) = (joint.side_of(body as u32), F::place(row, component)) {
            own[side][at] = (entry - pattern.row(joint.first_row).start) as u32;
        }
    }
    if is_turned {
        own = turned(own);
    }
    let known = layouts.iter().position(|known| *known == own);
    known.unwrap_or_else(|| {
        layouts.push(own);
        layouts.len() - 1
    }) as u32
}
