//! The pantograph against plane geometry, and its forces against virtual work.

use crate::examples::pantograph::pantograph::Eight;
use ezy_core::prelude::*;

/// What the projection of positions leaves, m, times the bars of a loop.
const GEOMETRY: f64 = 1e-10;

#[test]
fn analytic_pen_draws_the_tracers_figure_enlarged() {
    for k in [2.0, 3.0, 4.5] {
        let scene = Eight { k, ..Default::default() };
        let run = Simulation::new(&scene).outputs().every(0.05).run().unwrap();
        for s in run.samples() {
            for axis in ["x", "y"] {
                let [tracer, pen] = ["tracer", "pen"].map(|name| s.get(&format!("output.{name}.{axis}")).unwrap());
                assert!((pen - k * tracer).abs() <= GEOMETRY, "{k} {axis} {}: {pen} {tracer}", s.t);
            }
        }
    }
}

/// The bars OB and BP make a triangle with OP: its angles by the law of cosines.
#[test]
fn analytic_bars_stand_at_the_angles_of_a_triangle() {
    let scene = Eight::default();
    let run = Simulation::new(&scene).every(0.05).run().unwrap();
    for s in run.samples() {
        let angle = std::f64::consts::TAU * scene.f * s.t;
        let (x, y) = (0.4 + scene.size * angle.cos(), 0.1 + scene.size * (2.0 * angle).sin());
        let d = x.hypot(y);
        let corner = ((scene.a * scene.a + d * d - scene.c * scene.c) / (2.0 * scene.a * d)).acos();
        let upper = y.atan2(x) + corner;
        let inner = (y - scene.a * upper.sin()).atan2(x - scene.a * upper.cos());
        for (body, expected) in [("upper", upper), ("short", upper), ("inner", inner), ("outer", inner)] {
            let found = s.get(&format!("{body}.phi")).unwrap();
            // an angle is a distance over a bar of 0.3 m at least
            assert!((found - expected).abs() <= GEOMETRY / scene.a, "{body} {}: {found} {expected}", s.t);
        }
    }
}
