//! The results of a sweep, in one folder or in several.

use super::format::Format;
use super::kept::Kept;
use super::manifest::{CASES_PER_PART, Manifest};
use super::part;
use super::row::{Column, Row};
use super::trajectories;
use std::io;
use std::path::{Path, PathBuf};

/// Files that shares of a sweep wrote, put together.
#[derive(Debug)]
pub struct Results {
    manifest: Manifest,
    columns: Vec<Column>,
    n_cases: u64,
    n_per_part: u64,
    format: Format,
    /// Where each part is; `None` where it is not complete.
    parts: Vec<Option<PathBuf>>,
}

/// Why results cannot be put together.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultsError {
    /// A folder without `sweep.json`, or with another file of this name.
    #[error("`{}` has no results of a sweep; give the folder that --out named", .0.display())]
    NoSweep(PathBuf),
    /// Folders of different sweeps.
    #[error("`{}` and `{}` are of different sweeps ({}); give folders of one", one.display(), other.display(), differences.join("; "))]
    Different {
        /// A folder.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// Name, and both values.
        differences: Vec<String>,
    },
    /// Two files of one part that differ, though the same cases give the same numbers on machines of one kind.
    #[error("`{}` and `{}` are the same part, but differ; keep the one that you trust", one.display(), other.display())]
    Contradiction {
        /// A file.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
    },
    /// Parts that no folder has.
    #[error(
        "{n_missing} of {n_parts} parts are missing: {}; the command of the sweep with --resume computes them",
        listed(missing)
    )]
    Missing {
        /// How many.
        n_missing: usize,
        /// How many there are in all.
        n_parts: usize,
        /// The first and the last of each group of neighbours.
        missing: Vec<[u64; 2]>,
    },
    /// A file.
    #[error("`{}`: {cause}", path.display())]
    File {
        /// Which one.
        path: PathBuf,
        /// What is wrong with it.
        cause: io::Error,
    },
}

/// Groups of missing parts that a message lists.
const MOST_LISTED: usize = 20;

fn listed(groups: &[[u64; 2]]) -> String {
    let one = |[first, last]: &[u64; 2]| if first == last { format!("{first}") } else { format!("{first} to {last}") };
    let listed: Vec<String> = groups.iter().take(MOST_LISTED).map(one).collect();
    let more = groups.len().saturating_sub(MOST_LISTED);
    listed.join(", ") + &if more > 0 { format!(" and {more} more groups") } else { String::new() }
}

impl Results {
    /// The results in `folders`, each part once.
    ///
    /// # Errors
    /// [`ResultsError`] when they are not of one sweep, or contradict each other. Missing parts are no error here.
    pub fn open<P: AsRef<Path>>(folders: &[P]) -> Result<Self, ResultsError> {
        let mut all: Option<(PathBuf, Self)> = None;
        for folder in folders {
            let folder = folder.as_ref();
            let manifest = Manifest::of_folder(folder).ok().flatten();
            let none = || ResultsError::NoSweep(folder.to_owned());
            let manifest = manifest.ok_or_else(none)?;
            let (first, of) = match &mut all {
                Some(all) => all,
                none_yet => none_yet.insert((folder.to_owned(), Self::of(manifest.clone()).ok_or_else(none)?)),
            };
            let differences = of.manifest.differences(&manifest);
            if !differences.is_empty() {
                return Err(ResultsError::Different { one: first.clone(), other: folder.to_owned(), differences });
            }
            of.add(folder)?;
        }
        let nothing = || ResultsError::NoSweep(PathBuf::new());
        all.map(|(_, of)| of).ok_or_else(nothing)
    }

    /// Without any part.
    fn of(manifest: Manifest) -> Option<Self> {
        let columns = manifest.columns().filter(|columns| !columns.is_empty())?;
        let (n_cases, n_per_part) = (manifest.number("cases")?, manifest.number(CASES_PER_PART).filter(|n| *n > 0)?);
        let format = Format::of_name(manifest.text("format")?)?;
        let parts = vec![None; usize::try_from(n_cases.div_ceil(n_per_part)).ok()?];
        Some(Self { manifest, columns, n_cases, n_per_part, format, parts })
    }

