//! The equations of a scene as source text of another language, one file without a dependency on EZY.
//!
//! The kernels of a scene run once on [`Recorded`] numbers; what they computed is printed by one family of printers, so
//! that a file computes what a run computes. It knows nothing of runs: how a start is assembled, how rows are switched and how steps are made
//! is left to whoever calls it.

mod c;
mod expression;
pub mod fmu;
mod head;
mod identifiers;
mod julia;
mod kernels;
mod language;
mod matlab;
mod python;
mod recorder;
mod script;
mod statements;

pub use head::file_name;
pub use language::Language;

use crate::dynamics::{MotionError, RankLoss, System, SystemError};
use crate::linalg::Backend;
use crate::model::{Equations, Scene, SceneInfo};
use crate::scalar::Recorded;
use kernels::Kernels;
use std::sync::Arc;

/// Unknowns up to which a scene is exported: its equations are written out, and may be solved as a full matrix.
const LARGEST_N_UNKNOWNS: usize = 300;

/// Why a scene has no source text.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// Its equations cannot be recorded.
    #[error(
        "scene `{scene}` is written by hand for numbers of its own; implement `Derived::recorded` for it, or write it with `model!`"
    )]
    NotRecorded {
        /// Its name.
        scene: &'static str,
    },
    /// Too many equations to be written out.
    #[error("scene `{scene}` has {n} unknowns; at most {LARGEST_N_UNKNOWNS} are written out: set smaller counts")]
    TooLarge {
        /// Its name.
        scene: &'static str,
        /// Accelerations and multipliers.
        n: usize,
    },
    /// Rows that follow from others: a run chooses which of them bear, a formula cannot.
    #[error(
        "constraints of scene `{scene}` depend on each other where it starts ({loss}), so that multipliers are not determined; leave the redundant ones out, or start elsewhere"
    )]
    Dependent {
        /// Its name.
        scene: &'static str,
        /// Which.
        loss: RankLoss,
    },
    /// Rows that a run switches, which a unit of other tools does not.
    #[error(
        "row `{row}` of scene `{scene}` holds or lets go as a run decides, which an FMU cannot do; leave the limit or the stop out, or drive EZY by a stepper"
    )]
    Switched {
        /// Its name.
        scene: &'static str,
        /// The row.
        row: String,
    },
    /// An input that a run integrates.
    #[error(
        "input `{input}` of scene `{scene}` is given by its acceleration, which a run integrates; an FMU takes inputs that act at once"
    )]
    IntegratedInput {
        /// Its name.
        scene: &'static str,
        /// The input.
        input: &'static str,
    },
    /// Parameters that no run takes.
    #[error(transparent)]
    System(#[from] SystemError),
    /// No accelerations at the start.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// Where a file says that the scene starts: assembled values of `n_q` coordinates and `n_v` velocities.
#[derive(Debug, Clone, Copy)]
pub struct Start<'s> {
    /// Time, s.
    pub t: f64,
    /// Coordinates, m and rad.
    pub q: &'s [f64],
    /// Velocities, m/s and rad/s.
    pub v: &'s [f64],
}

/// What printers know of a scene.
struct Source<'s> {
    info: Arc<SceneInfo>,
    /// Values of the parameters, then those that the switches start with.
    parameters: Vec<f64>,
    start: Start<'s>,
    kernels: Kernels,
}

/// The equations of `scene` in `language`: constants from parameters, masses, constraints, Jacobian, convective terms, forces, accelerations with
/// multipliers, rates of first-order states, outputs; and its names, units and values.
///
/// # Errors
/// [`ExportError`] for a scene that cannot be recorded, is too large or has dependent rows at its start.
pub fn source(scene: &dyn Scene, language: Language, start: Start<'_>) -> Result<String, ExportError> {
    prepared(scene, start).map(|(source, _)| language.print(&source))
}

/// What printers know of `scene`, and its equations.
fn prepared<'s>(
    scene: &'s dyn Scene,
    start: Start<'s>,
) -> Result<(Source<'s>, &'s dyn Equations<Recorded>), ExportError> {
    let info = scene.info();
    let equations = scene.recorded().ok_or(ExportError::NotRecorded { scene: info.name })?;
    if info.n_unknowns() > LARGEST_N_UNKNOWNS {
        return Err(ExportError::TooLarge { scene: info.name, n: info.n_unknowns() });
    }
    let is_eliminated = eliminates(scene, &info, start)?;
    let kernels = Kernels::of(&info, equations, is_eliminated);
    Ok((Source { info, parameters: scene.parameters(), start, kernels }, equations))
}

/// Whether the generated elimination solves at the start: not where a body has no mass, or the scene no elimination.
fn eliminates(scene: &dyn Scene, info: &SceneInfo, start: Start<'_>) -> Result<bool, ExportError> {
    let mut system = System::new(scene, Backend::Dense)?;
    let (mut a, mut multipliers) = (vec![0.0; info.n_velocities()], vec![0.0; info.n_rows()]);
    let solved = system.accelerations(start.t, start.q, start.v, &mut a, &mut multipliers)?;
    if solved.is_rank_deficient {
        return Err(ExportError::Dependent { scene: info.name, loss: system.rank_loss(start.t, start.q) });
    }
    let mut at_pivots = |c: &[f64]| scene.accelerations(c, start.t, start.q, start.v, &mut a, &mut multipliers);
    Ok(info.has_elimination() && at_pivots(system.fixed()).all_keep())
}
