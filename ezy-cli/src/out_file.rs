//! The file of `--out`.

use std::io::Write;
use std::path::Path;

use ezy_core::record::{CsvWriter, RecordError, Recorder, Sample};
use ezy_study::output::OutputFile;

use super::failure::Failure;
use super::out_path::make_folder_of;
use super::run_error::{Estimate, error_line};

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
    /// Whether the first line is to tell the estimated error.
    estimated: bool,
}

/// Bytes of the line that tells the error: seven quantities, each with two numbers and its unit.
const LINE: usize = 400;

impl OutFile {
    /// Opens `path` for writing, leaves its content alone, and keeps other writers out. `estimated`: the first line will tell the
    /// estimated error, or the last one of a pipe or device.
    pub(super) fn open(path: &Path, estimated: bool) -> Result<Self, Failure> {
        match make_folder_of(path).and_then(|()| OutputFile::create(path)) {
            Ok(file) => {
                let partial = file.partial().map(|path| path.display().to_string());
                let mut rows = CsvWriter::new(file);
                if estimated && partial.is_some() {
                    rows = rows.with_comment(&padded(error_line(None)));
                }
                Ok(Self { rows, name: path.display().to_string(), partial, whole: true, estimated })
            }
            Err(cause) => Err(not_written(path, &cause)),
        }
    }

    /// Gives the file its name, when all samples were written, and tells the estimated error.
    ///
    /// # Errors
    /// Why it has not got its name, and where the rows are.
    pub(super) fn complete(self, estimate: Option<&Estimate>) -> Result<(), String> {
        let Self { rows, name, partial, whole, estimated } = self;
        let is_renamed = partial.is_some();
        let kept = partial.map(|partial| format!("; the rows so far are in `{partial}`"));
        match (whole, kept) {
            (true, kept) => {
                let mut file = rows.into_inner();
                let told = match (estimated, is_renamed) {
                    (false, _) => Ok(()),
                    (true, true) => file.write_over_start(format!("# {}\n", padded(error_line(estimate))).as_bytes()),
                    (true, false) => writeln!(file, "# {}", error_line(estimate)),
                };
                let done = told.and_then(|()| file.complete());
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

/// A line of [`LINE`] bytes, all of them of one byte.
fn padded(line: String) -> String {
    let line: String = line.chars().filter(char::is_ascii).take(LINE).collect();
    format!("{line:<LINE$}")
}

/// Why there is no output at `path`, and what to do.
fn not_written(path: &Path, cause: &std::io::Error) -> Failure {
    let remedy = match cause.kind() {
        std::io::ErrorKind::ResourceBusy => "wait for it, or give --out another file",
        _ => "give --out a file that may be written",
    };
    Failure::wrong_use(format!("`{}` cannot be written: {cause}; {remedy}", path.display()))
}
