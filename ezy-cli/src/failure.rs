//! What a command prints, and its failures by exit status.

use std::fmt::Display;
use std::io::{ErrorKind, Write as _};
use std::process::ExitCode;

/// A command failed.
#[derive(Debug)]
pub enum Failure {
    /// The request cannot be carried out as it stands; exit status 2.
    Use(String),
    /// The request was right, but the work stopped before its end; exit status 1.
    Stopped(String),
    /// The work was interrupted by a signal; see [`Interruption`](super::Interruption::failure).
    Interrupted {
        /// What was done until then.
        message: String,
        /// Exit status: 128 and the number of the signal.
        status: u8,
    },
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

    /// What it says.
    pub(super) fn message(&self) -> &str {
        match self {
            Self::Use(message) | Self::Stopped(message) | Self::Interrupted { message, .. } => message,
        }
    }

    /// Prints the message and gives the exit status.
    pub(crate) fn report(&self) -> ExitCode {
        let status = match self {
            Self::Use(_) => 2,
            Self::Stopped(_) => 1,
            Self::Interrupted { status, .. } => *status,
        };
        print_error(&format!("error: {}\n", self.message()));
        ExitCode::from(status)
    }
}

impl From<ezy_core::record::UnknownName> for Failure {
    fn from(unknown: ezy_core::record::UnknownName) -> Self {
        Self::wrong_use(unknown)
    }
}

/// Prints `text`. A reader that has seen enough and closed its end is no failure.
///
/// # Errors
/// [`Failure::Stopped`] when standard output cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::stopped(format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints to standard error. Where it is full or closed nobody reads it, and the exit status tells.
pub(super) fn print_error(text: &str) {
    _ = std::io::stderr().lock().write_all(text.as_bytes());
}
