//! Positions in which constraints depend on each other.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

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
        (Method::gauss(1e-10), 1e-7),
        (Method::radau(1e-8), 1e-4),
    ] {
        let run = simulation(&parallelogram::Falls::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let last = run.last();
        let (phi, rate) = (last.get("left.phi").unwrap(), last.get("left.omega").unwrap());
        let expected = (2.0 * 3.0 * 9.81 * (0.3_f64.sin() - phi.sin()) / (8.0 / 3.0)).sqrt();
        assert!(phi < -0.5 && (rate + expected).abs() <= bound, "{method:?}: {phi} {rate} {expected}");
        assert!(last.get("bar.phi").unwrap().abs() <= bound, "{method:?}: it stays a parallelogram");
        let pivot = run.monitors.pivot.unwrap();
        assert!(pivot.value < 0.01 && pivot.t > 0.05 && pivot.t < 0.5, "{method:?}: {pivot:?}");
    }
}

model! {
    /// The pendulum that the parallelogram is: I = 8/3 kg m² about its end, m g l = 3 kg · g · 1 m.
    pub model Equivalent {
        body rod { mass: 6, inertia: 7/6 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start turning { rod angle 0.3 rate 7; }
        scene turns { start turning; until 3 s; }
    }
}

/// A parallelogram that turns over: its errors grow in 3 s to some hundreds of the tolerance of a step.
const TURNED_OVER: f64 = 1e3;

/// Rounding at six passages, in which the position of the bars is known to the root of it in one direction.
const PASSED: f64 = 1e-8;

/// It goes round as the pendulum does, by steps that are not much shorter, and every level position that it passes stands in the record of
/// its run at its time.
#[test]
fn cross_parallelogram_turns_over_and_records_what_it_passes() {
    let pendulum = equivalent::Turns::default();
    let exact = simulation(&pendulum).method(Method::dop853(1e-13)).every(1e-3).run().unwrap();
    let half_turns: Vec<(f64, f64)> =
        exact.samples().map(|sample| (sample.t, sample.coordinates[2] / std::f64::consts::PI)).collect();
    let passes = |pair: &[(f64, f64)]| {
        let ((from_s, from), (to_s, to)) = (pair[0], pair[1]);
        let level = from.max(to).floor();
        (level > from.min(to)).then(|| from_s + (level - from) / (to - from) * (to_s - from_s))
    };
    let level: Vec<f64> = half_turns.windows(2).filter_map(passes).collect();
    assert!(level.len() >= 4, "{level:?}");
    let scene = parallelogram::Falls::default();
    let turning = |method| {
        let order = simulation(&scene).method(method).until(3.0).project_start();
        order.start("left.omega", 7.0).start("right.omega", 7.0).start("bar.omega", 0.0).run().unwrap()
    };
    for (method, tolerance, least) in [
        (Method::rk4(1e-3), 1e-10, level.len()),
        (Method::dop853(1e-9), 1e-9, 1),
        (Method::dop853(1e-12), 1e-12, 1),
        (Method::taylor(1e-9), 1e-9, 1),
        (Method::taylor(1e-12), 1e-12, 1),
    ] {
        let run = turning(method);
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let last = run.last();
        let error = last.get("left.phi").unwrap() - exact.last().coordinates[2];
        assert!(error.abs() <= (TURNED_OVER * tolerance).max(PASSED), "{method:?}: {error:.1e}");
        assert!(last.get("bar.phi").unwrap().abs() <= PASSED && last.position_residual <= 1e-12, "{method:?}");
        let alone = simulation(&pendulum).method(method).run().unwrap().cost;
        assert!(run.cost.steps <= 4 * alone.steps, "{method:?}: {} steps, {} alone", run.cost.steps, alone.steps);
        let crossings = &run.rank.crossings;
        assert!((least..=level.len()).contains(&crossings.len()), "{method:?}: {crossings:?} of {level:?}");
        for crossing in crossings {
            let n = level.iter().filter(|level_s| (crossing.from_s..crossing.to_s).contains(level_s)).count();
            assert_eq!(n, 1, "{method:?}: {crossing:?} of {level:?}");
        }
        // the pendulum itself has no singular position
        let alone = simulation(&pendulum).method(method).run().unwrap();
        assert!(alone.rank.crossings.is_empty() && alone.rank.intervals.is_empty(), "{method:?}: {}", alone.rank);
    }
}
