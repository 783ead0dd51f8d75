//! Names of a scene as identifiers of other languages.

use std::collections::HashSet;

/// Words that mean something in one of the languages, and what the printers write themselves.
const RESERVED: [&str; 3] = [
    // arguments and results
    "t q v z u c p dq dv dz du event change_of_acceleration change_of_multiplier change_of_rates \
     change_of_output mass residual jacobian convective force rates output acceleration multiplier ratio \
     matrix right_side solution T",
    // namespaces and functions
    "np sp ca math pi sin cos tan asin acos atan atan2 arcsin arccos arctan2 sqrt exp log tanh abs fabs \
     min max fmin fmax minimum maximum sign pow power zeros eltype promote_type solve",
    // keywords
    "and as assert async auto await baremodule begin bool break case catch char class classdef const \
     constexpr continue def default del delete do double elif else elseif end enum enumeration events \
     except explicit export extern false finally float for friend from function global goto if import in \
     inline int is lambda let local long macro methods module mutable namespace new nonlocal not operator \
     or otherwise parfor pass persistent private properties protected public quote raise register \
     restrict return short signed sizeof spmd static struct switch template this throw true try type \
     typedef typename union unsigned unwind_protect using virtual void volatile where while with yield",
];

/// A name with letters, digits and single underscores alone: `rod_0_x` for `rod[0].x`.
pub(super) fn identifier(name: &str) -> String {
    let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    let parts: Vec<&str> = plain.split('_').filter(|part| !part.is_empty()).collect();
    match parts.join("_") {
        joined if joined.starts_with(|c: char| c.is_ascii_alphabetic()) => joined,
        joined => format!("x{joined}"),
    }
}

/// Identifiers of one function, each given once.
#[derive(Debug)]
pub(super) struct Identifiers {
    taken: HashSet<String>,
}

impl Identifiers {
    pub(super) fn new() -> Self {
        Self { taken: RESERVED.iter().flat_map(|words| words.split(' ')).map(str::to_owned).collect() }
    }

    /// `wanted` as an identifier that nothing else has: with underscores behind it where it is taken.
    pub(super) fn give(&mut self, wanted: &str) -> String {
        let mut name = identifier(wanted);
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_identifiers_are_words_that_nothing_else_has() {
        assert_eq!(["rod[0].x", "seat.phi", "_a", "2"].map(identifier), ["rod_0_x", "seat_phi", "a", "x2"]);
        let mut identifiers = Identifiers::new();
        assert_eq!(
            ["c", "lambda", "a.b", "a_b", "a[b]"].map(|name| identifiers.give(name)),
            ["c_", "lambda_", "a_b", "a_b_", "a_b__"]
        );
    }
}
