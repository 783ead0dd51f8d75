//! Samples of a run, in memory and as rows of a CSV file. Knows no solver.

mod columns;
mod csv_writer;
mod limited_reader;
mod memory;
mod names;
mod sample;

pub(crate) use columns::column_index;
pub use columns::{Column, POTENTIAL, columns};
pub use csv_writer::CsvWriter;
pub use limited_reader::LimitedReader;
pub(crate) use memory::Record;
pub use names::{UnknownName, coordinate_index, find_name, input_index, output_index};
pub use sample::{EnergyState, Sample};

/// Optional parts of a sample, besides the motion. They cost time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Wanted {
    /// The work of each effect and the energy balance: an evaluation of the powers at every stage of every step.
    pub work: bool,
    /// The outputs of the scene: one evaluation a sample.
    pub outputs: bool,
    /// The power of each effect, and of the forces with a potential: one evaluation a sample.
    pub power: bool,
}

/// Takes the samples of a run as they are made; `Send`, so that a run can be handed to another thread.
pub trait Recorder: Send {
    /// Keeps one sample.
    ///
    /// # Errors
    /// [`RecordError`] when it could not be kept; the run then stops.
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError>;
}

/// A time without the rounding of the sum of its steps.
fn twelve_digits(t: f64) -> f64 {
    format!("{t:.11e}").parse().unwrap_or(t)
}

/// A sample could not be kept.
#[derive(Debug, thiserror::Error)]
#[error("the sample at t = {t} s could not be written: {cause}", t = twelve_digits(*.t))]
pub struct RecordError {
    /// Time of the sample, s.
    pub t: f64,
    /// Error of the file or pipe.
    pub cause: std::io::Error,
}
