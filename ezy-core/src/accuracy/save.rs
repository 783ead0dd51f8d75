//! The measurement as files.

use std::path::{Path, PathBuf};

use super::error::AccuracyError;
use super::figures::Where;
use super::measured::WorkPrecision;
use super::page::Pictures;
use crate::report::figure::{Figure, FigureError};

impl WorkPrecision {
    /// Writes page, figures and numbers into `directory`, which is made when it is not there, and returns the page's
    /// path: `index.html`, `work-precision.svg` and `.png`, `work-precision-grid`, `drift`, `energy`, `accuracy.csv`.
    ///
    /// # Errors
    /// [`AccuracyError::Figure`], [`AccuracyError::Write`].
    pub fn save(&self, directory: &Path) -> Result<PathBuf, AccuracyError> {
        let written = |path: PathBuf, done: std::io::Result<()>| match done {
            Ok(()) => Ok(path),
            Err(cause) => Err(AccuracyError::Write { path, cause }),
        };
        written(directory.to_owned(), std::fs::create_dir_all(directory))?;
        let csv = directory.join("accuracy.csv");
        written(csv.clone(), std::fs::write(&csv, self.csv()))?;
        let pictures = Pictures {
            end: drawn(&self.work_precision(Where::End), directory, "work-precision")?,
            grid: drawn(&self.work_precision(Where::Grid), directory, "work-precision-grid")?,
            drift: self.drift().map(|figure| drawn(&figure, directory, "drift")).transpose()?.flatten(),
            energy: drawn(&self.energy(), directory, "energy")?,
        };
        let page = directory.join("index.html");
        written(page.clone(), std::fs::write(&page, self.page(&pictures)))
    }
}

/// The SVG text; `None` where there is nothing to draw, such as a drift of nothing.
fn drawn(figure: &Figure, directory: &Path, name: &str) -> Result<Option<String>, AccuracyError> {
    match figure.save(directory, name) {
        Ok(svg) => Ok(Some(svg)),
        Err(FigureError::Empty { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}
