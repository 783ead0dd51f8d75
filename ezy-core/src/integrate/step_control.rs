//! The lengths of steps: fixed, or from the error of the last one.

use crate::archive::Archive;
use crate::dynamics::MotionError;
use crate::integrate::tolerances::step_control::{BETA, GROW, LEAST_ERROR, REST, SAFETY, SHRINK};
use crate::model::SceneInfo;
use crate::model::coordinate::is_angle;
use crate::scalar::Scalar;

/// Tolerated errors of a step: `absolute + relative · |y|` for each number of the state, or `angle` for each angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative tolerance.
    pub relative: f64,
    /// Absolute tolerance, in m, rad, m/s, rad/s alike.
    pub absolute: f64,
    /// Tolerance of angles, rad, in place of the other two where angles grow; angular velocities keep to the other two.
    pub angle: Option<f64>,
}

impl Tolerance {
    /// The smallest relative tolerance: below it an error estimate is rounding.
    pub const SMALLEST_RELATIVE: f64 = 1e-15;
    /// The relative tolerance when none is given, and then the absolute one: nine digits a step, which costs few steps at order 8.
    pub const DEFAULT: f64 = 1e-9;

    /// Accepts any motion.
    pub(crate) const ANY: Self = Self::new(f64::INFINITY, f64::INFINITY);

    /// Relative and absolute tolerance, the same for angles.
    pub const fn new(relative: f64, absolute: f64) -> Self {
        Self { relative, absolute, angle: None }
    }

    /// The relative tolerance becomes `relative`, and the others change in proportion.
    pub(crate) fn with_relative(self, relative: f64) -> Self {
        let factor = relative / self.relative;
        Self { relative, absolute: self.absolute * factor, angle: self.angle.map(|angle| angle * factor) }
    }

    /// Tolerated error of number `i` of a state whose first `n_q` numbers are the coordinates, where it has this size.
    pub(crate) fn of(&self, i: usize, n_q: usize, size: f64) -> f64 {
        match self.angle {
            Some(angle) if i < n_q && is_angle(i) => angle,
            _ => self.absolute + self.relative * size,
        }
    }

    /// The smallest tolerated error relative to the number, of coordinates `q`.
    pub(crate) fn smallest_relative(&self, q: &[f64]) -> f64 {
        let largest =
            q.iter().enumerate().filter(|(i, _)| is_angle(*i)).fold(1.0, |largest: f64, (_, x)| largest.max(x.abs()));
        self.angle.map_or(self.relative, |angle| self.relative.min(angle / largest))
    }

    /// That doubles near angles of coordinates `q` at `t` are no farther apart than the tolerance of angles.
    ///
    /// # Errors
    /// [`MotionError::AngleUnresolved`].
    pub(crate) fn check_angles<T: Scalar>(&self, info: &SceneInfo, t: f64, q: &[T]) -> Result<(), MotionError> {
        match self.unresolved(q).zip(self.angle) {
            None => Ok(()),
            Some(((i, spacing), tolerance)) => {
                let (name, angle) = (info.coordinates.item(i).name, q[i].magnitude());
                Err(MotionError::AngleUnresolved { t, name, angle, spacing, tolerance })
            }
        }
    }

    /// The first of the coordinates `q` that is an angle so large that doubles near it are farther apart than its tolerance, and how far.
    fn unresolved<T: Scalar>(&self, q: &[T]) -> Option<(usize, f64)> {
        let tolerated = self.angle?;
        let spacings =
            q.iter().enumerate().filter(|(i, _)| is_angle(*i)).map(|(i, x)| (i, f64::EPSILON * x.magnitude()));
        spacings.into_iter().find(|(_, spacing)| *spacing > tolerated)
    }
}

/// A proportional-integral controller for a method whose error goes with the power `order` of the step.
///
/// # Source
/// Gustafsson, ACM Trans. Math. Software 17 (1991); Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.2.
#[derive(Debug, Clone)]
pub(crate) struct StepControl {
    order: f64,
    last_error: f64,
    just_rejected: bool,
}

impl StepControl {
    /// For a method of which an error estimate goes with `h^order`.
    pub(crate) fn new(order: i32) -> Self {
        Self { order: f64::from(order), last_error: LEAST_ERROR, just_rejected: false }
    }

    /// Writes it, or reads another one over it.
    pub(crate) fn remember<T: Scalar>(&mut self, archive: &mut Archive<T>) {
        archive.number(&mut self.last_error);
        archive.flag(&mut self.just_rejected);
    }

    /// Factor for the step after one with this error, at most 1.
    pub(crate) fn accept(&mut self, error: f64) -> f64 {
        let proportional = error.powf(1.0 / self.order - 0.2 * BETA);
        let factor = (SAFETY * self.last_error.powf(BETA) / proportional).clamp(SHRINK, GROW);
        self.last_error = error.max(LEAST_ERROR);
        let factor = if self.just_rejected { factor.min(1.0) } else { factor };
        self.just_rejected = false;
        factor
    }

