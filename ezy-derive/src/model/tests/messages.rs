//! Every message with its exact text and place, in golden files.
//!
//! A case of a golden file is a remark, the text (behind `>`), and its messages as `line:column text`; a blank
//! line ends it. `UPDATE_GOLDEN=1 cargo test -p ezy-derive` writes the files anew.

use std::collections::BTreeSet;
use std::path::PathBuf;

use super::resolve;
use crate::golden;

/// What stands before the items of a case, on line 1, and behind them.
const BEFORE: &str = "pub model M { body seat { mass: 1, inertia: 1 } body bar { mass: 1, inertia: 1 } \
    param k: N*s/m = 1; point A = seat(-1, 0); hinge B: seat(1, 0) ~ bar(-1, 0); \
    skate rear: at A along seat(1, 0); start begin { at rest; }\n";
const BEHIND: &str = "\nscene run { start begin; until 1 s; } }";

#[test]
fn regress_messages_of_syntax() {
    check("syntax", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_whole_models() {
    check("model", str::to_owned);
}

#[test]
fn regress_messages_of_names() {
    check("names", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_values() {
    check("values", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_mechanisms() {
    check("mechanism", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_rows_and_forces() {
    check("statements", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_starts_and_scenes() {
    check("scenes", |items| format!("{BEFORE}{items}{BEHIND}"));
}

/// Words, signs and units that other languages and books have.
#[test]
fn regress_messages_of_other_languages() {
    check("elsewhere", |items| format!("{BEFORE}{items}{BEHIND}"));
}

#[test]
fn regress_messages_of_counts_and_arrays() {
    check("repeats", |items| {
        let before = BEFORE.replace("start begin", "count n = 4; body link[n] { mass: 1, inertia: 1 } start begin");
        format!("{before}{items}{BEHIND}")
    });
}

/// Compares the messages of each case of a golden file.
fn check(golden: &str, model: impl Fn(&str) -> String) {
    let manifest = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let path = manifest.join("src/model/tests/messages").join(golden).with_extension("txt");
    let old = std::fs::read_to_string(&path).expect("the golden file is there");
    let new: Vec<String> = old.trim_end().split("\n\n").map(|case| with_messages(case, &model)).collect();
    let new = new.join("\n\n") + "\n";
    golden::compare(&path, &new);
}

/// The remark and the text of a case with the messages that the text has now.
fn with_messages(case: &str, model: impl Fn(&str) -> String) -> String {
    let kept: Vec<&str> = case.lines().filter(|line| line.starts_with("# ") || line.starts_with('>')).collect();
    let text: Vec<&str> = kept.iter().filter_map(|line| line.strip_prefix('>')).map(str::trim_end).collect();
    let text: Vec<&str> = text.iter().map(|line| line.strip_prefix(' ').unwrap_or(line)).collect();
    let (model, messages) = resolve(&model(&text.join("\n")));
    let fatal = messages.iter().any(|message| !message.contains(" warning: "));
    assert_eq!(model.is_none(), fatal, "a text is a model unless it has an error:\n{case}");
    let kept = kept.into_iter().map(str::to_owned);
    kept.chain(messages).collect::<Vec<_>>().join("\n")
}

/// The messages for forty effects, of which scene k calls for the first k + 1.
fn messages_of_forty(effect: impl Fn(usize) -> String) -> Vec<String> {
    let effects: String = (0..40).map(effect).collect();
    let with = |k: usize| (0..=k).map(|i| format!("e{i}")).collect::<Vec<_>>().join(", ");
    let scenes: String =
        (0..40).map(|k| format!("scene s{k} {{ start begin; until 1 s; with {}; }} ", with(k))).collect();
    resolve(&format!("{BEFORE}{effects}{scenes}{BEHIND}")).1
}

fn assert_reports(messages: &[String], n: usize, text: &str) {
    let found = messages.iter().filter(|message| message.contains(text)).count();
    assert_eq!((found, messages.len()), (n, n), "{messages:#?}");
}

#[test]
fn invariant_a_shared_parameter_is_reported_once_for_each_effect() {
    let messages = messages_of_forty(|k| format!("effect e{k} {{ param p = 1; torque seat: p * t; }} "));
    assert_reports(&messages, 39, "which both declare `p`");
}

#[test]
fn invariant_a_row_that_effects_release_is_reported_once_for_each_effect() {
    let messages = messages_of_forty(|k| format!("effect e{k} {{ release rear; }} "));
    assert_reports(&messages, 39, "which both release `rear`");
}

#[test]
fn invariant_a_second_stop_is_reported_once_for_all_scenes() {
    let messages = messages_of_forty(|k| {
        let stops = "stop s1: seat.x to 3; stop s2: seat.y to 3; ";
        if k == 0 { format!("{stops}effect e0 {{ }} ") } else { format!("effect e{k} {{ }} ") }
    });
    // the message and its second place
    assert_eq!(messages.len(), 2, "{messages:#?}");
    assert!(messages[0].contains("two stops, `s1` and `s2`"), "{messages:#?}");
}

/// A message for each declaration but the first, and the first place behind it, which rustc prints once.
#[test]
fn invariant_effects_of_one_name_are_reported_once_for_each_declaration() {
    let effects = "effect same { param p = 1; torque seat: p * t; } ".repeat(40);
    let scenes: String = (0..40).map(|k| format!("scene s{k} {{ start begin; until 1 s; with same; }} ")).collect();
    let (_, messages) = resolve(&format!("{BEFORE}{effects}{scenes}{BEHIND}"));
    let of = |text: &str| messages.iter().filter(|message| message.contains(text)).cloned().collect::<BTreeSet<_>>();
    let (twice, first) = (of("`same` is declared twice"), of("`same` is first declared here"));
    assert_eq!((twice.len(), first.len(), messages.len()), (39, 1, 78), "{messages:#?}");
}
