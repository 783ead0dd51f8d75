//! Pictures of a scene at a state, made from its elements: bodies, joints, wheels, springs.
//!
//! A drawing is a list of parts. Each part is a piece of SVG that does not change, and a [`Motion`] that says where it is at a
//! state. So a sketch, the frames of a run and an animation show the same picture.

mod dimensions;
mod elements;
mod film;
#[cfg(feature = "figures")]
mod gif;
mod lettering;
mod outline;
mod parts;
#[cfg(feature = "figures")]
mod pieces;
#[cfg(feature = "figures")]
mod pixels;
mod sketch;
mod symbols;

pub use elements::{Anchor, Elements, Placed, Vector};
pub use film::Film;
pub use parts::{Drawing, Motion, Part};
pub use sketch::{sketch, sketch_within};

/// The looks of all parts, for a `style` element. Colours follow `color`.
pub const STYLE: &str = include_str!("drawing.css");

/// A number of pixels, to a hundredth.
pub(crate) fn number(x: f64) -> String {
    let rounded = (x * 100.0).round() / 100.0;
    if rounded == 0.0 { "0".to_owned() } else { rounded.to_string() }
}
