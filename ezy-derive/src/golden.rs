//! Texts that are compared with files. `UPDATE_GOLDEN=1 cargo test -p ezy-derive` writes the files anew.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use similar::TextDiff;

/// Longer differences are cut: what follows is mostly more of the same.
const MOST_LINES: usize = 60;

/// Panics with the difference when a file holds another text.
pub fn compare(file: &Path, now: &str) {
    compare_all(&BTreeMap::from([(file.to_path_buf(), now.to_owned())]));
}

/// The same for several files: the differences of all.
pub fn compare_all(files: &BTreeMap<PathBuf, String>) {
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        files.iter().for_each(|(file, now)| write(file, now));
        return;
    }
    let differences: String = files.iter().filter_map(|(file, now)| difference(file, now)).collect();
    assert!(differences.is_empty(), "{differences}\nUPDATE_GOLDEN=1 writes the files anew.");
}

/// Makes the folder too.
pub fn write(file: &Path, text: &str) {
    fs::create_dir_all(file.parent().expect("files are in a folder")).expect("the folder can be made");
    fs::write(file, text).expect("the file can be written");
}

/// Lines that changed, with a few around them; `None` without any.
fn difference(file: &Path, now: &str) -> Option<String> {
    let before = fs::read_to_string(file).unwrap_or_default();
    if before == now {
        return None;
    }
    let diff = TextDiff::from_lines(before.as_str(), now);
    let text = diff.unified_diff().context_radius(2).to_string();
    let (n_lines, lines) = (text.lines().count(), text.lines().take(MOST_LINES));
    let shown = lines.fold(format!("\n{}:\n", file.display()), |all, line| all + line + "\n");
    let left = n_lines.saturating_sub(MOST_LINES);
    Some(if left == 0 { shown } else { format!("{shown}… {left} more lines\n") })
}
