//! The differential-drive robot against closed forms.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::differential_robot;

/// RK4 at 10 ms on a circle that is run with at most 1 rad/s: (ωh)⁴/120 of a few radians.
const CIRCLE: f64 = 1e-9;

/// Mass that the speed of A moves, and inertia that the rate moves, of a robot whose centre of mass is on the axle.
fn inertias(w: f64, r: f64, m: f64, j: f64, m_wheel: f64, i_wheel: f64) -> [f64; 2] {
    let wheel = m_wheel + i_wheel / (r * r);
    [m + 2.0 * wheel, j + 2.0 * w * w * wheel]
}

#[test]
fn analytic_robot_runs_a_circle_by_steady_torques() {
    let s = differential_robot::Circle { right_torque: 0.021, ..Default::default() };
    let [mass, inertia] = inertias(s.w, s.r, s.m, s.j, s.m_wheel, s.i_wheel);
    let growth = (s.right_torque + s.left_torque) / (s.r * mass);
    let turning = s.w * (s.right_torque - s.left_torque) / (s.r * inertia);
    let radius = growth / turning;
    let run = simulation(&s).method(Method::rk4(1e-2)).every(0.5).run().unwrap();
    for sample in run.samples() {
        let t = sample.t;
        let angle = turning * t * t / 2.0;
        let (sin, cos) = angle.sin_cos();
        let rolled = [growth / s.r - turning * s.w / s.r, growth / s.r + turning * s.w / s.r].map(|a| a * t * t / 2.0);
        let [left_end, right_end] = [-s.w, s.w].map(|w| [(radius + w) * sin, radius - (radius + w) * cos]);
        let exact = [
            [radius * sin, radius * (1.0 - cos), angle],
            [left_end[0], left_end[1], rolled[0]],
            [right_end[0], right_end[1], rolled[1]],
        ];
        let error = crate::scenes::distance(sample.coordinates, exact.as_flattened());
        assert!(error <= CIRCLE, "{error:.1e} at {t} s");
    }
}

/// What 60 s leave of a transient with a time constant of 2 s or less.
const STEADY: f64 = 1e-9;

#[test]
fn analytic_robot_settles_where_the_bearings_take_the_torques() {
    let s = differential_robot::Cruise::default();
    let run = simulation(&s).method(Method::rk4(1e-2)).run().unwrap();
    let rates = [s.left_torque / s.c, s.right_torque / s.c];
    let v = run.last().velocities;
    for (rate, exact) in [(v[5], rates[0]), (v[8], rates[1]), (v[2], s.r * (rates[1] - rates[0]) / (2.0 * s.w))] {
        assert!((rate - exact).abs() <= STEADY, "{rate} for {exact} rad/s");
    }
}

#[test]
fn analytic_robot_at_prescribed_speeds_needs_no_force_but_the_centripetal_one() {
    let s = differential_robot::Prescribed::default();
    let run = simulation(&s).method(Method::rk4(1e-2)).every(1.0).work().run().unwrap();
    let speed = s.r * (s.left_rate + s.right_rate) / 2.0;
    let rate = s.r * (s.right_rate - s.left_rate) / (2.0 * s.w);
    let radius = speed / rate;
    let weight = s.m + 2.0 * s.m_wheel;
    for sample in run.samples() {
        let (sin, cos) = (rate * sample.t).sin_cos();
        let error = crate::scenes::distance(&sample.coordinates[..2], &[radius * sin, radius * (1.0 - cos)]);
        assert!(error <= CIRCLE, "{error:.1e} m at {} s", sample.t);
        let axle = sample.get("lambda.axle").unwrap() + weight * speed * rate;
        let motors = [sample.get("lambda.left_motor").unwrap(), sample.get("lambda.right_motor").unwrap()];
        assert!(axle.abs() <= CIRCLE, "{axle:.1e} N at {} s", sample.t);
        assert!(motors.iter().all(|m| m.abs() <= CIRCLE), "{motors:?} N·m at {} s", sample.t);
    }
}
