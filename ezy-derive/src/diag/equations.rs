//! Messages about equations that cannot hold together.

use super::fault_with_help;
use super::nearest::quoted;
use proc_macro2::Ident;

pub fn restricts_nothing(at: &Ident, row: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("row `{row}` restricts no motion: no velocity appears in it"),
        "remove it, or attach it to a body that moves",
    )
}

pub fn dependent(at: &Ident, row: &str, others: &[&str]) -> syn::Error {
    fault_with_help(
        at,
        format_args!(
            "row `{row}` repeats what {} already demand{}",
            quoted(others),
            if others.len() == 1 { "s" } else { "" }
        ),
        "remove one of these rows: for any parameters they restrict the same motion",
    )
}

pub fn too_many_rows(at: &Ident, n_rows: usize, n_coordinates: usize) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{at}` has {n_rows} constraint rows but only {n_coordinates} coordinates"),
        "remove rows until the model can move, or add bodies",
    )
}
