//! Workspaces and singular positions of linkages against closed forms.

use ezy_core::analysis::{AnalysisError, AssemblyBranch, Axis, Limit, Singularity, Workspace};
use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::prelude::*;
use nalgebra::Matrix4;
use std::f64::consts::{FRAC_PI_2, PI};

/// Of values at which a mechanism is singular, in rad and m: what is promised.
const VALUE: f64 = 1e-10;
/// Of coordinates at a dead centre: the tangent is followed to 1e-13 of a step.
const AT_DEAD_CENTRE: f64 = 1e-9;
/// Of coordinates elsewhere, in rad and m: Newton's method ends at 1e-15, ten thousand times as much next to singular positions.
const PLACE: f64 = 1e-11;

/// Of values at an end, in rad and m.
const ROUNDING: f64 = 1e-12;

model! {
    /// A four-bar.
    model Bars {
        param a: m = 0.3; param b: m = 0.9; param c: m = 0.7; param d: m = 0.8; param first: rad = 1.2;
        param second: rad = 0.3; param third: rad = 1.8; param omega: rad/s = 1;
        body crank { mass: 1, inertia: 0.1 }
        body coupler { mass: 1, inertia: 0.1 }
        body rocker { mass: 1, inertia: 0.1 }
        hinge O: ground(0, 0) ~ crank(0, 0);
        hinge A: crank(a, 0) ~ coupler(0, 0);
        hinge B: coupler(b, 0) ~ rocker(c, 0);
        hinge D: ground(d, 0) ~ rocker(0, 0);
        effect motor { drive turns: crank.phi = first + omega*t; }
        start away { crank angle first; coupler near angle second; rocker near angle third; at rest; }
        scene free { start away; until 1 s; }
        scene driven { start away; until 1 s; with motor; }
    }
}

model! {
    /// A crank, a rod and a piston.
    model Piston {
        param r: m = 0.3; param l: m = 0.8; param first: rad = 0.5; param second: rad = -0.2;
        body crank { mass: 1, inertia: 0.1 }
        body rod { mass: 1, inertia: 0.1 }
        body piston { mass: 1, inertia: 0.1 }
        hinge O: ground(0, 0) ~ crank(0, 0);
        hinge A: crank(r, 0) ~ rod(0, 0);
        hinge B: rod(l, 0) ~ piston(0, 0);
        constraint rail: piston.y = 0;
        constraint level: piston.phi = 0;
        start away { crank angle first; rod near angle second; at rest; }
        scene free { start away; until 1 s; }
    }
}

model! {
    /// A rod on a pin, upright.
    model Pinned {
        param l: m = 0.7;
        body rod { mass: 1, inertia: 0.1 }
        hinge O: ground(0, 0) ~ rod(-l, 0);
        start up { rod angle pi/2; at rest; }
        start flat { rod angle 0; at rest; }
        scene upright { start up; until 1 s; }
        scene level { start flat; until 1 s; }
    }
}

model! {
    /// Two links; the centre of the second one is the tip.
    model Links {
        param l1: m = 0.5; param l2: m = 0.4; param bend: rad = 1.5;
        body upper { mass: 1, inertia: 0.1 }
        body fore { mass: 1, inertia: 0.1 }
        hinge S: ground(0, 0) ~ upper(0, 0);
        hinge E: upper(l1, 0) ~ fore(-l2, 0);
        start bent { upper angle 0; fore angle bend; at rest; }
        scene free { start bent; until 1 s; }
    }
}

model! {
    /// A block on two rails at a small angle.
    model Rails {
        param angle: rad = 0.1;
        body block { mass: 1, inertia: 1 }
        constraint level: block.phi = 0;
        constraint one: block.y = 0;
        constraint two: block.y + angle*block.x = 0;
        start home { block at (0, 0) angle 0; at rest; }
        scene free { start home; until 1 s; }
    }
}

fn axis(name: &str, from: f64, to: f64, n: usize) -> Axis {
    let values = (0..=n).map(|i| from + (to - from) * i as f64 / n as f64).collect();
    Axis { name: name.to_owned(), values }
}

fn of<S: Scene>(scene: &S, axes: &[Axis], hold: &[&str], without: &[&str]) -> Result<Workspace, AnalysisError> {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    Workspace::of(&mut system, &start, axes, hold, without)
}

fn near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} for {expected}");
}

fn ends(branch: &AssemblyBranch) -> [(f64, Limit); 2] {
    let ends = branch.ends.as_ref().expect("of one coordinate");
    [(ends[0].value, ends[0].limit), (ends[1].value, ends[1].limit)]
}

