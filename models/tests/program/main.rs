//! The `ezy` program, run as its users run it. What depends on time, `accuracy`, is a program of its own, beside which nothing runs.

mod cli;
mod equations;
mod faults;
mod guide;
mod hostile;
mod new;
mod pictures;
mod plots;
mod run;
#[cfg(unix)]
mod signals;
mod starts;
mod study;
mod words;

use run::{assert_wrong_use, directory, ezy, text};
