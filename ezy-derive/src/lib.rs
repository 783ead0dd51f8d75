//! The `model!` macro of EZY.

mod diag;
mod emit;
#[cfg(test)]
mod expansions;
mod faulty;
mod function;
#[cfg(test)]
mod fuzz;
#[cfg(test)]
mod golden;
mod grammar;
#[cfg(test)]
mod growth;
#[cfg(test)]
mod guide;
mod mechanics;
mod model;
mod parse;
mod pipeline;
#[cfg(test)]
mod random;
mod symbolic;
mod units;
mod work;

/// Turns a model file into equations of motion.
///
/// For `ezy_core::model!` alone, which writes `$crate` before the model: the path of `ezy-core`, whatever its name is where the
/// model stands.
#[doc(hidden)]
#[proc_macro]
pub fn model(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    pipeline::expand(input.into()).into()
}
