//! Bodies, inputs, outputs and events by their names: the same numbers as by index.

use ezy_core::model::{NamedInputs, NamedScene};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_models::pendulum;
use ezy_tests::piloted::piloted;

const STEP: f64 = 1e-3;
/// A few roundings of the conversion of units, relative.
const CONVERTED: f64 = 1e-14;

model! {
    /// Links in a row, pushed at their end, beside a net of knots.
    pub model Rope {
        count n = 4;
        count m = 3;
        body anchor { mass: 1, inertia: 1 }
        body link[n] { mass: 1, inertia: 0.1 }
        body knot[m, n] { mass: 1, inertia: 1 }
        body float { mass: 2, inertia: 1 }
        input pull: kN = 0.001;
        hinge top: anchor(0, 0) ~ link[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: link[i-1](0.5, 0) ~ link[i](-0.5, 0); }
        for i in 0..m { for j in 0..n { spring anchor(0, 0) ~ knot[i, j](0, 0): stiffness 10 + i, length 1; } }
        gravity (0, -9.81);
        force at link[n-1](0, 0): (pull, 0);
        output height: cm = float.y;
        for i in 1..n { output bend[i]: deg = pin[i].angle; }
        for i in 0..m { for j in 1..n { output side[i, j]: mm = knot[i, j].r; } }
        for i in 0..n { for j in 0..i { output gap[i, j] = link[i].x - link[j].x; } }
        output power: W = pull * link[n-1].vx;
        start level {
            anchor at (0, 0) angle 0;
            for i in 0..n { link[i] angle 0.1*i; }
            for i in 0..m { for j in 0..n { knot[i, j] at (1 + j, i) angle i + 10*j; } }
            at rest;
        }
        scene swing { start level; until 0.1 s; }
    }
}

fn all(run: &Run) -> Vec<u64> {
    run.samples().flat_map(|sample| sample.numbers().map(f64::to_bits).collect::<Vec<_>>()).collect()
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= CONVERTED * b.abs()
}

#[test]
fn cross_law_by_name_gives_the_bits_of_the_law_by_index() {
    let scene = piloted::Pushed::default();
    let mut outputs = vec![0.0; scene.info().n_outputs()];
    let steering = output_index(&scene.info(), "steering").unwrap();
    let order = || Simulation::new(&scene).method(Method::rk4(STEP)).work().outputs().every(0.013);
    let by_name = order().control(|now, set| {
        set.torque = 200.0 * (1.5 - (now.bar.phi - now.seat.phi)) - 3.0 * now.outputs().steering;
        set.pull = 2.0 * now.seat.x - now.bar.vy + now.t * set.torque;
    });
    let by_index = order().control_by_index(|t, state, inputs| {
        // no output that is read depends on inputs
        let system = System::new(&scene, Backend::Auto).unwrap();
        system.outputs(t, &state.q, &state.v, &mut outputs);
        inputs[0] = 200.0 * (1.5 - (state.q[5] - state.q[2])) - 3.0 * outputs[steering];
        inputs[1] = 2.0 * state.q[0] - state.v[4] + t * inputs[0];
    });
    assert_eq!(all(&by_name.run().unwrap()), all(&by_index.run().unwrap()));
}

#[test]
fn cross_stepper_by_name_gives_the_bits_of_the_stepper_by_index() {
    let scene = piloted::Pushed::default();
    let order = || Simulation::new(&scene).method(Method::rk4(STEP)).work();
    let (mut by_name, mut by_index) = (order().stepper().unwrap(), order().stepper().unwrap());
    let power = output_index(&scene.info(), "power").unwrap();
    for _ in 0..300 {
        let now = by_name.now();
        let (seen, rate) = (now.outputs(), now.bar.omega - now.seat.omega);
        by_name.set().torque = 10.0 * seen.power - rate + seen.wheel.y;
        by_name.set().pull += 0.1;
        let (state, seen) = (by_index.state().clone(), by_index.outputs().to_vec());
        let rate = state.v[5] - state.v[2];
        by_index.inputs_mut()[0] = 10.0 * seen[power] - rate + seen[2];
        by_index.inputs_mut()[1] += 0.1;
        assert_eq!(by_name.inputs(), by_index.inputs());
        by_name.step(2).unwrap();
        by_index.step(2).unwrap();
        assert_eq!(by_name.state(), by_index.state());
    }
}

