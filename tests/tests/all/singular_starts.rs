//! Starts in singular positions: refused where no motion leads on, and run where one does.

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;
use ezy_models::n_four_bar;

const METHODS: [fn() -> Method; 8] = [
    || Method::rk4(1e-3),
    || Method::rk4(1e-5),
    || Method::dop853(1e-6),
    || Method::dop853(1e-12),
    || Method::taylor(1e-6),
    || Method::taylor(1e-12),
    || Method::radau(1e-6),
    || Method::radau(1e-12),
];

/// Crank 1 cannot point down while the others stand up. The nearest place stretches a crank and its coupler along a line of two fixed points.
fn stretched(scene: &dyn Scene, phi: f64) -> Simulation<'_, &dyn Scene> {
    simulation(scene).method(Method::rk4(1e-3)).project_start().start("crank[1].phi", phi)
}

#[test]
fn analytic_stretched_bars_are_refused_by_every_method() {
    let scene = n_four_bar::Fall { n: 3, ..Default::default() };
    for phi in [-1.5, -1.55, -1.6, -1.65, -1.7] {
        let start = stretched(&scene, phi).until(0.0).run().unwrap();
        let angle = |name: &str| start.first().get(&format!("{name}.phi")).unwrap();
        // a crank and its coupler in one line, and what they hang between does not move
        let is_straight = |i: usize| {
            let turned = angle(&format!("coupler[{i}]")) - angle(&format!("crank[{}]", if i == 0 { 0 } else { i + 1 }));
            turned.sin().abs() <= 1e-5
        };
        assert!(is_straight(0) || is_straight(2), "{phi}");
        for method in METHODS {
            for until_s in [1e-4, 0.05] {
                let refused = stretched(&scene, phi).method(method()).until(until_s).run().unwrap_err();
                let SetupError::Motion(MotionError::SingularPosition { t, rows, residual, .. }) = refused else {
                    panic!("{phi}, {}: {refused}", method().name())
                };
                assert_eq!((t, rows.len()), (0.0, 4), "{phi}: {rows:?}");
                assert!(residual > 0.0, "{phi}: {residual:e}");
            }
        }
        let mut stepper = stretched(&scene, phi).method(Method::rk4(1e-3)).stepper().unwrap();
        for _ in 0..2 {
            let refused = stepper.step(1).unwrap_err();
            assert!(matches!(refused, MotionError::SingularPosition { .. }), "{phi}: {refused}");
            stepper.reset();
        }
    }
}

/// From a level position on, parallel cranks turn as a pendulum whose rate follows from its energy.
#[test]
fn analytic_parallel_cranks_leave_their_level_position() {
    /// Tolerances of 1e-9 in 40 steps; RK4 at 1 ms is finer.
    const RATE: f64 = 1e-7;
    let scene = n_four_bar::Fall { n: 1, ..Default::default() };
    let rates = ["crank[0].omega", "crank[1].omega"];
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-9)]
    {
        let order = simulation(&scene).method(method).until(0.5).project_start();
        let order = order.start("crank[0].phi", 0.0).start("crank[1].phi", 0.0).start("coupler[0].omega", 0.0);
        let run = rates.iter().fold(order, |order, rate| order.start(*rate, -3.0)).run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        let last = run.last();
        let [phi, omega] = ["crank[0].phi", "crank[0].omega"].map(|name| last.get(name).unwrap());
        // ω² = g (3 n + 1)/2 / ((n + 1)/3 + n) / l
        let pendulum = 9.81 * 2.0 / (2.0 / 3.0 + 1.0);
        let expected = -(9.0 - 2.0 * pendulum * phi.sin()).sqrt();
        assert!((omega - expected).abs() <= RATE, "{}: {omega} for {expected}", method.name());
    }
}

#[test]
fn analytic_cranks_of_two_rates_in_a_level_position_contradict_no_row() {
    let scene = n_four_bar::Fall { n: 1, ..Default::default() };
    let order = simulation(&scene).method(Method::rk4(1e-3)).until(0.5).project_start();
    let order = order.start("crank[0].phi", 0.0).start("crank[1].phi", 0.0).start("crank[0].omega", -3.0);
    let refused = order.run().unwrap_err();
    assert!(matches!(refused, SetupError::Motion(MotionError::SingularPosition { .. })), "{refused}");
    assert!(refused.to_string().contains("is singular: constraints depend on each other there"), "{refused}");
}
