//! Gauss–Legendre collocation with eight nodes, of order 16: accelerations at all nodes at once, improved by sweeps.

mod collocation;
mod control;
mod convergence;
mod errors;
mod lanes;
mod quasi;
mod tableau;

use super::{Node, compensated, step_control::Tolerance};
use crate::archive::Archive;
use crate::dynamics::{EightStates, MotionError, State, System};
use crate::integrate::tolerances::gauss::FIRST_CHANGE;
use crate::model::{Eight, Scene, SceneRef};
use crate::scalar::{Lanes, Scalar};
pub(crate) use collocation::Collocation;
use control::GaussControl;
use convergence::{Convergence, Sweeps};
use errors::{StepError, next_coefficient};
use quasi::QuasiSweeps;
use tableau::{LARGEST_INTEGRAL, N, NODES, legendre, mean_of_integral, weights_up_to};

/// What became of a step that was tried.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Collocated {
    /// Errors over the tolerance, at the end of the step and of the polynomial within it, and by how much the equations change slopes over the step.
    Solved { error: f64, dense_error: f64, steepness: f64 },
    /// The sweeps do not converge.
    Diverged,
}

/// Collocation for q' = v, v' = a(t, q, v), w' = power of each effect.
///
/// The accelerations on a step are a polynomial of degree 7 that meets the equations at eight nodes. Sweeps find it: integrals of the
/// accelerations at the nodes give velocities there, those of the velocities positions, and these new accelerations (Picard's iteration).
/// The first sweep begins with the polynomial of the step before, continued. Of scenes with equations in quasi-velocities these and the coordinates that
/// they depend on are what sweeps find ([`QuasiSweeps`]); accelerations at the nodes follow.
///
/// # Source
/// Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1 and VIII.6.
#[derive(Debug)]
pub(crate) struct Gauss {
    nodes: EightStates,
    /// The coordinates that accelerations depend on, each with the place of its velocity.
    feedback: Vec<(usize, usize)>,
    /// For a scene with equations in quasi-velocities.
    quasi: Option<QuasiSweeps>,
    /// Accelerations of the sweep before.
    before: Vec<Eight>,
    /// Legendre coefficients of the accelerations of the step that was tried last, and of the step before it.
    coefficients: Vec<Eight>,
    last: Vec<Eight>,
    /// Sizes of those coefficients by degree, as [`lanes::sizes`].
    sizes: [f64; N],
    /// What they tell of the step that was tried last.
    error: StepError,
    last_sizes: [f64; N],
    /// Length of the step before, s; none after a start.
    last_s: Option<f64>,
    /// Length of the step that was tried last, s; none once the next one begins at its end.
    tried_s: Option<f64>,
    /// Change of an acceleration to change of the state over the tolerance.
    weights: Vec<f64>,
    /// Whether velocities at the nodes are the integrals of the accelerations there.
    has_velocities: bool,
    /// Power of each effect at the nodes, and change of a power to change of the work over the tolerance.
    power: Vec<Eight>,
    work_weights: Vec<f64>,
    /// Legendre coefficients of the powers.
    of_power: Vec<Eight>,
    /// Parts of the step that was tried last, of which the first `n_parts` are solved for.
    parts: Vec<Part>,
    n_parts: usize,
    /// What rounding cut off the last accepted step, and what it would cut off the present one.
    rest: State,
    next_rest: State,
}

impl Gauss {
    /// Storage for a scene.
    pub(crate) fn new<S: Scene + ?Sized>(scene: &S, n_works: usize) -> Self {
        let info = scene.info();
        let n_q = info.n_coordinates();
        let zeros = |n: usize| vec![Eight::from_f64(0.0); n];
        Self {
            nodes: EightStates::new(scene),
            feedback: info
                .feedback
                .map_or_else(|| (0..n_q).collect(), <[usize]>::to_vec)
                .into_iter()
                .map(|i| (i, i))
                .collect(),
            quasi: QuasiSweeps::new(scene),
            before: zeros(n_q),
            coefficients: zeros(n_q),
            last: zeros(n_q),
            sizes: [0.0; N],
            error: StepError::new(n_q),
            last_sizes: [0.0; N],
            last_s: None,
            tried_s: None,
            weights: vec![0.0; n_q],
            has_velocities: false,
            power: zeros(n_works),
            work_weights: vec![0.0; n_works],
            of_power: zeros(n_works),
            parts: Vec::new(),
            n_parts: 0,
            rest: State::zero(n_q, n_works),
            next_rest: State::zero(n_q, n_works),
        }
    }

