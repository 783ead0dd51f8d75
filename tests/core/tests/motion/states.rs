//! First-order states: numbers with a rate of their own beside the motion.

use ezy_core::dynamics::StartError;
use ezy_core::integrate::{PreciseError, PreciseMotion};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core::testing::{GivenSteps, StepsBy};
use ezy_core_tests::{simulation, system_of};

model! {
    /// A motor with armature current that turns a wheel against friction, and what becomes of the energy that it takes.
    pub model Motor {
        param u: V = 12;
        param R: ohm = 0.5;
        param L: H = 0.1;
        param k: N*m/A = 0.4;
        param c: N*m*s/rad = 0.05;
        body wheel { mass: 1, inertia: 0.2 }
        hinge axle: ground(0, 0) ~ wheel(0, 0);
        state current: A = 0 rate (u - R*current - k*wheel.omega)/L;
        output power: W = u*current;
        event half: current = 6;
        effect drive { torque wheel: k*current; }
        effect friction { torque wheel: -c*wheel.omega; }
        effect account {
            state supplied: J = 0 rate u*current;
            state heat: J = 0 rate R*current^2;
        }
        start still { wheel angle 0; at rest; }
        scene turns { start still; until 2 s; with drive, friction; }
        scene accounted { start still; until 2 s; with drive, friction, account; }
        scene blocked { start still; until 2 s; with account; }
    }
}

model! {
    /// A cart whose velocity follows what is asked for, by a proportional and an integral part; two states, one of which the other reads.
    pub model Cruise {
        input wanted: m/s = 3;
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        state integral: m = 0 rate wanted - cart.vx;
        param f: 1/s = 0.5;
        state slow: m = 1 rate f*(integral - slow);
        force at cart(0, 0): (8*(wanted - cart.vx) + 6*integral, 0);
        start still { cart at (0, 0); at rest; }
        scene cruises { start still; until 4 s; }
    }
}

/// Those that integrate first-order states.
fn methods() -> [Method; 5] {
    [Method::dop853(1e-11), Method::taylor(1e-11), Method::radau(1e-10), Method::rk4(1e-3), Method::midpoint(1e-4)]
}

/// (current, wheel.omega) at `t`, from (i, ω) at 0: x' = A x + b with the eigenvalues of A, here real.
fn exact(scene: &motor::Turns, t: f64, from: [f64; 2]) -> [f64; 2] {
    let motor::Turns { u, R: r, L: l, k, c, .. } = *scene;
    let j = 0.2;
    let a = [[-r / l, -k / l], [k / j, -c / j]];
    let (trace, determinant) = (a[0][0] + a[1][1], a[0][0] * a[1][1] - a[0][1] * a[1][0]);
    // where nothing changes
    let rest = [u / l * c / j / determinant, u / l * k / j / determinant];
    let root = (0.25 * trace * trace - determinant).sqrt();
    assert!(root.is_finite() && root > 0.0);
    let (fast, slow) = (0.5 * trace - root, 0.5 * trace + root);
    let x = [from[0] - rest[0], from[1] - rest[1]];
    let ax = [0, 1].map(|i| a[i][0] * x[0] + a[i][1] * x[1]);
    // e^{A t} = e^{s t} + (A − s) (e^{s t} − e^{f t})/(s − f)
    let (e_slow, part) = ((slow * t).exp(), ((slow * t).exp() - (fast * t).exp()) / (slow - fast));
    [0, 1].map(|i| rest[i] + e_slow * x[i] + part * (ax[i] - slow * x[i]))
}

/// Errors of ends and of samples between them over 2 s: 1e-11 and 1e-10 times some ten steps; h⁴ and h² of the fastest mode, 7/s, over their
/// constants.
const BOUNDS: [f64; 5] = [1e-9, 1e-9, 1e-8, 1e-9, 1e-5];