/// Where the closed curve of both ways of assembly over one coordinate turns back.
fn check_range(found: &Workspace, expected: [f64; 2]) {
    assert_eq!(found.branches.len(), 2);
    for branch in &found.branches {
        for ((value, limit), expected) in ends(branch).into_iter().zip(expected) {
            assert_eq!(limit, Limit::DeadCentre);
            near(value, expected, VALUE);
        }
        for (value, q) in found.axes[0].values.iter().zip(&branch.positions) {
            let is_reached = expected[0] - ROUNDING <= *value && *value <= expected[1] + ROUNDING;
            assert_eq!(q.is_some(), is_reached, "{value}");
        }
    }
    let kinds: Vec<_> = found.singular.iter().map(|singular| singular.kind).collect();
    assert_eq!(kinds, [Singularity::DeadCentre; 2]);
}

/// The rocker's angle for that of the crank, by the law of cosines: `side` says which way the bars bend.
fn rocker(theta: f64, [a, b, c, d]: [f64; 4], side: f64) -> f64 {
    let (x, y) = (a * theta.cos() - d, a * theta.sin());
    let f = x.hypot(y);
    y.atan2(x) + side * ((f * f + c * c - b * b) / (2.0 * f * c)).acos()
}

fn without_turns(angle: f64) -> f64 {
    angle - 2.0 * PI * (angle / (2.0 * PI)).round()
}

#[test]
fn analytic_crank_of_a_four_bar_turns_as_far_as_the_law_of_cosines_says() {
    let limit = |[a, b, c, d]: [f64; 4], side: f64| ((a * a + d * d - (b + side * c).powi(2)) / (2.0 * a * d)).acos();
    // Grashof with the shortest bar as crank, where that turns round; non-Grashof; Grashof with the shortest bar as rocker
    let sets = [[0.3, 0.9, 0.7, 0.8], [1.0, 0.9, 0.8, 1.3], [0.7, 0.9, 0.3, 0.8]];
    for (i, bars) in sets.into_iter().enumerate() {
        let mut scene = bars::Free::default();
        [scene.a, scene.b, scene.c, scene.d] = bars;
        let found = of(&scene, &[axis("crank.phi", -PI, PI, 90)], &[], &[]).unwrap();
        match i {
            0 => {
                assert!(found.singular.is_empty() && found.branches.len() == 1);
                assert_eq!(ends(&found.branches[0]), [(-PI, Limit::Range), (PI, Limit::Range)]);
                assert!(found.branches[0].positions.iter().all(Option::is_some));
            }
            1 => check_range(&found, [-limit(bars, 1.0), limit(bars, 1.0)]),
            _ => check_range(&found, [limit(bars, -1.0), limit(bars, 1.0)]),
        }
        // each branch bends to one side
        for branch in &found.branches {
            let reached =
                || found.axes[0].values.iter().zip(&branch.positions).filter_map(|(x, q)| Some((*x, q.as_ref()?)));
            let off = |side: f64| {
                let off = |(theta, q): (f64, &Vec<f64>)| without_turns(q[8] - rocker(theta, bars, side)).abs();
                reached().map(off).fold(0.0, f64::max)
            };
            assert!(off(1.0).min(off(-1.0)) <= PLACE, "{} {}", off(1.0), off(-1.0));
        }
        for singular in &found.singular {
            // coupler and rocker in line
            near((singular.q[5] - singular.q[8]).sin(), 0.0, AT_DEAD_CENTRE);
        }
    }
}

/// All bars in line at 0 and π.
#[test]
fn analytic_parallelogram_has_change_points() {
    let mut scene = bars::Free::default();
    [scene.a, scene.b, scene.c, scene.d] = [0.4, 0.9, 0.4, 0.9];
    [scene.first, scene.second, scene.third] = [1.0, 0.0, 1.0];
    let found = of(&scene, &[axis("crank.phi", -2.0, 5.0, 70)], &[], &[]).unwrap();
    assert_eq!(found.branches.len(), 1);
    assert_eq!(found.singular.len(), 2, "{:?}", found.singular);
    for (singular, expected) in found.singular.iter().zip([0.0, PI]) {
        assert_eq!(singular.kind, Singularity::ChangePoint);
        near(singular.value, expected, VALUE);
        near(singular.q[5], 0.0, VALUE);
        near(singular.q[8], expected, VALUE);
    }
    for (theta, q) in found.axes[0].values.iter().zip(&found.branches[0].positions) {
        let q = q.as_ref().expect("it turns round");
        near(q[5], 0.0, PLACE);
        near(q[8], *theta, PLACE);
    }
}

