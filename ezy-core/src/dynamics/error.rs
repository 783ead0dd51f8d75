//! What can go wrong at one state.

use super::MovedValue;
use super::tolerances::report::MAX_LISTED;
use crate::linalg::SparseKktError;
use crate::model::{LayoutFault, Name};
use crate::scalar::{legible, legible_time};

/// A system cannot be set up with these numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SystemError {
    /// A parameter is NaN or infinite.
    #[error("parameter `{name}` is {value}; give it a finite value")]
    ParameterNotFinite {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A mass or inertia is negative, infinite or not a number.
    #[error("the {quantity} of body `{body}` is {}; it must be finite and not negative", legible(*.value))]
    Mass {
        /// Name of the body.
        body: Name,
        /// `mass` or `inertia`.
        quantity: &'static str,
        /// Its value, kg or kg·m².
        value: f64,
    },
    /// The chosen backend divides by masses, and one is zero.
    #[error(
        "the {quantity} of body `{body}` is zero, which the {backend} backend cannot solve with; use `auto` or `dense`"
    )]
    BackendNeedsMass {
        /// Name of the body.
        body: Name,
        /// `mass` or `inertia`.
        quantity: &'static str,
        /// `generated` or `sparse`.
        backend: &'static str,
    },
    /// Products of levers over masses leave the numbers that the generated elimination can work with.
    #[error("levers and masses of scene `{scene}` are too far apart for the generated backend; use `auto` or `dense`")]
    OutOfRange {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The sparse backend could not be prepared.
    #[error(transparent)]
    Sparse(#[from] SparseKktError),
    /// Only the dense backend solves with massless bodies, and there are too many equations for it.
    #[error(
        "the {quantity} of body `{body}` is zero, and a system of {n} equations is too large for the dense backend \
         (at most {limit}), the only one that solves with massless bodies; give it a mass and an inertia, or give \
         smaller counts"
    )]
    MasslessInLargeScene {
        /// Name of the body.
        body: Name,
        /// `mass` or `inertia`.
        quantity: &'static str,
        /// Number of equations.
        n: usize,
        /// Largest number for the dense backend.
        limit: usize,
    },
    /// There is no sparse backend, and it was asked for, or the scene has counts, or a body in more than 24 rows, and too many
    /// equations for the dense backend.
    #[error(
        "scene `{scene}` is solved by sparse factors, and `ezy-core` is built without them; add \"sparse\" to its features in Cargo.toml"
    )]
    WithoutSparse {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The scene has no kernels on numbers with derivatives ([`Derived::with_derivatives`](crate::model::Derived::with_derivatives)).
    #[cfg(feature = "analysis")]
    #[error(
        "scene `{scene}` has no exact derivatives: its equations are those of `f64` alone; write them for any `Scalar` and let \
         `Derived::with_derivatives` return `Some(self)`"
    )]
    WithoutDerivatives {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The dense backend was asked for with too many equations.
    #[error("a system of {n} equations is too large for the dense backend (at most {limit}); use `auto` or `sparse`")]
    TooLargeForDense {
        /// Number of equations.
        n: usize,
        /// Largest number that is accepted.
        limit: usize,
    },
    /// A scene with counts, or with a body that is in many rows, has no generated elimination.
    #[error(
        "scene `{scene}` has no generated elimination: it has counts, or a body of it is in many rows; use `auto`, \
         `sparse` or `dense`"
    )]
    NoElimination {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The counts make no scene.
    #[error(transparent)]
    Layout(#[from] LayoutFault),
}

/// The motion cannot be continued from a state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// Constraints depend on each other and ask for different things.
    #[error(
        "constraints contradict each other at t = {t} s: {}; the best solution leaves {residual:.3e} of {level} (tolerance \
         {tolerance:.1e}). Remove one of them, or make them agree", rows_or_unknown(.rows), t = legible_time(*.t)
    )]
    ContradictoryRows {
        /// Time, s.
        t: f64,
        /// Names of the rows that depend on each other.
        rows: Vec<Name>,
        /// `the positions`, `the velocities` or `the accelerations`.
        level: &'static str,
        /// What is left of the rows: the largest |C|; of velocities and accelerations the largest residual of a redundant row, scaled to
        /// one, as a share of the largest velocity or acceleration.
        residual: f64,
        /// What may be left.
        tolerance: f64,
    },
    /// Constraints depend on each other in one position, and not beside it: at rest there is no finite force that holds the mechanism, in
    /// motion no acceleration that leads on.
    #[error(
        "the position at t = {t} s is singular: constraints depend on each other there, and not beside it: {}; any motion leaves \
         {residual:.1e} of {level}. Start beside that position, or change the lengths that lead there", rows_or_unknown(.rows), t = legible_time(*.t)
    )]
    SingularPosition {
        /// Time, s.
        t: f64,
        /// Names of the rows that depend on each other.
        rows: Vec<Name>,
        /// `the positions`, `the velocities` or `the accelerations`.
        level: &'static str,
        /// What is left of the rows, as in [`MotionError::ContradictoryRows`].
        residual: f64,
    },
    /// Constraints nearly depend on each other, or numbers are so far apart that they seem to.
    #[error(
        "the motion at t = {t} s is lost in rounding{}: the best solution leaves {residual:.1e} of one equation. Bring \
         masses and lengths nearer to each other, or move away from a position where constraints depend on each other",
        nearly_dependent(.rows, *.smallest_pivot), t = legible_time(*.t)
    )]
    LostInRounding {
        /// Time, s.
        t: f64,
        /// Names of the rows that nearly depend on each other.
        rows: Vec<Name>,
        /// Square of the smallest pivot of G, rows scaled to one, where they do.
        smallest_pivot: Option<f64>,
        /// The largest share of the terms of an equation that is left.
        residual: f64,
    },
    /// Next to a position where constraints depend on each other, no step leads on.
    #[error(
        "the motion does not get past the position at t = {t} s, where constraints nearly depend on each other: {}; smallest pivot \
         {smallest_pivot:.1e}. {cause}. If the mechanism locks there, it is the geometry or a drive that has to change", rows_or_unknown(.rows), t = legible_time(*.t)
    )]
    LockedUp {
        /// Time of the last good state, s.
        t: f64,
        /// Names of the rows that nearly depend on each other.
        rows: Vec<Name>,
        /// Square of the smallest pivot of G, rows scaled to one.
        smallest_pivot: f64,
        /// What no step could do.
        cause: Box<MotionError>,
    },
    /// No step leads on from where a law has no derivative.
    #[error(
        "the force on {force_on} has no derivative with respect to {by} at t = {t} s{}. A Taylor series needs one, and other methods do \
         not: use dop853, or smooth the law, as `sqrt(dot(v, v) + u^2)` with a small u does for `norm(v)`", by_terms(.terms), t = legible_time(*.t)
    )]
    NoDerivative {
        /// Time of the last good state, s.
        t: f64,
        /// Name of the coordinate that the force acts on.
        force_on: Name,
        /// Name of the coordinate or velocity.
        by: Name,
        /// Calls in the force, one of which has no derivative; none where they are not known.
        terms: Vec<String>,
        /// What no step could do.
        cause: Box<MotionError>,
    },
    /// In lanes and with derivatives only the generated elimination solves, and a pivot of it vanishes.
    #[error(
        "the pivot of constraint `{row}` vanishes at t = {t} s in the generated elimination, which alone solves in lanes \
         and with derivatives; run the scene in single numbers, where a pivoted solver decides", t = legible_time(*.t)
    )]
    LostPivot {
        /// Time, s.
        t: f64,
        /// Name of the row.
        row: Name,
    },
    /// A coordinate has neither mass nor a row that determines its acceleration.
    #[error(
        "the acceleration of {} is undetermined at t = {t} s: no mass and no constraint moves it; \
         give its body a mass or an inertia, or constrain it", list(.coordinates), t = legible_time(*.t)
    )]
    UndeterminedMotion {
        /// Time, s.
        t: f64,
        /// Names of the coordinates.
        coordinates: Vec<Name>,
    },
    /// The Euclidean metric needs dense factors.
    #[error(
        "a system of {n} equations is too large for the Euclidean metric (at most {limit}), which is there for \
         comparison; project in the metric of the masses"
    )]
    EuclideanTooLarge {
        /// Number of equations.
        n: usize,
        /// Largest number that is accepted.
        limit: usize,
    },
    /// Steps that keep to the tolerance have become too short to move anything.
    #[error(
        "the step has shrunk to {step_s:.1e} s at t = {t} s: the motion is too fast or not smooth there, or the \
         tolerance is below rounding; allow larger errors, or look at the forces at that time", t = legible_time(*.t)
    )]
    StepCollapsed {
        /// Time of the last good state, s.
        t: f64,
        /// The step, s.
        step_s: f64,
    },
    /// An angle became too large for the tolerance of angles.
    #[error(
        "{name} is {angle:.3e} rad at t = {t} s, where doubles are {spacing:.1e} rad apart, more than the tolerance of angles, \
         {tolerance:.1e} rad; give a larger one, end the run earlier, or continue in a new run from the angle less whole turns", t = legible_time(*.t)
    )]
    AngleUnresolved {
        /// End of the step, s.
        t: f64,
        /// Name of the coordinate.
        name: Name,
        /// The angle, rad.
        angle: f64,
        /// Distance of neighbouring doubles there, rad.
        spacing: f64,
        /// The tolerance, rad.
        tolerance: f64,
    },
    /// A number overflowed or is undefined.
    #[error(
        "{quantity} is not finite after t = {t} s: the motion has become too fast for the step, or a law is \
         undefined there; take a smaller step or tolerance, or look at the state and the forces at that time", t = legible_time(*.t)
    )]
    NotFinite {
        /// Time of the last good state, s.
        t: f64,
        /// The coordinate or equation that is not finite.
        quantity: Name,
    },
    /// A controller or a table gave no number.
    #[error("input `{name}` is set to {value} at t = {t} s; set it to a finite value", t = legible_time(*.t))]
    InputNotFinite {
        /// Time from which it holds, s.
        t: f64,
        /// Name of the input.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// An input that a run integrates was set beside its motion.
    #[error(
        "input `{name}` is {} {unit} at t = {t} s and was set to {} {unit}: what constraints follow cannot jump, here by {:.1e} {unit}; \
         leave it, and lead it there by its acceleration: for example `set.{input}_acceleration = w*w*(goal - set.{input}) - 2.0*w*set.{input}_rate`, \
         which takes a few times 1/w", legible(*.is), legible(*.set), .set - .is, t = legible_time(*.t)
    )]
    InputJumps {
        /// Time from which it would hold, s.
        t: f64,
        /// Name of the value, the rate or their time: `steer_rate`.
        name: &'static str,
        /// Name of the input: `steer`.
        input: &'static str,
        /// Its unit.
        unit: &'static str,
        /// Where its motion is.
        is: f64,
        /// What was set.
        set: f64,
    },
    /// A stop returns more than it gets, or nothing that is a number.
    #[error("the restitution of stop `{stop}` is {} at t = {t} s; it must be between 0 and 1", legible(*.value), t = legible_time(*.t))]
    Restitution {
        /// Time, s.
        t: f64,
        /// Name of the stop.
        stop: &'static str,
        /// Its value.
        value: f64,
    },
    /// A skate that holds up to nothing, or slides against a force that is none.
    #[error("the limit of skate `{skate}` is {} at t = {t} s; it must be above zero", legible(*.value), t = legible_time(*.t))]
    SkateLimit {
        /// Time, s.
        t: f64,
        /// Name of the skate.
        skate: &'static str,
        /// Its limit, N.
        value: f64,
    },
    /// A stop that cannot be told to be hit.
    #[error(
        "the {what} of stop `{stop}` from its {end} end is {value} at t = {t} s; its quantity and its bounds must be finite", t = legible_time(*.t)
    )]
    StopNotFinite {
        /// Time, s.
        t: f64,
        /// Name of the stop.
        stop: &'static str,
        /// `lower` or `upper`.
        end: &'static str,
        /// `distance` or `speed`.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// Gauss–Newton does not come closer to C = 0.
    #[error(
        "position projection stalled at t = {t} s: |C| = {residual:.3e} after {passes} passes (tolerance \
         {tolerance:.1e}); largest constraint: {row}. Take a smaller step or tolerance", t = legible_time(*.t)
    )]
    ProjectionStalled {
        /// Time, s.
        t: f64,
        /// Largest |C|.
        residual: f64,
        /// Name of the row that has it.
        row: Name,
        /// Passes done.
        passes: usize,
        /// The tolerance that was not reached.
        tolerance: f64,
    },
}

