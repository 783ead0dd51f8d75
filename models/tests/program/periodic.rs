//! The command `periodic`: what it prints, writes and draws.

use crate::run::assert_wrong_use;
use crate::{directory, json, output, table};
use std::fs;

/// Where the search ends, of the largest value of its kind.
const RETURNS: f64 = 1e-9;

#[test]
fn invariant_gait_is_told_written_and_drawn() {
    let folder = directory("periodic");
    let [table_file, figure] = ["gait.csv", "multipliers.svg"].map(|name| folder.join(name));
    let (out, plot) = (table_file.to_str().unwrap(), figure.to_str().unwrap());
    let told = output(&["periodic", "ezyroller/driven_on_tarmac", "--period", "2", "--out", out, "--plot", plot]);
    for words in ["periodic, T = 2 s", "stable: small deviations fade", "of place and heading", out, plot] {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
    let svg = fs::read_to_string(&figure).unwrap();
    assert!(svg.contains("unit circle") && svg.contains("multipliers"), "{svg}");

    // seen from the seat, everything is after the period as before
    let (head, rows) = table(&table_file);
    let of = |name: &str| head.iter().position(|column| column == name).unwrap();
    let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.iter().map(|x| x.parse().unwrap()).collect()).collect();
    let (first, last) = (&rows[0], &rows[rows.len() - 1]);
    assert!((last[of("t [s]")] - first[of("t [s]")] - 2.0).abs() <= f64::EPSILON);
    let angle = |row: &[f64]| row[of("bar.phi [rad]")] - row[of("seat.phi [rad]")];
    let speed = |row: &[f64]| f64::hypot(row[of("seat.vx [m/s]")], row[of("seat.vy [m/s]")]);
    assert!((angle(last) - angle(first)).abs() <= RETURNS * angle(first).abs());
    assert!((speed(last) - speed(first)).abs() <= RETURNS * speed(first));
    // and it went on
    assert!(f64::hypot(last[1] - first[1], last[2] - first[2]) > 1.0, "{first:?} {last:?}");
}

/// Without friction a pendulum keeps its amplitude: the period is a free value, 4 K(sin θ/2) √(l/g), and M has a block of two.
#[test]
fn analytic_period_of_a_pendulum_is_found() {
    let command = ["periodic", "pendulum/swing", "--period-near", "2.3", "--hold", "bob.phi,bob.omega", "--json"];
    let found = json(&command);
    let period = found["period"].as_f64().unwrap();
    // by the arithmetic-geometric mean of 1 and cos θ/2, with θ = π/2
    let (mut a, mut b) = (1.0, (0.25 * std::f64::consts::PI).cos());
    for _ in 0..5 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    let exact = std::f64::consts::TAU * f64::sqrt(1.0 / 9.81) / a;
    assert!((period - exact).abs() <= RETURNS * exact, "{period} s for {exact} s");
    assert_eq!(found["verdict"], "neutral", "{found}");
}

#[test]
fn invariant_wrong_use_of_periodic_says_how() {
    let of = |more: &[&'static str]| [&["periodic", "ezyroller/driven_on_tarmac"], more].concat();
    assert_wrong_use(&of(&["--period", "0"]), "0 s");
    assert_wrong_use(&of(&["--period", "2", "--plot", "gait.txt"]), "figures are written as .svg, .png or .html");
    assert_wrong_use(&of(&["--period", "2", "--out", "gait.txt"]), "csv");
    assert_wrong_use(&of(&["--period", "2", "--hold", "seat.fi"]), "did you mean `seat.phi`?");
}
