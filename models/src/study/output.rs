//! The directory that a study writes into.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ezy_study::output::{self, OutputFolder};
use ezy_study::report::figure::Figure;
use ezy_study::report::page::Page;

use super::error::StudyError;

/// A directory for figures, numbers and the page.
pub struct Output {
    folder: OutputFolder,
}

/// A figure with the numbers behind it and the words around it.
pub struct Plate<'a> {
    /// Name of its files.
    pub name: &'a str,
    /// The figure.
    pub figure: Figure,
    /// Columns of the CSV file: name with unit, values.
    pub columns: Vec<(&'a str, Vec<f64>)>,
    /// What stands under it.
    pub caption: String,
    /// What is seen, for those who do not see it.
    pub alternative: String,
}

impl Output {
    /// Makes the directory and keeps other writers out.
    pub fn new(directory: &Path) -> Result<Self, StudyError> {
        match OutputFolder::create(directory) {
            Ok(folder) => Ok(Self { folder }),
            Err(cause) => Err(StudyError::Write { path: directory.to_owned(), cause }),
        }
    }

    /// Saves a figure as SVG, PNG and CSV, and puts it on the page.
    pub fn plate(&self, page: &mut Page, plate: Plate<'_>) -> Result<(), StudyError> {
        let picture = plate.figure.save(self.folder.path(), plate.name)?;
        self.write(&format!("{}.csv", plate.name), &csv(&plate.columns))?;
        let files = ["svg", "png", "csv"].map(|extension| format!("{}.{extension}", plate.name));
        page.figure(picture, &plate.caption, &plate.alternative, &[&files[0], &files[1], &files[2]]);
        Ok(())
    }

    /// Writes a text file and returns where it is.
    pub fn write(&self, name: &str, text: &str) -> Result<PathBuf, StudyError> {
        let path = self.folder.path().join(name);
        match output::write(&path, text) {
            Ok(()) => Ok(path),
            Err(cause) => Err(StudyError::Write { path, cause }),
        }
    }
}

/// Rows to the length of the longest column; a shorter column leaves its cells empty.
fn csv(columns: &[(&str, Vec<f64>)]) -> String {
    let mut text = columns.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(",") + "\n";
    let n_rows = columns.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    for i in 0..n_rows {
        for (k, (_, values)) in columns.iter().enumerate() {
            text += if k > 0 { "," } else { "" };
            if let Some(value) = values.get(i) {
                _ = write!(text, "{value:?}");
            }
        }
        text.push('\n');
    }
    text
}
