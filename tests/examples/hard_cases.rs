//! Hard cases with their bounds, what every method reaches at the tolerance of the reference, and what a plain program does; and every
//! method at three tolerances.
//!
//! `cargo run --release -p ezy-tests --example hard_cases` runs all of them, some minutes, and prints the tables; with
//! `-- --write` they go into `docs/hard-cases.md`. `-- --methods` runs every case by every method at three tolerances, up to a
//! quarter of an hour, and with `--write` writes `docs/hard-cases-methods.md`. `-- --check` fails where a bound that a page says is
//! kept is missed, but for bounds on times, where a page and the program do not have the same cases, methods, quantities and bounds, and
//! where a run by a method that was quick when the page was written has become worse. It leaves out the cases that take minutes, unless
//! `--long` is given. A further word runs only the cases whose name holds it.

use ezy_tests::hard::case::Case;
use ezy_tests::hard::families::families;
use ezy_tests::hard::methods;
use ezy_tests::hard::page::{Found, broken, gone, is_checked, reasons, table};
use ezy_tests::page::{docs, write_part};
use std::error::Error;
use std::time::Instant;

const PAGE: &str = "hard-cases.md";
const METHODS_PAGE: &str = "hard-cases-methods.md";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let asks = |word: &str| arguments.iter().any(|argument| argument == word);
    let filter = arguments.iter().find(|argument| !argument.starts_with("--"));
    if filter.is_some() && asks("--write") {
        return Err("`--write` takes all cases; leave the name out".into());
    }
    let is_asked = |case: &Case| {
        filter.is_none_or(|word| case.name.contains(word)) && (!asks("--check") || is_checked(case, asks("--long")))
    };
    let mut different = Vec::new();
    if !asks("--methods") {
        different.extend(at_stated_tolerance(is_asked, asks("--check"), asks("--write"))?);
    }
    if asks("--methods") || asks("--check") {
        different.extend(at_three_tolerances(is_asked, asks("--check"), asks("--write"))?);
    }
    if different.is_empty() { Ok(()) } else { Err(different.join("\n").into()) }
}

/// Every case at the tolerance of its reference, and the naive program; returns what is broken.
fn at_stated_tolerance(
    is_asked: impl Fn(&Case) -> bool,
    checks: bool,
    writes: bool,
) -> Result<Vec<String>, Box<dyn Error>> {
    let page = if checks { std::fs::read_to_string(docs(PAGE))? } else { String::new() };
    let families = families();
    let cases: Vec<&Case> = families.iter().flat_map(|family| &family.cases).collect();
    let mut different = if checks { gone(&page, &cases, families.len()) } else { Vec::new() };
    for family in &families {
        let cases = family.cases.iter().filter(|case| is_asked(case));
        let mut explained = Vec::new();
        let found: Vec<Found<'_>> = cases
            .map(|case| {
                let clock = Instant::now();
                let found = case.at_its_tolerance(!checks);
                if !checks {
                    explained.extend(reasons(case, &found));
                }
                eprintln!("{}: {:.1} s", case.name, clock.elapsed().as_secs_f64());
                (case, found)
            })
            .collect();
        if found.is_empty() {
            continue;
        }
        let text = table(&found, &explained);
        println!("\n{text}");
        if writes {
            write_part(PAGE, family.name, &text)?;
        }
        if checks {
            different.extend(broken(&page, &found));
        }
    }
    Ok(different)
}

/// Every case by every method at three tolerances, of a check the quick ones; returns what is broken.
fn at_three_tolerances(
    is_asked: impl Fn(&Case) -> bool,
    checks: bool,
    writes: bool,
) -> Result<Vec<String>, Box<dyn Error>> {
    let page = if checks { std::fs::read_to_string(docs(METHODS_PAGE))? } else { String::new() };
    let families = families();
    let cases: Vec<&Case> = families.iter().flat_map(|family| &family.cases).collect();
    let to_run = cases.iter().filter(|case| is_asked(case) && (!checks || methods::is_quick(&page, case)));
    let rows: Vec<_> = to_run.filter_map(|case| methods::examine(case)).collect();
    let text = methods::table(&rows);
    println!("\n{text}");
    if writes {
        write_part(METHODS_PAGE, "methods", &text)?;
    }
    Ok(if checks { methods::broken(&page, &cases, &rows) } else { Vec::new() })
}