/// No consistent start was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StartError {
    /// A start value is NaN or infinite.
    #[error("start value `{name}` is {value}; give it a finite value")]
    NotFinite {
        /// Name of the coordinate or velocity.
        name: Name,
        /// Its value.
        value: f64,
    },
    /// A quaternion is zero.
    #[error("the quaternion of body `{body}` is zero at the start; give s = 1 where its axes are those of the ground")]
    NoAttitude {
        /// Name of the body.
        body: Name,
    },
    /// A start has first-order states of another scene.
    #[error(
        "the start has {found} first-order states where the scene has {expected}; take it from a system of this scene"
    )]
    States {
        /// Those of the scene.
        expected: usize,
        /// Those of the start.
        found: usize,
    },
    /// A start value leaves no digits for the geometry.
    #[error("start value `{name}` is {value:e}, beyond {largest:e}, where rounding hides the geometry; start nearer")]
    TooLarge {
        /// Name of the coordinate or velocity.
        name: Name,
        /// Its value.
        value: f64,
        /// Largest magnitude that is accepted.
        largest: f64,
    },
    /// A row has no value.
    #[error(
        "constraint `{row}` is not a number at the start: a length or a direction in it is zero; change the parameters or the \
         start values"
    )]
    UndefinedRow {
        /// Name of the row, the first of several.
        row: Name,
    },
    /// The given values and the constraints contradict each other.
    #[error(
        "the start contradicts the constraints: {} of {} cannot be met, the best start leaves {residual:.3e} \
         (tolerance {tolerance:.1e}); held: {}", .level, list(.rows), held_and_remedy(.held)
    )]
    Contradiction {
        /// `position` or `velocity`.
        level: &'static str,
        /// Rows that are not met, the worst first.
        rows: Vec<Name>,
        /// Largest residual of the best start.
        residual: f64,
        /// The tolerance that was not reached.
        tolerance: f64,
        /// Names of the given values.
        held: Vec<Name>,
    },
    /// The constraints are met, but across a singular position from the near values.
    #[error(
        "the start is assembled in another mode than the one asked for, across a position where constraints depend on each other: asked \
         for {}; reached {}. Give values nearer to the mode that is meant (those reached, if it is that one), or hold one of them",
        each(.values, MovedValue::asked), each(.values, MovedValue::reached)
    )]
    OtherAssemblyMode {
        /// The near values of the bodies that are on the other side, the one that moved farthest first.
        values: Vec<MovedValue>,
    },
}

