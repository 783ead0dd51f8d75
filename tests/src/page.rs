//! Parts of the pages in `docs` that programs write.

use std::path::{Path, PathBuf};

/// A page of the documentation.
pub fn docs(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs").join(name)
}

/// The part of a page between `<!-- NAME -->` and the next `<!-- end -->`; `None` when the page has no such part.
pub fn part<'a>(page: &'a str, name: &str) -> Option<&'a str> {
    let after = page.split_once(&format!("<!-- {name} -->\n"))?.1;
    Some(after.split_once("<!-- end -->")?.0)
}

/// Puts a new text into the place of a part.
///
/// # Errors
/// What the file answers.
pub fn write_part(name: &str, part_name: &str, text: &str) -> std::io::Result<()> {
    let page = std::fs::read_to_string(docs(name))?;
    let old = part(&page, part_name).unwrap_or_default();
    let opening = format!("<!-- {part_name} -->\n");
    std::fs::write(docs(name), page.replacen(&format!("{opening}{old}"), &format!("{opening}{text}"), 1))
}
