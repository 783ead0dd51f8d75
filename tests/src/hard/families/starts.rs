//! Starts that do not fulfil the rows.

use super::*;
use ezy_core::dynamics::StartError;
use ezy_core::model::{Scene, Start};
use ezy_core::prelude::{Backend, System};
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};
use ezy_models::{andrews, n_four_bar, pendulum};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// Of the reference, m/s and rad/s.
const PROJECTED: f64 = 1e-12;
/// Of the reference, m.
const ASSEMBLED_GAP: f64 = 1e-13;
/// Of the reference, m and rad.
const CHANGE: f64 = 5e-3;
/// How far every coordinate is moved, m and rad.
const MOVED: f64 = 1e-3;

/// Two links of a loop that meet: each by its body and its direction in the body, along the loop, rad.
type Elbow = [(usize, f64); 2];

/// K2 and K3 in E, K4 and K5 in G, K6 and K7 in H. The crank K1 starts in line with K2: F is no elbow with a side.
const ANDREWS_ELBOWS: [Elbow; 3] = [[(1, PI), (2, FRAC_PI_2)], [(3, FRAC_PI_2), (4, PI)], [(5, PI), (6, FRAC_PI_2)]];

pub fn cases() -> Vec<Case> {
    vec![
        assembly(
            "inconsistent_velocities",
            "every body of the linkage has a velocity of its own; the smallest change in the metric of the masses is the impulse of the hinges",
            velocities,
        ),
        assembly(
            "inconsistent_positions",
            "every coordinate of A01, A02 and A03 is off by 1e-3, with alternating signs; Andrews' links are a few centimetres long",
            positions,
        ),
    ]
}

/// No motion is computed.
fn assembly(name: &str, why: &'static str, examine: fn() -> Findings) -> Case {
    Case { by: By::Nothing, ..case(name, why, UNSTATED, Pace::Quick, move |_| examine()) }
}

fn velocities() -> Findings {
    let subject = subject("torture", "inconsistent_velocities");
    let scene = &*subject.scene;
    let mut system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
    let mut start = Start::free(system.info().n_coordinates());
    for (i, (name, value)) in subject.given().iter().enumerate() {
        let body = name.rsplit_once('.').map_or("", |(body, _)| body);
        let at = 3 * system.info().bodies.iter().position(|of| *of == body).unwrap_or_default() + i % 3;
        if i % 6 < 3 { start.give_position(at, *value) } else { start.near_velocity(at, *value) }
    }
    let expected = &subject.data["projected_mass_metric"];
    let error = system.consistent_start(&start).map_or(f64::NAN, |state| {
        let of = |body: &str, k: usize| state.v[subject.first_coordinate(body) + k] - number(&expected[body][k]);
        bodies(&subject)
            .iter()
            .flat_map(|body| (0..3).map(move |k| (body, k)))
            .map(|(body, k)| of(body, k))
            .fold(0.0, worse)
    });
    let held = subject.given().into_iter().fold(simulation(scene), |order, (name, value)| order.start(name, value));
    let refused = matches!(held.until(0.0).run(), Err(SetupError::Start(StartError::Contradiction { .. })));
    let checks = vec![
        Check::new("velocities, m/s, rad/s", PROJECTED, error),
        Check::new("starts that hold them and are accepted", 0.0, f64::from(u8::from(!refused))),
    ];
    Findings { checks, ..Findings::default() }
}

fn positions() -> Findings {
    let parallelogram = n_four_bar::Fall::default();
    let (n, mut elbows) = (parallelogram.n, Vec::new());
    for i in 0..n {
        let coupler = n + 1 + i;
        elbows.push([(i, 0.0), (coupler, 0.0)]);
        elbows.push([(coupler, 0.0), (i + 1, PI)]);
    }
    let scenes: [(&dyn Scene, &[Elbow]); 3] = [
        (&pendulum::Swing::default(), &[]),
        (&parallelogram, &elbows),
        (&andrews::Squeeze::default(), &ANDREWS_ELBOWS),
    ];
    let (mut gap, mut change, mut folded) = (0.0, 0.0, 0.0);
    for (scene, elbows) in scenes {
        let [left, moved, over] = assembled_from_nearby(scene, elbows);
        (gap, change, folded) = (worse(gap, left), worse(change, moved), worse(folded, over));
    }
    let flat = flat_linkage();
    let checks = vec![
        Check::new("gaps after assembly, m", ASSEMBLED_GAP, gap),
        Check::new("largest change of a coordinate, m, rad", CHANGE, change),
        Check::new("elbows of loops that changed their side", 0.0, folded),
        Check::new("A02 with level rods: gaps, m", ASSEMBLED_GAP, flat),
    ];
    Findings { checks, ..Findings::default() }
}

/// Largest gap, largest change of a coordinate, and elbows that changed their side, when the scene's own start is moved
/// and assembled anew.
fn assembled_from_nearby(scene: &dyn Scene, elbows: &[Elbow]) -> [f64; 3] {
    let mut system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
    let state = system.consistent_start(&system.scene_start()).expect("a consistent start");
    assembled(&mut system, scene, &state.q, elbows)
}

/// All rods level, each moved.
fn flat_linkage() -> f64 {
    let scene = n_four_bar::Fall::default();
    let scene: &dyn Scene = &scene;
    let mut system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
    let centres = [0.5, 1.5, 2.5, 1.5, 2.5];
    let q: Vec<f64> = centres.into_iter().flat_map(|x| [x, 0.0, 0.0]).collect();
    assembled(&mut system, scene, &q, &[])[0]
}

fn assembled(system: &mut System<&dyn Scene>, scene: &dyn Scene, q: &[f64], elbows: &[Elbow]) -> [f64; 3] {
    let info = Arc::clone(system.info());
    let mut start = Start::free(info.n_coordinates());
    for (i, q) in q.iter().enumerate() {
        start.near_position(i, q + if i % 2 == 0 { MOVED } else { -MOVED });
    }
    let Ok(state) = system.consistent_start(&start) else { return [f64::NAN; 3] };
    let mut rows = vec![0.0; info.n_position_rows];
    scene.position_constraint(system.fixed(), 0.0, &state.q, &mut rows);
    let change = state.q.iter().zip(&start.q).map(|(new, old)| new - old).fold(0.0, worse);
    let folded = elbows.iter().filter(|elbow| side(elbow, q) * side(elbow, &state.q) <= 0.0).count();
    [rows.into_iter().fold(0.0, worse), change, folded as f64]
}

/// Positive where the second link turns off to the left of the first, negative to the right.
fn side(elbow: &Elbow, q: &[f64]) -> f64 {
    let [first, second] = elbow.map(|(body, direction)| q[3 * body + 2] + direction);
    (second - first).sin()
}
