//! The command `inverse` on scenes of the crate, against closed forms, and there and back.

use crate::run::{assert_wrong_use, directory, ezy, text};
use crate::{json, output};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;
use std::process::{Command, Output};

/// The arm of the guide.
fn arm(arguments: &[&str], folder: &Path) -> Output {
    let ezy = Path::new(env!("CARGO_BIN_EXE_ezy"));
    let path = ezy.with_file_name("examples").join("led_arm").with_extension(std::env::consts::EXE_EXTENSION);
    assert!(path.exists(), "{} is not built: cargo build -p ezy-models --examples --features analysis", path.display());
    Command::new(path).args(arguments).current_dir(folder).output().expect("the program starts")
}

/// Rows of numbers below a head.
fn table(file: &Path) -> (String, Vec<Vec<f64>>) {
    let content = std::fs::read_to_string(file).unwrap();
    let (head, rows) = content.split_once('\n').expect("a head");
    let numbers = |row: &str| row.split(',').map(|number| number.parse().expect("a number")).collect();
    (head.to_owned(), rows.lines().map(numbers).collect())
}

/// Torques, of their largest: the tolerance 1e-9 of the run, a thousand times in its accelerations.
const FOLLOWED: f64 = 1e-6;

#[test]
fn analytic_parallelogram_takes_the_torque_of_a_pendulum() {
    let out = directory("inverse_fourbar").join("torque.csv");
    let file = out.to_str().expect("a name");
    output(&["inverse", "fourbar/driven", "--every", "0.01", "--out", file]);
    let (head, rows) = table(&out);
    assert_eq!((head.as_str(), rows.len()), ("t [s],lambda.motor [N*m]", 201));
    for row in &rows {
        let [t, lambda] = row[..] else { panic!("{row:?}") };
        // one pendulum of 5/3 kg m² and 19.62 N m; the reaction is −λ
        let (angle, alpha) = (FRAC_PI_2 + 0.5 * (3.0 * t).sin(), -0.5 * 9.0 * (3.0 * t).sin());
        let torque = 5.0 / 3.0 * alpha + 19.62 * angle.cos();
        assert!((lambda + torque).abs() <= FOLLOWED * 19.62, "{lambda} for {torque} at {t}");
    }
    let found = json(&["inverse", "fourbar/driven", "--json"]);
    let balance = |name: &str| found["balance"][name].as_f64().expect("a number");
    // no friction: work is the change of the energy, here 5/6 θ̇² + 19.62 sin θ
    let energy = |t: f64| {
        let rate = 1.5 * (3.0 * t).cos();
        5.0 / 6.0 * rate * rate + 19.62 * (FRAC_PI_2 + 0.5 * (3.0 * t).sin()).sin()
    };
    let change = energy(2.0) - energy(0.0);
    for (found, expected) in [("work", change), ("change_of_energy", change), ("taken_by_others", 0.0)] {
        assert!((balance(found) - expected).abs() <= FOLLOWED * 19.62, "{found}: {} for {expected}", balance(found));
    }
    assert!(found["stopped"].is_null() && found["values"][0]["unit"] == "N*m", "{found}");
}

/// Torques of shoulder and elbow, by Lagrange's equations of two angles (Spong, Hutchinson and Vidyasagar, ch. 7), where the tool goes round.
fn torques_of_the_arm(t: f64) -> [f64; 2] {
    let (l1, l2, m1, m2, m_tool, g, r, damping) = (0.5, 0.4, 3.0, 2.0, 1.0, 9.81, 0.15, 0.5);
    let s = TAU * t - (TAU * t).sin();
    let (s1, s2) = (TAU * (1.0 - (TAU * t).cos()), TAU * TAU * (TAU * t).sin());
    let [x, y] = [l1 - r + r * s.cos(), l2 + r * s.sin()];
    let [x1, y1] = [-r * s.sin() * s1, r * s.cos() * s1];
    let [x2, y2] = [-r * s.cos() * s1 * s1 - r * s.sin() * s2, -r * s.sin() * s1 * s1 + r * s.cos() * s2];
    // the elbow by the law of cosines; below the line to the tool
    let bend = ((x * x + y * y - l1 * l1 - l2 * l2) / (2.0 * l1 * l2)).acos();
    let a = y.atan2(x) - (l2 * bend.sin()).atan2(l1 + l2 * bend.cos());
    let b = a + bend;
    // rates and accelerations of absolute angles from J [ȧ ḃ] = [ẋ ẏ]
    let solve = |p: f64, q: f64| {
        let determinant = l1 * l2 * (b - a).sin();
        [(l2 * b.cos() * p + l2 * b.sin() * q) / determinant, (-l1 * a.cos() * p - l1 * a.sin() * q) / determinant]
    };
    let [a1, b1] = solve(x1, y1);
    let [c, d] = [l1 * a1 * a1, l2 * b1 * b1];
    let [a2, b2] = solve(x2 + c * a.cos() + d * b.cos(), y2 + c * a.sin() + d * b.sin());
    // coefficients of the kinetic energy A ȧ²/2 + B ḃ²/2 + C ȧ ḃ cos(b − a); the tool has an inertia of its own
    let big_a = (m1 / 3.0 + m2 + m_tool) * l1 * l1;
    let big_b = (m2 / 3.0 + m_tool) * l2 * l2 + 1e-3;
    let big_c = (m2 / 2.0 + m_tool) * l1 * l2;
    let elbow = big_b * b2
        + big_c * (a2 * (b - a).cos() + a1 * a1 * (b - a).sin())
        + (m2 / 2.0 + m_tool) * g * l2 * b.cos()
        + damping * (b1 - a1);
    let of_upper = big_a * a2
        + big_c * (b2 * (b - a).cos() - b1 * b1 * (b - a).sin())
        + (m1 / 2.0 + m2 + m_tool) * g * l1 * a.cos()
        - damping * (b1 - a1);
    [of_upper + elbow, elbow]
}

