//! DOP853 of a run in quasi-velocities, where its scene has them.

use super::{Adaptive, Dop853};
use crate::archive::Archive;
use crate::dynamics::{Dynamics, MotionError, State, System};
use crate::integrate::discontinuities::{Discontinuities, Smooth};
use crate::integrate::family::Sizes;
use crate::integrate::reduced::{End, Motion, Reduced};
use crate::integrate::{Integrator, Node, Tolerance};
use crate::model::{Scene, SceneRef};

/// Steps in quasi-velocities, and those of the rows where a start does not obey them, where some of them are switched off, and where a number would not
/// be finite.
pub(super) struct SingleRun {
    rows: Adaptive,
    steps: Adaptive,
    reduced: Reduced,
    /// Whether the step that was taken last is one in quasi-velocities.
    is_reduced: bool,
    /// Numbers, coordinates and velocities at the end of a step with the error that it may have.
    off: [Vec<f64>; 3],
    /// Numbers between both ends.
    inside: State,
}

/// As a system of first-order states alone.
impl<S: Scene + ?Sized> Dynamics<f64> for Motion<'_, S> {
    #[inline]
    fn slopes(
        &mut self,
        t: f64,
        [_, _, z]: [&[f64]; 3],
        _lambda: &mut [f64],
        [_, _, of_z, of_work]: [&mut [f64]; 4],
    ) -> Result<(), MotionError> {
        self.slopes_at(t, z, of_z);
        if !of_work.is_empty() {
            self.powers_at(t, z, of_work);
        }
        Ok(())
    }

    fn accelerations(
        &mut self,
        _t: f64,
        _q: &[f64],
        _v: &[f64],
        _a: &mut [f64],
        _lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        Ok(())
    }

    fn position_rates(&self, _q: &[f64], _v: &[f64], _out: &mut [f64]) {}

    fn place_states(&mut self, _z: &[f64]) {}

    fn state_rates(&self, _t: f64, _q: &[f64], _v: &[f64], _out: &mut [f64]) {}

    fn power(&self, _t: f64, _q: &[f64], _v: &[f64], _lambda: &[f64], _out: &mut [f64]) {}
}

/// The error over the tolerance of the step of length `h` that was tried last; writes coordinates and velocities at its end.
fn judge<S: Scene + ?Sized>(
    motion: &mut Motion<'_, S>,
    tried: &Dop853,
    [h, t]: [f64; 2],
    start: &End,
    [q, v]: [&mut [f64]; 2],
    [off, off_q, off_v]: &mut [Vec<f64>; 3],
) -> f64 {
    let numbers = motion.numbers;
    let (from, to, errors) = tried.tried();
    let mut shares = [0.0; 3];
    for (i, off) in off.iter_mut().enumerate() {
        let errors = errors.map(|errors| errors[i]);
        numbers.add(i, [from[i], to[i]], errors, &mut shares);
        *off = to[i] + h * errors[0];
    }
    motion.expand(t, &to[..numbers.n()], q, v);
    motion.expand(t, off, off_q, off_v);
    numbers.error(h, shares, [[&start.q, &start.v], [q, v], [off_q, off_v]])
}

impl SingleRun {
    /// `None` where [`Reduced`] has none.
    pub(super) fn new<P: SceneRef>(system: &System<P>, n_works: usize, tolerance: Tolerance) -> Option<Self> {
        let reduced = Reduced::new(system, n_works, tolerance)?;
        let (n, n_q) = (reduced.numbers.n(), reduced.numbers.n_q);
        let zeros = |n: usize| vec![0.0; n];
        Some(Self {
            rows: Adaptive::new(Sizes::new(system.info(), n_works), tolerance),
            steps: Adaptive::new(Sizes { n_q: 0, n_v: 0, n_c: 0, n_z: n, n_works }, tolerance),
            reduced,
            is_reduced: false,
            off: [zeros(n), zeros(n_q), zeros(n_q)],
            inside: State::zeros([0, 0], n, n_works),
        })
    }

    /// A step in quasi-velocities from `start`, with the powers there.
    fn step_reduced<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        power: &[f64],
        until: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let Self { steps, reduced: Reduced { numbers, start, end, buffers, .. }, off, .. } = self;
        let mut motion = Motion::of(system, *numbers, buffers);
        start.slopes(&mut motion);
        let End { state, q, v, .. } = end;
        let outcome =
            steps.step_judged(&mut motion, start.node(power), until, &mut Smooth, state, |tried, motion, h, t| {
                judge(motion, tried, [h, t], start, [q, v], off)
            });
        let n_evaluations = motion.n_evaluations;
        system.counters().evaluations += n_evaluations;
        end.complete(*numbers, to);
        outcome
    }
}

impl<P: SceneRef> Integrator<System<P>> for SingleRun {
    fn restart(&mut self) {
        Integrator::<System<P>>::restart(&mut self.rows);
        Integrator::<System<P>>::restart(&mut self.steps);
        self.reduced.restart();
        self.is_reduced = false;
    }

    fn restart_with(&mut self, step_s: f64) {
        Integrator::<System<P>>::restart(self);
        Integrator::<System<P>>::restart_with(&mut self.rows, step_s);
        Integrator::<System<P>>::restart_with(&mut self.steps, step_s);
    }

    fn stiff_since(&self) -> Option<f64> {
        let [rows, steps] = [&self.rows, &self.steps].map(Integrator::<System<P>>::stiff_since);
        rows.or(steps)
    }

    fn n_rejected(&self) -> u64 {
        [&self.rows, &self.steps].map(Integrator::<System<P>>::n_rejected).iter().sum()
    }

    fn keeps_rows(&self) -> bool {
        self.is_reduced
    }

    fn step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        end: f64,
        discontinuities: &mut dyn Discontinuities<System<P>>,
        to: &mut State,
    ) -> Result<(), MotionError> {
        // what is left behind begins anew when it is taken again
        if self.reduced.starts(system, from.state) {
            if !std::mem::replace(&mut self.is_reduced, true) {
                Integrator::<System<P>>::restart(&mut self.rows);
            }
            let outcome = self.step_reduced(system, from.power, end, to);
            if outcome.is_ok() {
                return outcome;
            }
        }
        // where that failed the rows say why
        if std::mem::replace(&mut self.is_reduced, false) {
            Integrator::<System<P>>::restart(&mut self.steps);
        }
        self.rows.step(system, from, h, end, discontinuities, to)
    }

    fn between(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        to: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        if !self.is_reduced {
            return self.rows.between(system, from, to, t, out);
        }
        let Self { steps, reduced: Reduced { numbers, start, end, buffers, .. }, inside, .. } = self;
        let mut motion = Motion::of(system, *numbers, buffers);
        end.slopes(&mut motion);
        steps.between(&mut motion, start.node(from.power), end.node(to.power), t, inside)?;
        motion.expand(t, &inside.z, &mut out.q, &mut out.v);
        out.work.copy_from_slice(&inside.work);
        out.t = t;
        let n_evaluations = motion.n_evaluations;
        system.counters().evaluations += n_evaluations;
        Ok(())
    }

    fn remember(&mut self, system: &mut System<P>, archive: &mut Archive) {
        self.rows.remember(system, archive);
        self.steps.remember(system, archive);
        self.reduced.remember(archive);
        archive.flag(&mut self.is_reduced);
    }

    fn given_step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        to: &mut State,
    ) -> Result<bool, MotionError> {
        self.rows.given_step(system, from, h, to)
    }

    fn accept_given(&mut self, h: f64) {
        Integrator::<System<P>>::accept_given(&mut self.rows, h);
    }
}
