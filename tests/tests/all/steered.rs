//! Inputs by acceleration: a controller steers what constraints follow.

use crate::scenes::{assert_checks, distance};
use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason, read_inputs};
use ezy_core_tests::{simulation, system_of};

model! {
    /// A pendulum on an arm that a motor turns: as a controller says, or as a function of time does.
    pub model Crane {
        param w: rad/s = 2;
        param c: rad/s^2 = 0.4;
        input angle: rad = 0.2 by acceleration;
        input wind: N = 0;
        body arm { mass: 2, inertia: 0.4 }
        body bob { mass: 1, inertia: 0.1 }
        hinge pin: arm(-0.3, 0) ~ ground(0, 0);
        hinge joint: arm(0.3, 0) ~ bob(0, 0.4);
        gravity (0, -9.81);
        force at bob(0, 0): (wind, 0);
        output place: rad = angle;
        output speed: rad/s = angle_rate;
        effect motor { drive turning: arm.phi = angle; }
        effect wave { drive waving: arm.phi = 0.2 + 0.5 * sin(w * t); }
        effect ramp { drive ramping: arm.phi = 0.2 + 0.3 * t + 0.5 * c * t^2; }
        start hanging { arm angle 0.2; bob angle 0.1; bob rate 0; }
        scene steered { start hanging; until 2 s; with motor; }
        scene waved { start hanging; until 2 s; with wave; }
        scene ramped { start hanging; until 2 s; with ramp; }
    }
}

model! {
    /// A rod whose length is set in mm, and pendulums on it.
    pub model Lift {
        count n = 2;
        input length: mm = 500 by acceleration;
        body link[n] { mass: 1, inertia: 0.1 }
        rod rope: ground(0, 0) ~ link[0](0, 0.2) length length;
        for i in 1..n { hinge pin[i]: link[i-1](0, -0.2) ~ link[i](0, 0.2); }
        gravity (0, -9.81);
        start hanging { link[0] at (0, -0.7) angle 0; for i in 1..n { link[i] angle 0.1; } }
        scene lifted { start hanging; until 1 s; }
    }
}

model! {
    /// Two of them, one by one, whose rope shortens by itself.
    pub model Winch {
        body first { mass: 1, inertia: 0.1 }
        body second { mass: 1, inertia: 0.1 }
        rod rope: ground(0, 0) ~ first(0, 0.2) length 0.5 + 0.02 * t - 0.1 * t^2;
        hinge pin: first(0, -0.2) ~ second(0, 0.2);
        gravity (0, -9.81);
        start hanging { first at (0, -0.7) angle 0; second angle 0.1; }
        scene lifted { start hanging; until 1 s; }
    }
}

/// Runs at 1e-12 over 2 s.
const METHOD: f64 = 1e-10;
/// RK4 at 1 ms over 2 s.
const FIXED: f64 = 1e-9;
/// About 1 ms, and a whole number of steps in 2 s.
const STEP: f64 = 1.0 / 1024.0;

fn steered(scene: &crane::Steered) -> Simulation<'_, &crane::Steered> {
    Simulation::new(scene).method(Method::rk4(STEP)).work().outputs()
}

fn bits(sample: Sample<'_>) -> Vec<u64> {
    sample.numbers().map(f64::to_bits).collect()
}

#[test]
fn fd_steered_scenes_pass_their_checks() {
    assert_checks(&crane::Steered::default());
    assert_checks(&lift::Lifted::default());
}

#[test]
fn cross_steady_acceleration_is_a_parabola_of_time_by_every_method() {
    let end = |scene: &dyn Scene, method| {
        let simulation = simulation(scene).work().method(method);
        let simulation = match scene.info().name {
            "steered" => simulation.input("angle_rate", 0.3).input("angle_acceleration", 0.4),
            _ => simulation,
        };
        let run = simulation.run().unwrap();
        assert!(run.last().energy.balance.abs() <= FIXED, "{:.1e} J", run.last().energy.balance);
        run.last().coordinates.to_vec()
    };
    for method in
        [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12), Method::rk4(STEP)]
    {
        let ends = [end(&crane::Steered::default(), method), end(&crane::Ramped::default(), method)];
        let error = distance(&ends[0], &ends[1]);
        assert!(error <= METHOD, "{method:?}: {error:.1e}");
    }
}

