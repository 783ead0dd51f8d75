//! Names that users type, looked up; an unknown name is answered with the nearest known one.

use crate::model::SceneInfo;

/// A name that is not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{kind} `{name}` {}", fault(self))]
pub struct UnknownName {
    /// Kind of name that was expected: `coordinate`, `column`, …
    pub kind: &'static str,
    /// The name as given.
    pub name: String,
    /// The known name that is most like it, if any is.
    pub nearest: Option<String>,
    /// All known names.
    pub known: Vec<String>,
    /// Call that is missing on the simulation, when the name is a column that the run did not record.
    pub remedy: Option<&'static str>,
}

fn fault(of: &UnknownName) -> String {
    match of.remedy {
        Some(remedy) => format!("was not recorded; call `.{remedy}()` on the simulation"),
        None => format!("is not known{}; known: {}", suggestion(&of.nearest), list(&of.known)),
    }
}

fn suggestion(nearest: &Option<String>) -> String {
    nearest.as_ref().map(|n| format!(" (did you mean `{n}`?)")).unwrap_or_default()
}

/// Known names that a message lists; further ones are counted.
const MAX_LISTED: usize = 60;

fn list(known: &[String]) -> String {
    let listed = known[..known.len().min(MAX_LISTED)].join(", ");
    match known.len().saturating_sub(MAX_LISTED) {
        _ if known.is_empty() => "none".to_owned(),
        0 => listed,
        more => format!("{listed} and {more} more"),
    }
}

/// Jaro–Winkler similarity from which a name is worth suggesting: one or two slips in a short word.
const SIMILAR: f64 = 0.75;

/// Index of a coordinate, `seat.phi`; its velocity has the same one.
///
/// # Errors
/// [`UnknownName`] with the most similar coordinate.
pub fn coordinate_index(info: &SceneInfo, name: &str) -> Result<usize, UnknownName> {
    find_name("coordinate", name, info.coordinates.iter().map(|c| &*c.name))
}

/// Index of an input.
///
/// # Errors
/// [`UnknownName`] with the most similar input.
pub fn input_index(info: &SceneInfo, name: &str) -> Result<usize, UnknownName> {
    find_name("input", name, info.inputs.iter().map(|input| input.name))
}

/// Index of an output.
///
/// # Errors
/// [`UnknownName`] with the most similar output.
pub fn output_index(info: &SceneInfo, name: &str) -> Result<usize, UnknownName> {
    find_name("output", name, info.outputs.iter().map(|output| &*output.name))
}

/// Index of `name` among `known`.
///
/// # Errors
/// [`UnknownName`] with the most similar known name.
pub fn find_name<'n>(
    kind: &'static str,
    name: &str,
    known: impl Iterator<Item = &'n str> + Clone,
) -> Result<usize, UnknownName> {
    if let Some(i) = known.clone().position(|k| k == name) {
        return Ok(i);
    }
    // `speed` of `output.speed`
    let by_last_part = known.clone().find(|k| k.rsplit_once('.').is_some_and(|(_, last)| last == name));
    let most_similar = || {
        let similarities = known.clone().map(|k| (strsim::jaro_winkler(k, name), k));
        // `torque` is no slip for `t`
        let is_near = |k: &str| k.chars().count() > 1 || name.chars().count() <= 2 || (k, name) == ("t", "time");
        let worth = similarities.filter(|(similarity, k)| *similarity > SIMILAR && is_near(k));
        worth.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, k)| k)
    };
    let nearest = by_last_part.or_else(most_similar).map(str::to_owned);
    Err(UnknownName { kind, name: name.to_owned(), nearest, known: known.map(str::to_owned).collect(), remedy: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_part_behind_the_dot_is_a_hint() {
        let known = ["t", "seat.x", "seat.phi", "output.speed", "output.spread"];
        let nearest = |name: &str| find_name("column", name, known.into_iter()).unwrap_err().nearest;
        assert_eq!(nearest("speed").as_deref(), Some("output.speed"));
        assert_eq!(nearest("phi").as_deref(), Some("seat.phi"));
        assert_eq!(nearest("seat.ph").as_deref(), Some("seat.phi"));
        assert_eq!(nearest("zzz"), None);
    }
}
