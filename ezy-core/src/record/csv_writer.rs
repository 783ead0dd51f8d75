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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::Method;
    use crate::simulate::simulation;

    crate::model! {
        /// A puck that nothing holds.
        pub model Puck {
            body puck { mass: 1, inertia: 1 }
            start here { puck at (0, 0) angle 0 velocity (1, 0) rate 0; }
            scene glides { start here; until 1 s; }
        }
    }

    /// A file whose second row finds no room, and the third one would.
    #[derive(Default)]
    struct FullOnce {
        rows: String,
        n_writes: usize,
    }

    impl Write for FullOnce {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.n_writes += 1;
            if self.n_writes == 2 {
                return Err(io::ErrorKind::StorageFull.into());
            }
            self.rows += &String::from_utf8_lossy(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn invariant_no_row_is_written_behind_one_that_is_missing() {
        let run = simulation(&puck::Glides::default()).method(Method::rk4(0.5)).every(0.5).run().unwrap();
        let mut writer = CsvWriter::new(FullOnce::default());
        let written: Vec<bool> = run.samples().map(|sample| writer.record(&sample).is_ok()).collect();
        assert_eq!(written, [true, false, false]);
        let rows = writer.into_inner().rows;
        assert!(rows.lines().count() == 2 && rows.ends_with('\n'), "{rows}");
    }
}
