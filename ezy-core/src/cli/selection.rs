//! Models and scenes by the names that are typed.

use super::Models;
use crate::model::{ModelInfo, SceneEntry};
use crate::record::{UnknownName, find_name};

/// What `MODEL` or `MODEL/SCENE` means.
#[derive(Debug, Clone, Copy)]
pub struct Selection {
    /// The model.
    pub model: &'static ModelInfo,
    /// The scene, when one was named.
    pub scene: Option<&'static SceneEntry>,
}

/// Finds `MODEL` or `MODEL/SCENE` among `models`; case, underscores and hyphens do not matter.
///
/// # Errors
/// [`UnknownName`] with the nearest model or scene.
pub fn find(models: &[&'static ModelInfo], path: &str) -> Result<Selection, UnknownName> {
    let (model, scene) = path.split_once('/').map_or((path, None), |(model, scene)| (model, Some(scene)));
    let model = models[position("model", model, models.iter().map(|m| m.name))?];
    let Some(scene) = scene else { return Ok(Selection { model, scene: None }) };
    let i = position("scene", scene, model.scenes.iter().map(|s| s.name))?;
    Ok(Selection { model, scene: Some(&model.scenes[i]) })
}

/// How a model or scene is typed: `EzyRoller` as `ezyroller`.
pub(super) fn typed(name: &str) -> String {
    name.to_lowercase()
}

fn position(kind: &'static str, name: &str, known: impl Iterator<Item = &'static str>) -> Result<usize, UnknownName> {
    let bare = |name: &str| name.to_lowercase().replace(['_', '-'], "");
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
