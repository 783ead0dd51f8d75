//! Steps next to a flat position of a parallelogram, and what is remembered of them.

use super::*;
use crate::dynamics::system_of;
use crate::integrate::{MethodKind, Tolerance};
use crate::linalg::Backend;
use crate::model::Scene;

crate::model! {
    /// A parallelogram without forces: it turns uniformly.
    pub model Parallelogram {
        body left { mass: 1, inertia: 1/12 }
        body right { mass: 1, inertia: 1/12 }
        body bar { mass: 2, inertia: 0.7 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: left(0.5, 0) ~ bar(-1, 0);
        hinge C: right(0.5, 0) ~ bar(1, 0);
        hinge D: ground(2, 0) ~ right(-0.5, 0);
        start below { left angle -0.3 rate 1; right near angle -0.3; bar near angle 0; }
        scene turns { start below; until 1 s; }
    }
}

/// At 1 s, at this angle to the flat position, turning by 1 rad/s; evaluated.
fn at(scene: &parallelogram::Turns, angle: f64) -> StepperState<&dyn Scene> {
    let system = system_of(scene, Backend::Auto).unwrap();
    let mut stepper = StepperState::new(system, Method::taylor(1e-6), Projection::Both, Metric::Mass, false).unwrap();
    let (sin, cos) = angle.sin_cos();
    let (x, y) = (0.5 * cos, 0.5 * sin);
    let q = vec![x, y, angle, 2.0 + x, y, angle, 1.0 + 2.0 * x, 2.0 * y, 0.0];
    let v = vec![-y, x, 1.0, -y, x, 1.0, -2.0 * y, 2.0 * x, 0.0];
    stepper.place(&State { t: 1.0, q, v, z: Vec::new(), work: Vec::new() });
    stepper.evaluate_now().unwrap();
    stepper
}

/// A step that would end in the flat position, 0.3 s away, is taken again a tenth shorter. Then it ends 0.03 rad beside it.
#[test]
fn analytic_step_to_a_flat_position_is_taken_again_shorter() {
    let scene = parallelogram::Turns::default();
    let mut stepper = at(&scene, -0.3);
    stepper.advance(0.3, 1.3).unwrap();
    let State { t, q, .. } = &stepper.next.state;
    assert!((t - (1.0 + 0.3 * SHORTENED)).abs() <= 1e-15 && (q[2] - (t - 1.3)).abs() <= 1e-6, "{t} {q:?}");
    assert_eq!(stepper.singular_positions.n_shortened, 1);
}

/// Steps of 0.1 s, far from the flat position: the first one is usual, and a longer length that was usual falls by a tenth of it.
#[test]
fn analytic_usual_length_falls_by_a_part_of_each_shorter_step() {
    let scene = parallelogram::Turns::default();
    for (before, after) in [(0.0, 0.1), (0.05, 0.1), (0.5, 0.49)] {
        let mut stepper = at(&scene, 0.5);
        stepper.singular_positions.usual_s = before;
        stepper.advance(0.1, 1.1).unwrap();
        assert!(
            (stepper.singular_positions.usual_s - after).abs() <= 1e-15,
            "{before}: {}",
            stepper.singular_positions.usual_s
        );
    }
}

/// Steps below 1e-4 of the usual one creep next to the flat position, unless something else ends them there.
#[test]
fn analytic_steps_creep_next_to_a_flat_position() {
    let scene = parallelogram::Turns::default();
    for (angle, length, t_next, creeps) in [
        (0.01, 0.99e-5, 1.1, true),
        (0.01, 1.01e-5, 1.1, false),
        (0.01, 0.99e-5, 1.0 + 0.99e-5, false),
        (0.5, 0.99e-5, 1.1, false),
    ] {
        let mut stepper = at(&scene, angle);
        (stepper.singular_positions.usual_s, stepper.next.state.t) = (0.1, 1.0 + length);
        let StepperState { system, singular_positions, now, next, .. } = &mut stepper;
        assert_eq!(
            singular_positions.creeps(system, &now.state, &next.state, t_next),
            creeps,
            "{angle} {length:e} {t_next}"
        );
    }
}

crate::model! {
    /// A pendulum that a motor turns, with the current of its coil.
    pub model Charged {
        body rod { mass: 1, inertia: 0.2 }
        hinge pin: ground(0, 0) ~ rod(-0.4, 0);
        gravity (0, -9.81);
        state current: A = 0.3 rate 4 (A/s)*cos(rod.phi) - 2 (1/s)*current - 0.5 (A/rad)*rod.omega;
        torque rod: 2 (N*m/A)*current;
        start aside { rod angle 0.5; at rest; }
        scene swings { start aside; until 2 s; }
    }
}

/// After each of some steps: another one goes on with the same bits.
fn goes_on_to_the_last_bit<S: Scene>(scene: &S, start: &State, kind: MethodKind) {
    let method = kind.with_step(0.01).or(kind.with_tolerance(Tolerance::new(1e-7, 1e-7))).unwrap();
    let new = || {
        let system = system_of(scene, Backend::Auto).unwrap();
        StepperState::new(system, method, Projection::Both, Metric::Mass, true).unwrap()
    };
    let mut first = new();
    first.place(start);
    first.evaluate_now().unwrap();
    let step = |stepper: &mut StepperState<_>| {
        let now = stepper.now.state.t;
        stepper.advance(0.01, if stepper.chooses_steps() { 3.0 } else { now + 0.01 }).unwrap();
        stepper.evaluate_next().unwrap();
        stepper.accept();
        (stepper.now.state.clone(), stepper.n_rejected())
    };
    for n in 0..60 {
        let mut archive = Archive::new();
        first.remember(&mut archive).unwrap();
        let (numbers, scalars) = archive.into_parts();
        let (mut other, mut archive) = (new(), Archive::of(numbers, scalars));
        other.remember(&mut archive).unwrap();
        assert!(archive.is_read_whole(), "{kind:?}");
        let one = step(&mut first);
        assert_eq!(one, step(&mut other), "{kind:?}, step {n}");
        assert_eq!(step(&mut first), step(&mut other), "{kind:?}, behind step {n}");
        if one.0.t > 2.0 {
            break;
        }
    }
    assert!(first.now.state.z.iter().zip(&start.z).all(|(z, start)| z != start), "{kind:?}");
}

/// By every method, over the flat position at 0.3 s.
#[test]
fn invariant_what_is_remembered_goes_on_to_the_last_bit() {
    let scene = parallelogram::Turns::default();
    let start = at(&scene, -0.3).now.state;
    MethodKind::ALL.iter().copied().for_each(|kind| goes_on_to_the_last_bit(&scene, &start, kind));
}

/// By every method that integrates them.
#[test]
fn invariant_remembered_first_order_states_go_on_to_the_last_bit() {
    let scene = charged::Swings::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let takes_states = |kind: &MethodKind| kind.info().takes_states;
    MethodKind::ALL.iter().copied().filter(takes_states).for_each(|kind| goes_on_to_the_last_bit(&scene, &start, kind));
}

crate::model! {
    /// Two bodies on a skate each, hinged, with a torque between them: the roller racer.
    pub model Racer {
        body seat { mass: 46, inertia: 10 }
        body bar { mass: 1, inertia: 0.005 }
        hinge B: seat(0.6, 0) ~ bar(-0.1, 0);
        skate rear: at seat(-0.2, 0) along seat(1, 0);
        skate ahead: at bar(0.1, 0) along bar(1, 0);
        effect pump { torque seat ~ bar: (2 N*m) * cos(pi * (t / (1 s))); }
        start folded { seat at (0, 0) angle 0; bar angle 2; seat velocity (1, _); }
        scene rides { start folded; until 3 s; with pump; }
    }
}

/// In quasi-velocities, too.
#[test]
fn invariant_remembered_quasi_velocities_go_on_to_the_last_bit() {
    let scene = racer::Rides::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    MethodKind::ALL.iter().copied().for_each(|kind| goes_on_to_the_last_bit(&scene, &start, kind));
}

/// Steps of DOP853 need no projection where they begin on the rows; off them, be it by 5e-12 of a velocity, they are those of rows. So are steps that are
/// not to be projected, or in another metric.
#[test]
fn invariant_steps_in_quasi_velocities_are_projected_steps_from_the_rows() {
    let scene = racer::Rides::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let keeps_rows = |projection: Projection, metric: Metric, change: f64| {
        let system = system_of(&scene, Backend::Auto).unwrap();
        let mut stepper = StepperState::new(system, Method::dop853(1e-9), projection, metric, false).unwrap();
        let mut start = start.clone();
        start.v[0] += change;
        stepper.place(&start);
        stepper.evaluate_now().unwrap();
        stepper.advance(0.01, 3.0).unwrap();
        stepper.method.integrator.keeps_rows()
    };
    assert!(keeps_rows(Projection::Both, Metric::Mass, 0.0));
    for (projection, metric, change) in [
        (Projection::Both, Metric::Mass, 5e-12),
        (Projection::Both, Metric::Euclidean, 0.0),
        (Projection::Velocities, Metric::Mass, 0.0),
        (Projection::None, Metric::Mass, 0.0),
    ] {
        assert!(!keeps_rows(projection, metric, change), "{projection:?} {metric:?} {change}");
    }
}

/// The length that a step is to begin with holds in quasi-velocities, too: it is far below what the method would choose.
#[test]
fn invariant_first_step_in_quasi_velocities_has_the_length_that_is_given() {
    let scene = racer::Rides::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let mut stepper = StepperState::new(system, Method::dop853(1e-9), Projection::Both, Metric::Mass, false).unwrap();
    stepper.place(&start);
    stepper.evaluate_now().unwrap();
    stepper.method.integrator.restart_with(1e-4);
    stepper.advance(1.0, 3.0).unwrap();
    assert_eq!(stepper.next.state.t, 1e-4);
}
