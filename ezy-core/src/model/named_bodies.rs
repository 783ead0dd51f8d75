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
    /// From its own coordinates and velocities.
    #[inline]
    fn new(q: &[f64], v: &[f64]) -> Self {
        Self { x: q[0], y: q[1], phi: q[2], vx: v[0], vy: v[1], omega: v[2] }
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
        Some(BodyState::new(&self.q[N_OF_BODY * place..], &self.v[N_OF_BODY * place..]))
    }

    /// Number of bodies for each index.
    pub fn lengths(&self) -> [usize; D] {
        self.lengths
    }

    /// All bodies; the last index changes first.
    pub fn iter(&self) -> impl Iterator<Item = BodyState> {
        self.q.chunks_exact(N_OF_BODY).zip(self.v.chunks_exact(N_OF_BODY)).map(|(q, v)| BodyState::new(q, v))
    }
}

/// Hands out the bodies of a state in declared order.
pub struct BodyReader<'a> {
    q: &'a [f64],
    v: &'a [f64],
}

impl<'a> BodyReader<'a> {
    /// Of `n_q` coordinates and velocities.
    #[inline]
    pub fn new(q: &'a [f64], v: &'a [f64]) -> Self {
        Self { q, v }
    }

    /// The next body.
    #[inline]
    pub fn body(&mut self) -> BodyState {
        let [q, v] = self.take(1);
        BodyState::new(q, v)
    }

    /// The next array.
    pub fn array<const D: usize>(&mut self, lengths: [i64; D]) -> BodyArray<'a, D> {
        let lengths = lengths.map(size);
        let [q, v] = self.take(lengths.iter().product());
        BodyArray { lengths, q, v }
    }

    #[inline]
    fn take(&mut self, n_bodies: usize) -> [&'a [f64]; 2] {
        let (q, later_q) = self.q.split_at(N_OF_BODY * n_bodies);
        let (v, later_v) = self.v.split_at(N_OF_BODY * n_bodies);
        (self.q, self.v) = (later_q, later_v);
        [q, v]
    }
}
