//! Steady motions, eigenvalues and responses, against closed forms.

use ezy_core::analysis::{AnalysisError, Instability, Linearization, Locus, Monodromy, SteadyMotion};
use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::prelude::*;
use ezy_tests::tables::{list, number, set_parameters, table};
use nalgebra::Complex;
use serde_json::Value;

/// Of positions, velocities and multipliers, as a share of the largest one.
const STEADY: f64 = 1e-11;
/// Of eigenvalues, as a share of the largest one: what rounding of the matrix makes of them, measured as 1.2e-13 for these.
const EIGENVALUES: f64 = 1e-10;
/// A double eigenvalue splits by the root of rounding.
const DOUBLE: f64 = 1e-7;
/// Of responses, as a share of the largest one.
const RESPONSE: f64 = 1e-9;

model! {
    /// Two bodies on a hinge with a spring, and a skate each: the EzyRoller and the roller racer.
    pub model Roller {
        param a: m = 0.2; param b: m = 0.6; param c: m = 0.1; param d: m = 0.1;
        param m1: kg = 46; param i1: kg*m^2 = 10; param m2: kg = 1; param i2: kg*m^2 = 0.005;
        param k: N*m = 0; param cd: N*m*s = 0; param e: rad = 0;
        input pump: N*m = 0;
        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }
        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate rear: at seat(-a, 0) along seat(1, 0);
        skate front: at bar(c, 0) along bar(1, 0);
        torsion seat ~ bar: stiffness k, angle e, damping cd;
        torque seat ~ bar: pump;
        output hinge_angle: rad = bar.phi - seat.phi;
        output hinge_rate: rad/s = bar.omega - seat.omega;
        output seat_rate: rad/s = seat.omega;
        start still { seat at (0, 0) angle 0; at rest; }
        scene runs { start still; until 1 s; }
    }
}

model! {
    /// Chaplygin's sleigh with a thrust and drag.
    pub model Sleigh {
        param m: kg = 1; param j: kg*m^2 = 1; param a: m = 1; param k: N*s/m = 0; param kw: N*m*s = 0;
        input thrust: N = 0; input turn: N*m = 0;
        body sleigh { mass: m, inertia: j }
        skate edge: at sleigh(-a, 0) along sleigh(1, 0);
        force at sleigh(-a, 0) along sleigh(1, 0): thrust;
        torque sleigh: turn - kw*sleigh.omega;
        drag at sleigh(0, 0): linear k;
        output turn_rate: rad/s = sleigh.omega;
        output speed: m/s = cos(sleigh.phi)*sleigh.vx + sin(sleigh.phi)*sleigh.vy;
        start still { sleigh at (0, 0) angle 0; at rest; }
        scene runs { start still; until 1 s; }
    }
}

model! {
    /// A car on two tyres.
    pub model Car {
        param m: kg = 1500; param i: kg*m^2 = 2500; param a: m = 1.2; param b: m = 1.5; param cf: N/rad = 8e4; param cr: N/rad = 9e4;
        input delta: rad = 0; input side: N = 0;
        body car { mass: m, inertia: i }
        point F = car(a, 0);
        force at F along car(0, 1): -cf*(slip_angle(F, car) - delta);
        tyre at car(-b, 0) along car(1, 0): stiffness cr;
        force at car(0, 0) along car(0, 1): side;
        output yaw_rate: rad/s = car.omega;
        output lateral_velocity: m/s = -sin(car.phi)*car.vx + cos(car.phi)*car.vy;
        start still { car at (0, 0) angle 0; at rest; }
        scene runs { start still; until 1 s; }
    }
}