#[test]
fn analytic_motor_follows_both_of_its_modes() {
    let scene = motor::Turns { L: 0.05, ..Default::default() };
    for (method, bound) in methods().into_iter().zip(BOUNDS) {
        let run = simulation(&scene).method(method).every(0.013).run().unwrap();
        assert!(run.samples().len() > 100);
        for sample in run.samples() {
            let [current, omega] = exact(&scene, sample.t, [0.0; 2]);
            let error = (sample.states[0] - current).abs().max((sample.get("wheel.omega").unwrap() - omega).abs());
            assert!(error <= bound, "{} at {} s: {error:e}", method.name(), sample.t);
            assert_eq!(sample.get("state.current").unwrap(), sample.states[0]);
        }
        let [current, _] = exact(&scene, 2.0, [0.0; 2]);
        let last = simulation(&scene).method(method).outputs().run().unwrap();
        assert!((last.last().get("output.power").unwrap() - 12.0 * current).abs() <= 12.0 * bound);
    }
}

/// Steps half as long make errors of the current 2^order times as small.
#[test]
fn order_of_first_order_states_is_that_of_the_method() {
    let scene = motor::Turns { L: 0.05, ..Default::default() };
    for (by, n, order) in [
        (StepsBy::Method(MethodKind::Midpoint), 100, 2.0),
        (StepsBy::Method(MethodKind::Rk4), 20, 4.0),
        (StepsBy::Method(MethodKind::Radau), 16, 5.0),
        (StepsBy::Method(MethodKind::Dop853), 6, 8.0),
        (StepsBy::Taylor(6), 24, 6.0),
        (StepsBy::Taylor(9), 12, 9.0),
    ] {
        let error = |n: u32| {
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let start = system.scene_start();
            let start = system.consistent_start(&start).unwrap();
            let mut steps = GivenSteps::new(system, start, by).unwrap();
            (0..n).for_each(|_| _ = steps.step(1.0 / f64::from(n)).unwrap().unwrap());
            let middle = steps.middle().unwrap();
            let end = steps.step(1e-9).unwrap().unwrap().z[0];
            let at = |t: f64, z: f64| (z - exact(&scene, t, [0.0; 2])[0]).abs();
            [at(1.0 + 1e-9, end), at(middle.t, middle.z[0])]
        };
        let (coarse, fine) = (error(n), error(2 * n));
        let [found, between] = [0, 1].map(|i| (coarse[i] / fine[i]).log2());
        assert!((order - 0.6..=order + 0.6).contains(&found), "{by:?}: {found} {coarse:?} {fine:?}");
        assert!(between >= f64::min(order, 3.0) - 0.6, "{by:?} between: {between} {coarse:?} {fine:?}");
    }
}

/// Where the current settles in L/R = 1e-7 s, it follows i = (u − k ω)/R, and the wheel obeys J ω' = k i − c ω, to L/R times the rate of the wheel.
/// Steps are as long as that motion allows: not of the order of 2 s over 1e-7 s, as stability of an explicit method would have them.
#[test]
fn analytic_stiff_current_takes_long_steps_by_radau() {
    for time_s in [1e-6, 1e-7, 1e-9] {
        let scene = motor::Turns { L: 0.5 * time_s, ..Default::default() };
        let motor::Turns { u, R: r, k, c, .. } = scene;
        let fades = (c + k * k / r) / 0.2;
        let rest = k * u / (r * c + k * k);
        let run = simulation(&scene).method(Method::radau(1e-7)).every(0.05).run().unwrap();
        assert!(run.outcome.reached_end() && run.samples().len() >= 41);
        assert!(run.cost.steps + run.cost.rejected <= 150, "{time_s:e} s: {:?}", run.cost);
        for sample in run.samples().skip(1) {
            let omega = rest * (1.0 - (-fades * sample.t).exp());
            let current = (u - k * omega) / r;
            // rates of the wheel times its speed and its current; and tolerances of some ten steps
            let bound = 10.0 * fades * time_s * rest.max(u / r) + 1e-5;
            let (found, speed) = (sample.states[0], sample.get("wheel.omega").unwrap());
            assert!((speed - omega).abs() <= bound, "{time_s:e} s, at {} s: {speed} {omega}", sample.t);
            assert!((found - current).abs() <= bound, "{time_s:e} s, at {} s: {found} {current}", sample.t);
        }
    }
}

