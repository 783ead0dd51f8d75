//! The measurement as files.

use std::path::{Path, PathBuf};

use super::error::AccuracyError;
use super::measured::WorkPrecision;
#[cfg(feature = "figures")]
use super::{figures::Where, page::Pictures};
#[cfg(feature = "figures")]
use crate::report::figure::{Figure, FigureError};
#[cfg(feature = "figures")]
use crate::report::page::Picture;

impl WorkPrecision {
    /// Writes `accuracy.csv` into `directory`, which is made when it is not there. With the feature `figures` also a page and
    /// its figures: `index.html`, `work-precision.svg` and `.png`, `work-precision-grid`, `drift`, `energy`. Returns the path of
    /// the page, or of the numbers where there is no page.
    ///
    /// # Errors
    /// [`AccuracyError::Write`]; with the feature `figures` also `AccuracyError::Figure`.
    pub fn save(&self, directory: &Path) -> Result<PathBuf, AccuracyError> {
        written(directory.to_owned(), std::fs::create_dir_all(directory))?;
        let csv = directory.join("accuracy.csv");
        written(csv.clone(), crate::output::write(&csv, self.csv()))?;
        #[cfg(feature = "figures")]
        {
            self.save_page(directory)
        }
        #[cfg(not(feature = "figures"))]
        {
            Ok(csv)
        }
    }

    /// Writes the page and its figures, and returns the page's path.
    #[cfg(feature = "figures")]
    fn save_page(&self, directory: &Path) -> Result<PathBuf, AccuracyError> {
        let pictures = Pictures {
            end: drawn(&self.work_precision(Where::End), directory, "work-precision")?,
            grid: drawn(&self.work_precision(Where::Grid), directory, "work-precision-grid")?,
            drift: self.drift().map(|figure| drawn(&figure, directory, "drift")).transpose()?.flatten(),
            energy: drawn(&self.energy(), directory, "energy")?,
        };
        let page = directory.join("index.html");
        written(page.clone(), crate::output::write(&page, self.page(&pictures)))
    }
}

/// The path of what was written.
fn written(path: PathBuf, done: std::io::Result<()>) -> Result<PathBuf, AccuracyError> {
    match done {
        Ok(()) => Ok(path),
        Err(cause) => Err(AccuracyError::Write { path, cause }),
    }
}

/// The picture; `None` where there is nothing to draw, such as a drift of nothing.
#[cfg(feature = "figures")]
fn drawn(figure: &Figure, directory: &Path, name: &str) -> Result<Option<Picture>, AccuracyError> {
    match figure.save(directory, name) {
        Ok(picture) => Ok(Some(picture)),
        Err(FigureError::Empty { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}
