//! The road train against concentric circles.

use ezy_core::prelude::*;
use ezy_models::road_train;

/// After 40 s at 2 m/s the last trailer has settled to rounding, and the rows hold the circles at any step.
const RADIUS: f64 = 1e-9;

#[test]
fn analytic_road_train_of_any_length_settles_on_concentric_circles() {
    let mut scene = road_train::Circling::default();
    for n in [1, 6] {
        scene.n = n;
        let run = Simulation::new(&scene).method(Method::rk4(4e-2)).until(40.0).run().unwrap();
        assert!(run.outcome.reached_end(), "{n}: {}", run.outcome);
        let end = run.last();
        let rate = end.velocities[5];
        let mut square = (scene.wheelbase / scene.delta.tan()).powi(2);
        for k in 0..n {
            square += scene.c * scene.c - scene.l * scene.l;
            let v = &end.velocities[3 * (k + 2)..];
            let error = v[0].hypot(v[1]) / rate - square.sqrt();
            assert!(error.abs() <= RADIUS, "trailer {k} of {n}: {error:.1e} m");
        }
    }
}
