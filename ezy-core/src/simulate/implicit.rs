//! Radau IIA with its step control.

use super::discontinuities::{Cut, Discontinuities};
use super::step_limit::{StepLimit, is_too_short, limited_step};
use super::tolerances::steps::LARGEST_CORRECTION;
use crate::dynamics::{MotionError, RESIDUAL_THAT_IS_ZERO, State, System};
use crate::integrate::{Attempt, Node, Radau, RadauControl, Tolerance, tolerance_of_estimate};
use crate::model::Scene;

/// Radau IIA with the length of its next step.
pub(super) struct Implicit {
    method: Radau,
    control: RadauControl,
    /// As asked for.
    tolerance: Tolerance,
    of_estimate: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    /// Velocities of the state that was found last, before its projection.
    found: Vec<f64>,
    /// For steps to samples; made when it is first needed.
    to_sample: Option<Box<Radau>>,
    rejected: u64,
}

impl Implicit {
    pub(super) fn new(method: Radau, n_q: usize, tolerance: Tolerance) -> Self {
        Self {
            method,
            control: RadauControl::default(),
            tolerance,
            of_estimate: tolerance_of_estimate(tolerance),
            step_s: None,
            found: vec![0.0; n_q],
            to_sample: None,
            rejected: 0,
        }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.method.restart();
        self.control = RadauControl::default();
        self.step_s = None;
    }

    /// Forgets the steps taken so far, and begins with this step length, s.
    pub(super) fn restart_with(&mut self, step_s: f64) {
        self.restart();
        self.step_s = Some(step_s);
    }

    /// Rejected steps.
    pub(super) fn n_rejected(&self) -> u64 {
        self.rejected
    }

    /// The state at `t` between the ends of the last step, not projected; its time is left alone.
    pub(super) fn between(&mut self, from: &State, to: &State, t: f64, out: &mut State) {
        self.method.dense_at(from, to, (t - from.t) / (to.t - from.t), out);
        self.found.copy_from_slice(&out.v);
    }

    /// Whether the projection of the state that was found last changed a velocity to `v` by more than errors within the tolerance should.
    /// Where constraints make fast velocities of small errors of positions, such as of a wheel that trails its hinge by 1 mm, a long step
    /// has errors that its estimate does not see.
    pub(super) fn is_off_constraints(&self, v: &[f64]) -> bool {
        let Tolerance { relative, absolute } = self.tolerance;
        // what a residual of positions that counts as zero makes of a velocity
        let rounding = RESIDUAL_THAT_IS_ZERO * v.iter().fold(1.0, |fastest: f64, v| fastest.max(v.abs()));
        let largest = |v: f64| LARGEST_CORRECTION * (absolute + relative * v.abs()).max(rounding);
        self.found.iter().zip(v).any(|(found, v)| (v - found).abs() > largest(*v))
    }

    /// The state at `t` in the last step, from a step of its own, not projected; `out` is left alone where that does not converge.
    pub(super) fn step_to<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        if self.to_sample.is_none() {
            self.to_sample = self.method.another(system.scene()).map(Box::new);
        }
        if let Some(method) = &mut self.to_sample {
            method.restart();
            method.attempt(system, from, t - from.state.t, self.of_estimate, out)?;
        }
        Ok(())
    }

    /// A step from `from` towards `end` whose error is within the tolerance; not yet projected. It ends at a discontinuity.
    pub(super) fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Node<'_>,
        end: f64,
        discontinuities: &mut Discontinuities,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let t = from.state.t;
        let left = end - t;
        let mut length = self.step_s.unwrap_or_else(|| self.method.first_step(from, left, self.of_estimate));
        // the step length before a discontinuity, to continue with behind it
        let (mut whole, mut cut) = (None, None);
        loop {
            let StepLimit { step_s: h, t_next } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            let attempt = self.method.attempt(system, from, h, self.of_estimate, to)?;
            if matches!(attempt, Attempt::Solved { .. }) {
                to.t = t_next;
                let next_cut = match cut {
                    None => discontinuities.cut(system, from, &[to], h),
                    Some(Cut::Before(_)) if discontinuities.are_crossed(system, from.state, &[to]) => {
                        Some(Cut::nearer(t, h))
                    }
                    Some(_) => None,
                };
                if let Some(Cut::Before(shorter) | Cut::Over(shorter)) = next_cut {
                    whole.get_or_insert(h);
                    (cut, length) = (next_cut, shorter);
                    self.rejected += 1;
                    continue;
                }
            }
            match attempt {
                Attempt::Solved { error, n_passes } if error <= 1.0 => {
                    self.step_s = Some(match whole {
                        Some(whole) => whole,
                        None => {
                            discontinuities.restart();
                            self.control.accept(h, error, n_passes, self.method.keeps_factors())
                        }
                    });
                    self.method.accept(h);
                    self.found.copy_from_slice(&to.v);
                    if cut.is_some() {
                        self.method.turn();
                    }
                    return Ok(());
                }
                Attempt::Solved { error, n_passes } => length = self.control.reject(h, error, n_passes),
                Attempt::Diverged { factor } => length = self.control.diverge(h, factor),
            }
            self.rejected += 1;
        }
    }
}