/// What a second run says of the error of a current is that error.
#[test]
fn cross_error_of_a_state_by_radau_is_estimated() {
    let scene = motor::Turns { L: 0.05, ..Default::default() };
    let run = simulation(&scene).method(Method::radau(1e-6)).until(0.4).estimate_error().run().unwrap();
    let estimate = run.error_estimate.as_ref().unwrap().as_ref().unwrap();
    let of_states = estimate.errors.iter().find(|of| of.quantity == "states" && of.unit == "A").unwrap();
    let [current, _] = exact(&scene, 0.4, [0.0; 2]);
    let error = (run.last().states[0] - current).abs();
    assert!(error > 1e-9 && (of_states.at_end / error - 1.0).abs() <= 0.2, "{error:e} {of_states:?}");
}

/// What the source supplies is heat, energy of the coil, work on the wheel; and what is not called for is not there.
#[test]
fn invariant_energy_of_a_motor_balances() {
    let scene = motor::Accounted::default();
    for (method, bound) in methods().into_iter().zip(BOUNDS) {
        let run = simulation(&scene).method(method).work().run().unwrap();
        let get = |name: &str| run.last().get(name).unwrap();
        let coil = 0.5 * scene.L * get("state.current").powi(2);
        let left = get("state.supplied") - get("state.heat") - coil - get("work.drive");
        assert!(get("work.drive") > 10.0 && left.abs() <= 100.0 * bound, "{}: {left:e}", method.name());
        assert!(get("balance").abs() <= 100.0 * bound);
    }
    // a wheel that nothing turns: a coil alone, i = u/R (1 − e^{−R t/L})
    let scene = motor::Blocked::default();
    let run = simulation(&scene).method(Method::dop853(1e-11)).run().unwrap();
    let current = scene.u / scene.R * (1.0 - (-scene.R * 2.0 / scene.L).exp());
    assert!((run.last().get("state.current").unwrap() - current).abs() <= BOUNDS[0]);
}

/// When the current passes 6 A; and from another start.
#[test]
fn analytic_event_of_a_state_is_located() {
    let scene = motor::Blocked::default();
    let rest = scene.u / scene.R;
    for start in [0.0, 5.0, -3.0] {
        let expected = scene.L / scene.R * ((rest - start) / (rest - 6.0)).ln();
        for (method, bound) in methods().into_iter().zip(BOUNDS) {
            let run = simulation(&scene).method(method).start("current", start).run().unwrap();
            let [half] = run.events() else { panic!("{:?}", run.events()) };
            let (t, current) = (half.state.t, half.state.z[0]);
            assert!(
                (t - expected).abs() <= bound && (current - 6.0).abs() <= 100.0 * bound,
                "{method:?} {t} {current}"
            );
        }
    }
}

/// The error e = w − v of a cart of 2 kg under the force 8 e + 6 ∫e obeys e'' + 4 e' + 3 e = 0: it fades by 1/s and 3/s, without an offset.
#[test]
fn analytic_integral_controller_leaves_no_offset() {
    let scene = cruise::Cruises::default();
    let run = simulation(&scene).method(Method::dop853(1e-11)).every(0.1).run().unwrap();
    for sample in run.samples() {
        let t = sample.t;
        // e(0) = 3, e'(0) = −4 · 3
        let e = -1.5 * (-t).exp() + 4.5 * (-3.0 * t).exp();
        let integral = -1.5 * (1.0 - (-t).exp()) + 1.5 * (1.0 - (-3.0 * t).exp());
        assert!((3.0 - sample.get("cart.vx").unwrap() - e).abs() <= BOUNDS[0], "{t}");
        assert!((sample.states[0] - integral).abs() <= BOUNDS[0], "{t}");
    }
}