/// Rows at an angle of x have the ratio x/2 of their singular values: rails are one below 1e-10.
#[test]
fn analytic_rails_at_a_small_angle_hold_the_block_or_are_one() {
    for (angle, is_held) in [(2e-9, true), (2e-11, false)] {
        match of(&rails::Free { angle }, &[axis("block.x", -1.0, 1.0, 5)], &[], &[]) {
            Ok(found) => assert!(!is_held && found.branches[0].positions.iter().all(Option::is_some), "{found:?}"),
            Err(error) => assert!(is_held && matches!(error, AnalysisError::Fixed { .. }), "{angle}: {error}"),
        }
    }
}

#[test]
fn analytic_piston_goes_between_its_dead_centres() {
    let scene = piston::Free::default();
    let found = of(&scene, &[axis("piston.x", 0.0, 1.5, 60)], &[], &[]).unwrap();
    check_range(&found, [0.8 - 0.3, 0.8 + 0.3]);
    for (singular, crank) in found.singular.iter().zip([PI, 0.0]) {
        near(without_turns(singular.q[2] - crank), 0.0, AT_DEAD_CENTRE);
    }
    // a range that ends before
    let found = of(&scene, &[axis("piston.x", 0.7, 1.0, 10)], &[], &[]).unwrap();
    assert!(found.singular.is_empty() && ends(&found.branches[0]) == [(0.7, Limit::Range), (1.0, Limit::Range)]);
}

/// A long crank turns as far as the rod is upright; one of the length of the rod, on its pin from ±90° on, can turn on without the piston.
#[test]
fn analytic_crank_longer_than_the_rod_does_not_turn_round() {
    let mut scene = piston::Free { r: 0.9, l: 0.6, ..piston::Free::default() };
    let found = of(&scene, &[axis("crank.phi", -3.0, 3.0, 60)], &[], &[]).unwrap();
    let limit = (0.6_f64 / 0.9).asin();
    check_range(&found, [-limit, limit]);
    scene = piston::Free { r: 0.5, l: 0.5, second: -0.5, ..scene };
    let found = of(&scene, &[axis("crank.phi", -2.0, 2.0, 40)], &[], &[]).unwrap();
    assert_eq!(found.singular.len(), 2, "{:?}", found.singular);
    for (singular, expected) in found.singular.iter().zip([-FRAC_PI_2, FRAC_PI_2]) {
        assert_eq!(singular.kind, Singularity::ChangePoint);
        near(singular.value, expected, VALUE);
        near(singular.q[6], 0.0, VALUE);
    }
}

/// The rows over y and φ are [0, s]/√(1 + s²) and [1, −c]/√(1 + c²), with lengths in l.
#[test]
fn analytic_smallest_singular_value_of_a_pinned_rod() {
    let l = pinned::Upright::default().l;
    let axes = [axis("rod.x", -1.0, 1.0, 40)];
    let found = of(&pinned::Upright::default(), &axes, &[], &[]).unwrap();
    check_range(&found, [-l, l]);
    for branch in &found.branches {
        let reached = axes[0].values.iter().zip(&branch.positions).enumerate().filter(|(_, (_, q))| q.is_some());
        for (i, (x, _)) in reached {
            let c = x / l;
            if 1.0 - c.abs() <= ROUNDING {
                near(branch.smallest_singular_value[i], 0.0, AT_DEAD_CENTRE);
                continue;
            }
            let s2 = 1.0 - c * c;
            let (trace, det2) = (s2 / (1.0 + s2) + 1.0, s2 / ((1.0 + s2) * (1.0 + c * c)));
            let smallest = ((trace - (trace * trace - 4.0 * det2).sqrt()) / 2.0).sqrt();
            near(branch.smallest_singular_value[i], smallest, PLACE);
            // dφ = −dx/(l s), dy = −dx c/s
            near(branch.transmission[i] * s2.sqrt(), (1.0 + c * c).sqrt(), PLACE);
        }
    }
    // from the dead centre itself
    let found = of(&pinned::Level::default(), &axes, &[], &[]).unwrap();
    check_range(&found, [-l, l]);
}

