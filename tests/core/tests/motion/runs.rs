//! How a run is asked for: inputs, samples, limits, and a caller who steps.

use ezy_core::prelude::*;
use ezy_core::simulate::{ExceededLimit, StopReason};
use ezy_core_tests::simulation;

model! {
    /// A cart that is pushed.
    pub model Cart {
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        input push: N = 3;
        output place: cm = cart.x;
        force at cart(0, 0): (push, 0);
        start here { cart at (0, 0); at rest; }
        scene pushed { start here; until 2 s; }
    }
}

model! {
    /// A mass on a spring that is far too stiff, 159 kHz.
    pub model Ringing {
        param c: N*s/m = 0;
        body mass { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ mass(0, 0) along ground(1, 0);
        spring mass(0, 0) ~ ground(-1, 0): stiffness 1e12, length 1;
        force at mass(0, 0): (-c * mass.vx, 0);
        start here { mass at (1e-3, 0); at rest; }
        scene rings { start here; until 100 s; }
    }
}

/// Rounding of some sums of numbers of one; of centimetres a hundred times as much.
const ROUNDING: f64 = 1e-13;

/// An input is held over a step at its value in the middle: over steps of 0.5 s a ramp is a staircase.
#[test]
fn analytic_inputs_are_held_over_a_step() {
    let scene = cart::Pushed::default();
    let order = || simulation(&scene).method(Method::rk4(0.5)).every(0.5).outputs();
    let ramp = InputTable::new(vec![0.0, 2.0], vec![0.0, 4.0]).unwrap();
    let jump = InputTable::held(vec![0.0, 1.0], vec![2.0, -2.0]).unwrap();
    let close = |x: f64, y: f64| assert!((x - y).abs() <= ROUNDING * 100.0, "{x} {y}");
    // v = Σ F h/m and x = Σ (v h + F h²/(2 m))
    for (run, inputs, v, x) in [
        (order().run(), [3.0; 4], 3.0, 3.0),
        (order().input("push", 4.0).run(), [4.0; 4], 4.0, 4.0),
        (order().input("push", ramp).run(), [0.5, 1.5, 2.5, 3.5], 2.0, 1.375),
        (order().input("push", jump).run(), [2.0, 2.0, -2.0, -2.0], 0.0, 1.0),
    ] {
        let run = run.unwrap();
        assert_eq!(run.samples().len(), 5);
        for (sample, expected) in run.samples().zip(inputs) {
            assert_eq!(sample.inputs, [expected], "at {}", sample.t);
        }
        let last = run.last();
        close(last.velocities[0], v);
        close(last.coordinates[0], x);
        close(last.get("output.place").unwrap(), 100.0 * x);
    }
}

/// With u = −k v once a step, v is multiplied by 1 − k h/m in each.
#[test]
fn analytic_feedback_is_asked_once_a_step() {
    let scene = cart::Pushed::default();
    let mut times = Vec::new();
    let law = |now: &Now<cart::Pushed>, set: &mut Inputs<cart::Pushed>| {
        times.push(now.t);
        set.push = -4.0 * now.cart.vx;
    };
    let run =
        Simulation::new(&scene).method(Method::rk4(0.1)).until(1.0).start("cart.vx", 1.0).control(law).run().unwrap();
    let v = run.last().velocities[0];
    assert!((v - 0.8_f64.powi(10)).abs() <= ROUNDING, "{v}");
    // at the beginning of each step, and not at the end of the run
    assert_eq!(times.len(), 10, "{times:?}");
    assert!(times.iter().enumerate().all(|(n, t)| (t - 0.1 * n as f64).abs() <= 1e-15), "{times:?}");
}

#[test]
fn invariant_samples_come_at_their_times_and_at_the_end() {
    let scene = cart::Pushed::default();
    for method in
        [Method::rk4(0.07), Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-9)]
    {
        let run = simulation(&scene).method(method).every(0.3).until(1.0).run().unwrap();
        let times: Vec<f64> = run.samples().map(|sample| sample.t).collect();
        assert_eq!(times.len(), 5, "{method:?}: {times:?}");
        assert!(run.sample(3).is_some_and(|sample| sample.t == times[3]) && run.sample(5).is_none(), "{method:?}");
        for (sample, expected) in run.samples().zip([0.0, 0.3, 0.6, 0.9, 1.0]) {
            assert!((sample.t - expected).abs() <= 1e-15, "{method:?}: {times:?}");
            let t = sample.t;
            assert!((sample.coordinates[0] - 0.75 * t * t).abs() <= ROUNDING, "{method:?} at {t}");
            assert!((sample.velocities[0] - 1.5 * t).abs() <= ROUNDING, "{method:?} at {t}");
            assert!(
                (sample.accelerations[0] - 1.5).abs() <= ROUNDING && sample.multipliers.len() == 2,
                "{method:?} at {t}"
            );
        }
    }
}

