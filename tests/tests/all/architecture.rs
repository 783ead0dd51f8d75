//! ARCHITECTURE.md and docs/decisions tell the truth: their paths exist, and layers import only what the page allows. The macro
//! does not depend on the crate that it writes for: what stands in both is alike.

use crate::circles::{self, modules};
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
    ("output", &["output"]),
    ("record", &["record", "model"]),
    ("simulate", &["simulate", "integrate", "dynamics", "linalg", "record", "model", "scalar"]),
    ("optimise", &["optimise", "simulate", "integrate", "record", "model", "scalar"]),
    ("report", &["report", "output", "record", "model"]),
    (
        "accuracy",
        &["accuracy", "simulate", "integrate", "dynamics", "linalg", "output", "record", "report", "model", "scalar"],
    ),
    ("sweep", &["sweep", "simulate", "dynamics", "linalg", "output", "record", "model"]),
    (
        "cli",
        &[
            "cli",
            "accuracy",
            "sweep",
            "testing",
            "simulate",
            "integrate",
            "dynamics",
            "linalg",
            "record",
            "report",
            "output",
            "model",
            "scalar",
        ],
    ),
];

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn check(source: &str, layers: &[(&str, &[&str])]) {
    let texts = modules(source);
    for (layer, allowed) in layers {
        let of_layer = || texts.iter().filter(|(module, _)| module.first().is_some_and(|first| first == layer));
        assert!(of_layer().next().is_some(), "{source}/{layer} is gone");
        // the unit tests of a layer may use what they like
        for (module, text) in of_layer().filter(|(module, _)| !module.iter().any(|name| name == "tests")) {
            for import in circles::paths(text).iter().filter(|path| path[0] == "crate").map(|path| path[1].as_str()) {
                let is_layer = layers.iter().any(|(layer, _)| *layer == import);
                assert!(!is_layer || allowed.contains(&import), "{source}/{} imports `{import}`", module.join("/"));
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

/// Texts in single backquotes that are paths of the repository.
pub fn paths(page: &str) -> Vec<&str> {
    let prefixes = ["ezy-derive/", "ezy-core/", "models/", "tests/", "docs/"];
    let quoted = page.split('`').skip(1).step_by(2);
    quoted.filter(|quoted| prefixes.iter().any(|prefix| quoted.starts_with(prefix))).collect()
}

fn assert_paths_exist(page_name: &str) -> usize {
    let page = fs::read_to_string(root().join(page_name)).unwrap();
    let paths = paths(&page);
    for path in &paths {
        assert!(root().join(path).exists(), "{page_name} names `{path}`, which is not there");
    }
    paths.len()
}

#[test]
fn invariant_paths_of_the_architecture_page_exist() {
    let seen = assert_paths_exist("ARCHITECTURE.md");
    assert!(seen >= 20, "only {seen} paths found on the page");
}

/// What is read in ten minutes.
const LONGEST_PAGE: usize = 150;

#[test]
fn invariant_architecture_page_is_short() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let lines = page.lines().count();
    assert!(lines <= LONGEST_PAGE, "ARCHITECTURE.md has {lines} lines");
}

#[test]
fn invariant_decisions_are_listed_and_complete() {
    let folder = "docs/decisions";
    let index = fs::read_to_string(root().join(folder).join("README.md")).unwrap();
    let listed: Vec<&str> =
        index.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(file, _)| file).collect();
    let mut found: Vec<String> = fs::read_dir(root().join(folder))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name != "README.md")
        .collect();
    found.sort();
    assert_eq!(listed, found, "{folder}/README.md lists each decision once, in order");
    for (i, name) in found.iter().enumerate() {
        assert!(name.starts_with(&format!("{:03}-", i + 1)), "{folder}/{name} leaves a number out");
        let page = fs::read_to_string(root().join(folder).join(name)).unwrap();
        for part in ["# ", "\n**Context.** ", "\n**Decision.** ", "\n**Cost.** ", "\n**Think again** "] {
            assert!(page.contains(part), "{folder}/{name} lacks `{}`", part.trim());
        }
        let title = page.lines().next().unwrap_or_default().trim_start_matches("# ");
        assert!(index.contains(&format!("]({name}) {title}\n")), "{folder}/README.md has another title for {name}");
        assert_paths_exist(&format!("{folder}/{name}"));
    }
}

/// What a pivot counts as vanished below, in how large groups sums of products are padded, and which matrices are listed
/// by rows.
const SHARED: [&str; 2] = ["PIVOT_TOLERANCE", "PRODUCT_GROUP"];

/// What a crate says of a constant: type and value, each time it is defined.
fn definitions(source: &str, name: &str) -> Vec<String> {
    let begin = format!("const {name}: ");
    let texts = modules(source);
    let lines = texts.values().flat_map(|text| text.lines());
    lines.filter_map(|line| Some(line.split_once(&begin)?.1.to_owned())).collect()
}

#[test]
fn cross_constants_of_macro_and_core_agree() {
    for name in SHARED {
        let [derive, core] = ["ezy-derive/src", "ezy-core/src"].map(|source| definitions(source, name));
        assert_eq!((derive.len(), &derive), (1, &core), "{name} is defined once in each crate, and alike");
    }
}
