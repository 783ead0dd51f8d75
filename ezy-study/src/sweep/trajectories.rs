//! Whole trajectories: a file for each case, beside the rows.

use super::format::Format;
use super::manifest::Manifest;
use super::row::{Cell, Column, Kind, Row};
use ezy_core::record::columns;
use ezy_core::simulate::Run;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Where the samples of cases are written.
#[derive(Clone, Copy)]
pub(super) struct Trajectories<'a> {
    pub folder: &'a Path,
    pub format: Format,
    pub n_per_part: u64,
    pub manifest: &'a Manifest,
}

/// Rows that are handed to a file at once.
const N_ROWS: usize = 1 << 12;

/// The file of a case: those of a part share a folder, so that none has too many.
pub(super) fn path(folder: &Path, case: u64, n_per_part: u64, format: Format) -> PathBuf {
    let part = folder.join("runs").join(format!("part-{:06}", case / n_per_part));
    part.join(format!("case-{case:06}.{}", format.name()))
}

impl Trajectories<'_> {
    /// Writes all samples of a run; the file has its name when it is complete.
    ///
    /// # Errors
    /// The error of the system, with the file.
    pub(super) fn write(&self, case: u64, run: &Run) -> Result<(), (PathBuf, io::Error)> {
        let path = path(self.folder, case, self.n_per_part, self.format);
        self.write_to(&path, case, run).map_err(|cause| (path, cause))
    }

    fn write_to(&self, path: &Path, case: u64, run: &Run) -> io::Result<()> {
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        let first = run.first();
        let number = |of: ezy_core::record::Column| Column { name: of.name, unit: of.unit, kind: Kind::Number };
        let case_number = Column { name: "case".to_owned(), unit: String::new(), kind: Kind::Count };
        let columns: Vec<Column> =
            std::iter::once(case_number).chain(columns(first.info, first.wanted).into_iter().map(number)).collect();
        let mut samples = run.samples();
        let mut pieces = std::iter::from_fn(|| {
            let row = |sample: ezy_core::record::Sample<'_>| Row {
                index: case,
                cells: sample.numbers().map(Cell::Number).collect(),
            };
            let piece: Vec<Row> = samples.by_ref().take(N_ROWS).map(row).collect();
            (!piece.is_empty()).then_some(Ok(piece))
        });
        self.format.write(path, &columns, self.manifest, &mut pieces)
    }
}
