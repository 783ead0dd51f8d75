//! The examples of `docs/language.md` are those of `examples/words`; they pass their checks, and the pictures of the page show them.

use crate::{assert_current, directory, text};
use std::fs;
use std::path::Path;
use std::process::Command;

/// How the page marks them: they are compiled here, and need not be documentation tests as well.
const EXAMPLE: &str = "```rust,ignore\nezy_core::model! {";

/// The word behind a piece of the text.
fn word_behind<'p>(text: &'p str, piece: &str) -> &'p str {
    text.split_once(piece).and_then(|(_, rest)| rest.split_whitespace().next()).unwrap()
}

#[test]
fn fd_examples_of_all_words_pass_their_checks() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("../docs/language.md")).unwrap();
    let files = ["items", "constraints", "forces", "scenes"].map(|name| format!("examples/words/{name}.rs"));
    let source: String = files.iter().map(|name| fs::read_to_string(root.join(name)).unwrap()).collect();
    let program = Path::new(env!("CARGO_BIN_EXE_ezy")).with_file_name("examples").join("words");
    let program = program.with_extension(std::env::consts::EXE_EXTENSION);
    let run = |arguments: &[&str]| {
        let done = Command::new(&program).args(arguments).output().unwrap();
        assert!(done.status.success(), "{arguments:?}:\n{}", text(&done.stdout) + &text(&done.stderr));
    };
    let folder = directory("words");
    let mut n_models = 0;
    let mut n_pictures = 0;
    for (block, rest) in page.split(EXAMPLE).skip(1).filter_map(|rest| rest.split_once("```")) {
        assert!(source.contains(block), "examples/words has not\n{block}");
        let name = word_behind(block, "pub model ");
        run(&["check", name]);
        n_models += 1;
        let section = rest.split("\n### ").next().unwrap_or_default();
        for (picture, _) in section.split("](guide/src/").skip(1).filter_map(|rest| rest.split_once(".svg)")) {
            let drawn = folder.join(name).with_extension("svg");
            let scene = format!("{name}/{}", word_behind(block, "scene "));
            run(&["sketch", &scene, "--out", drawn.to_str().unwrap()]);
            let kept = root.join("../docs/guide/src").join(picture).with_extension("svg");
            assert_current(&kept, &fs::read_to_string(&drawn).unwrap());
            n_pictures += 1;
        }
    }
    assert_eq!(n_models, source.matches("pub model ").count(), "the page shows every model");
    assert_eq!(n_pictures, page.matches("\n![").count(), "each picture shows the model above it");
}
