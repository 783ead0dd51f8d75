//! Taylor's method with its step control.

use super::{Taylor, order_for};
use crate::archive::Archive;
use crate::dynamics::{MotionError, Solved, State, System, SystemError};
use crate::integrate::discontinuities::Discontinuities;
use crate::integrate::family::{Family, MethodInfo, Needs};
use crate::integrate::step_limit::{StepLimit, is_too_short, limited_step};
use crate::integrate::tolerances::second_run::{ROUNDING, TIGHTER};
use crate::integrate::tolerances::steps::{
    CORRECTION_OF_ROUNDING, DEFECT_OF_ROUNDING, LARGEST_DEFECT, SERIES_CORRECTION, SHORTEST_OF_SERIES,
};
use crate::integrate::{Integrator, Node, Tolerance};
use crate::model::SceneRef;

/// Steps along series, of lengths that their coefficients choose.
pub(crate) struct AlongSeries {
    taylor: Taylor,
    tolerance: Tolerance,
    /// Longest step after one that was taken again, s; infinite once coefficients choose shorter ones.
    at_most_s: f64,
    rejected: u64,
    corrections: Corrections,
}

/// What the projection makes of the errors of steps. A series keeps each number to its tolerance; where a lever is short, the projection makes
/// a fast turn of an error of a position, with one sign step after step. Steps become so short that it does not.
struct Corrections {
    /// Velocities at the end of the step, before their projection.
    found: Vec<f64>,
    /// Steps are this part of what coefficients choose.
    part: f64,
}

impl Corrections {
    fn new(n_q: usize) -> Self {
        Self { found: vec![0.0; n_q], part: 1.0 }
    }

    /// Takes note of the projected velocities at the end of a step of a method of this order.
    fn note(&mut self, projected: &[f64], tolerance: Tolerance, order: usize) {
        let n_q = projected.len();
        let of = |(i, (found, v)): (usize, (&f64, &f64))| (v - found).abs() / tolerance.of(n_q + i, n_q, v.abs());
        let correction = self.found.iter().zip(projected).enumerate().map(of).fold(0.0, f64::max);
        let allowed = SERIES_CORRECTION.max(CORRECTION_OF_ROUNDING / tolerance.relative);
        let factor = (allowed / correction).powf(1.0 / order as f64);
        self.part = (self.part * factor).clamp(SHORTEST_OF_SERIES, 1.0);
    }
}

impl Family for AlongSeries {
    const INFO: MethodInfo = MethodInfo {
        name: "taylor",
        summary: "Taylor's method with order and steps that keep to a tolerance",
        order: None,
        chooses_steps: true,
        is_implicit: false,
        needs: Needs::Series,
        takes_any_body: false,
        takes_states: true,
        tighter: TIGHTER,
        rounding: ROUNDING,
    };

    fn of_system<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        tolerance: Tolerance,
        _is_projected: bool,
    ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
        let series = Self::of_order(system, n_works, order_for(tolerance), tolerance);
        Ok(series.map(|series| Box::new(series) as Box<dyn Integrator<System<P>>>))
    }
}

impl AlongSeries {
    /// Steps of this order, at least 4; none for a scene without a Taylor series.
    pub(crate) fn of_order<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        order: usize,
        tolerance: Tolerance,
    ) -> Option<Self> {
        Some(Self::new(Taylor::new(system.scene(), order, n_works)?, tolerance))
    }

    fn new(taylor: Taylor, tolerance: Tolerance) -> Self {
        let corrections = Corrections::new(taylor.n_coordinates());
        Self { taylor, tolerance, at_most_s: f64::INFINITY, rejected: 0, corrections }
    }
}

impl<P: SceneRef> Integrator<System<P>> for AlongSeries {
    fn restart(&mut self) {
        self.taylor.restart();
        self.at_most_s = f64::INFINITY;
        self.corrections.part = 1.0;
    }

    fn n_rejected(&self) -> u64 {
        self.rejected
    }

    fn accept(&mut self) {
        self.taylor.accept();
    }

    fn expands(&self) -> bool {
        true
    }

    fn judges_by_end(&self) -> bool {
        true
    }

    fn expand(
        &mut self,
        system: &mut System<P>,
        at: &State,
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Option<Result<Solved, MotionError>> {
        Some(self.taylor.expand(system, at, a, lambda))
    }

    /// Of a length that coefficients choose.
    fn step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        _h: f64,
        end: f64,
        _discontinuities: &mut dyn Discontinuities<System<P>>,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let (t, mut length) = (from.state.t, self.corrections.part * self.taylor.longest_step(self.tolerance));
        if is_too_short(t, length) && length < end - t {
            return Err(MotionError::StepCollapsed { t, step_s: length });
        }
        if length > self.at_most_s {
            length = self.at_most_s;
        } else {
            self.at_most_s = f64::INFINITY;
        }
        let StepLimit { step_s, t_next, .. } = limited_step(t, end, length);
        self.taylor.advance(system, from.state, step_s, to);
        to.t = t_next;
        self.corrections.found.copy_from_slice(&to.v);
        Ok(())
    }

