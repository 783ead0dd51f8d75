//! Single tokens: what is expected, and what is found instead.

use crate::diag::syntax;
use proc_macro2::{Delimiter, Ident, Span};
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseBuffer, ParseStream};
use syn::{Lit, Result, Token};

/// The next token is none of what the grammar has here.
pub fn expected(input: ParseStream, what: &str) -> syn::Error {
    syntax::expected(input.span(), what, &found(input))
}

/// The next token in words.
pub fn found(input: ParseStream) -> String {
    let cursor = input.cursor();
    if input.is_empty() {
        return "the end".into();
    }
    if let Some((ident, _)) = cursor.ident() {
        return format!("`{ident}`");
    }
    for (delimiter, sign) in [(Delimiter::Parenthesis, "("), (Delimiter::Brace, "{"), (Delimiter::Bracket, "[")] {
        if cursor.group(delimiter).is_some() {
            return format!("`{sign}`");
        }
    }
    match cursor.token_tree() {
        Some((tree, _)) => format!("`{tree}`"),
        None => "the end".into(),
    }
}

/// Skips one token tree; a lifetime counts as one, also one that is a keyword, which `Lifetime` refuses. False at the end.
pub fn skip(input: ParseStream) -> bool {
    let skipped = input.step(|cursor| {
        let lifetime = cursor.lifetime().map(|(_, rest)| rest);
        let rest = lifetime.or_else(|| cursor.token_tree().map(|(_, rest)| rest));
        rest.map(|rest| ((), rest)).ok_or_else(|| cursor.error("the end"))
    });
    skipped.is_ok()
}

/// A name of the user's choice.
pub fn name(input: ParseStream, what: &str) -> Result<Ident> {
    let Some((ident, _)) = input.cursor().ident() else { return Err(expected(input, what)) };
    let text = ident.to_string();
    if text == "_" {
        return Err(expected(input, what));
    }
    if text.starts_with("r#") {
        return Err(syntax::raw_name(ident.span(), &text));
    }
    if is_rust_keyword(&text) {
        return Err(syntax::keyword_as_name(ident.span(), &text));
    }
    input.call(Ident::parse_any)
}

/// Whether Rust 2024 reserves `text`.
pub fn is_rust_keyword(text: &str) -> bool {
    text == "gen" || syn::parse_str::<Ident>(text).is_err()
}

/// Whether the next token is this word. Words are no keywords elsewhere.
pub fn peek_word(input: ParseStream, word: &str) -> bool {
    input.cursor().ident().is_some_and(|(ident, _)| ident == word)
}

/// Takes this word.
pub fn word(input: ParseStream, word: &str) -> Result<Ident> {
    if peek_word(input, word) { input.call(Ident::parse_any) } else { Err(expected(input, &format!("`{word}`"))) }
}

/// Takes this word, if it follows.
pub fn take_word(input: ParseStream, word: &str) -> bool {
    peek_word(input, word) && skip(input)
}

/// Takes this sign, if it follows.
pub fn take<T: Parse + syn::token::Token>(input: ParseStream) -> bool {
    matches!(input.parse::<Option<T>>(), Ok(Some(_)))
}

/// Takes one of these signs, if one follows: what it means, and where it is.
pub fn take_one_of<T: Copy>(input: ParseStream, signs: &[(char, T)]) -> Option<(T, Span)> {
    let (found, _) = input.cursor().punct()?;
    let (_, meaning) = signs.iter().find(|(sign, _)| *sign == found.as_char())?;
    skip(input).then_some((*meaning, found.span()))
}

/// Takes the `,` between the parts of a list, unless this is the end of its brackets.
pub fn comma_or_end(input: ParseStream, closing: &str) -> Result<()> {
    if input.is_empty() || take::<Token![,]>(input) {
        return Ok(());
    }
    Err(expected(input, &format!("`,` or `{closing}`")))
}

/// Skips to behind the next `;`, or to the end.
pub fn skip_statement(input: ParseStream) {
    while !take::<Token![;]>(input) && skip(input) {}
}

/// Takes this sign.
pub fn sign<T: Parse + syn::token::Token>(input: ParseStream) -> Result<T> {
    input.parse::<T>().map_err(|_| expected(input, T::display()))
}

/// Nothing may be left in this pair of brackets.
pub fn end(input: ParseStream, closing: &str) -> Result<()> {
    if input.is_empty() { Ok(()) } else { Err(expected(input, &format!("`{closing}`"))) }
}

/// Nothing may be left behind the second component of a vector.
pub fn end_of_pair(input: ParseStream) -> Result<()> {
    if input.peek(Token![,]) { Err(syntax::third_component(input.span())) } else { end(input, ")") }
}

/// The inside of a pair of brackets, and its first and last sign.
pub struct Bracketed<'a> {
    pub inside: ParseBuffer<'a>,
    pub open: Span,
    pub close: Span,
}

/// Takes `( … )`.
pub fn parenthesised<'a>(input: &'a ParseBuffer<'a>) -> Result<Bracketed<'a>> {
    if !input.peek(syn::token::Paren) {
        return Err(expected(input, "`(`"));
    }
    let inside;
    let token = syn::parenthesized!(inside in input);
    Ok(Bracketed { inside, open: token.span.open(), close: token.span.close() })
}

/// Takes `{ … }`.
pub fn braced<'a>(input: &'a ParseBuffer<'a>) -> Result<Bracketed<'a>> {
    if !input.peek(syn::token::Brace) {
        return Err(expected(input, "`{`"));
    }
    let inside;
    let token = syn::braced!(inside in input);
    Ok(Bracketed { inside, open: token.span.open(), close: token.span.close() })
}

/// What was written from `begin` to here, blanks removed.
pub fn written(begin: Cursor, input: ParseStream) -> String {
    let mut text = String::new();
    let mut cursor = begin;
    while cursor != input.cursor() {
        let Some((tree, rest)) = cursor.token_tree() else { break };
        text.push_str(&tree.to_string());
        cursor = rest;
    }
    text.retain(|sign| !sign.is_whitespace());
    text
}

/// Whether a number follows; a sign before it is an operator.
pub fn peek_number(input: ParseStream) -> bool {
    input.cursor().literal().is_some() && matches!(input.fork().parse(), Ok(Lit::Int(_) | Lit::Float(_)))
}
