//! Discontinuities of laws: steps end there.

use ezy_core::model::EventKind;
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{ezy_roller, skateboard};

model! {
    /// A block of 1 kg on a spring of 1 N/m, against a second spring of 3 N/m on its right, or with dry friction.
    pub model Block {
        param friction: N = 0.1;
        body block { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        param k: N/m = 1;
        force at block(0, 0): (-k * block.x, 0);
        effect buffer { force at block(0, 0): (-3 * k * max(block.x, 0), 0); }
        effect rubbing { force at block(0, 0): (-friction * sign(block.vx), 0); }
        param knee: m/s = 1e-4;
        effect smooth { friction at block(0, 0) along ground(1, 0): force friction, speed knee; }
        effect written { force at block(0, 0): (-friction * block.vx / sqrt(block.vx^2 + knee^2), 0); }
        start left { block x -1; at rest; }
        scene alone { start left; until 20 s; }
        scene between { start left; until 20 s; with buffer; }
        scene rubs { start left; until 12 s; with rubbing; }
        scene smoothed { start left; until 12 s; with smooth; }
        scene formula { start left; until 12 s; with written; }
    }
}

/// Tries at each of the 9 passages of the middle that are not taken: a step over it, a step over what is left, another that
/// knows better where it is, and one that is too long behind it.
const TRIES: u64 = 4;

/// The same for the implicit method, which comes nearer in four steps so as not to see what is behind: one try over it before
/// each, and up to three that are halved where steps are long.
const IMPLICIT_TRIES: u64 = 12;

/// What steps that are not infinitely small leave of an order.
const ORDER: f64 = 0.3;

/// The last step of a run is as long as what is left, that of a stepper as long as the others: rounding of 12 s.
const LAST_STEP: f64 = 1e-15;

/// A step errs by the tolerance at most, and the run takes so many at the coarsest one.
const STEPS: f64 = 60.0;

/// x in m and v in m/s at t, in s, between the springs: half a turn of 1 rad/s on the left, half a turn of 2 rad/s on the
/// right.
fn between_springs(t: f64) -> [f64; 2] {
    let half = std::f64::consts::FRAC_PI_2;
    // from the middle, to the right
    let s = (t + half).rem_euclid(3.0 * half) - 2.0 * half;
    if s < 0.0 { [s.sin(), s.cos()] } else { [0.5 * (2.0 * s).sin(), (2.0 * s).cos()] }
}

/// The same with dry friction: cosines about 0.1 m behind the middle, to and fro, each swing 0.2 m shorter.
fn rubbing(t: f64) -> [f64; 2] {
    let swing = (t / std::f64::consts::PI).floor();
    let towards = if swing % 2.0 == 0.0 { 1.0 } else { -1.0 };
    let (amplitude, s) = (0.9 - 0.2 * swing, t - swing * std::f64::consts::PI);
    [towards * (-0.1 - amplitude * s.cos()), towards * amplitude * s.sin()]
}

/// Far more steps than any run here takes: one whose steps become too short fails at once.
const MOST_STEPS: u64 = 100_000;

fn end(scene: &dyn Scene, method: Method) -> ([f64; 2], Run) {
    let run = simulation(scene).method(method).max_steps(MOST_STEPS).run().unwrap();
    let last = run.last();
    ([last.get("block.x").unwrap(), last.get("block.vx").unwrap()], run)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

#[test]
fn analytic_springs_that_meet_are_followed_as_well_as_one() {
    let exact = between_springs(20.0);
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        for (method, tries) in [(Method::dop853(tolerance), TRIES), (Method::radau(tolerance), IMPLICIT_TRIES)] {
            let (found, run) = end(&block::Between::default(), method);
            let (one, alone) = end(&block::Alone { k: 4.0, ..Default::default() }, method);
            let [error, of_one] = [distance(found, exact), distance(one, [-40f64.cos(), 2.0 * 40f64.sin()])];
            // twice the speed all of the time
            assert!(error <= 2.0 * of_one, "{method:?}: {error:.1e}, without a discontinuity {of_one:.1e}");
            assert!(run.cost.rejected <= alone.cost.rejected + tries * 9, "{method:?}: {:?}", run.cost);
        }
    }
}

#[test]
fn analytic_dry_friction_is_followed_through_every_reversal() {
    let exact = rubbing(12.0);
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        for method in [Method::dop853(tolerance), Method::radau(tolerance)] {
            let (found, run) = end(&block::Rubs::default(), method);
            let error = distance(found, exact);
            assert!(error <= STEPS * tolerance, "{method:?}: {error:.1e}, {:?}", run.cost);
        }
    }
}

