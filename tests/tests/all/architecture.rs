//! ARCHITECTURE.md and docs/decisions tell the truth: their paths exist, and layers import only what the page allows. The macro
//! does not depend on the crate that it writes for: what stands in both is alike.

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

/// Texts in single backquotes that are paths of the repository.
fn paths(page: &str) -> Vec<&str> {
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

/// What a reader has in mind at once.
const LONGEST_PAGE: usize = 150;
const MOST_FILES_OF_A_WALK: usize = 5;

#[test]
fn invariant_architecture_page_is_short_and_so_are_its_walks() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let lines = page.lines().count();
    assert!(lines <= LONGEST_PAGE, "ARCHITECTURE.md has {lines} lines");
    let walks = page.split_once("## Three walks").expect("the page has walks").1;
    let walks: Vec<&str> = walks.split("\n### ").skip(1).collect();
    assert_eq!(walks.len(), 3);
    for walk in walks {
        let title = walk.lines().next().unwrap();
        let files = paths(walk);
        assert!((2..=MOST_FILES_OF_A_WALK).contains(&files.len()), "`{title}` goes through {files:?}");
        for file in files {
            assert!(root().join(file).is_file(), "`{title}` goes through `{file}`, which is no file");
        }
    }
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
fn definitions(source: &Path, name: &str) -> Vec<String> {
    let begin = format!("const {name}: ");
    let texts = files(source).into_iter().map(|file| fs::read_to_string(file).unwrap());
    let found = |text: String| text.lines().filter_map(|line| Some(line.split_once(&begin)?.1.to_owned())).collect();
    texts.flat_map::<Vec<String>, _>(found).collect()
}

#[test]
fn cross_constants_of_macro_and_core_agree() {
    for name in SHARED {
        let [derive, core] = ["ezy-derive/src", "ezy-core/src"].map(|source| definitions(&root().join(source), name));
        assert_eq!((derive.len(), &derive), (1, &core), "{name} is defined once in each crate, and alike");
    }
}