#[test]
fn analytic_arm_reaches_a_ring() {
    for bend in [1.5, -1.5] {
        let scene = links::Free { bend, ..links::Free::default() };
        let (l1, l2) = (scene.l1, scene.l2);
        let mut system = System::new(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let n = 40;
        let axes = [axis("fore.x", -1.0, 1.0, n), axis("fore.y", -1.0, 1.0, n)];
        let found = Workspace::of(&mut system, &start, &axes, &[], &[]).unwrap();
        let [branch] = &found.branches[..] else { panic!("{} branches", found.branches.len()) };
        let mut n_reached = 0;
        for (i, q) in branch.positions.iter().enumerate() {
            let (x, y) = (axes[0].values[i / (n + 1)], axes[1].values[i % (n + 1)]);
            let distance = x.hypot(y);
            let inside = (distance - (l1 - l2)).min(l1 + l2 - distance);
            if inside.abs() <= VALUE {
                continue;
            }
            assert_eq!(q.is_some(), inside > 0.0, "({x}, {y})");
            assert_eq!(branch.smallest_singular_value[i].is_nan(), q.is_none());
            let Some(q) = q else { continue };
            n_reached += 1;
            let elbow = q[5] - q[2];
            near(elbow.cos(), (distance * distance - l1 * l1 - l2 * l2) / (2.0 * l1 * l2), PLACE);
            assert_eq!(elbow.sin().signum(), bend.signum());
            let expected = smallest_of_links([l1, l2], [q[2], q[5]], 0.5);
            near(branch.smallest_singular_value[i], expected, PLACE);
        }
        assert!(n_reached > 900, "{n_reached}");
    }
}

/// Smallest singular value of the rows of shoulder and elbow over the place of the upper arm and both angles, from the eigenvalues of A Aᵀ. The rows are
/// −r₁, and r₁ + l₁ e(φ₁) − r₂ + l₂ e(φ₂).
fn smallest_of_links([l1, l2]: [f64; 2], [phi1, phi2]: [f64; 2], length: f64) -> f64 {
    let row = |by_angles: [f64; 2]| {
        // also over the place of the tip
        let norm = (2.0 * length * length + by_angles[0].powi(2) + by_angles[1].powi(2)).sqrt();
        (length / norm, by_angles.map(|x| x / norm))
    };
    let (x, [x1, x2]) = row([-l1 * phi1.sin(), -l2 * phi2.sin()]);
    let (y, [y1, y2]) = row([l1 * phi1.cos(), l2 * phi2.cos()]);
    #[rustfmt::skip]
    let a = Matrix4::new(
        -1.0, 0.0, 0.0, 0.0,
        0.0, -1.0, 0.0, 0.0,
        x, 0.0, x1, x2,
        0.0, y, y1, y2,
    );
    (a * a.transpose()).symmetric_eigenvalues().min().max(0.0).sqrt()
}

#[test]
fn invariant_what_cannot_be_held_is_named() {
    let crank = [axis("crank.phi", 1.0, 2.0, 4)];
    let refused = |found: Result<Workspace, AnalysisError>| found.unwrap_err().to_string();
    let driven = bars::Driven::default();
    let why = refused(of(&driven, &crank, &[], &[]));
    assert!(why.contains("prescribed by `turns`") && why.contains("`crank.phi`"), "{why}");
    let free = of(&bars::Free::default(), &crank, &[], &[]).unwrap();
    assert_eq!(of(&driven, &crank, &[], &["turns"]).unwrap(), free);
    let why = refused(of(&bars::Free::default(), &[axis("crank.x", -1.0, 1.0, 4)], &[], &[]));
    assert!(why.contains("`crank.x` cannot take other values"), "{why}");
    let both = [axis("crank.phi", 1.0, 2.0, 4), axis("rocker.phi", 1.0, 2.0, 4)];
    let why = refused(of(&bars::Free::default(), &both, &[], &[]));
    assert!(why.contains("`crank.phi`, `rocker.phi` cannot take other values"), "{why}");
    let tip = [axis("fore.x", 0.4, 0.6, 4)];
    let why = refused(of(&links::Free::default(), &tip, &[], &[]));
    assert!(why.contains("has 2 degrees of freedom") && why.contains(".phi`"), "{why}");
    let found = of(&links::Free::default(), &tip, &["fore.phi"], &[]).unwrap();
    assert!(found.branches[0].positions.iter().flatten().all(|q| q[5] == 1.5));
    let why = refused(of(&links::Free::default(), &tip, &["fore.x"], &[]));
    assert!(why.contains("`fore.x`, which is named twice"), "{why}");
    let why = refused(of(&links::Free::default(), &[axis("fore.z", 0.0, 1.0, 4)], &[], &[]));
    assert!(why.contains("no coordinate `fore.z`"), "{why}");
    let why = refused(of(&links::Free::default(), &[axis("fore.x", 1.0, 0.0, 4)], &[], &[]));
    assert!(why.contains("the values of `fore.x`"), "{why}");
    assert!(refused(of(&links::Free::default(), &[], &[], &[])).contains("the number of them, 0"));
    assert!(refused(of(&driven, &crank, &[], &["turn"])).contains("no position row `turn`"));
}
