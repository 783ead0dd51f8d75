//! No type of `ezy-core/src/dynamics` has more methods than one looks through at once. What a system does at one configuration, at its start or
//! for a projection are methods of its views.

use crate::circles::{modules, remove_tests};
use std::collections::BTreeMap;

const LAYER: &str = "dynamics";
/// Over all inherent impls of a type.
const MOST_METHODS: usize = 40;
/// Of `System`: fewer are found when they are written in another way than this file reads.
const FEWEST_METHODS: usize = 20;

#[test]
fn invariant_types_of_dynamics_have_few_methods() {
    let mut texts = modules("ezy-core/src");
    remove_tests(&mut texts);
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (_, text) in texts.iter().filter(|(module, _)| module.first().is_some_and(|layer| layer == LAYER)) {
        for (of, method) in methods(text) {
            found.entry(of).or_default().push(method);
        }
    }
    let of_system = found.get("System").map_or(0, Vec::len);
    assert!(of_system >= FEWEST_METHODS, "only {of_system} methods of `System` found");
    found.retain(|_, methods| methods.len() > MOST_METHODS);
    let n: Vec<_> = found.iter().map(|(of, methods)| (of, methods.len())).collect();
    assert!(
        found.is_empty(),
        "more than {MOST_METHODS} methods: {n:?}; give some to a view, which a method hands out: {found:#?}"
    );
}

#[test]
fn analytic_methods_of_inherent_impls_are_found_and_no_others() {
    let text = "\
impl<'s, P: SceneRef> System<P> {
    pub(crate) const fn one(&self) {
        fn inner() {}
    }

    fn two<T>(
        self,
    ) -> T {
    }
}

impl<F> Table<F>
where
    F: for<'a> Fn(&'a str),
{
    pub fn three(&self) {}
}

impl<P: SceneRef> Dynamics<f64> for System<P> {
    fn four(&self) {}
}

impl System<f64> {}

pub trait Five {
    fn five(&self);
}

fn six() {}
";
    let expected = [("System", "one"), ("System", "two"), ("Table", "three")];
    assert_eq!(methods(text), expected.map(|(of, method)| (of.to_owned(), method.to_owned())));
}

/// Type and name of the methods of inherent impls, in a text without comments that is laid out by rustfmt: a method begins one level deep.
fn methods(text: &str) -> Vec<(String, String)> {
    let (mut found, mut head, mut of) = (Vec::new(), None, None);
    for line in text.lines() {
        if line.starts_with("impl") {
            head = Some(String::new());
        }
        if let Some(so_far) = &mut head {
            so_far.push_str(line);
            if line.ends_with(['{', '}']) {
                of = implemented(so_far).filter(|_| line.ends_with('{'));
                head = None;
            }
            continue;
        }
        if line == "}" {
            of = None;
        }
        let method = line.strip_prefix("    ").filter(|rest| !rest.starts_with(' ')).and_then(method);
        if let (Some(of), Some(method)) = (&of, method) {
            found.push((String::clone(of), method));
        }
    }
    found
}

/// The type of an inherent impl.
fn implemented(head: &str) -> Option<String> {
    if head.contains(" for ") {
        return None;
    }
    let mut depth = 0;
    // behind the parameters of the impl
    let of = head.strip_prefix("impl")?.trim_start_matches(|c: char| {
        depth += i32::from(c == '<') - i32::from(c == '>');
        depth > 0 || c == '>' || c == ' '
    });
    Some(of.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect())
}

fn method(line: &str) -> Option<String> {
    let (before, rest) = line.split_once("fn ")?;
    let is_qualifier = |word: &str| word.starts_with("pub") || ["const", "async"].contains(&word);
    before.split_whitespace().all(is_qualifier).then(|| rest.split(['(', '<']).next().unwrap_or_default().to_owned())
}
