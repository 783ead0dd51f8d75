//! Hard cases with their bounds, what every method reaches at the tolerance of the reference, and what a plain program does; and every
//! method at three tolerances.

use clap::Args;
use ezy_tests::hard::case::Case;
use ezy_tests::hard::families::families;
use ezy_tests::hard::methods;
use ezy_tests::hard::page::{Found, broken, gone, is_checked, reasons, table};
use ezy_tests::page::{docs, write_part};
use std::error::Error;
use std::time::Instant;

use super::Outcome;

const PAGE: &str = "hard-cases.md";
const METHODS_PAGE: &str = "hard-cases-methods.md";

/// Runs hard cases with their bounds, at the tolerance of the reference, beside a plain program: some minutes
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Only cases whose name holds this
    #[arg(conflicts_with = "write")]
    name: Option<String>,
    /// Run every case by every method at three tolerances instead, up to a quarter of an hour
    #[arg(long)]
    methods: bool,
    /// Write the tables into docs/hard-cases.md, or docs/hard-cases-methods.md
    #[arg(long)]
    write: bool,
    /// Fail where a bound is missed that a page says is kept
    ///
    /// Bounds on times are left out. Fails as well where a page and the program do not have the same cases, methods, quantities and bounds, and where a run by
    /// a method that was quick when the page was written has become worse.
    #[arg(long)]
    check: bool,
    /// Check the cases that take minutes, too
    #[arg(long, requires = "check")]
    long: bool,
}

pub(crate) fn run(asked: &Asked) -> Outcome {
    let Asked { name, methods, write, check, long } = asked;
    let is_asked =
        |case: &Case| name.as_ref().is_none_or(|name| case.name.contains(name)) && (!check || is_checked(case, *long));
    let mut different = Vec::new();
    if !methods {
        different.extend(at_stated_tolerance(is_asked, *check, *write)?);
    }
    if *methods || *check {
        different.extend(at_three_tolerances(is_asked, *check, *write)?);
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