/// Inputs that a law sets are held over steps of fixed length.
#[test]
fn invariant_law_by_name_needs_a_fixed_step_as_by_index() {
    let scene = piloted::Ridden::default();
    for method in [Method::dop853(1e-9), Method::radau(1e-9), Method::taylor(1e-9)] {
        let by_name = Simulation::new(&scene).method(method).control(|_, _| {}).run();
        assert!(matches!(by_name, Err(SetupError::NeedsFixedStep { .. })));
        let by_index = Simulation::new(&scene).method(method).control_by_index(|_, _, _| {}).run();
        assert!(matches!(by_index, Err(SetupError::NeedsFixedStep { .. })));
    }
}

#[test]
fn cross_samples_of_every_method_have_the_names_of_their_columns() {
    let scene = piloted::Coast::default();
    for method in [Method::rk4(STEP), Method::dop853(1e-9), Method::radau(1e-9), Method::taylor(1e-9)] {
        let run = Simulation::new(&scene).method(method).outputs().every(0.1).run().unwrap();
        for sample in run.samples() {
            let bodies = scene.bodies_by_name(sample.coordinates, sample.velocities);
            let outputs = scene.outputs_by_name(sample.outputs);
            for (name, value) in [
                ("seat.x", bodies.seat.x),
                ("seat.y", bodies.seat.y),
                ("seat.phi", bodies.seat.phi),
                ("bar.vx", bodies.bar.vx),
                ("bar.vy", bodies.bar.vy),
                ("bar.omega", bodies.bar.omega),
                ("output.speed", outputs.speed),
                ("output.wheel.x", outputs.wheel.x),
                ("output.wheel.y", outputs.wheel.y),
                ("output.steering", outputs.steering),
                ("output.turning", outputs.turning),
            ] {
                assert_eq!(sample.get(name).unwrap(), value, "{name} by {}", method.name());
            }
        }
    }
}

#[test]
fn invariant_scene_without_inputs_can_be_watched() {
    let scene = piloted::Coast::default();
    let mut speeds = Vec::new();
    let watched = Simulation::new(&scene)
        .method(Method::rk4(1e-3))
        .until(0.01)
        .control(|now, _| speeds.push(now.outputs().speed))
        .run()
        .unwrap();
    let plain = Simulation::new(&scene).method(Method::rk4(1e-3)).until(0.01).run().unwrap();
    assert_eq!(all(&watched), all(&plain));
    assert_eq!(speeds.len(), 10);
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    assert_eq!(stepper.now().outputs().speed, speeds[0]);
}

#[test]
fn invariant_outputs_of_a_law_are_those_of_the_inputs_that_held() {
    let scene = piloted::Ridden::default();
    let mut powers = Vec::new();
    let law = |now: &Now<piloted::Ridden>, set: &mut Inputs<piloted::Ridden>| {
        let (held, rate) = (set.torque, now.bar.omega - now.seat.omega);
        set.torque = 10.0 * now.t;
        // in W, of a torque in N·cm
        powers.push((now.outputs().power, held * 0.01 * rate));
    };
    Simulation::new(&scene).method(Method::rk4(1e-3)).until(0.01).control(law).run().unwrap();
    assert!(powers.len() == 10 && powers[0].0 != 0.0);
    assert!(powers.iter().all(|(seen, expected)| is_near(*seen, *expected)), "{powers:?}");
}

