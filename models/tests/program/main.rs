//! The `ezy` program, run as its users run it. What depends on time, `accuracy`, is a program of its own, beside which nothing runs.

mod cli;
mod equations;
mod faults;
mod guide;
mod hostile;
mod leads;
mod new;
mod pictures;
mod plots;
mod run;
mod scenes;
mod show;
#[cfg(unix)]
mod signals;
mod starts;
mod study;
mod words;

use run::{assert_wrong_use, directory, ezy, text};
use serde_json::Value;

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
