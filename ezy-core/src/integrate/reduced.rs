//! The state of a run in quasi-velocities.

use super::hermite::Node;
use super::step_control::Tolerance;
use super::tolerances::quasi_velocities::SAME;
use crate::archive::Archive;
use crate::dynamics::{EightStates, State, System};
use crate::model::{Derived as _, EventKind, QuasiVelocities, Scene, SceneRef};

/// The numbers that are integrated: `n_u` quasi-velocities, then these of `n_q` coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Numbers {
    pub n_u: usize,
    pub integrated: &'static [usize],
    pub n_q: usize,
    pub tolerance: Tolerance,
}

impl Numbers {
    /// How many there are.
    pub(super) fn n(&self) -> usize {
        self.n_u + self.integrated.len()
    }
}

/// One end of a step.
#[derive(Debug)]
pub(super) struct End {
    /// Time and numbers, as first-order states; the time is no number before there is a state.
    pub state: State,
    /// All coordinates, and velocities.
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Slopes of the numbers, once they are computed.
    slopes: Vec<f64>,
    is_evaluated: bool,
}

impl End {
    fn new(numbers: Numbers, n_works: usize) -> Self {
        let (n, n_q) = (numbers.n(), numbers.n_q);
        let mut state = State::zeros([0, 0], n, n_works);
        state.t = f64::NAN;
        Self { state, q: vec![0.0; n_q], v: vec![0.0; n_q], slopes: vec![0.0; n], is_evaluated: false }
    }

    /// Whether this is that state, to the last bit.
    fn is(&self, State { t, q, v, .. }: &State) -> bool {
        self.state.t == *t && self.q == *q && self.v == *v
    }

    /// With the slopes, which are computed, and these powers.
    pub(super) fn node<'a>(&'a self, power: &'a [f64]) -> Node<'a> {
        Node { state: &self.state, q_rate: &[], a: &[], rate: &self.slopes, power }
    }

    /// Slopes of the numbers, which are computed where they are not known.
    pub(super) fn slopes<S: Scene + ?Sized>(&mut self, motion: &mut Motion<'_, S>) -> &[f64] {
        if !std::mem::replace(&mut self.is_evaluated, true) {
            motion.slopes_at(self.state.t, &self.state.z, &mut self.slopes);
        }
        &self.slopes
    }

    /// Completes the state at numbers whose coordinates and velocities are known: those coordinates that position constraints give come from there.
    pub(super) fn complete(&mut self, numbers: Numbers, to: &mut State) {
        let Self { state, q, v, is_evaluated, .. } = self;
        for (number, &i) in state.z[numbers.n_u..].iter_mut().zip(numbers.integrated) {
            *number = q[i];
        }
        *is_evaluated = false;
        to.t = state.t;
        to.q.copy_from_slice(q);
        to.v.copy_from_slice(v);
        to.work.copy_from_slice(&state.work);
    }
}

/// What is overwritten.
#[derive(Debug)]
pub(super) struct Buffers {
    /// Coordinates, of which those that are integrated are given.
    given: Vec<f64>,
    /// Coordinates and velocities of a stage.
    whole: [Vec<f64>; 2],
    /// Multipliers, which no power reads: rows do not move.
    lambda: Vec<f64>,
}

/// Both ends of a step of quasi-velocities and of those coordinates that no position constraint gives, with those that the motion depends on. At its ends the other
/// coordinates are computed from these, and all velocities: they obey the rows without a projection.
#[derive(Debug)]
pub(super) struct Reduced {
    pub numbers: Numbers,
    pub start: End,
    pub end: End,
    pub buffers: Buffers,
}

impl Reduced {
    /// `None` for a scene without such equations or with a body that is free to go anywhere, with rows that move, whose power takes multipliers, with discontinuities, with
    /// first-order states or with inputs that change from step to step, and where another solver than its elimination is asked for.
    pub(super) fn new<P: SceneRef>(system: &System<P>, n_works: usize, tolerance: Tolerance) -> Option<Self> {
        let (scene, info) = (system.scene(), system.info());
        let quasi =
            info.quasi_velocities.filter(|quasi| !quasi.has_free_body && scene.in_quasi_velocities().is_some())?;
        let is_law = |kind| matches!(kind, EventKind::Discontinuity | EventKind::Layer);
        let moves = info.effects.iter().any(|effect| matches!(effect.name, "drives" | "stops"));
        let is_smooth = !info.events.iter().any(|event| is_law(event.kind));
        let is_steady = info.n_states() == 0 && info.integrated_inputs.is_empty();
        if moves || !is_smooth || !is_steady || !system.uses_elimination() {
            return None;
        }
        let n_q = info.n_coordinates();
        let zeros = |n: usize| vec![0.0; n];
        let buffers = Buffers { given: zeros(n_q), whole: [zeros(n_q), zeros(n_q)], lambda: zeros(info.n_rows()) };
        let numbers = Numbers { n_u: quasi.formulas.len(), integrated: quasi.integrated, n_q, tolerance };
        let [start, end] = std::array::from_fn(|_| End::new(numbers, n_works));
        Some(Self { numbers, start, end, buffers })
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        [&mut self.start, &mut self.end].into_iter().for_each(|end| end.state.t = f64::NAN);
    }

