//! What an analysis cannot do.

use crate::dynamics::{MotionError, StartError, SystemError};
use crate::model::Name;
use thiserror::Error;

/// Why there is no result.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum AnalysisError {
    /// The scene cannot be computed, or has no exact derivatives.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The start that was given cannot be assembled.
    #[error("the start cannot be assembled: {0}")]
    Start(#[from] StartError),
    /// The equations of motion cannot be solved there.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A scene with bodies in space.
    #[error("scene `{scene}` has bodies in space; steady motions are found of planar bodies")]
    Spatial {
        /// Name of the scene.
        scene: &'static str,
    },
    /// A name that is held is no unknown of the scene.
    #[error(
        "`{name}` is no coordinate, no first-order state and, where scene `{scene}` moves, no velocity of it: it cannot be held"
    )]
    UnknownHeld {
        /// Name of the scene.
        scene: &'static str,
        /// The name.
        name: String,
    },
    /// What is left after the last step of the search.
    #[error(
        "no steady motion was found near the start of scene `{scene}`: {left:.3e} {unit} are left of {what} after {steps} steps; \
         take a start that is nearer, or look at what `{what}` should be balanced by"
    )]
    NotFound {
        /// Name of the scene.
        scene: &'static str,
        /// The equation that is left most, by its coordinate, row or state.
        what: Name,
        /// What is left of it.
        left: f64,
        /// Unit of that.
        unit: &'static str,
        /// How many steps were made.
        steps: usize,
    },
    /// The motion is no steady one: seen from the frame, what is linearised changes.
    #[error(
        "the motion of scene `{scene}` is not steady: seen from its frame it changes by {change:.1e} of its rates; \
         a force or a row depends on the time, the place or the heading"
    )]
    NotSteady {
        /// Name of the scene.
        scene: &'static str,
        /// Share of the largest rate.
        change: f64,
    },
    /// A name that the scene does not have.
    #[error("scene `{scene}` has no {kind} `{name}`; it has {known}")]
    Unknown {
        /// Name of the scene.
        scene: &'static str,
        /// What it should be the name of.
        kind: &'static str,
        /// The name.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A value whose change no steady motion next to the first one follows.
    #[error(
        "scene `{scene}` has no steady motion with another value of `{name}` next to the first one: something else fixes it, or the branch \
         folds there; begin at another value, or hold something else"
    )]
    CannotVary {
        /// Name of the scene.
        scene: &'static str,
        /// What should vary.
        name: String,
    },
    /// Inputs that are to take the place of drives are not as many as these.
    #[error("{n_inputs} inputs cannot take the place of {n_rows} rows; name one input for each row")]
    Unequal {
        /// Rows of the drives.
        n_rows: usize,
        /// Inputs.
        n_inputs: usize,
    },
    /// Inputs that do not determine the forces of drives.
    #[error(
        "at t = {t} s the inputs of scene `{scene}` do not determine the forces of the drives: two of them act alike, or one \
         does not act on what is driven, as in a singular position"
    )]
    Alike {
        /// Name of the scene.
        scene: &'static str,
        /// Time, s.
        t: f64,
    },
    /// Rest and steady motions are beyond the stop of a scene, or it would have to pull.
    #[error(
        "scene `{scene}` has no steady motion near its start: without the stop `{stop}` it would be beyond it, and on an end the stop would have to pull"
    )]
    BeyondStop {
        /// Name of the scene.
        scene: &'static str,
        /// Name of the stop.
        stop: &'static str,
    },
    /// A skate would have to hold more than its limit.
    #[error(
        "the steady motion near the start of scene `{scene}` takes {force:.6e} N of skate `{skate}`, which holds {limit:.6e} N: it slides; take another \
         start, or a higher limit"
    )]
    Slides {
        /// Name of the scene.
        scene: &'static str,
        /// Name of the skate.
        skate: &'static str,
        /// What it would have to hold, N.
        force: f64,
        /// Its limit, N.
        limit: f64,
    },
    /// No values of the inputs do what a drive does.
    #[error(
        "at t = {t} s no values of the inputs of scene `{scene}` do what `{drive}` does: {left:.3e} of its force are left; \
         begin with values that are nearer"
    )]
    Unbalanced {
        /// Name of the scene.
        scene: &'static str,
        /// Time, s.
        t: f64,
        /// The row of which most is left.
        drive: Name,
        /// Its multiplier.
        left: f64,
    },
    /// What drives leave free moves differently with inputs in their place.
    #[error(
        "at t = {t} s the rate of `{name}` of scene `{scene}` changes by {with_inputs:.6e} a second with the inputs and by {with_drives:.6e} with \
         the drives: what the drives leave free moves differently; name inputs that act where the drives do, or prescribe the rest, too"
    )]
    OtherMotion {
        /// Name of the scene.
        scene: &'static str,
        /// Time, s.
        t: f64,
        /// The velocity that differs most.
        name: Name,
        /// Its rate with the inputs.
        with_inputs: f64,
        /// Its rate with the drives.
        with_drives: f64,
    },
    /// A motion that does not come back.
    #[error(
        "no periodic motion was found near the start of scene `{scene}`: after {period} s and {steps} steps of the search `{what}` is {left:.3e} {unit} \
         away from its start; take a start or a period that is nearer, such as the end of a longer run"
    )]
    NoReturn {
        /// Name of the scene.
        scene: &'static str,
        /// The coordinate, velocity or state that is farthest from its start.
        what: Name,
        /// How far.
        left: f64,
        /// Unit of that.
        unit: &'static str,
        /// The period of the last run, s.
        period: f64,
        /// Steps of the search.
        steps: usize,
    },
    /// Forces or rows of another period, or of any, where none was given.
    #[error("the equations of scene `{scene}` depend on time{how}: give the period of what drives it")]
    TimeDependent {
        /// Name of the scene.
        scene: &'static str,
        /// In which way that is at odds with the period.
        how: String,
    },
    /// The search ended where nothing moves.
    #[error(
        "the search from the start of scene `{scene}` ends in a rest, of which any period is one; take a start that is farther from it"
    )]
    AtRest {
        /// Name of the scene.
        scene: &'static str,
    },
    /// No length of time.
    #[error("a period of {period} s is none; give one above zero")]
    Period {
        /// What was given, s.
        period: f64,
    },
    /// States that are not those of a period in whole steps.
    #[error(
        "{n_states} states of scene `{scene}` are no period in whole steps; take those at the times of `Monodromy::times`"
    )]
    NoPeriod {
        /// Name of the scene.
        scene: &'static str,
        /// How many states were given.
        n_states: usize,
    },
    /// Axes over which there is no workspace.
    #[error("a workspace is over one or two coordinates, each once, with two or more ascending values; change {what}")]
    Axes {
        /// What is wrong.
        what: String,
    },
    /// Drives fix what a workspace should be over.
    #[error("in scene `{scene}` `{names}` cannot take other values: they are prescribed by {rows}; leave that out")]
    Prescribed {
        /// Name of the scene.
        scene: &'static str,
        /// The coordinates.
        names: String,
        /// Drives, as they may be left out.
        rows: String,
    },
    /// Rows fix what a workspace should be over, or do so where the start is.
    #[error(
        "in scene `{scene}` `{names}` cannot take other values next to the start: the constraints fix them, or the start is a singular \
         position; take other coordinates, or another start"
    )]
    Fixed {
        /// Name of the scene.
        scene: &'static str,
        /// The coordinates.
        names: String,
    },
    /// More moves than what a workspace is over.
    #[error(
        "scene `{scene}` has {n_free} degrees of freedom in position at its start, and values are given for {n_axes}: what is left moves freely; \
         hold {names}, or as many others, or begin elsewhere where the start is a singular position"
    )]
    Undetermined {
        /// Name of the scene.
        scene: &'static str,
        /// Degrees of freedom.
        n_free: usize,
        /// Coordinates that are given values.
        n_axes: usize,
        /// Coordinates that could be held.
        names: String,
    },
    /// Equations or slopes that have no value at a place.
    #[error(
        "the equations of scene `{scene}`, or their slopes, are not finite at its start; take another start, or a law that has a slope there"
    )]
    NotFinite {
        /// Name of the scene.
        scene: &'static str,
    },
    /// Eigenvalues were not found.
    #[error("the eigenvalues of scene `{scene}` were not found: an entry of its matrix is not finite")]
    NoEigenvalues {
        /// Name of the scene.
        scene: &'static str,
    },
}
