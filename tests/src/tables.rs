//! Tables of exact values, with numbers as decimal text.

use ezy_core::model::Scene;
use serde_json::Value;

/// A table of `tests/answers/linear`.
///
/// # Panics
/// Where it is no JSON.
pub fn table(text: &str) -> Value {
    serde_json::from_str(text).expect("a table")
}

/// A number that is written as text; `pi` is π.
///
/// # Panics
/// Where it is none.
pub fn number(value: &Value) -> f64 {
    let text = value.as_str().expect("a number as text");
    if text == "pi" { std::f64::consts::PI } else { text.parse().expect("a number") }
}

/// The numbers of a list.
pub fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

/// The entries of a list; none of what is no list.
pub fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// Sets parameters of these names in the tables, in small letters, where the scene has them.
pub fn set_parameters<S: Scene>(scene: &mut S, tables: &[&Value]) {
    let info = scene.info();
    for (name, value) in tables.iter().flat_map(|table| table.as_object().into_iter().flatten()) {
        let place = info.parameters.iter().position(|parameter| parameter.name == name.to_lowercase());
        if let Some((place, text)) = place.zip(value.as_str()) {
            scene.set_parameter(place, number(&Value::from(text)));
        }
    }
}
