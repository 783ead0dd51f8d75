//! Text on standard output.

use std::io::{ErrorKind, Write as _};

use super::failure::Failure;

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
