//! The page of hard cases.

use ezy_tests::hard::case::{Case, Check, Findings};
use ezy_tests::hard::page::{broken, gone, table};

/// What is broken where the page was written with the first and found is the second.
fn broken_after(written: Check, found: Check) -> Vec<String> {
    let case =
        Case { name: "rod".to_owned(), why: "it is one", is_quick: true, examine: Box::new(|_| Findings::default()) };
    let findings = |check| Findings { checks: vec![check], ..Findings::default() };
    broken(&table(&[(&case, findings(written))]), &[(&case, findings(found))])
}

#[test]
fn analytic_bound_that_is_no_longer_kept_is_broken() {
    assert_eq!(broken_after(Check::new("gap", 1.0, 0.5), Check::new("gap", 1.0, 2.0)).len(), 1);
    assert_eq!(broken_after(Check::new("gap", 1.0, 0.5), Check::new("gap", 1.0, f64::NAN)).len(), 1);
}

#[test]
fn analytic_bounds_and_cases_that_are_gone_are_broken() {
    // one that the page does not know, and one that it has
    assert_eq!(broken_after(Check::new("gap", 1.0, 0.5), Check::new("angle", 1.0, 0.5)).len(), 2);
    let case = |name: &str| Case {
        name: name.to_owned(),
        why: "it is one",
        is_quick: true,
        examine: Box::new(|_| Findings::default()),
    };
    let (rod, wheel) = (case("rod"), case("wheel"));
    let page = table(&[(&rod, Findings { checks: vec![Check::new("gap", 1.0, 0.5)], ..Findings::default() })]);
    assert_eq!((gone(&page, &[&rod]).len(), gone(&page, &[&wheel]).len()), (0, 1));
}

#[test]
fn analytic_bound_that_is_kept_or_was_missed_before_is_not_broken() {
    for reached in [0.5, 2.0] {
        assert!(broken_after(Check::new("gap", 1.0, 2.0), Check::new("gap", 1.0, reached)).is_empty());
    }
    assert!(broken_after(Check::new("gap", 1.0, 0.5), Check::new("gap", 1.0, 0.6)).is_empty());
}

#[test]
fn analytic_bound_on_times_is_not_broken() {
    assert!(broken_after(Check::of_times("ratio", 1.0, 0.5), Check::of_times("ratio", 1.0, 2.0)).is_empty());
}
