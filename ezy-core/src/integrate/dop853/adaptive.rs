//! DOP853 with its step control.

use super::{Dop853, ERROR_ORDER, StiffnessWatch};
use crate::archive::Archive;
use crate::dynamics::{Dynamics, MotionError, State};
use crate::integrate::discontinuities::{Discontinuities, Passage};
use crate::integrate::family::Sizes;
use crate::integrate::step_control::StepControl;
use crate::integrate::step_limit::{StepLimit, is_too_short, limited_step};
use crate::integrate::tolerances::steps::{APPROACH, LARGEST_DENSE_ERROR, LEFT, MAX_DISCONTINUITIES};
use crate::integrate::{Integrator, Node, Tolerance};
use crate::scalar::Scalar;

/// DOP853 with the length of its next step.
pub(crate) struct Adaptive<T = f64> {
    method: Dop853<T>,
    control: StepControl,
    tolerance: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    /// Length of the last one, s.
    last_s: Option<f64>,
    watch: StiffnessWatch,
    rejected: u64,
    /// How values of the last step are found; none before the first.
    between: Option<Between>,
    /// For steps to values between the ends of a step.
    part: Option<Box<Dop853<T>>>,
}

/// How values between the ends of a step are found.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Between {
    /// By the polynomial.
    Polynomial,
    /// By a step of their own from the start of the step: the polynomial is off by more than the tolerance.
    Steps,
}

impl<T: Scalar> Adaptive<T> {
    pub(super) fn new(sizes: Sizes, tolerance: Tolerance) -> Self {
        Self {
            method: Dop853::new(sizes),
            control: StepControl::new(ERROR_ORDER),
            tolerance,
            step_s: None,
            last_s: None,
            watch: StiffnessWatch::default(),
            rejected: 0,
            between: None,
            part: None,
        }
    }

    /// [`Integrator::step`] towards `end`, with the error over the tolerance that `judge` finds of a try, by its length and the time of its end.
    ///
    /// In a layer a force changes by nearly all of itself, and the step is not short beside that: order 8 is not reached, and the
    /// estimate of order 5 counts as it is.
    pub(super) fn step_judged<D: Dynamics<T>>(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        end: f64,
        discontinuities: &mut dyn Discontinuities<D, T>,
        to: &mut State<T>,
        mut judge: impl FnMut(&mut Dop853<T>, &mut D, f64, f64) -> f64,
    ) -> Result<(), MotionError> {
        self.between = None;
        let t = from.state.t;
        let left = end - t;
        if let Some(last_s) = self.last_s
            && self.watch.is_due()
        {
            self.watch.note(self.method.stability(last_s, from), t);
        }
        let mut length = match self.step_s {
            Some(step_s) => step_s,
            None => self.method.first_step(system, from, left, self.tolerance)?,
        };
        // the step length before a discontinuity, to continue with behind it; not where the step becomes shorter than the way to it
        let (mut whole, mut n_discontinuities) = (None, 0);
        loop {
            let StepLimit { step_s: h, t_next, .. } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            match self.method.take(system, from, h, to) {
                Ok(()) => {
                    let mut error = judge(&mut self.method, system, h, t_next);
                    let passage = discontinuities.passage(system, from, to);
                    if passage == Passage::Layer {
                        error = error.max(self.method.error_of_order_5(h, self.tolerance));
                    }
                    if let Passage::Ends(shorter) = passage
                        && n_discontinuities < MAX_DISCONTINUITIES
                    {
                        n_discontinuities += 1;
                        let whole = *whole.get_or_insert(h);
                        length = if shorter > LEFT * whole { APPROACH * shorter } else { shorter };
                        self.rejected += 1;
                        continue;
                    } else if error <= 1.0 {
                        self.method.accept();
                        to.t = t_next;
                        let factor = self.control.accept(error);
                        self.step_s = Some(whole.unwrap_or(h * factor));
                        self.last_s = Some(h);
                        return Ok(());
                    } else {
                        length = h * self.control.reject(error);
                    }
                }
                // a stage may have left the region where the equations are defined; a shorter step may not
                Err(error) => {
                    length = h * self.control.reject(f64::NAN);
                    if is_too_short(t, length) {
                        return Err(error);
                    }
                }
            }
            (whole, n_discontinuities) = (None, 0);
            self.rejected += 1;
        }
    }
}