/// Inputs that are set act on states; a checkpoint and a reset bring them back.
#[test]
fn invariant_stepper_with_states_goes_on_to_the_last_bit() {
    let scene = cruise::Cruises::default();
    let new = || Simulation::new(&scene).method(Method::rk4(1e-2)).stepper().unwrap();
    let (mut one, mut other) = (new(), new());
    one.set().wanted = 5.0;
    one.step(50).unwrap();
    let checkpoint = one.save();
    other.restore(&checkpoint).unwrap();
    one.step(50).unwrap();
    other.step(50).unwrap();
    assert_eq!(one.state(), other.state());
    assert!(one.state().z[0] != 0.0 && one.state().z[1] != 1.0);
    one.reset();
    assert_eq!(one.state().z, [0.0, 1.0]);
    one.reset_with(&[("integral", 2.0)]).unwrap();
    assert_eq!(one.state().z, [2.0, 1.0]);
}

/// Runs in lanes and derivatives of a run take them, too: dv/dz₀ by differences.
#[test]
fn cross_ensembles_and_derivatives_integrate_states() {
    let scene = cruise::Cruises::default();
    let start = |integral: f64| {
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut start = system.scene_start();
        start.give_state(&system.info().clone(), 0, integral);
        system.consistent_start(&start).unwrap()
    };
    let starts = [0.0, 0.5, 1.0, -1.0].map(start);
    let scenes: [cruise::Cruises; 4] = Default::default();
    let mut ensemble = Ensemble::new(&scenes, [0, 1, 2, 3].map(|i| &starts[i]), Method::dop853(1e-11)).unwrap();
    ensemble.advance(2.0).unwrap();
    for (lane, start) in [0.0, 0.5, 1.0, -1.0].into_iter().enumerate() {
        let run = simulation(&scene).method(Method::dop853(1e-11)).start("integral", start).until(2.0).run().unwrap();
        let state = ensemble.state(lane);
        for (x, y) in state.z.iter().zip(run.last().states).chain(state.v.iter().zip(run.last().velocities)) {
            assert!((x - y).abs() <= BOUNDS[0], "{lane}: {x} {y}");
        }
    }
    let system = system_of(&scene, Backend::Auto).unwrap();
    let mut run = Sensitivities::new(&scene, &system.scene_start(), ["integral"], Method::dop853(1e-11)).unwrap();
    run.advance(2.0).unwrap();
    let [tangent] = run.tangents();
    let [low, high] = [2, 3].map(|lane| ensemble.state(lane));
    // the motion is linear
    let difference = (low.z[0] - high.z[0]) / 2.0;
    assert!((tangent.z[0] - difference).abs() <= BOUNDS[0], "{} {difference}", tangent.z[0]);
}

#[test]
fn invariant_methods_without_states_are_refused_by_name() {
    let scene = cruise::Cruises::default();
    let method = Method::gauss(1e-9);
    let error = simulation(&scene).method(method).run().unwrap_err();
    assert!(matches!(error, SetupError::FirstOrderStates { .. }), "{error}");
    let text = error.to_string();
    assert!(text.contains(method.name()) && text.contains("use dop853, radau, rk4 or midpoint"), "{text}");
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    start.z.push(7.0);
    let error = system.consistent_start(&start).unwrap_err();
    assert_eq!(error, StartError::States { expected: 2, found: 3 }, "{error}");
    let error = simulation(&scene).start("integrel", 1.0).run().unwrap_err();
    assert!(error.to_string().contains("did you mean `integral`"), "{error}");
}

