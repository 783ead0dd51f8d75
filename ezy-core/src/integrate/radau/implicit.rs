//! Radau IIA with its step control.

use super::{Attempt, Radau, RadauControl, tolerance_of_estimate};
use crate::archive::Archive;
use crate::dynamics::{MotionError, State, System, SystemError};
use crate::integrate::discontinuities::{Cut, Discontinuities};
use crate::integrate::family::{Family, MethodInfo, Needs};
use crate::integrate::step_limit::{StepLimit, is_too_short, limited_step};
use crate::integrate::tolerances::second_run::{ROUNDING_OF_RADAU, TIGHTER};
use crate::integrate::tolerances::steps::{GROW_AGAIN, LARGEST_CORRECTION, QUARTERED, RESOLVED};
use crate::integrate::{Integrator, Node, Tolerance};
use crate::model::SceneRef;

/// For given steps: the iteration goes on to rounding.
const CONVERGED: Tolerance = Tolerance::new(1e-10, 1e-10);

/// Radau IIA with the length of its next step.
pub(crate) struct Implicit {
    method: Radau,
    control: RadauControl,
    /// As asked for.
    tolerance: Tolerance,
    of_estimate: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    /// The last step, until it is accepted.
    made: Option<Made>,
    /// Velocities of the state that was found last, before its projection.
    found: Vec<f64>,
    /// Correction of the step that is taken again.
    refused: Option<f64>,
    /// A correction that a shorter step left as it was: rounding of positions.
    rounding: f64,
    /// Length of the next step at most, s, after one that was taken again.
    longest_s: f64,
    /// For steps to samples, with the states at both ends; made when it is first needed.
    to_sample: Option<Box<(Radau, State, State)>>,
    rejected: u64,
}

/// A step whose error is within the tolerance.
struct Made {
    length_s: f64,
    error: f64,
    n_passes: u32,
    /// The step length before a discontinuity, s, to continue with behind it; where the step ends at one.
    whole_s: Option<f64>,
    /// Whether the step goes over a discontinuity, or has tried to.
    is_cut: bool,
}

impl Family for Implicit {
    const INFO: MethodInfo = MethodInfo {
        name: "radau",
        summary: "Implicit method Radau IIA of order 5 with steps that keep to a tolerance, for stiff scenes",
        order: Some(5),
        chooses_steps: true,
        is_implicit: true,
        needs: Needs::Jacobians,
        takes_any_body: false,
        takes_states: true,
        tighter: TIGHTER,
        rounding: ROUNDING_OF_RADAU,
    };

    fn of_system<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        tolerance: Tolerance,
        _is_projected: bool,
    ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
        let Some(radau) = Radau::new(system.scene(), n_works)? else { return Ok(None) };
        Ok(Some(Box::new(Self::new(radau, system.info().n_coordinates(), tolerance))))
    }
}

impl Implicit {
    fn new(method: Radau, n_q: usize, tolerance: Tolerance) -> Self {
        Self {
            method,
            control: RadauControl::default(),
            tolerance,
            of_estimate: tolerance_of_estimate(tolerance),
            step_s: None,
            made: None,
            found: vec![0.0; n_q],
            refused: None,
            rounding: 0.0,
            longest_s: f64::INFINITY,
            to_sample: None,
            rejected: 0,
        }
    }

    /// The largest change of a velocity, to `v`, by the projection of the state that was found last, over what errors within the tolerance
    /// explain. Where constraints make fast velocities of small errors of positions, such as of a wheel that trails its hinge by 1 mm, a long
    /// step has errors that its estimate does not see.
    fn correction(&self, v: &[f64]) -> f64 {
        let Tolerance { relative, absolute, .. } = self.tolerance;
        let explained = |v: f64| LARGEST_CORRECTION * (absolute + relative * v.abs());
        self.found.iter().zip(v).fold(0.0, |largest: f64, (found, v)| largest.max((v - found).abs() / explained(*v)))
    }
}

impl<P: SceneRef> Integrator<System<P>> for Implicit {
    fn restart(&mut self) {
        self.method.restart();
        self.control = RadauControl::default();
        self.step_s = None;
        self.made = None;
        self.refused = None;
        self.rounding = 0.0;
        self.longest_s = f64::INFINITY;
    }

    fn restart_with(&mut self, step_s: f64) {
        Integrator::<System<P>>::restart(self);
        self.step_s = Some(step_s);
    }

    fn n_rejected(&self) -> u64 {
        self.rejected
    }