impl<D: Dynamics<T>, T: Scalar> Integrator<D, T> for Adaptive<T> {
    fn restart(&mut self) {
        self.method.restart();
        self.control = StepControl::new(ERROR_ORDER);
        self.step_s = None;
        self.last_s = None;
        self.watch.restart();
    }

    fn restart_with(&mut self, step_s: f64) {
        Integrator::<D, T>::restart(self);
        self.step_s = Some(step_s);
    }

    fn stiff_since(&self) -> Option<f64> {
        self.watch.since()
    }

    fn n_rejected(&self) -> u64 {
        self.rejected
    }

    /// # Cost
    /// Three evaluations of the accelerations for all values of a step, or eleven each where the polynomial is not good enough.
    fn between(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        to: Node<'_, T>,
        t: f64,
        out: &mut State<T>,
    ) -> Result<(), MotionError> {
        let between = match self.between {
            Some(between) => between,
            None => {
                self.method.prepare_dense(system, from, to)?;
                let is_right = self.method.dense_error(self.tolerance) <= LARGEST_DENSE_ERROR;
                if is_right { Between::Polynomial } else { Between::Steps }
            }
        };
        self.between = Some(between);
        let length = t - from.state.t;
        match between {
            Between::Polynomial => self.method.dense_at(length / (to.state.t - from.state.t), out),
            Between::Steps => {
                self.part.get_or_insert_with(|| Box::new(self.method.another())).attempt(
                    system,
                    from,
                    length,
                    self.tolerance,
                    out,
                )?;
            }
        }
        out.t = t;
        Ok(())
    }

    fn step(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        _h: f64,
        end: f64,
        discontinuities: &mut dyn Discontinuities<D, T>,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        let tolerance = self.tolerance;
        self.step_judged(system, from, end, discontinuities, to, |method, _, h, _| method.weighted_error(h, tolerance))
    }

    fn remember(&mut self, _system: &mut D, archive: &mut Archive<T>) {
        self.method.remember(archive);
        self.control.remember(archive);
        self.watch.remember(archive);
        archive.option(&mut self.step_s);
        archive.option(&mut self.last_s);
        archive.count(&mut self.rejected);
    }

    fn given_step(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        to: &mut State<T>,
    ) -> Result<bool, MotionError> {
        self.between = None;
        self.method.attempt(system, from, h, self.tolerance, to)?;
        Ok(true)
    }