model! {
    /// A ball whose bounces lose more and more, and a number that grows beyond all bounds.
    pub model Tiring {
        body ball { mass: 1, inertia: 1 }
        constraint upright: ball.phi = 0;
        constraint above: ball.x = 0;
        gravity (0, -10);
        param fades: 1/s = 0.5;
        param grows: 1/(m*s) = 1;
        effect floor {
            state bounce = 0.9 rate -fades*bounce;
            stop floor: ball.y from 0 restitution bounce;
        }
        effect growth { state size: m = 1 rate grows*size^2; }
        start high { ball at (0, 5); at rest; }
        scene bounces { start high; until 3 s; with floor; }
        scene bursts { start high; until 3 s; with growth; }
    }
}

/// The ball falls from 5 m in 1 s, and rises again by the share of the first bounce, 0.9 e^{−1/2}, of 10 m/s. Samples between steps change nothing.
#[test]
fn analytic_restitution_is_that_of_the_impact() {
    let scene = tiring::Bounces::default();
    let run = |method: Method, every: Option<f64>| {
        let order = simulation(&scene).method(method).until(1.5);
        if let Some(every) = every { order.every(every) } else { order }.run().unwrap()
    };
    let rebound = 10.0 * 0.9 * (-0.5_f64).exp();
    let methods = [Method::dop853(1e-10), Method::radau(1e-10)];
    for (method, every) in methods.into_iter().flat_map(|method| [(method, None), (method, Some(0.0371))]) {
        let last = run(method, every);
        let (y, vy) = (last.last().get("ball.y").unwrap(), last.last().get("ball.vy").unwrap());
        let (expected, expected_v) = (rebound * 0.5 - 5.0 * 0.25, rebound - 5.0);
        assert!(
            (y - expected).abs() <= 1e-8 && (vy - expected_v).abs() <= 1e-8,
            "{method:?} {every:?}: {y} {vy} {expected}"
        );
    }
}

model! {
    /// A pendulum with a motor whose current depends on all there is: time, position, velocity, the sine of the angle, another state and itself.
    pub model Entangled {
        param L: H = 0.5;
        param k: N*m/A = 0.4;
        input u: V = 2;
        body rod { mass: 1, inertia: 0.2 }
        hinge pin: ground(0, 0) ~ rod(-0.4, 0);
        gravity (0, -9.81);
        state current: A = 0.3
            rate (u*sin(3 (1/s)*t) - 0.8 (ohm)*current - k*rod.omega*sin(rod.phi) - 0.2 (V/m^2)*rod.y^2 + 0.1 (V)*tanh(charge))/L;
        state charge = 0.2 rate 1 (1/A/s)*current - 0.3 (1/s)*charge*sqrt(1 + charge^2) + 0.5 (1/m)*rod.vx;
        torque rod: k*current*cos(rod.phi) - 0.1 (N*m)*charge^2;
        output force: N = k*current/(1 m);
        start aside { rod angle 0.5; at rest; }
        scene swings { start aside; until 3 s; }
    }
}

/// At random states, a dozen orders of the series against the rates of the equations ahead.
#[test]
fn cross_series_of_states_solve_the_equations_ahead() {
    for scene in [&entangled::Swings::default() as &dyn Scene, &chained::Moves::default()] {
        let report = ezy_core::testing::check_scene(scene).unwrap();
        assert!(report.to_string().contains("Taylor series"), "{report}");
    }
}

/// Errors of 1e-11 a step, which 3 s make ten times as large.
const ENTANGLED: f64 = 2e-10;

