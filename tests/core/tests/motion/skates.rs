//! A skate with a limit.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A sled that is pulled across its runner, by a force that turns round.
    pub model Sled {
        param m: kg = 2;
        param limit: N = 3;
        body sled { mass: m, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit limit;
        force at sled(0, 0): (0, 6 - 12 * t^3);
        start rest { sled at (0, 0) angle 0; at rest; }
        scene pulled { start rest; until 1.2 s; }
    }
}

/// Changes are located to 1e-12 s on a motion with accelerations of 8 m/s² that methods follow to 1e-11.
const LOCATED: f64 = 1e-10;

/// m v' = F(t) − 3 N from 0 s to 1 s, where v returns to zero and F is −6 N; then m v' = F(t) + 3 N.
#[test]
fn analytic_sled_slides_on_to_the_other_side() {
    for method in
        [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-11), Method::rk4(1e-3)]
    {
        let run = simulation(&sled::Pulled::default()).method(method).work().run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {:?}", run.outcome);
        let events: Vec<(&str, f64)> = run.events().iter().map(|of| (of.event.name, of.state.t)).collect();
        let [("runner slides", first), ("runner stops", stops), ("runner slides", second)] = events[..] else {
            panic!("{method:?}: {events:?}")
        };
        assert!(first == 0.0 && (stops - 1.0).abs() <= LOCATED && (second - 1.0).abs() <= LOCATED, "{events:?}");
        let last = run.last();
        let (v, y) = (last.get("sled.vy").unwrap(), last.get("sled.y").unwrap());
        // v = (9 t − 3 t⁴ − 6)/2 after 1 s, and y by one more integration
        assert!((v + 0.7104).abs() <= LOCATED && (y - 0.393_504).abs() <= LOCATED, "{method:?}: {v} {y}");
        assert!((last.get("lambda.runner").unwrap() + 3.0).abs() <= LOCATED, "{method:?}: {:?}", last.multipliers);
    }
}

/// Below the limit the skate holds, and its multiplier balances the force.
#[test]
fn analytic_sled_that_holds_does_not_move() {
    let scene = sled::Pulled { limit: 20.0, ..Default::default() };
    let run = simulation(&scene).method(Method::dop853(1e-12)).run().unwrap();
    let last = run.last();
    assert!(run.events().is_empty() && last.get("sled.y").unwrap().abs() <= 1e-15);
    assert!((last.get("lambda.runner").unwrap().abs() - (12.0 * 1.2_f64.powi(3) - 6.0)).abs() <= 1e-12);
    let fixed = simulation(&scene).method(Method::rk4(1e-2)).run().unwrap().cost;
    assert_eq!((fixed.steps, fixed.rejected), (120, 0));
}

/// A step of fixed length is taken back where a mode ends in it; what is left of it is a step more.
#[test]
fn regress_steps_that_changes_of_mode_take_back() {
    let run = simulation(&sled::Pulled::default()).method(Method::rk4(0.07)).run().unwrap();
    // 18 steps to 1.2 s; the sled stops in the one that passes 1 s
    assert_eq!((run.cost.steps, run.cost.rejected, run.events().len()), (19, 1, 3));
}

model! {
    /// A sled of 1 kg that is pulled across its runner by 2 N, while what holds it fades and grows again with how far it slid.
    pub model Fading {
        body sled { mass: 1, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit 4 - 4 * t + 16 * sled.y;
        force at sled(0, 0): (0, 2);
        start rest { sled at (0, 0) angle 0; at rest; }
        scene pulled { start rest; until 1.5 s; }
    }
}

/// It slides from 0.5 s on. With s from there, y'' = 4 s − 16 y, so that 4 y = s − sin(4 s)/4. Had it held, the limit would be negative after
/// 1 s, and a step that is longer than that is taken back to where it has one.
#[test]
fn analytic_sled_slides_before_its_limit_would_end() {
    for method in [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-11)] {
        let run = simulation(&fading::Pulled::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let events: Vec<(&str, f64)> = run.events().iter().map(|of| (of.event.name, of.state.t)).collect();
        let [("runner slides", t)] = events[..] else { panic!("{method:?}: {events:?}") };
        let y = run.last().get("sled.y").unwrap();
        assert!(
            (t - 0.5).abs() <= LOCATED && (4.0 * y - 1.0 + 0.25 * 4.0_f64.sin()).abs() <= LOCATED,
            "{method:?}: {t} {y}"
        );
        // the step that has no limit at its end, and the one that passes the change
        assert_eq!(run.cost.rejected, 2, "{method:?}");
    }
}