    fn accept_given(&mut self, _h: f64) {
        self.method.accept();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::discontinuities::{Cut, Smooth};

    /// One number that moves freely.
    const ONE: Sizes = Sizes { n_q: 1, n_v: 1, n_c: 0, n_z: 0, n_works: 0 };

    /// Every step passes this.
    struct Passes(Passage);

    impl<D> Discontinuities<D> for Passes {
        fn passage(&mut self, _: &mut D, _: Node<'_>, _: &State) -> Passage {
            self.0
        }

        fn has_layers(&self) -> bool {
            false
        }

        fn turns(&mut self, _: &mut D, _: &State, _: &State, _: f64) -> bool {
            false
        }

        fn cut(&mut self, _: &mut D, _: Node<'_>, _: &[&State], _: f64) -> Option<Cut> {
            None
        }

        fn are_crossed(&mut self, _: &mut D, _: &State, _: &[&State]) -> bool {
            false
        }

        fn restart(&mut self) {}

        fn rest(&mut self) {}
    }

    /// Moves uniformly, up to a wall at 1 m.
    struct UpToAWall;

    impl Dynamics<f64> for UpToAWall {
        fn accelerations(
            &mut self,
            t: f64,
            q: &[f64],
            _: &[f64],
            a: &mut [f64],
            _: &mut [f64],
        ) -> Result<(), MotionError> {
            a[0] = 0.0;
            if q[0] <= 1.0 { Ok(()) } else { Err(MotionError::NotFinite { t, quantity: "a force".into() }) }
        }

        fn position_rates(&self, _: &[f64], v: &[f64], out: &mut [f64]) {
            out.copy_from_slice(v);
        }

        fn place_states(&mut self, _: &[f64]) {}

        fn state_rates(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}

        fn power(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
    }

    /// Moves under a force of this size whose values at the stages have nothing to do with each other, as in a narrow layer.
    struct Rough(f64);

    impl Dynamics<f64> for Rough {
        fn accelerations(
            &mut self,
            t: f64,
            _: &[f64],
            _: &[f64],
            a: &mut [f64],
            _: &mut [f64],
        ) -> Result<(), MotionError> {
            a[0] = self.0 * (1e6 * t).sin();
            Ok(())
        }

        fn position_rates(&self, _: &[f64], v: &[f64], out: &mut [f64]) {
            out.copy_from_slice(v);
        }

        fn place_states(&mut self, _: &[f64]) {}

        fn state_rates(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}

        fn power(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
    }

    /// In a layer the larger error counts, that of order 5 alone or of all estimates: what is accepted there is accepted anywhere.
    #[test]
    fn invariant_step_in_a_layer_is_accepted_only_where_any_other_is() {
        let start = State { t: 0.0, q: vec![0.0], v: vec![0.0], z: Vec::new(), work: Vec::new() };
        let mut refused = [0, 0];
        for i in 0..400 {
            let (size, step_s) = (10_f64.powf(-10.0 + 0.01 * f64::from(i)), 1.0 + 0.01 * f64::from(i % 7));
            let [smooth, layer] = [Passage::Smooth, Passage::Layer].map(|passage| {
                let mut adaptive = Adaptive::new(ONE, Tolerance::new(1e-9, 1e-9));
                adaptive.step_s = Some(step_s);
                let from = Node { state: &start, q_rate: &start.v, a: &[0.0], rate: &[], power: &[] };
                adaptive.step(&mut Rough(size), from, 10.0, 10.0, &mut Passes(passage), &mut start.clone()).unwrap();
                adaptive.rejected > 0
            });
            assert!(layer || !smooth, "{size:e} {step_s}");
            refused[0] += u32::from(layer);
            refused[1] += u32::from(smooth);
        }
        assert!(refused[0] >= refused[1] && refused[1] > 0 && refused[0] < 400, "{refused:?}");
    }

    /// Of 4 s, 4/3 s and 4/9 s only the last ends before the wall, which is 1 s away. From the wall on no step leads on.
    #[test]
    fn analytic_step_whose_stages_leave_where_equations_are_defined_is_made_shorter() {
        let at = |x: f64| State { t: 0.0, q: vec![x], v: vec![1.0], z: Vec::new(), work: Vec::new() };
        let step = |start: &State, to: &mut State| {
            let mut adaptive = Adaptive::new(ONE, Tolerance::new(1e-9, 1e-9));
            adaptive.step_s = Some(4.0);
            let from = Node { state: start, q_rate: &start.v, a: &[0.0], rate: &[], power: &[] };
            let outcome = adaptive.step(&mut UpToAWall, from, 10.0, 10.0, &mut Smooth, to);
            (outcome, adaptive.rejected)
        };
        let mut to = at(0.0);
        assert_eq!(step(&at(0.0), &mut to), (Ok(()), 2));
        assert!((to.t - 4.0 / 9.0).abs() <= 1e-15 && (to.q[0] - to.t).abs() <= 1e-15, "{to:?}");
        let (outcome, _) = step(&at(1.0), &mut to);
        assert!(matches!(outcome, Err(MotionError::NotFinite { .. })), "{outcome:?}");
    }
}
