//! The commands `plot` and `compare`.

use std::fs;
use std::path::Path;

use crate::{assert_wrong_use, directory, ezy, text};

/// What a command that must succeed prints.
fn done(arguments: &[&str]) -> String {
    let done = ezy(arguments);
    assert_eq!(done.status.code(), Some(0), "{arguments:?}: {}", text(&done.stderr));
    text(&done.stdout)
}

/// Texts of a figure, in the order in which they are drawn.
fn texts(svg: &Path) -> Vec<String> {
    let svg = fs::read_to_string(svg).unwrap();
    let labels = svg.split("aria-label=\"").skip(1);
    labels.map(|rest| rest.split('"').next().unwrap().to_owned()).collect()
}

#[test]
fn invariant_plot_has_a_panel_for_each_unit_and_names_its_curves() {
    let svg = directory("plot_units").join("coast.svg");
    let out = svg.to_str().unwrap();
    let printed = done(&["plot", "ezyroller/coast", "seat.phi", "*.omega", "C.x", "--out", out]);
    assert_eq!(printed, format!("{out}\n"));
    let texts = texts(&svg);
    for expected in [
        "EzyRoller/coast".to_lowercase().as_str(),
        "seat.phi [rad]",
        "angular velocity [rad/s]",
        "C.x [m]",
        "bar.omega",
        "time [s]",
    ] {
        assert_eq!(texts.iter().filter(|text| *text == expected).count(), 1, "{expected} in {texts:?}");
    }
}

#[test]
fn regress_plot_is_the_same_to_the_byte() {
    let directory = directory("plot_bytes");
    let [one, two] = ["one.svg", "two.svg"].map(|name| directory.join(name));
    for path in [&one, &two] {
        done(&["plot", "ezyroller/coast", "bar.phi", "kinetic", "--out", path.to_str().unwrap()]);
    }
    assert_eq!(fs::read(one).unwrap(), fs::read(two).unwrap());
}

#[test]
fn invariant_plot_varies_what_it_is_told_and_names_the_values() {
    let svg = directory("plot_vary").join("vary.svg");
    let out = svg.to_str().unwrap();
    let arguments =
        ["plot", "ezyroller/coast", "bar.phi", "--vary", "d=0.1,0.2", "--vary", "method=rk4,dop853", "--out", out];
    done(&arguments);
    let texts = texts(&svg);
    for expected in ["d = 0.1, method = rk4", "d = 0.2, method = dop853", "bar.phi [rad]"] {
        assert!(texts.iter().any(|text| text == expected), "{expected} in {texts:?}");
    }
}

#[test]
fn invariant_plot_writes_what_the_ending_says() {
    let directory = directory("plot_endings");
    let path = |name: &str| directory.join(name).to_str().unwrap().to_owned();
    done(&["plot", "ezyroller/coast", "C.y", "--against", "C.x", "--out", &path("path.png")]);
    done(&["plot", "ezyroller/coast", "seat.omega", "--against", "seat.phi", "--out", &path("plane.html")]);
    assert!(fs::read(path("path.png")).unwrap().starts_with(b"\x89PNG"));
    let page = fs::read_to_string(path("plane.html")).unwrap();
    assert!(page.contains("seat.omega over seat.phi") && page.matches("<svg").count() == 2, "wide and narrow");
}

#[test]
fn invariant_wrong_plots_say_what_to_do() {
    let out = directory("plot_wrong").join("x.svg");
    let out = out.to_str().unwrap();
    let wrong = |arguments: &[&str], message: &str| {
        assert_wrong_use(&[&["plot"], arguments, &["--out", out]].concat(), message)
    };
    wrong(&["seat.phi"], "`seat.phi` names no scene");
    wrong(&["ezyroller/coast"], "give one column or several");
    wrong(&["ezyroller/coast", "seat.fi"], "did you mean `seat.phi`?");
    wrong(&["ezyroller/coast", "chair.*"], "column `chair.*` is not known");
    wrong(&["ezyroller/coast", "seat.phi", "--against", "seat.ex"], "did you mean `seat.x`?");
    wrong(&["ezyroller/coast", "seat.phi", "--vary", "mass=1,2"], "value to vary `mass` is not known");
    wrong(&["ezyroller/coast", "seat.phi", "--vary", "method=rk5"], "--vary method: `rk5`");
    wrong(&["ezyroller/coast", "seat.phi", "--vary", "d"], "write NAME=A,B");
    wrong(&["ezyroller/coast", "seat.phi", "--vary", "step=0.1,x"], "`x` is not a finite number");
    assert_wrong_use(
        &["plot", "ezyroller/coast", "seat.phi", "--out", "a.pdf"],
        "figures are written as .svg, .png or .html",
    );
    assert!(!Path::new(out).exists());
}

