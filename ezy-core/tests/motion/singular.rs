//! Positions in which constraints depend on each other.

use ezy_core::prelude::*;

model! {
    /// A parallelogram that falls through its flat position, where it could become an antiparallelogram.
    pub model Parallelogram {
        body left { mass: 1, inertia: 1/12 }
        body right { mass: 1, inertia: 1/12 }
        body bar { mass: 2, inertia: 0.7 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: left(0.5, 0) ~ bar(-1, 0);
        hinge C: right(0.5, 0) ~ bar(1, 0);
        hinge D: ground(2, 0) ~ right(-0.5, 0);
        gravity (0, -9.81);
        start above { left angle 0.3; right near angle 0.3; bar near angle 0; at rest; }
        scene falls { start above; until 0.6 s; }
    }
}

/// I = 2/3 + 2 kg m² and m g l = (1 + 2) kg · 9.81 m/s² · 1 m: the rate at the angle reached.
#[test]
fn analytic_parallelogram_passes_its_flat_position() {
    for (method, bound) in [
        (Method::rk4(1e-3), 1e-6),
        (Method::dop853(1e-10), 1e-7),
        (Method::taylor(1e-10), 1e-7),
        (Method::radau(1e-8), 1e-4),
    ] {
        let run = Simulation::new(&parallelogram::Falls::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let last = run.last();
        let (phi, rate) = (last.get("left.phi").unwrap(), last.get("left.omega").unwrap());
        let expected = (2.0 * 3.0 * 9.81 * (0.3_f64.sin() - phi.sin()) / (8.0 / 3.0)).sqrt();
        assert!(phi < -0.5 && (rate + expected).abs() <= bound, "{method:?}: {phi} {rate} {expected}");
        assert!(last.get("bar.phi").unwrap().abs() <= bound, "{method:?}: it stays a parallelogram");
        assert!(run.monitors.pivot.unwrap().value < 0.1, "{method:?}: {:?}", run.monitors.pivot);
    }
}
