//! CONTRIBUTING.md says how to add a kind of row. Here a copy of the macro gets it, as the page says, and uses it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A model that uses the new word; it must compile, and a ratio in place of the angle must be an error.
const USE: &str = r##"

#[cfg(test)]
mod worked_example {
    const TEXT: &str = "model Lamp { body arm { mass: 1, inertia: 1 } body shelf { mass: 1, inertia: 1 } \
        parallel p: arm ~ shelf angle 0.5; start s { at rest; } scene swing { start s; until 1 s; } }";

    #[test]
    fn analytic_new_word_is_a_row() {
        let items = super::expand(TEXT.parse().expect("the text has tokens")).to_string();
        assert!(!items.contains("compile_error"), "{items}");
        assert!(items.contains(r#"Borrowed ("p") , kind : "parallel""#), "{items}");
    }

    #[test]
    fn analytic_new_word_says_what_it_knows() {
        let text = TEXT.replace("angle 0.5", "ratio 0.5");
        let items = super::expand(text.parse().expect("the text has tokens")).to_string();
        assert!(items.contains("compile_error") && items.contains("angle"), "{items}");
    }
}
"##;

/// The code blocks below the heading of the example, in order.
fn blocks(page: &str) -> Vec<String> {
    let section = page.split("\n## ").find(|section| section.starts_with("Adding a kind of row"));
    let section = section.expect("CONTRIBUTING.md says how to add a kind of row");
    let bodies = section.split("```rust\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default());
    bodies
        .map(|body| body.lines().map(|line| line.strip_prefix("   ").unwrap_or(line).to_owned() + "\n").collect())
        .collect()
}

fn insert_before(file: &Path, anchor: &str, text: &str) {
    let before = fs::read_to_string(file).expect("the file is there");
    assert!(before.contains(anchor), "{} has no `{anchor}`", file.display());
    fs::write(file, before.replacen(anchor, &format!("{text}{anchor}"), 1)).expect("the copy can be written");
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("the folder can be made");
    for entry in fs::read_dir(from).expect("the folder is there").map(|entry| entry.expect("an entry").path()) {
        let target = to.join(entry.file_name().expect("a name"));
        if entry.is_dir() {
            copy(&entry, &target);
        } else {
            fs::copy(&entry, &target).expect("the file can be copied");
        }
    }
}

#[test]
fn reference_example_of_a_new_row_works_as_the_page_says() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("worked_example");
    let _ = fs::remove_dir_all(&root);
    let source = root.join("ezy-derive/src");
    copy(&here.join("src"), &source);
    let manifest = fs::read_to_string(here.join("Cargo.toml")).expect("the manifest is there");
    let needed = manifest.replace("trybuild = { workspace = true }\n", "");
    fs::write(root.join("ezy-derive/Cargo.toml"), needed).expect("the manifest can be written");
    fs::copy(here.join("../Cargo.lock"), root.join("Cargo.lock")).expect("the lock file can be copied");
    let workspace = fs::read_to_string(here.join("../Cargo.toml")).expect("the manifest is there");
    let kept = workspace.split("\n[profile").next().unwrap_or_default().lines();
    let kept = kept.filter(|line| !line.starts_with("default-members") && !line.starts_with("exclude"));
    let alone = kept.map(|line| if line.starts_with("members") { "members = [\"ezy-derive\"]" } else { line });
    fs::write(root.join("Cargo.toml"), alone.collect::<Vec<_>>().join("\n")).expect("the manifest can be written");

    let page = fs::read_to_string(here.join("../CONTRIBUTING.md")).expect("the page is there");
    let [word, file, module, arm] = &blocks(&page)[..] else { panic!("the example has four blocks of code") };
    insert_before(&source.join("grammar.rs"), "    position(\"drive\"", word);
    fs::write(source.join("mechanics/rows/parallel.rs"), file).expect("the copy can be written");
    insert_before(&source.join("mechanics/rows/mod.rs"), "mod rod;\n", module);
    insert_before(&source.join("mechanics/rows/mod.rs"), "        \"rod\" =>", arm);
    let pipeline = fs::read_to_string(source.join("pipeline.rs")).expect("the file is there");
    fs::write(source.join("pipeline.rs"), pipeline + USE).expect("the copy can be written");

    // in a target folder of its own: the one of the workspace may be in use
    let output = Command::new(env!("CARGO"))
        .args(["test", "--quiet", "--offline", "--lib", "worked_example"])
        .current_dir(&root)
        .env("CARGO_TARGET_DIR", root.with_extension("target"))
        // built once, and not debugged
        .env("CARGO_INCREMENTAL", "0")
        .env("CARGO_PROFILE_DEV_DEBUG", "false")
        .output()
        .expect("cargo runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && said.contains("2 passed"), "{said}");
}