model! {
    /// A car with a trailer.
    pub model Towed {
        param m1: kg = 1500; param i1: kg*m^2 = 2500; param a: m = 1.2; param b: m = 1.5; param h: m = 2.4;
        param cf: N/rad = 9e4; param cr: N/rad = 1.1e5;
        param m2: kg = 1000; param i2: kg*m^2 = 1800; param d: m = 3; param l: m = 3.3; param ct: N/rad = 6e4; param ch: N*m*s = 0;
        input delta: rad = 0;
        body car { mass: m1, inertia: i1 }
        body trailer { mass: m2, inertia: i2 }
        hinge hitch: car(-h, 0) ~ trailer(d, 0);
        point F = car(a, 0);
        force at F along car(0, 1): -cf*(slip_angle(F, car) - delta);
        tyre at car(-b, 0) along car(1, 0): stiffness cr;
        tyre at trailer(d - l, 0) along trailer(1, 0): stiffness ct;
        torsion car ~ trailer: stiffness 0, angle 0, damping ch;
        output yaw_rate: rad/s = car.omega;
        output hitch_angle: rad = trailer.phi - car.phi;
        output trailer_yaw_rate: rad/s = trailer.omega;
        start still { car at (0, 0) angle 0; trailer angle 0; at rest; }
        scene runs { start still; until 1 s; }
    }
}

/// The steady motion of an entry is found from itself; it has these eigenvalues, zeros and responses.
fn check<S: Scene>(scene: &S, inputs: &[(&str, f64)], entry: &Value, tolerance: f64) {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let info = system.info().clone();
    for (name, value) in inputs {
        let place = info.inputs.iter().position(|input| input.name == *name).expect("an input");
        system.inputs_mut()[place] = *value;
    }
    let mut start = system.scene_start();
    for (i, body) in info.bodies.iter().enumerate() {
        let values = &entry["steady"]["bodies"][&**body];
        for part in 0..3 {
            start.give_position(3 * i + part, number(&values[part]));
            start.give_velocity(3 * i + part, number(&values[3 + part]));
        }
    }
    // the numbers are rounded
    let expected = start.clone();
    start.give_way();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap_or_else(|error| panic!("{error}: {entry}"));
    let largest = expected.q.iter().chain(&expected.v).fold(1.0, |m: f64, x| m.max(x.abs()));
    let found = motion.state.q.iter().chain(&motion.state.v);
    for (found, expected) in found.zip(expected.q.iter().chain(&expected.v)) {
        assert!((found - expected).abs() <= STEADY * largest, "{found} for {expected}: {motion:?}");
    }
    let multipliers = info.rows.iter().map(|row| number(&entry["steady"]["multipliers"][&*row.name]));
    let multipliers: Vec<f64> = multipliers.collect();
    let largest = multipliers.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
    for (found, expected) in motion.multipliers.iter().zip(&multipliers) {
        assert!((found - expected).abs() <= STEADY * largest, "{found} for {expected}: {motion:?}");
    }

    let linear = Linearization::of(&mut system, &motion).unwrap();
    let spectrum = linear.spectrum().unwrap();
    let zeros = &entry["zero_eigenvalues"];
    assert_eq!(Some(spectrum.n_zero as u64), zeros["count"].as_u64(), "{spectrum:?} for {zeros}");
    let mut blocks: Vec<u64> = list(&zeros["jordan_blocks"]).iter().filter_map(Value::as_u64).collect();
    blocks.sort_by(|a, b| b.cmp(a));
    assert_eq!(spectrum.zero_blocks.iter().map(|n| *n as u64).collect::<Vec<_>>(), blocks, "{zeros}");
    let expected = list(&entry["eigenvalues"]).iter().map(|s| Complex::new(number(&s[0]), number(&s[1])));
    let mut expected: Vec<Complex<f64>> = expected.collect();
    let largest = expected.iter().fold(0.0, |m: f64, s| m.max(s.norm()));
    assert_eq!(spectrum.eigenvalues.len(), expected.len(), "{spectrum:?}");
    for found in &spectrum.eigenvalues {
        let nearest =
            (0..expected.len()).min_by(|&i, &j| (expected[i] - found).norm().total_cmp(&(expected[j] - found).norm()));
        let exact = expected.swap_remove(nearest.expect("one is left"));
        assert!((found - exact).norm() <= tolerance * largest, "{found} for {exact}");
    }
    assert_eq!(Some(spectrum.n_unstable() as u64), entry["unstable"].as_u64(), "{spectrum:?}");

    let response = &entry["response"];
    let place = |of: &Value, all: &[&str]| all.iter().position(|name| Some(*name) == of.as_str());
    let outputs: Vec<&str> = info.outputs.iter().map(|output| &*output.name).collect();
    let inputs = &linear.inputs;
    for sample in list(&response["samples"]) {
        let g = linear.response(Complex::new(0.0, number(&sample["omega"]))).expect("no eigenvalue");
        let largest = g.iter().fold(0.0, |m: f64, g| m.max(g.norm()));
        for (i, output) in list(&response["outputs"]).iter().enumerate() {
            for (j, input) in list(&response["inputs"]).iter().enumerate() {
                let Some((output, input)) = place(output, &outputs).zip(place(input, inputs)) else { continue };
                let of = &sample["G"][i][j];
                let exact = Complex::new(number(&of[0]), number(&of[1]));
                let found = g[(output, input)];
                assert!((found - exact).norm() <= RESPONSE * largest, "{found} for {exact} of {output} by {input}");
            }
        }
    }
}

