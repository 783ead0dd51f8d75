//! The file of `--out`, which is touched no earlier than there is something to put into it.

use std::fs::{File, OpenOptions};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use crate::record::{CsvWriter, RecordError, Recorder, Sample};

use super::failure::Failure;

/// A CSV file that is opened before the run and replaced at its first sample.
///
/// A run that is refused leaves what was there: an older file keeps its rows, a file made here is removed.
pub(super) struct OutFile {
    path: PathBuf,
    file: File,
    is_new: bool,
    rows: Option<CsvWriter<File>>,
}

impl OutFile {
    /// Opens `path` for writing and leaves its content alone.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let made = OpenOptions::new().write(true).create_new(true).open(path);
        let (opened, is_new) = match made {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                (OpenOptions::new().write(true).create(true).truncate(false).open(path), false)
            }
            made => (made, true),
        };
        match opened {
            Ok(file) => Ok(Self { path: path.to_owned(), file, is_new, rows: None }),
            Err(cause) => {
                let remedy = "give --out a file in a directory that exists and may be written to";
                Err(Failure::wrong_use(format!("`{}` cannot be written: {cause}; {remedy}", path.display())))
            }
        }
    }

    /// Empties the file.
    fn begin(&self) -> Result<CsvWriter<File>, std::io::Error> {
        // pipes and devices have no length to set
        if self.file.metadata()?.is_file() {
            self.file.set_len(0)?;
        }
        Ok(CsvWriter::new(self.file.try_clone()?))
    }
}

impl Recorder for OutFile {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        let rows = match self.rows.take() {
            Some(rows) => rows,
            None => self.begin().map_err(|cause| RecordError { t: sample.t, cause })?,
        };
        self.rows.insert(rows).record(sample)
    }
}

impl Drop for OutFile {
    fn drop(&mut self) {
        if self.is_new && self.rows.is_none() {
            // a leftover empty file is no reason to fail
            _ = std::fs::remove_file(&self.path);
        }
    }
}