#[test]
fn order_steered_motion_approaches_a_function_of_time() {
    let (by_law, by_time) = (crane::Steered::default(), crane::Waved::default());
    let w = by_time.w;
    let reference = simulation(&by_time).method(Method::dop853(1e-12)).run().unwrap();
    let rate = move |t: f64| 0.5 * w * (w * t).cos();
    let errors = [0.02, 0.01, 0.005].map(|h| {
        let run = Simulation::new(&by_law).method(Method::rk4(h)).work().input("angle_rate", rate(0.0));
        // its mean over the step, so that the rate is right at the end of each
        let run = run.control(move |now, set| set.angle_acceleration = (rate(now.t + h) - rate(now.t)) / h);
        let run = run.run().unwrap();
        assert!(run.last().energy.balance.abs() <= 1e-6 * (h / 0.005_f64).powi(4), "{:.1e}", run.last().energy.balance);
        distance(run.last().coordinates, reference.last().coordinates)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
}

#[test]
fn invariant_steered_run_keeps_constraints_and_energy() {
    let scene = crane::Steered::default();
    let law = |now: &Now<crane::Steered>, set: &mut Inputs<crane::Steered>| {
        let goal = if now.t < 1.0 { 0.7 } else { -0.1 };
        set.angle_acceleration = 64.0 * (goal - set.angle) - 16.0 * set.angle_rate;
    };
    let run = steered(&scene).every(0.0301).control(law).run().unwrap();
    for s in run.samples() {
        assert!(s.energy.balance.abs() <= METHOD, "{:.1e} J at {} s", s.energy.balance, s.t);
        // what is recorded is where the drive is then, also between steps
        for (column, arm) in [("input.angle", "arm.phi"), ("input.angle_rate", "arm.omega")] {
            let error = s.get(column).unwrap() - s.get(arm).unwrap();
            assert!(error.abs() <= METHOD, "{column}: {error:.1e} at {} s", s.t);
        }
        assert!((s.get("output.place").unwrap() - s.get("arm.phi").unwrap()).abs() <= METHOD);
        assert!((s.get("output.speed").unwrap() - s.get("arm.omega").unwrap()).abs() <= METHOD);
    }
    assert!(run.last().get("arm.phi").unwrap() < 0.0);
}

#[test]
fn invariant_controllers_by_name_by_index_and_of_a_stepper_give_the_same_bits() {
    let scene = crane::Steered::default();
    let by_name = steered(&scene).control(|now, set| {
        set.angle_acceleration = 9.0 * (0.5 - set.angle) - 6.0 * set.angle_rate;
        set.wind = now.bob.vx;
    });
    let by_index = steered(&scene).control_by_index(|_, state, inputs| {
        inputs[2] = 9.0 * (0.5 - inputs[0]) - 6.0 * inputs[1];
        inputs[4] = state.v[3];
    });
    let (by_name, by_index) = (by_name.run().unwrap(), by_index.run().unwrap());
    assert_eq!(bits(by_name.last()), bits(by_index.last()));
    let mut stepper = steered(&scene).stepper().unwrap();
    for _ in 0..2 {
        for _ in 0..2048 {
            let wind = stepper.now().bob.vx;
            let mut set = stepper.set();
            set.angle_acceleration = 9.0 * (0.5 - set.angle) - 6.0 * set.angle_rate;
            set.wind = wind;
            drop(set);
            stepper.step(1).unwrap();
        }
        assert_eq!(stepper.state().q, by_name.last().coordinates);
        stepper.reset();
    }
}

#[test]
fn invariant_value_that_jumps_is_refused_in_words() {
    let scene = crane::Steered::default();
    let run = steered(&scene).control(|now, set| set.angle = if now.t < 0.5 { set.angle } else { 0.5 }).run().unwrap();
    let text = run.outcome.to_string();
    for words in
        ["input `angle` is 0.2 rad at t = 0.5 s and was set to 0.5 rad", "by 3.0e-1 rad", "set.angle_acceleration"]
    {
        assert!(text.contains(words), "{text}");
    }
    assert!(matches!(run.outcome, Outcome::Stopped { reason: StopReason::Motion(MotionError::InputJumps { .. }), .. }));
    let first = steered(&scene).control(|_, set| set.angle_rate = 0.5).run().unwrap_err().to_string();
    assert!(first.contains("input `angle_rate` is 0 rad/s at t = 0 s and was set to 0.5 rad/s"), "{first}");

    let mut stepper = steered(&scene).stepper().unwrap();
    stepper.step(10).unwrap();
    stepper.inputs_mut()[0] = 0.25;
    // looking at it again does not make it right
    stepper.inputs_mut()[4] = 1.0;
    let before = stepper.state().clone();
    for _ in 0..2 {
        assert!(matches!(stepper.step(1), Err(MotionError::InputJumps { name: "angle", .. })));
    }
    assert_eq!(stepper.state(), &before);
    stepper.set().angle = 0.2;
    stepper.step(1).unwrap();
    stepper.set().angle_since = 0.0;
    assert!(matches!(stepper.step(1), Err(MotionError::InputJumps { name: "angle_since", input: "angle", .. })));
    stepper.reset();
    stepper.step(1).unwrap();
}

#[test]
fn invariant_tables_of_values_and_starts_elsewhere_are_refused() {
    let scene = crane::Steered::default();
    let table = || InputTable::new(vec![0.0, 1.0], vec![0.2, 0.5]).unwrap();
    let error = steered(&scene).input("angle", table()).run().unwrap_err();
    assert!(matches!(error, SetupError::IntegratedInput { name: "angle", input: "angle" }));
    assert!(error.to_string().contains("`angle_acceleration`"), "{error}");
    assert!(steered(&scene).input("angle", 0.3).run().is_err(), "the start gives the arm an angle of 0.2");
    let run = steered(&scene).input("angle", 0.3).start("arm.phi", 0.3).until(0.1).run().unwrap();
    assert!((run.last().get("arm.phi").unwrap() - 0.3).abs() <= METHOD);
}

#[test]
fn cross_file_of_a_steered_run_repeats_it() {
    let scene = crane::Steered::default();
    let mut file = Vec::new();
    let mut writer = CsvWriter::new(&mut file);
    let law =
        |now: &Now<crane::Steered>, set: &mut Inputs<crane::Steered>| set.angle_acceleration = (3.0 * now.t).cos();
    let run = steered(&scene).input("angle_rate", 0.1).every(STEP).control(law).record_to(&mut writer).run().unwrap();
    drop(writer);
    let tables = read_inputs(&file[..], &scene.info()).unwrap();
    let again = tables.into_iter().fold(steered(&scene), |order, (name, table)| order.input(name, table));
    let again = again.run().unwrap();
    let error = distance(run.last().coordinates, again.last().coordinates);
    assert!(error <= METHOD, "{error:.1e}");
}

#[test]
fn cross_rope_in_millimetres_of_an_array_is_that_of_single_bodies() {
    let (array, single) = (lift::Lifted::default(), winch::Lifted::default());
    let method = Method::dop853(1e-12);
    let array = simulation(&array).method(method).input("length_rate", 20.0).input("length_acceleration", -200.0);
    let (array, single) = (array.run().unwrap(), simulation(&single).method(method).run().unwrap());
    let error = distance(array.last().coordinates, single.last().coordinates);
    assert!(error <= METHOD, "{error:.1e}");
}

#[test]
fn invariant_ensembles_and_sensitivities_hold_the_declared_value() {
    let scene = crane::Steered::default();
    let start = system_of(&scene, Backend::Auto).unwrap().scene_start();
    let mut run = Sensitivities::new(&scene, &start, ["bob.phi"], Method::dop853(1e-12)).unwrap();
    run.advance(1.0).unwrap();
    let expected = simulation(&scene).until(1.0).method(Method::dop853(1e-12)).run().unwrap();
    let error = distance(&run.state().q, expected.last().coordinates);
    assert!(error <= METHOD && (run.state().q[2] - 0.2).abs() <= METHOD, "{error:.1e}");
}

/// A start is assembled with the inputs of the start, whatever they became: what a fresh stepper gives, and after a start that cannot be met the state and
/// the inputs are what they were.
#[test]
fn invariant_stepper_starts_anew_with_the_inputs_of_the_start() {
    let scene = crane::Steered::default();
    let fresh = || Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    let mut used = fresh();
    for acceleration in [1.0, 0.0] {
        used.set().angle_acceleration = acceleration;
        used.step(500).unwrap();
    }
    let (before, inputs) = (used.state().clone(), used.inputs().to_vec());
    assert!(used.reset_with(&[("arm.phi", 1.0)]).is_err(), "the motor holds it at 0.2");
    assert_eq!((&before, &inputs[..]), (used.state(), used.inputs()));
    let given = [("bob.phi", 0.3)];
    used.reset_with(&given).unwrap();
    let mut new = fresh();
    new.reset_with(&given).unwrap();
    assert_eq!((new.state(), new.inputs()), (used.state(), used.inputs()));
    assert!(used.state().q[2] == 0.2 && used.state().q[5] == 0.3, "{:?}", used.state().q);
    used.step(10).unwrap();
}
