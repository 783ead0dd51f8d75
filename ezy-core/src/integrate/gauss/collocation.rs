//! Gauss–Legendre collocation with its step control.

use super::tableau::NODES;
use super::{Collocated, Gauss, GaussControl};
use crate::archive::Archive;
use crate::dynamics::{MotionError, State, System, SystemError};
use crate::integrate::discontinuities::{Discontinuities, Passage};
use crate::integrate::family::{Family, MethodInfo, Needs};
use crate::integrate::step_limit::{StepLimit, is_too_short, limited_step};
use crate::integrate::tolerances::gauss::TURNED_WITHIN;
use crate::integrate::tolerances::second_run::TIGHTER;
use crate::integrate::tolerances::steps::{APPROACH, LEFT, MAX_DISCONTINUITIES};
use crate::integrate::{Integrator, Node, Tolerance};
use crate::model::SceneRef;

/// For given steps: their changes are compared with the tolerance itself.
const TO_ROUNDING: Tolerance = Tolerance::new(1e-14, 1e-14);

/// Collocation with the length of its next step.
pub(crate) struct Collocation {
    method: Gauss,
    control: GaussControl,
    tolerance: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    rejected: u64,
    /// Whether the last step ends behind a discontinuity, with the forces there.
    is_cut: bool,
    /// Error of the polynomial of the last step, over the tolerance.
    dense_error: f64,
    /// For the time of a call; made when it is first needed.
    node: Option<State>,
}

impl Family for Collocation {
    const INFO: MethodInfo = MethodInfo {
        name: "gauss",
        summary: "Gauss-Legendre collocation of order 16 with steps that keep to a tolerance, for smooth motions",
        order: Some(16),
        chooses_steps: true,
        is_implicit: false,
        needs: Needs::Nothing,
        takes_any_body: false,
        takes_states: false,
        // its errors lie up to five orders below the tolerance where that is large
        tighter: TIGHTER * TIGHTER,
        // a smaller tolerance may end with the same sweeps, and so with the same error: another method shows it
        rounding: f64::INFINITY,
    };

    fn of_system<P: SceneRef>(
        system: &System<P>,
        n_works: usize,
        tolerance: Tolerance,
        _is_projected: bool,
    ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
        let method = Gauss::new(system.scene(), n_works);
        let control = GaussControl::default();
        Ok(Some(Box::new(Self {
            method,
            control,
            tolerance,
            step_s: None,
            rejected: 0,
            is_cut: false,
            dense_error: 0.0,
            node: None,
        })))
    }
}

impl Collocation {
    /// Whether a smoothed law turns between the start and a node: steps are long enough for there and back.
    ///
    /// # Cost
    /// Nine evaluations of the events, in scenes with such laws.
    fn turns_within<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: &State,
        to: &State,
        discontinuities: &mut dyn Discontinuities<System<P>>,
    ) -> bool {
        if !discontinuities.has_layers() {
            return false;
        }
        let Self { method, node, .. } = self;
        let node = node.get_or_insert_with(|| to.clone());
        NODES.0.iter().any(|&c| {
            method.dense_at(from, c, node);
            node.t = from.t + c * (to.t - from.t);
            discontinuities.turns(system, from, node, TURNED_WITHIN)
        })
    }
}

impl<P: SceneRef> Integrator<System<P>> for Collocation {
    fn restart(&mut self) {
        self.method.restart();
        self.control = GaussControl::default();
        self.step_s = None;
    }

    fn restart_with(&mut self, step_s: f64) {
        Integrator::<System<P>>::restart(self);
        self.step_s = Some(step_s);
    }

    fn n_rejected(&self) -> u64 {
        self.rejected
    }

    /// A step of order 16 goes over most of a period.
    fn n_event_parts(&self) -> usize {
        NODES.0.len()
    }

    /// Infinite where accelerations were not eliminated.
    fn smallest_pivot_within(&self) -> f64 {
        self.method.smallest_pivot()
    }

