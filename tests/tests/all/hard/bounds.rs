//! Hard cases that run in a second or two keep the bounds of their references; `examples/hard_cases.rs` runs all.

use ezy_tests::hard::case::How;
use ezy_tests::hard::families::families;

/// Bounds that are known to be missed; `docs/hard-cases.md` says why.
const MISSED: [(&str, &str); 1] =
    [("caster_trail_1e-2", "100 trail/speed over a step of radau, 1e-6, after alignment")];

fn keeps_its_bounds(name: &str) {
    let families = families();
    let family = families.iter().find(|family| family.name == name).expect("a family");
    assert!(family.cases.iter().any(|case| case.is_quick), "{name} has no case that a test could run");
    let mut faults = Vec::new();
    for case in family.cases.iter().filter(|case| case.is_quick) {
        let findings = (case.examine)(How::Alone);
        for check in findings.checks.iter().filter(|check| !check.is_time) {
            let is_known_to_miss = MISSED.contains(&(case.name.as_str(), check.what.as_str()));
            if check.is_met() == is_known_to_miss {
                let (verdict, stopped) = (
                    if is_known_to_miss { "kept now" } else { "missed" },
                    findings.stopped.as_deref().unwrap_or_default(),
                );
                faults.push(format!(
                    "{}, {}: {:.1e}, bound {:.1e}: {verdict} {stopped}",
                    case.name, check.what, check.reached, check.bound
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn reference_ratios_of_masses_and_bodies_without_mass() {
    keeps_its_bounds("masses");
}

#[test]
fn reference_redundant_rows() {
    keeps_its_bounds("redundant");
}

#[test]
fn reference_singular_positions() {
    keeps_its_bounds("singular");
}

#[test]
fn reference_fast_modes_beside_slow_motion() {
    keeps_its_bounds("stiff");
}

#[test]
fn reference_fast_turns() {
    keeps_its_bounds("spinning");
}

#[test]
fn reference_inconsistent_starts() {
    keeps_its_bounds("starts");
}

#[test]
fn reference_mechanisms_of_the_literature() {
    keeps_its_bounds("classical");
}

#[test]
fn reference_vehicles_without_slip() {
    keeps_its_bounds("rolling");
}

#[test]
fn reference_short_chains() {
    keeps_its_bounds("chains");
}
