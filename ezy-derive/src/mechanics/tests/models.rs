//! Some of the random mechanisms as model files, for tests that compile them.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

use super::{Trial, mechanism};
use crate::golden;
use crate::grammar::WORDS;

/// More bodies take longer to compile than to test.
const MOST_BODIES: u64 = 4;
/// Enough to meet every word.
const N_CANDIDATES: u64 = 200;
/// Nearer to singular positions, motion is too fast for the steps of a check.
const LARGEST_CONDITION: f64 = 300.0;

/// Mechanisms that each bring a word which none before them has, until none is left.
fn chosen() -> Vec<Trial> {
    let mut left: BTreeSet<&str> = WORDS.iter().map(|word| word.word).collect();
    let mut chosen = Vec::new();
    for seed in 0..N_CANDIDATES {
        if left.is_empty() {
            break;
        }
        let made = mechanism::mechanism(seed, 1 + (seed % MOST_BODIES) as usize);
        let text = made.text("Random");
        let brought = |word: &str| text.lines().any(|line| line.trim_start().starts_with(&format!("{word} ")));
        if !left.iter().any(|word| brought(word)) {
            continue;
        }
        let tame = |trial: &Trial| trial.kkt(&trial.states()[0]).condition() < LARGEST_CONDITION;
        if let Some(trial) = Trial::new(seed, made).filter(tame) {
            left.retain(|word| !brought(word));
            chosen.push(trial);
        }
    }
    assert!(left.is_empty(), "no mechanism has {left:?}");
    chosen
}

#[test]
fn regress_random_models_are_those_of_the_file() {
    let mut now =
        "//! Random mechanisms as model files, written by `ezy-derive/src/mechanics/tests/models.rs`.\n\n".to_owned();
    now += "// a random row of velocities may integrate to one of positions, which is a warning\n";
    now += "#![allow(missing_docs, deprecated)]\n\nuse ezy_core::model;\nuse ezy_core::model::ModelInfo;\n";
    let mut names = Vec::new();
    for trial in chosen() {
        let text = trial.made.text(&format!("Random{}", trial.seed));
        let text = text.lines().fold(String::new(), |all, line| all + "    " + line + "\n");
        write!(now, "\nmodel! {{\n{text}}}\n").expect("a string takes text");
        names.push(format!("&random{}::MODEL", trial.seed));
    }
    let list = names.join(", ");
    write!(now, "\npub static MODELS: [&ModelInfo; {}] = [{list}];\n", names.len()).expect("a string takes text");

    golden::compare(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/src/random_models.rs"), &now);
}
