//! The examples of the guide's chapter on the language are those of `examples/words`, and pass their checks.

use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn fd_examples_of_all_words_pass_their_checks() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("../docs/guide/src/language.md")).unwrap();
    let files = ["items", "constraints", "forces", "scenes"].map(|name| format!("examples/words/{name}.rs"));
    let source: String = files.iter().map(|name| fs::read_to_string(root.join(name)).unwrap()).collect();
    let program = Path::new(env!("CARGO_BIN_EXE_ezy")).with_file_name("examples").join("words");
    let program = program.with_extension(std::env::consts::EXE_EXTENSION);
    let blocks = page.split("```rust\nezy_core::model! {").skip(1).filter_map(|rest| rest.split_once("```"));
    let mut n_models = 0;
    for (block, _) in blocks {
        assert!(source.contains(block), "examples/words has not\n{block}");
        let name = block.split_once("pub model ").unwrap().1.split_whitespace().next().unwrap();
        let done = Command::new(&program).args(["check", name]).output().unwrap();
        assert!(done.status.success(), "{name}:\n{}", crate::text(&done.stdout) + &crate::text(&done.stderr));
        n_models += 1;
    }
    assert_eq!(n_models, source.matches("pub model ").count(), "the page shows every model");
}