    fn accept(&mut self) {
        self.method.accept();
    }

    /// # Cost
    /// Where the polynomial of the step is not good enough, some sweeps for each of its parts, once a step.
    fn between(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        to: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        let share = (t - from.state.t) / (to.state.t - from.state.t);
        if self.dense_error <= 1.0 {
            self.method.dense_at(from.state, share, out);
        } else {
            let n_parts = Collocated::n_parts(self.dense_error);
            self.method.dense_in_parts(system, from.state, n_parts, self.tolerance, share, out);
        }
        out.t = t;
        Ok(())
    }

    /// In a layer a force changes by nearly all of itself, and the step is not short beside that: the order of its end is not reached, and
    /// the error of its polynomial counts.
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
        let mut length = self.step_s.unwrap_or_else(|| self.method.first_step(from, left));
        // the step length before a discontinuity, to continue with behind it; not where the step becomes shorter than the way to it
        let (mut whole, mut n_discontinuities, mut is_cut) = (None, 0, false);
        loop {
            let StepLimit { step_s: h, t_next, nears_end } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            match self.method.attempt(system, from, h, self.tolerance, to) {
                Ok(Collocated::Solved { mut error, dense_error, steepness }) => {
                    let passage = discontinuities.passage(system, from, to);
                    if let Passage::Ends(shorter) = passage
                        && n_discontinuities < MAX_DISCONTINUITIES
                    {
                        n_discontinuities += 1;
                        let whole = *whole.get_or_insert(h);
                        is_cut = shorter <= LEFT * whole;
                        length = if is_cut { shorter } else { APPROACH * shorter };
                        self.rejected += 1;
                        continue;
                    }
                    let is_layer = passage == Passage::Layer
                        || (error <= 1.0
                            && dense_error > 1.0
                            && self.turns_within(system, from.state, to, discontinuities));
                    if is_layer {
                        error = error.max(dense_error);
                    }
                    let factor = self.control.factor(h, error, steepness);
                    if error <= 1.0 {
                        to.t = t_next;
                        self.dense_error = dense_error;
                        self.is_cut = is_cut && discontinuities.are_crossed(system, from.state, &[to]);
                        // one that was cut short says little of the next
                        let shortest = if nears_end { length } else { 0.0 };
                        self.step_s = Some(whole.unwrap_or((h * factor).max(shortest)));
                        return Ok(());
                    }
                    length = h * factor;
                }
                Ok(Collocated::Diverged) => length = h * self.control.failed(),
                // a node may have left the region where the equations are defined; a shorter step may not
                Err(error) => {
                    length = h * self.control.failed();
                    if is_too_short(t, length) {
                        return Err(error);
                    }
                }
            }
            (whole, n_discontinuities, is_cut) = (None, 0, false);
            self.rejected += 1;
        }
    }

    fn judges_by_end(&self) -> bool {
        true
    }

    fn refuses(&mut self, from: Node<'_>, to: Node<'_>) -> bool {
        let (t, h) = (from.state.t, to.state.t - from.state.t);
        let error = self.method.error_by_end(to.a);
        if error <= 1.0 || self.is_cut {
            return false;
        }
        let shorter = h * self.control.factor(h, error, 0.0);
        let refuses = !is_too_short(t, shorter);
        if refuses {
            self.step_s = Some(shorter);
            self.rejected += 1;
        }
        refuses
    }

    fn remember(&mut self, _system: &mut System<P>, archive: &mut Archive) {
        self.method.remember(archive);
        self.control.remember(archive);
        archive.option(&mut self.step_s);
        archive.count(&mut self.rejected);
    }

    fn given_step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        to: &mut State,
    ) -> Result<bool, MotionError> {
        self.dense_error = 0.0;
        Ok(matches!(self.method.attempt(system, from, h, TO_ROUNDING, to)?, Collocated::Solved { .. }))
    }

    fn accept_given(&mut self, _h: f64) {
        self.method.accept();
    }
}
