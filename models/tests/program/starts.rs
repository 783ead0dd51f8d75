//! What the program says of start values that give way.

use crate::{ezy, text};

const LONGER_BASE: [&str; 6] = ["run", "fourbar/turning", "--set", "base=1.3", "--until", "0"];

#[test]
fn invariant_start_values_that_gave_way_are_a_table_and_a_list() {
    let done = ezy(&LONGER_BASE);
    let said = text(&done.stdout);
    assert!(done.status.success() && said.contains("gave way at the start"), "{said}");
    let line = said.lines().find(|line| line.starts_with("rocker.phi")).expect("the rocker gave way");
    assert!(line.contains("1.570796326795") && line.contains("rad"), "{line}");
    let told: serde_json::Value =
        serde_json::from_slice(&ezy(&[&LONGER_BASE[..], &["--json"]].concat()).stdout).expect("JSON");
    let names: Vec<_> = told["gave_way"].as_array().expect("a list").iter().map(|value| &value["name"]).collect();
    assert_eq!(names, ["coupler.phi", "rocker.phi"]);
    let rocker = &told["gave_way"][1];
    assert_eq!((&rocker["got"], rocker["unit"].as_str()), (&told["state"]["rocker.phi"], Some("rad")));
}

#[test]
fn invariant_start_values_that_are_held_are_not_mentioned() {
    let as_declared = ["run", "fourbar/turning", "--until", "0"];
    assert!(!text(&ezy(&as_declared).stdout).contains("gave way"));
    assert!(!text(&ezy(&[&as_declared[..], &["--json"]].concat()).stdout).contains("gave_way"));
}

/// Nobody says how the trucks and the rotor turn.
#[test]
fn invariant_start_values_that_nobody_gave_are_a_line_and_a_list() {
    let stroked = ["run", "snakeboard/stroked", "--until", "0"];
    let said = text(&ezy(&stroked).stdout);
    let line = "\n\nfree at the start, so assembled from 0: rotor.omega, front.omega, back.omega\n\ncoordinate ";
    assert!(said.contains(line), "{said}");
    let free = |given: &[&str]| -> serde_json::Value {
        let done = ezy(&[&stroked[..], &["--json"], given].concat());
        serde_json::from_slice::<serde_json::Value>(&done.stdout).expect("JSON")["free_at_start"].clone()
    };
    assert_eq!(free(&[]), serde_json::json!(["rotor.omega", "front.omega", "back.omega"]));
    assert_eq!(free(&["--start", "front.omega=0.1"]), serde_json::json!(["rotor.omega", "back.omega"]));
    let all = ["--start", "rotor.omega=0", "--start", "front.omega=0", "--start", "back.omega=0"];
    assert!(free(&all).is_null());
}
