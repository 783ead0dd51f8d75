//! Folds, branch points and branches of steady motions over a value, against closed forms.

use crate::equilibria::{SPRUNG_WEIGHT, chain, positions, slider_crank, sprung_pendulum};
use ezy_core::analysis::{AnalysisError, Bifurcation, BifurcationDiagram, Branch, BranchEnd, BranchPoint};
use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::prelude::*;
use ezy_tests::tables::{list, number, set_parameters, table};
use std::f64::consts::{FRAC_PI_2, PI};

/// Of the value at a fold or a branch point, as a share of the largest.
const VALUE: f64 = 1e-10;
/// Of a coordinate at a fold: the tangent is followed to 1e-13 of a step, and rounding of its small component along the value is amplified by
/// the step.
const AT_FOLD: f64 = 1e-9;

/// Of what is kept along a branch, in m and rad: rounding of each of a thousand corrections at most.
const KEPT: f64 = 1e-12;

fn diagram_of<S: Scene>(scene: &S, name: &str, range: [f64; 2], step: f64) -> BifurcationDiagram {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    BifurcationDiagram::of(&mut system, &start, &[], name, range, step).unwrap()
}

fn special(branch: &Branch) -> Vec<&BranchPoint> {
    branch.points.iter().filter(|point| point.bifurcation.is_some()).collect()
}

#[test]
fn analytic_folds_of_a_slider_crank_over_its_torque() {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    let mut n_sets = 0;
    for of in list(&table["sets"]).iter().filter(|of| of["model"] == "slider_crank") {
        n_sets += 1;
        let mut scene = slider_crank::Rests::default();
        set_parameters(&mut scene, &[&of["parameters"]]);
        let folds = list(&of["folds_over_the_torque"]);
        let torques: Vec<f64> = folds.iter().map(|fold| number(&fold["torque"])).collect();
        let largest = torques.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let mut system = System::new(&scene, Backend::Auto).unwrap();
        let mut start = system.scene_start();
        start.q[2] = number(&of["equilibria"][0]["crank_angle"]);
        let range = [-2.0 * largest, 2.0 * largest];
        let diagram = BifurcationDiagram::of(&mut system, &start, &[], "tau", range, 0.5).unwrap();
        let [branch] = &diagram.branches[..] else { panic!("{} branches", diagram.branches.len()) };
        assert_eq!(branch.ends, [BranchEnd::Closed; 2]);
        let found = special(branch);
        assert_eq!(
            found.len(),
            folds.len(),
            "{:?}",
            found.iter().map(|p| (p.value, p.bifurcation)).collect::<Vec<_>>()
        );
        for (fold, torque) in folds.iter().zip(&torques) {
            let nearest = found.iter().min_by(|a, b| (a.value - torque).abs().total_cmp(&(b.value - torque).abs()));
            let point = nearest.expect("one");
            assert_eq!(point.bifurcation, Some(Bifurcation::Fold));
            assert!((point.value - torque).abs() <= VALUE * largest, "{} for {torque}", point.value);
            let turn = (point.motion.state.q[2] - number(&fold["crank_angle"])) / (2.0 * PI);
            assert!((turn - turn.round()).abs() <= AT_FOLD, "{turn}");
        }
        // stability changes at each fold, and nowhere else
        let counts: Vec<usize> = branch.points.iter().map(|point| point.spectrum.n_unstable()).collect();
        let changes = counts.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(changes >= folds.len(), "{counts:?}");
    }
    assert_eq!(n_sets, 3);
}

