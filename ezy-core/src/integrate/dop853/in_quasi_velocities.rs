//! DOP853 of eight runs of a scene in quasi-velocities.

use super::tableau::{AT_END, N_STAGES, N_SUMS, NODES, STAGES};
use super::{ERROR_ORDER, first_length};
use crate::dynamics::{MotionError, State};
use crate::integrate::reduced::{Numbers, are_same};
use crate::integrate::step_control::StepControl;
use crate::integrate::step_limit::{StepLimit, is_too_short, limited_step};
use crate::integrate::{Tolerance, compensated};
use crate::model::quasi_in_lanes::{AtStage, EquationsInQuasiVelocities, Stages};
use crate::model::{Derived as _, Eight, N_LANES, Scene as _, SceneInfo, SceneRef};
use crate::scalar::{Scalar, in_widest};
use std::sync::Arc;

/// Eight runs of a scene, one a lane, with steps that they share. What is integrated are quasi-velocities and those coordinates that no position constraint gives, with those that
/// the motion depends on; after each step the others are computed from these, and all velocities: they obey the rows without a projection.
pub(crate) struct InQuasiVelocities<P> {
    scene: P,
    info: Arc<SceneInfo>,
    /// Inputs, then constants.
    fixed: Vec<Eight>,
    numbers: Numbers,
    control: StepControl,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    t: f64,
    /// Steps so far, and the sums of their errors over the tolerance.
    n_steps: u64,
    errors: Eight,
    /// The present state, and one that is tried: q and v, and u with the coordinates that are integrated.
    now: End,
    next: End,
    /// The end of a step with the error that it may have.
    off: End,
    /// Numbers at a stage.
    values: Vec<Eight>,
    q: Vec<Eight>,
    /// Slopes of all stages, those of the start first.
    slopes: Vec<Eight>,
    /// Whether those of the start are known.
    is_begun: bool,
}

/// One end of a step: the numbers that are integrated, and the whole state.
struct End {
    numbers: Vec<Eight>,
    /// What rounding cut off the numbers.
    rest: Vec<Eight>,
    q: Vec<Eight>,
    v: Vec<Eight>,
}

impl<P: SceneRef> InQuasiVelocities<P> {
    /// Runs from a state that obeys the rows, with `fixed` as what the kernels read as `c`. `None` for a scene without such equations, and where u does not give back these
    /// velocities.
    pub(crate) fn new(scene: P, fixed: &[Eight], start: &State<Eight>, tolerance: Tolerance) -> Option<Self> {
        let of_scene = scene.info();
        let info = of_scene.quasi_velocities?;
        let equations = scene.in_quasi_velocities()?;
        let State { t, q, v, .. } = start;
        let zeros = |n: usize| vec![Eight::from_f64(0.0); n];
        let (n_u, n) = (info.formulas.len(), info.formulas.len() + info.integrated.len());
        let zero = || End { numbers: zeros(n), rest: zeros(n), q: zeros(q.len()), v: zeros(v.len()) };
        let mut now = End { q: q.clone(), ..zero() };
        let (mut of_lane, mut u) = ([fixed, q, v].map(|x| vec![0.0; x.len()]), vec![0.0; n_u]);
        for lane in 0..N_LANES {
            for (of_lane, of_all) in of_lane.iter_mut().zip([fixed, q, v]) {
                of_lane.iter_mut().zip(of_all).for_each(|(x, all)| *x = all.0[lane]);
            }
            let [fixed, q, v] = &of_lane;
            equations.of_one().quasi_velocities(fixed, q, v, &mut u);
            now.numbers.iter_mut().zip(&u).for_each(|(number, u)| number.0[lane] = *u);
        }
        for (number, &i) in now.numbers[n_u..].iter_mut().zip(info.integrated) {
            *number = q[i];
        }
        equations.velocities_in_lanes(fixed, &Eight::from_f64(*t), q, &now.numbers[..n_u], &mut now.v);
        let is_same = (0..N_LANES).all(|lane| are_same(v.iter().map(|v| v.0[lane]), now.v.iter().map(|v| v.0[lane])));
        is_same.then(|| Self {
            scene,
            info: of_scene,
            fixed: fixed.to_vec(),
            numbers: Numbers { n_u, integrated: info.integrated, n_q: q.len(), tolerance },
            control: StepControl::new(ERROR_ORDER),
            step_s: None,
            t: *t,
            n_steps: 0,
            errors: Eight::from_f64(0.0),
            now,
            next: zero(),
            off: zero(),
            values: zeros(n),
            q: zeros(q.len()),
            slopes: zeros(N_STAGES * n),
            is_begun: false,
        })
    }