    fn between(
        &mut self,
        _system: &mut System<P>,
        from: Node<'_>,
        to: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        let (from, to) = (from.state, to.state);
        self.method.dense_at(from, to, (t - from.t) / (to.t - from.t), out);
        self.found.copy_from_slice(&out.v);
        out.t = t;
        Ok(())
    }

    fn is_unsure_between(&self) -> bool {
        self.method.is_stiff()
    }

    /// Neither the tolerance nor rounding explains it.
    fn is_off_constraints(&self, v: &[f64]) -> bool {
        self.correction(v) > self.rounding.max(1.0)
    }

    /// By one step, or by so many that their iteration converges, up to four.
    ///
    /// # Cost
    /// Jacobians, a factorisation and an iteration for each state.
    fn step_to(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<bool, MotionError> {
        let Node { state: start, a, rate, power, .. } = from;
        if self.to_sample.is_none() {
            self.to_sample =
                self.method.another(system.scene()).map(|method| Box::new((method, start.clone(), start.clone())));
        }
        let Some((method, at, end)) = self.to_sample.as_deref_mut() else { return Ok(false) };
        'parts: for n in [1, 2, 4] {
            let h = (t - start.t) / f64::from(n);
            method.restart();
            end.copy_from(start);
            for i in 0..n {
                std::mem::swap(at, end);
                at.t = start.t + f64::from(i) * h;
                let from = Node { state: &*at, q_rate: &at.v, a, rate, power };
                if matches!(method.attempt(system, from, h, self.of_estimate, end)?, Attempt::Diverged { .. }) {
                    continue 'parts;
                }
                method.accept(h);
            }
            out.copy_from(end);
            out.t = t;
            return Ok(true);
        }
        Ok(false)
    }

    /// A change that stays in the shorter step is rounding.
    fn shorter_for_constraints(&mut self, v: &[f64]) -> Option<f64> {
        let correction = self.correction(v);
        if self.refused.take().is_some_and(|refused| correction > RESOLVED * refused) {
            (self.rounding, self.longest_s) = (correction / RESOLVED, f64::INFINITY);
        }
        let made = self.made.as_ref()?;
        if correction <= self.rounding.max(1.0) {
            return None;
        }
        self.refused = Some(correction);
        self.longest_s = QUARTERED * made.length_s;
        Some(self.longest_s)
    }

    fn accept(&mut self) {
        let Some(Made { length_s, error, n_passes, whole_s, is_cut }) = self.made.take() else { return };
        let keeps = self.method.keeps_factors();
        let wanted_s = whole_s.unwrap_or_else(|| self.control.accept(length_s, error, n_passes, keeps));
        self.longest_s *= GROW_AGAIN;
        self.rounding /= GROW_AGAIN;
        self.step_s = Some(wanted_s.min(self.longest_s));
        self.refused = None;
        self.method.accept(length_s);
        if is_cut {
            self.method.turn();
        }
    }

    fn step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        _h: f64,
        end: f64,
        discontinuities: &mut dyn Discontinuities<System<P>>,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let t = from.state.t;
        let left = end - t;
        let mut length = self.step_s.unwrap_or_else(|| self.method.first_step(from, left, self.of_estimate));
        // the step length before a discontinuity, to continue with behind it
        let (mut whole, mut cut) = (None, None);
        loop {
            let StepLimit { step_s: h, t_next, .. } = limited_step(t, end, length);
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
                    if whole.is_none() {
                        discontinuities.restart();
                    }
                    let is_cut = cut.is_some();
                    self.made = Some(Made { length_s: h, error, n_passes, whole_s: whole, is_cut });
                    self.found.copy_from_slice(&to.v);
                    return Ok(());
                }
                Attempt::Solved { error, n_passes } => length = self.control.reject(h, error, n_passes),
                Attempt::Diverged { factor } => length = self.control.diverge(h, factor),
            }
            self.rejected += 1;
        }
    }

    fn remember(&mut self, system: &mut System<P>, archive: &mut Archive) {
        self.method.remember(system, archive);
        self.control.remember(archive);
        archive.option(&mut self.step_s);
        archive.number(&mut self.rounding);
        archive.number(&mut self.longest_s);
        archive.count(&mut self.rejected);
    }

    fn given_step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        to: &mut State,
    ) -> Result<bool, MotionError> {
        Ok(matches!(self.method.attempt(system, from, h, CONVERGED, to)?, Attempt::Solved { .. }))
    }

    fn accept_given(&mut self, h: f64) {
        self.method.accept(h);
    }
}
