//! Exact derivatives of motions, rows and outputs, by two other routes: the Jacobians that the macro derives, and differences.

use ezy_core::dynamics::{By, Gradients, Of, OperatingPoint, SystemError};
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::model::{Derived, Equations, EquationsWithDerivatives, ModelInfo, Scene, SceneInfo, Start};
use ezy_core::prelude::System;
use ezy_core::scalar::Scalar;
use ezy_models::registry::MODELS;
use ezy_tests::crank::Crank;
use ezy_tests::fuzz::draw::Draw;
use ezy_tests::top::Top;
use ezy_tests::{piloted, random_models, shapes};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

model! {
    /// Everything that a scene can depend on: a moving row, a mass with a parameter, inputs, an integrated one, a first-order state.
    pub model Gantry {
        param m: kg = 1.5;
        param l: m = 0.4;
        param k = 3;
        input angle: rad = 0.2 by acceleration;
        input wind: N = 0.7;
        state current = 0.3 rate wind - k * current * arm.omega;
        body arm { mass: 2, inertia: 0.4 }
        body bob { mass: m, inertia: m * l^2 }
        hinge pin: arm(-0.3, 0) ~ ground(0, 0);
        hinge joint: arm(0.3, 0) ~ bob(0, l);
        gravity (0, -9.81);
        force at bob(0, 0): (wind * current, -k * norm(bob.v));
        output place: cm = angle * bob.x;
        output heat = k * current^2 * bob.omega;
        drive turning: arm.phi = angle + 0.1 * sin(k * t);
        start hanging { arm angle 0.2; bob angle 0.1; bob rate 0; }
        scene steered { start hanging; until 2 s; }
    }
}

/// Random states of each scene.
const N_STATES: u64 = 4;

/// Both routes sum the same terms in another order: a handful of roundings of the largest.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Shortest step of the differences, relative to what is varied where that is above one.
pub(super) const STEP: f64 = 6e-6;

/// The differences are of fourth order at steps of one and two, extrapolated: (4/3 + 1/6) ε/step of what is differentiated, and as
/// much for each of a few terms that cancel in it.
const DIFFERENCES: f64 = 8.0 * 1.5 * f64::EPSILON / STEP;

/// Least share of the comparisons in which the truncation is below the rounding, so that the differences are sharp.
const SHARP: f64 = 0.9;

/// A state off the rows: the equations hold everywhere.
struct Case {
    c: Vec<f64>,
    parameters: Vec<f64>,
    t: f64,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl Case {
    fn random(scene: &dyn Scene, system: &System<&dyn Scene>, i: u64) -> Self {
        let info = scene.info();
        let mut draw = Draw::new(62, i);
        let mut numbers = |n: usize, size: f64| (0..n).map(|_| draw.between(-size, size)).collect::<Vec<_>>();
        let mut c = system.fixed().to_vec();
        let first: Vec<f64> = numbers(info.n_inputs() + info.n_states(), 1.0);
        c.iter_mut().zip(first).for_each(|(c, moved)| *c += moved);
        Self {
            c,
            parameters: scene.parameters(),
            t: 0.5 * info.until_s * (1.0 + numbers(1, 1.0)[0]),
            q: numbers(info.n_coordinates(), 2.0),
            v: numbers(info.n_velocities(), 2.0),
            a: numbers(info.n_velocities(), 2.0),
            lambda: numbers(info.n_rows(), 2.0),
        }
    }

    fn point(&self) -> OperatingPoint<'_> {
        let Self { c, t, q, v, a, lambda, .. } = self;
        OperatingPoint { fixed: c, t: *t, q, v, accelerations: a, multipliers: lambda }
    }

    /// Number `i` of those by which is differentiated.
    fn varied(&mut self, info: &SceneInfo, by: By, i: usize) -> &mut f64 {
        match by {
            By::Positions => &mut self.q[i],
            By::Velocities => &mut self.v[i],
            By::Inputs => &mut self.c[i],
            By::States => &mut self.c[info.n_inputs() + i],
            By::Parameters => &mut self.parameters[i],
        }
    }

