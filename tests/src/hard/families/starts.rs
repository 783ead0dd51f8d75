//! Starts that do not fulfil the rows.

use super::*;
use crate::hard::case::Check;
use ezy_core::dynamics::StartError;
use ezy_core::model::{Scene, Start};
use ezy_core::prelude::{Backend, Simulation, System};
use ezy_core::simulate::SetupError;
use ezy_models::{andrews, n_four_bar, pendulum};

/// Of the reference, m/s and rad/s.
const PROJECTED: f64 = 1e-12;
/// Of the reference, m.
const ASSEMBLED_GAP: f64 = 1e-13;
/// Of the reference, m and rad.
const CHANGE: f64 = 5e-3;
/// How far every coordinate is moved, m and rad.
const MOVED: f64 = 1e-3;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "inconsistent_velocities",
            "every body of the linkage has a velocity of its own; the smallest change in the metric of the masses is the impulse of the hinges",
            true,
            |_| velocities(),
        ),
        case(
            "inconsistent_positions",
            "every coordinate of A01, A02 and A03 is off by 1e-3, with alternating signs; Andrews' links are a few centimetres long",
            true,
            |_| positions(),
        ),
    ]
}

fn velocities() -> Findings {
    let subject = subject("torture", "inconsistent_velocities");
    let scene = &*subject.scene;
    let mut system = System::new(scene, Backend::Auto).expect("a scene that can be set up");
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
    let held = subject.given().into_iter().fold(Simulation::new(scene), |order, (name, value)| order.give(name, value));
    let refused = matches!(held.until(0.0).run(), Err(SetupError::Start(StartError::Contradiction { .. })));
    let checks = vec![
        Check::new("velocities, m/s, rad/s", PROJECTED, error),
        Check::new("starts that hold them and are accepted", 0.0, f64::from(u8::from(!refused))),
    ];
    Findings { checks, by: "the assembly of a start".to_owned(), ..Findings::default() }
}

fn positions() -> Findings {
    let scenes: [&dyn Scene; 3] =
        [&pendulum::Swing::default(), &n_four_bar::Fall::default(), &andrews::Squeeze::default()];
    let (mut gap, mut change) = (0.0, 0.0);
    for scene in scenes {
        let [left, moved] = assembled_from_nearby(scene);
        (gap, change) = (worse(gap, left), worse(change, moved));
    }
    let flat = flat_linkage();
    let checks = vec![
        Check::new("gaps after assembly, m", ASSEMBLED_GAP, gap),
        Check::new("largest change of a coordinate, m, rad", CHANGE, change),
        Check::new("A02 with level rods: gaps, m", ASSEMBLED_GAP, flat),
    ];
    Findings { checks, by: "the assembly of a start".to_owned(), ..Findings::default() }
}

/// Largest gap, and largest change of a coordinate, when the scene's own start is moved and assembled anew.
fn assembled_from_nearby(scene: &dyn Scene) -> [f64; 2] {
    let mut system = System::new(scene, Backend::Auto).expect("a scene that can be set up");
    let state = system.consistent_start(&system.scene_start()).expect("a consistent start");
    assembled(&mut system, scene, &state.q)
}

/// All rods level, each moved.
fn flat_linkage() -> f64 {
    let scene = n_four_bar::Fall::default();
    let scene: &dyn Scene = &scene;
    let mut system = System::new(scene, Backend::Auto).expect("a scene that can be set up");
    let centres = [0.5, 1.5, 2.5, 1.5, 2.5];
    let q: Vec<f64> = centres.into_iter().flat_map(|x| [x, 0.0, 0.0]).collect();
    assembled(&mut system, scene, &q)[0]
}

fn assembled<'s>(system: &mut System<'s, dyn Scene + 's>, scene: &dyn Scene, q: &[f64]) -> [f64; 2] {
    let info = system.info();
    let mut start = Start::free(info.n_coordinates());
    for (i, q) in q.iter().enumerate() {
        start.near_position(i, q + if i % 2 == 0 { MOVED } else { -MOVED });
    }
    let Ok(state) = system.consistent_start(&start) else { return [f64::NAN; 2] };
    let mut rows = vec![0.0; info.n_position_rows];
    scene.position_constraint(system.fixed(), 0.0, &state.q, &mut rows);
    let change = state.q.iter().zip(&start.q).map(|(new, old)| new - old).fold(0.0, worse);
    [rows.into_iter().fold(0.0, worse), change]
}
