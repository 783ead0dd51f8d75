//! A hash of the model text, by which results tell which model they are of.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// FNV-1a (Fowler, Noll, Vo), the same on every machine.
#[derive(Debug)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Of these bytes.
    #[cfg(test)]
    pub fn of(bytes: impl IntoIterator<Item = u8>) -> u64 {
        let mut hash = Self::default();
        hash.add_bytes(bytes);
        hash.0
    }

    fn add_bytes(&mut self, bytes: impl IntoIterator<Item = u8>) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    fn add(&mut self, text: &str) {
        // the end of a word, so that `a b` is not `ab`
        self.add_bytes(text.bytes().chain([0]));
    }

    /// All tokens but documentation, which changes no motion, and the path of the crate.
    fn add_all(&mut self, tokens: TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        while let Some(token) = tokens.next() {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == '#' && tokens.next_if(is_documentation).is_some() => {}
                TokenTree::Group(group) => {
                    let [open, close] = match group.delimiter() {
                        Delimiter::Parenthesis => ["(", ")"],
                        Delimiter::Brace => ["{", "}"],
                        Delimiter::Bracket => ["[", "]"],
                        Delimiter::None => ["", ""],
                    };
                    self.add(open);
                    self.add_all(group.stream());
                    self.add(close);
                }
                TokenTree::Ident(ident) if ident == "$crate" => {}
                token => self.add(&token.to_string()),
            }
        }
    }
}

/// `[doc = "…"]`
fn is_documentation(token: &TokenTree) -> bool {
    let TokenTree::Group(group) = token else { return false };
    matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(ident)) if ident == "doc")
}

/// A hash of all words of the text; comments, documentation and spaces do not count.
pub fn of(tokens: &TokenStream) -> u64 {
    let mut hash = Hash::default();
    hash.add_all(tokens.clone());
    hash.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_text(text: &str) -> u64 {
        of(&text.parse().unwrap())
    }

    #[test]
    fn invariant_fingerprint_tells_texts_apart_by_what_they_mean() {
        let text = "/// A rod. \n model Rod { /** long */ param l: m = 0.5; // metres\n }";
        assert_eq!(of_text(text), of_text("model Rod {param l : m = 0.5;}"));
        let others = [
            "model Rod { param l: m = 0.6; }",
            "model Rod { param l: m = 0.50; }",
            "model Rod { param lm = 0.5; }",
            "model Rod { param l: m = 0.5 }",
            "model Rod ( param l: m = 0.5; )",
            "model Rod { #[cfg] param l: m = 0.5; }",
        ];
        assert!(others.iter().all(|other| of_text(other) != of_text(text)));
    }

    /// The values of the published algorithm for `a` and its end, 0.
    #[test]
    fn reference_fingerprint_is_fnv_1a() {
        assert_eq!(of_text("a"), 0x089b_e207_b544_f1e4);
    }
}