#[test]
fn analytic_arm_takes_the_torques_of_lagrange() {
    let folder = directory("inverse_arm");
    let done = arm(&["inverse", "ledarm/led", "--by", "shoulder,elbow", "--out", "torque.csv"], &folder);
    let told = text(&done.stdout);
    assert!(done.status.success() && told.contains("inputs in place of the drives from t = 0 s to 1 s"), "{told}");
    let (head, rows) = table(&folder.join("torque.csv"));
    assert_eq!((head.as_str(), rows.len()), ("t [s],shoulder [N*m],elbow [N*m]", 1001));
    let largest = rows.iter().flat_map(|row| &row[1..]).fold(0.0, |most: f64, x| most.max(x.abs()));
    for row in &rows {
        for (found, expected) in row[1..].iter().zip(torques_of_the_arm(row[0])) {
            assert!((found - expected).abs() <= FOLLOWED * largest, "{found} for {expected} at {}", row[0]);
        }
    }
}

/// Straight lines between rows leave errors of the order of the square of their distance, and steps that hold a value as well.
#[test]
fn order_motors_alone_follow_the_path_with_errors_of_order_two() {
    let folder = directory("inverse_back");
    let error = |step: &str| {
        let done =
            arm(&["inverse", "ledarm/led", "--by", "elbow,shoulder", "--every", step, "--out", "torque.csv"], &folder);
        assert!(done.status.success(), "{}", text(&done.stderr));
        let done = arm(&["run", "ledarm/moved", "--inputs", "torque.csv", "--step", step, "--json"], &folder);
        let end: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
        // once round: back where it began
        let [x, y] = ["tool.x", "tool.y"].map(|name| end["state"][name].as_f64().expect("a number"));
        (x - 0.5).hypot(y - 0.4)
    };
    let (coarse, fine) = (error("0.004"), error("0.002"));
    let order = (coarse / fine).log2();
    assert!((1.8..2.2).contains(&order) && fine < 1e-3, "{order}: {coarse} m, {fine} m");
}

#[test]
fn invariant_what_cannot_be_found_says_why() {
    assert_wrong_use(&["inverse", "fourbar/turning"], "fourbar/turning has no drive");
    assert_wrong_use(&["inverse", "fourbar/turning"], "docs/language.md");
    assert_wrong_use(&["inverse", "fourbar/driven", "--drive", "moter"], "did you mean `motor`?");
    assert_wrong_use(&["inverse", "fourbar/driven", "--by", "torque"], "torque");
    assert_wrong_use(&["inverse", "fourbar/driven", "--out", "torque.txt"], "values are written as .csv");
    let folder = directory("inverse_wrong");
    let done = arm(&["inverse", "ledarm/led", "--by", "shoulder"], &folder);
    let told = text(&done.stderr);
    assert!(done.status.code() == Some(2) && told.contains("1 inputs cannot take the place of 2 rows"), "{told}");
    assert!(told.contains("the rows: across, up"), "{told}");
    // before the tool is out of reach the values are there
    let done =
        arm(&["inverse", "ledarm/led", "--set", "r=0.55", "--by", "shoulder,elbow", "--out", "torque.csv"], &folder);
    let told = text(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{told}");
    let (_, rows) = table(&folder.join("torque.csv"));
    assert!(told.contains("the run ") && rows.len() > 1 && rows.len() < 1001, "{told} {}", rows.len());
    let help = text(&ezy(&["inverse", "--help"]).stdout);
    assert!(help.split_whitespace().collect::<Vec<_>>().join(" ").contains("--inputs FILE.csv --step H"), "{help}");
}
