//! From text to model, and to messages.

mod good;
mod messages;

use super::Model;
use crate::diag::Diagnostics;

/// The EzyRoller, with every construct of the language that its study needs.
pub const EZY_ROLLER: &str = include_str!("ezy_roller.txt");

/// The model of a text, and its messages as `line:column text`.
fn resolve(text: &str) -> (Option<Model>, Vec<String>) {
    let tokens = text.parse().expect("the text consists of Rust tokens");
    let mut diag = Diagnostics::default();
    let ast = crate::parse::parse(tokens, &mut diag);
    let model = super::resolve(ast, &mut diag);
    (model, diag.listing())
}

/// The model of a text without faults.
fn good(text: &str) -> Model {
    let (model, messages) = resolve(text);
    assert!(messages.is_empty(), "{messages:#?}");
    model.expect("a text without faults is a model")
}
