//! A mode as a motion that can be seen: without growth or decay, about the steady motion.

use super::mode::Mode;
use super::steady_motion::SteadyMotion;
use super::tolerances::mode::{SEEN_ANGLE_RAD, SEEN_SHARE, STILL};
use super::tolerances::spectrum::ROUNDING;
use crate::dynamics::State;
use crate::model::coordinate::is_angle;
use std::f64::consts::TAU;

/// The motion x₀ + a Re(`deviation` exp(i Im(s) t)) of one mode, seen from the frame of the steady motion x₀: of coordinates, velocities and
/// first-order states. Growth and decay are left out. Of a real eigenvalue it is x₀ + a `deviation` (1 − cos(|s| t))/2, out and back.
#[derive(Debug, Clone, Copy)]
pub struct Swing<'a> {
    motion: &'a SteadyMotion,
    mode: &'a Mode,
}

impl<'a> Swing<'a> {
    /// Of a mode about a steady motion.
    pub fn new(motion: &'a SteadyMotion, mode: &'a Mode) -> Self {
        Self { motion, mode }
    }

    /// Whether the mode oscillates: its eigenvalue is not real.
    pub fn oscillates(&self) -> bool {
        let s = self.mode.eigenvalue;
        s.im.abs() > ROUNDING * s.norm()
    }

    /// 2π/|Im s|, s; for a real eigenvalue 2π/|s|, a time of its size.
    pub fn period_s(&self) -> f64 {
        let s = self.mode.eigenvalue;
        TAU / if self.oscillates() { s.im.abs() } else { s.norm() }
    }

    /// The amplitude a by which the largest angle is 0.2 rad, or the largest displacement a tenth of the size of the mechanism if that is less; m,
    /// rad or the unit of a state, as what moves most in the mode. None where no body moves.
    pub fn visible_amplitude(&self, size_m: f64) -> Option<f64> {
        let moved = self.mode.deviation.iter().take(self.motion.state.q.len()).enumerate();
        let largest = |of_angles: bool| {
            let of_kind = moved.clone().filter(|(place, _)| is_angle(*place) == of_angles);
            of_kind.fold(0.0, |largest: f64, (_, x)| largest.max(x.norm()))
        };
        let [length, angle] = [false, true].map(largest);
        let amplitude = (SEEN_ANGLE_RAD / angle).min(SEEN_SHARE * size_m / length);
        (length.max(angle) > STILL && amplitude > 0.0).then_some(amplitude)
    }

    /// The state at a time after it begins, s. Its own time stays that of the steady motion, by which drives have their place.
    pub fn at(&self, amplitude: f64, t: f64) -> State {
        let angle = TAU * t / self.period_s();
        let (sin, cos) = angle.sin_cos();
        let turns = self.mode.eigenvalue.im.signum();
        let oscillates = self.oscillates();
        let mut state = self.motion.state.clone();
        let State { q, v, z, .. } = &mut state;
        for (x, deviation) in q.iter_mut().chain(v).chain(z).zip(&self.mode.deviation) {
            *x += amplitude
                * if oscillates {
                    deviation.re * cos - deviation.im * turns * sin
                } else {
                    deviation.re * 0.5 * (1.0 - cos)
                };
        }
        state
    }
}
