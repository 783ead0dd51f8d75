//! Rows and forces: read by the form that the table of keywords gives.

use super::ast::{ItemKind, Name, Phrase, Statement};
use super::expression::{expression, indexed};
use super::place::{on_body, place};
use super::token::{expected, peek_word, sign, word};
use crate::diag::syntax;
use crate::grammar::{IfAbsent, Part, Setting, Word};
use proc_macro2::{Delimiter, Ident};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Result, Token};

/// What follows the word, which is `keyword`.
pub fn statement(input: ParseStream, word: &'static Word, keyword: Ident) -> Result<ItemKind> {
    let name = if word.is_row() { row_name(input, word)? } else { None };
    let mut statement = Statement { word, keyword, name, phrases: Vec::new() };
    parts(input, word.form, &mut statement)?;
    if !input.peek(Token![;]) {
        return Err(expected(input, &ending(word.form)));
    }
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Statement(statement))
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

fn parts(input: ParseStream, form: &'static [Part], statement: &mut Statement) -> Result<()> {
    for part in form {
        self::part(input, part, statement)?;
    }
    Ok(())
}

fn part(input: ParseStream, part: &'static Part, statement: &mut Statement) -> Result<()> {
    let phrase = match part {
        Part::Pair => {
            let a = place(input)?;
            sign::<Token![~]>(input)?;
            Phrase::Pair(Box::new([a, place(input)?]))
        }
        Part::At => {
            word(input, "at")?;
            Phrase::At(place(input)?)
        }
        Part::Couple => {
            let a = indexed(input, "the name of a body")?;
            sign::<Token![~]>(input)?;
            Phrase::Couple(a, indexed(input, "the name of a body")?)
        }
        Part::BodyOrCouple => {
            let a = indexed(input, "the name of a body")?;
            if input.peek(Token![~]) {
                sign::<Token![~]>(input)?;
                Phrase::Couple(a, indexed(input, "the name of a body")?)
            } else if input.peek(Token![:]) {
                Phrase::Body(a)
            } else {
                return Err(expected(input, "`~` or `:`"));
            }
        }
        Part::Along | Part::Across => {
            let across = matches!(part, Part::Across);
            word(input, if across { "across" } else { "along" })?;
            Phrase::Direction { across, direction: on_body(input, "a direction `body(x, y)`")? }
        }
        Part::Scalar(asked) => {
            sign::<Token![:]>(input)?;
            Phrase::Scalar(*asked, expression(input)?)
        }
        Part::Equals(asked) => {
            sign::<Token![=]>(input)?;
            Phrase::Scalar(*asked, expression(input)?)
        }
        Part::Vector(asked) => {
            sign::<Token![:]>(input)?;
            Phrase::Vector(*asked, expression(input)?)
        }
        Part::BareVector(asked) => Phrase::Vector(*asked, expression(input)?),
        Part::Equation => {
            let left = expression(input)?;
            let equals = sign::<Token![=]>(input)?.span;
            Phrase::Equation { left, equals, right: expression(input)? }
        }
        Part::Settings(known) => settings(input, known, statement.word)?,
        Part::Colon => return sign::<Token![:]>(input).map(|_| ()),
        Part::Choice(forms) => {
            let Some(form) = forms.iter().find(|form| begins(input, form)) else {
                let beginnings: Vec<&str> = forms.iter().filter_map(|form| form.first().map(beginning)).collect();
                return Err(expected(input, &alternatives(&beginnings)));
            };
            return parts(input, form, statement);
        }
    };
    statement.phrases.push(phrase);
    Ok(())
}

fn begins(input: ParseStream, form: &[Part]) -> bool {
    match form.first() {
        Some(Part::At) => peek_word(input, "at"),
        Some(Part::Along) => peek_word(input, "along"),
        Some(Part::Across) => peek_word(input, "across"),
        Some(Part::Scalar(_) | Part::Vector(_) | Part::Colon) => input.peek(Token![:]),
        Some(_) => input.peek(Ident::peek_any),
        None => true,
    }
}

/// How a part begins, for messages.
fn beginning(part: &Part) -> &'static str {
    match part {
        Part::At => "`at`",
        Part::Along => "`along`",
        Part::Across => "`across`",
        Part::Scalar(_) | Part::Vector(_) | Part::Colon => "`:`",
        Part::Equals(_) => "`=`",
        _ => "the name of a body",
    }
}

fn alternatives<S: AsRef<str>>(beginnings: &[S]) -> String {
    let words: Vec<&str> = beginnings.iter().map(AsRef::as_ref).collect();
    match words.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, first)) => format!("{} or {last}", first.join(", ")),
        None => String::new(),
    }
}

/// What may still come at the end of a statement.
fn ending(form: &[Part]) -> String {
    match form.last() {
        Some(Part::Settings(_)) => "`,` or `;`".to_owned(),
        _ => "`;`".to_owned(),
    }
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

/// `word value, word value`, each at most once, in any order.
fn settings(input: ParseStream, known: &'static [Setting], statement: &Word) -> Result<Phrase> {
    let mut given: Vec<Option<super::ast::Expr>> = known.iter().map(|_| None).collect();
    let mut words: Vec<Option<Ident>> = known.iter().map(|_| None).collect();
    let place = || format!("a {}", statement.word);
    let names: Vec<&str> = known.iter().map(|setting| setting.word).collect();
    while !input.peek(Token![;]) {
        let Some((found, _)) = input.cursor().ident() else {
            let required = known.iter().any(|setting| setting.if_absent == IfAbsent::Required);
            let end = (!required).then(|| "`;`".to_owned());
            let words: Vec<String> = names.iter().map(|name| format!("`{name}`")).chain(end).collect();
            let error = expected(input, &alternatives(&words));
            return Err(if required { error } else { with_setting(error, statement, names[0], &names) });
        };
        let Some(i) = names.iter().position(|name| found == name) else {
            return Err(syntax::unknown_word(&found, &place(), &names));
        };
        let word = input.call(Ident::parse_any)?;
        if let Some(first) = &words[i] {
            return Err(syntax::field_twice(&word, first));
        }
        let value = expression(input).map_err(|error| with_setting(error, statement, names[i], &names));
        given[i] = Some(value?);
        words[i] = Some(word);
        let another = input.cursor().ident().is_some_and(|(word, _)| names.iter().any(|name| word == name));
        if input.peek(Token![,]) {
            input.parse::<Token![,]>()?;
        } else if !another {
            break;
        }
    }
    // a row is one without settings, too
    let needs_one = !statement.is_row() && given.iter().all(Option::is_none);
    if needs_one && known.iter().all(|setting| setting.if_absent == IfAbsent::Absent) {
        return Err(syntax::no_setting(input.span(), &place(), &names));
    }
    match known.iter().zip(&given).find(|(setting, value)| setting.if_absent == IfAbsent::Required && value.is_none()) {
        Some((missing, _)) => Err(syntax::setting_missing(input.span(), missing.word, &place())),
        None => Ok(Phrase::Settings(known, given)),
    }
}
