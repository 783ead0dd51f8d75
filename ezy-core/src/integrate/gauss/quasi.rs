//! Sweeps in quasi-velocities: fewer numbers, and fewer operations for each.

use super::convergence::{Convergence, Sweeps};
use super::lanes;
use super::tableau::{N, TO_INTEGRALS};
use super::useful_degree;
use crate::archive::Archive;
use crate::dynamics::{EightStates, State, System};
use crate::integrate::Tolerance;
use crate::integrate::reduced::are_same;
use crate::model::coordinate::N_OF_BODY;
use crate::model::quasi_in_lanes::{EquationsInQuasiVelocities, Nodes, Start, Times};
use crate::model::{Derived as _, Eight, N_LANES, QuasiVelocitiesInfo, Scene, SceneRef};
use crate::scalar::Scalar;

/// Lanes at the start of a step: a column of R in each of the first, then v_t, then the velocities.
const DRIFT: usize = N_LANES - 2;
const SAME: usize = N_LANES - 1;

/// Quasi-velocities at the nodes, and the coordinates that they depend on.
#[derive(Debug)]
pub(super) struct QuasiSweeps {
    info: QuasiVelocitiesInfo,
    n_u: usize,
    /// At the start of the step: quasi-velocities, then those coordinates.
    start: Vec<f64>,
    /// The same at the nodes, and their slopes there: those of the present sweep, and of the sweep before.
    values: Vec<Eight>,
    slopes: Vec<Eight>,
    before: Vec<Eight>,
    /// Sines and angles of a sweep.
    turned: Vec<Eight>,
    /// What depends on the times of the nodes alone.
    of_time: Vec<Eight>,
    /// Change of a slope to change of the state over the tolerance.
    weights: Vec<f64>,
    /// Legendre coefficients of the slopes of the step that was tried last, and of the step before it.
    coefficients: Vec<Eight>,
    last: Vec<Eight>,
    /// Length of the step before, s; none where that was not made in quasi-velocities.
    last_s: Option<f64>,
    /// Whether the step that was tried last was made in quasi-velocities.
    is_tried: bool,
}

impl QuasiSweeps {
    /// `None` for a scene without such equations.
    pub(super) fn new<S: Scene + ?Sized>(scene: &S) -> Option<Self> {
        let info = scene.info().quasi_velocities.filter(|_| scene.in_quasi_velocities().is_some())?;
        let n_u = info.formulas.len();
        if n_u > DRIFT {
            return None;
        }
        let n = n_u + info.feedback.len();
        let zeros = || vec![Eight::from_f64(0.0); n];
        Some(Self {
            info,
            n_u,
            start: vec![0.0; n],
            values: zeros(),
            slopes: zeros(),
            before: zeros(),
            turned: vec![Eight::from_f64(0.0); 4 * info.n_angles],
            of_time: vec![Eight::from_f64(0.0); info.n_of_time],
            weights: vec![0.0; n],
            coefficients: zeros(),
            last: zeros(),
            last_s: None,
            is_tried: false,
        })
    }

    pub(super) fn restart(&mut self) {
        (self.last_s, self.is_tried) = (None, false);
    }

