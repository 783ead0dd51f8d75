//! Every model by name: what the command line and the generic tests go through.

use ezy_core::model::{ModelInfo, SceneEntry};
use ezy_core::record::{UnknownName, find_name};

/// All models, in the order in which they are listed.
pub static MODELS: &[&ModelInfo] = &[
    &crate::ezy_roller::MODEL,
    &crate::roller_racer::MODEL,
    &crate::snakeboard::MODEL,
    &crate::skateboard::MODEL,
    &crate::chaplygin_sleigh::MODEL,
    &crate::knife_edge::MODEL,
    &crate::tractor_trailers::MODEL,
    &crate::road_train::MODEL,
    &crate::differential_robot::MODEL,
    &crate::single_track_car::MODEL,
    &crate::wheeled_snake::MODEL,
    &crate::pendulum::MODEL,
    &crate::double_pendulum::MODEL,
    &crate::slider_crank::MODEL,
    &crate::four_bar::MODEL,
    &crate::andrews::MODEL,
    &crate::chain::MODEL,
    &crate::n_four_bar::MODEL,
    &crate::hanging_net::MODEL,
];

/// What `MODEL` or `MODEL/SCENE` means.
#[derive(Debug, Clone, Copy)]
pub struct Selection {
    /// The model.
    pub model: &'static ModelInfo,
    /// The scene, when one was named.
    pub scene: Option<&'static SceneEntry>,
}

/// Finds `MODEL` or `MODEL/SCENE`; case and underscores do not matter.
///
/// # Errors
/// [`UnknownName`] with the nearest model or scene.
pub fn find(path: &str) -> Result<Selection, UnknownName> {
    let (model, scene) = path.split_once('/').map_or((path, None), |(model, scene)| (model, Some(scene)));
    let model = MODELS[position("model", model, MODELS.iter().map(|m| m.name))?];
    let Some(scene) = scene else { return Ok(Selection { model, scene: None }) };
    let i = position("scene", scene, model.scenes.iter().map(|s| s.name))?;
    Ok(Selection { model, scene: Some(&model.scenes[i]) })
}

/// How a model or scene is typed: `EzyRoller` as `ezyroller`.
pub fn typed(name: &str) -> String {
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
