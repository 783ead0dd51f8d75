//! Why a sweep ends without all of its rows.

use super::plan::PlanError;
use ezy_core::record::UnknownName;
use std::io;
use std::path::PathBuf;

/// Why a sweep was not begun, or not finished. What was computed is kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// What is kept.
    #[error(transparent)]
    Name(#[from] UnknownName),
    /// What is kept, of cases in lanes.
    #[error("of cases in lanes only ends are known, and `{kept}` needs more; keep ends alone, or leave lanes out")]
    BeyondEnd {
        /// What needs more.
        kept: String,
    },
    /// Whole trajectories in memory.
    #[error("`samples` are files beside the rows; write the sweep into a folder")]
    NoFolder,
    /// Share `i` of `n`, where `i` is not from 1 to `n`.
    #[error("there is no share {i} of {n}; shares are numbered from 1 to their number")]
    Shard {
        /// Number of the share.
        i: u64,
        /// Number of all.
        n: u64,
    },
    /// The folder has results, and nothing was said of them.
    #[error(
        "`{}` has results of this sweep: {} of {} parts are complete; resume it, or give another folder",
        folder.display(), n_parts[0], n_parts[1]
    )]
    Exists {
        /// The folder.
        folder: PathBuf,
        /// Complete parts, and all.
        n_parts: [u64; 2],
    },
    /// The folder has results of something else.
    #[error("`{}` has results of another sweep ({}); give another folder, or what was given then", folder.display(), differences.join("; "))]
    Changed {
        /// The folder.
        folder: PathBuf,
        /// Name, what it was and what it is now.
        differences: Vec<String>,
    },
    /// A file or a folder.
    #[error("`{}`: {cause}", path.display())]
    File {
        /// Which one.
        path: PathBuf,
        /// What the system said.
        cause: io::Error,
    },
}
