//! First-order states in scenes of the garage: currents of motors, tyres with a relaxation length, the integral of a controller.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{differential_robot, single_track_car, tractor_trailers};

/// Methods that integrate first-order states, and what they leave of the numbers below.
fn methods(step_s: f64) -> [(Method, f64); 4] {
    [
        (Method::dop853(1e-10), 1e-7),
        (Method::taylor(1e-10), 1e-7),
        (Method::radau(1e-9), 1e-6),
        (Method::rk4(step_s), 1e-6),
    ]
}

/// What the batteries supply is heat, energy of the coils, and the work of the motors; at last the wheels turn as fast as voltage and bearings
/// allow: ω = k u/(R c + k²).
#[test]
fn analytic_electric_robot_accounts_for_its_energy_and_settles() {
    let scene = differential_robot::Electric { right_voltage: 6.0, ..Default::default() };
    let (u, r, k, c) = (6.0, scene.resistance, scene.k, scene.c);
    for (method, bound) in methods(1e-3) {
        let run = simulation(&scene).method(method).work().until(20.0).run().unwrap();
        let get = |name: &str| run.last().get(name).unwrap();
        let [left, right] = ["state.left_current", "state.right_current"].map(get);
        let coils = 0.5 * scene.inductance * (left * left + right * right);
        let lost = get("state.supplied") - get("state.heat") - coils - get("work.motors");
        assert!(
            get("work.motors") > 10.0 && lost.abs() <= bound * get("state.supplied"),
            "{}: {lost:e}",
            method.name()
        );
        let omega = k * u / (r * c + k * k);
        assert!((get("left.omega") - omega).abs() <= bound * omega, "{} {}", get("left.omega"), omega);
        assert!((left - c * omega / k).abs() <= bound * left && (left - right).abs() <= bound, "{left} {right}");
    }
}

/// Tyres follow their slip over a rolled length: at first the front one by 1 − e^{−u t/σ} of the steering angle, as long as the car has not turned;
/// at last the car corners as on tyres without that length.
#[test]
fn analytic_relaxing_tyres_lag_and_then_corner_alike() {
    let scene = single_track_car::Relaxing::default();
    let short_s = 1e-3;
    // tyres without that length have a law that is not analytic
    let has_both = |(method, _): &(Method, f64)| method.kind() != MethodKind::Taylor;
    for (method, bound) in methods(1e-3).into_iter().filter(has_both) {
        let run = simulation(&scene).method(method).until(short_s).run().unwrap();
        let slip = run.last().states[0];
        let followed = -scene.delta * (1.0 - (-scene.u * scene.delta.cos() * short_s / scene.sigma).exp());
        // meanwhile the car gains a side velocity, of the order of F/m t with half of the last force
        let gained = scene.cf * slip.abs() / scene.m * short_s / scene.u;
        assert!((slip - followed).abs() <= gained, "{slip} {followed} {gained}");
        let end = |run: Run| [run.last().velocities[1], run.last().velocities[2]];
        let relaxing = end(simulation(&scene).method(method).until(20.0).run().unwrap());
        let steady = single_track_car::Cornering::default();
        let steady = end(simulation(&steady).method(method).until(20.0).run().unwrap());
        assert!((relaxing[1] - steady[1]).abs() <= bound, "{relaxing:?} {steady:?}");
    }
}

/// The integral holds the steered axle against the torque that pulls it aside: the last trailer comes to the heading without an offset.
#[test]
fn analytic_autopilot_leaves_no_offset() {
    let scene = tractor_trailers::Piloted::default();
    let run = simulation(&scene).method(Method::dop853(1e-9)).outputs().until(400.0).run().unwrap();
    let get = |name: &str| run.last().get(name).unwrap();
    let offset = get("second.phi") - scene.heading;
    // the slowest mode has faded
    assert!(offset.abs() <= 1e-6, "{offset:e}");
    assert!((get("state.error_sum") + scene.pull / scene.stiff / scene.ki).abs() <= 1e-4, "{}", get("state.error_sum"));
    let without = tractor_trailers::Piloted { ki: 0.0, ..Default::default() };
    let run = simulation(&without).method(Method::dop853(1e-9)).until(400.0).run().unwrap();
    let offset = run.last().get("second.phi").unwrap() - scene.heading;
    assert!((offset - scene.pull / scene.stiff / scene.kp).abs() <= 1e-6, "{offset}");
}

/// Errors of 1e-10 a step over some hundreds of them, relative to the largest number.
const TOLERANCE: f64 = 1e-10;
const OF_STEPS: f64 = 300.0;

/// Whatever the method, the same states, positions and velocities at the end.
#[test]
fn cross_methods_agree_on_states_of_the_garage() {
    let scenes: [&dyn Scene; 3] = [
        &differential_robot::Electric { right_voltage: 6.0, ..Default::default() },
        &single_track_car::Relaxing::default(),
        &tractor_trailers::Piloted::default(),
    ];
    for scene in scenes {
        let numbers = |method| {
            let run = simulation(scene).method(method).until(3.0).run().unwrap();
            let last = run.last();
            [last.states, last.coordinates, last.velocities].concat()
        };
        let dop853 = numbers(Method::dop853(1e-12));
        let size = dop853.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        for method in [Method::taylor(TOLERANCE), Method::radau(TOLERANCE)] {
            let error = numbers(method).iter().zip(&dop853).fold(0.0, |most: f64, (x, y)| most.max((x - y).abs()));
            assert!(
                error <= OF_STEPS * TOLERANCE * size,
                "{}, {}: {error:e} of {size}",
                scene.info().name,
                method.name()
            );
        }
    }
}

/// Windings of 1 µs: some hundred steps over 5 s, and the motion of windings without inductance, to L/R.
#[test]
fn analytic_robot_with_fast_windings_is_driven_in_few_steps() {
    let resistance = differential_robot::Electric::default().resistance;
    let end = |time_s: f64| {
        let scene =
            differential_robot::Electric { right_voltage: 6.0, inductance: resistance * time_s, ..Default::default() };
        let run = simulation(&scene).method(Method::radau(1e-8)).run().unwrap();
        assert!(run.cost.steps + run.cost.rejected <= 300, "{time_s:e} s: {:?}", run.cost);
        let get = |name: &str| run.last().get(name).unwrap();
        for (current, wheel, u) in [
            ("state.left_current", "left.omega", scene.left_voltage),
            ("state.right_current", "right.omega", scene.right_voltage),
        ] {
            let quasi_static = (u - scene.k * get(wheel)) / resistance;
            assert!((get(current) - quasi_static).abs() <= 1e-5, "{time_s:e} s: {} {quasi_static}", get(current));
        }
        [get("left.omega"), get("right.omega")]
    };
    let (short, shorter) = (end(1e-6), end(1e-8));
    for (x, y) in short.iter().zip(shorter) {
        assert!((x - y).abs() <= 1e-5, "{short:?} {shorter:?}");
    }
}
