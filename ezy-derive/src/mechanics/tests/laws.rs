//! Laws of forces at one state, against the same by hand.

use crate::diag::Diagnostics;
use crate::mechanics::symbols::Meaning;
use crate::mechanics::{Equations, EventKind};
use crate::model::Model;
use crate::symbolic::evaluate::Point;
use crate::symbolic::{SumId, Symbol};
use crate::{model, parse};

/// Some operations on numbers of ten.
const ROUNDING: f64 = 1e-13;

/// Positions and velocities of two bodies.
const Q: [f64; 6] = [0.3, -0.2, 0.7, 1.1, 0.4, -0.5];
const V: [f64; 6] = [0.8, -1.3, 0.9, 0.2, 0.6, -1.7];

fn resolved(items: &str) -> Model {
    let text = format!(
        "model M {{ body one {{ mass: 2, inertia: 3 }} body two {{ mass: 1, inertia: 1 }} {items} \
         start s {{ at rest; }} scene run {{ start s; until 1 s; }} }}"
    );
    let mut diag = Diagnostics::default();
    let syntax = parse::parse(text.parse().expect("the text has tokens"), &mut diag);
    match model::resolve(syntax, &mut diag).filter(|_| diag.is_empty()) {
        Some(model) => model,
        None => panic!("{text}: {}", diag.into_compile_errors()),
    }
}

/// Equations where no parameter and no input is read, with the values of switches.
struct At(Equations, [f64; 2]);

impl At {
    fn value(&self, sum: SumId) -> f64 {
        self.0.algebra.evaluate(sum, self)
    }

    /// F.
    fn force(&self) -> Vec<f64> {
        self.0.force.iter().map(|&sum| self.value(sum)).collect()
    }

    /// Values of what is not smooth, of layers or of discontinuities, ascending.
    fn breaks(&self, are_layers: bool) -> Vec<f64> {
        let is_one = |kind: &EventKind| match kind {
            EventKind::Declared { .. } => false,
            EventKind::Discontinuity => !are_layers,
            EventKind::Layer => are_layers,
        };
        let of_layers = self.0.events.iter().filter(|event| is_one(&event.kind));
        let mut values: Vec<f64> = of_layers.map(|event| self.value(event.value)).collect();
        values.sort_by(f64::total_cmp);
        values
    }
}

impl Point for At {
    fn symbol(&self, symbol: Symbol) -> f64 {
        match self.0.symbols.meaning(symbol) {
            Meaning::Time => 0.3,
            Meaning::Coordinate(i) => Q[i],
            Meaning::Velocity(i) => V[i],
            meaning => panic!("{meaning:?} is not read"),
        }
    }

    fn parameter(&self, index: usize) -> f64 {
        self.1[index]
    }
}

/// The one scene of a model with these items.
fn at(items: &str) -> At {
    let model = resolved(items);
    At(Equations::derive(&model, &model.scenes[0]), [f64::NAN; 2])
}

fn assert_close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
    let error = found.iter().zip(expected).fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()));
    assert!(error <= ROUNDING, "{found:?} {expected:?}");
}