/// Every entry of every set of a table.
fn check_all<S: Scene + Default>(text: &str, inputs: impl Fn(&Value) -> Vec<(&'static str, f64)>) -> usize {
    check_sets::<S>(text, |_| true, inputs)
}

/// Every entry of the sets of a table that are wanted, by their names; returns how many these are.
pub(super) fn check_sets<S: Scene + Default>(
    text: &str,
    is_wanted: impl Fn(&str) -> bool,
    inputs: impl Fn(&Value) -> Vec<(&'static str, f64)>,
) -> usize {
    let table = table(text);
    let mut n = 0;
    for of in list(&table["sets"]).iter().filter(|of| of["name"].as_str().is_none_or(&is_wanted)) {
        let entries = list(&of["entries"]).iter().chain(list(&of["speeds"]));
        // a set may be one motion
        let alone = Some(of).filter(|of| !of["steady"].is_null());
        for entry in entries.chain(alone) {
            let mut scene = S::default();
            set_parameters(&mut scene, &[&of["parameters"], entry]);
            if let Some(psi0) = entry["psi0"].as_str() {
                let place =
                    scene.info().parameters.iter().position(|p| p.name == "e").expect("the angle of the spring");
                scene.set_parameter(place, number(&Value::from(psi0)));
            }
            let is_double = entry.to_string().contains("double");
            check(&scene, &inputs(of), entry, if is_double { DOUBLE } else { EIGENVALUES });
            n += 1;
        }
    }
    n
}

#[test]
fn analytic_ezyroller_runs_straight() {
    assert!(check_all::<roller::Runs>(include_str!("../../answers/linear/ezyroller_straight.json"), |_| vec![]) > 20);
}

#[test]
fn analytic_ezyroller_runs_on_circles() {
    assert_eq!(check_all::<roller::Runs>(include_str!("../../answers/linear/ezyroller_circle.json"), |_| vec![]), 4);
}

/// From a start beside it, with the place, the heading and the speed of the table held, the same circle is found.
#[test]
fn analytic_roller_keeps_to_a_circle_that_is_held() {
    let table = table(include_str!("../../answers/linear/ezyroller_circle.json"));
    let of = &table["sets"][2];
    let mut scene = roller::Runs::default();
    set_parameters(&mut scene, &[&of["parameters"]]);
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let [seat, bar] =
        ["seat", "bar"].map(|body| [0, 1, 2, 3, 4, 5].map(|part| number(&of["steady"]["bodies"][body][part])));
    let mut start = system.scene_start();
    for part in 0..3 {
        start.give_position(part, seat[part]);
        start.give_velocity(part, seat[3 + part]);
    }
    start.give_position(5, bar[2] + 0.1);
    start.give_velocity(5, bar[5]);
    start.near_position(3, bar[0]);
    start.near_position(4, bar[1]);
    (1..3).for_each(|part| start.near_velocity(part, seat[3 + part]));
    (3..6).for_each(|i| start.near_velocity(i, bar[i]));
    let motion = SteadyMotion::near(&mut system, &start, &["seat.x", "seat.y", "seat.phi", "seat.vx"]).unwrap();
    assert!(
        (motion.state.q[5] - bar[2]).abs() <= STEADY && (motion.frame.omega - seat[5]).abs() <= STEADY,
        "{motion:?}"
    );
    assert!(motion.n_steps > 1 && motion.free.is_empty(), "{motion:?}");
    let free = SteadyMotion::near(&mut system, &start, &[]).unwrap().free;
    assert_eq!(free.len(), 4, "place, heading and speed: {free:?}");
}

#[test]
fn analytic_roller_racer_runs_straight() {
    assert!(check_all::<roller::Runs>(include_str!("../../answers/linear/roller_racer.json"), |_| vec![]) > 4);
}

#[test]
fn analytic_sleigh_runs_straight_and_on_circles() {
    let inputs = |of: &Value| {
        let [m, a, v, w, k, kw] = ["m", "a", "v", "w", "k", "kw"].map(|name| number(&of["parameters"][name]));
        vec![("thrust", k * v - m * a * w * w), ("turn", m * a * v * w + (k * a * a + kw) * w)]
    };
    assert_eq!(check_all::<sleigh::Runs>(include_str!("../../answers/linear/sleigh.json"), inputs), 7);
}

#[test]
fn analytic_car_on_linear_tyres() {
    assert!(check_all::<car::Runs>(include_str!("../../answers/linear/car.json"), |_| vec![]) > 10);
}

#[test]
fn analytic_trailer_sways() {
    assert!(check_all::<towed::Runs>(include_str!("../../answers/linear/car_and_trailer.json"), |_| vec![]) > 10);
}

/// Of critical speeds: the interval of the search, and what rounding of eigenvalues makes of it.
const CRITICAL: f64 = 1e-10;

/// From a root locus over the speed, in steps that do not meet the critical speed.
#[test]
fn analytic_trailer_sways_from_its_critical_speed_on() {
    let table = table(include_str!("../../answers/linear/car_and_trailer.json"));
    let mut n = 0;
    for of in list(&table["sets"]) {
        let mut scene = towed::Runs::default();
        set_parameters(&mut scene, &[&of["parameters"]]);
        let mut system = System::new(&scene, Backend::Auto).unwrap();
        let spectrum = |v: f64| {
            let mut start = system.scene_start();
            // the angles are given, and the speeds
            [0, 3].into_iter().for_each(|i| start.give_velocity(i, v));
            let motion = SteadyMotion::near(&mut system, &start, &["car.vx"])?;
            Linearization::of(&mut system, &motion)?.spectrum()
        };
        let speeds: Vec<f64> = (1..=12).map(|i| 5.0 * f64::from(i)).collect();
        let locus = Locus::of::<AnalysisError>(&speeds, spectrum).unwrap();
        let expected = list(&of["critical_speeds"]);
        assert_eq!(locus.critical.len(), expected.len(), "{:?}", locus.critical);
        for (found, expected) in locus.critical.iter().zip(expected) {
            let exact = number(&expected["v"]);
            assert!((found.value - exact).abs() <= CRITICAL * exact, "{found:?} for {exact}");
            let n_unstable = ["unstable_below", "unstable_above"].map(|key| expected[key].as_u64());
            assert_eq!(found.n_unstable.map(|n| Some(n as u64)), n_unstable);
            let Instability::Oscillation { omega } = found.kind else { panic!("{found:?}") };
            let exact = number(&expected["frequency_rad_per_s"]);
            assert!((omega - exact).abs() <= CRITICAL * exact, "{omega} for {exact}");
            n += 1;
        }
    }
    assert_eq!(n, 3);
}

/// An oversteering car diverges above v = √(cf cr L² / (m (a cf − b cr))), without oscillation, where the zero of its yaw joins the others.
#[test]
fn analytic_car_diverges_from_its_critical_speed_on() {
    let (m, a, b, cf, cr) = (1500.0, 1.6, 1.1, 1e5, 8e4);
    let scene = car::Runs { m, a, b, cf, cr, ..car::Runs::default() };
    let exact = (cf * cr * (a + b) * (a + b) / (m * (a * cf - b * cr))).sqrt();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let spectrum = |v: f64| {
        let mut start = system.scene_start();
        start.give_velocity(0, v);
        let motion = SteadyMotion::near(&mut system, &start, &["car.vx"])?;
        Linearization::of(&mut system, &motion)?.spectrum()
    };
    let locus = Locus::of::<AnalysisError>(&[10.0, 20.0, 30.0, 40.0], spectrum).unwrap();
    let [found] = locus.critical[..] else { panic!("{:?}", locus.critical) };
    assert!((found.value - exact).abs() <= CRITICAL * exact, "{found:?} for {exact}");
    assert_eq!((found.kind, found.n_unstable), (Instability::Divergence, [0, 1]));
}

/// Around a circle the flow between two headings is that of the turning frame: multipliers are exp(s T), and 1 for the zeros.
#[test]
fn cross_multipliers_on_a_circle_are_those_of_its_eigenvalues() {
    let table = table(include_str!("../../answers/linear/ezyroller_circle.json"));
    let of = &table["sets"][2];
    let mut scene = roller::Runs::default();
    set_parameters(&mut scene, &[&of["parameters"]]);
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    for (i, body) in ["seat", "bar"].into_iter().enumerate() {
        for part in 0..3 {
            start.give_position(3 * i + part, number(&of["steady"]["bodies"][body][part]));
            start.give_velocity(3 * i + part, number(&of["steady"]["bodies"][body][3 + part]));
        }
    }
    start.give_way();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let spectrum = Linearization::of(&mut system, &motion).unwrap().spectrum().unwrap();
    let frame = motion.frame;
    // a quarter of the circle
    let period = 0.25 * std::f64::consts::TAU / frame.omega.abs();
    let centre = [-frame.vy / frame.omega, frame.vx / frame.omega];
    let at = |t: f64| {
        let (sin, cos) = (frame.omega * t).sin_cos();
        let mut state = motion.state.clone();
        state.t = t;
        for i in (0..state.q.len()).step_by(3) {
            let [x, y] = [motion.state.q[i] - centre[0], motion.state.q[i + 1] - centre[1]];
            state.q[i] = centre[0] + cos * x - sin * y;
            state.q[i + 1] = centre[1] + sin * x + cos * y;
            state.q[i + 2] += frame.omega * t;
            let [vx, vy] = [motion.state.v[i], motion.state.v[i + 1]];
            (state.v[i], state.v[i + 1]) = (cos * vx - sin * vy, sin * vx + cos * vy);
        }
        state
    };
    let states: Vec<_> = Monodromy::times(0.0, period, 200).into_iter().map(at).collect();
    let monodromy = Monodromy::of(&mut system, &states).unwrap();
    assert!(monodromy.gap <= STEADY, "{}", monodromy.gap);
    let mut expected: Vec<Complex<f64>> = spectrum.eigenvalues.iter().map(|s| (s * period).exp()).collect();
    expected.extend(std::iter::repeat_n(Complex::new(1.0, 0.0), spectrum.n_zero));
    let found = monodromy.multipliers().unwrap();
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0, |m: f64, s| m.max(s.norm()));
    for found in found {
        let nearest = (0..expected.len())
            .min_by(|&i, &j| (expected[i] - found).norm().total_cmp(&(expected[j] - found).norm()))
            .expect("one is left");
        let exact = expected.swap_remove(nearest);
        // ones in a block of two split by the root of rounding
        let tolerance = if (exact - 1.0).norm() == 0.0 { 1e-6 } else { RESPONSE };
        assert!((found - exact).norm() <= tolerance * largest, "{found} for {exact}");
    }
}

model! {
    /// A block on a spring, whose damper leaves it slow: poles at some −k/c and −c/m.
    pub model Damped {
        param m: kg = 1e-10; param c: N*s/m = 1; param k: N/m = 1;
        input push: N = 0;
        body block { mass: m, inertia: 1 }
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        force at block(0, 0): (push - k*block.x - c*block.vx, 0);
        output place: m = block.x;
        start still { at rest; }
        scene rests { start still; until 1 s; }
    }
}

/// (k − m ω²)² + c² ω² = 2 k², beside a pole ten thousand million times as far away.
#[test]
fn analytic_bandwidth_beside_a_far_pole() {
    let scene = damped::Rests::default();
    let (m, c, k) = (scene.m, scene.c, scene.k);
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let of = Linearization::of(&mut system, &motion).unwrap().transfer("push", "place").unwrap();
    let b = c * c - 2.0 * k * m;
    let exact = (2.0 * k * k / (b + (b * b + 4.0 * m * m * k * k).sqrt())).sqrt();
    // ε of the far pole
    let tolerance = f64::EPSILON * c * c / (k * m);
    let found = of.bandwidth().unwrap();
    assert!((found / exact - 1.0).abs() <= tolerance, "{found} rad/s for {exact}");
}
