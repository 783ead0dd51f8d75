//! Names that the command line gives values to.

use ezy_core::model::{ModelInfo, SceneEntry, SceneInfo};
use ezy_core::record::{UnknownName, find_name, input_index};
use ezy_models::registry::typed;

use super::failure::Failure;
use super::value::Assignment;

/// A name that is given two values has none.
pub fn refuse_twice(option: &str, assignments: &[Assignment]) -> Result<(), Failure> {
    for (i, later) in assignments.iter().enumerate() {
        if let Some(earlier) = assignments[..i].iter().find(|earlier| earlier.name == later.name) {
            let (name, first, second) = (&later.name, earlier.value, later.value);
            return Err(Failure::wrong_use(format!(
                "`{option} {name}` is given twice, as {first} and as {second}; give it once"
            )));
        }
    }
    Ok(())
}

/// The parameter or count of a scene by its name.
pub fn parameter(model: &ModelInfo, entry: &SceneEntry, name: &str) -> Result<usize, Failure> {
    let info = (entry.info)();
    let parameters = info.parameters.iter().map(|parameter| parameter.name);
    let known = parameters.chain(info.counts().iter().map(|count| count.name));
    let declared = |info: &SceneInfo| info.parameters.iter().map(|p| (p.name, p.effect)).collect();
    find_name("parameter", name, known).map_err(|unknown| of_another_scene(model, entry, unknown, &declared))
}

/// That an input exists.
pub fn check_input(model: &ModelInfo, entry: &SceneEntry, name: &str) -> Result<(), Failure> {
    let declared = |info: &SceneInfo| info.inputs.iter().map(|i| (i.name, i.effect)).collect();
    let found = input_index((entry.info)(), name);
    found.map(|_| ()).map_err(|unknown| of_another_scene(model, entry, unknown, &declared))
}

/// Names with the effects that declare them.
type Declared = Vec<(&'static str, Option<&'static str>)>;

/// What is not known here may belong to an effect that other scenes call for; `declared` lists names with their effects.
fn of_another_scene(
    model: &ModelInfo,
    entry: &SceneEntry,
    unknown: UnknownName,
    declared: &dyn Fn(&SceneInfo) -> Declared,
) -> Failure {
    let (kind, name) = (unknown.kind, unknown.name.as_str());
    let effect_in = |other: &SceneEntry| {
        let all = declared((other.info)());
        all.into_iter().find(|(known, _)| *known == name).and_then(|(_, effect)| effect)
    };
    let others: Vec<&SceneEntry> = model.scenes.iter().filter(|other| effect_in(other).is_some()).collect();
    let Some(effect) = others.first().and_then(|other| effect_in(other)) else { return unknown.into() };
    let others: Vec<String> = others.iter().map(|other| path(model, other)).collect();
    Failure::wrong_use(format!(
        "{kind} `{name}` belongs to effect `{effect}`, which {} does not call for; run one that does: {}",
        path(model, entry),
        others.join(", ")
    ))
}

/// How a scene is typed.
pub fn path(model: &ModelInfo, entry: &SceneEntry) -> String {
    format!("{}/{}", typed(model.name), entry.name)
}
