//! What an exported file says about its scene: names, units and values, in the order of the arguments.

use crate::model::{Name, SceneInfo};

use super::Source;

/// A list of what an argument or a result consists of.
#[derive(Debug)]
pub(super) struct List {
    pub name: &'static str,
    /// Of what, and what the values are.
    pub about: &'static str,
    /// Rows and outputs have none.
    pub has_values: bool,
    pub entries: Vec<Entry>,
}

#[derive(Debug)]
pub(super) struct Entry {
    pub name: String,
    pub unit: String,
    pub value: f64,
    /// What the model file says of it, in one line.
    pub documentation: String,
}

impl Entry {
    fn new(name: impl Into<String>, unit: &str, value: f64, documentation: &str) -> Self {
        Self { name: name.into(), unit: unit.to_owned(), value, documentation: plain(documentation) }
    }
}

/// Documentation as one line that ends no comment and no string.
fn plain(documentation: &str) -> String {
    let words: Vec<&str> = documentation.split_whitespace().collect();
    words.join(" ").replace("*/", "* /").replace('"', "'").replace('\\', "/")
}

/// Parameters, then switches.
pub(super) fn parameter_names(info: &SceneInfo) -> impl Iterator<Item = String> + '_ {
    let switches = info.switches.iter().map(|of| of.name.to_owned());
    info.parameters.iter().map(|of| of.name.to_owned()).chain(switches)
}

/// The lists of a file; none that is empty.
pub(super) fn lists(source: &Source<'_>) -> Vec<List> {
    let info = &source.info;
    let of_motion = |of: &[crate::model::CoordinateInfo], values: &[f64]| {
        of.iter().zip(values).map(|(of, &value)| Entry::new(of.name.clone(), of.unit, value, "")).collect()
    };
    let declared = |of: &[crate::model::ParameterInfo]| {
        of.iter().map(|of| Entry::new(of.name, of.unit, of.default, of.documentation)).collect::<Vec<_>>()
    };
    let documentation = info.parameters.iter().map(|of| (of.unit, of.documentation));
    let of_parameters = documentation.chain(info.switches.iter().map(|of| ("", of.documentation)));
    let parameters = parameter_names(info).zip(of_parameters).zip(&source.parameters);
    let without_value = |name: &Name, unit, documentation| Entry::new(name.clone(), unit, 0.0, documentation);
    let all = [
        ("coordinates", "q, and where the scene starts", of_motion(&info.coordinates, source.start.q)),
        ("velocities", "v, and where the scene starts", of_motion(&info.velocities, source.start.v)),
        ("states", "z, first-order states, and where they start", declared(info.states)),
        ("inputs", "u, with their declared values", declared(info.inputs)),
        (
            "parameters",
            "p, from which `constants` makes c",
            parameters.map(|((name, (unit, about)), &value)| Entry::new(name, unit, value, about)).collect(),
        ),
        (
            "rows",
            "the constraints, with the units of their multipliers",
            info.rows.iter().map(|row| without_value(&row.name, row.multiplier_unit, row.kind)).collect(),
        ),
        (
            "events",
            "what `events` returns: conditions of events, of the end of the scene, and discontinuities of laws",
            info.events.iter().map(|of| Entry::new(of.name, "", 0.0, of.documentation)).collect(),
        ),
        (
            "outputs",
            "what `outputs` returns",
            info.outputs.iter().map(|of| without_value(&of.name, of.unit, of.documentation)).collect(),
        ),
    ];
    let lists = all.map(|(name, about, entries)| List {
        name,
        about,
        has_values: !matches!(name, "rows" | "outputs" | "events"),
        entries,
    });
    lists.into_iter().filter(|list| !list.entries.is_empty()).collect()
}

/// What a file says first, by lines.
pub(super) fn title(source: &Source<'_>) -> Vec<String> {
    let info = &source.info;
    let mut lines = vec![format!(
        "Equations of motion of {}/{}, written by EZY {}.",
        info.model,
        info.name,
        env!("CARGO_PKG_VERSION")
    )];
    lines.extend(info.documentation.lines().map(plain));
    lines.extend(
        [
            "",
            "M a + G' lambda = F and G a = -[h; s] are the equations of motion, v is the rate of q. Arguments: time t in s, coordinates q,",
            "velocities v, where the scene has some first-order states z and inputs u, and c, which `constants` makes of the parameters p.",
            "Functions of the motion take all of these. Lists of names, with units and values, are in their order.",
        ]
        .map(str::to_owned),
    );
    if !info.switches.is_empty() {
        lines.push("Rows that are switched hold as the last parameters say; a run of EZY sets these when a skate slips or a stop opens.".to_owned());
    }
    lines
}

/// A name for files and prefixes: `ezyroller_driven`.
pub fn file_name(info: &SceneInfo) -> String {
    let of = |name: &str| super::identifiers::identifier(&name.to_lowercase());
    format!("{}_{}", of(info.model), of(info.name))
}