/// Two files with differences that are computed by hand.
fn two_files(name: &str) -> [String; 2] {
    let directory = directory(name);
    let write = |name: &str, text: &str| {
        let path = directory.join(name);
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let first = "# estimated error: none\nt [s],a.x [m],a.phi [rad]\n0,1,0\n1,2,0.5\n2,4,1\n";
    // at t = 1 between rows: x = 1.5 + 0.5 (4.5 − 1.5) = 3
    let second = "t [s],a.x [m],b.x [m]\n0,1.25,7\n0.5,1.5,7\n1.5,4.5,7\n2,4,7\n3,9,7\n";
    [write("first.csv", first), write("second.csv", second)]
}

#[test]
fn analytic_comparison_of_two_files_is_that_by_hand() {
    let [first, second] = two_files("compare_files");
    let printed = done(&["compare", &first, &second]);
    let row = printed.lines().find(|line| line.starts_with("a.x")).unwrap_or_else(|| panic!("{printed}"));
    assert_eq!(row.split_whitespace().collect::<Vec<_>>(), ["a.x", "1.00e0", "1.000000", "0.00e0", "4.00e0", "m"]);
    assert!(printed.contains("in one of them alone: a.phi, b.x") && printed.contains("interpolated"), "{printed}");
    let json: serde_json::Value = serde_json::from_str(&done(&["compare", &first, &second, "--json"])).unwrap();
    assert_eq!(
        json["columns"],
        serde_json::json!([{ "name": "a.x", "unit": "m", "largest": 1.0, "t": 1.0, "at_end": 0.0, "size": 4.0 }])
    );
}

#[test]
fn cross_comparison_of_two_steps_and_of_their_files_is_one() {
    let directory = directory("compare_steps");
    let file = |step: &str| {
        let path = directory.join(format!("{step}.csv")).to_str().unwrap().to_owned();
        done(&["run", "ezyroller/coast", "--step", step, "--every", "0.05", "--out", &path]);
        path
    };
    let (coarse, fine) = (file("1e-2"), file("1e-3"));
    let columns = |arguments: &[&str]| {
        let json: serde_json::Value =
            serde_json::from_str(&done(&[&["compare"], arguments, &["bar.phi", "--json"]].concat())).unwrap();
        json["columns"].clone()
    };
    let of_runs = columns(&["ezyroller/coast", "--vary", "step=1e-2,1e-3", "--every", "0.05"]);
    assert_eq!(columns(&[&coarse, &fine]), of_runs);
    // RK4 at 10 ms: 4e-8 rad off, measured against the reference in tests/answers
    let largest = of_runs[0]["largest"].as_f64().unwrap();
    assert!((1e-9..1e-6).contains(&largest), "{largest}");
}

#[test]
fn invariant_comparison_draws_both_motions_and_their_difference() {
    let [first, second] = two_files("compare_figure");
    let svg = directory("compare_figure_out").join("difference.svg");
    done(&["compare", &first, &second, "--out", svg.to_str().unwrap()]);
    let texts = texts(&svg);
    assert!(["a.x [m]", "difference [m]"].iter().all(|label| texts.iter().any(|text| text == label)), "{texts:?}");
}

#[test]
fn invariant_wrong_comparisons_say_what_to_do() {
    let [first, second] = two_files("compare_wrong");
    assert_wrong_use(&["compare", &first], "two motions are compared, and there are 1");
    assert_wrong_use(&["compare", "ezyroller/coast", "--vary", "step=1e-2,1e-3,1e-4"], "there are 3");
    assert_wrong_use(&["compare", &first, &second, "a.z"], "did you mean `a.x`?");
    assert_wrong_use(&["compare", &first, &second, "a.phi"], "have none of these columns in common");
    assert_wrong_use(&["compare", &first, "lacking.csv"], "lacking.csv");
    let faulty = |name: &str, text: &str| {
        let path = directory(name).join("faulty.csv");
        fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    assert_wrong_use(&["compare", &first, &faulty("compare_1", "x [m]\n1\n")], "its first column is not time");
    assert_wrong_use(
        &["compare", &first, &faulty("compare_2", "t [s],a.x [m]\n0,one\n")],
        "row 1, column `a.x`: `one` is no number",
    );
    assert_wrong_use(&["compare", &first, &faulty("compare_3", "t [s],a.x [m]\n1,1\n0,1\n")], "time runs backwards");
    assert_wrong_use(
        &["compare", &first, &faulty("compare_4", "t [s],a.x [mm]\n0,1\n")],
        "is in m here and in mm there",
    );
    assert_wrong_use(&["compare", &first, &faulty("compare_5", "t [s],a.x [m]\n9,1\n")], "no time in common");
}