#[test]
fn cross_arrays_have_the_names_of_their_columns() {
    let (n, m) = (5, 2);
    let scene = rope::Swing { n, m };
    let mut seen = 0;
    let law = |now: &Now<rope::Swing>, set: &mut Inputs<rope::Swing>| {
        let info = scene.info();
        let (state, outputs) = (now.state(), now.outputs());
        let position = |name: String| state.q[coordinate_index(&info, &name).unwrap()];
        assert_eq!((now.link.lengths(), now.knot.lengths()), ([n], [m, n]));
        assert_eq!([now.anchor.phi, now.float.y], ["anchor.phi", "float.y"].map(|name| position(name.into())));
        for (i, link) in now.link.iter().enumerate() {
            assert_eq!(link, now.link.at(i));
            assert_eq!([link.x, link.phi], [position(format!("link[{i}].x")), position(format!("link[{i}].phi"))]);
            assert_eq!(link.vy, state.v[coordinate_index(&info, &format!("link[{i}].y")).unwrap()]);
            let gaps = (0..i).map(|j| link.x - now.link.at(j).x);
            assert!(outputs.gap.iter().skip(i * i.saturating_sub(1) / 2).take(i).eq(gaps));
        }
        for (i, j) in (0..m).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let knot = now.knot.at([i, j]);
            assert_eq!(knot.x, position(format!("knot[{i},{j}].x")));
            if j > 0 {
                let side = (outputs.side.x.at([i, j]), outputs.side.y.at([i, j]));
                assert!(is_near(side.0, 1e3 * knot.x) && is_near(side.1, 1e3 * knot.y));
            }
        }
        let bend = (now.link.at(3).phi - now.link.at(2).phi).to_degrees();
        assert!(is_near(outputs.bend.at(3), bend) && is_near(outputs.height, 100.0 * now.float.y));
        assert!(is_near(outputs.power, set.pull * 1e3 * now.link.at(n - 1).vx));
        assert!(now.link.get(n).is_none() && now.knot.get([0, n]).is_none() && now.knot.get([m, 0]).is_none());
        assert!(outputs.bend.get(0).is_none() && outputs.bend.get(n).is_none() && outputs.bend.get(1).is_some());
        set.pull = now.t;
        seen += 1;
    };
    let run = Simulation::new(&scene).method(Method::rk4(0.01)).outputs().control(law).run().unwrap();
    assert_eq!(run.last().inputs, [0.09]);
    let by_index = Simulation::new(&scene).method(Method::rk4(0.01)).outputs();
    let by_index = by_index.control_by_index(|t, _, inputs| inputs[0] = t).run().unwrap();
    assert_eq!(all(&run), all(&by_index));
    assert_eq!(seen, 10);
}

#[test]
#[should_panic(expected = "no body has the index [4]: the array has [4] bodies")]
fn invariant_body_that_is_not_there_is_named() {
    let scene = rope::Swing::default();
    Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap().now().link.at(4);
}

#[test]
fn invariant_inputs_by_name_are_read_and_written_in_their_order() {
    let set = Inputs::<piloted::Pushed>::read(&[3.0, 7.0]);
    assert_eq!((set.torque, set.pull), (3.0, 7.0));
    let mut values = [0.0; 2];
    set.write(&mut values);
    assert_eq!(values, [3.0, 7.0]);
}

#[test]
fn invariant_constants_of_events_are_the_names_of_a_run() {
    let scene = pendulum::Knocking::default();
    let info = scene.info();
    let stop = info.stop.unwrap();
    let names = [stop.hits[0].name, stop.holds.name, stop.lets_go.name];
    assert_eq!(names, [pendulum::events::post::hits, pendulum::events::post::holds, pendulum::events::post::lets_go]);
    let run = Simulation::new(&scene).method(Method::dop853(1e-9)).run().unwrap();
    assert!(run.events().iter().any(|occurrence| occurrence.event.name == pendulum::events::post::hits));
}
