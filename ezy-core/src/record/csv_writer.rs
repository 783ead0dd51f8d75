//! Samples as rows of a CSV file.

use super::{RecordError, Recorder, Sample, columns};
use std::fmt::Write as _;
use std::io::{self, Write};

/// Writes each sample as one row, and hands it to the file before the next is made, so that a run that is cut
/// short leaves all its rows.
///
/// The first row names the columns with their units, `seat.x [m]`; numbers are as short as gives back the
/// same `f64`. After an error nothing more is written, so that rows stay in order.
pub struct CsvWriter<W: Write> {
    file: W,
    /// Whether the row of names has been written.
    named: bool,
    /// Whether a row could not be written.
    failed: bool,
    row: String,
    /// A line before the names.
    comment: String,
}

impl<W: Write> CsvWriter<W> {
    /// Writes nothing before the first sample.
    pub fn new(file: W) -> Self {
        Self { file, named: false, failed: false, row: String::new(), comment: String::new() }
    }

    /// Writes a line `# comment` before the row of names.
    #[must_use]
    pub fn with_comment(mut self, comment: &str) -> Self {
        self.comment = format!("# {comment}\n");
        self
    }

    /// The file, after the last row.
    pub fn into_inner(self) -> W {
        self.file
    }

    fn write(&mut self, sample: &Sample<'_>) -> io::Result<()> {
        if self.failed {
            return Err(io::Error::other("an earlier row could not be written"));
        }
        self.row.clear();
        if !self.named {
            self.row += &self.comment;
            self.row += &names(sample)?;
        }
        for (i, x) in sample.numbers().enumerate() {
            // writing to a string cannot fail
            _ = write!(self.row, "{}{x:?}", if i > 0 { "," } else { "" });
        }
        self.row.push('\n');
        let done = self.file.write_all(self.row.as_bytes()).and_then(|()| self.file.flush());
        (self.named, self.failed) = (true, done.is_err());
        done
    }
}

/// The row of names; those of array members with two indices hold a comma and are quoted.
fn names(sample: &Sample<'_>) -> io::Result<String> {
    let names = columns(sample.info, sample.wanted).into_iter().map(|c| match c.unit.as_str() {
        "" => c.name,
        unit => format!("{} [{unit}]", c.name),
    });
    let mut row = csv::Writer::from_writer(Vec::new());
    row.write_record(names)?;
    let row = row.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
    String::from_utf8(row).map_err(io::Error::other)
}

impl<W: Write + Send> Recorder for CsvWriter<W> {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        self.write(sample).map_err(|cause| RecordError { t: sample.t, cause })
    }
}