    /// Writes what the next step takes from the last one, or reads it.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        self.last.iter_mut().for_each(|lanes| archive.numbers(&mut lanes.0));
        archive.option(&mut self.last_s);
    }

    /// Keeps the step of this length that was tried last.
    pub(super) fn accept(&mut self, h: f64) {
        std::mem::swap(&mut self.last, &mut self.coefficients);
        self.last_s = std::mem::take(&mut self.is_tried).then_some(h);
    }

    /// Whether quasi-velocities of the start give back its velocities. They do not where those do not obey the rows, nor where a pivot vanishes that depends
    /// on parameters.
    ///
    /// Takes them for the start of the step, and sets the weights of slopes from those of accelerations; overwrites `q` and `v` of the nodes.
    fn start<P: SceneRef>(
        &mut self,
        equations: &dyn EquationsInQuasiVelocities,
        system: &System<P>,
        nodes: &mut EightStates,
        from: &State,
        weights: &[f64],
    ) -> bool {
        let Self { info, n_u, start, values, .. } = self;
        let (u, q) = start.split_at_mut(*n_u);
        equations.of_one().quasi_velocities(system.fixed(), &from.q, &from.v, u);
        q.iter_mut().zip(info.feedback).for_each(|(q, &i)| *q = from.q[i]);
        let values = &mut values[..*n_u];
        for (k, (value, u)) in values.iter_mut().zip(&*u).enumerate() {
            value.0 = [0.0; N_LANES];
            (value.0[k], value.0[SAME]) = (1.0, *u);
        }
        nodes.q.iter_mut().zip(&from.q).for_each(|(nodes, q)| *nodes = Eight::from_f64(*q));
        equations.velocities_in_lanes(&nodes.fixed, &Eight::from_f64(from.t), &nodes.q, values, &mut nodes.v);

        // a velocity along the axis of a body turns from x to y within the step: the stricter one counts
        for (k, of_u) in self.weights[..*n_u].iter_mut().enumerate() {
            let bodies = nodes.v.chunks_exact(N_OF_BODY).zip(weights.chunks_exact(N_OF_BODY));
            let changes = bodies.map(|(v, weights)| {
                let [x, y, omega] = std::array::from_fn(|i| v[i].0[k] - v[i].0[DRIFT]);
                let turned = (x * x + y * y).sqrt() * weights[0].max(weights[1]);
                turned.max(omega.abs() * weights[2])
            });
            *of_u = changes.fold(0.0, f64::max);
        }
        are_same(from.v.iter().copied(), nodes.v.iter().map(|v| v.0[SAME]))
    }

    /// Slopes for the first sweep of a step of length `h`: the polynomials of the step before, continued, or the slopes at the start.
    fn first_guess(
        &mut self,
        equations: &dyn EquationsInQuasiVelocities,
        nodes: &mut EightStates,
        from: &State,
        h: f64,
    ) {
        if let Some(last_s) = self.last_s {
            let sizes = lanes::sizes(&self.last, &self.weights);
            lanes::evaluate(&self.last, useful_degree(&sizes, h / last_s), 1.0, h / last_s, &mut self.slopes);
            return;
        }
        let Self { start, values, slopes, before, turned, of_time, weights, .. } = self;
        let EightStates { fixed, q, v, .. } = nodes;
        let t = Eight::from_f64(from.t);
        equations.values_of_time_in_lanes(fixed, &t, of_time);
        // a step of no length
        let of = Times { c: fixed, of_time, t: &t, h: 0.0, integrals: &TO_INTEGRALS };
        slopes.fill(Eight::from_f64(0.0));
        let (start, at) = (Start { values: start, q: &from.q }, Nodes { values, before, slopes, turned, q, v });
        equations.sweeps_in_lanes(of, start, weights, at, &mut |_, _| false);
    }

    /// Sweeps in quasi-velocities until slopes at the nodes belong to the values there, and writes `q` and `v` of the nodes. `None` where the step cannot be
    /// solved for in quasi-velocities; no convergence where sweeps do not converge.
    ///
    /// `weights` are those of accelerations.
    pub(super) fn sweep<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        nodes: &mut EightStates,
        from: &State,
        h: f64,
        tolerance: Tolerance,
        weights: &[f64],
    ) -> Option<Option<Convergence>> {
        self.is_tried = false;
        let equations = system.scene().in_quasi_velocities().filter(|_| EightStates::has_all_rows(system))?;
        if !self.start(equations, system, nodes, from, weights) {
            return None;
        }
        let n_q = from.q.len();
        for (of_q, &i) in self.weights[self.n_u..].iter_mut().zip(self.info.feedback) {
            *of_q = h / tolerance.of(i, n_q, from.q[i].abs());
        }
        self.first_guess(equations, nodes, from, h);
        equations.values_of_time_in_lanes(&nodes.fixed, &nodes.t, &mut self.of_time);

        let Self { start, values, slopes, before, turned, of_time, weights, .. } = self;
        let EightStates { fixed, t, q, v, .. } = nodes;
        let of = Times { c: fixed, of_time, t, h, integrals: &TO_INTEGRALS };
        let (start, at) = (Start { values: start, q: &from.q }, Nodes { values, before, slopes, turned, q, v });
        let (mut sweeps, mut converged) = (Sweeps::default(), None);
        equations.sweeps_in_lanes(of, start, weights, at, &mut |change, slopes| {
            let ended = sweeps.see(change, || lanes::size(slopes, weights));
            let goes_on = ended.is_none();
            converged = ended.flatten();
            goes_on
        });
        lanes::coefficients(&self.slopes, &mut self.coefficients);
        self.is_tried = true;
        system.counters().evaluations += N as u64 * u64::from(sweeps.n());
        Some(converged)
    }
}

