//! The order of every method in every scene: the error of one step against the length of it.

use crate::scenes::distance;
use ezy_core::dynamics::State;
use ezy_core::integrate::{Dop853, Node, Radau, Rk4, Taylor, Tolerance};
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_models::registry::MODELS;

/// Order of the series that tells where a step should lead; two fifths of its radius leave nothing to see.
const ORACLE: usize = 40;
/// Part of that radius, taken as the distance at which the last terms are 1, that the longest step has.
const LONGEST: f64 = 0.4;
/// Each step over the next one.
const RATIO: f64 = 1.2;
/// Lengths of steps: a method of order 4 needs 17 of them to come from 1e-6 to rounding, one of order 12 six.
const N_STEPS: i32 = 40;
/// Errors above it, over the size of the state, are not yet those of small steps.
const LARGE: f64 = 1e-6;
/// Rounding of a step's sums, over the size of the state, with a margin of hundreds so that it bends no slope.
const ROUNDING: f64 = 5e-14;
/// Higher terms of the error.
const ORDER_TOLERANCE: f64 = 0.5;
/// The terms of order 8 of DOP853 are so small that smaller steps meet rounding before those of higher order have died away.
const DOP853_TOLERANCE: f64 = 1.0;
/// Any error will do: the step is given.
const ANY: Tolerance = Tolerance { relative: 1.0, absolute: 1.0 };
/// The iteration of the implicit method goes on to rounding.
const CONVERGED: Tolerance = Tolerance { relative: 1e-10, absolute: 1e-10 };

/// A scene on its way, where nothing is zero by symmetry.
struct OnTheWay<'s> {
    system: System<'s, dyn Scene + 's>,
    state: State,
    a: Vec<f64>,
    lambda: Vec<f64>,
}

impl<'s> OnTheWay<'s> {
    fn new(scene: &'s (dyn Scene + 's)) -> Self {
        let until_s = 0.3 * scene.info().until_s.min(2.0);
        let run = Simulation::new(scene).method(Method::dop853(1e-10)).until(until_s).run().unwrap();
        let last = run.last();
        let (q, v) = (last.coordinates.to_vec(), last.velocities.to_vec());
        let mut system = System::new(scene, Backend::Auto).unwrap();
        let (mut a, mut lambda) = (vec![0.0; q.len()], vec![0.0; scene.info().n_rows()]);
        system.accelerations(last.t, &q, &v, &mut a, &mut lambda).unwrap();
        Self { system, state: State { t: last.t, q, v, work: Vec::new() }, a, lambda }
    }

    fn taylor(&mut self, order: usize, h: f64) -> State {
        let mut method = Taylor::new(self.system.scene(), order, 0).expect("a series");
        let mut to = self.state.clone();
        method.expand(&mut self.system, &self.state, &mut self.a, &mut self.lambda).unwrap();
        method.accept();
        method.advance(&self.system, &self.state, h, &mut to);
        to
    }

    fn rk4(&mut self, h: f64) -> State {
        let (n_q, n_c) = (self.state.q.len(), self.lambda.len());
        let mut to = self.state.clone();
        let from = Node { state: &self.state, a: &self.a, power: &[] };
        Rk4::new(n_q, n_c, 0).step(&mut self.system, from, h, self.state.t + h, &mut to).unwrap();
        to
    }

    fn dop853(&mut self, h: f64) -> State {
        let (n_q, n_c) = (self.state.q.len(), self.lambda.len());
        let mut to = self.state.clone();
        let from = Node { state: &self.state, a: &self.a, power: &[] };
        Dop853::new(n_q, n_c, 0).attempt(&mut self.system, from, h, ANY, &mut to).unwrap();
        to
    }

    /// Steps in which the iteration does not converge err by anything.
    fn radau(&mut self, h: f64) -> State {
        let mut to = self.state.clone();
        let from = Node { state: &self.state, a: &self.a, power: &[] };
        let mut method = Radau::new(self.system.scene(), 0).unwrap().expect("slopes");
        method.attempt(&mut self.system, from, h, CONVERGED, false, &mut to).unwrap();
        to
    }

    /// Where the terms of the series are as large as the state, s.
    fn radius(&mut self) -> f64 {
        let mut method = Taylor::new(self.system.scene(), ORACLE, 0).expect("a series");
        method.expand(&mut self.system, &self.state, &mut self.a, &mut self.lambda).unwrap();
        method.accept();
        method.longest_step(ANY)
    }

    /// Order of one step over the lengths that show one; none where a method leaves no error.
    fn order(&mut self, step: fn(&mut Self, f64) -> State) -> Option<f64> {
        let longest = (LONGEST * self.radius()).min(1.0);
        let size = self.state.q.iter().chain(&self.state.v).fold(1.0, |m: f64, x| m.max(x.abs()));
        let mut errors = Vec::new();
        for i in 0..N_STEPS {
            let h = longest / RATIO.powi(i);
            let (oracle, end) = (self.taylor(ORACLE, h), step(self, h));
            let error = distance(&oracle.q, &end.q).max(distance(&oracle.v, &end.v)) / size;
            if error < ROUNDING {
                break;
            }
            if error < LARGE {
                errors.push(error);
            }
        }
        let [.., first, _, _, last] = errors[..] else { return None };
        // a step errs with one power more than the method; over three lengths, since a term may cross zero at one of them
        Some((first / last).ln() / RATIO.powi(3).ln() - 1.0)
    }
}

type Step = fn(&mut OnTheWay<'_>, f64) -> State;

/// A method that is better than its order in a scene, such as RK4 where forces do not vary, is no fault.
#[test]
fn order_of_every_method_in_every_scene() {
    let methods: [(&str, f64, Step); 5] = [
        ("rk4", 4.0 - ORDER_TOLERANCE, |on, h| on.rk4(h)),
        ("dop853", 8.0 - DOP853_TOLERANCE, |on, h| on.dop853(h)),
        ("radau", 5.0 - ORDER_TOLERANCE, |on, h| on.radau(h)),
        ("taylor of order 8", 8.0 - ORDER_TOLERANCE, |on, h| on.taylor(8, h)),
        ("taylor of order 12", 12.0 - ORDER_TOLERANCE, |on, h| on.taylor(12, h)),
    ];
    let mut n_measured = [0; 5];
    let (mut n_scenes, mut faults) = (0, Vec::new());
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        if scene.series().is_none() {
            continue;
        }
        n_scenes += 1;
        let mut on = OnTheWay::new(&*scene);
        for ((name, least, step), n) in methods.into_iter().zip(&mut n_measured) {
            let Some(order) = on.order(step) else { continue };
            *n += 1;
            if order < least {
                faults.push(format!("{}/{}, {name}: {order:.2}", scene.info().model, scene.info().name));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    // what moves uniformly or as a polynomial shows none
    assert!(n_scenes >= 38 && n_measured.iter().all(|n| *n >= 15), "{n_scenes} scenes, {n_measured:?} measured");
}
