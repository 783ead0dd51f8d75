//! The `model!` macro of EZY.

/// Turns a model file into equations of motion.
#[proc_macro]
pub fn model(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let _ = input;
    proc_macro::TokenStream::new()
}
