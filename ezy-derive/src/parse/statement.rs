//! Rows and forces: read by the form that the table of keywords gives.

use super::ast::{Expr, ItemKind, Name, Phrase, Statement};
use super::expression::{expression, indexed};
use super::place::{on_body, place};
use super::token::{expected, peek_word, sign, take, word};
use crate::diag::syntax;
use crate::grammar::{Beginning, IfAbsent, Part, Setting, WORDS, Word};
use proc_macro2::{Delimiter, Ident};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Result, Token};

const BODY: &str = "the name of a body";

/// What follows the word, which is `keyword`.
pub fn statement(input: ParseStream, word: &'static Word, keyword: Ident) -> Result<ItemKind> {
    let name = if word.is_row() { row_name(input, word)? } else { None };
    let mut phrases = Vec::new();
    parts(input, word.form, word, &mut phrases)?;
    if !take::<Token![;]>(input) {
        let ends_with_settings = matches!(word.form.last(), Some(Part::Settings(_)));
        if let (false, Some((setting, _))) = (ends_with_settings, input.cursor().ident()) {
            return Err(syntax::no_setting_behind(&setting, &place_of(word)));
        }
        return Err(expected(input, if ends_with_settings { "`,` or `;`" } else { "`;`" }));
    }
    Ok(ItemKind::Statement(Statement { word, keyword, name, phrases }))
}

fn row_name(input: ParseStream, word: &Word) -> Result<Option<Name>> {
    let named = input.cursor().ident().is_some_and(|(_, rest)| {
        let behind = rest.group(Delimiter::Bracket).map_or(rest, |(_, _, rest)| rest);
        behind.punct().is_some_and(|(p, _)| p.as_char() == ':')
    });
    if !named && word.may_be_unnamed() {
        return Ok(None);
    }
    let name = indexed(input, &format!("the name of the {}", word.word))?;
    sign::<Token![:]>(input)?;
    Ok(Some(name))
}

fn parts(input: ParseStream, form: &'static [Part], word: &Word, phrases: &mut Vec<Phrase>) -> Result<()> {
    form.iter().try_for_each(|part| self::part(input, part, word, phrases))
}

fn part(input: ParseStream, part: &'static Part, of: &Word, phrases: &mut Vec<Phrase>) -> Result<()> {
    phrases.push(match part {
        Part::Colon => return sign::<Token![:]>(input).map(|_| ()),
        Part::Equals => return sign::<Token![=]>(input).map(|_| ()),
        Part::Choice(forms) => return parts(input, choice(input, forms)?, of, phrases),
        Part::Pair => pair(input)?,
        Part::At => at(input)?,
        Part::Couple => couple(input)?,
        Part::BodyOrCouple => body_or_couple(input)?,
        Part::Along => direction(input, "along")?,
        Part::Across => direction(input, "across")?,
        Part::Scalar(expected) => Phrase::Scalar(*expected, expression(input)?),
        Part::Vector(expected) => Phrase::Vector(*expected, expression(input)?),
        Part::Equation => equation(input)?,
        Part::Settings(known) => settings(input, known, of)?,
    });
    Ok(())
}

