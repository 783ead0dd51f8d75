//! Inputs that change while a scene runs.

use ezy_core::prelude::*;
use ezy_core::simulate::InputTable;
use ezy_core_tests::simulation;

model! {
    /// A cart that follows an input, and a sled that is pulled across its runner by another one.
    pub model Driven {
        input place: m = 1 by acceleration;
        input pull: N = 0;
        body cart { mass: 1, inertia: 1 }
        body sled { mass: 2, inertia: 1 }
        constraint drive: cart.x = place;
        skate runner: at sled(0, 0) along sled(1, 0) limit 3;
        force at sled(0, 0): (0, pull);
        start rest { cart at (1, 0) angle 0; sled at (0, 0) angle 0; at rest; }
        scene runs { start rest; until 2 s; }
    }
}

/// Constant accelerations, which RK4 follows to rounding.
const ROUNDING: f64 = 1e-13;

/// 1 m + ½ 2 m/s² t², with its rate, also at samples between the ticks of the controller.
#[test]
fn analytic_samples_tell_where_an_input_by_acceleration_is() {
    let scene = driven::Runs::default();
    let run = simulation(&scene).method(Method::rk4(0.25)).every(0.1).control_by_index(|_, _, inputs| inputs[2] = 2.0);
    for sample in run.run().unwrap().samples() {
        let (t, found) = (sample.t, ["input.place", "input.place_rate"].map(|name| sample.get(name).unwrap()));
        assert!(
            (found[0] - (1.0 + t * t)).abs() <= ROUNDING && (found[1] - 2.0 * t).abs() <= ROUNDING,
            "{t}: {found:?}"
        );
    }
}

/// 2 N hold the sled, 7 N from 1 s on let it slide: the mode that begins there has the input of that time, 2 kg · a = 7 N − 3 N.
#[test]
fn analytic_mode_begins_with_the_input_that_began_it() {
    let scene = driven::Runs::default();
    let pull = InputTable::held(vec![0.0, 1.0], vec![2.0, 7.0]).unwrap();
    let run = simulation(&scene).method(Method::rk4(0.25)).input("pull", pull).run().unwrap();
    let events: Vec<(&str, f64)> = run.events().iter().map(|of| (of.event.name, of.state.t)).collect();
    assert_eq!(events, [("runner slides", 1.0)]);
    let last = run.last();
    let found = ["sled.vy", "sled.y"].map(|name| last.get(name).unwrap());
    assert!((found[0] - 2.0).abs() <= ROUNDING && (found[1] - 1.0).abs() <= ROUNDING, "{found:?}");
}
