//! The command `list`.

use crate::model::{ModelInfo, SceneInfo};
use crate::report::table::Table;

use super::Models;
use super::arguments::ListArguments;
use super::failure::{Failure, print};
use super::json::Json;
use super::selection::typed;

pub(super) fn list(models: Models<'_>, arguments: &ListArguments) -> Result<(), Failure> {
    if arguments.json {
        let models = Json::list(models.iter().map(|model| model_json(model)));
        return print(&format!("{}\n", Json::object([("models", models)])));
    }
    print(&models.iter().map(|model| model_text(model) + "\n").collect::<String>())
}

/// Independent velocities: coordinates less rows, which are independent in a sound scene.
fn freedom(info: &SceneInfo) -> usize {
    info.n_coordinates().saturating_sub(info.n_rows())
}

fn model_text(model: &ModelInfo) -> String {
    let mut table = Table::new([
        "scene",
        "effects",
        "bodies",
        "position constraints",
        "velocity constraints",
        "degrees of freedom",
        "until [s]",
    ]);
    for scene in model.scenes {
        let info = (scene.info)();
        let effects = info.effects.iter().map(|effect| effect.name).collect::<Vec<_>>().join(", ");
        table.push([
            format!("{}/{}", typed(model.name), info.name),
            if effects.is_empty() { "-".to_owned() } else { effects },
            info.bodies.len().to_string(),
            info.n_position_rows.to_string(),
            (info.n_rows() - info.n_position_rows).to_string(),
            freedom(info).to_string(),
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
pub(super) fn counts_json(info: &SceneInfo) -> Json {
    let count = |count: &crate::model::CountInfo| {
        Json::object([
            ("name", Json::text(count.name)),
            ("default", Json::Count(count.default as u64)),
            ("documentation", Json::text(count.documentation.trim())),
        ])
    };
    Json::list(info.counts().iter().map(count))
}

fn model_json(model: &ModelInfo) -> Json {
    let names = |effects: &[crate::model::EffectInfo]| Json::list(effects.iter().map(|effect| Json::text(effect.name)));
    let scene = |info: &SceneInfo| {
        let parameter = |p: &crate::model::ParameterInfo| {
            Json::object([
                ("name", Json::text(p.name)),
                ("unit", Json::text(p.unit)),
                ("default", Json::Number(p.default)),
                ("effect", p.effect.map_or(Json::Null, Json::text)),
            ])
        };
        let named = |name: &str, unit: &str| Json::object([("name", Json::text(name)), ("unit", Json::text(unit))]);
        Json::object([
            ("name", Json::text(info.name)),
            ("documentation", Json::text(info.documentation.trim())),
            ("effects", names(info.effects)),
            ("bodies", Json::list(info.bodies.iter().map(|body| Json::text(*body)))),
            ("parameters", Json::list(info.parameters.iter().map(parameter))),
            ("counts", counts_json(info)),
            ("inputs", Json::list(info.inputs.iter().map(|input| named(input.name, input.unit)))),
            ("outputs", Json::list(info.outputs.iter().map(|output| named(output.name, output.unit)))),
            ("coordinates", Json::Count(info.n_coordinates() as u64)),
            ("position_rows", Json::Count(info.n_position_rows as u64)),
            ("velocity_rows", Json::Count((info.n_rows() - info.n_position_rows) as u64)),
            ("freedom", Json::Count(freedom(info) as u64)),
            ("until", Json::Number(info.until_s)),
        ])
    };
    Json::object([
        ("name", Json::text(model.name)),
        ("documentation", Json::text(model.documentation.trim())),
        ("effects", names(model.effects)),
        ("scenes", Json::list(model.scenes.iter().map(|entry| scene((entry.info)())))),
    ])
}
