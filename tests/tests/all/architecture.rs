//! ARCHITECTURE.md and docs/decisions tell the truth: their paths exist, and layers import only what the page allows. The macro
//! does not depend on the crate that it writes for: what stands in both is alike.

use crate::circles::{self, modules};
use std::collections::BTreeSet;
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
    ("export", &["export", "dynamics", "linalg", "model", "scalar"]),
    ("linalg", &["linalg", "model"]),
    ("dynamics", &["dynamics", "linalg", "model", "scalar"]),
    ("analysis", &["analysis", "dynamics", "linalg", "model", "scalar"]),
    ("integrate", &["integrate", "dynamics", "linalg", "model", "scalar"]),
    ("record", &["record", "model"]),
    ("simulate", &["simulate", "integrate", "dynamics", "linalg", "record", "model", "scalar"]),
    ("optimise", &["optimise", "simulate", "integrate", "record", "model", "scalar"]),
];

/// The layers of studies, with those of the core that each may import.
const STUDY: &[(&str, &[&str])] = &[
    ("output", &["output"]),
    ("report", &["report", "output", "record", "model"]),
    ("accuracy", &["accuracy", "simulate", "integrate", "dynamics", "output", "record", "report", "model", "scalar"]),
    ("sweep", &["sweep", "simulate", "output", "record", "model"]),
];