/// Which calls have no derivative; a norm is printed as a root.
fn by_terms(terms: &[String]) -> String {
    let quoted: Vec<String> = terms.iter().map(|term| format!("`{term}`")).collect();
    if quoted.is_empty() { String::new() } else { format!(", because of {}", quoted.join(" or ")) }
}

pub(super) fn rows_or_unknown(names: &[Name]) -> String {
    if names.is_empty() { "too many to work out which".to_owned() } else { list(names) }
}

fn nearly_dependent(rows: &[Name], smallest_pivot: Option<f64>) -> String {
    let pivot =
        |pivot| format!(", where constraints nearly depend on each other ({}; smallest pivot {pivot:.1e})", list(rows));
    smallest_pivot.map(pivot).unwrap_or_default()
}

fn held_and_remedy(names: &[Name]) -> String {
    if names.is_empty() {
        return "nothing. The constraints contradict each other, or their lengths do not reach: change the parameters"
            .to_owned();
    }
    let names = list(names);
    format!("{names}. Give fewer values, values that fit, or let them give way: `project_start`, `--project-start`")
}

fn each(values: &[MovedValue], say: fn(&MovedValue) -> String) -> String {
    list(&values.iter().map(|value| say(value).into()).collect::<Vec<Name>>())
}

fn list(names: &[Name]) -> String {
    let listed = names[..names.len().min(MAX_LISTED)].join(", ");
    match names.len().saturating_sub(MAX_LISTED) {
        0 => listed,
        more => format!("{listed} and {more} more"),
    }
}
