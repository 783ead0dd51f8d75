//! ARCHITECTURE.md tells the truth: its paths exist, and layers import only what it allows.

use std::fs;
use std::path::{Path, PathBuf};

/// Layer, and the layers of the same crate that it may import.
const DERIVE: &[(&str, &[&str])] = &[
    ("diag", &["diag"]),
    ("parse", &["parse", "diag"]),
    ("model", &["model", "parse", "diag"]),
    ("symbolic", &["symbolic"]),
    ("mechanics", &["mechanics", "symbolic", "model", "diag"]),
    ("emit", &["emit", "mechanics", "symbolic", "model"]),
];

const CORE: &[(&str, &[&str])] = &[
    ("scalar", &["scalar"]),
    ("model", &["model", "scalar"]),
    ("kernel", &["kernel"]),
    ("layout", &["layout", "model"]),
    ("linalg", &["linalg", "model"]),
    ("dynamics", &["dynamics", "linalg", "model", "scalar"]),
    ("integrate", &["integrate", "dynamics", "linalg", "model", "scalar"]),
    ("record", &["record", "model"]),
    ("simulate", &["simulate", "integrate", "dynamics", "linalg", "record", "model", "scalar"]),
    ("report", &["report", "record", "model"]),
    ("accuracy", &["accuracy", "simulate", "integrate", "dynamics", "linalg", "record", "report", "model", "scalar"]),
    (
        "cli",
        &[
            "cli",
            "accuracy",
            "testing",
            "simulate",
            "integrate",
            "dynamics",
            "linalg",
            "record",
            "report",
            "model",
            "scalar",
        ],
    ),
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A layer is one file, or a folder with or without a file beside it.
fn files(layer: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![layer.to_path_buf(), layer.with_extension("rs")];
    while let Some(path) = open.pop() {
        if path.is_dir() {
            open.extend(fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
        } else if path.extension().is_some_and(|extension| extension == "rs") && path.exists() {
            found.push(path);
        }
    }
    found
}

/// What follows `crate::` in a file; a group `crate::{a, b::c}` counts with each of its members.
fn imports(text: &str) -> Vec<String> {
    let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n");
    let word = |rest: &str| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let mut out = Vec::new();
    for rest in code.split("crate::").skip(1) {
        match rest.strip_prefix('{') {
            Some(group) => {
                let group = group.split(';').next().unwrap_or_default();
                let mut depth = 0;
                for part in group.split_inclusive([',', '{', '}']) {
                    if depth == 0 {
                        out.push(word(part.trim()));
                    }
                    depth += part.matches('{').count() as i32 - part.matches('}').count() as i32;
                }
            }
            None => out.push(word(rest)),
        }
    }
    out.retain(|name| !name.is_empty());
    out
}

fn check(source: &str, layers: &[(&str, &[&str])]) {
    let all: Vec<&str> = layers.iter().map(|(layer, _)| *layer).collect();
    for (layer, allowed) in layers {
        let found = files(&root().join(source).join(layer));
        assert!(!found.is_empty(), "{source}/{layer} is gone");
        for file in found {
            let text = fs::read_to_string(&file).unwrap();
            // the unit tests of a layer may use what they like
            let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            for import in imports(text) {
                let ok = !all.contains(&import.as_str()) || allowed.contains(&import.as_str());
                assert!(
                    ok || file.components().any(|part| part.as_os_str() == "tests"),
                    "{} imports `{import}`",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn invariant_layers_of_the_macro_import_downwards() {
    check("ezy-derive/src", DERIVE);
}

#[test]
fn invariant_layers_of_the_core_import_downwards() {
    check("ezy-core/src", CORE);
}

#[test]
fn invariant_paths_of_the_architecture_page_exist() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let prefixes = ["ezy-derive/", "ezy-core/", "models/", "tests/", "docs/"];
    let mut seen = 0;
    for quoted in page.split('`').skip(1).step_by(2) {
        if prefixes.iter().any(|prefix| quoted.starts_with(prefix)) {
            assert!(root().join(quoted).exists(), "ARCHITECTURE.md names `{quoted}`, which is not there");
            seen += 1;
        }
    }
    assert!(seen >= 20, "only {seen} paths found on the page");
}
