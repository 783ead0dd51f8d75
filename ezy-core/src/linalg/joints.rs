//! Rows that hold the same bodies, and in which order they are eliminated from `G M⁻¹ Gᵀ`.

use super::order::minimum_degree;
use super::tolerances::sizes::{HUB_ROWS, PRODUCTS_PER_JOINT};
use crate::model::SparsityPattern;
use crate::model::coordinate::{N_OF_BODY, body_and_component};
use std::ops::Deref;

/// Up to three rows, as many as a weld has, one behind the other, that hold the same bodies.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Joint {
    pub first_row: usize,
    pub n_rows: usize,
    pub bodies: HeldBodies,
}

/// Bodies that a joint holds, ascending.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeldBodies {
    n: usize,
    all: [u32; BODIES],
}

impl HeldBodies {
    /// None where there are too many.
    fn new(mut bodies: Vec<u32>) -> Option<Self> {
        bodies.sort_unstable();
        bodies.dedup();
        let mut held = Self { n: bodies.len(), all: [0; BODIES] };
        held.all.get_mut(..held.n)?.copy_from_slice(&bodies);
        Some(held)
    }
}

impl Deref for HeldBodies {
    type Target = [u32];

    fn deref(&self) -> &[u32] {
        &self.all[..self.n]
    }
}

impl Joint {
    /// Each entry of its part of G: its number in the pattern, its row among those of the joint, and its column.
    pub(super) fn entries(&self, pattern: &SparsityPattern) -> impl Iterator<Item = (usize, usize, usize)> {
        (0..self.n_rows).flat_map(move |r| {
            let row = self.first_row + r;
            pattern.row(row).zip(pattern.columns_of(row)).map(move |(entry, column)| (entry, r, column))
        })
    }

    /// The place of a body among those that it holds.
    pub(super) fn side_of(&self, body: u32) -> Option<usize> {
        self.bodies.iter().position(|&other| other == body)
    }
}

/// Largest number of bodies that a joint holds.
pub(super) const BODIES: usize = 2;

/// The joints in the order of elimination, and the blocks of the factors.
pub(super) struct Plan {
    pub joints: Vec<Joint>,
    /// Later joints of each one, ascending, whose blocks are not zero.
    pub later: Vec<Vec<usize>>,
    /// How many joints either path of each pair has. Paths come first: joints of one and of the other by turns.
    pub paths: Vec<usize>,
}

impl Plan {
    /// None where a body is held by so many rows that they would all be coupled, sparse factors of K cost less, a row holds more than two bodies,
    /// or an entry of G is the sum of two.
    pub(super) fn new(n_q: usize, pattern: &SparsityPattern, n_rows: usize) -> Option<Self> {
        let joints = joints(pattern, n_rows)?;
        let mut of_body = vec![Vec::new(); n_q.div_ceil(N_OF_BODY)];
        for (k, joint) in joints.iter().enumerate() {
            joint.bodies.iter().for_each(|&body| of_body[body as usize].push(k));
        }
        let n_rows_of = |list: &[usize]| list.iter().map(|&k| joints[k].n_rows).sum::<usize>();
        if of_body.iter().any(|list| n_rows_of(list) > HUB_ROWS) {
            return None;
        }
        let ordered = |order: Vec<usize>| later(&order, &joints, &of_body).map(|later| (order, later));
        let mut plan = ordered(inwards(&joints, &of_body));
        let n_blocks = |later: &[Vec<usize>]| later.iter().map(Vec::len).sum::<usize>();
        let n_pairs = pairs_that_share_a_body(&joints, &of_body);
        if plan.as_ref().is_none_or(|(_, later)| n_blocks(later) > n_pairs) {
            // with closed loops another order may leave less
            let by_degree = minimum_degree(joints.len(), of_body.iter().map(|list| &list[..])).ok()?;
            let other = ordered(by_degree);
            plan = plan.into_iter().chain(other).min_by_key(|(_, later)| n_products(later));
        }
        let (order, later) = plan?;
        let mut all: Vec<Option<Joint>> = joints.into_iter().map(Some).collect();
        let joints: Vec<Joint> = order.iter().filter_map(|&k| all[k].take()).collect();
        Some(Self::paths_first(joints, &later))
    }

