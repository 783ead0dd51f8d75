//! A frame that travels and turns evenly.

use crate::model::coordinate::{N_OF_BODY, n_bodies};

/// The velocity field of a frame that coincides with the ground now: a point at (x, y) moves by (vx − omega y, vy + omega x).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Frame {
    /// Velocity of the origin along x, m/s.
    pub vx: f64,
    /// Velocity of the origin along y, m/s.
    pub vy: f64,
    /// Rate of turn, rad/s.
    pub omega: f64,
}

impl Frame {
    /// Velocity of planar bodies that rest in the frame; `q` and `out` hold x, y, φ of one body after the other.
    pub(super) fn carry(&self, q: &[f64], out: &mut [f64]) {
        for (q, out) in q.chunks_exact(N_OF_BODY).zip(out.chunks_exact_mut(N_OF_BODY)) {
            out.copy_from_slice(&[self.vx - self.omega * q[1], self.vy + self.omega * q[0], self.omega]);
        }
    }

    /// What the turn of the frame makes of vectors that rest in it: ω e_z × each; turns are as they are.
    pub(super) fn turn(&self, v: &[f64], out: &mut [f64]) {
        for (v, out) in v.chunks_exact(N_OF_BODY).zip(out.chunks_exact_mut(N_OF_BODY)) {
            out.copy_from_slice(&[-self.omega * v[1], self.omega * v[0], 0.0]);
        }
    }

    /// The frame in which most of what moves so rests, in least squares.
    pub(super) fn of(q: &[f64], v: &[f64]) -> Self {
        let n = n_bodies(q.len()).max(1) as f64;
        let mean = |x: &[f64], part: usize| x.iter().skip(part).step_by(N_OF_BODY).sum::<f64>() / n;
        let ([x, y], [vx, vy]) = ([mean(q, 0), mean(q, 1)], [mean(v, 0), mean(v, 1)]);
        let (mut moment, mut size) = (0.0, 0.0);
        for (q, v) in q.chunks_exact(N_OF_BODY).zip(v.chunks_exact(N_OF_BODY)) {
            moment += (q[0] - x) * (v[1] - vy) - (q[1] - y) * (v[0] - vx) + v[2];
            size += (q[0] - x).powi(2) + (q[1] - y).powi(2) + 1.0;
        }
        let omega = moment / size;
        Self { vx: vx + omega * y, vy: vy - omega * x, omega }
    }
}
