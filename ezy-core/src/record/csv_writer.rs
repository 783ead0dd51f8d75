//! Samples as rows of a CSV file.

use super::{RecordError, Recorder, Sample, columns};
use crate::model::SceneInfo;
use std::io::Write;

/// Writes each sample as one row, and hands it to the file before the next is made, so that a run that is cut
/// short leaves all its rows.
///
/// The first row names the columns with their units, `seat.x [m]`; numbers have 17 significant digits, which
/// give back the same `f64`.
pub struct CsvWriter<W: Write> {
    rows: csv::Writer<W>,
    fields: Vec<String>,
}

impl<W: Write> CsvWriter<W> {
    /// Writes the row of names.
    ///
    /// # Errors
    /// What the file answers.
    pub fn new(file: W, info: &SceneInfo) -> Result<Self, std::io::Error> {
        let mut rows = csv::Writer::from_writer(file);
        let header = columns(info).into_iter().map(|c| match c.unit.as_str() {
            "" => c.name,
            unit => format!("{} [{unit}]", c.name),
        });
        rows.write_record(header)?;
        rows.flush()?;
        Ok(Self { rows, fields: Vec::new() })
    }

    fn write(&mut self, sample: &Sample<'_>) -> Result<(), std::io::Error> {
        self.fields.clear();
        self.fields.extend(sample.numbers().map(|x| format!("{x:.16e}")));
        self.rows.write_record(&self.fields)?;
        self.rows.flush()
    }
}

impl<W: Write> Recorder for CsvWriter<W> {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.write(sample).map_err(|cause| RecordError { t: sample.t, cause })
    }
}
