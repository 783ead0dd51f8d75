//! Hard cases that run in a second or two keep what the page says; the example `measure` runs all.

use ezy_tests::hard::case::{By, How, METHODS, Pace, Purpose};
use ezy_tests::hard::families::families;
use ezy_tests::hard::page::lost;
use ezy_tests::page::docs;

/// The quickest without optimisation.
const METHOD: &str = "taylor";

fn keeps_its_bounds(name: &str) {
    let families = families();
    let family = families.iter().find(|family| family.name == name).expect("a family");
    let page = std::fs::read_to_string(docs("hard-cases.md")).unwrap();
    let (k, (_, method)) = METHODS.iter().enumerate().find(|(_, (name, _))| *name == METHOD).expect("a method");
    let (mut faults, mut n_kept) = (Vec::new(), 0);
    for case in family.cases.iter().filter(|case| case.pace == Pace::Quick) {
        let how = How { method: *method, tolerance: case.tolerance, purpose: Purpose::Page };
        let findings = (case.examine)(how);
        n_kept += findings.checks.iter().filter(|check| check.is_met()).count();
        faults.extend(lost(&page, case, if case.by == By::Nothing { 0 } else { k }, &findings));
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(n_kept > 0, "{name} has no case that a test could run");
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