/// k θ = (m g l/2) sin θ, with θ from upright: the straight branch, and one that leaves it where k = m g l/2.
#[test]
fn analytic_sprung_rod_buckles_at_a_branch_point() {
    let scene = sprung_pendulum::Rests { k: 14.0, ..Default::default() };
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    start.q[2] = FRAC_PI_2 + 0.1;
    let diagram = BifurcationDiagram::of(&mut system, &start, &[], "k", [3.0, 15.0], 0.5).unwrap();
    assert!(diagram.is_complete);
    let [straight, buckled @ ..] = &diagram.branches[..] else { panic!("no branch") };
    let [point] = special(straight)[..] else { panic!("{:?}", straight.points.len()) };
    assert_eq!(point.bifurcation, Some(Bifurcation::BranchPoint));
    assert!((point.value - SPRUNG_WEIGHT).abs() <= VALUE * SPRUNG_WEIGHT, "{} for {SPRUNG_WEIGHT}", point.value);
    assert_eq!(straight.ends, [BranchEnd::Range; 2]);
    for point in &straight.points {
        assert!((point.motion.state.q[2] - FRAC_PI_2).abs() <= VALUE, "{point:?}");
    }
    assert_eq!(buckled.len(), 2);
    let mut sides = Vec::new();
    for branch in buckled {
        assert_eq!(branch.ends, [BranchEnd::BranchPoint, BranchEnd::Range]);
        assert!(special(branch).is_empty());
        for point in &branch.points {
            let theta = point.motion.state.q[2] - FRAC_PI_2;
            let left = point.value * theta - SPRUNG_WEIGHT * theta.sin();
            assert!(left.abs() <= VALUE * SPRUNG_WEIGHT, "{left}");
        }
        let [first, .., last] = &branch.points[..] else { panic!("one point") };
        assert!((first.value - SPRUNG_WEIGHT).abs() <= VALUE * SPRUNG_WEIGHT);
        assert!((last.value - 3.0).abs() <= VALUE, "{}", last.value);
        assert!(branch.points[1..].iter().all(|point| point.spectrum.n_unstable() == 0));
        sides.push((last.motion.state.q[2] - FRAC_PI_2).signum());
    }
    assert_eq!(sides[0] + sides[1], 0.0);
}

/// The same rod with an offset of the spring: folds where k = (m g l/2) cos θ.
#[test]
fn analytic_folds_of_a_sprung_rod_over_its_offset() {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    let of = list(&table["sets"]).iter().find(|of| of["name"] == "inverted_soft").expect("the set");
    let mut scene = sprung_pendulum::Rests::default();
    set_parameters(&mut scene, &[&of["parameters"]]);
    let diagram = diagram_of(&scene, "e", [-10.0, 10.0], 0.2);
    let [branch] = &diagram.branches[..] else { panic!("{} branches", diagram.branches.len()) };
    let found = special(branch);
    for fold in list(&of["folds_over_the_offset_e"]) {
        let (theta, e) = (number(&fold["theta"]), number(&fold["e"]));
        let near = found.iter().find(|point| (point.motion.state.q[2] - FRAC_PI_2 - theta).abs() <= AT_FOLD);
        let point = near.unwrap_or_else(|| panic!("no fold at {theta}"));
        assert_eq!(point.bifurcation, Some(Bifurcation::Fold));
        assert!((point.value - e).abs() <= VALUE * e.abs().max(1.0), "{} for {e}", point.value);
    }
    for point in &branch.points {
        let theta = point.motion.state.q[2] - FRAC_PI_2;
        let left = scene.k * (theta - point.value) - SPRUNG_WEIGHT * theta.sin();
        assert!(left.abs() <= VALUE * SPRUNG_WEIGHT, "{left}");
    }
}

/// A chain of n rods of length l over a span x is straight at x = n l, where its tension grows without bound.
#[test]
fn analytic_curve_ends_where_the_mechanism_does() {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    let of = list(&table["sets"]).iter().find(|of| of["name"] == "chain_20").expect("the set");
    let mut scene = chain::Rests::default();
    set_parameters(&mut scene, &[&of["parameters"]]);
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    start.q.copy_from_slice(&positions(&system.info().clone(), of));
    let diagram = BifurcationDiagram::of(&mut system, &start, &[], "x", [1.0, 2.5], 0.1).unwrap();
    let [branch] = &diagram.branches[..] else { panic!("{} branches", diagram.branches.len()) };
    assert_eq!(branch.ends, [BranchEnd::Range, BranchEnd::Lost]);
    let last = &branch.points[branch.points.len() - 1];
    assert!(last.value < 2.0 && last.value > 1.99, "{}", last.value);
}

model! {
    /// A car on two tyres at a constant forward speed, with a steering angle in front.
    model Steered {
        param m: kg = 1500; param i: kg*m^2 = 2500; param a: m = 1.2; param b: m = 1.5;
        param cf: N/rad = 100000; param cr: N/rad = 70000; param u: m/s = 40; param delta: rad = 0;
        body car { mass: m, inertia: i }
        tyre at car(a, 0) along car(cos(delta), sin(delta)): stiffness cf;
        tyre at car(-b, 0) along car(1, 0): stiffness cr;
        roll pace: at car(0, 0) along car(1, 0) = u;
        start at_speed { car at (0, 0) angle 0; car velocity (u, 0) rate 0; }
        scene runs { start at_speed; until 1 s; }
    }
}

/// A steady turn: steering angle, rad, and sideways speed, m/s.
struct Circle {
    delta: f64,
    v: f64,
}

