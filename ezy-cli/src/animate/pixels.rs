//! Frames as pixels. Without the feature `figures`, how to get them.

use crate::failure::Failure;
use ezy_study::report::drawing::Film;

/// A picture that moves.
#[cfg(feature = "figures")]
pub(super) fn gif(film: &Film<'_>, seconds: f64, width: u32) -> Result<Vec<u8>, Failure> {
    film.gif(seconds, width).ok_or_else(|| too_large(width))
}

/// A frame.
#[cfg(feature = "figures")]
pub(super) fn png(film: &Film<'_>, frame: usize, width: u32) -> Result<Vec<u8>, Failure> {
    film.png(frame, width).ok_or_else(|| too_large(width))
}

#[cfg(feature = "figures")]
fn too_large(width: u32) -> Failure {
    Failure::wrong_use(format!("a picture {width} pixels wide is too high for a file; give a smaller --width"))
}

#[cfg(not(feature = "figures"))]
pub(super) fn gif(_: &Film<'_>, _: f64, _: u32) -> Result<Vec<u8>, Failure> {
    crate::drawing::check().map(|()| Vec::new())
}

#[cfg(not(feature = "figures"))]
pub(super) fn png(_: &Film<'_>, _: usize, _: u32) -> Result<Vec<u8>, Failure> {
    crate::drawing::check().map(|()| Vec::new())
}
