//! Errors of a run that cannot start.

use crate::dynamics::{MotionError, StartError, SystemError};
use crate::integrate::Tolerance;
use crate::memory::readable;
use crate::model::{Name, SceneInfo, SeriesInfo};
use crate::record::{RecordError, UnknownName};
use crate::scalar::legible;

/// A run cannot start like this.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SetupError {
    /// A start value was given for something that does not exist.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// Parameters, masses or backend cannot be used.
    #[error(transparent)]
    System(#[from] SystemError),
    /// The step is not a positive length of time.
    #[error("the step is {} s; give a positive step", legible(*.step_s))]
    Step {
        /// The step, s.
        step_s: f64,
    },
    /// The method integrates no first-order states.
    #[error(
        "scene `{scene}` has first-order states, which {method} does not integrate; use dop853, radau, rk4 or midpoint"
    )]
    FirstOrderStates {
        /// Name of the scene.
        scene: &'static str,
        /// Name of the method.
        method: &'static str,
    },
    /// The method integrates planar bodies alone.
    #[error("scene `{scene}` has bodies in space, which {method} does not integrate; use dop853, rk4 or midpoint")]
    SpatialBodies {
        /// Name of the scene.
        scene: &'static str,
        /// Name of the method.
        method: &'static str,
    },
    /// A tolerance of angles was given where not every body has one.
    #[error("scene `{scene}` has bodies in space, whose attitudes are quaternions; leave out the tolerance of angles")]
    AnglesInSpace {
        /// Name of the scene.
        scene: &'static str,
    },
    /// The tolerances are out of range.
    #[error("the tolerances are {relative:e} relative and {absolute:e} absolute; give positive ones up to {largest}")]
    Tolerance {
        /// Relative tolerance.
        relative: f64,
        /// Absolute tolerance.
        absolute: f64,
        /// Largest tolerance that is accepted.
        largest: f64,
    },
    /// Inputs that change and steppers need steps of a known length.
    #[error(
        "control laws, input tables and steppers hold inputs over a fixed step, but {method} chooses its steps; ask for a fixed one: \
         `--method rk4 --step 0.001`, `.method(Method::rk4(0.001))`"
    )]
    NeedsFixedStep {
        /// Name of the method.
        method: &'static str,
    },
    /// Runs that step together, and runs with derivatives, take other methods.
    #[error("{method} cannot run in lanes or with derivatives; use dop853, rk4 or midpoint")]
    SingleNumbers {
        /// Name of the method.
        method: &'static str,
    },
    /// The other runs that an estimate of the error takes cannot call a law that may keep a state of its own.
    #[error(
        "the error cannot be estimated of a run with a control law: other runs cannot call it; compare runs with two steps, or record \
         the inputs and give them as a table"
    )]
    ControlledOnce,
    /// Runs that step together have one time.
    #[error(
        "the runs start at t = {} s and t = {} s; runs that step together start at one time", legible(*.first), legible(*.other)
    )]
    DifferentTimes {
        /// Time of the first start, s.
        first: f64,
        /// Time of another start, s.
        other: f64,
    },
    /// A start has the numbers of another scene.
    #[error(
        "a start has {found} coordinates, velocities or first-order states where the scene has {expected}; take it from a system of this scene"
    )]
    StartLength {
        /// Those of the scene.
        expected: usize,
        /// Length of what was given.
        found: usize,
    },
    /// A run carries so many derivatives at once.
    #[error("derivatives by {n} quantities are asked for, and a run carries {limit}: make further runs for the others")]
    TooManyDerivatives {
        /// Quantities that were asked for.
        n: usize,
        /// Most of them.
        limit: usize,
    },
    /// What a derivative is asked by is computed, not given.
    #[error("`{name}` is not given by the start but follows from the constraints; give it a start value")]
    NotGiven {
        /// Name of the coordinate or velocity.
        name: Name,
    },
    /// What a derivative is asked by cannot change alone.
    #[error(
        "the motion has no derivative by `{name}`: with another value of it the constraints contradict what the start gives; give it fewer \
         values, or values that are near"
    )]
    HeldByStart {
        /// Name of the parameter or start value.
        name: String,
    },
    /// The tolerance of angles is not positive or too large.
    #[error("the tolerance of angles is {rad:e} rad; give a positive one up to {largest:e} rad, or none")]
    AngleTolerance {
        /// Tolerance of angles, rad.
        rad: f64,
        /// Largest one that is accepted, rad.
        largest: f64,
    },
    /// Its value follows from its acceleration.
    #[error(
        "input `{name}` is given as a table, but it follows from its acceleration; give the table for `{input}_acceleration`, and one \
         number for `{name}`, with which it starts"
    )]
    IntegratedInput {
        /// Name of the value or the rate.
        name: &'static str,
        /// Name of the input.
        input: &'static str,
    },
    /// The scene has no Taylor series.
    #[error("scene `{scene}` has no Taylor series: {}; use another method, such as dop853", why(*.series))]
    NoSeries {
        /// Name of the scene.
        scene: &'static str,
        /// What is known of it.
        series: SeriesInfo,
    },
    /// The scene does not know the Jacobians of its equations.
    #[error(
        "scene `{scene}` has no Jacobians of its equations, which radau needs: it was written by hand without them, or they are too long to write; use another method, such as dop853"
    )]
    NoJacobians {
        /// Name of the scene.
        scene: &'static str,
    },
    /// Its skate may slide, or its stop may be hit.
    #[error(
        "scene `{scene}` has modes because of {what} `{name}`, which only runs support; run the scene, or remove the {}",
        if *.what == "skate" { "limit" } else { "stop" }
    )]
    Modes {
        /// Name of the scene.
        scene: &'static str,
        /// `skate` or `stop`.
        what: &'static str,
        /// Its name.
        name: &'static str,
    },
    /// The start is where a stop does not let anything be.
    #[error(
        "the start of scene `{scene}` is beyond the {end} end of stop `{stop}`, by {beyond:.3e}; start on the other side, or \
         move the stop"
    )]
    BeyondStop {
        /// Name of the scene.
        scene: &'static str,
        /// Name of the stop.
        stop: &'static str,
        /// `lower` or `upper`.
        end: &'static str,
        /// By how much, in the unit of its quantity.
        beyond: f64,
    },
    /// More steps than anyone waits for.
    #[error(
        "{steps:.1e} steps of {} s lie between the start and the end; at most {limit:.0e} are taken: give a larger step or an \
         earlier end", legible(*.step_s)
    )]
    TooManySteps {
        /// Steps that the run would take.
        steps: f64,
        /// The step, s.
        step_s: f64,
        /// The largest number that is accepted.
        limit: f64,
    },
    /// A limit is negative or not a number.
    #[error("the limit {name} is {}; give a number that is not negative, or no limit", legible(*.value))]
    Limit {
        /// `max-drift` or `max-energy-error`.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// The end is before the start or not a number.
    #[error(
        "the run is to end at {} s but starts at {} s; give a finite end that is not before the start",
        legible(*.until_s), legible(*.start_s)
    )]
    Until {
        /// The end, s.
        until_s: f64,
        /// The start, s.
        start_s: f64,
    },
    /// The recording interval is not a positive length of time.
    #[error(
        "the recording interval is {} s; give a positive interval, or none to keep only the start and the end",
        legible(*.every_s)
    )]
    Every {
        /// The interval, s.
        every_s: f64,
    },
    /// A sample is asked for at a time that the run does not reach.
    #[error(
        "a sample is asked for at {} s, but the run goes from {} s to {} s; leave that time out, or change the end",
        legible(*.t), legible(*.start_s), legible(*.until_s)
    )]
    SampleTime {
        /// Time of the sample, s.
        t: f64,
        /// The start, s.
        start_s: f64,
        /// The end, s.
        until_s: f64,
    },
    /// More samples than are kept or streamed.
    #[error(
        "{samples:.1e} samples {} s apart lie between the start and the end; at most {limit:.0e} are possible: give a longer interval",
        legible(*.every_s)
    )]
    TooManySamples {
        /// Samples that the run would keep.
        samples: f64,
        /// The interval, s.
        every_s: f64,
        /// The largest number that is accepted.
        limit: f64,
    },
    /// The samples need more memory than the machine has left.
    #[error(
        "{samples:.1e} samples {} s apart need {}, and the machine has {} left: give a longer interval, or write samples to a file \
         without keeping them (`stream_to`)", legible(*.every_s), readable(*.needed), readable(*.available)
    )]
    Memory {
        /// Samples that the run would keep.
        samples: f64,
        /// The interval, s.
        every_s: f64,
        /// Bytes that they need.
        needed: u64,
        /// Bytes that the machine has left.
        available: u64,
    },
    /// The start values do not fit.
    #[error(transparent)]
    Start(#[from] StartError),
    /// There is no motion from the start.
    #[error("the motion cannot start: {0}")]
    Motion(#[from] MotionError),
    /// Not even the first sample could be written.
    #[error(transparent)]
    Record(#[from] RecordError),
}

impl SetupError {
    /// Refuses a tolerance of angles in a scene with bodies in space.
    ///
    /// # Errors
    /// [`SetupError::AnglesInSpace`].
    pub(crate) fn refuse_angles(info: &SceneInfo, tolerance: Option<Tolerance>) -> Result<(), Self> {
        let has_angle = tolerance.is_some_and(|tolerance| tolerance.angle.is_some());
        if has_angle && !info.is_planar() { Err(Self::AnglesInSpace { scene: info.name }) } else { Ok(()) }
    }

    /// Refuses a scene that becomes another one while it runs.
    ///
    /// # Errors
    /// [`SetupError::Modes`].
    pub fn refuse_modes(info: &SceneInfo) -> Result<(), Self> {
        let skate = info.limited_skates.first().map(|skate| ("skate", skate.name));
        let stop = info.stop.map(|stop| ("stop", stop.name));
        match skate.or(stop) {
            None => Ok(()),
            Some((what, name)) => Err(Self::Modes { scene: info.name, what, name }),
        }
    }
}

/// Why there is no series.
fn why(series: SeriesInfo) -> String {
    match series {
        SeriesInfo::NotAnalytic { function } => format!("a law calls `{function}`, which is not analytic"),
        _ => "its equations were written without one".to_owned(),
    }
}
