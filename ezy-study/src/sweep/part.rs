//! One file of a sweep: the rows of consecutive cases.

use super::format::{Format, read};
use super::manifest::Manifest;
use super::row::Column;
use crate::output::OutputFile;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The rows of a part, as they are computed. They stand in `NAME.partial`, each from the moment that it is known, and get their name when
/// all are there.
pub(super) struct Part {
    file: OutputFile,
    /// Rows that an earlier program left.
    pub n_found: u64,
}

/// Where part `number` of a folder is.
pub(super) fn path(folder: &Path, number: u64, format: Format) -> PathBuf {
    folder.join(format!("part-{number:06}.{}", format.name()))
}

/// Where its rows are until it is complete.
pub(super) fn partial(folder: &Path, number: u64) -> PathBuf {
    path(folder, number, Format::Csv).with_extension("csv.partial")
}

impl Part {
    /// Begins a part whose first case is `first`, or goes on behind the rows that are there.
    ///
    /// # Errors
    /// The error of the system; [`io::ErrorKind::ResourceBusy`] when another program writes this part.
    pub(super) fn open(path: &Path, heading: &str, first: u64, n_rows: u64) -> io::Result<Self> {
        let (mut n_found, mut n_bytes) = (0, 0);
        let mut file = OutputFile::resume(path, |bytes| {
            (n_found, n_bytes) = whole_rows(bytes, heading, first, n_rows);
            n_bytes
        })?;
        if n_bytes == 0 {
            file.write_all(heading.as_bytes())?;
        }
        Ok(Self { file, n_found })
    }

    /// Adds rows; they are in the file when this returns.
    ///
    /// # Errors
    /// The error of the system.
    pub(super) fn write(&mut self, rows: &str) -> io::Result<()> {
        self.file.write_all(rows.as_bytes())
    }

    /// Gives the part its name, or writes it in another format under `path`.
    ///
    /// # Errors
    /// The error of the system.
    pub(super) fn complete(
        self,
        path: &Path,
        format: Format,
        columns: &[Column],
        manifest: &Manifest,
    ) -> io::Result<()> {
        let (Format::Parquet, Some(partial)) = (format, self.file.partial()) else { return self.file.complete() };
        let rows = read(partial, columns)?;
        format.write(path, columns, manifest, &mut std::iter::once(Ok(rows)))?;
        std::fs::remove_file(partial)
    }
}

/// How many whole rows of the cases from `first` on `bytes` begin with, `n_rows` at most, and how many bytes these are with the heading.
/// A row that was being written when the program was killed is none.
pub(super) fn whole_rows(bytes: &[u8], heading: &str, first: u64, n_rows: u64) -> (u64, usize) {
    let Some(rows) = bytes.strip_prefix(heading.as_bytes()) else { return (0, 0) };
    let n_columns = n_fields(heading.as_bytes());
    let (mut n, mut end) = (0, heading.len());
    for line in rows.split_inclusive(|byte| *byte == b'\n') {
        let number = line.split(|byte| *byte == b',').next().and_then(|number| std::str::from_utf8(number).ok());
        let is_whole = line.ends_with(b"\n") && n_fields(line) == n_columns && number == Some(&(first + n).to_string());
        if n == n_rows || !is_whole {
            break;
        }
        (n, end) = (n + 1, end + line.len());
    }
    (n, end)
}

/// Fields of a line: commas that are in no quotes, and one.
fn n_fields(line: &[u8]) -> usize {
    let mut is_quoted = false;
    1 + line
        .iter()
        .filter(|byte| {
            is_quoted ^= **byte == b'"';
            **byte == b',' && !is_quoted
        })
        .count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_whole_rows_end_where_a_program_was_killed() {
        let (heading, one, two) = ("case,a [m],message\n", "4,0.5,\n", "5,,\"no, \"\"why\"\"\"\n");
        let whole = format!("{heading}{one}{two}");
        let of = |text: &str| whole_rows(text.as_bytes(), heading, 4, 2);
        assert_eq!(of(&whole), (2, whole.len()));
        for cut in 0..whole.len() {
            let expected = match cut {
                _ if cut < heading.len() => (0, 0),
                _ if cut < heading.len() + one.len() => (0, heading.len()),
                _ => (1, heading.len() + one.len()),
            };
            assert_eq!(of(&whole[..cut]), expected, "{cut} bytes");
        }
        // a third row belongs to the next part, a wrong number to nothing, a wrong heading to another sweep
        assert_eq!(of(&format!("{whole}6,1.0,\n")), (2, whole.len()));
        assert_eq!(of(&format!("{heading}5,1.0,\n")), (0, heading.len()));
        assert_eq!(of(&format!("case,b,message\n{one}")), (0, 0));
        assert_eq!(of(&format!("{heading}4,0.5\n")), (0, heading.len()));
    }
}
