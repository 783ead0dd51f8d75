//! The messages in the guide and in the reference of the language are those of the macro, and the reference has every word.
//!
//! A block of `text` with lines that begin with `error:` or `warning:` shows messages. Lines above it are wrong lines: each stands in the last
//! model of the page in place of the first line that begins with the same words. `UPDATE_GOLDEN=1 cargo test -p ezy-derive` writes the messages anew,
//! and the reference as the documentation of `model!` shows it.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use quote::ToTokens;

use crate::expansions::texts;
use crate::golden;
use crate::parse::words_of_the_language;
use crate::pipeline::expand;

fn file(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)
}

/// The reference of the language.
fn reference() -> PathBuf {
    file("docs/language.md")
}

fn pages() -> BTreeMap<PathBuf, String> {
    let entries = fs::read_dir(file("docs/guide/src")).expect("the guide is there");
    let pages = entries.map(|entry| entry.expect("an entry").path()).chain([reference()]);
    let pages = pages.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    pages.map(|path| (path.clone(), fs::read_to_string(path).expect("a page can be read"))).collect()
}

/// The errors of a model, as rustc shows their text; of a warning the text alone.
fn messages(model: &str) -> String {
    let tokens = model.parse().expect("the model has tokens");
    let model = texts(tokens).pop().expect("a block with a model");
    let items: syn::File = syn::parse2(expand(model)).expect("the expansion is Rust");
    let mut messages = Vec::new();
    for item in &items.items {
        match item {
            syn::Item::Macro(item)
                if item.mac.path.segments.last().is_some_and(|last| last.ident == "compile_error") =>
            {
                let text: syn::LitStr = item.mac.parse_body().expect("the text of an error");
                messages.push(format!("error: {}", text.value().replace('\n', "\n       ")));
            }
            syn::Item::Const(item) => messages.extend(warning(item)),
            _ => {}
        }
    }
    messages.join("\n\n")
}

/// The note of the deprecated constant by which the macro warns.
fn warning(item: &syn::ItemConst) -> Option<String> {
    let text = item.expr.to_token_stream().to_string();
    let note = text.split_once("deprecated (note = ")?.1.split_once(")]")?.0;
    let note: syn::LitStr = syn::parse_str(note).ok()?;
    Some(format!("warning: {}", note.value()))
}

/// Words that begin a line, up to its first sign.
fn beginning(line: &str) -> Vec<&str> {
    let signs = |letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == ' ');
    line.trim().split(signs).next().unwrap_or_default().split(' ').filter(|word| !word.is_empty()).collect()
}

/// The model with a wrong line in place of the first whose beginning is most alike.
fn with_wrong_line(model: &str, wrong: &str) -> String {
    let words = beginning(wrong);
    let alike = |line: &str| beginning(line).iter().zip(&words).take_while(|(a, b)| a == b).count();
    let most = model.lines().map(alike).max().unwrap_or_default();
    assert!(most > 0, "`{wrong}` begins as no line of\n{model}");
    let replaced = model.lines().find(|line| alike(line) == most).unwrap_or_default();
    model.replacen(replaced, wrong, 1)
}

fn is_message(line: &str) -> bool {
    ["error:", "warning:"].iter().any(|kind| line.starts_with(kind))
}

/// The page with the messages that its models have now.
fn with_messages(page: &str) -> String {
    let mut model = "";
    let mut new = String::new();
    for (i, part) in page.split("```").enumerate() {
        new += if i == 0 { "" } else { "```" };
        let body = part.split_once('\n').map_or("", |(_, body)| body);
        let first = body.split_inclusive('\n').take_while(|line| !is_message(line)).map(str::len).sum::<usize>();
        let shown = Some(first).filter(|at| *at < body.len());
        match (i % 2 == 1, shown) {
            (true, _) if part.starts_with("rust") => {
                model = if body.contains("model! {") { body } else { model };
                new += part;
            }
            (true, Some(at)) if part.starts_with("text\n") => {
                let wrong = &body[..at];
                let whole = wrong.lines().fold(model.to_owned(), |model, line| with_wrong_line(&model, line));
                let messages = messages(&whole);
                assert!(!messages.is_empty(), "there is nothing wrong about\n{whole}");
                new += &format!("text\n{wrong}{messages}\n");
            }
            _ => new += part,
        }
    }
    new
}

/// The reference in the documentation of `model!`: without its title, and without pictures and links to other pages, which are not there.
fn for_rustdoc(page: &str) -> String {
    let (_, body) = page.split_once("\n\n").expect("a title");
    let is_picture = |paragraph: &&str| paragraph.starts_with("![");
    let body = body.split("\n\n").filter(|paragraph| !is_picture(paragraph)).collect::<Vec<_>>().join("\n\n");
    let mut new = String::new();
    for part in body.replace("```rust,ignore", "```rust").split_inclusive(')') {
        match part.rsplit_once("](") {
            // of a link to a page its text stays, with the name of the page
            Some((before, target)) if target.contains(".md") => {
                let (path, _) = target.split_once(['#', ')']).unwrap_or((target, ""));
                new += before;
                new.remove(new.rfind('[').expect("a link begins"));
                new += &format!(" (`docs/{path}`)");
            }
            _ => new += part,
        }
    }
    new
}

#[test]
fn regress_messages_of_the_guide_are_those_of_the_macro() {
    let mut now: BTreeMap<_, _> = pages().into_iter().map(|(path, page)| (path, with_messages(&page))).collect();
    now.insert(file("ezy-core/src/language.md"), for_rustdoc(&now[&reference()]));
    golden::compare_all(&now);
}

#[test]
fn invariant_documentation_of_the_macro_links_within_itself() {
    let page = "# T\n\nSee [a](#a), [`b` (c)](b.md#c).\n\n![P](p.svg)\n\n```rust,ignore\nlink[0](1, 0)\n```\n";
    assert_eq!(for_rustdoc(page), "See [a](#a), `b` (c) (`docs/b.md`).\n\n```rust\nlink[0](1, 0)\n```\n");
}

/// Each word has a heading, an equation, an example that uses it, and a wrong line that begins with it.
#[test]
fn reference_page_of_the_language_has_every_word() {
    let page = &pages()[&reference()];
    let sections: BTreeMap<&str, &str> =
        page.split("\n### `").skip(1).filter_map(|section| section.split_once("`\n")).collect();
    for word in words_of_the_language() {
        let section = sections.get(word).unwrap_or_else(|| panic!("the reference has no section of `{word}`"));
        let section = section.split("\n## ").next().unwrap_or_default();
        let begins = |line: &str| beginning(line).join(" ").starts_with(word);
        let block =
            |kind: &str| section.split(kind).nth(1).and_then(|rest| rest.split("```").next()).unwrap_or_default();
        assert!(section.contains("\n> "), "`{word}` has no equation");
        assert!(block("```rust,ignore\n").lines().any(begins), "the example of `{word}` does not use it");
        let wrong = block("```text\n");
        assert!(wrong.lines().next().is_some_and(begins) && wrong.contains("\nerror: "), "`{word}` has no wrong line");
    }
}

#[test]
fn invariant_wrong_line_takes_the_place_of_the_one_that_begins_alike() {
    let model = "param a = 1;\nparam b = 2;\nforce at c(0, 0): 1;";
    assert_eq!(with_wrong_line(model, "param b: m = 3;"), "param a = 1;\nparam b: m = 3;\nforce at c(0, 0): 1;");
    assert_eq!(with_wrong_line(model, "force 3;"), "param a = 1;\nparam b = 2;\nforce 3;");
}
