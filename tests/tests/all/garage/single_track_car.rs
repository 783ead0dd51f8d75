//! The single-track car against the closed form of steady cornering.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::single_track_car;

/// A steering angle so small that its square is rounding of the closed form, which is linear in it.
const DELTA: f64 = 1e-5;
/// δ² and what 20 s leave of a transient that decays with 5 to 15 per second.
const LINEAR: f64 = 1e-8;

#[test]
fn analytic_car_yaw_rate_by_understeer_gradient() {
    let mut car = single_track_car::Cornering { delta: DELTA, ..Default::default() };
    for (lf, lr, u) in [(1.2, 1.4, 10.0), (1.2, 1.4, 40.0), (1.3, 1.3, 20.0), (1.45, 1.15, 30.0)] {
        (car.lf, car.lr, car.u) = (lf, lr, u);
        let length = lf + lr;
        let understeer = car.m / length * (lr / car.cf - lf / car.cr);
        let run = simulation(&car).method(Method::rk4(5e-3)).until(20.0).run().unwrap();
        let rate = u * DELTA / (length + understeer * u * u);
        let error = run.last().velocities[2] / rate - 1.0;
        assert!(error.abs() <= LINEAR, "{lf} m, {u} m/s: {error:.1e}");
        let side = (run.last().get("lambda.cruise").unwrap() / (car.m * u * rate)).abs();
        // the thrust that holds the speed is of second order
        assert!(side <= 1e-3, "{side:.1e}");
    }
}

/// Steady states of the same equations: what 60 s leave of the transient, which is slow on tyres that are nearly flat.
const STEADY: f64 = 1e-9;

#[test]
fn analytic_car_side_forces_balance_at_the_limit_of_the_tyres() {
    let car = single_track_car::Limit { delta: 0.08, ..Default::default() };
    let run = simulation(&car).method(Method::rk4(5e-3)).until(60.0).run().unwrap();
    let (q, v) = (run.last().coordinates, run.last().velocities);
    let (sin, cos) = q[2].sin_cos();
    let (along, across, rate) = (v[0] * cos + v[1] * sin, v[1] * cos - v[0] * sin, v[2]);
    let (sin_d, cos_d) = car.delta.sin_cos();
    let side = |forward: f64, sideward: f64, stiffness: f64, limit: f64| {
        -limit * (stiffness * sideward.atan2(forward.abs()) / limit).tanh()
    };
    let wheel = across + car.lf * rate;
    let front = side(along * cos_d + wheel * sin_d, wheel * cos_d - along * sin_d, car.cf, car.ff);
    let rear = side(along, across - car.lr * rate, car.cr, car.fr);
    let centripetal = (front * cos_d + rear) / (car.m * along * rate) - 1.0;
    let moment = car.lf * front * cos_d / (car.lr * rear) - 1.0;
    assert!(centripetal.abs() <= STEADY && moment.abs() <= STEADY, "{centripetal:.1e} {moment:.1e}");
    assert!(front > 0.8 * car.ff, "{front} N is no test of the limit");
}
