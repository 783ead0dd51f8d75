//! The `model!` macro of EZY.

mod diag;
mod emit;
mod faulty;
mod function;
#[cfg(test)]
mod fuzz;
#[cfg(test)]
mod growth;
mod mechanics;
mod model;
mod parse;
mod pipeline;
#[cfg(test)]
mod random;
mod symbolic;
mod units;
mod words;
mod work;

/// Turns a model file into equations of motion.
#[proc_macro]
pub fn model(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    pipeline::expand(input.into()).into()
}
