//! References for the models of the garage: `answers/*.json`. Each was computed by two independent formulations in
//! 113-bit arithmetic, or from a closed form; each file says so, and how far double precision can follow.

use ezy_core::prelude::*;
use serde_json::Value;
use std::path::Path;

/// Recorded times this near to a reference's are the same, s.
const SAME_TIME: f64 = 1e-9;

/// Reads `answers/<name>.json`.
///
/// # Panics
/// When the file is not there or is no JSON: the test that asks for it fails.
pub fn load(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("answers").join(format!("{name}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The case of a file with a name.
///
/// # Panics
/// When there is none.
pub fn case<'v>(file: &'v Value, name: &str) -> &'v Value {
    list(&file["cases"]).iter().find(|case| case["name"] == name).unwrap_or_else(|| panic!("no case `{name}`"))
}

/// A number.
///
/// # Panics
/// When it is none.
pub fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// A number; what a file leaves out is zero.
///
/// # Panics
/// When it is something else.
pub fn number_or_zero(value: &Value) -> f64 {
    if value.is_null() { 0.0 } else { number(value) }
}

/// Rows of numbers, the time first.
pub fn rows(table: &Value) -> Vec<Vec<f64>> {
    list(table).iter().map(|row| list(row).iter().map(number).collect()).collect()
}

/// A list; what a file leaves out is empty.
///
/// # Panics
/// When it is something else.
pub fn list(value: &Value) -> &[Value] {
    match value {
        Value::Null => &[],
        _ => value.as_array().unwrap_or_else(|| panic!("{value} is no list")),
    }
}

/// Sets parameters of a scene by name.
///
/// # Panics
/// When the scene has no such parameter.
pub fn set(scene: &mut dyn Scene, values: &[(&str, f64)]) {
    for (name, value) in values {
        let i = scene.info().parameters.iter().position(|p| p.name == *name);
        scene.set_parameter(i.unwrap_or_else(|| panic!("no parameter `{name}`")), *value);
    }
}

/// Names of bodies in a reference, and in the model.
pub type Names<'n> = &'n [(&'n str, &'n str)];

/// Coordinates and velocities of a body of a reference's model, by their names here.
pub fn start_values(body: &Value) -> [(&'static str, &Value); 6] {
    let (centre, velocity) = (&body["com"], &body["vel"]);
    [
        ("x", &centre[0]),
        ("y", &centre[1]),
        ("phi", &body["angle"]),
        ("vx", &velocity[0]),
        ("vy", &velocity[1]),
        ("omega", &body["omega"]),
    ]
}

/// Starts the named bodies where the `bodies` of a reference's model are.
///
/// # Panics
/// When a number is missing.
pub fn start_at<'s, S: Scene + ?Sized + 's>(
    mut order: Simulation<'s, &'s S>,
    model: &Value,
    names: Names<'_>,
) -> Simulation<'s, &'s S> {
    for body in list(&model["bodies"]) {
        let Some((_, name)) = names.iter().find(|(theirs, _)| body["name"] == *theirs) else { continue };
        for (member, value) in start_values(body) {
            order = order.start(format!("{name}.{member}"), number(value));
        }
    }
    order
}

/// Calls `compare` with a sample at each of the times: of one run that keeps a sample every `every_s`, or of a run that
/// ends there, for a time in between.
///
/// # Panics
/// When a run cannot start or stops on the way.
pub fn at_times<'s, S: Scene + ?Sized + 's>(
    order: impl Fn() -> Simulation<'s, &'s S>,
    every_s: f64,
    times: impl Iterator<Item = f64> + Clone,
    mut compare: impl FnMut(usize, Sample<'_>),
) {
    let last = times.clone().filter(|t| ((t / every_s).round() * every_s - t).abs() < SAME_TIME).fold(0.0, f64::max);
    let run = order().until(last).every(every_s).run().expect("a run that starts");
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    for (i, t) in times.enumerate() {
        if let Some(sample) = run.samples().find(|s| (s.t - t).abs() < SAME_TIME) {
            compare(i, sample);
        } else {
            let run = order().until(t).run().expect("a run that starts");
            assert!(run.outcome.reached_end(), "{}", run.outcome);
            compare(i, run.last());
        }
    }
}

/// Largest differences of the coordinates and of the velocities of the named bodies from the `states` of a reference.
///
/// # Panics
/// As [`at_times`], and when a body or a number is missing.
pub fn from_states<'s, S: Scene + ?Sized + 's>(
    order: impl Fn() -> Simulation<'s, &'s S>,
    every_s: f64,
    states: &Value,
    names: Names<'_>,
) -> [f64; 2] {
    let states = list(states);
    let mut worst = [0.0_f64; 2];
    at_times(order, every_s, states.iter().map(|state| number(&state["t"])), |i, sample| {
        for (theirs, ours) in names {
            for (k, member) in ["x", "y", "phi", "vx", "vy", "omega"].into_iter().enumerate() {
                let value = sample.get(&format!("{ours}.{member}")).expect("a coordinate");
                worst[k / 3] = worse(worst[k / 3], value - number(&states[i]["bodies"][theirs][k]));
            }
        }
    });
    worst
}

/// The larger of an error and the size of another one; a NaN stays.
pub fn worse(worst: f64, error: f64) -> f64 {
    if error.abs() > worst || error.is_nan() { error.abs() } else { worst }
}
