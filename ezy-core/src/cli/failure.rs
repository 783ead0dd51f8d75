//! Failures of a command, by exit status.

use std::fmt::Display;
use std::process::ExitCode;

/// A command failed.
#[derive(Debug)]
pub enum Failure {
    /// The request cannot be carried out as it stands; exit status 2.
    Use(String),
    /// The request was right, but the work stopped before its end; exit status 1.
    Stopped(String),
}

impl Failure {
    /// A request that cannot be carried out.
    pub fn wrong_use(message: impl Display) -> Self {
        Self::Use(message.to_string())
    }

    /// Work that stopped.
    pub fn stopped(message: impl Display) -> Self {
        Self::Stopped(message.to_string())
    }

    /// Prints the message and gives the exit status.
    pub fn report(&self) -> ExitCode {
        let (message, status) = match self {
            Self::Use(message) => (message, 2),
            Self::Stopped(message) => (message, 1),
        };
        eprintln!("error: {message}");
        ExitCode::from(status)
    }
}

impl From<crate::record::UnknownName> for Failure {
    fn from(unknown: crate::record::UnknownName) -> Self {
        Self::wrong_use(unknown)
    }
}
