//! Every model by name: what the command line and the generic tests go through.

use ezy_cli::Selection;
use ezy_core::model::ModelInfo;
use ezy_core::record::UnknownName;

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

/// Finds `MODEL` or `MODEL/SCENE`; case and underscores do not matter.
///
/// # Errors
/// [`UnknownName`] with the nearest model or scene.
pub fn find(path: &str) -> Result<Selection, UnknownName> {
    ezy_cli::find(MODELS, path)
}