    /// Forgets the steps taken so far, before another run.
    pub(crate) fn restart(&mut self) {
        (self.last_s, self.tried_s) = (None, None);
        self.quasi.iter_mut().for_each(QuasiSweeps::restart);
        [&mut self.rest.q, &mut self.rest.v, &mut self.rest.work].into_iter().for_each(|rest| rest.fill(0.0));
    }

    /// Writes what the next step takes from the last one, or reads it.
    fn remember(&mut self, archive: &mut Archive) {
        self.rest.remember(archive);
        self.last.iter_mut().for_each(|lanes| archive.numbers(&mut lanes.0));
        archive.numbers(&mut self.last_sizes);
        archive.option(&mut self.last_s);
        self.quasi.iter_mut().for_each(|quasi| quasi.remember(archive));
    }

    /// Attempts one step of length `h` from `from`; writes `to`, not yet projected.
    ///
    /// # Errors
    /// [`MotionError`] at a node; `to` is then unspecified.
    /// # Cost
    /// Some ten sweeps, each of the accelerations at eight states or of the rates of quasi-velocities there; no allocation.
    pub(crate) fn attempt<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        tolerance: Tolerance,
        to: &mut State,
    ) -> Result<Collocated, MotionError> {
        self.begin(system, from, h, tolerance);
        let Self { nodes, quasi, weights, .. } = self;
        let converged = quasi.as_mut().and_then(|quasi| quasi.sweep(system, nodes, from.state, h, tolerance, weights));
        let converged = match converged {
            Some(Some(converged)) => {
                nodes.accelerate(system)?;
                Some(converged)
            }
            Some(None) => None,
            None => {
                self.continue_accelerations(from, h);
                self.sweep(system, from.state, h)?
            }
        };
        let Some(Convergence { steepness }) = converged else { return Ok(Collocated::Diverged) };
        self.has_velocities = false;
        self.complete(system, from.state, h);
        self.expand();
        self.end(from.state, h, to);
        let [error, dense_error] = self.errors(from, steepness);
        Ok(Collocated::Solved { error, dense_error, steepness })
    }

    /// The smallest pivot at the nodes of the step that was tried last; infinite where accelerations were not eliminated.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        self.nodes.smallest_pivot
    }

    /// The error of the end of the step that was tried last, over the tolerance, by the accelerations there. A force that changes between
    /// the last node and the end is seen by nothing else.
    pub(crate) fn error_by_end(&self, at_end: &[f64]) -> f64 {
        self.error.by_end(at_end)
    }

    /// Keeps the step that was tried last.
    pub(crate) fn accept(&mut self) {
        if let Some(tried_s) = self.tried_s.take() {
            std::mem::swap(&mut self.rest, &mut self.next_rest);
            std::mem::swap(&mut self.last, &mut self.coefficients);
            self.last_sizes = self.sizes;
            self.last_s = Some(tried_s);
            self.quasi.iter_mut().for_each(|quasi| quasi.accept(tried_s));
        }
    }

    fn begin<P: SceneRef>(&mut self, system: &System<P>, from: Node<'_>, h: f64, tolerance: Tolerance) {
        let Self { nodes, tried_s, weights, work_weights, .. } = self;
        nodes.begin(system);
        nodes.t = NODES.fused(Eight::from_f64(h), Eight::from_f64(from.state.t));
        *tried_s = Some(h);
        write_weights(from.state, h, tolerance, weights);
        let works = work_weights.iter_mut().zip(&from.state.work);
        works.for_each(|(weight, work)| *weight = h / (tolerance.absolute + tolerance.relative * work.abs()));
        self.n_parts = 0;
    }

    /// The first guess of the accelerations at the nodes.
    fn continue_accelerations(&mut self, from: Node<'_>, h: f64) {
        let Self { nodes, last, last_sizes, last_s, .. } = self;
        match last_s {
            Some(last_s) => {
                lanes::evaluate(last, useful_degree(last_sizes, h / *last_s), 1.0, h / *last_s, &mut nodes.a)
            }
            None => nodes.a.iter_mut().zip(from.a).for_each(|(nodes, a)| *nodes = Eight::from_f64(*a)),
        }
    }

    /// Sweeps until the accelerations at the nodes belong to the states there; none where they do not converge.
    fn sweep<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: &State,
        h: f64,
    ) -> Result<Option<Convergence>, MotionError> {
        let Self { nodes, feedback, before, weights, .. } = self;
        nodes.q.iter_mut().zip(&from.q).for_each(|(nodes, q)| *nodes = Eight::from_f64(*q));
        let mut sweeps = Sweeps::default();
        loop {
            lanes::integrate(h, &from.v, &nodes.a, &mut nodes.v);
            lanes::integrate_some(h, &from.q, &nodes.v, feedback, &mut nodes.q);
            std::mem::swap(before, &mut nodes.a);
            nodes.accelerate(system)?;
            let change = lanes::change(&nodes.a, before, weights);
            if let Some(ended) = sweeps.see(change, || lanes::size(&nodes.a, weights)) {
                return Ok(ended);
            }
        }
    }

    /// Velocities at the nodes, from the accelerations there.
    fn integrate_velocities(&mut self, from: &State, h: f64) {
        if !std::mem::replace(&mut self.has_velocities, true) {
            lanes::integrate(h, &from.v, &self.nodes.a, &mut self.nodes.v);
        }
    }

    /// Powers at the nodes, from the accelerations there.
    fn complete<P: SceneRef>(&mut self, system: &System<P>, from: &State, h: f64) {
        if self.power.is_empty() {
            return;
        }
        self.integrate_velocities(from, h);
        let Self { nodes, power, .. } = self;
        lanes::integrate(h, &from.q, &nodes.v, &mut nodes.q);
        nodes.powers(system, power);
    }

    /// Legendre coefficients of the slopes at the nodes.
    fn expand(&mut self) {
        self.sizes = lanes::coefficients_and_sizes(&self.nodes.a, &self.weights, &mut self.coefficients);
        lanes::coefficients(&self.power, &mut self.of_power);
    }

    /// The end of the step that was tried last.
    fn end(&mut self, from: &State, h: f64, to: &mut State) {
        let Self { coefficients, of_power, rest, next_rest, .. } = self;
        next_rest.copy_from(rest);
        for (i, Lanes([mean, slope, ..])) in coefficients.iter().enumerate() {
            let change = h * (from.v[i] + h * mean_of_integral(*mean, *slope));
            to.q[i] = compensated::add(from.q[i], change, &mut next_rest.q[i]);
            to.v[i] = compensated::add(from.v[i], h * mean, &mut next_rest.v[i]);
        }
        for (i, Lanes([mean, ..])) in of_power.iter().enumerate() {
            to.work[i] = compensated::add(from.work[i], h * mean, &mut next_rest.work[i]);
        }
        to.t = from.t + h;
    }

    /// Length of the first step: what changes a position or a velocity by a part of itself, or of one unit. A step that is too long costs a few
    /// sweeps.
    pub(crate) fn first_step(&self, from: Node<'_>, longest: f64) -> f64 {
        let State { q, v, .. } = from.state;
        let slopes = v.iter().zip(q).chain(from.a.iter().zip(v));
        let steepest = slopes.fold(0.0, |steepest: f64, (slope, x)| steepest.max(slope.abs() / (1.0 + x.abs())));
        (FIRST_CHANGE / steepest.max(FIRST_CHANGE)).min(longest)
    }

    /// Errors over the tolerance at the end of the step and within it, from the Legendre coefficients of the slopes.
    fn errors(&mut self, from: Node<'_>, steepness: f64) -> [f64; 2] {
        let Self { of_power, work_weights, coefficients, weights, sizes, error, .. } = self;
        let [error, next] = error.of_slopes(coefficients, weights, sizes, from.a, steepness);
        let of_works = match &of_power[..] {
            [] => 0.0,
            of_power => next_coefficient(&lanes::sizes(of_power, work_weights), f64::INFINITY).0,
        };
        [error, LARGEST_INTEGRAL * next.max(of_works)]
    }

    /// The state at `s` of the step that was tried last, from 0 to 1, not projected; its time is left alone.
    pub(crate) fn dense_at(&mut self, from: &State, s: f64, out: &mut State) {
        let h = self.tried_s.unwrap_or_default();
        self.integrate_velocities(from, h);
        let Self { nodes, power, .. } = self;
        interpolate(from, h, [&nodes.v, &nodes.a, power], s, out);
    }

    /// The same by the end of a step of their own for each of `n_parts` equal parts, whose polynomials have errors as many times smaller to the
    /// power 9; by the polynomial of the step where sweeps of a part fail. From then on [`Gauss::dense_at`] is not to be called.
    ///
    /// # Cost
    /// Once a step, a few sweeps for each part up to `s`.
    pub(crate) fn dense_in_parts<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: &State,
        n_parts: usize,
        tolerance: Tolerance,
        s: f64,
        out: &mut State,
    ) {
        let of_parts = s * n_parts as f64;
        let wanted = (of_parts as usize).min(n_parts - 1);
        let h = self.tried_s.unwrap_or_default() / n_parts as f64;
        while self.n_parts <= wanted {
            let i = self.n_parts;
            if i == self.parts.len() {
                let Self { nodes, power, .. } = self;
                let part = Part { start: from.clone(), a: nodes.a.clone(), v: nodes.v.clone(), power: power.clone() };
                self.parts.push(part);
            }
            let mut start = std::mem::replace(&mut self.parts[i].start, State::zero(0, 0));
            match self.parts[..i].last() {
                Some(before) => before.interpolate(h, 1.0, &mut start),
                None => start.copy_from(from),
            }
            start.t = from.t + i as f64 * h;
            self.nodes.t = NODES.fused(Eight::from_f64(h), Eight::from_f64(start.t));
            let length = 1.0 / n_parts as f64;
            let continue_polynomial = |gauss: &mut Self| {
                lanes::evaluate(&gauss.coefficients, N - 1, i as f64 * length, length, &mut gauss.nodes.a);
            };
            continue_polynomial(self);
            write_weights(&start, h, tolerance, &mut self.weights);
            // nodes of a part may be nearer to a singular position than those of the step
            if !matches!(self.sweep(system, &start, h), Ok(Some(_))) {
                continue_polynomial(self);
            }
            self.has_velocities = false;
            self.integrate_velocities(&start, h);
            self.complete(system, &start, h);
            let Self { nodes, power, parts, .. } = self;
            let part = &mut parts[i];
            part.start = start;
            part.a.copy_from_slice(&nodes.a);
            part.v.copy_from_slice(&nodes.v);
            part.power.copy_from_slice(power);
            self.n_parts += 1;
        }
        self.parts[wanted].interpolate(h, of_parts - wanted as f64, out);
    }
}