    /// Takes a state for the start of a step. False where it does not obey the rows, where some of them are switched off, and where a pivot vanishes that depends on
    /// parameters.
    pub(super) fn starts<P: SceneRef>(&mut self, system: &System<P>, from: &State) -> bool {
        let Some(equations) = system.scene().in_quasi_velocities().filter(|_| EightStates::has_all_rows(system)) else {
            return false;
        };
        let (fixed, Self { numbers, start, end, .. }) = (system.fixed(), self);
        if !start.is(from) {
            std::mem::swap(start, end);
        }
        let State { t, q, v, work, .. } = from;
        start.state.work.copy_from_slice(work);
        if start.is(from) {
            return true;
        }
        let (u, of_q) = start.state.z.split_at_mut(numbers.n_u);
        equations.of_one().quasi_velocities(fixed, q, v, u);
        equations.of_one().velocities(fixed, *t, q, u, &mut start.v);
        let obeys = are_same(v.iter().copied(), start.v.iter().copied());
        of_q.iter_mut().zip(numbers.integrated).for_each(|(number, &i)| *number = q[i]);
        start.state.t = if obeys { *t } else { f64::NAN };
        start.q.copy_from_slice(q);
        start.v.copy_from_slice(v);
        start.is_evaluated = false;
        obeys
    }

    /// Writes both ends, or reads them.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        for End { state, q, v, is_evaluated, .. } in [&mut self.start, &mut self.end] {
            archive.number(&mut state.t);
            [&mut state.z, &mut state.work, q, v].into_iter().for_each(|numbers| archive.numbers(numbers));
            *is_evaluated &= !archive.is_read();
        }
    }
}

/// The motion of the numbers.
pub(super) struct Motion<'a, S: ?Sized> {
    scene: &'a S,
    equations: &'a dyn QuasiVelocities<f64>,
    fixed: &'a [f64],
    pub numbers: Numbers,
    buffers: &'a mut Buffers,
    /// How often slopes were computed.
    pub n_evaluations: u64,
}

impl<'a, S: Scene + ?Sized> Motion<'a, S> {
    /// Of a scene with equations in quasi-velocities.
    pub(super) fn of<P: SceneRef<Target = S>>(
        system: &'a System<P>,
        numbers: Numbers,
        buffers: &'a mut Buffers,
    ) -> Self {
        let scene = system.scene();
        let equations = scene.in_quasi_velocities().expect("who starts a step has asked").of_one();
        Self { scene, equations, fixed: system.fixed(), numbers, buffers, n_evaluations: 0 }
    }

    /// All coordinates and velocities at these numbers.
    pub(super) fn expand(&mut self, t: f64, numbers: &[f64], q: &mut [f64], v: &mut [f64]) {
        let u = self.place(numbers);
        self.equations.whole_state(self.fixed, t, &self.buffers.given, u, q, v);
    }

    /// Slopes of these numbers.
    #[inline]
    pub(super) fn slopes_at(&mut self, t: f64, numbers: &[f64], out: &mut [f64]) {
        let u = self.place(numbers);
        let (of_u, of_q) = out.split_at_mut(self.numbers.n_u);
        self.equations.motion(self.fixed, t, &self.buffers.given, u, of_u, of_q);
        self.n_evaluations += 1;
    }

    /// Power of each effect at these numbers.
    pub(super) fn powers_at(&mut self, t: f64, numbers: &[f64], out: &mut [f64]) {
        let u = self.place(numbers);
        let Buffers { given, whole: [q, v], lambda } = &mut *self.buffers;
        self.equations.whole_state(self.fixed, t, given, u, q, v);
        self.scene.power(self.fixed, t, q, v, lambda, out);
    }

    /// Places those of the numbers that are coordinates, and returns the others.
    #[inline]
    fn place<'n>(&mut self, numbers: &'n [f64]) -> &'n [f64] {
        let (u, of_q) = numbers.split_at(self.numbers.n_u);
        self.numbers.integrated.iter().zip(of_q).for_each(|(&i, q)| self.buffers.given[i] = *q);
        u
    }
}

/// Whether quasi-velocities give back the velocities that they are taken from. They do not where those do not obey the rows, nor where a pivot vanishes that depends on parameters.
pub(super) fn are_same(v: impl Iterator<Item = f64> + Clone, found: impl Iterator<Item = f64>) -> bool {
    let fastest = v.clone().fold(0.0, |fastest: f64, v| fastest.max(v.abs()));
    v.zip(found).all(|(v, found)| (v - found).abs() <= SAME * fastest)
}
