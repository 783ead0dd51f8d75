//! The command `linearize` on scenes of the crate, against closed forms.

use crate::run::{assert_wrong_use, directory, ezy, text};
use crate::{json, output};
use std::fs;

/// Of eigenvalues, as a share of themselves.
const EIGENVALUES: f64 = 1e-10;
/// Of critical values.
const CRITICAL: f64 = 1e-10;

/// ±i √(g/l) about the lower position.
#[test]
fn analytic_pendulum_swings_about_rest() {
    let hanging = json(&["linearize", "pendulum/swing", "--start", "bob.phi=-1.4", "--json"]);
    assert_eq!((hanging["steady"]["kind"].as_str(), hanging["verdict"].as_str()), (Some("rest"), Some("neutral")));
    let angle = hanging["steady"]["state"]["bob.phi"].as_f64().unwrap();
    assert!((angle + std::f64::consts::FRAC_PI_2).abs() <= 1e-12, "{angle}");
    let omega = hanging["eigenvalues"][0]["imaginary"].as_f64().unwrap();
    assert!((omega / 9.81f64.sqrt() - 1.0).abs() <= EIGENVALUES, "{omega}");
    let told = output(&["linearize", "pendulum/swing", "--start", "bob.phi=1.4"]);
    for part in ["Pendulum/swing: steady at rest", "unstable: 1 eigenvalue", "no eigenvalue is zero", "bob.phi"] {
        assert!(told.contains(part), "{part} in {told}");
    }
}

/// An oversteering car diverges above u = √(cf cr L² / (m (lf cf − lr cr))).
#[test]
fn analytic_car_has_its_critical_speed() {
    let (m, lf, lr, cf, cr) = (1500.0, 1.6, 1.1, 1e5, 8e4);
    let exact = f64::sqrt(cf * cr * (lf + lr) * (lf + lr) / (m * (lf * cf - lr * cr)));
    let folder = directory("linearize_vary");
    let [table, figure] = ["locus.csv", "locus.svg"].map(|name| folder.join(name).display().to_string());
    let vary = "linearize singletrackcar/cornering --set delta=0 --set lf=1.6 --set lr=1.1 --set cf=1e5 --set cr=8e4 \
                --vary u=10:60:10 --json";
    let arguments = vary.split(' ').chain(["--out", &table, "--plot", &figure]);
    let locus = json(&arguments.collect::<Vec<_>>());
    let [critical] = &locus["critical"].as_array().unwrap()[..] else { panic!("{locus}") };
    let value = critical["value"].as_f64().unwrap();
    assert!((value / exact - 1.0).abs() <= CRITICAL, "{value} for {exact}");
    assert_eq!((critical["kind"].as_str(), critical["unstable_above"].as_u64()), (Some("divergence"), Some(1)));
    let rows = fs::read_to_string(table).unwrap();
    assert!(rows.starts_with("u [m/s],real [1/s],imaginary [1/s]\n10,"), "{rows}");
    let n_eigenvalues: usize =
        locus["points"].as_array().unwrap().iter().map(|point| point["eigenvalues"].as_array().unwrap().len()).sum();
    assert_eq!(rows.lines().count(), 1 + n_eigenvalues);
    assert!(fs::read_to_string(figure).unwrap().contains("real part [1/s]"));
}

/// A pair of eigenvalues ±i times the turn rate is that of circles about other centres: no doubt about the stability of the circle.
#[test]
fn invariant_circle_is_stable_besides_its_centre() {
    let scene = "singletrackcar/cornering";
    let circle = json(&["linearize", scene, "--json"]);
    assert_eq!((circle["steady"]["kind"].as_str(), circle["verdict"].as_str()), (Some("circle"), Some("stable")));
    let turn_rate = circle["steady"]["turn_rate"].as_f64().unwrap();
    let of_centre = circle["eigenvalues"][0]["imaginary"].as_f64().unwrap();
    assert!((of_centre / turn_rate - 1.0).abs() <= EIGENVALUES, "{of_centre} for {turn_rate}");
    assert!(output(&["linearize", scene]).contains("circles about other centres"));
    let examples = output(&["linearize", "--help"]);
    let example = examples.lines().find_map(|line| line.trim().strip_prefix("ezy linearize")).expect("an example");
    let words = example.split("   ").next().unwrap_or_default().split_whitespace();
    output(&["linearize"].into_iter().chain(words).collect::<Vec<_>>());
}

#[test]
fn invariant_what_is_not_linearized_says_why() {
    assert_wrong_use(&["linearize", "ezyroller/coast", "--hold", "seat.fi"], "did you mean `seat.phi`?");
    assert_wrong_use(&["linearize", "pendulum/swing", "--hold", "bob.omega"], "cannot be held");
    assert_wrong_use(&["linearize", "ezyroller/coast", "--vary", "method=rk4"], "a linearization has no method");
    assert_wrong_use(&["linearize", "ezyroller/coast", "--out", "a.csv"], "--vary");
    // a torque that nothing balances
    let done = ezy(&["linearize", "ezyroller/driven"]);
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stdout));
    assert!(text(&done.stderr).contains("no steady motion was found near the start"), "{}", text(&done.stderr));
}
