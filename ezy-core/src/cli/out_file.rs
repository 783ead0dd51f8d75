//! The file of `--out`.

use std::path::Path;

use crate::output::OutputFile;
use crate::record::{CsvWriter, RecordError, Recorder, Sample};

use super::failure::Failure;

/// A CSV file that takes its place when the run has ended.
///
/// A run that is refused leaves what was there. One that is killed, or that cannot write a sample, leaves its rows in
/// `NAME.partial` and the older file as it was.
pub(super) struct OutFile {
    rows: CsvWriter<OutputFile>,
    name: String,
    /// Where the rows are until then; `None` for a pipe or a device.
    partial: Option<String>,
    whole: bool,
}

impl OutFile {
    /// Opens `path` for writing, leaves its content alone, and keeps other writers out.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        match OutputFile::create(path) {
            Ok(file) => {
                let partial = file.partial().map(|path| path.display().to_string());
                Ok(Self { rows: CsvWriter::new(file), name: path.display().to_string(), partial, whole: true })
            }
            Err(cause) => Err(not_written(path, &cause)),
        }
    }

    /// Gives the file its name, when all samples were written.
    ///
    /// # Errors
    /// Why it has not got its name, and where the rows are.
    pub(super) fn complete(self) -> Result<(), String> {
        let Self { rows, name, partial, whole } = self;
        let kept = partial.map(|partial| format!("; the rows so far are in `{partial}`"));
        match (whole, kept) {
            (true, kept) => {
                let done = rows.into_inner().complete();
                done.map_err(|cause| format!("`{name}` cannot be completed: {cause}{}", kept.unwrap_or_default()))
            }
            (false, Some(kept)) => Err(format!("`{name}` is not complete{kept}")),
            (false, None) => Err(format!("`{name}` did not take all rows")),
        }
    }
}

impl Recorder for OutFile {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        let done = self.rows.record(sample);
        self.whole &= done.is_ok();
        done
    }
}

/// Why there is no output at `path`, and what to do.
fn not_written(path: &Path, cause: &std::io::Error) -> Failure {
    let remedy = match cause.kind() {
        std::io::ErrorKind::ResourceBusy => "wait for it, or give --out another file",
        _ => "give --out a file in a directory that exists and may be written to",
    };
    Failure::wrong_use(format!("`{}` cannot be written: {cause}; {remedy}", path.display()))
}
