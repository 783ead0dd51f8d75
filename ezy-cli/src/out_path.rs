//! The names after `--out`: what their endings say, and the folders they are in.

use std::path::Path;

use super::failure::Failure;

/// Endings of files, which are no folders.
const OF_FILES: [&str; 17] =
    ["c", "csv", "fmu", "gif", "htm", "html", "jl", "json", "m", "md", "pdf", "png", "py", "svg", "tex", "txt", "xlsx"];

/// The ending of a name in small letters; none of a device, a pipe or a name without one.
pub(super) fn ending(path: &Path) -> Option<String> {
    path.extension().map(|ending| ending.to_string_lossy().to_lowercase())
}

/// That the ending of a file is one of `endings`, or that it has none.
///
/// # Errors
/// What `what`, a plural, is written as.
pub(super) fn check_ending(path: &Path, what: &str, endings: &[&str]) -> Result<(), Failure> {
    match ending(path) {
        Some(ending) if !endings.contains(&ending.as_str()) => {
            let known: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
            Err(Failure::wrong_use(format!(
                "`{}`: {what} are written as {}; give --out such a file",
                path.display(),
                known.join(" or ")
            )))
        }
        _ => Ok(()),
    }
}

/// That a folder does not have the name of a file.
///
/// # Errors
/// The name to give.
pub(super) fn check_folder_name(path: &Path) -> Result<(), Failure> {
    match ending(path) {
        Some(ending) if OF_FILES.contains(&ending.as_str()) && !path.is_dir() => Err(Failure::wrong_use(format!(
            "`{}`: several files are written, into a folder; give --out a folder, such as `{}`",
            path.display(),
            path.with_extension("").display()
        ))),
        _ => Ok(()),
    }
}

/// Makes the folder of a file.
///
/// # Errors
/// The error of the system.
pub(super) fn make_folder_of(path: &Path) -> std::io::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.map_or(Ok(()), std::fs::create_dir_all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_ending_of_another_format_is_refused() {
        let is_taken = |name: &str| check_ending(Path::new(name), "motions", &["csv"]).is_ok();
        assert!(["a.csv", "A.CSV", "/dev/stdout", "a"].into_iter().all(is_taken));
        assert!(!["a.json", "a.csv.gz", "b/a.html"].into_iter().any(is_taken));
        let is_folder = |name: &str| check_folder_name(Path::new(name)).is_ok();
        assert!(is_folder("out/v1.2") && is_folder("out") && !is_folder("out/x.html"));
    }
}
