//! Scene descriptions made at run time, for scenes whose size is a number.

use ezy_core::model::{
    CoordinateInfo, EffectInfo, EliminationStep, Formula, Operations, ParameterInfo, RowInfo, SceneInfo,
    SparsityPattern,
};

/// What differs between the scenes made here.
pub struct Description<'d> {
    pub model: &'static str,
    pub n_bodies: usize,
    /// Name of each row.
    pub rows: Vec<String>,
    pub n_position_rows: usize,
    /// Columns of each row of G.
    pub columns: Vec<Vec<usize>>,
    /// Name and value of each parameter.
    pub parameters: &'d [(&'static str, f64)],
    pub effects: &'static [EffectInfo],
    pub until_s: f64,
}

const NO_FORMULA: Formula = Formula { text: "", latex: "", mathml: "" };

fn leak<T>(items: Vec<T>) -> &'static [T] {
    Vec::leak(items)
}

fn text(name: String) -> &'static str {
    String::leak(name)
}

/// The description as a scene gives it. Lives until the program ends.
pub fn info(description: Description<'_>) -> &'static SceneInfo {
    let bodies: Vec<&'static str> = (0..description.n_bodies).map(|i| text(format!("body{i}"))).collect();
    let coordinate = |body: &str, name: &str, velocity: &str, unit| CoordinateInfo {
        name: text(format!("{body}.{name}")),
        velocity_name: text(format!("{body}.{velocity}")),
        unit,
        symbol: NO_FORMULA,
        velocity_symbol: NO_FORMULA,
    };
    let coordinates = bodies.iter().flat_map(|body| {
        [coordinate(body, "x", "vx", "m"), coordinate(body, "y", "vy", "m"), coordinate(body, "phi", "omega", "rad")]
    });
    let row = |name| RowInfo {
        name: text(name),
        kind: "row",
        multiplier_unit: "N",
        constraint: NO_FORMULA,
        convective_term: NO_FORMULA,
    };
    let parameter = |&(name, default)| ParameterInfo {
        name,
        unit: "",
        default,
        default_text: "",
        documentation: "",
        effect: None,
        symbol: NO_FORMULA,
    };
    let n_rows = description.rows.len();
    let mut starts = vec![0];
    starts.extend(description.columns.iter().scan(0, |n, columns| {
        *n += columns.len();
        Some(*n)
    }));
    Box::leak(Box::new(SceneInfo {
        model: description.model,
        name: "scene",
        documentation: "",
        coordinates: leak(coordinates.collect()),
        bodies: leak(bodies),
        points: &[],
        rows: leak(description.rows.into_iter().map(row).collect()),
        n_position_rows: description.n_position_rows,
        parameters: leak(description.parameters.iter().map(parameter).collect()),
        inputs: &[],
        outputs: &[],
        events: &[],
        stick_slip: None,
        stop: None,
        effects: description.effects,
        until_s: description.until_s,
        n_constants: 0,
        jacobian: SparsityPattern { starts: leak(starts), columns: leak(description.columns.concat()) },
        jacobian_entries: &[],
        mass_entries: &[],
        force_entries: &[],
        potential_energy: Formula { text: "0", latex: "0", mathml: "" },
        abbreviations: &[],
        equations: &[],
        elimination: leak(vec![EliminationStep { rows: leak((0..n_rows).collect()), constant_pivot: false }]),
        acceleration_operations: Operations::default(),
        correction_operations: Operations::default(),
        series: ezy_core::model::SeriesInfo::Absent,
        repeats: None,
    }))
}
