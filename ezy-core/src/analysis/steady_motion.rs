//! Rest and steady motions.

use super::frame::Frame;
use super::steady_equations::Unknowns;
use super::tolerances::search::STRAIGHT;
use crate::dynamics::State;
use crate::model::Name;
use crate::model::coordinate::N_OF_BODY;

/// A motion that is constant seen from a frame; at rest in that of the ground where nothing moves.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyMotion {
    /// Time, coordinates, velocities and first-order states.
    pub state: State,
    /// Accelerations, `n_v`: those of the turn of the frame.
    pub accelerations: Vec<f64>,
    /// Multipliers, `n_c`.
    pub multipliers: Vec<f64>,
    /// The frame in which it rests.
    pub frame: Frame,
    /// Coordinates, velocities and states in which the steady motions next to it differ: as many as directions are free.
    pub free: Vec<Name>,
    /// Newton steps that it took.
    pub n_steps: usize,
}

impl SteadyMotion {
    /// That of a point at which the equations are met.
    pub(super) fn of(point: Unknowns, free: Vec<Name>, n_steps: usize) -> Self {
        let Unknowns { state, frame, multipliers } = point;
        let mut accelerations = vec![0.0; state.v.len()];
        frame.turn(&state.v, &mut accelerations);
        Self { state, accelerations, multipliers, frame, free, n_steps }
    }

    /// How it goes on: of which kind the frame is.
    pub fn course(&self) -> Course {
        let (State { q, v, .. }, Frame { vx, vy, omega }) = (&self.state, self.frame);
        if v.iter().all(|v| *v == 0.0) {
            return Course::Rest;
        }
        let first = [0, 1].map(|part| q.get(part).copied().unwrap_or_default());
        let speed = f64::hypot(vx - omega * first[1], vy + omega * first[0]);
        // distances from the first body: what the place of the whole mechanism is does not matter
        let size = q.chunks_exact(N_OF_BODY).map(|q| f64::hypot(q[0] - first[0], q[1] - first[1])).fold(1.0, f64::max);
        match (omega * size).abs() <= STRAIGHT * speed || omega == 0.0 {
            true if speed == 0.0 => Course::InPlace,
            true => Course::Straight { speed },
            false => {
                let centre = [-vy / omega, vx / omega];
                Course::Circle { centre, turn_rate: omega, speed, radius: speed / omega.abs() }
            }
        }
    }
}

/// How a steady motion goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Course {
    /// Nothing moves.
    Rest,
    /// No body moves on, but parts turn evenly, such as wheels and disks.
    InPlace,
    /// Along a straight line.
    Straight {
        /// Speed, m/s.
        speed: f64,
    },
    /// Around a point.
    Circle {
        /// The point, m.
        centre: [f64; 2],
        /// Turn rate, rad/s, against the clock.
        turn_rate: f64,
        /// Speed of the first body, m/s.
        speed: f64,
        /// Of the centre of mass of the first body, m.
        radius: f64,
    },
}