    /// Present time, s.
    pub(crate) fn time(&self) -> f64 {
        self.t
    }

    /// How many steps a run would have taken so far, but for a factor that all runs share, if it had chosen them alone: errors go with the eighth power of the step.
    pub(crate) fn n_steps_of_its_own(&self, lane: usize) -> f64 {
        let n = self.n_steps as f64;
        n * (self.errors.0[lane] / n).powf(1.0 / f64::from(ERROR_ORDER))
    }

    /// Present coordinates and velocities.
    pub(crate) fn state(&self) -> [&[Eight]; 2] {
        [&self.now.q, &self.now.v]
    }

    /// A step towards `end`, whose length the error decides; after an error the state is the last good one.
    ///
    /// # Errors
    /// [`MotionError::StepCollapsed`] where no step is short enough, and [`MotionError::AngleUnresolved`].
    pub(crate) fn step(&mut self, end: f64) -> Result<(), MotionError> {
        let t = self.t;
        let left = end - t;
        if !std::mem::replace(&mut self.is_begun, true) {
            self.stages(t, 0.0, 0, 1);
        }
        let mut length = match self.step_s {
            Some(step_s) => step_s,
            None => self.first_step(left),
        };
        loop {
            let StepLimit { step_s: h, t_next, .. } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            let errors = self.attempt(h, t_next);
            let error = errors.magnitude();
            if error <= 1.0 {
                self.numbers.tolerance.check_angles(&self.info, t_next, &self.next.q)?;
                self.t = t_next;
                self.n_steps += 1;
                self.errors = self.errors + errors;
                std::mem::swap(&mut self.now, &mut self.next);
                self.is_begun = false;
                self.step_s = Some(h * self.control.accept(error));
                return Ok(());
            }
            length = h * self.control.reject(error);
        }
    }

    /// Slopes of these stages of a step from the present state.
    fn stages(&mut self, t: f64, h: f64, first: usize, end: usize) {
        let Self { scene, fixed, now, values, q, slopes, .. } = self;
        let of = Stages { c: fixed, t, h, nodes: &NODES, weights: &STAGES, first, end };
        equations(scene).stages_in_lanes(of, &now.numbers, AtStage { values, q }, slopes);
    }

    /// Length of the first step.
    fn first_step(&mut self, longest: f64) -> f64 {
        let n = self.now.numbers.len();
        let (numbers, start) = (self.numbers, self.now.numbers.clone());
        let norm = |x: &[Eight]| {
            let squares = x.iter().zip(&start).enumerate().map(|(i, (&x, y))| {
                let x = x / numbers.scale(i, y.abs());
                x * x
            });
            let sum = squares.fold(Eight::from_f64(0.0), |sum, square| sum + square);
            (sum / Eight::from_f64(n as f64)).sqrt().magnitude()
        };
        let first = self.slopes[..n].to_vec();
        let t = self.t;
        let Ok(length) = first_length(longest, norm(&start), norm(&first), |guess| {
            const EULER: [&[(usize, f64)]; 2] = [&[], &[(0, 1.0)]];
            let Self { scene, fixed, now, values, q, slopes, .. } = self;
            let of = Stages { c: fixed, t, h: guess, nodes: &[0.0, 1.0], weights: &EULER, first: 1, end: 2 };
            equations(scene).stages_in_lanes(of, &now.numbers, AtStage { values, q }, slopes);
            let change: Vec<Eight> = slopes[n..2 * n].iter().zip(&first).map(|(&b, &a)| b - a).collect();
            Ok::<f64, std::convert::Infallible>(norm(&change))
        });
        length
    }

    /// Attempts a step of length `h`; the error over the tolerance of each run.
    fn attempt(&mut self, h: f64, t_next: f64) -> Eight {
        self.stages(self.t, h, 1, N_STAGES);
        let Self { scene, fixed, numbers, now, next, off, slopes, q: given, .. } = self;
        let equations = equations(scene);
        let mut shares = [Eight::from_f64(0.0); 3];
        in_widest(
            #[inline(always)]
            || {
                let n = now.numbers.len();
                next.rest.copy_from_slice(&now.rest);
                let length = Eight::from_f64(h);
                for i in 0..n {
                    let [step, five, three, six] = sums(&slopes[i..], n);
                    let end = compensated::add(now.numbers[i], length * step, &mut next.rest[i]);
                    next.numbers[i] = end;
                    off.numbers[i] = end + length * five;
                    numbers.add(i, [now.numbers[i], end], [five, three, six], &mut shares);
                }
            },
        );
        for end in [&mut *next, &mut *off] {
            expand(equations, fixed, t_next, *numbers, given, end);
        }
        let ends = [now, next, off].map(|end| [&end.q[..], &end.v]);
        let mut error = Eight::from_f64(0.0);
        in_widest(
            #[inline(always)]
            || error = numbers.error(h, shares, ends),
        );
        error
    }
}

