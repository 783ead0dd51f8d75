//! Samples as rows of a CSV file.

use super::{RecordError, Recorder, Sample, columns};
use std::io::Write;

/// Writes each sample as one row, and hands it to the file before the next is made, so that a run that is cut
/// short leaves all its rows.
///
/// The first row names the columns with their units, `seat.x [m]`; numbers have 17 significant digits, which
/// give back the same `f64`.
pub struct CsvWriter<W: Write> {
    rows: csv::Writer<W>,
    /// Whether the row of names has been written.
    named: bool,
    fields: Vec<String>,
}

impl<W: Write> CsvWriter<W> {
    /// Writes nothing before the first sample.
    pub fn new(file: W) -> Self {
        Self { rows: csv::Writer::from_writer(file), named: false, fields: Vec::new() }
    }

    fn write(&mut self, sample: &Sample<'_>) -> Result<(), std::io::Error> {
        if !self.named {
            let names = columns(sample.info, sample.wanted).into_iter().map(|c| match c.unit.as_str() {
                "" => c.name,
                unit => format!("{} [{unit}]", c.name),
            });
            self.rows.write_record(names)?;
            self.named = true;
        }
        self.fields.clear();
        self.fields.extend(sample.numbers().map(|x| format!("{x:.16e}")));
        self.rows.write_record(&self.fields)?;
        self.rows.flush()
    }
}

impl<W: Write + Send> Recorder for CsvWriter<W> {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.write(sample).map_err(|cause| RecordError { t: sample.t, cause })
    }
}