    fn between(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        _to: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        self.taylor.dense_at(system, from.state, t - from.state.t, out);
        out.t = t;
        Ok(())
    }

    /// A series does not see what is farther away than its terms tell, such as a steep law of friction: where the equations at the end
    /// disagree with it, the next try is half as long.
    fn refuses(&mut self, from: Node<'_>, to: Node<'_>) -> bool {
        let (t, h) = (from.state.t, to.state.t - from.state.t);
        let shortens =
            !is_too_short(t, 0.5 * h) && !self.taylor.follows(h, [to.a, to.rate], LARGEST_DEFECT, DEFECT_OF_ROUNDING);
        if shortens {
            self.at_most_s = 0.5 * h;
            self.rejected += 1;
        } else {
            self.at_most_s *= 2.0;
            self.corrections.note(&to.state.v, self.tolerance, self.taylor.order());
        }
        shortens
    }

    fn remember(&mut self, _system: &mut System<P>, archive: &mut Archive) {
        self.taylor.remember(archive);
        archive.number(&mut self.at_most_s);
        archive.number(&mut self.corrections.part);
        archive.count(&mut self.rejected);
    }

    fn given_step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        to: &mut State,
    ) -> Result<bool, MotionError> {
        self.taylor.accept();
        self.taylor.advance(system, from.state, h, to);
        Ok(true)
    }

    fn longest_step(&mut self) -> Option<f64> {
        Some(self.taylor.longest_step(self.tolerance))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    crate::model! {
        /// A stone that falls.
        pub model Stone {
            body stone { mass: 2, inertia: 1 }
            gravity (0, -10);
            start high { stone at (0, 5) angle 0; at rest; }
            scene falls { start high; until 1 s; }
        }
    }

    /// Corrections go with the power 10 of the length: 2^5 times what is allowed is made smaller by the root of a half.
    #[test]
    fn analytic_corrections_shorten_steps_of_a_series() {
        // velocities of 1 m/s are tolerated to 2e-9 m/s
        let tolerance = Tolerance::new(1e-9, 1e-9);
        let mut corrections = Corrections { found: vec![0.0, 1.0, 1.0], part: 1.0 };
        let mut part = |in_allowed: f64| {
            corrections.note(&[0.0, 1.0, 1.0 + 2e-9 * SERIES_CORRECTION * in_allowed], tolerance, 10);
            corrections.part
        };
        let close = |x: f64, y: f64| assert!((x - y).abs() <= 1e-6, "{x} {y}");
        assert_eq!([part(0.0), part(0.9)], [1.0; 2]);
        close(part(2.0_f64.powi(5)), 0.5_f64.sqrt());
        close(part(1.0), 0.5_f64.sqrt());
        close(part(2.0_f64.powi(-2)), 0.5_f64.powf(0.3));
        assert_eq!(part(2.0_f64.powi(9)), 0.5);
        // the tolerance of angles is not that of their rates
        let note = |angle: Option<f64>| {
            let mut corrections = Corrections { found: vec![0.0, 1.0, 1.0], part: 1.0 };
            corrections.note(&[0.0, 1.0, 1.0 + 1.8e-9 * SERIES_CORRECTION], Tolerance { angle, ..tolerance }, 10);
            corrections.part
        };
        assert_eq!([note(Some(1e-15)), note(None)], [1.0; 2]);
        // at 1e-13 ten tolerances are rounding
        corrections.note(&[0.0, 1.0, 1.0 + 2e-13], Tolerance::new(1e-13, 1e-13), 10);
        assert!((corrections.part / (0.5 * 10.0_f64.powf(0.1)) - 1.0).abs() <= 1e-3, "{}", corrections.part);
    }

    /// Accelerations at the end that are no numbers are not those of a series. A step is halved for them as long as half of it changes the time.
    #[test]
    fn analytic_steps_are_halved_as_long_as_halves_change_the_time() {
        let scene = stone::Falls::default();
        for (h, is_halved) in [(1e-3, true), (2.1e-14, true), (1.9e-14, false)] {
            let taylor = Taylor::new(&scene, 8, 0).unwrap();
            let mut series = AlongSeries::new(taylor, Tolerance::new(1e-9, 1e-9));
            let (from, mut to) = (State::zero(3, 0), State::zero(3, 0));
            to.t = h;
            let node = |state| Node { state, q_rate: &[f64::NAN; 3], a: &[f64::NAN; 3], rate: &[], power: &[] };
            let refused = Integrator::<System<&stone::Falls>>::refuses(&mut series, node(&from), node(&to));
            assert_eq!(refused, is_halved, "{h:e}");
            assert_eq!((series.at_most_s, series.rejected), if is_halved { (0.5 * h, 1) } else { (f64::INFINITY, 0) });
        }
    }
}