#[cfg(test)]
mod tests {
    use crate::archive::Archive;
    use crate::dynamics::system_of;
    use crate::dynamics::{Metric, Projection, State, System};
    use crate::integrate::gauss::{Collocated, Gauss};
    use crate::integrate::{Node, Tolerance};
    use crate::linalg::Backend;
    use crate::machine::narrow::assert_same_on_each_processor;
    use crate::model::Scene;

    crate::model! {
        /// Two bodies on a skate each, hinged, with a torque between them: the roller racer.
        pub model Racer {
            param front: m = 0.1;
            body seat { mass: 46, inertia: 10 }
            body bar { mass: 1, inertia: 0.005 }
            hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
            skate rear: at seat(-0.2, 0) along seat(1, 0);
            skate ahead: at bar(front, 0) along bar(1, 0);
            torque seat ~ bar: (2 N*m) * cos(pi * (t / (1 s)));
            start folded { seat at (0, 0) angle 0; bar angle 2; seat velocity (1, _); }
            scene rides { start folded; until 1 s; }
        }
    }

    /// Length of the step, s, and its tolerance.
    const H: f64 = 0.05;
    const TOLERANCE: Tolerance = Tolerance::new(1e-13, 1e-13);

    /// Steps of one scene.
    struct Steps<'s> {
        system: System<&'s dyn Scene>,
        gauss: Gauss,
        state: State,
    }

    impl<'s> Steps<'s> {
        /// Velocities at the start are those that rows give, with this change of the first one.
        fn new(scene: &'s racer::Rides, change: f64, in_quasi_velocities: bool) -> Self {
            let mut system = system_of(scene, Backend::Auto).unwrap();
            let given = system.scene_start();
            let mut state = system.consistent_start(&given).unwrap();
            state.v[0] += change;
            let mut gauss = Gauss::new(scene, 0);
            if !in_quasi_velocities {
                gauss.quasi = None;
            }
            Self { system, gauss, state }
        }

        /// The end of a step from the present state.
        fn tried(&mut self, h: f64) -> State {
            let Self { system, gauss, state, .. } = self;
            let [mut a, mut lambda] = [vec![0.0; state.v.len()], vec![0.0; 4]];
            system.accelerations(state.t, &state.q, &state.v, &mut a, &mut lambda).unwrap();
            let node = Node { state, q_rate: &state.v, a: &a, rate: &[], power: &[] };
            let mut to = state.clone();
            let outcome = gauss.attempt(system, node, h, TOLERANCE, &mut to).unwrap();
            assert!(matches!(outcome, Collocated::Solved { .. }), "{outcome:?}");
            to
        }

        /// Takes the step, with both projections.
        fn take(&mut self, h: f64) {
            self.state = self.tried(h);
            self.gauss.accept();
            let State { t, q, v, .. } = &mut self.state;
            self.system.project(*t, q, v, Projection::Both, Metric::Mass).unwrap();
        }
    }

    /// The end of a first step in quasi-velocities, if they are to be used, and how often rows were eliminated for it.
    fn end(front: f64, change: f64, in_quasi_velocities: bool) -> (State, u64) {
        let scene = racer::Rides { front };
        let mut steps = Steps::new(&scene, change, in_quasi_velocities);
        let before = steps.system.counters().factorizations;
        let to = steps.tried(H);
        // but for the accelerations at the start
        (to, steps.system.counters().factorizations - before - 1)
    }

    fn assert_close(one: &State, other: &State, tolerance: f64) {
        for (x, y) in one.q.iter().chain(&one.v).zip(other.q.iter().chain(&other.v)) {
            assert!((x - y).abs() <= tolerance, "{x} {y}");
        }
    }

    /// A step begins with what the one before leaves, one that was taken back leaves nothing, and a restart forgets. The motion amplifies errors
    /// of each by less than ten.
    #[test]
    fn cross_steps_one_after_the_other_are_those_of_rows() {
        let scene = racer::Rides { front: 0.1 };
        let [of_rows, of_these] = [false, true].map(|these| {
            let mut steps = Steps::new(&scene, 0.0, these);
            steps.take(H);
            steps.take(0.7 * H);
            let _ = steps.tried(2.0 * H);
            steps.take(1.3 * H);
            steps.gauss.restart();
            steps.take(H);
            steps.state
        });
        assert_close(&of_rows, &of_these, 4.0 * 10.0 * 10.0 * TOLERANCE.absolute);
    }

    #[test]
    fn invariant_steps_go_on_from_an_archive_with_the_same_bits() {
        let scene = racer::Rides { front: 0.1 };
        let mut steps = Steps::new(&scene, 0.0, true);
        steps.take(H);
        steps.take(H);
        let mut archive = Archive::new();
        steps.gauss.remember(&mut archive);
        let (numbers, scalars) = archive.into_parts();
        let mut others = Steps::new(&scene, 0.0, true);
        others.state = steps.state.clone();
        let mut archive = Archive::of(numbers, scalars);
        others.gauss.remember(&mut archive);
        assert!(archive.is_read_whole());
        assert_eq!(steps.tried(H), others.tried(H));
    }

    /// Coordinates move once more in each sweep. Those of rows take 54, these 35; without that second move they took 51.
    #[test]
    fn cross_steps_in_quasi_velocities_take_fewer_sweeps_than_those_of_rows() {
        let scene = racer::Rides { front: 0.1 };
        let [of_rows, of_these] = [false, true].map(|these| {
            let mut steps = Steps::new(&scene, 0.0, these);
            (0..4).for_each(|_| steps.take(4.0 * H));
            steps.system.counters().evaluations
        });
        assert!(4 * of_these <= 3 * of_rows, "{of_these} {of_rows}");
    }

    /// Sweeps leave a tenth of the tolerance, and the order of the method the rest.
    #[test]
    fn cross_steps_in_quasi_velocities_are_those_of_rows() {
        let [(of_rows, n_rows), (of_these, n_these)] = [false, true].map(|these| end(0.1, 0.0, these));
        assert_close(&of_rows, &of_these, 10.0 * TOLERANCE.absolute);
        // once, at the end of the sweeps
        assert!(n_these == 1 && n_rows > 5, "{n_these} {n_rows}");
    }

    #[test]
    fn invariant_steps_on_each_processor_have_the_same_bits() {
        for in_quasi_velocities in [false, true] {
            assert_same_on_each_processor(|| end(0.1, 0.0, in_quasi_velocities));
        }
    }

    /// The front wheel at the hinge says nothing of how the bar turns.
    #[test]
    fn invariant_steps_with_a_vanishing_pivot_are_those_of_rows() {
        assert_eq!(end(-0.1, 0.0, true), end(-0.1, 0.0, false));
    }

    /// Quasi-velocities cannot say that a wheel slips, however little.
    #[test]
    fn invariant_steps_from_velocities_off_the_rows_are_those_of_rows() {
        for change in [1e-3, 5e-12] {
            assert_eq!(end(0.1, change, true), end(0.1, change, false), "{change}");
        }
    }
}