/// Four lengths of steps: that a stage is beyond a discontinuity and the end is not happens at some.
#[test]
fn order_rk4_is_four_across_discontinuities() {
    let scenes: [(&dyn Scene, _); 2] =
        [(&block::Between::default(), between_springs(20.0)), (&block::Rubs::default(), rubbing(12.0))];
    for (scene, exact) in scenes {
        let errors = [0.02, 0.01, 0.005, 0.0025].map(|h| distance(end(scene, Method::rk4(h)).0, exact));
        let order = (errors[0] / errors[3]).log2() / 3.0;
        assert!((order - 4.0).abs() <= ORDER, "{}: order {order:.2}, {errors:?}", scene.info().name);
    }
}

/// Of a step that a discontinuity cuts, the rest ends where the step would have.
#[test]
fn invariant_discontinuities_leave_the_times_of_samples_and_steppers_alone() {
    let scene = block::Rubs::default();
    let run = simulation(&scene).method(Method::rk4(0.01)).every(0.02).run().unwrap();
    let mut stepper = simulation(&scene).method(Method::rk4(0.01)).stepper().unwrap();
    for (i, sample) in run.samples().enumerate() {
        assert_eq!(sample.t, i as f64 * 0.02);
        let State { t, q, .. } = stepper.state();
        assert_eq!(*t, sample.t);
        assert!((q[0] - sample.coordinates[0]).abs() <= LAST_STEP, "at {t} s");
        stepper.step(2).unwrap();
    }
}

#[test]
fn analytic_smoothed_friction_through_zero_speed_is_near_dry_friction() {
    let exact = rubbing(12.0);
    let (found, _) = end(&block::Smoothed::default(), Method::dop853(1e-9));
    // below 1e-4 m/s the force is not what it is: over 1e-4/0.9 s of each of three reversals, and quadratically beyond
    let error = distance(found, exact);
    assert!(error <= 1e-4, "{error:.1e}");
}

/// Pulses that begin and end 2,500 times a second, several to a step: a step that begins within rounding of one end and passes others has to come
/// to that end.
#[test]
fn cross_steps_over_several_discontinuities_end_at_the_first() {
    let scene = skateboard::Ridden {
        m_rider: 3.826_724_731_516_005_5e-2,
        j_rider: 5.442_617_521_904_539e-3,
        m_truck: 240.206_981_404_326_27,
        nu_push: 7.984_072_692_297_641e3,
        ..skateboard::Ridden::default()
    };
    let end = |method: Method| {
        let order = simulation(&scene).method(method).until(0.02).project_start().max_steps(MOST_STEPS);
        let given =
            [("rear.vx", 6.374_253_553_551_820_6e-3), ("rear.vy", 1.0), ("rear.omega", 1.486_840_858_291_516e-2)];
        let run = given.iter().fold(order, |order, given| order.start(given.0, given.1)).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        (run.last().coordinates.to_vec(), run.cost.steps)
    };
    let (reference, _) = end(Method::dop853(1e-11));
    for tolerance in [1e-6, 1e-8] {
        let (found, n_steps) = end(Method::radau(tolerance));
        let error = reference.iter().zip(&found).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
        assert!(error <= n_steps as f64 * tolerance, "{error:.1e} at {tolerance:.0e}, {n_steps} steps");
    }
}

/// Steps that are short beside the layer are those of the same law as a formula, of which nothing is known.
#[test]
fn invariant_resolved_friction_costs_dop853_no_steps() {
    let cost = |scene: &dyn Scene, tolerance: f64| {
        let cost = end(scene, Method::dop853(tolerance)).1.cost;
        [cost.steps, cost.rejected]
    };
    let knee = 0.5;
    let smoothed = block::Smoothed { knee, ..block::Smoothed::default() };
    let formula = block::Formula { knee, ..block::Formula::default() };
    for tolerance in [1e-6, 1e-8, 1e-10] {
        assert_eq!(cost(&smoothed, tolerance), cost(&formula, tolerance), "at {tolerance:.0e}");
    }
}

#[test]
fn invariant_discontinuities_are_listed_once_and_are_no_events_of_a_run() {
    let info = Scene::info(&block::Between::default());
    let discontinuities: Vec<&str> = info.events.iter().map(|event| event.name).collect();
    assert_eq!(discontinuities, ["block.x"]);
    assert!(info.events.iter().all(|event| event.kind == EventKind::Discontinuity));
    let (_, run) = end(&block::Between::default(), Method::dop853(1e-6));
    assert!(run.events().is_empty());
    let smoothed = Scene::info(&block::Smoothed::default());
    assert!(smoothed.events.iter().map(|event| event.kind).eq([EventKind::Layer]), "{:?}", smoothed.events);
    let (_, run) = end(&block::Smoothed::default(), Method::dop853(1e-6));
    assert!(run.events().is_empty());
    assert!(Scene::info(&ezy_roller::Driven::default()).events.is_empty());
}
