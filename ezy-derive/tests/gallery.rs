//! The gallery of compile errors, `docs/compile-errors.md`, is made of the files in `tests/ui` and of nothing else.
//!
//! `UPDATE_GOLDEN=1 cargo test -p ezy-derive --test gallery` writes it anew.

#[path = "../src/golden.rs"]
mod golden;

use std::fs;
use std::path::{Path, PathBuf};

const OPENING: &str = "\
# Compile errors

What a wrong model says, as `rustc` shows it. Each message stands on the word to change; its first line names the fault, `help`
an edit that would compile. All faults of a stage are reported at once: of syntax, names and values; where there is none, of
equations. This page is made of the files of the tests ([ezy-derive/tests/ui](../ezy-derive/tests/ui)), so it shows what the
macro says today.
";

/// A theme: the header of its file, the model text, and what rustc answers.
fn section(file: &Path) -> String {
    let source = fs::read_to_string(file).expect("the file can be read");
    let answer = fs::read_to_string(file.with_extension("stderr")).expect("each file has its answer");
    let (header, code): (Vec<&str>, Vec<&str>) = source.lines().partition(|line| line.starts_with("//!"));
    let header = header.iter().map(|line| line.trim_start_matches("//!").trim()).collect::<Vec<_>>().join(" ");
    let (title, explanation) = header.split_once(": ").unwrap_or((header.trim_end_matches('.'), ""));
    let explanation = if explanation.is_empty() { String::new() } else { format!("{}\n\n", sentence(explanation)) };
    let code = code.join("\n");
    // what follows the models is no part of them
    let code = code.split("\nfn main() {}").next().unwrap_or_default();
    let (code, answer) = (code.trim(), answer.trim_end());
    format!("\n## {title}\n\n{explanation}```rust,compile_fail\n{code}\n```\n\n```text\n{answer}\n```\n")
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().collect::<String>() + letters.as_str()).unwrap_or_default()
}

#[test]
fn regress_gallery_of_compile_errors_shows_what_the_macro_says() {
    let crate_root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let entries = fs::read_dir(crate_root.join("tests/ui")).expect("the folder is there");
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    let now = OPENING.to_owned() + &files.iter().map(|file| section(file)).collect::<String>();

    golden::compare(&crate_root.join("../docs/compile-errors.md"), &now);
}
