//! The walks of ARCHITECTURE.md lead through the code: what a step names is defined in its file, and one step leads to the next.
//!
//! A step is written "1. `file`, `function` and `Type::function`: text". The function named first is called in the step before. Where that is
//! not so, the page says what is:
//!
//! - "(called in step 2)": an earlier step calls it.
//! - "(as `Trait::function`)": it is called under this name: it implements the trait, or is called by who does.
//! - a type beside the functions (`Type`): the step before hands on a value of this type, and calls nothing.
//!
//! Everything else that a step puts in backquotes stands in its file.

use crate::architecture::{paths, root};
use crate::circles::modules;
use std::fs;

/// What a reader has in mind at once.
const MOST_FILES_OF_A_WALK: usize = 5;
/// The walk that follows what is written into files; the steps of the other ones call each other.
const WALK_OF_DATA: &str = "A hinge's length, from text to force";

#[test]
fn invariant_walks_of_the_architecture_page_are_those_of_the_code() {
    let page = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let walks = page.split_once("## Three walks").expect("the page has walks").1;
    let walks: Vec<(&str, &str)> = walks.split("\n### ").skip(1).filter_map(|walk| walk.split_once('\n')).collect();
    assert_eq!(walks.len(), 3);
    assert!(walks.iter().any(|(title, _)| *title == WALK_OF_DATA));
    for (title, walk) in walks {
        let files = paths(walk);
        assert!((2..=MOST_FILES_OF_A_WALK).contains(&files.len()), "`{title}` goes through {files:?}");
        let steps = steps(walk);
        assert_eq!(steps.len(), files.len(), "each step of `{title}` opens one file");
        for step in &steps {
            step.check_names().unwrap_or_else(|fault| panic!("`{title}`, `{}`: {fault}", step.file));
        }
        for i in 1..steps.len() {
            if title != WALK_OF_DATA {
                check_link(&steps, i).unwrap_or_else(|fault| panic!("`{title}`, step {}: {fault}", i + 1));
            }
        }
    }
}

#[test]
fn analytic_wrong_steps_are_found() {
    let step = |head: &str, text: &str| Step { text: text.to_owned(), ..Step::new(head) };
    let caller =
        || step("`a.rs`, `Loop::run`: text", "impl Loop {\n    fn run(&self) {\n        advance(1);\n    }\n}");
    assert_eq!(caller().check_names(), Ok(()));
    for head in ["`a.rs`, `run`, `Other::run`: text", "`a.rs`, `walk`: text", "`a.rs`, `Loop::run`: `retreat`"] {
        assert!(step(head, &caller().text).check_names().is_err(), "{head}");
    }
    for (callee, is_called) in [("advance", true), ("run", false), ("vance", false)] {
        let next = step(&format!("`b.rs`, `{callee}`: text"), &format!("fn {callee}(n: u8) {{\n}}"));
        assert_eq!(check_link(&[caller(), next], 1).is_ok(), is_called, "{callee}");
    }
    for (taken, is_taken) in [("&Order", true), ("&OrderOf", false)] {
        let first = step("`a.rs`, `Order`: text", "struct Order;");
        let next = step("`b.rs`, `make`: text", &format!("fn make(order: {taken}) {{\n}}"));
        assert_eq!(check_link(&[first, next], 1).is_ok(), is_taken, "{taken}");
    }
}

struct Step {
    file: String,
    /// The file without comments that are lines of their own, where it is Rust.
    text: String,
    functions: Vec<String>,
    /// The value that the step hands on.
    handed_on: Option<String>,
    /// The name that the step before calls in place of the first function.
    called_as: Option<String>,
    /// The step that calls the first function, where it is not the one before.
    called_in: Option<usize>,
    /// What else stands in backquotes.
    quoted: Vec<String>,
}

fn steps(walk: &str) -> Vec<Step> {
    let mut steps: Vec<String> = Vec::new();
    for line in walk.lines().map(str::trim).filter(|line| !line.is_empty()) {
        match line.split_once(". ") {
            Some((number, rest)) if number.parse::<usize>().is_ok() => steps.push(rest.to_owned()),
            _ => steps.last_mut().expect("a walk begins with its first step").extend([" ", line]),
        }
    }
    let read = |step: Step| {
        let text = fs::read_to_string(root().join(&step.file)).unwrap_or_else(|_| panic!("`{}` is no file", step.file));
        let is_rust = step.file.ends_with(".rs");
        let lines = text.lines().filter(|line| !is_rust || !line.trim_start().starts_with("//"));
        Step { text: lines.collect::<Vec<_>>().join("\n"), ..step }
    };
    steps.iter().map(|step| read(Step::new(step))).collect()
}

impl Step {
    /// From what the page says, without its number; the file is not read yet.
    fn new(step: &str) -> Self {
        let (head, text) = step.split_once(": ").expect("a step says where it is, then what happens there");
        let (head, called_as) = match head.split_once("(as `") {
            Some((head, rest)) => (head, rest.split('`').next().map(str::to_owned)),
            None => (head, None),
        };
        let called_in =
            head.split_once("(called in step ").and_then(|(_, rest)| rest.trim_end_matches(')').parse().ok());
        let (file, names) = backquoted(head).split_first().map(|(file, names)| (file.clone(), names.to_vec())).unwrap();
        let (types, functions) =
            names.into_iter().partition::<Vec<_>, _>(|name| last(name).starts_with(char::is_uppercase));
        assert!(types.len() <= 1, "a step hands on one value, not {types:?}");
        let handed_on = types.into_iter().next();
        Self { file, text: String::new(), functions, handed_on, called_as, called_in, quoted: backquoted(text) }
    }