/// The first form whose beginning fits.
fn choice(input: ParseStream, forms: &[&'static [Part]]) -> Result<&'static [Part]> {
    let fits = |form: &&&'static [Part]| form.first().is_none_or(|part| begins(input, part.beginning()));
    forms.iter().find(fits).copied().ok_or_else(|| {
        let beginnings = forms.iter().filter_map(|form| form.first()).map(|part| match part.beginning() {
            Beginning::Word(word) => format!("`{word}`"),
            Beginning::Sign(sign) => format!("`{sign}`"),
            Beginning::Name => BODY.to_owned(),
        });
        expected(input, &alternatives(&beginnings.collect::<Vec<_>>()))
    })
}

fn begins(input: ParseStream, beginning: Beginning) -> bool {
    match beginning {
        Beginning::Word(word) => peek_word(input, word),
        Beginning::Sign(sign) => input.cursor().punct().is_some_and(|(found, _)| found.as_char() == sign),
        Beginning::Name => input.peek(Ident::peek_any),
    }
}

fn alternatives(words: &[String]) -> String {
    match words {
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => words.concat(),
    }
}

fn pair(input: ParseStream) -> Result<Phrase> {
    let a = place(input)?;
    sign::<Token![~]>(input)?;
    Ok(Phrase::Pair(Box::new([a, place(input)?])))
}

fn at(input: ParseStream) -> Result<Phrase> {
    word(input, "at")?;
    place(input).map(Phrase::At)
}

fn couple(input: ParseStream) -> Result<Phrase> {
    let a = indexed(input, BODY)?;
    sign::<Token![~]>(input)?;
    Ok(Phrase::Couple(a, indexed(input, BODY)?))
}

fn body_or_couple(input: ParseStream) -> Result<Phrase> {
    let a = indexed(input, BODY)?;
    if take::<Token![~]>(input) {
        return Ok(Phrase::Couple(a, indexed(input, BODY)?));
    }
    if input.peek(Token![:]) { Ok(Phrase::Body(a)) } else { Err(expected(input, "`~` or `:`")) }
}

fn direction(input: ParseStream, keyword: &str) -> Result<Phrase> {
    word(input, keyword)?;
    let direction = on_body(input, "a direction `body(x, y)`")?;
    Ok(Phrase::Direction { across: keyword == "across", direction })
}

fn equation(input: ParseStream) -> Result<Phrase> {
    let left = expression(input)?;
    let equals = sign::<Token![=]>(input)?.span;
    Ok(Phrase::Equation { left, equals, right: expression(input)? })
}

/// `word value, word value`, each at most once, in any order.
fn settings(input: ParseStream, known: &'static [Setting], statement: &Word) -> Result<Phrase> {
    let mut given: Vec<Option<(Ident, Expr)>> = known.iter().map(|_| None).collect();
    let names: Vec<&str> = known.iter().map(|setting| setting.word).collect();
    while !input.peek(Token![;]) {
        let Some((found, _)) = input.cursor().ident() else { return Err(no_word(input, known, statement, &names)) };
        let Some(i) = names.iter().position(|name| found == name) else {
            let needs_none = statement.is_row() && known.iter().all(|setting| setting.if_absent != IfAbsent::Required);
            let may_have_ended = needs_none && given.iter().all(Option::is_none);
            return Err(match WORDS.iter().any(|another| found == another.word) {
                true if may_have_ended => syntax::no_end(&found, statement.word),
                _ => syntax::unknown_word(&found, &place_of(statement), &names),
            });
        };
        let word = input.call(Ident::parse_any)?;
        if let Some((first, _)) = &given[i] {
            return Err(syntax::field_twice(&word, first));
        }
        let value = expression(input).map_err(|error| with_setting(error, statement, names[i], &names))?;
        given[i] = Some((word, value));
        let another = input.cursor().ident().is_some_and(|(word, _)| names.iter().any(|name| word == name));
        if !take::<Token![,]>(input) && !another {
            break;
        }
    }
    let given: Vec<Option<Expr>> = given.into_iter().map(|given| given.map(|(_, value)| value)).collect();
    check_settings(input, known, &given, statement, &names)?;
    Ok(Phrase::Settings(known, given))
}

/// In a message.
fn place_of(statement: &Word) -> String {
    format!("a {}", statement.word)
}

/// Something that is no word stands where a setting could begin.
fn no_word(input: ParseStream, known: &[Setting], statement: &Word, names: &[&str]) -> syn::Error {
    let required = known.iter().any(|setting| setting.if_absent == IfAbsent::Required);
    let end = (!required).then_some(";");
    let words: Vec<String> = names.iter().copied().chain(end).map(|word| format!("`{word}`")).collect();
    let error = expected(input, &alternatives(&words));
    if required { error } else { with_setting(error, statement, names[0], names) }
}

/// `error` with the way a setting is written, where the example of the word leaves it out.
fn with_setting(error: syn::Error, statement: &Word, setting: &str, names: &[&str]) -> syn::Error {
    let example = statement.example.trim_end_matches(';');
    let shows = |name: &str| example.split(' ').any(|word| word == name);
    if shows(setting) {
        return error;
    }
    let comma = if names.iter().any(|name| shows(name)) { "," } else { "" };
    syntax::with_example(error, statement.word, &format!("{example}{comma} {setting} …;"))
}

/// What is required is there; of settings that can all be left out a force needs one.
fn check_settings(
    input: ParseStream,
    known: &[Setting],
    given: &[Option<Expr>],
    statement: &Word,
    names: &[&str],
) -> Result<()> {
    let needs_one = !statement.is_row() && given.iter().all(Option::is_none);
    if needs_one && known.iter().all(|setting| setting.if_absent == IfAbsent::Absent) {
        return Err(syntax::no_setting(input.span(), &place_of(statement), names));
    }
    let missing =
        |(setting, value): &(&Setting, &Option<Expr>)| setting.if_absent == IfAbsent::Required && value.is_none();
    match known.iter().zip(given).find(missing) {
        Some((missing, _)) => Err(syntax::setting_missing(input.span(), missing.word, &place_of(statement))),
        None => Ok(()),
    }
}
