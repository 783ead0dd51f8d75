//! What the field of a body is.

use super::coordinate::N_OF_BODY;
use super::member::{ArrayIndex, place, size};

/// Position and velocity of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyState {
    /// Centre of mass, m.
    pub x: f64,
    /// Centre of mass, m.
    pub y: f64,
    /// Angle, rad.
    pub phi: f64,
    /// Rate of `x`, m/s.
    pub vx: f64,
    /// Rate of `y`, m/s.
    pub vy: f64,
    /// Rate of `phi`, rad/s.
    pub omega: f64,
}

impl BodyState {
    /// From the coordinates and velocities that stand at `i`.
    #[inline(always)]
    fn at(i: usize, q: &[f64], v: &[f64]) -> Self {
        Self { x: q[i], y: q[i + 1], phi: q[i + 2], vx: v[i], vy: v[i + 1], omega: v[i + 2] }
    }
}

/// The bodies of an array with `D` indices.
#[derive(Debug, Clone, Copy)]
pub struct BodyArray<'a, const D: usize> {
    lengths: [usize; D],
    q: &'a [f64],
    v: &'a [f64],
}

impl<const D: usize> BodyArray<'_, D> {
    /// A body: `now.link.at(3)`, `now.knot.at([i, j])`.
    ///
    /// # Panics
    /// When there is no such body, as for a slice.
    #[track_caller]
    pub fn at(&self, index: impl ArrayIndex<D>) -> BodyState {
        let index = index.indices();
        match self.get(index) {
            Some(body) => body,
            None => panic!("no body has the index {index:?}: the array has {:?} bodies", self.lengths),
        }
    }

    /// A body, if there is one with this index.
    pub fn get(&self, index: impl ArrayIndex<D>) -> Option<BodyState> {
        let place = place(index.indices(), self.lengths.map(|length| (0, length)))?;
        Some(BodyState::at(N_OF_BODY * place, self.q, self.v))
    }

    /// Number of bodies for each index.
    pub fn lengths(&self) -> [usize; D] {
        self.lengths
    }

    /// All bodies; the last index changes first.
    pub fn iter(&self) -> impl Iterator<Item = BodyState> {
        (0..self.q.len()).step_by(N_OF_BODY).map(|i| BodyState::at(i, self.q, self.v))
    }
}

/// Hands out the bodies of a state in declared order.
pub struct BodyReader<'a> {
    q: &'a [f64],
    v: &'a [f64],
    /// Where the next body stands.
    next: usize,
}

impl<'a> BodyReader<'a> {
    /// Of `n_q` coordinates and velocities.
    #[inline(always)]
    pub fn new(q: &'a [f64], v: &'a [f64]) -> Self {
        Self { q, v, next: 0 }
    }

    /// The next body.
    #[inline(always)]
    pub fn body(&mut self) -> BodyState {
        let i = self.next;
        self.next += N_OF_BODY;
        BodyState::at(i, self.q, self.v)
    }

    /// The next array.
    pub fn array<const D: usize>(&mut self, lengths: [i64; D]) -> BodyArray<'a, D> {
        let lengths = lengths.map(size);
        let i = self.next;
        self.next += N_OF_BODY * lengths.iter().product::<usize>();
        BodyArray { lengths, q: &self.q[i..self.next], v: &self.v[i..self.next] }
    }
}
