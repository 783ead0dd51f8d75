//! Messages about counts, arrays and `for`.

use super::nearest::quoted;
use super::{Extent, fault_with_help};
use proc_macro2::Ident;

messages! {
    too_many_loops(at: &Ident, limit: usize):
        "this `for` stands in {limit} others", "compute with fewer indices";

    index_shadows(variable: &Ident, what: &str):
        "the index `{variable}` has the name of {what}",
        "write another name, such as `{variable}1`";

    not_an_index(at: Extent):
        "this is no index",
        "write whole numbers, counts and indices of `for`, with `+`, `-`, `*`, and `/` by a number above zero";

    /// `what`: "an array of bodies".
    without_index(name: &Ident, what: &str):
        "`{name}` is {what}", "write one of its members, such as `{name}[0]`";

    index_on_single(at: Extent, name: &Ident, what: &str):
        "`{name}` is {what}, not an array",
        "write `{name}` without an index, or declare an array, such as `body link[n] {{ … }}`";

    no_index(name: &Ident, instead: &str):
        "parameter `{name}` is not declared, and the members of this array have no index",
        "where members differ, write `{instead}`";

    length_unknown(name: &Ident, array: &Ident, count: &str):
        "`{name}` is no count",
        "write a whole number or a count; where `{name}` shall be an index: `for {name} in 0..{count} {{ body {array}[{name}] {{ … }} }}`";

    array_from(at: Extent, array: &Ident, index: &Ident):
        "the members of `{array}` are counted from 0",
        "write `0` here, and `{index}+1` where a number from 1 on is meant";

    length_by_index(at: Extent, array: &Ident):
        "the number of members of `{array}` depends on an index",
        "write a whole number or a count: each row of an array has as many members as the others";

    name_with_index(at: Extent, name: &Ident):
        "`{name}` is declared with an index, but stands in no `for`",
        "write `{name}`, or put the declaration into `for i in 0..n {{ … }}`";
}

pub fn count_not_whole(at: Extent, name: &Ident, value: f64) -> syn::Error {
    let nearest = if value.is_finite() { value.round().clamp(1.0, 1e6) } else { 1.0 };
    fault_with_help(
        at,
        format_args!("count `{name}` is {value}"),
        format_args!("write a whole number from 1 on, such as `{nearest}`"),
    )
}

pub fn unknown_index(name: &Ident, known: &[String]) -> syn::Error {
    let help = match known {
        [] => "write a whole number, or `count name = …;` and its name".to_owned(),
        known => format!("counts and indices here: {}", quoted(known)),
    };
    fault_with_help(name, format_args!("`{name}` is neither a count nor the index of a `for` around"), help)
}

pub fn number_of_indices(at: Extent, name: &Ident, wanted: usize, found: usize) -> syn::Error {
    let plural = if wanted == 1 { "index" } else { "indices" };
    fault_with_help(
        at,
        format_args!("`{name}` has {wanted} {plural}, but {found} {} given", if found == 1 { "is" } else { "are" }),
        format_args!("write `{name}[{}]`", ["i", "i, j", "i, j, k", "i, j, k, l"][wanted.clamp(1, 4) - 1]),
    )
}

/// `index`: the value that is out of range; `lengths`: the declared sizes.
pub fn out_of_range(at: Extent, name: &Ident, index: i64, length: i64, counts: &str) -> syn::Error {
    let range = match length {
        1 => "`0`".to_owned(),
        _ => format!("`0` to `{}`", length - 1),
    };
    let with = if counts.is_empty() { String::new() } else { format!(" with {counts}") };
    fault_with_help(
        at,
        format_args!("this index of `{name}` becomes {index}"),
        format_args!("its indices go from {range}{with}; change the index or the range of the `for`"),
    )
}

pub fn out_of_declared_range(at: Extent, name: &Ident, index: i64, from: i64, to: i64) -> syn::Error {
    fault_with_help(
        at,
        format_args!("this index of `{name}` becomes {index}"),
        format_args!("`{name}` is declared in a `for` from {from} to {}; change the index or that range", to - 1),
    )
}

/// A name declared in a `for` carries the indices of the `for`.
pub fn name_needs_indices(at: Extent, name: &Ident, variables: &[String]) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{name}` is declared once for each `{}`", variables.join("`, `")),
        format_args!("write `{name}[{}]`", variables.join(", ")),
    )
}

pub fn no_value(at: Extent, name: &Ident, members: &[&str]) -> syn::Error {
    let help = match members.first() {
        Some(first) => format!("write a member, such as `{name}[…].{first}`"),
        None => "write a parameter or a number".to_owned(),
    };
    fault_with_help(at, format_args!("a member of `{name}` is no value"), help)
}