/// A vector fixed to body one, along the axes of the ground.
fn turned([x, y]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = Q[2].sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// Velocity of a point of body one.
fn velocity(at: [f64; 2]) -> [f64; 2] {
    let arm = turned(at);
    [V[0] - V[2] * arm[1], V[1] + V[2] * arm[0]]
}

/// Generalised forces of a force at a point of body one.
fn at_point(at: [f64; 2], [x, y]: [f64; 2]) -> [f64; 6] {
    let arm = turned(at);
    [x, y, arm[0] * y - arm[1] * x, 0.0, 0.0, 0.0]
}

/// −f v/√(v² + u²) and the share v/√(v² + u²), by which steps see where the law turns around: for both components at a point, for the slip
/// along a direction, and for the rate of a couple.
#[test]
fn analytic_friction_is_its_law_and_tells_its_layers() {
    let share = |v: f64, u: f64| v / v.hypot(u);
    let v = velocity([0.4, 0.1]);
    let size = (v[0] * v[0] + v[1] * v[1] + 0.25).sqrt();
    let point = at("friction at one(0.4, 0.1): force 3, speed 0.5;");
    assert_close(&point.force(), &at_point([0.4, 0.1], v.map(|v| -3.0 * v / size)));
    let mut expected = v.map(|v| v / size);
    expected.sort_by(f64::total_cmp);
    assert_close(&point.breaks(true), &expected);

    let along = turned([0.6, 0.8]);
    let slip = v[0] * along[0] + v[1] * along[1] - 0.7;
    let tread = at("friction at one(0.4, 0.1) along one(3, 4): force 3, speed 0.5, tread 0.7;");
    assert_close(&tread.force(), &at_point([0.4, 0.1], along.map(|x| -3.0 * share(slip, 0.5) * x)));
    assert_close(&tread.breaks(true), &[share(slip, 0.5)]);

    let rate = V[5] - V[2];
    let couple = at("friction one ~ two: torque 2, rate 0.5;");
    assert_close(&couple.force(), &[0.0, 0.0, 2.0 * share(rate, 0.5), 0.0, 0.0, -2.0 * share(rate, 0.5)]);
    assert_close(&couple.breaks(true), &[share(rate, 0.5)]);
}

/// A skate that slides to the left of its direction is pushed to the right, and takes energy from what moves to the left.
#[test]
fn analytic_sliding_skate_is_pushed_against_its_side() {
    let model = resolved("skate runner: at one(0.4, 0.1) along one(3, 4) limit 5;");
    let normal = turned([-0.8, 0.6]);
    let v = velocity([0.4, 0.1]);
    let across = normal[0] * v[0] + normal[1] * v[1];
    for (side, force) in [(1.0, -5.0), (-1.0, 5.0)] {
        let at = At(Equations::derive(&model, &model.scenes[0]), [0.0, side]);
        let start: Vec<f64> = at.0.symbols.switches().iter().map(|switch| switch.start).collect();
        assert_eq!(start, [1.0, 0.0], "the skate holds at the start");
        assert_eq!(at.value(at.0.constraints.velocity[0]), 0.0, "the row is off");
        assert_close(&at.force(), &at_point([0.4, 0.1], normal.map(|x| force * x)));
        let power: Vec<f64> = at.0.power.iter().map(|&(_, sum)| at.value(sum)).collect();
        assert_close(&power, &[force * across]);
        let [limit, velocity] = at.0.limited_skates[0];
        assert_close(&[at.value(limit), at.value(velocity)], &[5.0, across]);
    }
}

/// A skate that holds is its row, and no force.
#[test]
fn analytic_holding_skate_is_its_row() {
    let model = resolved("skate runner: at one(0.4, 0.1) along one(3, 4) limit 5;");
    let at = At(Equations::derive(&model, &model.scenes[0]), [1.0, 0.0]);
    let (normal, v) = (turned([-0.8, 0.6]), velocity([0.4, 0.1]));
    assert_close(&[at.value(at.0.constraints.velocity[0])], &[normal[0] * v[0] + normal[1] * v[1]]);
    assert_close(&at.force(), &[0.0; 6]);
}

/// The row of a stop is the quantity less the bound of its side, without rounding, and 0 = 0 while it is open.
#[test]
fn analytic_row_of_a_stop_is_of_its_side() {
    let model = resolved("stop rail: one.x from -0.1 to 0.7 restitution 0.5;");
    let row = |holds, side| {
        let at = At(Equations::derive(&model, &model.scenes[0]), [holds, side]);
        at.value(at.0.constraints.position[0])
    };
    assert_eq!([row(1.0, 1.0), row(1.0, -1.0)], [Q[0] + 0.1, Q[0] - 0.7]);
    assert_eq!([1.0, -1.0, 0.0].map(|side| row(0.0, side)), [0.0; 3]);
}

/// Where a law jumps or bends: its own argument, and that of the limit of a skate, which is no force while the skate holds.
#[test]
fn analytic_discontinuities_are_the_arguments_of_laws() {
    assert_close(&at("force at one(0, 0): (-3 N * sign(one.vy), 0);").breaks(false), &[V[1]]);
    assert_close(&at("force at one(0, 0): (-3 N/m * abs(one.x), 0);").breaks(false), &[Q[0]]);
    assert_close(
        &at("skate runner: at one(0, 0) along one(1, 0) limit 2 N + 1 N/m * abs(one.y);").breaks(false),
        &[Q[1]],
    );
}

/// −k (φ₂ − φ₁ − 0.5 t) − c (ω₂ − ω₁): the damper knows nothing of the angle that moves.
#[test]
fn analytic_torsion_to_a_moving_angle() {
    let torsion = at("torsion one ~ two: stiffness 3, angle 0.5 * t, damping 2;");
    let torque = -3.0 * (Q[5] - Q[2] - 0.15) - 2.0 * (V[5] - V[2]);
    assert_close(&torsion.force(), &[0.0, 0.0, -torque, 0.0, 0.0, torque]);
}

/// Distances are positive between the ends, and so is the rate of one that grows.
#[test]
fn analytic_distances_of_a_stop_from_its_ends() {
    let at = at("stop rail: one.x from -1 to 2 restitution 0.5;");
    let contact = at.0.contact.as_ref().expect("there is a stop");
    let values: Vec<f64> = contact.values().into_iter().map(|sum| at.value(sum)).collect();
    assert_close(&values, &[Q[0] + 1.0, V[0], 2.0 - Q[0], -V[0], 0.5]);
}
