//! The page of hard cases by every method.

use ezy_tests::hard::case::{By, Case, Check, Ended, Findings, How, Pace};
use ezy_tests::hard::methods::{broken, examine, lines, table};

fn case_with(reached: fn(f64) -> f64, ended: Ended) -> Case {
    let examine = move |how: How| {
        let checks = vec![Check::new("angle", 1e-8, reached(how.tolerance)), Check::for_all("gap", 1e-12, 1e-13)];
        Findings { checks, steps: 10, ended: Some(ended), ..Findings::default() }
    };
    Case {
        name: "rod".to_owned(),
        why: "it is one",
        tolerance: 1e-9,
        by: By::Methods,
        pace: Pace::Quick,
        examine: Box::new(examine),
    }
}

fn page_of(case: &Case) -> String {
    table(&[examine(case).unwrap()])
}

#[test]
fn analytic_kept_right_and_off_follow_from_bound_and_tolerance() {
    let page = page_of(&case_with(|tolerance| 20.0 * tolerance, Ended::Reached));
    let line = lines(&page).find(|line| line.method == "taylor").unwrap();
    assert_eq!(line.cells, ["2e-5, 10", "2e-8, 10", "kept: 2e-11, 10"]);
    // at 1e-6 and 1e-9 the median of error over tolerance is 2e4
    let off = page_of(&case_with(|_| 2e-5, Ended::Reached));
    let line = lines(&off).find(|line| line.method == "radau").unwrap();
    assert_eq!(line.cells, ["2e-5, 10", "2e-5, 10", "**off: 2e-5**, 10"]);
    assert!(lines(&off).find(|line| line.method == "rk4").unwrap().cells.iter().all(|cell| *cell == "2e-5, 10"));
}

#[test]
fn analytic_what_a_page_has_is_not_lost() {
    let [good, bad] = [|_| 1e-10, |_| 2e-3].map(|reached: fn(f64) -> f64| case_with(reached, Ended::Reached));
    let refused = case_with(|_| f64::NAN, Ended::Refused("does not get past"));
    let page = page_of(&good);
    let lost = |case: &Case| broken(&page, &[case], &[examine(case).unwrap()]).len();
    assert_eq!((lost(&good), lost(&bad), lost(&refused)), (0, 12, 12));
    assert_eq!(broken(&page_of(&refused), &[&good], &[examine(&good).unwrap()]).len(), 0);
    // a case that is gone, with its four methods; a page that is gone, and its table
    assert_eq!((broken(&page, &[], &[]).len(), broken("", &[&good], &[]).len()), (4, 5));
    // a method and a tolerance that are on one side alone
    let without =
        |word: &str| page.lines().filter(|line| !line.contains(word)).fold(String::new(), |t, l| t + l + "\n");
    assert_eq!(broken(&without("| dop853 |"), &[&good], &[]).len(), 1);
    assert_eq!(broken(&page.replace("| dop853 | kept", "| euler | kept"), &[&good], &[]).len(), 2);
    assert_eq!(broken(&page.replace(" | 1e-12 |", " |"), &[&good], &[]).len(), 1);
    let shorter = page.replace("| kept: 1e-10, 10 |\n| `rod` |  | taylor", "|\n| `rod` |  | taylor");
    assert_eq!((shorter == page, broken(&shorter, &[&good], &[]).len()), (false, 1));
}
