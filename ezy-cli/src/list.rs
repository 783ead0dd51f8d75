//! The command `list`.

use serde_json::{Value, json};

use ezy_core::model::{CountInfo, EffectInfo, ModelInfo, ParameterInfo, SceneEntry, SceneInfo};
use ezy_study::report::table::Table;

use super::Models;
use super::arguments::ListArguments;
use super::failure::{Failure, print};
use super::json::print_json;
use super::selection::{selected, typed};

pub(super) fn list(models: Models<'_>, arguments: &ListArguments) -> Result<(), Failure> {
    let models = selected(models, arguments.path.as_deref())?;
    if arguments.json {
        let models = models.iter().map(|(model, scenes)| model_json(model, scenes)).collect::<Value>();
        return print_json(&json!({ "models": models }));
    }
    print(&models.iter().map(|(model, scenes)| model_text(model, scenes) + "\n").collect::<String>())
}

/// Independent velocities at the start: all less rows that hold, which are independent in a sound scene.
fn freedom(info: &SceneInfo) -> usize {
    let [_, n_rows] = info.n_rows_at_start();
    info.n_velocities().saturating_sub(n_rows)
}

fn model_text(model: &ModelInfo, scenes: &[&SceneEntry]) -> String {
    let mut table = Table::new([
        "scene",
        "effects",
        "bodies",
        "position constraints",
        "velocity constraints",
        "degrees of freedom",
        "until [s]",
    ]);
    for scene in scenes {
        let info = (scene.info)();
        let effects = info.effects.iter().map(|effect| effect.name).collect::<Vec<_>>().join(", ");
        let [n_position_rows, n_rows] = info.n_rows_at_start();
        table.push([
            format!("{}/{}", typed(model.name), info.name),
            if effects.is_empty() { "-".to_owned() } else { effects },
            info.bodies.len().to_string(),
            n_position_rows.to_string(),
            (n_rows - n_position_rows).to_string(),
            freedom(&info).to_string(),
            info.until_s.to_string(),
        ]);
    }
    let counts = model.scenes.first().map_or(&[][..], |scene| (scene.info)().counts());
    let counts: Vec<String> = counts.iter().map(|count| format!("{} = {}", count.name, count.default)).collect();
    let sizes = match counts.join(", ") {
        counts if counts.is_empty() => counts,
        counts => format!("sizes for {counts}\n"),
    };
    format!("{}: {}\n\n{table}{sizes}", model.name, model.documentation.trim())
}

/// Names and declared values of the counts of a scene.
pub(super) fn counts_json(info: &SceneInfo) -> Value {
    let counts = info.counts().iter();
    let count =
        |c: &CountInfo| json!({ "name": c.name, "default": c.default, "documentation": c.documentation.trim() });
    counts.map(count).collect()
}

fn model_json(model: &ModelInfo, scenes: &[&SceneEntry]) -> Value {
    json!({
        "name": model.name,
        "documentation": model.documentation.trim(),
        "effects": names(model.effects),
        "scenes": scenes.iter().map(|entry| scene_json(&(entry.info)())).collect::<Value>(),
    })
}

fn scene_json(info: &SceneInfo) -> Value {
    let [n_position_rows, n_rows] = info.n_rows_at_start();
    let parameter =
        |p: &ParameterInfo| json!({ "name": p.name, "unit": p.unit, "default": p.default, "effect": p.effect });
    let parameters: Value = info.parameters.iter().map(parameter).collect();
    let inputs: Value = info.inputs.iter().map(|i| json!({ "name": i.name, "unit": i.unit })).collect();
    let outputs: Value = info.outputs.iter().map(|o| json!({ "name": o.name, "unit": o.unit })).collect();
    json!({
        "name": info.name,
        "documentation": info.documentation.trim(),
        "effects": names(info.effects),
        "bodies": &info.bodies[..],
        "parameters": parameters,
        "counts": counts_json(info),
        "inputs": inputs,
        "outputs": outputs,
        "coordinates": info.n_coordinates(),
        "position_rows": n_position_rows,
        "velocity_rows": n_rows - n_position_rows,
        "freedom": freedom(info),
        "until": info.until_s,
    })
}

fn names(effects: &[EffectInfo]) -> Value {
    effects.iter().map(|effect| effect.name).collect()
}
