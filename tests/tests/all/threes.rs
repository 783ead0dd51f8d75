//! How many coordinates a body has, and where they stand, is said in `model/coordinate.rs` of each crate: no other file has a literal 3 where
//! it computes places in q.

use crate::circles::{modules, remove_tests};

const SAID_IN: &str = "model/coordinate";

/// Threes that have nothing to do with coordinates: file, line, and what is counted.
const OTHERS: [(&str, &str, &str); 5] = [
    ("diag/nearest", "(shorter / 3)", "letters of a name for each that may be wrong"),
    ("emit/places", "[Entries; 3]", "kinds of numbers that a series reads"),
    ("report/figure/svg", "bytes.len().div_ceil(3)", "bytes that four signs of base64 hold"),
    ("report/figure/svg", "bytes.chunks(3)", "bytes that four signs of base64 hold"),
    ("testing/jacobians", "(i % 3)", "different multipliers, any number of them would do"),
];

/// Calls that take as many numbers at a time as a body has coordinates.
const BY_THREES: [&str; 9] = [
    "chunks(",
    "chunks_mut(",
    "chunks_exact(",
    "chunks_exact_mut(",
    "as_chunks::<",
    "as_chunks_mut::<",
    "div_ceil(",
    "step_by(",
    "is_multiple_of(",
];
/// The names of the number: a file that uses one of them uses it for the lengths of its arrays, too.
const NAMES: [&str; 2] = ["N_OF_BODY", "Component::ALL"];

#[test]
fn invariant_number_of_coordinates_of_a_body_is_said_once() {
    let mut found: Vec<(String, String)> = Vec::new();
    for source in ["ezy-core/src", "ezy-study/src", "ezy-cli/src", "ezy-derive/src"] {
        let mut texts = modules(source);
        remove_tests(&mut texts);
        let texts = texts.into_iter().map(|(module, text)| (module.join("/"), text));
        for (file, text) in texts.filter(|(file, _)| file != SAID_IN) {
            found.extend(threes(&text).into_iter().map(|line| (file.clone(), line)));
        }
    }
    let is_other =
        |(file, line): &(String, String), other: &(&str, &str, &str)| file == other.0 && line.contains(other.1);
    for other in &OTHERS {
        assert!(found.iter().any(|one| is_other(one, other)), "take {other:?} off the list");
    }
    found.retain(|one| !OTHERS.iter().any(|other| is_other(one, other)));
    assert!(found.is_empty(), "of coordinates? then use {SAID_IN}.rs: {found:#?}");
}

#[test]
fn analytic_threes_in_places_are_found_and_no_others() {
    for line in [
        "q[3 * body + 2]",
        "for i in 3 * a..3 * b",
        "column / 3",
        "(k % 3)",
        "n * 3",
        "q[i + 3]",
        "q[3 + i]",
        "q.chunks_exact(3)",
        "q.as_chunks::<3>()",
        "vec![[0.0; 3]; N_OF_BODY]",
    ] {
        assert_eq!(threes(line), [line]);
    }
    for line in [
        "0.3 * width",
        "3.0 * x",
        "1e-3 * x",
        "x.3 * y",
        "13 * n",
        "n / 30",
        "3u8",
        "[0x1a; 3]",
        "k + 3 <= n",
        "\"3 * x\"",
        "'\"', 2 / n, \"a \\\" 3 * x\"",
        "x.powi(3)",
    ] {
        assert!(threes(line).is_empty(), "{line}");
    }
}

/// The lines of a text in which a literal 3 stands in the arithmetic of places.
fn threes(text: &str) -> Vec<String> {
    let text = without_strings(text);
    let has_a_name = NAMES.iter().any(|name| text.contains(name));
    let is_of_places = |(before, after): (&str, &str)| {
        let is_factor = ["* ", "/ ", "% "].iter().any(|sign| before.ends_with(sign)) || after.starts_with(" *");
        let is_added =
            before.ends_with("+ ") && after.starts_with(']') || before.ends_with('[') && after.starts_with(" +");
        let is_length = has_a_name && before.ends_with("; ") && after.starts_with(']');
        is_factor || is_added || is_length || BY_THREES.iter().any(|call| before.ends_with(call))
    };
    let lines = text.lines().filter(|line| literal_threes(line).any(is_of_places));
    lines.map(|line| line.trim().to_owned()).collect()
}

/// What stands before and behind each 3 of a line that is a literal of its own, not a part of a name or of another number.
fn literal_threes(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let places = line.match_indices('3').map(|(at, _)| (&line[..at], &line[at + 1..]));
    places.filter(|(before, after)| {
        let ends = |c: char| c.is_alphanumeric() || c == '_';
        let is_behind_a_point = before.ends_with('.') && !before.ends_with("..");
        let is_before_a_point = after.starts_with('.') && !after.starts_with("..");
        let is_exponent =
            before.strip_suffix("e-").is_some_and(|number| number.ends_with(|c: char| c.is_ascii_digit()));
        !is_exponent && !before.ends_with(ends) && !after.starts_with(ends) && !is_behind_a_point && !is_before_a_point
    })
}

/// A text with its strings left out; lines stay apart.
fn without_strings(text: &str) -> String {
    let text = text.replace("'\"'", "' '").replace("'\\\"'", "' '");
    let (mut code, mut is_in, mut is_escaped) = (String::new(), false, false);
    for c in text.chars() {
        let ends = c == '"' && !is_escaped;
        is_escaped = is_in && c == '\\' && !is_escaped;
        is_in ^= ends;
        if !is_in || ends || c == '\n' {
            code.push(c);
        }
    }
    code
}
