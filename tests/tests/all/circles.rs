//! What a file uses does not use the file: no circles between files and folders that stand beside each other.
//!
//! A folder counts as one with everything in it; a file that declares the files of a folder is no part of their circles.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Each crate has more files than this: fewer are found when its folder has moved.
const FEWEST_FILES: usize = 25;

/// The names of a module and those around it, from the root of the crate.
pub type Module = Vec<String>;

#[test]
fn invariant_files_of_the_macro_have_no_circles() {
    check("ezy-derive/src");
}

#[test]
fn invariant_files_of_the_core_have_no_circles() {
    check("ezy-core/src");
}

#[test]
fn invariant_files_of_studies_have_no_circles() {
    check("ezy-study/src");
}

#[test]
fn invariant_files_of_the_command_line_have_no_circles() {
    check("ezy-cli/src");
}

#[test]
fn invariant_files_of_the_models_have_no_circles() {
    check("models/src");
}

#[test]
fn invariant_files_of_the_oracles_have_no_circles() {
    check("tests/src");
}

#[test]
fn analytic_circle_is_found_through_exports_and_groups() {
    let texts = [
        (vec![], "mod a; mod b; mod c; pub use b::inner::Thing;"),
        (vec!["a"], "use crate::{Thing, c::{self, Other as Another}};"),
        (vec!["b"], "mod inner;"),
        (vec!["b", "inner"], "pub struct Thing; fn f() -> super::super::a::Result { ::a::g() }"),
        (vec!["c"], "pub struct Other;"),
    ];
    let texts = texts.map(|(module, text)| (module.into_iter().map(str::to_owned).collect(), text.to_owned()));
    assert_eq!(circles(&Crate::new(texts.into())), [(String::new(), vec!["a".to_owned(), "b".to_owned()])]);
}

fn check(source: &str) {
    let texts = modules(source);
    assert!(texts.len() > FEWEST_FILES, "{source} has {} files", texts.len());
    let found = circles(&Crate::new(texts));
    assert!(found.is_empty(), "{source}: files that use each other: {found:?}");
}

/// The texts of a crate by module, without comments and tests.
pub fn modules(source: &str) -> BTreeMap<Module, String> {
    let mut texts = BTreeMap::new();
    read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(source), &Module::new(), &mut texts);
    texts
}

fn read(folder: &Path, module: &Module, texts: &mut BTreeMap<Module, String>) {
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        let name = entry.file_stem().unwrap().to_str().unwrap().to_owned();
        let inside = [module.as_slice(), std::slice::from_ref(&name)].concat();
        if entry.is_dir() {
            read(&entry, &inside, texts);
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&entry).unwrap();
            let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
            let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
            let code = code.collect::<Vec<_>>().join("\n");
            texts.insert(if ["lib", "mod"].contains(&name.as_str()) { module.clone() } else { inside }, code);
        }
    }
}

/// Takes out the modules that are compiled for tests alone.
pub fn remove_tests(texts: &mut BTreeMap<Module, String>) {
    let is_test = |module: &Module| {
        (0..module.len()).any(|n| {
            // `#[cfg(test)]` or `#[cfg(all(test, …))]`
            let declared = format!("]\nmod {};", module[n]);
            let before = texts.get(&module[..n]).and_then(|text| text.split_once(&declared));
            let attribute = before.and_then(|(before, _)| before.lines().last());
            attribute.is_some_and(|line| line.starts_with("#[cfg(test)") || line.starts_with("#[cfg(all(test,"))
        })
    };
    let tests: Vec<Module> = texts.keys().filter(|module| is_test(module)).cloned().collect();
    texts.retain(|module, _| !tests.contains(module));
}

struct Crate {
    texts: BTreeMap<Module, String>,
    /// What modules hand on, by name.
    exports: BTreeMap<Module, BTreeMap<String, Vec<String>>>,
}

impl Crate {
    fn new(mut texts: BTreeMap<Module, String>) -> Self {
        remove_tests(&mut texts);
        let mut exports: BTreeMap<Module, BTreeMap<String, Vec<String>>> = BTreeMap::new();
        for (module, text) in &mut texts {
            let (exported, rest) = split_exports(text);
            let named = paths(&exported).into_iter().map(|path| (path.last().unwrap().clone(), path));
            exports.insert(module.clone(), named.collect());
            *text = rest;
        }
        Self { texts, exports }
    }