    fn add(&mut self, folder: &Path) -> Result<(), ResultsError> {
        let of_file = |path: &Path, cause| ResultsError::File { path: path.to_owned(), cause };
        for (number, known) in self.parts.iter_mut().enumerate() {
            let path = part::path(folder, number as u64, self.format);
            if !path.exists() {
                continue;
            }
            if let Some(one) = known {
                let [a, b] = [&*one, &path].map(|path| std::fs::read(path).map_err(|cause| of_file(path, cause)));
                if a? != b? {
                    return Err(ResultsError::Contradiction { one: one.clone(), other: path });
                }
            }
            *known = Some(path);
        }
        Ok(())
    }

    /// The columns of every row.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Cases of the whole sweep.
    pub fn n_cases(&self) -> u64 {
        self.n_cases
    }

    /// That all parts are there.
    ///
    /// # Errors
    /// [`ResultsError::Missing`] with their numbers.
    pub fn check_complete(&self) -> Result<(), ResultsError> {
        let mut missing: Vec<[u64; 2]> = Vec::new();
        for number in (0..self.parts.len()).filter(|i| self.parts[*i].is_none()).map(|i| i as u64) {
            match missing.last_mut() {
                Some([_, last]) if *last + 1 == number => *last = number,
                _ => missing.push([number, number]),
            }
        }
        let n_missing = self.parts.iter().filter(|part| part.is_none()).count();
        if missing.is_empty() {
            Ok(())
        } else {
            Err(ResultsError::Missing { n_missing, n_parts: self.parts.len(), missing })
        }
    }

    /// The rows that are there, part by part, in order. Each part is checked: it has its cases, each once.
    pub fn parts(&self) -> impl Iterator<Item = Result<Vec<Row>, ResultsError>> + '_ {
        self.parts.iter().enumerate().filter_map(|(number, path)| {
            let path = path.as_ref()?;
            let of_file = |cause| ResultsError::File { path: path.clone(), cause };
            let first = number as u64 * self.n_per_part;
            let cases = first..(first + self.n_per_part).min(self.n_cases);
            let rows = self.format.read(path, &self.columns).and_then(|rows| {
                let is_whole = rows.iter().map(|row| row.index).eq(cases.clone());
                let wrong = || {
                    let what = format!(
                        "it does not have the cases from {} to {}, each once; remove it and compute them again",
                        cases.start,
                        cases.end - 1
                    );
                    io::Error::new(io::ErrorKind::InvalidData, what)
                };
                if !is_whole {
                    return Err(wrong());
                }
                let lacking = self.keeps_samples().then(|| self.first_without_samples(path, &rows)).flatten();
                lacking.map_or(Ok(rows), |case| {
                    let what = format!("the samples of case {case} are missing; remove this file and compute it again");
                    Err(io::Error::new(io::ErrorKind::NotFound, what))
                })
            });
            Some(rows.map_err(of_file))
        })
    }

    /// Whether each case has a file with its samples.
    fn keeps_samples(&self) -> bool {
        self.manifest.has_kept(&Kept::Samples.to_string())
    }

    /// The first case of a part that ran, and whose samples are not beside it.
    fn first_without_samples(&self, part: &Path, rows: &[Row]) -> Option<u64> {
        let folder = part.parent()?;
        let samples = |row: &Row| trajectories::path(folder, row.index, self.n_per_part, self.format);
        rows.iter().find(|row| row.has_run() && !samples(row).exists()).map(|row| row.index)
    }

    /// Writes all rows that are there into one file, part by part, and returns how many these are.
    ///
    /// # Errors
    /// [`ResultsError::File`]; an older file is then as it was.
    pub fn write(&self, path: &Path, format: Format) -> Result<u64, ResultsError> {
        let (mut n, mut failure) = (0, None);
        let mut pieces = self.parts().map(|rows| {
            n += rows.as_ref().map_or(0, |rows| rows.len() as u64);
            rows.map_err(|error| {
                failure = Some(error);
                io::Error::other("a part cannot be read")
            })
        });
        let done = format.write(path, &self.columns, &self.manifest, &mut pieces);
        drop(pieces);
        match (failure, done) {
            (Some(failure), _) => Err(failure),
            (None, Err(cause)) => Err(ResultsError::File { path: path.to_owned(), cause }),
            (None, Ok(())) => Ok(n),
        }
    }
}