/// Samples of a step with radau stand on its polynomial: each costs the accelerations that it records, and no step of its own.
#[test]
fn invariant_samples_of_radau_cost_one_evaluation_each() {
    let scene = cart::Pushed::default();
    let cost = |every| simulation(&scene).method(Method::radau(1e-9)).every(every).run().unwrap().cost;
    let (few, many) = (cost(2.0), cost(0.01));
    assert_eq!((many.steps, many.evaluations), (few.steps, few.evaluations + 199));
}

#[test]
fn invariant_a_limit_on_steps_ends_a_run_with_what_it_has() {
    let scene = cart::Pushed::default();
    for (method, steps) in [(Method::rk4(0.01), 7), (Method::radau(1e-9), 2)] {
        let run = simulation(&scene).method(method).max_steps(steps).run().unwrap();
        let Outcome::Stopped { t, reason: StopReason::Limit(ExceededLimit::Steps { .. }), .. } = &run.outcome else {
            panic!("{method:?}: {:?}", run.outcome)
        };
        assert!(
            run.cost.steps + run.cost.rejected == steps && *t == run.last().t && *t > 0.0,
            "{method:?}: {:?}",
            run.cost
        );
    }
    // where the last good state was sampled, it is not sampled again
    let run = simulation(&scene).method(Method::rk4(0.01)).every(0.01).max_steps(7).run().unwrap();
    let times: Vec<f64> = run.samples().map(|sample| sample.t).collect();
    assert!(times.len() == 8 && times.windows(2).all(|pair| pair[0] < pair[1]), "{times:?}");
    let whole = simulation(&scene).method(Method::rk4(0.01)).max_steps(200).run().unwrap();
    assert!(whole.outcome.reached_end() && whole.cost.steps == 200, "{:?}", whole.cost);
    assert_eq!(whole.cost.evaluations, 4 * 200 + 1);
}

/// 1.6e7 periods would take more steps than are allowed: the run says so after 20,000 of them, unless a limit was set. Where a damper ends
/// the ringing, its first thousands of steps say nothing about those that follow.
#[test]
fn cross_a_run_that_stalls_ends_within_seconds() {
    let rings = ringing::Rings::default();
    for method in [Method::dop853(1e-6), Method::taylor(1e-6), Method::radau(1e-4)] {
        let run = simulation(&rings).method(method).run().unwrap();
        let attempts = run.cost.steps + run.cost.rejected;
        let Outcome::Stopped { t, reason: StopReason::Limit(ExceededLimit::Pace { needed, .. }), .. } = &run.outcome
        else {
            panic!("{method:?}: {:?}", run.outcome)
        };
        assert!((20_000..20_100).contains(&attempts), "{method:?}: {attempts}");
        let rest = (100.0 - t) / t * attempts as f64;
        assert!((needed / rest - 1.0).abs() <= 0.5, "{method:?}: {needed} for {rest}");
    }
    let run = simulation(&rings).method(Method::taylor(1e-6)).max_steps(20_200).run().unwrap();
    assert!(run.cost.steps + run.cost.rejected >= 20_200, "{:?}", run.outcome);
    let damped = ringing::Rings { c: 1e4 };
    let run = simulation(&damped).method(Method::radau(1e-4)).run().unwrap();
    assert!(run.outcome.reached_end() && run.cost.steps > 2_000, "{:?}: {:?}", run.outcome, run.cost);
}

#[test]
fn cross_stepper_gives_the_bits_of_a_run_and_repeats_them() {
    let scene = cart::Pushed::default();
    let order = || simulation(&scene).method(Method::rk4(0.05)).until(2.0).outputs().work();
    let run = order().every(0.05).run().unwrap();
    let mut stepper = order().stepper().unwrap();
    for pass in 0..2 {
        for sample in run.samples().take(39) {
            assert_eq!(
                (&stepper.state().q[..], &stepper.state().v[..]),
                (sample.coordinates, sample.velocities),
                "{pass}"
            );
            assert_eq!(
                (stepper.outputs().to_vec(), stepper.energy()),
                (sample.outputs.to_vec(), sample.energy),
                "{pass}"
            );
            assert_eq!(stepper.accelerations().unwrap(), sample.accelerations, "{pass}");
            assert_eq!(stepper.multipliers().unwrap(), sample.multipliers, "{pass}");
            stepper.step(1).unwrap();
        }
        stepper.inputs_mut()[0] = 5.0;
        stepper.reset();
        assert_eq!(stepper.inputs(), [3.0]);
    }
    stepper.reset_with(&[("cart.vx", 2.0)]).unwrap();
    stepper.step(4).unwrap();
    assert!((stepper.state().v[0] - 2.3).abs() <= ROUNDING && (stepper.state().t - 0.2).abs() <= 1e-15);
    assert!(stepper.reset_with(&[("cart.nope", 2.0)]).is_err());
}

