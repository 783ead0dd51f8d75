//! Runs that step together, and derivatives of runs.

use ezy_core::prelude::*;

model! {
    /// A mass on a spring.
    pub model Spring {
        param k: N/m = 8;
        param m: kg = 2;
        body block { mass: m, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ block(0, 0): stiffness k;
        start out { block at (1, 0) angle 0 velocity (0, 0); }
        scene swings { start out; until 1.7 s; }
    }
}

const METHODS: [(Method, f64); 2] = [(Method::rk4(5e-3), 1e-8), (Method::dop853(1e-11), 1e-9)];

/// x = cos √(k/m) t in each lane.
#[test]
fn analytic_springs_swing_together() {
    let scenes: [spring::Swings; 4] = std::array::from_fn(|i| spring::Swings { k: 4.0 + 3.0 * i as f64, m: 2.0 });
    for (method, bound) in METHODS {
        let start = |scene| {
            let mut system = System::new(scene, Backend::Generated).unwrap();
            let start = system.scene_start();
            system.consistent_start(&start).unwrap()
        };
        let starts = scenes.each_ref().map(start);
        let mut together = Ensemble::new(&scenes, starts.each_ref(), method).unwrap();
        for until in [0.61, 1.7] {
            together.advance(until).unwrap();
            assert_eq!(together.time(), until);
            for (lane, scene) in scenes.iter().enumerate() {
                let omega = (scene.k / scene.m).sqrt();
                let state = together.state(lane);
                assert!((state.q[0] - (omega * until).cos()).abs() <= bound, "{method:?} {lane}: {:?}", state.q);
                assert!(
                    (state.v[0] + omega * (omega * until).sin()).abs() <= 10.0 * bound,
                    "{method:?} {lane}: {:?}",
                    state.v
                );
            }
        }
    }
}

/// x = x₀ cos ωt + v₀/ω sin ωt with ω² = k/m: derivatives by x₀, v₀, k and m.
#[test]
fn analytic_derivatives_of_a_spring() {
    let scene = spring::Swings::default();
    for (method, bound) in METHODS {
        let start = System::new(&scene, Backend::Generated).unwrap().scene_start();
        let mut run = Sensitivities::new(&scene, &start, ["block.x", "block.vx", "k", "m"], method).unwrap();
        run.advance(1.7).unwrap();
        let (omega, t) = ((scene.k / scene.m).sqrt(), 1.7);
        let (sin, cos) = (omega * t).sin_cos();
        let by_omega = [-t * sin, -sin - omega * t * cos];
        let expected = [
            [cos, -omega * sin],
            [sin / omega, cos],
            by_omega.map(|x| x / (2.0 * omega * scene.m)),
            by_omega.map(|x| -x * omega / (2.0 * scene.m)),
        ];
        assert!((run.state().q[0] - cos).abs() <= bound, "{method:?}");
        for (tangent, expected) in run.tangents().iter().zip(expected) {
            let found = [tangent.q[0], tangent.v[0]];
            let close = found.iter().zip(expected).all(|(x, y)| (x - y).abs() <= 100.0 * bound);
            assert!(close, "{method:?}: {found:?} {expected:?}");
        }
    }
}
