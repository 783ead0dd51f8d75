//! `for i in a..b { … }`, around items and in starts.

use super::Log;
use super::ast::Loop;
use super::expression::expression;
use super::token::{braced, name, sign, word};
use crate::diag::{repeats, syntax};
use syn::parse::ParseStream;
use syn::{Result, Token};

/// Deepest nesting of `for`, which bounds the recursion of the parser.
const MAX_LOOPS: usize = 4;

const EXAMPLE: &str = "for i in 1..n { hinge pin[i]: link[i-1](l, 0) ~ link[i](0, 0); }";

/// Reads a `for` inside of `outer`: `inside` reads what stands in its braces, with this `for` as the innermost one.
pub fn repeated(
    input: ParseStream,
    outer: &[Loop],
    log: &mut Log,
    inside: impl FnOnce(ParseStream, &[Loop], &mut Log) -> Result<()>,
) -> Result<()> {
    let keyword = word(input, "for")?;
    if outer.len() == MAX_LOOPS {
        return Err(repeats::too_many_loops(&keyword, MAX_LOOPS));
    }
    let range = head(input).map_err(|error| syntax::with_example(error, "for", EXAMPLE))?;
    let braces = braced(input)?;
    log.loops.push((range.clone(), outer.to_vec()));
    inside(&braces.inside, &[outer, &[range]].concat(), log)
}

fn head(input: ParseStream) -> Result<Loop> {
    let variable = name(input, "the name of the index")?;
    word(input, "in")?;
    let from = expression(input)?;
    sign::<Token![..]>(input)?;
    if input.peek(Token![=]) {
        return Err(syntax::end_of_range(input.span()));
    }
    let to = expression(input)?;
    Ok(Loop { variable, from, to })
}
