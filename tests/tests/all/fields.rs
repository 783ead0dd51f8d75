//! A struct of the loop holds one idea: none has more fields than a reader keeps in mind.

use crate::circles::{modules, remove_tests};

const MOST_FIELDS: usize = 10;

/// The loop has more structs than this: fewer are found when its folder has moved.
const FEWEST_STRUCTS: usize = 40;

#[test]
fn invariant_structs_of_the_loop_have_few_fields() {
    let mut texts = modules("ezy-core/src");
    remove_tests(&mut texts);
    let of_loop = texts.into_iter().map(|(module, text)| (module.join("/"), text));
    let of_loop = of_loop.filter(|(file, _)| file.split('/').next() == Some("simulate"));
    let mut found: Vec<(String, String, usize)> = Vec::new();
    for (file, text) in of_loop {
        found.extend(structs(&text).into_iter().map(|(name, n)| (file.clone(), name, n)));
    }
    assert!(found.len() >= FEWEST_STRUCTS, "only {} structs found", found.len());
    found.retain(|one| one.2 > MOST_FIELDS);
    assert!(found.is_empty(), "which of its fields are one idea, with a name of its own? {found:#?}");
}

#[test]
fn analytic_named_fields_are_counted_at_their_own_level() {
    let text = "
        pub(in crate::a) struct Four<'s, P: Scene, const N: usize> {
            #[cfg(feature = \"x\")]
            pub(crate) a: [f64; N],
            b: Option<&'s mut dyn b::Trait>,
            c: Box<dyn FnMut(f64) -> Result<f64, E> + Send + 's>,
            d: (u64, f64),
        }
        struct Unit;
        struct Pair(u64, [f64; 3]);
        fn f() { let s = Four { a: 1, b: 2 }; }
        struct One { of: usize }
        struct None {}";
    let expected = [("Four", 4), ("One", 1), ("None", 0)].map(|(name, n)| (name.to_owned(), n));
    assert_eq!(structs(text), expected);
}

/// The structs with named fields of a text, and how many fields each has.
fn structs(text: &str) -> Vec<(String, usize)> {
    let declared = text.split("struct ").skip(1).filter_map(|rest| {
        let (head, body) = rest.split_once('{')?;
        let name = head.split(|c: char| !c.is_alphanumeric() && c != '_').next()?;
        (!head.contains(';')).then(|| (name.to_owned(), n_fields(body)))
    });
    declared.collect()
}

/// The colons behind names up to the brace that closes a body.
fn n_fields(body: &str) -> usize {
    let body = body.replace("::", "").replace("->", "");
    let (mut depth, mut n) = (0, 0);
    for c in body.chars() {
        match c {
            '}' if depth == 0 => break,
            '{' | '(' | '[' | '<' => depth += 1,
            '}' | ')' | ']' | '>' => depth -= 1,
            ':' if depth == 0 => n += 1,
            _ => {}
        }
    }
    n
}