    /// What is differentiated, in `f64`, and the size of its largest term.
    fn value(&mut self, scene: &dyn Scene, of: Of) -> (Vec<f64>, f64) {
        let info = scene.info();
        scene.constants(&self.parameters, &mut self.c);
        let Self { c, t, q, v, a, lambda, .. } = self;
        let (n_v, n_c) = (info.n_velocities(), info.n_rows());
        let zeros = |n: usize| vec![0.0; n];
        let mut out = zeros(match of {
            Of::PositionRows => info.n_position_rows,
            Of::VelocityRows => n_c,
            Of::Motion => n_v + n_c + info.n_states(),
            Of::Outputs => info.n_outputs(),
        });
        let mut g = zeros(info.jacobian.n_nonzeros());
        scene.velocity_jacobian(c, *t, q, &mut g);
        let mut size = largest(&g) * (1.0 + largest(v));
        match of {
            Of::PositionRows => scene.position_constraint(c, *t, q, &mut out),
            Of::VelocityRows => scene.velocity_constraint(c, *t, q, v, &mut out),
            Of::Outputs => scene.outputs(c, *t, q, v, &mut out),
            Of::Motion => {
                let mut m = zeros(n_v);
                scene.mass_matrix(c, &mut m);
                let (force, rest) = out.split_at_mut(n_v);
                let (rows, rates) = rest.split_at_mut(n_c);
                scene.applied_force(c, *t, q, v, force);
                scene.convective_term(c, *t, q, v, rows);
                scene.state_rates(c, *t, q, v, rates);
                size = size.max(largest(&m) * largest(a)).max(largest(force)).max(largest(rows));
                size = size.max(largest(&g) * (largest(a) + largest(lambda)));
                force.iter_mut().zip(m.iter().zip(&*a)).for_each(|(force, (m, a))| *force -= m * a);
                rows.iter_mut().for_each(|row| *row = -*row);
                for (k, row, column) in info.jacobian.entries() {
                    force[column] -= g[k] * lambda[row];
                    rows[row] -= g[k] * a[column];
                }
            }
        }
        size = size.max(largest(&out));
        (out, size)
    }
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m: f64, x| if x.abs() > m || x.is_nan() { x.abs() } else { m })
}

fn scenes(models: &[&ModelInfo]) -> Vec<Box<dyn Scene>> {
    models.iter().flat_map(|model| model.scenes).map(|entry| (entry.new)()).collect()
}

/// Those of the garage, of every other shape, and of a body in space.
pub(super) fn all() -> Vec<Box<dyn Scene>> {
    let models = [MODELS, &shapes::MODELS, &random_models::MODELS, &[&piloted::piloted::MODEL, &gantry::MODEL]];
    let top = Top {
        inertia: [0.2, 0.3, 0.4],
        pin: Some([0.1, -0.2, 0.3]),
        gravity: 9.81,
        start: ([1.0, 0.0, 0.0, 0.0], [0.0; 3]),
    };
    models.into_iter().flat_map(scenes).chain([Box::new(top) as Box<dyn Scene>]).collect()
}

pub(super) fn name(scene: &dyn Scene) -> String {
    format!("{}/{}", scene.info().model, scene.info().name)
}

