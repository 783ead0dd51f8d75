//! Suggestions for a name that does not exist.

use super::elsewhere::{Meaning, meaning, synonym};
use std::fmt::Write;

/// Names are listed in a message when there are at most this many: more would bury the message.
const LISTED_NAMES: usize = 10;

/// The candidate that `name` means in other languages, or the most similar one, if one is similar.
pub fn nearest<'a>(name: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let distance = |candidate: &str| strsim::damerau_levenshtein(&name.to_lowercase(), &candidate.to_lowercase());
    let alike = |candidate: &str| {
        let edits = distance(candidate);
        // a name of one or two letters is not similar to every other one
        let shorter = name.chars().count().min(candidate.chars().count());
        edits == 0 || (shorter > 2 && edits <= (shorter / 3).max(1)) || strsim::jaro_winkler(name, candidate) > 0.85
    };
    let similar =
        || candidates.iter().copied().filter(|candidate| alike(candidate)).min_by_key(|candidate| distance(candidate));
    synonym(name, candidates).or_else(similar)
}

/// ``did you mean `b`? bodies: `a`, `b` ``, as far as it helps.
pub fn suggestion(name: &str, candidates: &[&str], list: &str) -> String {
    let mut text = match nearest(name, candidates) {
        Some(candidate) => format!("did you mean `{candidate}`?"),
        None => String::new(),
    };
    if candidates.is_empty() {
        write!(text, "there are no {list}").ok();
    } else if candidates.len() <= LISTED_NAMES || text.is_empty() {
        let blank = if text.is_empty() { "" } else { " " };
        write!(text, "{blank}{list}: {}", quoted(candidates)).ok();
    }
    text
}

/// The meaning elsewhere, or else the most similar name that is known.
pub fn meaning_or_suggestion(table: &[Meaning], name: &str, candidates: &[&str], list: &str) -> String {
    meaning(table, name).map_or_else(|| suggestion(name, candidates, list), str::to_owned)
}

/// `` `a`, `b` ``
pub fn quoted<S: AsRef<str>>(names: &[S]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{}`", name.as_ref())).collect();
    names.join(", ")
}