/// A part of a step, solved for by itself.
#[derive(Debug)]
struct Part {
    start: State,
    /// Slopes of v, of q and of the works at the nodes.
    a: Vec<Eight>,
    v: Vec<Eight>,
    power: Vec<Eight>,
}

impl Part {
    fn interpolate(&self, h: f64, s: f64, out: &mut State) {
        interpolate(&self.start, h, [&self.v, &self.a, &self.power], s, out);
    }
}

/// The state at `s` of a step of length `h` from `from`, by the slopes of q, v and the works at its nodes; the time is left alone.
fn interpolate(from: &State, h: f64, [v, a, power]: [&[Eight]; 3], s: f64, out: &mut State) {
    let weights = weights_up_to(s);
    let parts = [(&mut out.q, &from.q, v), (&mut out.v, &from.v, a), (&mut out.work, &from.work, power)];
    for (out, from, slopes) in parts {
        for ((out, from), slope) in out.iter_mut().zip(from).zip(slopes) {
            *out = from + h * lanes::sum(&weights, slope);
        }
    }
}

/// How much a change of an acceleration over a step of length `h` changes the state at its end, over the tolerance.
fn write_weights(from: &State, h: f64, tolerance: Tolerance, weights: &mut [f64]) {
    let n_q = weights.len();
    for (i, (weight, (q, v))) in weights.iter_mut().zip(from.q.iter().zip(&from.v)).enumerate() {
        let [of_q, of_v] = [tolerance.of(i, n_q, q.abs()), tolerance.of(n_q + i, n_q, v.abs())];
        *weight = h * (1.0 / of_v).max(h / of_q);
    }
}

