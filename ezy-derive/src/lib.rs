//! The `model!` macro of EZY.

mod diag;
mod model;
mod parse;

/// Turns a model file into equations of motion.
#[proc_macro]
pub fn model(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let mut diag = diag::Diagnostics::default();
    let ast = parse::parse(input.into(), &mut diag);
    model::resolve(ast, &mut diag);
    diag.into_compile_errors().into()
}