#[test]
fn invariant_files_of_inputs_are_read_or_refused_by_row_and_column() {
    let info = cart::Pushed::default().info();
    let read = |text: &str| read_inputs(text.as_bytes(), &info).map_err(|error| error.to_string());
    let [(name, table)] = &read("t [s], push [N]\n0, 1\n1, 3\n1, 5\n2, 5").unwrap()[..] else { panic!("one input") };
    assert_eq!((name.as_str(), [0.0, 0.5, 1.0, 2.0, 3.0].map(|t| table.at(t))), ("push", [1.0, 2.0, 5.0, 5.0, 5.0]));
    // of a file that a run wrote the columns of inputs alone, each value until the next
    let [(name, table)] = &read("t [s],cart.x [m],input.push [N]\n0,7,1\n1,8,3").unwrap()[..] else {
        panic!("one input")
    };
    assert_eq!((name.as_str(), [0.0, 0.5, 1.0].map(|t| table.at(t))), ("push", [1.0, 1.0, 3.0]));
    for (text, word) in [
        ("push\n1", "t"),
        ("t\n1", "input"),
        ("t,pull\n0,1", "pull"),
        ("t,push [kN]\n0,1", "kN"),
        ("t [ms],push\n0,1", "ms"),
        ("t,push,push\n0,1,2", "push"),
        ("t,push\n0,1\n1,x", "row 2"),
        ("t,push\n1,1\n0,1", "row 2"),
        ("t,push\n0,inf", "row 1"),
    ] {
        let error = read(text).expect_err(text);
        assert!(error.contains(word), "{text}: {error}");
    }
}

/// The rows of a file give back each `f64`.
#[test]
fn invariant_rows_of_a_file_are_the_samples() {
    let scene = cart::Pushed::default();
    let mut file = Vec::new();
    let mut writer = CsvWriter::new(&mut file);
    let run = simulation(&scene).method(Method::rk4(0.1)).every(0.7).record_to(&mut writer).run().unwrap();
    drop(writer);
    let text = String::from_utf8(file).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = |name: &str| names.iter().position(|found| *found == name).unwrap_or_else(|| panic!("{names:?}"));
    let (t, x, v) = (place("t [s]"), place("cart.x [m]"), place("cart.vx [m/s]"));
    assert_eq!(lines.clone().count(), run.samples().len());
    for (line, sample) in lines.zip(run.samples()) {
        let numbers: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        assert_eq!((numbers[t], numbers[x], numbers[v]), (sample.t, sample.coordinates[0], sample.velocities[0]));
    }
}

model! {
    /// x'' = 6 x², whose solution 1/(1 − t)² ends at 1 s.
    pub model Escape {
        body stone { mass: 1, inertia: 1 }
        effect pull { force at stone(0, 0): (6 * stone.x^2, 0); }
        start away { stone at (1, 0) angle 0 velocity (2, 0) rate 0; }
        scene leaves { start away; until 2 s; with pull; }
    }
}

#[test]
fn analytic_motion_that_ends_is_followed_to_its_end_and_says_so() {
    let scene = escape::Leaves::default();
    for method in [Method::dop853(1e-11), Method::taylor(1e-11), Method::gauss(1e-11), Method::radau(1e-9)] {
        let run = simulation(&scene).method(method).until(0.9).run().unwrap();
        let x = run.last().coordinates[0];
        assert!((x / 100.0 - 1.0).abs() <= 1e-6, "{method:?}: {x}");
        let [shortest, longest] = run.monitors.steps_s.unwrap();
        assert!(shortest < longest / 3.0, "{method:?}: steps become shorter, from {longest} to {shortest}");
        let run = simulation(&scene).method(method).run().unwrap();
        let Outcome::Stopped { t, .. } = run.outcome else { panic!("{method:?}: {:?}", run.outcome) };
        assert!((t - 1.0).abs() <= 1e-3, "{method:?}: {t}");
    }
}

/// Progress is told for each hundredth of a run, and at its end.
#[test]
fn analytic_progress_is_told_for_each_hundredth() {
    let scene = cart::Pushed::default();
    let mut told = Vec::new();
    let order = simulation(&scene).method(Method::rk4(0.005)).until(2.0).on_progress(|done| told.push(done));
    assert_eq!(order.run().unwrap().cost.steps, 400);
    assert!(told.len() >= 99 && told.len() <= 101 && told[told.len() - 1] == 1.0, "{} times", told.len());
    for pair in told.windows(2) {
        // a step is a quarter of a hundredth
        assert!((pair[1] - pair[0] - 0.01).abs() <= 0.003, "{pair:?}");
    }
}