/// What a scene has that was asked for them before.
fn equations<P: SceneRef>(scene: &P) -> &dyn EquationsInQuasiVelocities {
    scene.in_quasi_velocities().expect("who makes this has asked")
}

/// All coordinates and velocities from the numbers that are integrated, which get those coordinates that position constraints give.
fn expand(
    equations: &dyn EquationsInQuasiVelocities,
    fixed: &[Eight],
    t: f64,
    Numbers { n_u, integrated, .. }: Numbers,
    given: &mut [Eight],
    End { numbers, q, v, .. }: &mut End,
) {
    let t = Eight::from_f64(t);
    for (&i, number) in integrated.iter().zip(&numbers[n_u..]) {
        given[i] = *number;
    }
    equations.whole_state_in_lanes(fixed, &t, given, &numbers[..n_u], q, v);
    for (&i, number) in integrated.iter().zip(&mut numbers[n_u..]) {
        *number = q[i];
    }
}

/// The step of a number over its length, and its errors of orders 5 and 3 and the sixth difference; slopes of stages are `n` long.
#[inline(always)]
fn sums(slopes: &[Eight], n: usize) -> [Eight; N_SUMS] {
    let mut sums = [Eight::from_f64(0.0); N_SUMS];
    for (stage, weights) in AT_END {
        let slope = slopes[stage * n];
        for k in 0..N_SUMS {
            sums[k] = sums[k] + Eight::from_f64(weights[k]) * slope;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::{System, system_of};
    use crate::linalg::Backend;
    use crate::machine::narrow::assert_same_on_each_processor;
    use crate::model::{Equations as _, Scene};
    use crate::scalar::packed;
    use std::array::from_fn;

    crate::model! {
        /// A roller racer with a box that is welded to its seat, and a wheel that turns as a motor says: its place is read by a spring.
        pub model Racer {
            param front: m = 0.1;
            param m0: N*m = 2;
            body seat { mass: 46, inertia: 10 }
            body bar { mass: 1, inertia: 0.005 }
            body cargo { mass: 2, inertia: 0.1 }
            body wheel { mass: 0.5, inertia: 0.02 }
            hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
            weld lid: seat(-0.1, 0.2) ~ cargo(0, 0.1) angle 0.3;
            hinge axle: seat(0, -0.3) ~ wheel(0, 0.05);
            drive spin: wheel.phi = 0.2 * sin(2 * (t / (1 s)));
            skate rear: at seat(-0.2, 0) along seat(1, 0);
            skate ahead: at bar(front, 0) along bar(1, 0);
            torque seat ~ bar: m0 * cos(pi * (t / (1 s)));
            force at wheel(0, 0): (-(3 N/m) * wheel.x, 0);
            start folded { seat at (0, 0) angle 0; bar angle 2; seat velocity (1, _); }
            scene rides { start folded; until 1 s; }
        }
    }

    const TOLERANCE: Tolerance = Tolerance::new(1e-10, 1e-10);

    /// Runs of racers whose torques and front wheels differ, from velocities that are off the rows by `change`.
    fn runs(scenes: &[racer::Rides; N_LANES], change: f64) -> Option<InQuasiVelocities<&dyn Scene>> {
        runs_from(scenes, 2.0, change)
    }

    /// The same with the bar at this angle, rad.
    fn runs_from(scenes: &[racer::Rides; N_LANES], angle: f64, change: f64) -> Option<InQuasiVelocities<&dyn Scene>> {
        let mut systems: [System<&dyn Scene>; N_LANES] =
            scenes.each_ref().map(|scene| system_of(scene as &dyn Scene, Backend::Auto).unwrap());
        let starts = systems.each_mut().map(|system| {
            let mut start = system.scene_start();
            start.give_position(5, angle);
            let mut start = system.consistent_start(&start).unwrap();
            start.v[0] += change;
            start
        });
        let fixed = packed(from_fn(|lane| systems[lane].fixed()));
        let [q, v] = [packed(from_fn(|lane| &starts[lane].q[..])), packed(from_fn(|lane| &starts[lane].v[..]))];
        let start = State { t: 0.0, q, v, z: Vec::new(), work: Vec::new() };
        InQuasiVelocities::new(&scenes[0], &fixed, &start, TOLERANCE)
    }

    fn scenes() -> [racer::Rides; N_LANES] {
        from_fn(|lane| racer::Rides { front: 0.1 + 0.01 * lane as f64, m0: 2.0 - 0.1 * lane as f64 })
    }

    /// The state at the end of a second, and the number of steps.
    fn end(scenes: &[racer::Rides; N_LANES]) -> ([Vec<Eight>; 2], u32) {
        let mut runs = runs(scenes, 0.0).unwrap();
        let mut n_steps = 0;
        while runs.time() < 1.0 {
            runs.step(1.0).unwrap();
            n_steps += 1;
        }
        (runs.state().map(<[Eight]>::to_vec), n_steps)
    }

    /// Each of some ten steps is off by the tolerance, and the motion amplifies that by less than ten in a second.
    #[test]
    fn cross_runs_in_quasi_velocities_are_those_of_rows() {
        let scenes = scenes();
        let ([q, v], n_steps) = end(&scenes);
        assert!((5..60).contains(&n_steps), "{n_steps}");
        for (lane, scene) in scenes.iter().enumerate() {
            let run = crate::simulate::Simulation::new(scene).method(crate::integrate::Method::dop853(1e-12));
            let run = run.until(1.0).run().unwrap();
            let alone = run.last();
            let pairs = alone.coordinates.iter().zip(&q).chain(alone.velocities.iter().zip(&v));
            for (x, y) in pairs {
                assert!((x - y.0[lane]).abs() <= 100.0 * TOLERANCE.absolute, "{lane}: {x} {}", y.0[lane]);
            }
        }
    }

    /// Sums of a handful of terms below four.
    #[test]
    fn invariant_states_obey_the_rows_to_rounding() {
        const ROUNDING: f64 = 16.0 * 4.0 * f64::EPSILON;
        let scenes = scenes();
        let mut runs = runs(&scenes, 0.0).unwrap();
        let info = scenes[0].info();
        while runs.time() < 1.0 {
            runs.step(1.0).unwrap();
            let (t, [q, v]) = (runs.time(), runs.state());
            let mut of_positions = vec![Eight::from_f64(0.0); info.n_position_rows];
            let mut of_velocities = vec![Eight::from_f64(0.0); info.n_rows()];
            scenes[0].position_constraint(&runs.fixed, Eight::from_f64(t), q, &mut of_positions);
            scenes[0].velocity_constraint(&runs.fixed, Eight::from_f64(t), q, v, &mut of_velocities);
            for residual in of_positions.iter().chain(&of_velocities) {
                assert!(residual.magnitude() <= ROUNDING, "{residual:?} at {t} s");
            }
        }
    }

    #[test]
    fn invariant_runs_on_each_processor_have_the_same_bits() {
        let scenes = scenes();
        assert_same_on_each_processor(|| end(&scenes));
    }

    /// A front wheel at the hinge says nothing of how the bar turns; and quasi-velocities cannot say that a wheel slips, however little, in any lane.
    #[test]
    fn invariant_runs_that_quasi_velocities_do_not_describe_are_left_to_the_rows() {
        assert!(runs(&scenes(), 0.0).is_some());
        assert!(runs(&scenes(), 5e-12).is_none());
        let mut one = scenes();
        one[5].front = -0.1;
        assert!(runs(&one, 0.0).is_none());
    }

    /// Doubles near 1e9 rad are 1.2e-7 rad apart.
    #[test]
    fn invariant_angle_beyond_its_tolerance_ends_runs_before_the_step() {
        let scenes = scenes();
        let mut runs = runs_from(&scenes, 1e9, 0.0).unwrap();
        runs.numbers.tolerance = Tolerance { angle: Some(1e-8), ..Tolerance::new(1e-2, 1e-2) };
        let error = runs.step(1.0).unwrap_err();
        assert!(matches!(&error, MotionError::AngleUnresolved { name, .. } if *name == "bar.phi"), "{error}");
        assert_eq!(runs.time(), 0.0);
    }

    /// An angle has the tolerance that is given for angles: with a coarse one steps are longer, and with one as small as the others as long.
    #[test]
    fn invariant_steps_keep_to_the_tolerance_of_angles() {
        let scenes = scenes();
        let n_steps = |angle: Option<f64>| {
            let mut runs = runs(&scenes, 0.0).unwrap();
            runs.numbers.tolerance = Tolerance { angle, ..TOLERANCE };
            let mut n = 0;
            while runs.time() < 1.0 {
                runs.step(1.0).unwrap();
                n += 1;
            }
            n
        };
        let [fine, same, none] = [Some(1e-13), Some(1e-10), None].map(n_steps);
        assert!(fine > none && same >= none, "{fine} {same} {none}");
    }
}
