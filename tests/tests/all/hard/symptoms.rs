//! The page by symptom quotes messages that EZY has, and names cases that are there.

use ezy_tests::hard::families::families;
use ezy_tests::page::docs;
use std::fs;
use std::path::Path;

/// What stands where no case shows a symptom.
const NONE: &str = "no case";

/// The lines of the tables by symptom as cells: what is seen, its meaning, what to do, what shows it.
fn symptoms() -> Vec<[String; 4]> {
    let page = fs::read_to_string(docs("hard-cases.md")).unwrap();
    let part = page.split_once("## By symptom").unwrap().1.split_once("# The log").unwrap().0;
    let cells =
        |line: &str| -> Vec<String> { line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect() };
    let lines = part.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| you see"));
    lines.map(|line| cells(line).try_into().unwrap_or_else(|_| panic!("`{line}` has no four cells"))).collect()
}

/// All Rust files of a folder as one text, with strings that go over lines joined.
fn sources(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            text += &sources(&path);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let file = fs::read_to_string(path).unwrap();
            text += &file.split("\\\n").map(str::trim_start).collect::<String>();
        }
    }
    text
}

#[test]
fn invariant_symptoms_quote_messages_that_are_there() {
    let root = docs("..");
    let text: String = ["ezy-core/src", "ezy-study/src", "ezy-cli/src", "models/src"]
        .iter()
        .map(|folder| sources(&root.join(folder)))
        .collect();
    let mut seen = 0;
    for [symptom, ..] in symptoms() {
        for quoted in symptom.split('"').skip(1).step_by(2) {
            assert!(text.contains(quoted), "no message says \"{quoted}\"");
            seen += 1;
        }
    }
    assert!(seen >= 10, "only {seen} messages found on the page");
}

#[test]
fn invariant_symptoms_name_cases_and_tests_that_are_there() {
    let families = families();
    let cases: Vec<&str> = families.iter().flat_map(|family| &family.cases).map(|case| case.name.as_str()).collect();
    for [symptom, .., shown] in symptoms() {
        let names: Vec<&str> = shown.split('`').skip(1).step_by(2).collect();
        assert!(!names.is_empty() || shown == NONE, "nothing shows {symptom}");
        for name in names {
            assert!(cases.contains(&name) || docs("..").join(name).is_file(), "`{name}` is no case and no test");
        }
    }
}