/// By elimination and by factors, between steps and at them, and in double-double.
#[test]
fn cross_taylor_and_dop853_integrate_states_alike() {
    let scene = entangled::Swings::default();
    let run = |method, backend| simulation(&scene).method(method).backend(backend).every(0.1).work().run().unwrap();
    let reference = run(Method::dop853(1e-13), Backend::Auto);
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let start = system.consistent_start(&start).unwrap();
    let mut precise = PreciseMotion::new(&scene, &start).unwrap();
    for backend in [Backend::Generated, Backend::Dense] {
        let taylor = run(Method::taylor(1e-11), backend);
        for (one, other) in taylor.samples().zip(reference.samples()) {
            assert_eq!(one.t, other.t);
            let pairs = one.states.iter().zip(other.states).chain(one.coordinates.iter().zip(other.coordinates));
            let error = pairs
                .chain(one.velocities.iter().zip(other.velocities))
                .fold(0.0, |m: f64, (x, y)| m.max((x - y).abs()));
            assert!(error <= ENTANGLED, "{backend:?} at {} s: {error:e}", one.t);
        }
        let [one, other] = [&taylor, &reference].map(|run| run.last().get("energy.balance").unwrap_or(0.0));
        assert!((one - other).abs() <= ENTANGLED, "{one} {other}");
    }
    precise.advance_to(3.0).unwrap();
    for (x, y) in
        precise.z().iter().zip(reference.last().states).chain(precise.v().iter().zip(reference.last().velocities))
    {
        assert!((x.high() - y).abs() <= ENTANGLED / 10.0, "{x:?} {y}");
    }
    assert!(reference.last().states[0].abs() > 0.01 && reference.last().states[1].abs() > 0.01);
    let mut start = start;
    start.z.pop();
    assert!(matches!(
        PreciseMotion::new(&scene, &start).err(),
        Some(PreciseError::States { expected: 2, found: 1, .. })
    ));
}

model! {
    /// Masses in a row that springs hold together, and a motor that reads two of them: in a scene with counts.
    pub model Chained {
        count n = 3;
        param k: N/m = 20;
        body block[n] { mass: 1, inertia: 1 }
        for i in 0..n { slider rail[i]: ground(0, 0) ~ block[i](0, 0) along ground(1, 0); }
        for i in 1..n { spring block[i-1](0, 0) ~ block[i](0, 0): stiffness k, length 0.5; }
        state way: m = 0.1 rate block[0].vx*cos(block[n-1].x/(1 m)) - 0.3 (1/s)*way;
        state pull: N = 1 rate -2 (N/m/s)*block[n-1].x*way/(1 m) + 0.5 (N/s)*sin(2 (1/s)*t);
        force at block[n-1](0, 0): (pull, 0);
        force at block[0](0, 0): (-3 (N/m)*way, 0);
        start apart { for i in 0..n { block[i] at (0.7*i, 0) angle 0; } at rest; }
        scene moves { start apart; until 2 s; }
    }
}

#[test]
fn cross_taylor_integrates_states_of_scenes_with_counts() {
    let scene = chained::Moves::default();
    let run = |method| simulation(&scene).method(method).run().unwrap();
    let [one, other] = [Method::taylor(1e-11), Method::dop853(1e-12)].map(run);
    let pairs = one.last().states.iter().zip(other.last().states);
    for (x, y) in pairs.chain(one.last().velocities.iter().zip(other.last().velocities)) {
        assert!((x - y).abs() <= ENTANGLED, "{x} {y}");
    }
}

/// Of 1/(1 − t) nothing is left after 1 s: the run says so, and does not go on.
#[test]
fn invariant_state_that_is_no_number_ends_a_run() {
    let scene = tiring::Bursts::default();
    for method in
        [Method::rk4(1e-2), Method::midpoint(1e-2), Method::dop853(1e-9), Method::taylor(1e-9), Method::radau(1e-9)]
    {
        let run = simulation(&scene).method(method).run().unwrap();
        let text = run.outcome.to_string();
        assert!(!run.outcome.reached_end() && run.last().t < 1.2, "{method:?}: {text}");
        assert!(run.last().states[0].is_finite(), "{method:?}");
    }
    let mut stepper = simulation(&scene).method(Method::rk4(1e-2)).stepper().unwrap();
    assert!(stepper.step(300).unwrap_err().to_string().contains("size"));
}
