//! A recorder that ends a run at a deadline.

use std::io;
use std::time::Instant;

use crate::record::{RecordError, Recorder, Sample};

/// Refuses every sample after the deadline.
pub(super) struct Deadline(pub Instant);

impl Recorder for Deadline {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        if Instant::now() < self.0 {
            return Ok(());
        }
        let cause = io::Error::new(io::ErrorKind::TimedOut, "the time given to the measurement is over");
        Err(RecordError { t: sample.t, cause })
    }
}
