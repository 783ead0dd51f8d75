//! What the loop of a run asks of a method.

use super::discontinuities::Discontinuities;
use super::hermite::Node;
use super::tolerances::steps::EVENT_PARTS;
use crate::archive::Archive;
use crate::dynamics::{MotionError, Solved, State};
use crate::scalar::Scalar;

/// A method with its storage and its step control, for systems `D` in numbers `T`.
///
/// A run restarts it, and then for each step evaluates the start, steps, projects the end, evaluates it, asks for states between both ends,
/// and accepts the step.
pub(crate) trait Integrator<D, T: Scalar = f64>: Send {
    /// Forgets the steps taken so far.
    fn restart(&mut self);

    /// Forgets the steps taken so far, and begins with this step length, s. Where states are near zero, the first step that a
    /// method would choose is too short.
    fn restart_with(&mut self, _step_s: f64) {
        self.restart();
    }

    /// A step of length `h` from `from` to `t_next`, not yet projected. A method that chooses its steps may stop before, and
    /// every method stops at a discontinuity.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    fn step(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        discontinuities: &mut dyn Discontinuities<D, T>,
        to: &mut State<T>,
    ) -> Result<(), MotionError>;

    /// The state at `t` between the ends of the last step, not projected.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    fn between(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        to: Node<'_, T>,
        t: f64,
        out: &mut State<T>,
    ) -> Result<(), MotionError>;

    /// The next step starts at the state that was evaluated last, the end of the last step if there was one.
    fn accept(&mut self) {}

    /// Writes what the next step takes from those before, once one is accepted, or reads it. A method that expands finds the rest
    /// by [`Integrator::expand`] at the state.
    fn remember(&mut self, system: &mut D, archive: &mut Archive<T>);

    /// Rejected steps.
    fn n_rejected(&self) -> u64 {
        0
    }

    /// Time since which stability limits the steps, s.
    fn stiff_since(&self) -> Option<f64> {
        None
    }

    /// Whether the last step led to a state that obeys the rows to rounding.
    fn keeps_rows(&self) -> bool {
        false
    }

    /// Whether the method finds accelerations itself, by [`Integrator::expand`].
    fn expands(&self) -> bool {
        false
    }

    /// Whether the method judges a step by the accelerations at its end, by [`Integrator::refuses`].
    fn judges_by_end(&self) -> bool {
        false
    }

    /// Accelerations `a` (`n_q`) and multipliers `lambda` (`n_c`) at a state, with what the next step from there needs; none by a method
    /// that needs nothing else.
    fn expand(
        &mut self,
        _system: &mut D,
        _at: &State<T>,
        _a: &mut [T],
        _lambda: &mut [T],
    ) -> Option<Result<Solved, MotionError>> {
        None
    }

    /// Whether the step from `from` to `to`, both evaluated, is to be taken again shorter.
    fn refuses(&mut self, _from: Node<'_, T>, _to: Node<'_, T>) -> bool {
        false
    }

    /// Parts of a step at whose ends event functions are sampled.
    fn n_event_parts(&self) -> usize {
        EVENT_PARTS
    }

    /// The smallest pivot within the last step, of a method whose steps are long enough to pass a singular position between their ends.
    fn smallest_pivot_within(&self) -> f64 {
        f64::INFINITY
    }

    /// The length of the next try, s, where the projection changed the velocities of the last step, to `v`, by more than the tolerance
    /// explains. An explicit method takes steps so short that it does not.
    fn shorter_for_constraints(&mut self, _v: &[T]) -> Option<f64> {
        None
    }

    /// Whether nothing tells how good values between the ends of the last step are, so that states there are to be ends of steps of their own.
    fn is_unsure_between(&self) -> bool {
        false
    }

    /// Whether the projection of the state that was found last changed its velocities, to `v`, by more than the tolerance explains, so that it is to be the
    /// end of a step of its own.
    fn is_off_constraints(&self, _v: &[T]) -> bool {
        false
    }

    /// The state at `t` between the ends of the last step, from a step of its own, not projected; `out` is left alone, and the answer is
    /// false, where the iteration of that step does not converge, and by a method that needs no such step.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    fn step_to(
        &mut self,
        _system: &mut D,
        _from: Node<'_, T>,
        _t: f64,
        _out: &mut State<T>,
    ) -> Result<bool, MotionError> {
        Ok(false)
    }

    /// A step of exactly this length, whatever its error, for tests of the stages; iterations go on to rounding. False where one does not
    /// converge.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    fn given_step(&mut self, system: &mut D, from: Node<'_, T>, h: f64, to: &mut State<T>)
    -> Result<bool, MotionError>;

    /// The next given step starts at the end of the last one, which was this long, s.
    fn accept_given(&mut self, _h: f64) {}

    /// The longest step that the method would choose from the state that was accepted last, s, before it tries any.
    fn longest_step(&mut self) -> Option<f64> {
        None
    }
}
