//! Models and scenes by the names that are typed.

use std::path::Path;

use super::Models;
use ezy_core::model::{ModelInfo, SceneEntry};
use ezy_core::record::{UnknownName, find_name};

/// What `MODEL` or `MODEL/SCENE` means.
#[derive(Debug, Clone, Copy)]
pub struct Selection {
    /// The model.
    pub model: &'static ModelInfo,
    /// The scene, when one was named.
    pub scene: Option<&'static SceneEntry>,
}

/// How a scene is typed.
pub(super) fn path(model: &ModelInfo, entry: &SceneEntry) -> String {
    format!("{}/{}", typed(model.name), entry.name)
}

/// Finds `MODEL` or `MODEL/SCENE` among `models`; case, underscores and hyphens do not matter.
///
/// # Errors
/// [`UnknownName`] with the nearest model or scene; a scene without its model with the models that have it.
pub fn find(models: &[&'static ModelInfo], path: &str) -> Result<Selection, UnknownName> {
    let (model, scene) = path.split_once('/').map_or((path, None), |(model, scene)| (model, Some(scene)));
    let found = position("model", model, models.iter().map(|m| m.name));
    let model = models[found.map_err(|unknown| with_scenes(models, path, unknown))?];
    let Some(scene) = scene else { return Ok(Selection { model, scene: None }) };
    let i = position("scene", scene, model.scenes.iter().map(|s| s.name))?;
    Ok(Selection { model, scene: Some(&model.scenes[i]) })
}

/// The models with their scenes that an optional `MODEL[/SCENE]` selects: all without one.
///
/// # Errors
/// Those of [`find`].
pub(super) fn selected(
    models: Models<'_>,
    path: Option<&str>,
) -> Result<Vec<(&'static ModelInfo, Vec<&'static SceneEntry>)>, UnknownName> {
    let all = |model: &'static ModelInfo| (model, model.scenes.iter().collect());
    let Some(path) = path else { return Ok(models.iter().map(|model| all(model)).collect()) };
    let Selection { model, scene } = find(models, path)?;
    Ok(vec![scene.map_or_else(|| all(model), |scene| (model, vec![scene]))])
}

/// Leads from what is no model to scenes: from `coast` to `ezyroller/coast`, from `ezyroller.coast` to the same; from a file to its model.
fn with_scenes(models: &[&'static ModelInfo], path: &str, unknown: UnknownName) -> UnknownName {
    let all = models.iter().flat_map(|model| model.scenes.iter().map(|scene| (model.name, scene.name)));
    let is_meant =
        |(model, scene): &(&str, &str)| [bare(scene), bare(&format!("{model}{scene}"))].contains(&bare(path));
    let meant: Vec<String> = all.filter(is_meant).map(|(model, scene)| format!("{}/{scene}", typed(model))).collect();
    let stem = Path::new(path).file_stem().map(|stem| bare(&stem.to_string_lossy()));
    let of_file = models.iter().find(|model| path.ends_with(".rs") && stem.as_deref() == Some(&*bare(model.name)));
    if let Some(model) = of_file {
        return UnknownName { name: path.to_owned(), nearest: Some(typed(model.name)), ..unknown };
    }
    match meant.first() {
        Some(first) => UnknownName { nearest: Some(first.clone()), known: meant, ..unknown },
        None => unknown,
    }
}

/// A name without what does not matter.
fn bare(name: &str) -> String {
    name.to_lowercase().replace(|c: char| !c.is_alphanumeric(), "")
}

/// How a model or scene is typed: `EzyRoller` as `ezyroller`.
pub(super) fn typed(name: &str) -> String {
    name.to_lowercase()
}

fn position(kind: &'static str, name: &str, known: impl Iterator<Item = &'static str>) -> Result<usize, UnknownName> {
    let known: Vec<String> = known.map(typed).collect();
    match known.iter().position(|k| bare(k) == bare(name)) {
        Some(i) => Ok(i),
        None => find_name(kind, &name.to_lowercase(), known.iter().map(String::as_str)),
    }
}

/// The first scene of the program, for examples.
pub(super) fn first_scene(models: Models<'_>) -> Option<(&'static ModelInfo, &'static SceneEntry)> {
    models.iter().find_map(|&model| Some((model, model.scenes.first()?)))
}
