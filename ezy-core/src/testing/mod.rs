//! Checks of a scene against finite differences and against itself, for one line in a user's test.

mod report;

pub use report::{Check, CheckError, CheckReport};
