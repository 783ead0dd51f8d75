//! The Chaplygin sleigh against its closed form.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::chaplygin_sleigh;
use ezy_tests::garage::{Names, at_times, case, load, number, rows, start_at, worse};

/// RK4 at 1 ms with rates up to 1.5 rad/s leaves 1e-14 a second; bar of the reference: 1e-9.
const STATE: f64 = 1e-12;
/// Until the sleigh has turned over an error of its rate of 1e-3 rad/s grows by exp(r t), a thousand times.
const REVERSAL: f64 = 1e-11;
const SIDEWAYS: f64 = 1e-12;

const SLEIGH: Names<'static> = &[("S", "sleigh")];

#[test]
fn analytic_sleigh_in_all_its_motions() {
    let file = load("chaplygin_sleigh");
    for (name, bar) in [("bloch", STATE), ("spin", STATE), ("com_behind", STATE), ("reversal", REVERSAL)] {
        let case = case(&file, name);
        let parameter = |name: &str| number(&case["parameters"][name]);
        let mut scene = chaplygin_sleigh::Coast::default();
        (scene.m, scene.j, scene.a) = (parameter("m"), parameter("J"), parameter("a"));
        let table = rows(&case["rows"]);
        let order = || start_at(simulation(&scene).method(Method::rk4(1e-3)), &case["model"], SLEIGH);
        at_times(order, 0.25, table.iter().map(|row| row[0]), |i, s| {
            let [t, v, omega, theta, x, y, knife] = table[i][..] else { panic!("seven columns") };
            let (q, u, a) = (s.coordinates, s.velocities, scene.a);
            let (sin, cos) = q[2].sin_cos();
            let differences = [
                u[0] * cos + u[1] * sin - v,
                u[2] - omega,
                q[2] - theta,
                q[0] - a * cos - x,
                q[1] - a * sin - y,
                -s.multipliers[0] - knife,
            ];
            let error = differences.into_iter().fold(0.0, worse);
            assert!(error <= bar, "{name}: {error:.1e} at {t} s");
            assert!(s.velocity_residual <= SIDEWAYS, "{name}: {:.1e} m/s at {t} s", s.velocity_residual);
        });
    }
}

/// RK4 at 1 ms; the energy turned over is 50 J.
const ENERGY: f64 = 1e-12;

#[test]
fn invariant_sleigh_on_an_incline_keeps_its_energy() {
    let scene = chaplygin_sleigh::Downhill::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).work().every(0.5).run().unwrap();
    for s in run.samples() {
        assert!(s.energy.balance.abs() <= ENERGY, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
}