#[test]
fn cross_gradients_of_the_motion_are_the_generated_jacobians() {
    let mut worst = 0.0_f64;
    let mut n_compared = 0;
    for scene in &all() {
        let (scene, info) = (&**scene, scene.info());
        let Some(places) = scene.jacobian_places() else { continue };
        let places_by_z = scene.state_jacobian_places();
        let system = System::new(scene, Backend::Auto).unwrap();
        let mut gradients = Gradients::new(&system).unwrap();
        for i in 0..N_STATES {
            let mut case = Case::random(scene, &system, i);
            let (_, size) = case.value(scene, Of::Motion);
            let Case { c, t, q, v, a, lambda, .. } = &case;
            let [mut by_q, mut by_v, mut by_z] =
                [&places.by_q, &places.by_v, &places_by_z].map(|of| vec![0.0; of.len()]);
            scene.jacobians(c, *t, q, v, a, lambda, &mut by_q, &mut by_v);
            scene.state_jacobians(c, *t, q, v, &mut by_z);
            for (by, places, entries) in [
                (By::Positions, &places.by_q, &by_q),
                (By::Velocities, &places.by_v, &by_v),
                (By::States, &places_by_z, &by_z),
            ] {
                let n = info.n_unknowns() + info.n_states();
                let (mut expected, mut terms) = (vec![0.0; gradients.n_entries(Of::Motion, by)], size);
                let mut found = expected.clone();
                for (&(row, column), entry) in places.iter().zip(entries) {
                    expected[column * n + row] += entry;
                    terms = terms.max(entry.abs());
                }
                gradients.write(&case.point(), Of::Motion, by, &mut found);
                for (place, (found, expected)) in found.iter().zip(&expected).enumerate() {
                    let error = (found - expected).abs() / terms.max(1.0);
                    worst = if error > worst || error.is_nan() { error } else { worst };
                    let (row, column) = (place % n, place / n);
                    assert!(error <= ROUNDING, "{} {by:?} ({row}, {column}): {found} {expected}", name(scene));
                    n_compared += 1;
                }
            }
        }
    }
    assert!(n_compared > 100_000, "{n_compared}");
    println!("{n_compared} entries, {:.1} roundings at most", worst / f64::EPSILON);
}

#[test]
fn fd_gradients_of_everything_by_everything() {
    let (mut n_compared, mut n_sharp, mut worst) = (0, 0, 0.0_f64);
    for scene in &all() {
        let (scene, info) = (&**scene, scene.info());
        let system = System::new(scene, Backend::Auto).unwrap();
        let mut gradients = Gradients::new(&system).unwrap();
        let n_states = if info.n_unknowns() > 60 { 1 } else { N_STATES };
        for i in 0..n_states {
            let mut case = Case::random(scene, &system, i);
            for of in [Of::PositionRows, Of::VelocityRows, Of::Motion, Of::Outputs] {
                for by in [By::Positions, By::Velocities, By::States, By::Inputs, By::Parameters] {
                    let n = gradients.n_rows(of);
                    let mut found = vec![0.0; gradients.n_entries(of, by)];
                    gradients.write(&case.point(), of, by, &mut found);
                    for (j, column) in found.chunks(n.max(1)).enumerate() {
                        let x = *case.varied(&info, by, j);
                        let unit = if x == 0.0 || by != By::Parameters { 1.0 } else { x.abs() };
                        let difference = Difference::of(|e| {
                            *case.varied(&info, by, j) = x + e * unit;
                            let value = case.value(scene, of);
                            *case.varied(&info, by, j) = x;
                            value
                        });
                        let _ = case.value(scene, of);
                        for (row, exact) in column.iter().enumerate() {
                            let slope = exact * unit;
                            let rounding = DIFFERENCES * difference.size.max((exact * x).abs()).max(1.0);
                            let error = (slope - difference.slopes[row]).abs();
                            let truncation = difference.truncations[row];
                            let at = format!("{} {of:?} by {by:?} ({row}, {j})", name(scene));
                            assert!(error <= rounding + truncation, "{at}: {slope} {difference:?}");
                            worst = worst.max((error - truncation) / rounding);
                            n_compared += 1;
                            n_sharp += usize::from(truncation <= rounding);
                        }
                    }
                }
            }
        }
    }
    assert!(n_compared > 100_000 && n_sharp as f64 >= SHARP * n_compared as f64, "{n_sharp} of {n_compared}");
    println!("{n_sharp} of {n_compared} are sharp, {worst:.2} of the bound at most");
}

/// Slopes of numbers at zero, by central differences at two steps that are extrapolated to none.
#[derive(Debug)]
pub(super) struct Difference {
    pub slopes: Vec<f64>,
    /// At most these: what the next coarser pair of steps gives less of it.
    pub truncations: Vec<f64>,
    pub size: f64,
}

