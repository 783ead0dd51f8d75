//! `param name: unit = value;`, `param name = value;`, and the same for `input`

use super::Log;
use super::ast::{ItemKind, Parameter};
use super::expression::expression;
use super::token::{name, sign, written};
use super::unit::{self, Misplaced, optional_unit};
use crate::diag::syntax;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn parameter(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    declaration(input, "param", "the name of the parameter").map(ItemKind::Parameter)
}

pub fn input(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    declaration(input, "input", "the name of the input").map(ItemKind::Input)
}

fn declaration(input: ParseStream, keyword: &str, what: &str) -> Result<Parameter> {
    let name = name(input, what)?;
    let unit = optional_unit(input)?;
    sign::<Token![=]>(input)?;
    if let Some(Misplaced { at, written, unit, value }) = unit::behind_value(input) {
        return Err(syntax::value_with_unit(at, keyword, &name, &written, &unit, &value));
    }
    let begin = input.cursor();
    let value = expression(input)?;
    let value_text = written(begin, input);
    sign::<Token![;]>(input)?;
    Ok(Parameter { name, unit, value, value_text })
}
