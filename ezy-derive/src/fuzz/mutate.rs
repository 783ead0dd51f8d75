//! Mistakes in texts: in their tokens, and in their letters.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::random::Random;

/// Number of mistakes in one text: from one to many.
const MAX_MISTAKES: usize = 6;

/// Typing errors, and tokens at the limits of Rust's grammar.
const SNIPPETS: [&str; 44] = [
    " ",
    "\n",
    ";",
    ",",
    ":",
    "=",
    "~",
    ".",
    "..",
    "^",
    "*",
    "/",
    "-",
    "+",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "_",
    "0",
    "1",
    "9",
    "e",
    "t",
    "1e308",
    "1e-320",
    "99999999999999999999",
    "0x1F",
    "1_0.5",
    "1f32",
    "1.",
    "pi",
    "n-1",
    "r#fn",
    "'a",
    "'a'",
    "\"text\"",
    "#[a]",
    "#!",
    "//",
    "/*",
    "é",
];

/// Brackets, and the invisible ones that other macros leave around what they hand on.
const DELIMITERS: [Delimiter; 4] = [Delimiter::Parenthesis, Delimiter::Bracket, Delimiter::Brace, Delimiter::None];

/// The text after some mistakes in its tokens; foreign ones are those of `all`.
pub fn tokens(mut text: TokenStream, all: &[TokenTree], random: &mut Random) -> TokenStream {
    for _ in 0..=random.below(MAX_MISTAKES) {
        text = token(text, all, random);
    }
    text
}

/// Deletes, repeats, swaps, inserts or puts into brackets one token, somewhere in the tree.
fn token(text: TokenStream, all: &[TokenTree], random: &mut Random) -> TokenStream {
    let mut trees: Vec<TokenTree> = text.into_iter().collect();
    if trees.is_empty() {
        return trees.into_iter().collect();
    }
    let i = random.below(trees.len());
    if let (TokenTree::Group(group), 1..) = (&trees[i], random.below(8)) {
        let inside = token(group.stream(), all, random);
        trees[i] = Group::new(group.delimiter(), inside).into();
        return trees.into_iter().collect();
    }
    let j = random.below(trees.len());
    match random.below(12) {
        0 | 1 => drop(trees.remove(i)),
        2 | 3 => trees.insert(i, trees[j].clone()),
        4 | 5 => trees.swap(i, j),
        6 | 7 => trees.insert(i, random.of(all).clone()),
        8 => {
            let wrapped = Group::new(*random.of(&DELIMITERS), trees[i].clone().into());
            trees[i] = wrapped.into();
        }
        _ => trees[i] = random.of(all).clone(),
    }
    trees.into_iter().collect()
}

/// The text after some mistakes in its letters; `other` is where foreign pieces come from.
pub fn letters(text: &str, other: &str, random: &mut Random) -> String {
    let mut text: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(MAX_MISTAKES) {
        let i = random.below(text.len());
        let end = (i + random.below(12)).min(text.len());
        match random.below(8) {
            0 => drop(text.drain(i..end)),
            1 => drop(text.drain(i..text.len().min(i + 1))),
            2 => {
                let piece = text[i..end].to_vec();
                let at = random.below(text.len());
                text.splice(at..at, piece);
            }
            3 if !text.is_empty() => {
                let j = random.below(text.len());
                text.swap(i, j);
            }
            4 => text.truncate(end),
            5 => {
                let from: Vec<char> = other.chars().collect();
                let at = random.below(from.len());
                text.splice(i..i, from[at..(at + random.below(40)).min(from.len())].iter().copied());
            }
            _ => drop(text.splice(i..i, random.of(&SNIPPETS).chars())),
        }
    }
    text.into_iter().collect()
}

/// Every token tree, also inside of brackets.
pub fn flatten(text: TokenStream) -> Vec<TokenTree> {
    let inside = |tree: TokenTree| match &tree {
        TokenTree::Group(group) => [vec![tree.clone()], flatten(group.stream())].concat(),
        _ => vec![tree],
    };
    text.into_iter().flat_map(inside).collect()
}
