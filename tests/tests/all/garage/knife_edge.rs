//! The knife edge against its closed form.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::knife_edge;
use ezy_tests::garage::{Names, at_times, load, number, rows, start_at, worse};

/// RK4 at Ωh = 0.01 or below leaves (Ωh)⁴/120 of the way at a rate Ω, 2e3 rad on an arc of 1 m/Ω; bar of the reference.
const STATE: f64 = 1e-9;
/// Relative to the weight.
const FORCE: f64 = 1e-8;

const BLADE: Names<'static> = &[("S", "blade")];

#[test]
fn analytic_knife_edge_on_its_cycloids() {
    let file = load("knife_edge_incline");
    for case in file["cases"].as_array().unwrap() {
        let parameter = |name: &str| number(&case["parameters"][name]);
        let mut scene = knife_edge::Cycloid::default();
        (scene.m, scene.j) = (parameter("m"), parameter("J"));
        (scene.g, scene.alpha) = (parameter("g"), parameter("incline_alpha"));
        let step = if parameter("Omega") > 10.0 { 1e-4 } else { 1e-3 };
        let table = rows(&case["rows"]);
        let order = || start_at(simulation(&scene).method(Method::rk4(step)), &case["model"], BLADE);
        at_times(order, 0.5, table.iter().map(|row| row[0]), |i, s| {
            let [t, v, phi, x, y, knife] = table[i][..] else { panic!("six columns") };
            let (sin, cos) = s.coordinates[2].sin_cos();
            let differences = [
                s.velocities[0] * cos + s.velocities[1] * sin - v,
                s.coordinates[2] - phi,
                s.coordinates[0] - x,
                s.coordinates[1] - y,
            ];
            let error = differences.into_iter().fold(0.0, worse);
            assert!(error <= STATE, "{}: {error:.1e} at {t} s", case["name"]);
            let error = (-s.multipliers[0] - knife) / (scene.m * scene.g);
            assert!(error.abs() <= FORCE, "{}: knife {error:.1e} at {t} s", case["name"]);
        });
    }
}