/// At the yaw rate r: m u r = Ff cos δ + Fr and 0 = a Ff cos δ − b Fr, with Fr = −cr α and α of the rear wheel of tangent (v − b r)/u; then δ
/// by halving.
fn circle(car: &steered::Runs, r: f64) -> Circle {
    let steered::Runs { m, a, b, cf, cr, u, .. } = *car;
    let [front, rear] = [b, a].map(|lever| lever * m * u * r / (a + b));
    let v = b * r - u * (rear / cr).tan();
    let left = |delta: f64| cf * (delta - (v + a * r).atan2(u)) * delta.cos() - front;
    let (mut low, mut high) = (-0.5, 0.5);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        *(if left(middle) > 0.0 { &mut high } else { &mut low }) = middle;
    }
    Circle { delta: 0.5 * (low + high), v }
}

/// Above its critical speed a car that oversteers is unstable straight on; below, its steering angle has a largest value, at a fold.
#[test]
fn analytic_oversteering_car_turns_to_both_sides() {
    let car = steered::Runs::default();
    let diagram = diagram_of(&car, "delta", [-0.05, 0.05], 0.01);
    let [branch] = &diagram.branches[..] else { panic!("{} branches", diagram.branches.len()) };
    assert_eq!(branch.ends, [BranchEnd::Range; 2]);
    for point in &branch.points {
        let state = &point.motion.state;
        // its place and its heading are kept
        assert!(state.q.iter().all(|q| q.abs() <= KEPT), "{:?}", state.q);
        let expected = circle(&car, state.v[2]);
        assert!((expected.delta - point.value).abs() <= VALUE, "{} for {}", point.value, expected.delta);
        assert!((expected.v - state.v[1]).abs() <= VALUE * car.u, "{} for {}", state.v[1], expected.v);
    }
    let folds = special(branch);
    assert_eq!(folds.len(), 2, "{folds:?}");
    for fold in folds {
        assert_eq!(fold.bifurcation, Some(Bifurcation::Fold));
        let r = fold.motion.state.v[2];
        // a largest value: δ falls to both sides with the square of the distance
        let beside = [-1e-3, 1e-3].map(|h| circle(&car, r + h).delta.abs() - fold.value.abs());
        assert!(beside.iter().all(|x| *x < 0.0), "{beside:?}");
        assert!((beside[0] - beside[1]).abs() <= 1e-2 * beside[0].abs(), "{beside:?}");
    }
}

model! {
    /// A rod whose spring is wound by each turn: it rests wherever that and its weight are what a motor gives.
    model Wound {
        param tau: N*m = 0; param k: N*m = 0.0005;
        body rod { mass: 1, inertia: 1 }
        constraint pin: rod.x = 0;
        constraint level: rod.y = 0;
        torque rod: tau - 1 N*m*sin(rod.phi) - k*rod.phi;
        start home { rod angle 0; at rest; }
        scene rests { start home; until 1 s; }
    }
}

#[test]
fn invariant_endless_branch_says_that_it_goes_on() {
    let diagram = diagram_of(&wound::Rests::default(), "tau", [-2.0, 2.0], 0.1);
    let [branch] = &diagram.branches[..] else { panic!("{} branches", diagram.branches.len()) };
    assert_eq!(branch.ends, [BranchEnd::TooLong; 2]);
}

/// A place that a constraint fixes cannot vary.
#[test]
fn invariant_what_is_fixed_does_not_vary() {
    let scene = wound::Rests::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let of = |system: &mut _, name| BifurcationDiagram::of(system, &start, &[], name, [0.0, 1.0], 0.1).unwrap_err();
    let fixed = of(&mut system, "rod.x");
    assert!(matches!(&fixed, AnalysisError::CannotVary { name, .. } if name == "rod.x"), "{fixed}");
    let unknown = of(&mut system, "rod.z");
    assert!(matches!(&unknown, AnalysisError::Unknown { name, .. } if name == "rod.z"), "{unknown}");
}

model! {
    /// A block that nothing drives or brakes.
    model Gliding {
        body block { mass: 1, inertia: 1 }
        start moving { block at (0, 0) angle 0 velocity (1, 0) rate 0; }
        scene glides { start moving; until 1 s; }
    }
}

/// A speed that varies may be named among what is held: any speed is steady.
#[test]
fn invariant_what_varies_is_not_held() {
    let scene = gliding::Glides::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    for hold in [&[][..], &["block.vx"]] {
        let diagram = BifurcationDiagram::of(&mut system, &start, hold, "block.vx", [1.0, 2.0], 0.1).unwrap();
        let points = &diagram.branches[0].points;
        assert!(points.len() > 10, "{}", points.len());
        assert!(points.iter().all(|point| (point.motion.state.v[0] - point.value).abs() <= KEPT), "{points:?}");
    }
}
