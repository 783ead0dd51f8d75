//! The scenes: EZY's model files, the same equations by hand, and where the motion ends.

mod double_pendulum;
mod ezy_roller;
mod slider_crank;

#[path = "../../../../models/src/mechanisms/double_pendulum.rs"]
mod double_pendulum_model;
#[path = "../../../../models/src/vehicles/ezy_roller.rs"]
mod ezy_roller_model;
#[path = "../../../../models/src/mechanisms/slider_crank.rs"]
mod slider_crank_model;

pub use double_pendulum::double_pendulum;
pub use double_pendulum_model::double_pendulum::Swing;
pub use ezy_roller::{coast, driven};
pub use ezy_roller_model::ezy_roller::{Coast, Driven};
pub use slider_crank::slider_crank;
pub use slider_crank_model::slider_crank::Pushed;

use crate::right_side::{ByHand, N_Q, State};
use serde_json::Value;
use std::error::Error;

/// A scene without EZY.
pub struct Scene<const C: usize> {
    pub name: &'static str,
    pub start: State,
    pub until_s: f64,
    pub right_side: ByHand<C>,
    /// Coordinates at the end, from an independent reference.
    pub end: [f64; N_Q],
}

/// `tests/answers/<name>.json`.
fn answer(name: &str) -> Result<Value, Box<dyn Error>> {
    let path = format!("{}/../answers/{name}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    Ok(serde_json::from_str(&text)?)
}
