//! Every threshold of the numerical layers stands in one place, with its unit and with a test that is there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

const LAYERS: [&str; 5] = ["dynamics", "linalg", "integrate", "simulate", "analysis"];

/// Numbers of a method that stand with its formulas: coefficients.
const WITH_FORMULAS: [&str; 1] = ["tableau.rs"];

/// The layer in which numbers may stand without a name: in formulas of a source, as that of a first step, and in tolerances of given steps.
const WITH_NAMELESS: &str = "integrate";

/// Numbers that are no thresholds: the modes of a scene, a place in a group of inputs, what mathematics gives, sizes of blocks, sizes and orders of methods, and
/// public numbers; of `analysis` the parameters of the ITP method, nodes, shares of a period, and first states of generators.
const NO_THRESHOLDS: [&str; 32] = [
    "DRIFT",
    "SAME",
    "BODIES",
    "FREE",
    "HOLDS",
    "SLIDES_LEFT",
    "SLIDES_RIGHT",
    "GOLDEN",
    "GOLDEN_RATIO",
    "LARGEST_BASIS",
    "DOUBLE_FACTORIAL_OF_15",
    "N_COEFFICIENTS",
    "WIDTH",
    "ERROR_ORDER",
    "DENSE_ERROR_ORDER",
    "ESTIMATE_ORDER",
    "LARGEST_OF_FIXED_STEPS",
    "SMALLEST_RELATIVE",
    "DEFAULT",
    "SINCE",
    "ORDER",
    "TWO_BODIES",
    "N_LAST",
    "LOG_NOTHING",
    "KAPPA_1",
    "KAPPA_2",
    "LOST",
    "BETWEEN",
    "SHARES",
    "N_OF_FRAME",
    "N_STAGES",
    "SEED",
];

const NUMBERS: [&str; 8] = ["f64", "f32", "usize", "u32", "u64", "i32", "std::ops::Range<f64>", "Range<f64>"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found
}

/// The code of a file without its unit tests and comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    text.lines().map(str::trim).map(|line| line.split("//").next().unwrap_or_default())
}

/// Name and type of the constant that a line defines.
fn constant(line: &str) -> Option<(&str, &str)> {
    let (name, rest) = line.split_once("const ")?.1.split_once(": ")?;
    let is_name = name.chars().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
    is_name.then(|| (name, rest.split(" =").next().unwrap_or_default()))
}

fn is_number(kind: &str) -> bool {
    let of_array = kind.trim_start_matches('[').split(';').next().unwrap_or_default();
    NUMBERS.contains(&of_array)
}

/// Whether a line holds a number like 1e-12, which never says why it is that one.
fn has_power_of_ten(line: &str) -> bool {
    let bytes = line.as_bytes();
    (1..bytes.len().saturating_sub(1)).any(|i| {
        let exponent = bytes[i + 1].is_ascii_digit() || bytes[i + 1] == b'-';
        let begins = line[..i].rfind(|c: char| !(c.is_ascii_digit() || c == '.' || c == '_')).map_or(0, |at| at + 1);
        let is_number = begins < i && bytes[begins].is_ascii_digit();
        let in_word = begins > 0 && (bytes[begins - 1].is_ascii_alphanumeric() || bytes[begins - 1] == b'"');
        bytes[i] == b'e' && exponent && is_number && !in_word
    })
}

#[test]
fn invariant_thresholds_stand_in_one_place_a_layer() {
    let mut n = 0;
    for layer in LAYERS {
        let folder = root().join("ezy-core/src").join(layer);
        // unit tests that fill a file or a folder of their own
        let is_code = |file: &PathBuf| {
            let mut parts = file.strip_prefix(&folder).unwrap().iter();
            !parts.any(|part| part == "tests" || part == "tests.rs" || WITH_FORMULAS.iter().any(|with| part == *with))
        };
        for file in sources(&folder).into_iter().filter(is_code) {
            let text = fs::read_to_string(&file).unwrap();
            let is_place = file == folder.join("tolerances.rs");
            for line in code(&text) {
                let threshold = constant(line).filter(|(name, kind)| is_number(kind) && !NO_THRESHOLDS.contains(name));
                n += usize::from(is_place && threshold.is_some());
                let is_nameless = layer != WITH_NAMELESS && has_power_of_ten(line);
                let stray = !is_place && (threshold.is_some() || is_nameless);
                assert!(!stray, "{}: `{line}` belongs in {layer}/tolerances.rs", file.display());
            }
        }
    }
    println!("{n} thresholds");
    assert!(n >= 20, "only {n} thresholds found");
}

