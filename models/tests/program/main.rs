//! The `ezy` program, run as its users run it. What depends on time, `accuracy`, is a program of its own, beside which nothing runs.

mod cli;
mod equations;
#[cfg(feature = "analysis")]
mod equilibrium;
#[cfg(feature = "export")]
mod export;
mod faults;
mod guide;
mod hostile;
#[cfg(feature = "analysis")]
mod inverse;
mod leads;
#[cfg(feature = "analysis")]
mod linearize;
mod new;
#[cfg(feature = "analysis")]
mod periodic;
mod pictures;
mod plots;
mod reactions;
mod remarks;
mod run;
mod scenes;
mod show;
#[cfg(unix)]
mod signals;
mod starts;
mod study;
#[cfg(unix)]
mod sweeps;
mod words;
#[cfg(feature = "analysis")]
mod workspace;

use run::{assert_wrong_use, directory, ezy, text};
use serde_json::Value;
use std::path::Path;

/// Standard output of a command that succeeds.
fn output(arguments: &[&str]) -> String {
    let done = ezy(arguments);
    assert_eq!(done.status.code(), Some(0), "{arguments:?}: {}", text(&done.stderr));
    text(&done.stdout)
}

/// The same, of a command that prints JSON.
fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&output(arguments)).expect("output is JSON")
}

/// Head and rows of a file of comma-separated values without quotes.
#[cfg(feature = "analysis")]
fn table(file: &Path) -> (Vec<String>, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(file).expect("a table");
    let mut rows = text.lines().map(|line| line.split(',').map(str::to_owned).collect());
    (rows.next().expect("a head"), rows.collect())
}

/// A file of the repository is as it is made now; with `UPDATE_GOLDEN=1` it is written anew.
fn assert_current(file: &Path, made: &str) {
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::create_dir_all(file.parent().expect("a file is in a folder")).unwrap();
        std::fs::write(file, made).unwrap();
    }
    let kept = std::fs::read_to_string(file).unwrap_or_default().replace("\r\n", "\n");
    assert!(kept == made, "{} is not what is made now: UPDATE_GOLDEN=1 renews it", file.display());
}