/// The command line, and the layers of core and studies that it may import.
const CLI: (&str, &[&str]) = (
    "ezy-cli",
    &[
        "analysis",
        "accuracy",
        "export",
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
);

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// `crates`: those whose layers have the names that are listed, by the words that begin their paths.
fn check(source: &str, crates: &[&str], layers: &[(&str, &[&str])]) {
    let texts = modules(source);
    let is_layer = |name: &str| [CORE, layers].iter().any(|layers| layers.iter().any(|(layer, _)| *layer == name));
    for (layer, allowed) in layers {
        let of_layer = || texts.iter().filter(|(module, _)| module.first().is_some_and(|first| first == layer));
        assert!(of_layer().next().is_some(), "{source}/{layer} is gone");
        // the unit tests of a layer may use what they like
        for (module, text) in of_layer().filter(|(module, _)| !module.iter().any(|name| name == "tests")) {
            let paths = circles::paths(text);
            let of_crates = paths.iter().filter(|path| path.len() > 1 && crates.contains(&path[0].as_str()));
            for import in of_crates.map(|path| path[1].as_str()) {
                assert!(
                    !is_layer(import) || allowed.contains(&import),
                    "{source}/{} imports `{import}`",
                    module.join("/")
                );
            }
        }
    }
}

#[test]
fn invariant_layers_of_the_macro_import_downwards() {
    check("ezy-derive/src", &["crate"], DERIVE);
}

#[test]
fn invariant_layers_of_the_core_import_downwards() {
    check("ezy-core/src", &["crate"], CORE);
}

#[test]
fn invariant_layers_of_studies_import_downwards() {
    check("ezy-study/src", &["crate", "ezy_core"], STUDY);
}

#[test]
fn invariant_command_line_imports_the_layers_that_are_listed() {
    let texts = modules("ezy-cli/src");
    let paths: Vec<Vec<String>> = texts.values().flat_map(|text| circles::paths(text)).collect();
    let imported: BTreeSet<&str> = paths
        .iter()
        .filter(|path| ["ezy_core", "ezy_study"].contains(&path[0].as_str()) && path.len() > 1)
        .map(|path| path[1].as_str())
        .collect();
    assert_eq!(imported, CLI.1.iter().copied().collect());
}

/// Where each layer stands in the picture: column and floor.
const PLACES: [&[(&str, [u32; 2])]; 2] = [
    &[
        ("ezy-cli", [380, 7]),
        ("optimise", [120, 6]),
        ("accuracy", [500, 6]),
        ("sweep", [640, 6]),
        ("simulate", [300, 5]),
        ("analysis", [100, 4]),
        ("integrate", [240, 4]),
        ("dynamics", [240, 3]),
        ("export", [580, 4]),
        ("report", [500, 5]),
        ("layout", [100, 2]),
        ("linalg", [240, 2]),
        ("record", [420, 2]),
        ("output", [700, 4]),
        ("model", [280, 1]),
        ("scalar", [280, 0]),
    ],
    &[
        ("emit", [860, 5]),
        ("mechanics", [860, 4]),
        ("model", [860, 3]),
        ("symbolic", [990, 3]),
        ("parse", [860, 2]),
        ("diag", [860, 1]),
    ],
];

/// The layers that one imports, without those that one of them imports, too.
fn next_below(layers: &[(&'static str, &'static [&'static str])], of: &str) -> Vec<&'static str> {
    let imports = |of: &str| layers.iter().find(|(layer, _)| *layer == of).map_or(&[][..], |(_, imports)| imports);
    let below = || imports(of).iter().copied().filter(|layer| *layer != of);
    below().filter(|layer| !below().any(|over| over != *layer && imports(over).contains(layer))).collect()
}

/// Layers as boxes, a line from each to those right below it.
fn picture() -> String {
    const FLOOR: u32 = 64;
    let y = |floor: u32| FLOOR * (7 - floor) + 56;
    let mut lines = String::new();
    let mut boxes = String::new();
    let upwards = [&[CLI], CORE, STUDY].concat();
    for (layers, places) in [&upwards[..], DERIVE].into_iter().zip(PLACES) {
        let place = |layer: &str| places.iter().find(|(name, _)| *name == layer).map(|(_, place)| *place);
        // what emitted code calls stands beside the layers
        for (layer, _) in layers.iter().filter(|(layer, _)| *layer != "kernel") {
            let [x, floor] = place(layer).unwrap_or_else(|| panic!("`{layer}` has no place in the picture"));
            for [to_x, to_floor] in next_below(layers, layer).into_iter().filter_map(place) {
                assert!(to_floor < floor, "`{layer}` stands below what it imports");
                lines += &format!("<path d=\"M{x} {} L{to_x} {}\"/>\n", y(floor) + 15, y(to_floor) - 15);
            }
            boxes += &format!("<rect x=\"{}\" y=\"{}\" width=\"96\" height=\"30\" rx=\"4\"/>", x - 48, y(floor) - 15);
            boxes += &format!("<text x=\"{x}\" y=\"{}\">{layer}</text>\n", y(floor) + 5);
        }
    }
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1080 540\" font-family=\"sans-serif\" font-size=\"15\">\n\
         <style>text {{ fill: #222; text-anchor: middle; }} path, rect {{ fill: none; stroke: #667; }} rect {{ fill: #eef; }}\n\
         @media (prefers-color-scheme: dark) {{ text {{ fill: #eee; }} path, rect {{ stroke: #99a; }} rect {{ fill: #223; }} }}</style>\n\
         <text x=\"120\" y=\"30\">ezy-core</text>\n<text x=\"660\" y=\"84\">ezy-study</text>\n<text x=\"860\" y=\"30\">ezy-derive</text>\n{lines}{boxes}</svg>\n"
    )
}

#[test]
fn regress_picture_of_the_layers_is_that_of_their_imports() {
    let path = root().join("docs/layers.svg");
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&path, picture()).unwrap();
    }
    let drawn = fs::read_to_string(path).unwrap();
    assert!(
        drawn == picture(),
        "docs/layers.svg is out of date: UPDATE_GOLDEN=1 cargo test -p ezy-tests --test all -- picture_of_the_layers"
    );
}

/// Texts in single backquotes that are paths of the repository.
pub fn paths(page: &str) -> Vec<&str> {
    let prefixes = ["ezy-derive/", "ezy-core/", "ezy-study/", "ezy-cli/", "models/", "tests/", "docs/"];
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