/// Names of the functions that are tests.
fn tests() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for folder in ["tests/tests", "ezy-core/src", "tests/core/tests/motion"] {
        for file in sources(&root().join(folder)) {
            let text = fs::read_to_string(file).unwrap();
            let functions = text.split("#[test]\n").skip(1).filter_map(|rest| rest.trim_start().strip_prefix("fn "));
            found.extend(functions.filter_map(|rest| Some(rest.split_once('(')?.0.to_owned())));
        }
    }
    found
}

#[test]
fn invariant_thresholds_have_a_unit_and_a_test_that_exists() {
    let tests = tests();
    for layer in LAYERS {
        let text = fs::read_to_string(root().join("ezy-core/src").join(layer).join("tolerances.rs")).unwrap();
        let mut doc = String::new();
        for line in text.lines().map(str::trim) {
            if let Some(words) = line.strip_prefix("/// ") {
                doc.push_str(words);
                doc.push(' ');
                continue;
            }
            if let Some((name, _)) = constant(line) {
                assert!(doc.contains("Unit: "), "{layer}: {name} has no unit");
                let named = doc.split_once("Test: ").unwrap_or_else(|| panic!("{layer}: {name} has no test")).1;
                let named: Vec<&str> = named.split('`').skip(1).step_by(2).collect();
                assert!(!named.is_empty(), "{layer}: {name} names no test");
                for test in named {
                    assert!(tests.contains(test), "{layer}: {name} names `{test}`, which is no test");
                }
            }
            doc.clear();
        }
    }
}

/// The decision lists each threshold with its value, the tests named beside it, and that one of them fails.
#[test]
fn invariant_table_of_the_decision_lists_every_threshold_and_a_test_that_fails() {
    let decision = fs::read_to_string(root().join("docs/decisions/045-thresholds-earn-their-place.md")).unwrap();
    let mut rows: Vec<&str> =
        decision.lines().filter(|line| LAYERS.iter().any(|l| line.starts_with(&format!("| {l} |")))).collect();
    for layer in LAYERS {
        let text = fs::read_to_string(root().join("ezy-core/src").join(layer).join("tolerances.rs")).unwrap();
        let (mut group, mut doc) = ("", String::new());
        for line in text.lines() {
            group = line.strip_prefix("pub(crate) mod ").map_or(group, |rest| rest.trim_end_matches(" {"));
            if line.trim().starts_with("///") {
                doc.push_str(line);
            } else if let (Some((name, _)), Some((_, value))) = (constant(line), line.split_once(" = ")) {
                let begins = format!("| {layer} | {group}::{name} | {} |", value.trim_end_matches(';'));
                let Some(i) = rows.iter().position(|row| row.starts_with(&begins)) else { panic!("no row `{begins}`") };
                let row = rows.swap_remove(i);
                let tests = doc.split_once("Test: ").map_or("", |(_, named)| named);
                let missing = tests.split('`').skip(1).step_by(2).find(|test| !row.contains(&format!("`{test}`")));
                let fails = row.contains("| fails |") || row.ends_with("fails |");
                assert!(missing.is_none() && fails, "{row}: {missing:?}");
                doc.clear();
            } else {
                doc.clear();
            }
        }
    }
    assert!(rows.is_empty(), "no thresholds: {rows:?}");
}

#[test]
fn analytic_lines_with_thresholds_are_told_from_others() {
    for (line, expected) in [
        ("if x < 1e-12 {", true),
        ("let x = 2.5e3 * y;", true),
        ("x = 1_000e-3;", true),
        ("let one2e4 = 0.5;", false),
        ("self.step(1e)", false),
    ] {
        assert_eq!(has_power_of_ten(line), expected, "{line}");
    }
    assert_eq!(constant("pub(crate) const NEAR: f64 = 1.6;"), Some(("NEAR", "f64")));
    assert_eq!(constant("pub(crate) const BESIDE: [f64; 2] = [0.40, 0.53];"), Some(("BESIDE", "[f64; 2]")));
    assert!(is_number("[f64; 2]") && !is_number("&str"));
    assert_eq!(constant("fn of<const N: usize>()"), Some(("N", "usize>()")));
}