    /// The named functions as they are defined in the file.
    fn defined(&self) -> impl Iterator<Item = Function> {
        self.functions.iter().flat_map(|name| functions(&self.text, name))
    }

    fn check_names(&self) -> Result<(), String> {
        if let Some(name) = self.functions.iter().find(|name| functions(&self.text, name).is_empty()) {
            return Err(format!("the function `{name}` is not defined there"));
        }
        if let Some(name) = &self.handed_on {
            let is_defined =
                ["struct", "enum", "trait"].iter().any(|kind| self.text.contains(&format!("{kind} {name} ")));
            if !is_defined
                && !self.text.contains(&format!("struct {name};"))
                && !self.defined().any(|f| f.mentions(name))
            {
                return Err(format!("nothing there hands on `{name}`"));
            }
        }
        if let Some(quoted) = self.quoted.iter().find(|quoted| !self.text.contains(last(quoted))) {
            return Err(format!("`{quoted}` does not stand there"));
        }
        Ok(())
    }
}

/// Whether an earlier step leads to step `i`, counted from 0.
fn check_link(steps: &[Step], i: usize) -> Result<(), String> {
    let step = &steps[i];
    let callee = step.functions.first().ok_or("no function is named")?;
    let before = &steps[step.called_in.map_or(i - 1, |number| number - 1)];
    if let Some(value) = &before.handed_on {
        let is_taken = functions(&step.text, callee).iter().any(|function| function.mentions(value));
        return is_taken.then_some(()).ok_or_else(|| format!("`{callee}` takes no `{value}`"));
    }
    let called = step.called_as.as_ref().unwrap_or(callee);
    if !before.defined().any(|function| function.calls(called)) {
        return Err(format!("`{called}` is not called by {:?}", before.functions));
    }
    let Some(between) = &step.called_as else { return Ok(()) };
    let implements = |function: Function| {
        let a_trait = between.split_once("::").map_or("", |(a_trait, _)| a_trait);
        words(&function.around, a_trait).any(|rest| rest.contains(" for "))
    };
    if last(between) == last(callee) && functions(&step.text, callee).into_iter().any(implements) {
        return Ok(());
    }
    let source = &step.file[..step.file.find("/src/").ok_or("the file is in no crate")? + "/src".len()];
    let mut found = modules(source).into_values().flat_map(|text| functions(&text, between));
    let leads = |function: Function| {
        function.calls(callee) && callee.split_once("::").is_none_or(|(of, _)| function.mentions(of))
    };
    found.any(leads).then_some(()).ok_or_else(|| format!("no `{between}` calls `{callee}`"))
}

struct Function {
    /// The line `impl …` or `trait …` around it, empty for a free function.
    around: String,
    signature: String,
    body: String,
}

impl Function {
    fn mentions(&self, name: &str) -> bool {
        [&self.around, &self.signature, &self.body].iter().any(|text| words(text, name).next().is_some())
    }

    fn calls(&self, name: &str) -> bool {
        words(&self.body, last(name)).any(|rest| rest.starts_with('('))
    }
}

/// The functions of this name; of `Type::name`, those in an `impl` or a `trait` with that word. The text is laid out by rustfmt: what begins
/// with a line ends at the next `}` that stands in the same column.
fn functions(text: &str, name: &str) -> Vec<Function> {
    let (of, begin) = (name.rsplit_once("::").map(|(of, _)| of), format!("fn {}", last(name)));
    let (mut found, mut around) = (Vec::new(), String::new());
    let mut is_open = false;
    for (i, line) in text.lines().enumerate() {
        let indent = line.len() - line.trim_start().len();
        if indent == 0 && (line.starts_with("impl") || words(line, "trait").next().is_some()) {
            (around, is_open) = (String::new(), true);
        }
        if is_open {
            around += line;
            is_open = !line.ends_with('{');
        } else if line == "}" {
            around.clear();
        }
        let is_named = line.split_once(&begin).is_some_and(|(_, rest)| rest.starts_with(['(', '<']));
        if !is_named || of.is_some_and(|of| words(&around, of).next().is_none()) {
            continue;
        }
        let end = format!("{}}}", &line[..indent]);
        let rest: Vec<&str> = text.lines().skip(i).collect();
        let n = if line.ends_with('}') {
            1
        } else {
            rest.iter().position(|line| *line == end).map_or(rest.len(), |n| n + 1)
        };
        if let Some((signature, body)) = rest[..n].join("\n").split_once('{')
            && !signature.contains(";\n")
        {
            found.push(Function { around: around.clone(), signature: signature.to_owned(), body: body.to_owned() });
        }
    }
    found
}

/// What follows each place where this word stands in the text.
fn words<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let places = text.match_indices(word).map(move |(at, _)| (&text[..at], &text[at + word.len()..]));
    places.filter(move |(before, rest)| !before.ends_with(is_word) && !rest.starts_with(is_word)).map(|(_, rest)| rest)
}

fn last(name: &str) -> &str {
    name.rsplit("::").next().unwrap_or(name)
}

fn backquoted(text: &str) -> Vec<String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned).collect()
}
