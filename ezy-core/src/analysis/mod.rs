//! Where a scene rests or runs steadily, and what becomes of small deviations from that.
//!
//! | | |
//! |---|---|
//! | [`SteadyMotion`] | rest, or motion that is constant seen from a frame that travels and turns evenly; found from a start |
//! | [`Linearization`] | x' = A x + B u, y = C x + D u about it, on the manifold of the constraints |
//! | [`Spectrum`] | eigenvalues, with those that are zero told apart |
//!
//! Derivatives are exact ([`Gradients`](crate::dynamics::Gradients)). Knows nothing of steps and of files.

mod error;
mod frame;
mod linearization;
mod spectrum;
mod steady_motion;
#[cfg(test)]
mod tests;
mod tolerances;

pub use error::AnalysisError;
pub use frame::Frame;
pub use linearization::Linearization;
pub use spectrum::Spectrum;
pub use steady_motion::SteadyMotion;
