//! The slider-crank against references.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::slider_crank;
use ezy_tests::garage::{at_times, case, load, number, rows, start_at, worse};

/// RK4 at 1 ms over 10 s of a motion with 1 rad/s: 1e-13; bar of the reference: 1e-8.
const STATE: f64 = 1e-12;
/// The projection's promise.
const GUIDE: f64 = 1e-12;

#[test]
fn reference_slider_crank_with_strut() {
    let file = load("slider_crank_ida");
    let table = rows(&file["rows"]);
    let scene = slider_crank::Pushed::default();
    let order = || simulation(&scene).method(Method::rk4(1e-3));
    at_times(order, 0.25, table.iter().map(|row| row[0]), |i, s| {
        let [t, q, x, p, q_rate, x_rate, p_rate] = table[i][..] else { panic!("seven columns") };
        let (at, rate) = (s.coordinates, s.velocities);
        let differences = [at[2] - q, at[3] - x, at[5] - p, rate[2] - q_rate, rate[3] - x_rate, rate[5] - p_rate];
        let error = differences.into_iter().fold(0.0, worse);
        assert!(error <= STATE, "{error:.1e} at {t} s");
        assert!(at[4].abs() <= GUIDE, "{:.1e} m at {t} s", at[4]);
    });
}

/// Of the reference, through 12 positions in which crank and rod are upright and the rows lose a rank.
const THROUGH_RANK_LOSS: f64 = 1e-6;

#[test]
fn reference_equal_lengths_pass_their_dead_points() {
    let file = load("torture");
    let case = case(&file, "slider_crank_equal_lengths");
    let bodies = &case["model"]["bodies"];
    let mut scene = slider_crank::Falling::default();
    (scene.r, scene.r_centre, scene.m1, scene.i1) = (1.0, 0.5, 1.0, 1.0 / 12.0);
    // the slider of 2 kg is part of the rod
    scene.l = 1.0;
    scene.m2 = 3.0;
    scene.l_centre = (0.5 + 2.0) / 3.0;
    scene.i2 = 1.0 / 12.0 + (scene.l_centre - 0.5_f64).powi(2) + 2.0 * (1.0 - scene.l_centre).powi(2);
    let order = || {
        let order = start_at(simulation(&scene).method(Method::rk4(1e-4)), &case["model"], &[("crank", "crank")]);
        order.start("rod.phi", number(&bodies[1]["angle"])).start("rod.omega", number(&bodies[1]["omega"]))
    };
    let states = case["states"].as_array().unwrap();
    at_times(order, 0.05, states.iter().map(|s| number(&s["t"])), |i, s| {
        let of = |body: &str, k: usize| number(&states[i]["bodies"][body][k]);
        let slider = s.coordinates[3] + (1.0 - scene.l_centre) * s.coordinates[5].cos();
        let error = [s.coordinates[2] - of("crank", 2), slider - of("slider", 0)].into_iter().fold(0.0, worse);
        assert!(error <= THROUGH_RANK_LOSS, "{error:.1e} at {} s", s.t);
    });
}
