//! Remarks on what a run with its tolerance does not tell.

use crate::{ezy, output, text};

#[test]
fn invariant_motion_that_amplifies_errors_is_remarked_on() {
    let run = ["run", "doublependulum/swing", "--method", "taylor", "--estimate-error"];
    assert!(output(&run).contains("remark: the motion makes a small change of its start "));
    assert!(!output(&[&run[..], &["--until", "1"]].concat()).contains("remark: the motion makes"));
}

#[test]
fn invariant_what_many_steps_add_up_to_is_told() {
    let run = ["run", "rollerracer/rowed_on_tarmac"];
    let object: serde_json::Value =
        serde_json::from_str(&output(&[&run[..], &["--rtol", "1e-12", "--json"]].concat())).expect("JSON");
    let sum = object["cost"]["steps"].as_f64().unwrap() * 1e-12;
    assert!((object["added_up"].as_f64().unwrap() / sum - 1.0).abs() < 1e-12, "{object}");
    let told = format!("\nerrors of these steps may add up to {sum:.1e} of one more than each number, ");
    let told_of = |more: &[&str]| output(&[&run[..], more].concat());
    assert!(told_of(&["--rtol", "1e-12"]).contains(&told), "{told}");
    // a fixed step has no tolerance
    assert!(!told_of(&["--step", "1e-3"]).contains("add up"));
}

#[test]
fn invariant_tolerance_below_rounding_is_lifted_and_told() {
    let run = |rtol| ezy(&["run", "pendulum/swing", "--until", "0.1", "--rtol", rtol, "--json"]);
    let below = run("1e-17");
    let json: serde_json::Value = serde_json::from_slice(&below.stdout).expect("JSON");
    assert!(below.status.success() && json["relative_tolerance"] == 1e-15, "{json}");
    let remark = "remark: the relative tolerance 1e-17 is below rounding; the run kept to 1e-15\n";
    assert_eq!(text(&below.stderr), remark);
    let smallest = run("1e-15");
    assert!(!text(&smallest.stdout).contains("relative_tolerance") && !text(&smallest.stderr).contains("remark"));
}

/// A condition of 4e4 makes 1e-11 of the rounding of a number, and the iteration of Radau leaves as much of any motion.
#[test]
fn invariant_tolerance_that_rounding_does_not_keep_is_told() {
    let run = |scene: &[&str], method, rtol| {
        let run = ezy(&[&["run", "--json", "--until", "0.1", "--method", method, "--rtol", rtol], scene].concat());
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
        let remarks = text(&run.stderr).contains("remark: the tolerance is not reached: ");
        assert_eq!(remarks, json["attainable_tolerance"].is_number(), "{json}");
        (remarks, json)
    };
    let short_links = ["wheeledsnake/slithering", "--set", "l=0.006"];
    let (remarks, json) = run(&short_links, "taylor", "1e-12");
    let expected = json["monitors"]["condition"]["largest"].as_f64().unwrap() * f64::EPSILON;
    assert!(remarks && json["attainable_tolerance"] == expected && expected > 1e-12, "{json}");
    assert!(!run(&short_links, "taylor", "1e-9").0);
    let pendulum = ["pendulum/swing"];
    assert_eq!(run(&pendulum, "radau", "1e-12").1["attainable_tolerance"], 1e-11);
    assert!(!run(&pendulum, "radau", "1e-10").0 && !run(&pendulum, "dop853", "1e-12").0);
}

/// A pendulum knocks ever more softly: a third less each time.
#[test]
fn invariant_impacts_softer_than_the_tolerance_are_told() {
    let run = |until| {
        let knocks = ["run", "pendulum/knocking", "--json", "--set", "e=0.7", "--rtol", "1e-7", "--until", until];
        let run = ezy(&knocks);
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).expect("JSON");
        (text(&run.stderr).contains("remark: the softest impact has "), json)
    };
    let [(of_few, few), (of_many, many)] = ["20", "80"].map(run);
    let softest = |json: &serde_json::Value| json["monitors"]["softest_impact"]["speed"].as_f64().unwrap();
    assert!(!of_few && softest(&few) > 1e-5, "{few}");
    assert!(of_many && softest(&many) < 1e-5, "{many}");
}