    /// The module that a path leads to; `None` out of the crate.
    fn module(&self, from: &Module, path: &[String]) -> Option<Module> {
        let (mut at, mut rest) = (from.clone(), path);
        match path[0].as_str() {
            "crate" => (at, rest) = (Module::new(), &path[1..]),
            "self" => rest = &path[1..],
            "super" => {}
            first if self.texts.contains_key(&[from.as_slice(), &[first.to_owned()]].concat()) => {}
            _ => return None,
        }
        while rest.first().is_some_and(|name| name == "super") {
            at.pop();
            rest = &rest[1..];
        }
        while let Some(name) = rest.first() {
            let inside = [at.as_slice(), std::slice::from_ref(name)].concat();
            if !self.texts.contains_key(&inside) {
                let export = self.exports.get(&at).and_then(|exports| exports.get(name));
                return export.and_then(|path| self.module(&at, path)).or(Some(at));
            }
            (at, rest) = (inside, &rest[1..]);
        }
        Some(at)
    }
}

/// The texts of `pub use …;`, and what is left.
fn split_exports(text: &str) -> (String, String) {
    let (mut exported, mut rest) = (String::new(), String::new());
    for statement in text.split_inclusive(';') {
        let begin = statement.find("pub use ").or_else(|| statement.find("pub(crate) use "));
        let begin = begin.or_else(|| statement.find("pub(super) use ")).unwrap_or(statement.len());
        rest += &statement[..begin];
        exported += &statement[begin..];
    }
    (exported, rest)
}

/// Every path of two names or more that does not begin with `::`; groups count with each of their members.
pub fn paths(text: &str) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let first = rest.chars().next().unwrap();
        let behind = text[..at].chars().next_back();
        let begins = is_word(first) && behind.is_none_or(|c| !is_word(c) && c != ':');
        at += if begins { path(rest, &[], &mut found) } else { first.len_utf8() };
    }
    found
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Reads a path behind another one, or a group of them; says how long it is.
fn path(text: &str, before: &[String], found: &mut Vec<Vec<String>>) -> usize {
    if text.starts_with('{') {
        let mut at = 1;
        while at < text.len() && !text[at..].starts_with('}') {
            let first = text[at..].chars().next().unwrap();
            let begins = is_word(first) && !text[..at].ends_with(is_word);
            at += if begins { path(&text[at..], before, found) } else { first.len_utf8() };
        }
        return at + 1;
    }
    let length = text.find(|c| !is_word(c)).unwrap_or(text.len());
    let so_far = [before, &[text[..length].to_owned()]].concat();
    match text[length..].strip_prefix("::") {
        Some(rest) if rest.starts_with(|c| is_word(c) || c == '{') => length + 2 + path(rest, &so_far, found),
        _ => {
            found.extend(Some(so_far).filter(|path| path.len() > 1));
            length
        }
    }
}

/// Files and folders that stand beside each other and use each other, with the folder that they stand in.
fn circles(all: &Crate) -> Vec<(String, Vec<String>)> {
    let mut uses: BTreeMap<Module, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
    for (module, text) in &all.texts {
        for used in paths(text).iter().filter_map(|path| all.module(module, path)) {
            let common = module.iter().zip(&used).take_while(|(a, b)| a == b).count();
            if let (Some(one), Some(other)) = (module.get(common), used.get(common)) {
                let beside = uses.entry(module[..common].to_vec()).or_default();
                beside.entry(one.clone()).or_default().insert(other.clone());
            }
        }
    }
    let mut circles = Vec::new();
    for (folder, uses) in &uses {
        let mut seen = BTreeSet::new();
        for name in uses.keys() {
            let circle: Vec<String> = reached(uses, name)
                .into_iter()
                .filter(|other| other != name && reached(uses, other).contains(name))
                .collect();
            if !circle.is_empty() && seen.insert(name.clone()) {
                let mut circle = [circle, vec![name.clone()]].concat();
                circle.sort();
                seen.extend(circle.iter().cloned());
                circles.push((folder.join("/"), circle));
            }
        }
    }
    circles
}

/// What a file uses, and what that uses.
fn reached(uses: &BTreeMap<String, BTreeSet<String>>, from: &str) -> BTreeSet<String> {
    let mut reached = BTreeSet::new();
    let mut open = vec![from.to_owned()];
    while let Some(name) = open.pop() {
        for next in uses.get(&name).into_iter().flatten() {
            if reached.insert(next.clone()) {
                open.push(next.clone());
            }
        }
    }
    reached
}
