//! Parts of descriptions of scenes that are written by hand.

use ezy_core::model::{CoordinateInfo, Formula, Operations, RowInfo, SceneInfo, SeriesInfo, SparsityPattern};

pub(crate) const fn f(text: &'static str) -> Formula {
    Formula { text, latex: "", mathml: "" }
}

pub(crate) const fn coordinate(name: &'static str, velocity_name: &'static str, unit: &'static str) -> CoordinateInfo {
    CoordinateInfo { name, velocity_name, unit, symbol: f(name), velocity_symbol: f(velocity_name) }
}

pub(crate) const fn row(
    name: &'static str,
    kind: &'static str,
    constraint: &'static str,
    convective_term: &'static str,
) -> RowInfo {
    RowInfo { name, kind, multiplier_unit: "N", constraint: f(constraint), convective_term: f(convective_term) }
}

const NO_OPERATIONS: Operations = Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 };

/// A scene without anything.
pub(crate) const EMPTY: SceneInfo = SceneInfo {
    model: "",
    name: "",
    documentation: "",
    bodies: &[],
    coordinates: &[],
    points: &[],
    rows: &[],
    n_position_rows: 0,
    parameters: &[],
    inputs: &[],
    outputs: &[],
    events: &[],
    stick_slip: None,
    stop: None,
    effects: &[],
    until_s: 0.0,
    n_constants: 0,
    jacobian: SparsityPattern { starts: &[0], columns: &[] },
    jacobian_entries: &[],
    mass_entries: &[],
    force_entries: &[],
    potential_energy: f("0"),
    abbreviations: &[],
    equations: &[],
    elimination: &[],
    acceleration_operations: NO_OPERATIONS,
    correction_operations: NO_OPERATIONS,
    series: SeriesInfo::Absent,
    repeats: None,
};
