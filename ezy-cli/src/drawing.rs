//! Columns of motions as a figure in a file. Without the feature `figures`, how to get it.

use std::path::Path;

use super::failure::Failure;
use super::out_path::ending;

/// Endings of the files that are written.
const ENDINGS: [&str; 3] = ["svg", "png", "html"];

/// Whether figures can be drawn.
pub(super) fn check() -> Result<(), Failure> {
    match cfg!(feature = "figures") {
        true => Ok(()),
        false => Err(Failure::wrong_use(
            "this program was built without figures; add \"figures\" to the features of ezy-cli in Cargo.toml: \
             ezy-cli = { …, features = [\"figures\"] }",
        )),
    }
}

/// Whether a file of this name can be written, found before the runs.
pub(super) fn check_name(path: &Path) -> Result<(), Failure> {
    if ending(path).is_some_and(|ending| ENDINGS.contains(&ending.as_str())) {
        return Ok(());
    }
    Err(Failure::wrong_use(format!(
        "`{}`: figures are written as .svg, .png or .html; give --out such a file",
        path.display()
    )))
}