impl Difference {
    pub fn of(mut f: impl FnMut(f64) -> (Vec<f64>, f64)) -> Self {
        let mut size = 0.0_f64;
        let mut central = |step: f64| {
            let ((ahead, size_ahead), (behind, size_behind)) = (f(step), f(-step));
            size = size.max(size_ahead).max(size_behind);
            ahead.iter().zip(&behind).map(|(ahead, behind)| (ahead - behind) / (2.0 * step)).collect::<Vec<_>>()
        };
        let of_steps = [STEP, 2.0 * STEP, 4.0 * STEP].map(&mut central);
        let extrapolated = |fine: &[f64], coarse: &[f64]| -> Vec<f64> {
            fine.iter().zip(coarse).map(|(fine, coarse)| (4.0 * fine - coarse) / 3.0).collect()
        };
        let [fine, coarse] = [0, 1].map(|i| extrapolated(&of_steps[i], &of_steps[i + 1]));
        let truncations = fine.iter().zip(&coarse).map(|(fine, coarse)| (fine - coarse).abs()).collect();
        Self { slopes: fine, truncations, size }
    }
}

/// A scene that counts calls of its kernels on numbers with derivatives, written as one by hand may be.
struct Counted {
    scene: gantry::Steered,
    calls: AtomicUsize,
}

impl<T: Scalar> Equations<T> for Counted {
    fn constants(&self, parameters: &[T], c: &mut [T]) {
        self.scene.constants(parameters, c);
    }
    fn mass_matrix(&self, c: &[T], m: &mut [T]) {
        self.scene.mass_matrix(c, m);
    }
    fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        self.scene.position_constraint(c, t, q, out);
    }
    fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.scene.velocity_constraint(c, t, q, v, out);
    }
    fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
        self.scene.velocity_jacobian(c, t, q, out);
    }
    fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.scene.convective_term(c, t, q, v, out);
    }
    fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.calls.fetch_add(1, Relaxed);
        self.scene.applied_force(c, t, q, v, out);
    }
    fn state_rates(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.scene.state_rates(c, t, q, v, out);
    }
    fn outputs(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
        self.calls.fetch_add(1, Relaxed);
        self.scene.outputs(c, t, q, v, out);
    }
}

impl Derived for Counted {
    fn with_derivatives(&self) -> Option<&dyn EquationsWithDerivatives> {
        Some(self)
    }
}

impl Scene for Counted {
    fn info(&self) -> Arc<SceneInfo> {
        self.scene.info()
    }
    fn parameter(&self, index: usize) -> f64 {
        self.scene.parameter(index)
    }
    fn set_parameter(&mut self, index: usize, value: f64) {
        self.scene.set_parameter(index, value);
    }
    fn start(&self, c: &[f64], start: &mut Start) {
        self.scene.start(c, start);
    }
    fn power(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.scene.power(c, t, q, v, lambda, out);
    }
    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        self.scene.potential_energy(c, t, q)
    }
    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        self.scene.points(c, t, q, out);
    }
}

/// Of six coordinates and velocities, one state, three parameters, and five inputs.
#[test]
fn invariant_gradients_take_a_call_for_every_eight_columns() {
    let counted = Counted { scene: gantry::Steered::default(), calls: AtomicUsize::new(0) };
    let scene: &dyn Scene = &counted;
    let system = System::new(scene, Backend::Auto).unwrap();
    let mut gradients = Gradients::new(&system).unwrap();
    let case = Case::random(scene, &system, 0);
    for of in [Of::Motion, Of::Outputs] {
        for by in [By::Positions, By::Velocities, By::States, By::Inputs, By::Parameters] {
            let mut out = vec![0.0; gradients.n_entries(of, by)];
            counted.calls.store(0, Relaxed);
            gradients.write(&case.point(), of, by, &mut out);
            assert_eq!(counted.calls.load(Relaxed), gradients.n_columns(by).div_ceil(8), "{of:?} {by:?}");
        }
    }
}

#[test]
fn analytic_scenes_of_f64_alone_have_no_gradients() {
    let crank = Crank::default();
    let error = Gradients::new(&System::new(&crank, Backend::Auto).unwrap()).err();
    assert_eq!(error, Some(SystemError::WithoutDerivatives { scene: "turn" }));
}
