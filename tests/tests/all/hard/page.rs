//! The page of hard cases.

use ezy_tests::hard::case::{By, Case, Check, Ended, Findings, METHODS, Pace};
use ezy_tests::hard::page::{broken, gone, reasons, table};

fn case_by(name: &str, by: By, examine: fn(f64) -> Findings) -> Case {
    Case {
        name: name.to_owned(),
        why: "it is one",
        tolerance: 1e-9,
        by,
        pace: Pace::Quick,
        examine: Box::new(move |how| examine(how.tolerance)),
    }
}

fn case(name: &str) -> Case {
    case_by(name, By::Methods, |_| Findings::default())
}

fn findings(check: &Check) -> Findings {
    Findings { checks: vec![check.clone()], ended: Some(Ended::Reached), ..Findings::default() }
}

/// By every method the same.
fn by_all(check: &Check) -> Vec<Findings> {
    vec![findings(check); METHODS.len()]
}

fn page_of(case: &Case, found: Vec<Findings>) -> String {
    table(&[(case, found)], &[])
}

/// What is broken where the page was written with the first and found is the second.
fn broken_after(written: &Check, found: &Check) -> usize {
    let case = case("rod");
    broken(&page_of(&case, by_all(written)), &[(&case, by_all(found))]).len()
}

#[test]
fn analytic_bound_that_is_no_longer_kept_is_broken() {
    let kept = Check::new("gap", 1.0, 0.5);
    assert_eq!(broken_after(&kept, &Check::new("gap", 1.0, 2.0)), METHODS.len());
    assert_eq!(broken_after(&kept, &Check::new("gap", 1.0, f64::NAN)), METHODS.len());
    // by one method alone
    let (rod, mut found) = (case("rod"), by_all(&kept));
    let page = page_of(&rod, found.clone());
    found[2] = findings(&Check::new("gap", 1.0, 2.0));
    let now = broken(&page, &[(&rod, found.clone())]);
    assert!(now.len() == 1 && now[0].contains(METHODS[2].0), "{now:?}");
    // which the page knows
    assert!(broken(&page_of(&rod, found.clone()), &[(&rod, found)]).is_empty());
}

#[test]
fn analytic_quantities_bounds_and_methods_that_are_gone_are_broken() {
    let kept = Check::new("gap", 1.0, 0.5);
    // one that the page does not know, one that it has, and that by every method
    assert_eq!(broken_after(&kept, &Check::new("angle", 1.0, 0.5)), 2 + METHODS.len());
    // a bound that was loosened: the old one is gone, the new one is not on the page
    assert_eq!(broken_after(&kept, &Check::new("gap", 2.0, 0.5)), 2);
    let rod = case("rod");
    let mut found = by_all(&kept);
    found[1] = Findings::default();
    let now = broken(&page_of(&rod, by_all(&kept)), &[(&rod, found)]);
    assert!(now.len() == 1 && now[0].contains(METHODS[1].0), "{now:?}");
}

#[test]
fn analytic_cases_and_tables_that_are_gone_are_broken() {
    let (rod, wheel) = (case("rod"), case("wheel"));
    let page = page_of(&rod, by_all(&Check::new("gap", 1.0, 0.5)));
    assert!(gone(&page, &[&rod], 1).is_empty());
    // one that only the page has, and one that it has not
    assert_eq!((gone(&page, &[], 1).len(), gone(&page, &[&rod, &wheel], 1).len()), (1, 1));
    // a table that is gone, and a column
    assert_eq!(gone(&page, &[&rod], 2).len(), 1);
    assert_eq!(gone(&page.replace("| taylor |", "| euler |"), &[&rod], 1).len(), 1);
}

#[test]
fn analytic_bound_that_is_kept_or_was_missed_before_is_not_broken() {
    for reached in [0.5, 2.0] {
        assert_eq!(broken_after(&Check::new("gap", 1.0, 2.0), &Check::new("gap", 1.0, reached)), 0);
    }
    assert_eq!(broken_after(&Check::new("gap", 1.0, 0.5), &Check::new("gap", 1.0, 0.6)), 0);
}

#[test]
fn analytic_bound_on_times_is_not_broken() {
    assert_eq!(broken_after(&Check::of_times("ratio", 1.0, 0.5), &Check::of_times("ratio", 1.0, 2.0)), 0);
}

#[test]
fn analytic_case_without_methods_is_compared() {
    let rod = case_by("rod", By::Nothing, |_| Findings::default());
    let found = |reached: f64| vec![findings(&Check::new("gap", 1.0, reached))];
    let page = page_of(&rod, found(0.5));
    assert!(page.contains("| yes, 5.0e-1 |"), "{page}");
    assert_eq!([0.5, 2.0].map(|reached| broken(&page, &[(&rod, found(reached))]).len()), [0, 1]);
}

#[test]
fn analytic_miss_is_explained_by_the_tolerance_from_which_on_it_is_kept() {
    let rod = case_by("rod", By::Methods, |tolerance| findings(&Check::new("gap", 1e-9, 20.0 * tolerance)));
    let told = reasons(&rod, &rod.at_its_tolerance(false));
    // RK4 has no tolerance
    assert_eq!(told.len(), METHODS.len() - 1, "{told:?}");
    assert!(told[0].ends_with("gap: 20 times the bound, kept from 1e-11 on (0 steps)"), "{told:?}");
    let never = case_by("rod", By::Methods, |_| findings(&Check::new("gap", 1e-9, 1.0)));
    assert!(
        reasons(&never, &never.at_its_tolerance(false))[0]
            .ends_with("gap: 1.0e9 times the bound, not kept down to 1e-15")
    );
}
