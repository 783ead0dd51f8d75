//! The pendulum against elliptic functions.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::pendulum;
use ezy_tests::garage::{at_times, case, load, number, rows, worse};

/// RK4 at 1 ms: (ωh)⁴/120 of the phase of 60 rad that is travelled in 20 s, with ω up to 4.4 rad/s.
const STATE: f64 = 1e-9;
/// Tensions are squares of rates of 4.4 rad/s.
const TENSION: f64 = 1e-8;
/// The projection's promise.
const GAP: f64 = 1e-12;

/// Impacts are located to 1e-12 s on motions that methods follow to 1e-12; each begins the next swing.
const KNOCKS_S: f64 = 1e-10;

/// RK4 at ωh = 0.01: (ωh)⁴/120 of 1e3 rad is 8e-8, of which the projection leaves less.
const FAST_ANGLE: f64 = 1e-8;

#[test]
fn analytic_pendulum_without_inertia_on_both_sides() {
    let file = load("a01_simple_pendulum");
    let table: Vec<_> = rows(&file["exact"]["rows"]).into_iter().filter(|row| row[0] <= 20.0).collect();
    let (swing, mirrored) = (pendulum::Swing::default(), pendulum::Mirrored::default());
    let scenes: [(&dyn Scene, f64); 2] = [(&swing, 1.0), (&mirrored, -1.0)];
    for (scene, side) in scenes {
        let order = || simulation(scene).method(Method::rk4(1e-3));
        at_times(order, 0.01, table.iter().map(|row| row[0]), |i, s| {
            let [t, x, y, vx, vy, tension] = table[i][..] else { panic!("six columns") };
            let differences =
                [s.coordinates[0] - side * x, s.coordinates[1] - y, s.velocities[0] - side * vx, s.velocities[1] - vy];
            let error = differences.into_iter().fold(0.0, worse);
            assert!(error <= STATE, "{error:.1e} at {t} s");
            let error = s.multipliers[0].hypot(s.multipliers[1]) - tension;
            assert!(error.abs() <= TENSION, "tension {error:.1e} at {t} s");
            assert!(s.position_residual <= GAP, "{:.1e} m at {t} s", s.position_residual);
        });
    }
}

#[test]
fn analytic_fast_rotor_off_its_centre() {
    let file = load("torture");
    let case = case(&file, "fast_rotor_off_centre");
    let table: Vec<_> = rows(&case["rows"]).into_iter().filter(|row| row[0] <= 0.1).collect();
    let body = &case["model"]["bodies"][0];
    let scene = pendulum::Swing { l: 0.05, i: number(&body["inertia"]), ..Default::default() };
    // hanging down; the file's angle is zero there
    let down = -std::f64::consts::FRAC_PI_2;
    let order = || {
        let order = simulation(&scene).method(Method::rk4(1e-6));
        order.start("bob.phi", down).start("bob.omega", number(&body["omega"]))
    };
    at_times(order, 1e-3, table.iter().map(|row| row[0]), |i, s| {
        let [t, angle, ..] = table[i][..] else { panic!("five columns") };
        let error = s.coordinates[2] - down - angle;
        assert!(error.abs() <= FAST_ANGLE, "{error:.1e} rad at {t} s");
        assert!(s.position_residual <= GAP, "{:.1e} m at {t} s", s.position_residual);
    });
}

/// K(k), the complete elliptic integral of the first kind, by the arithmetic-geometric mean.
fn quarter_period(k: f64) -> f64 {
    let (mut a, mut g) = (1.0_f64, (1.0 - k * k).sqrt());
    while (a - g).abs() > 4.0 * f64::EPSILON {
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / a
}

#[test]
fn analytic_pendulum_knocks_against_a_post() {
    let scene = pendulum::Knocking::default();
    let rate = (scene.g / scene.l).sqrt();
    // impacts n keep e^2n of the energy: sin(θ/2) at the turn is k = eⁿ/√2, and the way up and down takes 2 K(k)/ω
    let of_impact = |n: i32| quarter_period(scene.e.powi(n) / std::f64::consts::SQRT_2) / rate;
    let swings = std::iter::successors(Some((1, of_impact(0))), |(n, t)| Some((n + 1, t + 2.0 * of_impact(*n))));
    let expected: Vec<f64> = swings.map(|(_, t)| t).take_while(|t| *t < 10.0).collect();
    let kept = scene.e.powi(2 * expected.len() as i32);
    let lost = scene.m * scene.g * scene.l * (1.0 - kept);
    for method in
        [Method::rk4(5e-4), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)]
    {
        let run = simulation(&scene).method(method).work().run().unwrap();
        let hits = run.events().iter().filter(|occurred| occurred.event.name == "post hits");
        let found: Vec<f64> = hits.map(|hit| hit.state.t).collect();
        assert_eq!(found.len(), expected.len(), "{found:?} by {}", method.name());
        for (t, expected) in found.iter().zip(&expected) {
            assert!((t - expected).abs() <= KNOCKS_S, "{t} for {expected} by {}", method.name());
        }
        let work = run.last().get("work.stops").unwrap();
        assert!((work + lost).abs() <= STATE, "{work} for -{lost} by {}", method.name());
    }
}