    /// How many joints are in paths.
    pub(super) fn n_in_paths(&self) -> usize {
        2 * self.paths.iter().sum::<usize>()
    }

    /// Two paths of about the same length, and again two, until all are taken.
    fn paths_first(joints: Vec<Joint>, later: &[Vec<usize>]) -> Self {
        let mut paths = paths(&joints, later);
        paths.sort_by_key(|path| std::cmp::Reverse(path.len()));
        let by_turns =
            |[one, other]: &[Vec<usize>; 2]| one.iter().zip(other).map(|(a, b)| [*a, *b]).collect::<Vec<_>>();
        let paths: Vec<Vec<[usize; 2]>> = paths.as_chunks::<2>().0.iter().map(by_turns).collect();
        let mut order: Vec<usize> = paths.iter().flatten().flatten().copied().collect();
        let mut is_placed = vec![false; joints.len()];
        order.iter().for_each(|&k| is_placed[k] = true);
        order.extend((0..joints.len()).filter(|&k| !is_placed[k]));
        let position = positions(&order);
        let moved = |list: &Vec<usize>| {
            let mut list: Vec<usize> = list.iter().map(|&k| position[k]).collect();
            list.sort_unstable();
            list
        };
        let later = order.iter().map(|&k| moved(&later[k])).collect();
        let mut all: Vec<Option<Joint>> = joints.into_iter().map(Some).collect();
        let joints = order.iter().filter_map(|&k| all[k].take()).collect();
        Self { joints, later, paths: paths.iter().map(Vec::len).collect() }
    }
}

/// Rows one behind the other that hold the same bodies; none where one holds more than two, or an entry of G is the sum of two.
fn joints(pattern: &SparsityPattern, n_rows: usize) -> Option<Vec<Joint>> {
    let mut joints: Vec<Joint> = Vec::new();
    for row in 0..n_rows {
        let columns = pattern.columns_of(row);
        let mut unique: Vec<usize> = columns.clone().collect();
        unique.sort_unstable();
        unique.dedup();
        if unique.len() < columns.len() {
            return None;
        }
        let bodies = HeldBodies::new(columns.map(|column| body_and_component(column).0 as u32).collect())?;
        match joints.last_mut() {
            Some(last) if last.bodies == bodies && last.n_rows < 3 => last.n_rows += 1,
            _ => joints.push(Joint { first_row: row, n_rows: 1, bodies }),
        }
    }
    Some(joints)
}

/// From the ends of each tree of bodies to its middle, all branches at the same pace: without closed loops nothing is filled in, and
/// neighbours in the order seldom wait for each other.
fn inwards(joints: &[Joint], of_body: &[Vec<usize>]) -> Vec<usize> {
    let mut is_placed = vec![false; joints.len()];
    let mut outwards = Vec::with_capacity(joints.len());
    let mut came_from = vec![None; joints.len()];
    for first in 0..joints.len() {
        if is_placed[first] {
            continue;
        }
        let one_end = farthest(first, joints, of_body, &mut came_from)[0];
        let path = farthest(one_end, joints, of_body, &mut came_from);
        let middle = path[path.len() / 2];
        is_placed[middle] = true;
        let mut next = outwards.len();
        outwards.push(middle);
        while next < outwards.len() {
            for neighbour in neighbours(outwards[next], joints, of_body) {
                if !std::mem::replace(&mut is_placed[neighbour], true) {
                    outwards.push(neighbour);
                }
            }
            next += 1;
        }
    }
    outwards.reverse();
    outwards
}

