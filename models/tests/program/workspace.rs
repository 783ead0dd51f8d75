//! The command `workspace` on a slider-crank, whose reach is known.

use crate::run::assert_wrong_use;
use crate::{directory, json, output, table};
use std::fs;

/// Singular positions are found to ten digits.
const FOUND: f64 = 1e-10;

/// The slider goes from l − r to l + r, where crank and rod are in line.
#[test]
fn analytic_slider_reaches_from_one_dead_centre_to_the_other() {
    let command = ["workspace", "slidercrank/falling", "--over", "rod.x=0:2:0.05"];
    let found = json(&[&command[..], &["--json"]].concat());
    let branches = found["branches"].as_array().unwrap();
    assert_eq!(branches.len(), 2, "{found}");
    for branch in branches {
        let mut ends = [0, 1].map(|end| branch["ends"][end]["value"].as_f64().unwrap());
        ends.sort_by(f64::total_cmp);
        let (r, l) = (0.5, 1.0);
        assert!((ends[0] - (l - r)).abs() <= FOUND && (ends[1] - (l + r)).abs() <= FOUND, "{ends:?}");
        assert_eq!(
            (&branch["ends"][0]["limit"], &branch["ends"][1]["limit"]),
            (&"dead centre".into(), &"dead centre".into())
        );
    }
    assert_eq!(found["singular"].as_array().unwrap().len(), 2, "{found}");

    let folder = directory("workspace");
    let [table_file, figure] = ["reach.csv", "reach.svg"].map(|name| folder.join(name));
    let (out, plot) = (table_file.to_str().unwrap(), figure.to_str().unwrap());
    let told = output(&[&command[..], &["--out", out, "--plot", plot]].concat());
    for words in ["2 ways of assembly", "dead centre", out, plot] {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
    assert!(fs::read_to_string(&figure).unwrap().contains("smallest singular value"));
    // the circle of the pin about the bearing, and the rod from the pin to the slider
    let (head, rows) = table(&table_file);
    let of = |name: &str| head.iter().position(|column| column == name).unwrap();
    let mut n_reached = 0;
    for row in &rows {
        let number = |name: &str| row[of(name)].parse::<f64>().unwrap();
        let x = number("rod.x [m]");
        // beside its ends rounding decides
        if (x - 1.0).abs() < 0.49 || (x - 1.0).abs() > 0.51 {
            assert_eq!(row[of("reachable")], if (x - 1.0).abs() < 0.5 { "1" } else { "0" }, "{row:?}");
        }
        if row[of("reachable")] == "1" {
            n_reached += 1;
            let (sin, cos) = number("crank.phi [rad]").sin_cos();
            assert!((f64::hypot(x - 0.5 * cos, 0.5 * sin) - 1.0).abs() <= FOUND, "{row:?}");
        }
    }
    assert!(n_reached >= 38, "{n_reached}");
}

#[test]
fn invariant_wrong_use_of_workspace_says_how() {
    let of = |more: &[&'static str]| [&["workspace", "slidercrank/falling"], more].concat();
    assert_wrong_use(&of(&["--over", "rod.x=1:1:0.1"]), "one value is no range");
    assert_wrong_use(&of(&["--over", "rod.z=0:1:0.1"]), "did you mean `rod.y`?");
    assert_wrong_use(&of(&["--over", "rod.x=0:1:0.1", "--without", "motor"]), "drive");
    assert_wrong_use(
        &of(&["--over", "rod.x=0:1:0.1", "--plot", "reach.txt"]),
        "figures are written as .svg, .png or .html",
    );
}