/// The degree up to which Legendre coefficients of these sizes are worth continuing over a step so many times as long as their own: as long as
/// terms fall. Those of even or odd degree may be small by symmetry.
fn useful_degree(sizes: &[f64; N], length: f64) -> usize {
    let polynomials = legendre(1.0 + 2.0 * length);
    let term = |m: usize| sizes[m] * polynomials[m];
    let (mut best, mut least) = (0, f64::INFINITY);
    for m in 0..N {
        let of_two = term(m).max(if m + 1 < N { term(m + 1) } else { 0.0 });
        if of_two <= least {
            (best, least) = (m, of_two);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A puck on a spring: x'' = −k x.
        pub model Sprung {
            param k: N/m = 1;
            body puck { mass: 1, inertia: 1 }
            effect tie { force at puck(0, 0): (-k * puck.x, 0); }
            start here { puck at (1, 0) angle 0; at rest; }
            effect rough {
                param w: rad/m = 1;
                param rough: N = 1000;
                force at puck(0, 0): (rough * (sin(2 * w * puck.x) - 2 * sin(w * puck.x) * cos(w * puck.x)), 0);
            }
            scene swings { start here; until 1 s; with tie; }
            scene trembles { start here; until 1 s; with tie, rough; }
        }
    }

    /// A force that is zero but for rounding, which is 1e-16 of its terms, and a tolerance below that. With terms of 300 N it is less than 1e-12 of
    /// the acceleration of 1 m/s², with 30 kN more.
    #[test]
    fn analytic_changes_that_are_rounding_end_sweeps() {
        let solved = |rough: f64| {
            let scene = sprung::Trembles { rough, ..Default::default() };
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let mut gauss = Gauss::new(&scene, 0);
            let (mut from, a) = (State::zero(3, 0), [-1.0, 0.0, 0.0]);
            from.q[0] = 1.0;
            let (node, mut to) = (Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &[] }, from.clone());
            let tolerance = Tolerance::new(1e-17, 1e-17);
            let outcome = gauss.attempt(&mut system, node, 1.0, tolerance, &mut to).unwrap();
            matches!(outcome, Collocated::Solved { .. })
        };
        assert_eq!([300.0, 3e4].map(solved), [true, false]);
    }

    /// From x = 1 m at rest, in a step of 1 s with a tolerance of 1e-6: the outcome, and how many sweeps it took.
    fn swept(k: f64) -> (bool, u64) {
        let scene = sprung::Swings { k };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut gauss = Gauss::new(&scene, 0);
        let (mut from, a) = (State::zero(3, 0), [-k, 0.0, 0.0]);
        from.q[0] = 1.0;
        let (node, mut to) = (Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &[] }, from.clone());
        let outcome = gauss.attempt(&mut system, node, 1.0, Tolerance::new(1e-6, 1e-6), &mut to).unwrap();
        (matches!(outcome, Collocated::Solved { .. }), system.counters().evaluations / N as u64)
    }

    /// As Picard's iteration with these nodes in another program. At 7 rad/s changes grow in the first sweeps and in the end: after eight sweeps
    /// they may, and two rates above 0.9 in a row end it at the thirteenth.
    #[test]
    fn cross_sweeps_of_a_swing_end_where_they_have_converged_or_do_not() {
        let found = [1.0, 2.0, 4.0, 7.0_f64].map(|rate| swept(rate * rate));
        assert_eq!(found, [(true, 5), (true, 7), (true, 11), (false, 13)]);
    }

    /// Speeds of 2 m/s at 0 and of 3 m/s at 1 m, and an acceleration of 4 m/s² at 3 m/s: the first changes its number fastest, by a tenth of a
    /// unit in 0.05 s. From rest it is one second.
    #[test]
    fn analytic_first_step_changes_a_number_by_a_tenth() {
        let gauss = Gauss::new(&sprung::Swings::default(), 0);
        let first = |q: [f64; 3], v: [f64; 3], a: [f64; 3], longest: f64| {
            let mut from = State::zero(3, 0);
            from.q.copy_from_slice(&q);
            from.v.copy_from_slice(&v);
            gauss.first_step(Node { state: &from, q_rate: &from.v, a: &a, rate: &[], power: &[] }, longest)
        };
        let found = first([0.0, 1.0, 0.0], [2.0, 3.0, 0.0], [0.0, 4.0, 0.0], 10.0);
        assert!((found / 0.05 - 1.0).abs() <= ROUNDING_OF_SUMS, "{found}");
        assert_eq!([10.0, 0.5].map(|longest| first([0.0; 3], [0.0; 3], [0.0; 3], longest)), [1.0, 0.5]);
    }

    /// A change of an acceleration by 1 changes velocities by h and positions by h²: the larger one counts, over its own tolerance.
    #[test]
    fn analytic_weights_are_those_of_the_number_that_changes_most() {
        let mut from = State::zero(3, 0);
        (from.q[0], from.q[1], from.v[0], from.v[1]) = (9.0, 0.0, 0.0, 9.0);
        let tolerance = Tolerance { angle: Some(1e-9), ..Tolerance::new(1e-3, 1e-3) };
        let mut weights = [0.0; 3];
        write_weights(&from, 2.0, tolerance, &mut weights);
        // velocities of 0, 9, 0; positions of 9, 0 and an angle
        let expected = [2.0 / 1e-3, 4.0 / 1e-3, 4.0 / 1e-9];
        assert!(weights.iter().zip(expected).all(|(x, y)| (x / y - 1.0).abs() <= 1e-14), "{weights:?}");
    }

    /// Rounding of some twenty operations.
    const ROUNDING_OF_SUMS: f64 = 1e-14;
}
