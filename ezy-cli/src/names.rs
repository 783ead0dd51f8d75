//! Names that the command line gives values to.

use ezy_core::model::{ModelInfo, ParameterInfo, Scene, SceneEntry, SceneInfo};
use ezy_core::record::{UnknownName, find_name, input_index};

use super::Models;
use super::failure::Failure;
use super::leads::assignment_of;
use super::quantity;
use super::selection::{find, path};
use super::value::Assignment;

/// The name of what has several rows: `motor` of `motor.x`.
#[cfg(feature = "analysis")]
pub(super) fn base(row: &str) -> &str {
    row.rsplit_once('.').map_or(row, |(base, _)| base)
}

/// A name that is given two values has none.
fn refuse_twice(option: &str, assignments: &[Assignment]) -> Result<(), Failure> {
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

/// The scene that `MODEL/SCENE` names.
pub(super) fn scene_entry(
    models: Models<'_>,
    text: &str,
) -> Result<(&'static ModelInfo, &'static SceneEntry), Failure> {
    let selection = find(models, text)?;
    let model = selection.model;
    let entry = selection.scene.ok_or_else(|| {
        let scenes: Vec<String> = model.scenes.iter().map(|entry| path(model, entry)).collect();
        Failure::wrong_use(format!("`{text}` names no scene; run one of: {}", scenes.join(", ")))
    })?;
    Ok((model, entry))
}

/// A scene with its parameters and counts set.
pub(super) fn scene_with(model: &ModelInfo, entry: &SceneEntry, set: &[Assignment]) -> Result<Box<dyn Scene>, Failure> {
    refuse_twice("--set", set)?;
    let mut scene = (entry.new)();
    for assignment in set {
        match (entry.info)().counts().iter().position(|count| count.name == assignment.name) {
            Some(i) => scene.set_count(i, whole_number(assignment)?),
            None => scene.set_parameter(parameter(model, entry, &assignment.name)?, assignment.value),
        }
    }
    Ok(scene)
}

/// Counts up to here are exact as numbers typed with a point or a power of ten.
const LARGEST_COUNT: f64 = 1e15;

/// The value of a count: `--set n=1000`.
pub(super) fn whole_number(assignment: &Assignment) -> Result<usize, Failure> {
    let (name, value) = (&assignment.name, assignment.value);
    if value.fract() == 0.0 && (1.0..=LARGEST_COUNT).contains(&value) {
        return Ok(value as usize);
    }
    Err(Failure::wrong_use(format!("`{name}` is a count, but was given {value}; give it a whole number from 1 on")))
}

/// The parameter or count of a scene by its name.
fn parameter(model: &ModelInfo, entry: &SceneEntry, name: &str) -> Result<usize, Failure> {
    let info = (entry.info)();
    let parameters = info.parameters.iter().map(|parameter| parameter.name);
    let known = parameters.chain(info.counts().iter().map(|count| count.name));
    find_name("parameter", name, known).map_err(|unknown| {
        let units = info.parameters.iter().map(|parameter| (parameter.name, parameter.unit));
        of_another_option(&info, "--set", name)
            .or_else(|| of_the_unit(&unknown, units))
            .unwrap_or_else(|| of_another_scene(model, entry, unknown, |info| info.parameters))
    })
}

/// A name that another option gives its value to.
fn of_another_option(info: &SceneInfo, option: &str, name: &str) -> Option<Failure> {
    let right = assignment_of(name, info).filter(|right| *right != option)?;
    Some(Failure::wrong_use(format!("`{option} {name}`: write {right} {name}=VALUE")))
}

/// A word for a quantity, such as `mass`, with the names in its unit.
fn of_the_unit<'n>(unknown: &UnknownName, names: impl Iterator<Item = (&'n str, &'n str)> + Clone) -> Option<Failure> {
    let (unit, names) = quantity::alike(&unknown.name, names)?;
    let UnknownName { kind, name, known, .. } = unknown;
    let (names, known) = (names.join(", "), known.join(", "));
    Some(Failure::wrong_use(format!("{kind} `{name}` is not known; in {unit}: {names}; all: {known}")))
}

/// That no start value or input is given twice, and that inputs exist.
pub(super) fn check_assignments(
    model: &ModelInfo,
    entry: &SceneEntry,
    start: &[Assignment],
    input: &[Assignment],
) -> Result<(), Failure> {
    refuse_twice("--start", start)?;
    refuse_twice("--input", input)?;
    let info = (entry.info)();
    let elsewhere = start.iter().find_map(|assignment| of_another_option(&info, "--start", &assignment.name));
    elsewhere.map_or(Ok(()), Err)?;
    input.iter().try_for_each(|assignment| check_input(model, entry, &assignment.name))
}

/// That an input exists.
pub(super) fn check_input(model: &ModelInfo, entry: &SceneEntry, name: &str) -> Result<(), Failure> {
    let info = (entry.info)();
    let wrong = |unknown| {
        let elsewhere = of_another_option(&info, "--input", name);
        elsewhere.unwrap_or_else(|| of_another_scene(model, entry, unknown, |info| info.inputs))
    };
    input_index(&info, name).map(|_| ()).map_err(wrong)
}

/// What is not known here may belong to an effect that other scenes call for.
fn of_another_scene(
    model: &ModelInfo,
    entry: &SceneEntry,
    unknown: UnknownName,
    declared: fn(&SceneInfo) -> &'static [ParameterInfo],
) -> Failure {
    let (kind, name) = (unknown.kind, unknown.name.as_str());
    let effect_in = |other: &SceneEntry| declared(&(other.info)()).iter().find(|known| known.name == name)?.effect;
    let paths = model.scenes.iter().filter(|other| effect_in(other).is_some()).map(|other| path(model, other));
    let paths: Vec<String> = paths.collect();
    let Some(effect) = model.scenes.iter().find_map(effect_in) else { return unknown.into() };
    Failure::wrong_use(format!(
        "{kind} `{name}` belongs to effect `{effect}`, which {} does not call for; run one that does: {}",
        path(model, entry),
        paths.join(", ")
    ))
}
