//! Errors of a study.

use std::path::PathBuf;

use ezy_core::dynamics::{MotionError, StartError, SystemError};
use ezy_core::record::UnknownName;
use ezy_core::simulate::SetupError;
use ezy_study::report::figure::FigureError;

/// Why the study stopped.
#[derive(Debug, thiserror::Error)]
pub enum StudyError {
    /// A run could not start.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A run stopped early.
    #[error("the run of {scene} {outcome}")]
    Stopped {
        /// Name of the scene.
        scene: &'static str,
        /// How it ended.
        outcome: String,
    },
    /// It was asked to end.
    #[error("the study was interrupted{}", page.as_ref().map_or(String::new(), |page| format!("; the parts so far: {}", page.display())))]
    Interrupted {
        /// The page with the parts that were done, when it is written.
        page: Option<PathBuf>,
    },
    /// A name that the study uses is not in the model.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// Parameters cannot be used.
    #[error(transparent)]
    System(#[from] SystemError),
    /// A start could not be assembled.
    #[error(transparent)]
    Start(#[from] StartError),
    /// The equations are singular.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A figure could not be made.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// A file or directory could not be written.
    #[error("{} cannot be written: {cause}; choose another directory with --out", path.display())]
    Write {
        /// The file or directory.
        path: PathBuf,
        /// What the system said.
        cause: std::io::Error,
    },
}
