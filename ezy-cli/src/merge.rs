//! The command `merge`.

use super::arguments::MergeArguments;
use super::failure::{Failure, print};
use super::json::print_json;
use super::out_path::{check_ending, ending, make_folder_of};
use ezy_study::sweep::{Format, Results, ResultsError};
use serde_json::json;

pub(super) fn merge(arguments: &MergeArguments) -> Result<(), Failure> {
    let results = Results::open(&arguments.folders).map_err(refused)?;
    let missing = results.check_complete();
    if !arguments.incomplete {
        missing.map_err(|why| Failure::stopped(format!("{why}; --incomplete joins what is there")))?;
    }
    let Some(out) = &arguments.out else {
        let (mut n, mut n_failed) = (0, 0);
        for part in results.parts() {
            let rows = part.map_err(refused)?;
            n += rows.len();
            n_failed += rows.iter().filter(|row| !row.is_good()).count();
        }
        return told(arguments, n as u64, results.n_cases(), Some(n_failed));
    };
    check_ending(out, "tables", &["csv", "parquet"])?;
    let format = if ending(out).as_deref() == Some("parquet") { Format::Parquet } else { Format::Csv };
    make_folder_of(out).map_err(|cause| Failure::wrong_use(format!("`{}`: {cause}", out.display())))?;
    let n = results.write(out, format).map_err(refused)?;
    told(arguments, n, results.n_cases(), None)
}

fn told(arguments: &MergeArguments, n: u64, n_cases: u64, n_failed: Option<usize>) -> Result<(), Failure> {
    let out = arguments.out.as_ref().map(|out| out.display().to_string());
    if arguments.json {
        return print_json(&json!({ "cases": n, "of": n_cases, "failed": n_failed, "file": out }));
    }
    let failed = n_failed.filter(|n| *n > 0).map_or(String::new(), |n| format!(", {n} of them failed"));
    print(&format!("{n} of {n_cases} cases, each once{failed}\n{}", out.map_or(String::new(), |out| out + "\n")))
}

fn refused(error: ResultsError) -> Failure {
    match error {
        ResultsError::NoSweep(_) | ResultsError::Different { .. } => Failure::wrong_use(error),
        error => Failure::stopped(error),
    }
}
