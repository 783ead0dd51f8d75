//! The command `equilibrium` on scenes of the crate, against closed forms.

use crate::run::{assert_wrong_use, ezy, text};
use crate::{directory, json, output};

/// Positions of a rest, rad.
const STEADY: f64 = 1e-11;

#[test]
fn analytic_double_pendulum_hangs_below_its_start() {
    let start = ["equilibrium", "doublependulum/swing", "--start", "upper.phi=-1.4", "--start", "lower.phi=-1.5"];
    let told = output(&start);
    for words in
        ["DoublePendulum/swing: steady at rest", "reaction", " N\n", "neutral by the linear part: 4 eigenvalues"]
    {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
    let rest = json(&[&start[..], &["--json"]].concat());
    for angle in ["upper.phi", "lower.phi"] {
        let left = rest["steady"]["state"][angle].as_f64().expect("a number") + std::f64::consts::FRAC_PI_2;
        assert!(left.abs() <= STEADY, "{rest}");
    }
    assert_eq!((&rest["steady"]["kind"], &rest["verdict"]), (&"rest".into(), &"neutral".into()), "{rest}");
}

#[test]
fn analytic_all_rests_of_a_double_pendulum() {
    let path = ["equilibrium", "doublependulum/swing", "--all"];
    let told = output(&path);
    assert!(told.contains("4 rests found from 128 starts") && told.contains("unstable"), "{told}");
    let all = json(&[&path[..], &["--json"]].concat());
    let rests = all["rests"].as_array().expect("a list");
    let mut unstable: Vec<u64> = rests.iter().filter_map(|rest| rest["unstable"].as_u64()).collect();
    unstable.sort_unstable();
    assert_eq!(unstable, [0, 1, 1, 2], "{all}");
    let starts: u64 = rests.iter().filter_map(|rest| rest["starts"].as_u64()).sum();
    assert_eq!(starts + all["lost"].as_u64().expect("a number"), 128);
}

#[test]
fn invariant_steady_run_has_a_speed_and_names_what_is_free() {
    let told = output(&["equilibrium", "ezyroller/coast", "--start", "bar.phi=0", "--start", "seat.omega=0"]);
    for words in ["steady straight at 1 m/s", "with other values of bar.", "Newton step"] {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
}

#[test]
fn invariant_what_is_not_steady_says_why() {
    // down a slope it goes faster and faster
    let done = ezy(&["equilibrium", "chaplyginsleigh/downhill"]);
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stdout));
    let told = text(&done.stderr);
    assert!(told.contains("steady"), "{told}");
    assert_wrong_use(&["equilibrium", "doublependulum/swing", "--hold", "uper.phi"], "did you mean `upper.phi`?");
}

/// Of a car whose rear tyres give way first the steering angle has a largest value, at a fold; to both sides alike.
#[test]
fn invariant_diagram_over_a_steering_angle_has_two_folds() {
    let folder = directory("bifurcation_diagram");
    let [csv, figure] = ["turns.csv", "turns.svg"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let car = ["equilibrium", "singletrackcar/limit", "--set", "fr=5e3", "--set", "ff=7e3"];
    let varied = [&car[..], &["--vary", "delta=-0.15:0.15:0.005"]].concat();
    let told = output(&[&varied[..], &["--out", &csv, "--plot", &figure]].concat());
    assert!(told.contains("1 branch over delta") && told.contains("car.omega [rad/s]"), "{told}");
    assert_eq!(told.matches("  fold  ").count(), 2, "{told}");
    let rows = std::fs::read_to_string(&csv).unwrap();
    assert!(rows.starts_with("branch,delta [rad],bifurcation,unstable,car.x [m],"), "{rows}");
    assert!(std::fs::read_to_string(&figure).unwrap().contains("unstable"));

    let diagram = json(&[&varied[..], &["--json"]].concat());
    let points = diagram["branches"][0]["points"].as_array().unwrap();
    assert_eq!(points.len() + 1, rows.lines().count());
    let folds: Vec<f64> =
        points.iter().filter(|p| p["bifurcation"] == "fold").map(|p| p["value"].as_f64().unwrap()).collect();
    assert!((folds[0] + folds[1]).abs() <= 1e-10 && folds[0].abs() > 0.04, "{folds:?}");
    // beyond it no turn is near the start
    let delta = format!("delta={}", folds[0].abs() + 1e-3);
    let beyond = ezy(&[&car[..], &["--set", &delta]].concat());
    assert_eq!(beyond.status.code(), Some(1), "{}", text(&beyond.stdout));
}

#[test]
fn invariant_what_cannot_vary_is_refused() {
    let scene = ["equilibrium", "doublependulum/swing", "--vary"];
    let refused = |vary: &str, words: &str| assert_wrong_use(&[&scene[..], &[vary]].concat(), words);
    refused("lenght=1:2:0.1", "`lenght` is not known");
    refused("rtol=1e-9,1e-6", "a steady motion has no rtol");
    refused("g=9.81", "one value is no range");
}

/// Knots that hang below each other carry what is below them, and no thread across carries anything.
#[test]
fn analytic_hanging_net_comes_to_rest_from_its_push() {
    let rest = json(&["equilibrium", "hangingnet/swing", "--set", "rows=4", "--set", "columns=4", "--json"]);
    assert_eq!(rest["steady"]["kind"], "rest", "{rest}");
    for (row, tension) in rest["steady"]["multipliers"].as_object().expect("an object") {
        let tension = tension.as_f64().expect("a number");
        let below = match row.strip_prefix("warp[").and_then(|rest| rest.split(',').next()?.parse::<f64>().ok()) {
            Some(i) => 4.0 - i,
            None if row.ends_with(".y") => 4.0,
            None => 0.0,
        };
        // of the weight of a column
        assert!((tension.abs() - below * 0.01 * 9.81).abs() <= STEADY * 4.0 * 0.01 * 9.81, "{row}: {tension} N");
    }
}

/// Folded rests have no linear equations: the others are told all the same.
#[test]
fn invariant_rests_without_linear_equations_are_listed() {
    let path = ["equilibrium", "hangingnet/swing", "--all", "--set", "rows=2"];
    let all = json(&[&path[..], &["--json"]].concat());
    let rests = all["rests"].as_array().expect("a list");
    let unknown = rests.iter().filter(|rest| rest["verdict"] == "unknown").count();
    assert!(unknown > 0 && unknown < rests.len(), "{unknown} of {}", rests.len());
    assert!(rests.iter().all(|rest| (rest["verdict"] == "unknown") == rest["error"].is_string()), "{all}");
}
