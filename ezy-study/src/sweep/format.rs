//! How tables are written: CSV, and Parquet with the feature `parquet`.

use super::manifest::Manifest;
use super::row::{Column, Pieces, Row, heading};
use crate::output::OutputFile;
use std::io::{self, BufWriter, Write as _};
use std::path::Path;

/// How files of rows are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Format {
    /// Text; names carry their units, `m0 [N*m]`, and what the table is of stands beside it, in `sweep.json`.
    #[default]
    Csv,
    /// Columns of numbers, with units and with what the table is of among the metadata. Needs the feature `parquet`.
    Parquet,
}

impl Format {
    /// `csv` or `parquet`, as files end.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Parquet => "parquet",
        }
    }

    pub(super) fn of_name(name: &str) -> Option<Self> {
        [Self::Csv, Self::Parquet].into_iter().find(|format| format.name() == name)
    }

    /// Writes a file that takes its place when it is complete.
    ///
    /// # Errors
    /// The error of the system or of the rows; [`io::ErrorKind::Unsupported`] of a format that was not built in.
    pub(super) fn write(
        self,
        path: &Path,
        columns: &[Column],
        manifest: &Manifest,
        rows: &mut Pieces<'_>,
    ) -> io::Result<()> {
        let mut file = OutputFile::create(path)?;
        match self {
            Self::Csv => {
                let mut out = BufWriter::new(&mut file);
                out.write_all(heading(columns).as_bytes())?;
                let mut line = String::new();
                for piece in rows {
                    for row in piece? {
                        line.clear();
                        row.write_line(&mut line);
                        out.write_all(line.as_bytes())?;
                    }
                }
                out.flush()?;
            }
            Self::Parquet => super::parquet::write(&mut file, columns, manifest, rows)?,
        }
        file.complete()
    }

    /// Reads the rows of a file.
    ///
    /// # Errors
    /// The error of the system; [`io::ErrorKind::InvalidData`] when the file is not of these columns.
    pub(super) fn read(self, path: &Path, columns: &[Column]) -> io::Result<Vec<Row>> {
        match self {
            Self::Csv => read(path, columns),
            Self::Parquet => super::parquet::read(path, columns),
        }
    }
}

/// Reads the rows of a file of CSV.
///
/// # Errors
/// The error of the system; [`io::ErrorKind::InvalidData`] when the file is not of these columns.
pub(super) fn read(path: &Path, columns: &[Column]) -> io::Result<Vec<Row>> {
    let mut rows = csv::ReaderBuilder::new().from_path(path)?;
    let row = |(i, record): (usize, csv::Result<csv::StringRecord>)| {
        let wrong = || io::Error::new(io::ErrorKind::InvalidData, format!("row {} is none of this sweep", i + 1));
        Row::of_record(&record?, columns).ok_or_else(wrong)
    };
    rows.records().enumerate().map(row).collect()
}
