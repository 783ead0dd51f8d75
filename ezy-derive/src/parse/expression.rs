//! Expressions, by recursive descent: `+ -` bind weakest, then `* /`, then the sign, then `^` (to the right).

use super::ast::{Expr, Name};
use super::token::{
    Bracketed, comma_or_end, end, end_of_pair, expected, found, is_rust_keyword, name, parenthesised, peek_number,
    peek_word, take, take_one_of, written,
};
use super::unit::{self, Misplaced};
use crate::diag::elsewhere::{self, meaning};
use crate::diag::{names, syntax};
use crate::function::{FUNCTIONS, Operator};
use crate::units;
use proc_macro2::{Ident, Span};
use syn::parse::ParseStream;
use syn::{Lit, Result, Token};

/// Keeps the recursion over an expression, here and in all later stages, far from the end of the stack.
const MAX_PARTS: usize = 400;
/// The same for brackets in brackets, each of which takes several calls.
const MAX_BRACKETS: usize = 50;

/// A scalar or a vector.
pub fn expression(input: ParseStream) -> Result<Expr> {
    Parser::default().sum(input)
}

/// A scalar with a unit behind it.
pub fn expression_before_unit(input: ParseStream) -> Result<Expr> {
    Parser { before_unit: true, ..Parser::default() }.sum(input)
}

/// A name, with or without indices.
pub fn indexed(input: ParseStream, what: &str) -> Result<Name> {
    Parser::default().indexed(input, what)
}

#[derive(Default)]
struct Parser {
    parts: usize,
    /// How many brackets are open.
    brackets: usize,
    /// Whether a unit may stand behind a number.
    before_unit: bool,
}

impl Parser {
    fn count(&mut self, at: Span) -> Result<()> {
        self.parts += 1;
        if self.parts > MAX_PARTS { Err(syntax::expression_too_large(at, MAX_PARTS)) } else { Ok(()) }
    }

    fn sum(&mut self, input: ParseStream) -> Result<Expr> {
        let mut left = self.product(input)?;
        while let Some((operator, span)) = take_one_of(input, &[('+', Operator::Add), ('-', Operator::Subtract)]) {
            self.count(span)?;
            left = binary(operator, span, left, self.product(input)?);
        }
        Ok(left)
    }

    fn product(&mut self, input: ParseStream) -> Result<Expr> {
        let mut left = self.signed(input)?;
        while let Some((operator, span)) = take_one_of(input, &[('*', Operator::Multiply), ('/', Operator::Divide)]) {
            if operator == Operator::Multiply && input.peek(Token![*]) {
                return Err(syntax::power_of_other_languages(input.span()));
            }
            self.count(span)?;
            left = binary(operator, span, left, self.signed(input)?);
        }
        Ok(left)
    }

    fn signed(&mut self, input: ParseStream) -> Result<Expr> {
        let Some(((), sign)) = take_one_of(input, &[('-', ())]) else { return self.power(input) };
        self.count(sign)?;
        Ok(Expr::Negative { sign, operand: Box::new(self.signed(input)?) })
    }

    fn power(&mut self, input: ParseStream) -> Result<Expr> {
        let base = self.primary(input)?;
        match take_one_of(input, &[('^', Operator::Power)]) {
            Some((operator, span)) => Ok(binary(operator, span, base, self.signed(input)?)),
            None => Ok(base),
        }
    }

    fn primary(&mut self, input: ParseStream) -> Result<Expr> {
        self.count(input.span())?;
        if peek_number(input) {
            return self.number(input);
        }
        if input.peek(syn::token::Paren) {
            return self.in_brackets(input, Self::group);
        }
        if let Some((word, _)) = input.cursor().ident().filter(|(word, _)| is_rust_keyword(&word.to_string())) {
            let text = word.to_string();
            if ["if", "match"].contains(&text.as_str()) {
                return Err(syntax::no_conditions(word.span(), &found(input)));
            }
            // functions of other languages whose names Rust reserves, such as `mod`
            if meaning(elsewhere::FUNCTIONS, &text).is_some() {
                return Err(names::unknown_function(&word));
            }
        }
        if input.peek(Token![=]) {
            return Err(syntax::equals_for_value(input.span()));
        }
        let owner = self.indexed(input, "a value")?;
        if input.peek(syn::token::Paren) && owner.indices.is_empty() {
            let function = owner.word;
            return self.in_brackets(input, |parser, brackets| {
                let arguments = parser.arguments(&brackets.inside)?;
                Ok(Expr::Call { function, arguments, end: brackets.close })
            });
        }
        if is_function(&owner.word) && owner.indices.is_empty() && begins_value(input) {
            return Err(syntax::function_without_brackets(&owner.word));
        }
        if peek_dot(input) {
            input.parse::<Token![.]>()?;
            let member = name(input, "the name of a member")?;
            if peek_dot(input) {
                input.parse::<Token![.]>()?;
                return Err(member_of_member(&owner.word, &member, &name(input, "the name of a member")?));
            }
            return Ok(Expr::Member { owner: Box::new(owner), member });
        }
        Ok(if owner.indices.is_empty() { Expr::Name(owner.word) } else { Expr::Indexed(Box::new(owner)) })
    }

