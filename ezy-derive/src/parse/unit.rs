//! Units: products, quotients and whole powers of names, such as `kg*m^2` or `N*s/m`.

use super::ast::{Unit, UnitFactor};
use super::token::{end, expected, name, parenthesised, take, take_one_of};
use crate::units::{self, Spelling};
use proc_macro2::{Delimiter, Span};
use syn::parse::ParseStream;
use syn::{Lit, LitInt, Result, Token};

/// Beyond it no unit is meant, and products of exponents stay far from overflow.
const MAX_EXPONENT: i32 = 12;
/// Brackets in brackets: `(N/(m*s))^2`.
const MAX_BRACKETS: usize = 2;

/// The unit between `:` and `=`, or none before `=`.
pub fn optional_unit(input: ParseStream) -> Result<Option<Unit>> {
    if take::<Token![:]>(input) {
        unit(input).map(Some)
    } else if input.peek(Token![=]) {
        Ok(None)
    } else {
        Err(expected(input, "`:` or `=`"))
    }
}

pub fn unit(input: ParseStream) -> Result<Unit> {
    let mut unit = Unit { text: String::new(), factors: Vec::new() };
    product(input, 1, 0, &mut unit)?;
    Ok(unit)
}

/// The unit behind a number in an expression, and its last token: `30 deg`, `5 m/s^2`, `5 (N*m)`. It goes on behind `*` and `/` as long as names
/// of units follow; in an expression `t` is the time.
pub fn of_number(input: ParseStream) -> Result<Option<(Unit, Span)>> {
    let mut unit = Unit { text: String::new(), factors: Vec::new() };
    if input.peek(syn::token::Paren) {
        let brackets = parenthesised(input)?;
        product(&brackets.inside, 1, 1, &mut unit)?;
        end(&brackets.inside, ")")?;
        unit.text = format!("({})", unit.text);
        return Ok(Some((unit, brackets.close)));
    }
    if !begins_unit(input) {
        return Ok(None);
    }
    power(input, 1, MAX_BRACKETS, &mut unit)?;
    loop {
        let behind_sign = input.fork();
        let sign = take_one_of(&behind_sign, &[('*', ('*', 1)), ('/', ('/', -1))]);
        let Some(((sign, exponent), _)) = sign.filter(|_| begins_unit(&behind_sign)) else { break };
        take_one_of(input, &[('*', ()), ('/', ())]);
        unit.text.push(sign);
        power(input, exponent, MAX_BRACKETS, &mut unit)?;
    }
    let end = unit.factors.last().map_or_else(Span::call_site, |factor| factor.name.span());
    Ok(Some((unit, end)))
}

/// Whether the name of a unit follows, and not of something else.
fn begins_unit(input: ParseStream) -> bool {
    let Some((name, behind)) = input.cursor().ident() else { return false };
    let is_value = behind.punct().is_some_and(|(sign, _)| sign.as_char() == '.')
        || behind.group(Delimiter::Parenthesis).is_some()
        || behind.group(Delimiter::Bracket).is_some();
    let name = name.to_string();
    name != "t" && units::is_known(&name) && !is_value
}

fn product(input: ParseStream, exponent: i32, depth: usize, unit: &mut Unit) -> Result<()> {
    power(input, exponent, depth, unit)?;
    while let Some(((sign, exponent), _)) = take_one_of(input, &[('*', ('*', exponent)), ('/', ('/', -exponent))]) {
        unit.text.push(sign);
        power(input, exponent, depth, unit)?;
    }
    Ok(())
}

fn power(input: ParseStream, exponent: i32, depth: usize, unit: &mut Unit) -> Result<()> {
    if input.peek(LitInt) && input.fork().parse::<LitInt>().is_ok_and(|one| one.to_string() == "1") {
        input.parse::<LitInt>()?;
        unit.text.push('1');
        return Ok(());
    }
    let first = unit.factors.len();
    if input.peek(syn::token::Paren) && depth < MAX_BRACKETS {
        let brackets = parenthesised(input)?;
        unit.text.push('(');
        product(&brackets.inside, exponent, depth + 1, unit)?;
        unit.text.push(')');
        end(&brackets.inside, ")")?;
    } else {
        let name = name(input, "a unit")?;
        unit.text.push_str(&name.to_string());
        unit.factors.push(UnitFactor { name, exponent });
    }
    if take::<Token![^]>(input) {
        unit.text.push('^');
        let power = whole_number(input, unit)?;
        unit.factors[first..].iter_mut().for_each(|factor| factor.exponent *= power);
    }
    Ok(())
}

fn whole_number(input: ParseStream, unit: &mut Unit) -> Result<i32> {
    let at = input.fork();
    let negative = take::<Token![-]>(input);
    if negative {
        unit.text.push('-');
    }
    let literal = input.parse::<LitInt>().ok().filter(|literal| literal.suffix().is_empty());
    let digits = literal.and_then(|literal| literal.base10_parse::<i32>().ok());
    match digits.filter(|digits| (1..=MAX_EXPONENT).contains(digits)) {
        Some(digits) => {
            unit.text.push_str(&digits.to_string());
            Ok(if negative { -digits } else { digits })
        }
        None => Err(expected(&at, "a whole exponent")),
    }
}

/// A unit behind a number, where none can stand, or that is none of the language.
pub struct Misplaced {
    pub at: Span,
    /// As written.
    pub written: String,
    /// In units of the language.
    pub unit: String,
    /// The number in these units.
    pub value: String,
}

/// The unit behind a value that is one number with or without a sign.
pub fn behind_value(input: ParseStream) -> Option<Misplaced> {
    let value = input.fork();
    let sign = value.parse::<Option<Token![-]>>().ok()?.map_or("", |_| "-");
    let digits = match value.parse().ok()? {
        Lit::Int(number) => number.base10_digits().to_owned(),
        Lit::Float(number) => number.base10_digits().to_owned(),
        _ => return None,
    };
    behind(&format!("{sign}{digits}"), &value)
}

/// The unit that follows a number, if one does.
pub fn behind(number: &str, input: ParseStream) -> Option<Misplaced> {
    let (first, _) = input.cursor().ident()?;
    let name = first.to_string();
    let instead = units::spelling(&name);
    if !units::is_known(&name) && instead.is_none() {
        return None;
    }
    let whole = unit(&input.fork()).ok();
    let whole = whole.filter(|unit| unit.factors.iter().all(|factor| units::is_known(&factor.name.to_string())));
    let written = whole.map_or(name, |unit| unit.text);
    let (unit, value) = match instead {
        Some(Spelling { unit, is }) => (unit, is.map_or(number.to_owned(), |is| format!("{number}*{is}"))),
        None => (written.clone(), number.to_owned()),
    };
    Some(Misplaced { at: first.span(), written, unit, value })
}