    /// Factor for the next try after a step with this error, above 1 or not a number.
    pub(crate) fn reject(&mut self, error: f64) -> f64 {
        self.just_rejected = true;
        if error.is_finite() { (SAFETY / error.powf(1.0 / self.order)).max(SHRINK) } else { SHRINK }
    }
}

/// `t_n = t_0 + n h`, computed from n each time: adding h up sixty thousand times would cost 5e-11 s. The last
/// step is shortened to land on the end, and the last time is the end to the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clock {
    start: f64,
    end: f64,
    step: f64,
    n_steps: u64,
}

impl Clock {
    /// From `start` to `end ≥ start`, s, with `step > 0`.
    pub(crate) fn new(start: f64, end: f64, step: f64) -> Self {
        let n_steps = ((end - start) / step - REST).ceil().max(0.0) as u64;
        Self { start, end, step, n_steps }
    }

    /// Number of steps.
    pub(crate) fn n_steps(&self) -> u64 {
        self.n_steps
    }

    /// `t_n`, s.
    pub(crate) fn time(&self, n: u64) -> f64 {
        if n >= self.n_steps { self.end } else { self.start + n as f64 * self.step }
    }

    /// Length of the step that starts at `t_n`, s.
    pub(crate) fn step(&self, n: u64) -> f64 {
        if n + 1 < self.n_steps { self.step } else { self.end - self.time(n) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a power.
    const ROUNDING: f64 = 1e-13;

    fn close(x: f64, y: f64) {
        assert!((x - y).abs() <= ROUNDING * y.abs(), "{x} {y}");
    }

    #[test]
    fn analytic_tolerances_change_in_proportion() {
        let tolerance = Tolerance { angle: Some(1e-3), ..Tolerance::new(1e-6, 1e-5) }.with_relative(1e-8);
        close(tolerance.relative, 1e-8);
        close(tolerance.absolute, 1e-7);
        close(tolerance.angle.unwrap(), 1e-5);
    }

    /// Steady errors ε ask for 0.9 ε^(0.04 + 0.2 · 0.04 − 1/8): with 0.9 ε^(−0.077) one becomes a step of its own length.
    #[test]
    fn analytic_steady_errors_ask_for_their_eighth_root_less_what_damps() {
        for error in [1.0, 0.1, 1e-2] {
            let mut control = StepControl::new(8);
            control.accept(error);
            close(control.accept(error), 0.9 * error.powf(0.04 + 0.008 - 0.125));
        }
    }

    /// An error that grows from 1e-3 to 1e-1 asks for 100^(−0.04) of what a steady one of 1e-1 asks for.
    #[test]
    fn analytic_growing_errors_shorten_the_step_ahead() {
        let mut control = StepControl::new(8);
        control.accept(1e-3);
        let growing = control.accept(1e-1);
        close(growing / control.accept(1e-1), 100_f64.powf(-0.04));
    }

    #[test]
    fn analytic_steps_change_by_six_and_a_third_at_most() {
        let mut control = StepControl::new(8);
        assert_eq!(control.accept(0.0), 6.0);
        // an error below 1e-4 is remembered as 1e-4
        close(control.accept(1.0), 0.9 * 1e-4_f64.powf(0.04));
        assert_eq!(control.reject(1e8), 1.0 / 3.0);
        assert_eq!(control.reject(f64::NAN), 1.0 / 3.0);
        close(control.reject(4.0), 0.9 * 4.0_f64.powf(-0.125));
        assert_eq!(control.accept(0.0), 1.0, "the step after a rejected one does not grow");
        assert_eq!(control.accept(0.0), 6.0);
    }

    /// 1 s in steps of 0.3 s: three of them and 0.1 s; in steps of 0.1 s ten, since what rounding adds is none.
    #[test]
    fn analytic_clock_lands_on_its_end() {
        let clock = Clock::new(2.0, 3.0, 0.3);
        assert_eq!(clock.n_steps(), 4);
        let times: Vec<f64> = (0..6).map(|n| clock.time(n)).collect();
        assert_eq!(times, [2.0, 2.3, 2.6, 2.0 + 3.0 * 0.3, 3.0, 3.0]);
        for (n, length) in [0.3, 0.3, 0.3, 0.1].into_iter().enumerate() {
            assert!((clock.step(n as u64) - length).abs() <= 1e-15, "{n}");
        }
        let tenths = Clock::new(0.0, 0.1 + 0.2, 0.1);
        assert_eq!((tenths.n_steps(), tenths.time(3)), (3, 0.1 + 0.2));
        assert_eq!(Clock::new(1.0, 1.0, 0.1).n_steps(), 0);
    }
}
