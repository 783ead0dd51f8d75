//! Names and patterns of the hand-written EzyRoller.

use crate::described::{EMPTY, coordinate, f, row};
use ezy_core::model::{
    CoordinateInfo, EffectInfo, EliminationStep, Formula, List, Name, ParameterInfo, PointInfo, RowInfo, SceneInfo,
    SparsityPattern,
};
use std::sync::{Arc, LazyLock};

const fn point(name: &'static str, body: usize, position: [&'static str; 2]) -> PointInfo {
    PointInfo { name: Name::Borrowed(name), body: Some(body), position: Some([f(position[0]), f(position[1])]) }
}

const fn parameter(name: &'static str, unit: &'static str, default: f64, default_text: &'static str) -> ParameterInfo {
    ParameterInfo { name, unit, default, default_text, documentation: "", effect: None, symbol: f(name) }
}

const fn of_pump(parameter: ParameterInfo) -> ParameterInfo {
    ParameterInfo { effect: Some("pump"), ..parameter }
}

static VELOCITIES: [CoordinateInfo; 6] = [
    coordinate("seat.vx", "m/s"),
    coordinate("seat.vy", "m/s"),
    coordinate("seat.omega", "rad/s"),
    coordinate("bar.vx", "m/s"),
    coordinate("bar.vy", "m/s"),
    coordinate("bar.omega", "rad/s"),
];

static COORDINATES: [CoordinateInfo; 6] = [
    coordinate("seat.x", "m"),
    coordinate("seat.y", "m"),
    coordinate("seat.phi", "rad"),
    coordinate("bar.x", "m"),
    coordinate("bar.y", "m"),
    coordinate("bar.phi", "rad"),
];

static ROWS: [RowInfo; 4] = [
    row(
        "B.x",
        "hinge",
        "seat.x + b*cos(seat.phi) - bar.x + d*cos(bar.phi)",
        "-b*cos(seat.phi)*seat.omega^2 - d*cos(bar.phi)*bar.omega^2",
    ),
    row(
        "B.y",
        "hinge",
        "seat.y + b*sin(seat.phi) - bar.y + d*sin(bar.phi)",
        "-b*sin(seat.phi)*seat.omega^2 - d*sin(bar.phi)*bar.omega^2",
    ),
    row(
        "rear",
        "skate",
        "-seat.vx*sin(seat.phi) + seat.vy*cos(seat.phi) - a*seat.omega",
        "-(seat.vx*cos(seat.phi) + seat.vy*sin(seat.phi))*seat.omega",
    ),
    row(
        "front",
        "skate",
        "-bar.vx*sin(bar.phi) + bar.vy*cos(bar.phi) + c*bar.omega",
        "-(bar.vx*cos(bar.phi) + bar.vy*sin(bar.phi))*bar.omega",
    ),
];

static POINTS: [PointInfo; 3] = [
    point("A", 0, ["seat.x - a*cos(seat.phi)", "seat.y - a*sin(seat.phi)"]),
    point("C", 1, ["bar.x + c*cos(bar.phi)", "bar.y + c*sin(bar.phi)"]),
    point("B", 0, ["seat.x + b*cos(seat.phi)", "seat.y + b*sin(seat.phi)"]),
];

static PARAMETERS: [ParameterInfo; 10] = [
    parameter("a", "m", 0.2, "0.2"),
    parameter("b", "m", 0.6, "0.6"),
    parameter("c", "m", 0.1, "0.1"),
    parameter("d", "m", 0.1, "0.1"),
    parameter("m1", "kg", 46.0, "46.0"),
    parameter("i1", "kg*m^2", 10.0, "10.0"),
    parameter("m2", "kg", 1.0, "1.0"),
    parameter("i2", "kg*m^2", 0.005, "0.005"),
    of_pump(parameter("m0", "N*m", 2.0, "2.0")),
    of_pump(parameter("omega", "rad/s", std::f64::consts::PI, "pi")),
];

const EFFECTS: [EffectInfo; 1] = [EffectInfo { name: "pump", documentation: "" }];

const JACOBIAN_ENTRIES: [Formula; 14] = [
    f("1"),
    f("-b*sin(seat.phi)"),
    f("-1"),
    f("-d*sin(bar.phi)"),
    f("1"),
    f("b*cos(seat.phi)"),
    f("-1"),
    f("d*cos(bar.phi)"),
    f("-sin(seat.phi)"),
    f("cos(seat.phi)"),
    f("-a"),
    f("-sin(bar.phi)"),
    f("cos(bar.phi)"),
    f("c"),
];

const MASS_ENTRIES: [Formula; 6] = [f("m1"), f("m1"), f("i1"), f("m2"), f("m2"), f("i2")];

const COASTING: [Formula; 6] = [f("0"), f("0"), f("0"), f("0"), f("0"), f("0")];

const PUMPED: [Formula; 6] = [f("0"), f("0"), f("m0*cos(omega*t)"), f("0"), f("0"), f("-m0*cos(omega*t)")];

fn scene(
    name: &'static str,
    until_s: f64,
    parameters: &'static [ParameterInfo],
    effects: &'static [EffectInfo],
    force_entries: &'static [Formula],
) -> SceneInfo {
    SceneInfo {
        model: "HandRoller",
        name,
        bodies: List::Borrowed(&[Name::Borrowed("seat"), Name::Borrowed("bar")]),
        coordinates: List::Borrowed(&COORDINATES),
        velocities: List::Borrowed(&VELOCITIES),
        points: List::Borrowed(&POINTS),
        rows: List::Borrowed(&ROWS),
        n_position_rows: 2,
        parameters,
        effects,
        until_s,
        n_constants: parameters.len(),
        jacobian: SparsityPattern::new(&[0, 4, 8, 11, 14], &[0, 2, 3, 5, 1, 2, 4, 5, 0, 1, 2, 3, 4, 5]),
        jacobian_entries: &JACOBIAN_ENTRIES,
        mass_entries: &MASS_ENTRIES,
        force_entries,
        elimination: &[EliminationStep { rows: &[0, 1, 2, 3], constant_pivot: false }],
        ..EMPTY
    }
}

/// Everything about the scene `coast`.
pub static COAST: LazyLock<Arc<SceneInfo>> =
    LazyLock::new(|| Arc::new(scene("coast", 1.0, PARAMETERS.split_at(8).0, &[], &COASTING)));

/// Everything about the scene `driven`.
pub static DRIVEN: LazyLock<Arc<SceneInfo>> =
    LazyLock::new(|| Arc::new(scene("driven", 60.0, &PARAMETERS, &EFFECTS, &PUMPED)));
