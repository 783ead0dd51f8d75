//! Parts of descriptions of scenes that are written by hand.

use ezy_core::model::{
    CoordinateInfo, Formula, List, Name, Operations, RowInfo, SceneInfo, SeriesInfo, SparsityPattern,
};

pub(crate) const fn f(text: &'static str) -> Formula {
    Formula { text, latex: "", mathml: "" }
}

pub(crate) const fn coordinate(name: &'static str, unit: &'static str) -> CoordinateInfo {
    CoordinateInfo { name: Name::Borrowed(name), unit, symbol: Some(f(name)) }
}

pub(crate) const fn row(
    name: &'static str,
    kind: &'static str,
    constraint: &'static str,
    convective_term: &'static str,
) -> RowInfo {
    let name = Name::Borrowed(name);
    RowInfo { name, kind, multiplier_unit: "N", constraint: f(constraint), convective_term: f(convective_term) }
}

const NO_OPERATIONS: Operations = Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 };

/// A scene without anything.
pub(crate) const EMPTY: SceneInfo = SceneInfo {
    model: "",
    name: "",
    documentation: "",
    fingerprint: 0,
    bodies: List::Borrowed(&[]),
    kinds: List::Borrowed(&[]),
    coordinates: List::Borrowed(&[]),
    velocities: List::Borrowed(&[]),
    points: List::Borrowed(&[]),
    rows: List::Borrowed(&[]),
    n_position_rows: 0,
    parameters: &[],
    inputs: &[],
    integrated_inputs: &[],
    states: &[],
    outputs: List::Borrowed(&[]),
    events: &[],
    limited_skates: &[],
    stop: None,
    switches: &[],
    effects: &[],
    until_s: 0.0,
    n_constants: 0,
    jacobian: SparsityPattern::new(&[0], &[]),
    jacobian_entries: &[],
    mass_entries: &[],
    force_entries: &[],
    potential_energy: f("0"),
    abbreviations: &[],
    equations: &[],
    elimination: &[],
    acceleration_operations: NO_OPERATIONS,
    correction_operations: NO_OPERATIONS,
    feedback: None,
    quasi_velocities: None,
    series: SeriesInfo::Absent,
    repeats: None,
};