    fn indexed(&mut self, input: ParseStream, what: &str) -> Result<Name> {
        let begin = input.cursor();
        let word = name(input, what)?;
        let mut indexed = Name { text: word.to_string(), end: word.span(), word, indices: Vec::new() };
        if !input.peek(syn::token::Bracket) {
            return Ok(indexed);
        }
        let inside;
        let brackets = syn::bracketed!(inside in input).span;
        if self.brackets == MAX_BRACKETS {
            return Err(syntax::brackets_too_deep(brackets.open(), MAX_BRACKETS));
        }
        self.brackets += 1;
        indexed.indices.push(self.sum(&inside)?);
        while take::<Token![,]>(&inside) {
            indexed.indices.push(self.sum(&inside)?);
        }
        self.brackets -= 1;
        end(&inside, "]")?;
        indexed.end = brackets.close();
        indexed.text = written(begin, input);
        Ok(indexed)
    }

    fn in_brackets(
        &mut self,
        input: ParseStream,
        parse: impl FnOnce(&mut Self, &Bracketed) -> Result<Expr>,
    ) -> Result<Expr> {
        let brackets = parenthesised(input)?;
        if self.brackets == MAX_BRACKETS {
            return Err(syntax::brackets_too_deep(brackets.open, MAX_BRACKETS));
        }
        self.brackets += 1;
        let result = parse(self, &brackets);
        self.brackets -= 1;
        result
    }

    /// `(e)` or the vector `(x, y)`.
    fn group(&mut self, brackets: &Bracketed) -> Result<Expr> {
        let inside = &brackets.inside;
        let x = self.sum(inside)?;
        if inside.is_empty() {
            return Ok(x);
        }
        if !take::<Token![,]>(inside) {
            return Err(expected(inside, "`)`"));
        }
        let y = self.sum(inside)?;
        end_of_pair(inside)?;
        Ok(Expr::Vector { x: Box::new(x), y: Box::new(y), start: brackets.open, end: brackets.close })
    }

    fn arguments(&mut self, inside: ParseStream) -> Result<Vec<Expr>> {
        let mut arguments = Vec::new();
        while !inside.is_empty() {
            arguments.push(self.sum(inside)?);
            comma_or_end(inside, ")")?;
        }
        Ok(arguments)
    }

    fn number(&self, input: ParseStream) -> Result<Expr> {
        let literal: Lit = input.parse()?;
        let (digits, suffix) = match &literal {
            Lit::Int(literal) => (literal.base10_digits(), literal.suffix()),
            Lit::Float(literal) => (literal.base10_digits(), literal.suffix()),
            _ => return Err(syntax::expected(literal.span(), "a number", "another literal")),
        };
        let span = literal.span();
        if !suffix.is_empty() {
            return Err(match self.before_unit {
                true => syntax::number_joined_with_unit(span, digits, suffix),
                false if suffix != "t" && units::is_known(suffix) => {
                    syntax::number_joined_with_unit(span, digits, suffix)
                }
                false if is_suffix_of_rust(suffix) => syntax::number_with_suffix(span, digits, suffix, digits),
                false => syntax::number_with_suffix(span, digits, suffix, &format!("{digits} * {suffix}")),
            });
        }
        // the decimal digits as written: the nearest f64
        let value = match digits.parse::<f64>() {
            Ok(value) if value.is_finite() => value,
            _ => return Err(syntax::number_too_large(span, digits)),
        };
        if self.before_unit {
            return Ok(Expr::Number { value, span });
        }
        if let Some(factor) = factor(input) {
            return Err(syntax::product_without_sign(input.span(), digits, &factor));
        }
        if let Some((unit, end)) = unit::of_number(input)? {
            return Ok(Expr::Quantity { value, unit, start: span, end });
        }
        // `t` is the time in expressions, and no tonne
        match unit::behind(digits, input).filter(|_| !peek_word(input, "t")) {
            Some(Misplaced { at, written, unit, value }) => Err(syntax::other_unit(at, &written, &unit, &value)),
            None => Ok(Expr::Number { value, span }),
        }
    }
}

fn is_function(name: &Ident) -> bool {
    FUNCTIONS.iter().any(|function| name == function)
}

/// Whether a name or a number follows.
fn begins_value(input: ParseStream) -> bool {
    input.cursor().ident().is_some() || peek_number(input)
}

fn peek_dot(input: ParseStream) -> bool {
    input.peek(Token![.]) && !input.peek(Token![..])
}

/// What follows a number and is meant as a factor of it: the time, a call, a member, or brackets around what is no unit.
fn factor(input: ParseStream) -> Option<String> {
    let is_factor = match input.cursor().ident() {
        Some((name, _)) if name == "t" || is_function(&name) => true,
        Some((_, behind)) => behind.punct().is_some_and(|(sign, _)| sign.as_char() == '.'),
        None => input.peek(syn::token::Paren) && unit::of_number(&input.fork()).is_err(),
    };
    is_factor.then(|| found(input))
}

fn member_of_member(owner: &Ident, member: &Ident, second: &Ident) -> syn::Error {
    let written = format!("{owner}.{member}");
    let instead = match (member.to_string().as_str(), second.to_string().as_str()) {
        ("v" | "velocity", "x" | "y") => format!("write `{owner}.v{second}`"),
        ("r" | "position" | "pos", "x" | "y") => format!("write `{owner}.{second}`"),
        _ => match meaning(elsewhere::VALUES, &owner.to_string()) {
            Some(help) => help.to_owned(),
            None => "a name has one member, such as `seat.vx`".to_owned(),
        },
    };
    syntax::member_of_member(second, &written, &instead)
}

/// `f64`, `u8`, `usize`
fn is_suffix_of_rust(suffix: &str) -> bool {
    let bits = suffix.strip_prefix(['f', 'i', 'u']);
    bits.is_some_and(|bits| bits == "size" || bits.parse::<u8>().is_ok())
}

fn binary(operator: Operator, span: Span, left: Expr, right: Expr) -> Expr {
    Expr::Binary { operator, span, left: Box::new(left), right: Box::new(right) }
}
