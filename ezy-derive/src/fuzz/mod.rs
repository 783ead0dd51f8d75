//! Random texts: none may panic or hang; each becomes items or errors.

mod grammar;
mod long_run;
mod mutate;
mod texts;
mod trial;
mod values;

use proc_macro2::TokenStream;
use std::str::FromStr;

use crate::pipeline::expand;
use crate::random::Random;
use texts::Texts;
use trial::Verdict;

/// Random texts of every `cargo test`; `long_run` takes as many as one likes.
const N_TEXTS: u64 = 400;
/// Their seed.
const SEED: u64 = 20;
/// Random models without mistakes.
const N_MODELS: u64 = 20;

#[test]
fn invariant_random_texts_give_a_model_or_an_error() {
    let texts = Texts::new();
    let mut n_models = 0;
    for i in 0..N_TEXTS {
        let text = texts.text(SEED, i);
        match trial::verdict(&text, true) {
            Ok(verdict) => n_models += u64::from(verdict == Verdict::Model),
            Err(fault) => panic!("text {i}: {fault}\n{text}"),
        }
    }
    assert!(0 < n_models && n_models < N_TEXTS, "the texts are neither all right nor all wrong: {n_models}");
}

#[test]
fn invariant_most_random_models_without_mistakes_are_accepted() {
    let accepted =
        |seed: &u64| trial::verdict(&grammar::model("Random", &mut Random::new(*seed)), true) == Ok(Verdict::Model);
    let n_models = (0..N_MODELS).filter(accepted).count() as u64;
    assert!(4 * n_models > N_MODELS, "{n_models} of {N_MODELS}");
}

#[test]
fn invariant_other_constructs_are_a_model() {
    for text in texts::GOOD {
        let items = expand_text(text);
        assert!(!is_error(&items), "{items}");
    }
}

#[test]
fn invariant_deep_brackets_and_signs_end_in_an_error() {
    for (open, close) in [("(", ")"), ("-", ""), ("sin(", ")"), ("2^", ""), ("1 - (2 * ", ")"), ("a[", "]")] {
        let value = format!("{}1{}", open.repeat(2000), close.repeat(2000));
        let items = expand_text(&format!("pub model M {{ param a = {value}; }}"));
        assert!(items.to_string().contains(" more than "), "{items}");
    }
}

#[test]
fn invariant_deepest_expressions_are_a_model() {
    for (open, close, n) in [("(", ")", 49), ("-", "", 390), ("sin(", ")", 49), ("1.01^", "", 190), ("1 + ", "", 190)] {
        let value = format!("{}(2 * seat.x){}", open.repeat(n), close.repeat(n));
        assert!(!is_error(&expand_text(&with_torque("", &value))), "{open}");
    }
}

/// Lifetimes that no Rust program has are tokens all the same.
#[test]
fn regress_keywords_as_lifetimes_are_an_error() {
    for items in
        ["param p: kg/'as^2 = 7;", "'as", "body b { 'fn: 1 }", "scene s { until 0.1 'as; }", "for i in 0..'in {}"]
    {
        let verdict = trial::verdict(&format!("pub model Random {{ {items} }}"), true);
        assert_eq!(verdict, Ok(trial::Verdict::Refused), "{items}");
    }
}

#[test]
fn invariant_values_of_values_are_a_model_or_an_error() {
    let lets: String = (1..9).map(|i| format!("let a{i} = a{} + sin(a{});", i - 1, i - 1)).collect();
    assert!(!is_error(&expand_text(&with_torque(&format!("let a0 = 2 * seat.x; {lets}"), "a8"))));
    let reverse: String = (0..2000).map(|i| format!("let a{i} = 1 + a{};", i + 1)).collect();
    assert!(expand_text(&with_torque(&reverse, "1")).to_string().contains("long chain of values"));
}

fn with_torque(items: &str, value: &str) -> String {
    format!(
        "pub model M {{ body seat {{ mass: 1, inertia: 1 }} {items} torque seat: {value};
         start s {{ }} scene c {{ start s; until 1 s; }} }}"
    )
}

fn expand_text(text: &str) -> TokenStream {
    expand(TokenStream::from_str(text).expect("the text consists of Rust tokens"))
}

fn is_error(items: &TokenStream) -> bool {
    items.to_string().contains("compile_error")
}