/// From each joint that none comes before, joints that have the one before alone, and one behind with which they share one body. All
/// have the largest number of rows.
fn paths(joints: &[Joint], later: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let n_rows = joints.iter().map(|joint| joint.n_rows).max();
    let mut n_before = vec![0; joints.len()];
    later.iter().flatten().for_each(|&k| n_before[k] += 1);
    let next = |k: usize| match later[k][..] {
        [next] if joints[k].bodies.iter().filter(|&&body| joints[next].side_of(body).is_some()).count() == 1 => {
            Some(next)
        }
        _ => None,
    };
    let is_in = |k: usize, n: usize| n_before[k] == n && Some(joints[k].n_rows) == n_rows && next(k).is_some();
    let path = |first: usize| std::iter::successors(Some(first), |&k| next(k).filter(|&next| is_in(next, 1)));
    (0..joints.len()).filter(|&k| is_in(k, 0)).map(|first| path(first).collect()).collect()
}

/// Joints that share a body with one; some more than once.
fn neighbours<'a>(k: usize, joints: &'a [Joint], of_body: &'a [Vec<usize>]) -> impl Iterator<Item = usize> + 'a {
    joints[k]
        .bodies
        .iter()
        .flat_map(move |&body| of_body[body as usize].iter().copied())
        .filter(move |&other| other != k)
}

/// The way back from the joint that is farthest from another one. All of `came_from` is none, before and after.
fn farthest(from: usize, joints: &[Joint], of_body: &[Vec<usize>], came_from: &mut [Option<u32>]) -> Vec<usize> {
    let mut reached = vec![from];
    came_from[from] = Some(from as u32);
    let mut next = 0;
    while let Some(&k) = reached.get(next) {
        for neighbour in neighbours(k, joints, of_body) {
            if came_from[neighbour].is_none() {
                came_from[neighbour] = Some(k as u32);
                reached.push(neighbour);
            }
        }
        next += 1;
    }
    let back = |&k: &usize| came_from[k].map(|before| before as usize).filter(|&before| before != k);
    let path = std::iter::successors(reached.last().copied(), back).collect();
    reached.iter().for_each(|&k| came_from[k] = None);
    path
}

/// Position of each joint in an order.
fn positions(order: &[usize]) -> Vec<usize> {
    let mut position = vec![0; order.len()];
    order.iter().enumerate().for_each(|(p, &k)| position[k] = p);
    position
}

/// How many pairs of joints share a body.
fn pairs_that_share_a_body(joints: &[Joint], of_body: &[Vec<usize>]) -> usize {
    let later = |k: usize| {
        let mut list: Vec<usize> = neighbours(k, joints, of_body).filter(|&other| other > k).collect();
        list.sort_unstable();
        list.dedup();
        list.len()
    };
    (0..joints.len()).map(later).sum()
}

/// Later joints of each one, in an order, whose blocks of the factors are not zero; none where they are too many.
fn later(order: &[usize], joints: &[Joint], of_body: &[Vec<usize>]) -> Option<Vec<Vec<usize>>> {
    let position = positions(order);
    let mut later: Vec<Vec<usize>> = Vec::with_capacity(order.len());
    let mut children = vec![Vec::new(); order.len()];
    let mut n_products = 0_usize;
    for (p, &k) in order.iter().enumerate() {
        let mut list: Vec<usize> =
            neighbours(k, joints, of_body).map(|other| position[other]).filter(|&other| other > p).collect();
        for &child in &children[p] {
            list.extend(later[child as usize].iter().copied().filter(|&other| other > p));
        }
        list.sort_unstable();
        list.dedup();
        if let Some(&parent) = list.first() {
            children[parent].push(p as u32);
        }
        n_products += list.len() * (list.len() + 1) / 2;
        if n_products > PRODUCTS_PER_JOINT * joints.len() {
            return None;
        }
        later.push(list);
    }
    Some(later)
}

/// Products of blocks in an elimination.
fn n_products(later: &[Vec<usize>]) -> usize {
    later.iter().map(|list| list.len() * (list.len() + 1) / 2).sum()
}
