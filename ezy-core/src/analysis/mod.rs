//! Where a scene rests or runs steadily, what becomes of small deviations from that, and which torques a motion takes.
//!
//! | | |
//! |---|---|
//! | [`SteadyMotion`] | rest, or motion that is constant seen from a frame that travels and turns evenly; found from a start |
//! | [`Rests`] | all rests that starts over full turns lead to |
//! | [`BifurcationDiagram`] | steady motions over a value that varies: folds, branch points, changes of stability |
//! | [`Linearization`] | x' = A x + B u, y = C x + D u about it, on the manifold of the constraints |
//! | [`Spectrum`] | eigenvalues, with those that are zero told apart |
//! | [`PeriodicMotion`] | a motion that comes back to itself, or, as a gait, to itself seen from another place; found from a start |
//! | [`Monodromy`] | what a period of a motion makes of small deviations: Floquet multipliers |
//! | [`InverseDynamics`] | inputs in place of drives: the torques that a prescribed motion takes |
//! | [`Mode`] | an eigenvalue with its eigenvector: damping, frequency, what moves |
//! | [`Transfer`] | the response of one output to one input: poles, zeros, margins, Bode plots |
//! | [`Workspace`] | which values of one or two coordinates a mechanism reaches, and where it is singular |
//! | [`Locus`] | eigenvalues over a value that varies, and the critical values at which stability changes |
//!
//! Derivatives are exact ([`Gradients`]). Knows nothing of steps and of files.

mod bifurcation;
mod bode;
mod curve;
mod curve_meetings;
mod eigenvectors;
mod error;
mod frame;
mod inverse_dynamics;
mod linearization;
mod locus;
mod margins;
mod mode;
mod monodromy;
mod newton;
mod one_sided;
mod orientation;
mod periodic_motion;
mod position_curve;
mod position_rows;
mod realization;
mod relaxation;
mod rests;
mod return_map;
mod root;
mod row_space;
mod scaling;
mod spectrum;
mod steady_equations;
mod steady_motion;
mod swing;
mod symmetry;
#[cfg(test)]
mod tests;
mod tolerances;
mod transfer;
mod workspace;
mod workspace_branch;
mod workspace_curve;
mod workspace_grid;

pub use bifurcation::{Bifurcation, BifurcationDiagram, Branch, BranchEnd, BranchPoint};
pub use bode::BodePoint;
pub use error::AnalysisError;
pub use frame::Frame;
pub use inverse_dynamics::{InverseDynamics, Required};
pub use linearization::Linearization;
pub use locus::{CriticalValue, Instability, Locus};
pub use margins::AtFrequency;
pub use mode::Mode;
pub use monodromy::Monodromy;
pub use periodic_motion::{Period, PeriodicMotion, Stability, Trivial};
pub use rests::{Rest, Rests};
pub use spectrum::Spectrum;
pub use steady_motion::{Course, SteadyMotion};
pub use swing::Swing;
pub use transfer::Transfer;
pub use workspace::{Axis, Workspace};
pub use workspace_branch::{AssemblyBranch, Limit, ReachEnd, SingularPosition, Singularity};

use crate::dynamics::{By, Gradients, Of, OperatingPoint};
use crate::model::SceneRef;
use nalgebra::DMatrix;

/// The derivatives of `of` by `by` as a matrix.
fn derivatives<P: SceneRef>(gradients: &mut Gradients<P>, at: &OperatingPoint<'_>, of: Of, by: By) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(gradients.n_rows(of), gradients.n_columns(by));
    gradients.write(at, of, by, matrix.as_mut_slice());
    matrix
}
