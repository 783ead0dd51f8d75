//! What a command found, in the forms that are asked for: text, JSON, CSV, a figure.

use std::path::Path;

use serde_json::Value;

use super::animate::write;
use super::drawing;
use super::failure::{Failure, print};
use super::json::print_json;
use super::out_path::check_ending;
#[cfg(feature = "figures")]
use ezy_study::report::figure::Figure;

/// A result.
pub(super) trait Shown {
    fn text(&self) -> String;

    fn json(&self) -> Value;

    fn csv(&self) -> Result<Vec<u8>, Failure>;

    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing;
}

/// A figure.
#[cfg(feature = "figures")]
pub(super) struct Drawing {
    pub figure: Figure,
    pub title: String,
    /// What is seen, for those who do not see it.
    pub alternative: String,
}

/// In which forms a result is asked for.
pub(super) struct Forms<'a> {
    out: Option<&'a Path>,
    plot: Option<&'a Path>,
    json: bool,
}

impl<'a> Forms<'a> {
    /// Those of the options --out, --plot and --json, for `what`, in the plural.
    ///
    /// # Errors
    /// A file that cannot be written under its name.
    pub(super) fn new(what: &str, out: Option<&'a Path>, plot: Option<&'a Path>, json: bool) -> Result<Self, Failure> {
        out.map_or(Ok(()), |out| check_ending(out, what, &["csv"]))?;
        if let Some(plot) = plot {
            drawing::check()?;
            drawing::check_name(plot)?;
        }
        Ok(Self { out, plot, json })
    }

    /// Writes the files, and prints JSON, or text with the names of the files.
    pub(super) fn show(&self, result: &impl Shown) -> Result<(), Failure> {
        if let Some(out) = self.out {
            write(out, result.csv()?)?;
        }
        if let Some(plot) = self.plot {
            draw(result, plot)?;
        }
        if self.json {
            return print_json(&result.json());
        }
        let files: String =
            [self.out, self.plot].into_iter().flatten().map(|path| format!("\n{}", path.display())).collect();
        print(&format!("{}{files}{}", result.text(), if files.is_empty() { "" } else { "\n" }))
    }
}

#[cfg(not(feature = "figures"))]
fn draw(_: &impl Shown, _: &Path) -> Result<(), Failure> {
    drawing::check()
}

#[cfg(feature = "figures")]
fn draw(result: &impl Shown, path: &Path) -> Result<(), Failure> {
    let Drawing { figure, title, alternative } = result.drawing();
    super::drawing_of_columns::write(&figure, &title, &alternative, path)
}
