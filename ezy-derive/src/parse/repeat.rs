//! `count n = 100;` and the head of `for i in a..b { … }`

use super::Log;
use super::ast::{Count, ItemKind, Loop};
use super::expression::expression;
use super::token::{name, sign, word};
use crate::diag::{repeats, syntax};
use syn::parse::ParseStream;
use syn::{Result, Token};

/// Deepest nesting of `for`, which bounds the recursion of the parser.
const MAX_LOOPS: usize = 4;

pub const FOR_EXAMPLE: &str = "for i in 1..n { hinge pin[i]: link[i-1](l, 0) ~ link[i](0, 0); }";

pub fn count(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the count")?;
    sign::<Token![=]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Count(Count { name, value }))
}

/// `for i in a..b`, inside `outer`.
pub fn range(input: ParseStream, outer: &[Loop]) -> Result<Loop> {
    let keyword = word(input, "for")?;
    if outer.len() == MAX_LOOPS {
        return Err(repeats::too_many_loops(&keyword, MAX_LOOPS));
    }
    head(input).map_err(|error| syntax::with_example(error, "for", FOR_EXAMPLE))
}

fn head(input: ParseStream) -> Result<Loop> {
    let variable = name(input, "the name of the index")?;
    word(input, "in")?;
    let from = expression(input)?;
    sign::<Token![..]>(input)?;
    let to = expression(input)?;
    Ok(Loop { variable, from, to })
}
