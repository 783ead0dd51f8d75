//! What can go wrong at one state.

use crate::linalg::SparseKktError;

/// A system cannot be set up with these numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SystemError {
    /// A parameter is NaN or infinite.
    #[error("parameter `{name}` is {value}; give it a finite value")]
    ParameterNotFinite {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A mass or inertia is negative or not a number.
    #[error("the {quantity} of body `{body}` is {value}; it must be zero or positive")]
    Mass {
        /// Name of the body.
        body: &'static str,
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
        body: &'static str,
        /// `mass` or `inertia`.
        quantity: &'static str,
        /// `generated` or `sparse`.
        backend: &'static str,
    },
    /// The sparse backend could not be prepared.
    #[error(transparent)]
    Sparse(#[from] SparseKktError),
}

/// The motion cannot be continued from a state.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// The rows do not determine the reactions.
    #[error(
        "constraint rows depend on each other at t = {t} s: {}; smallest singular value {smallest_singular_value:.1e} \
         of the largest. The reactions, and where the motion goes on, are undetermined: change the geometry or the \
         start so that the rows are independent, or remove one of them", .rows.join(", ")
    )]
    DependentRows {
        /// Time, s.
        t: f64,
        /// Names of the rows that take part in a dependency.
        rows: Vec<&'static str>,
        /// Smallest singular value of the scaled K relative to the largest.
        smallest_singular_value: f64,
    },
    /// A coordinate has neither mass nor a row that determines its acceleration.
    #[error(
        "the acceleration of {} is undetermined at t = {t} s: no mass and no constraint row moves it; \
         give its body a mass or an inertia, or constrain it", .coordinates.join(", ")
    )]
    UndeterminedMotion {
        /// Time, s.
        t: f64,
        /// Names of the coordinates.
        coordinates: Vec<&'static str>,
    },
    /// A number overflowed or is undefined.
    #[error(
        "{quantity} is not finite after t = {t} s: the motion has become too fast for the step, or a law is \
         undefined there; take a smaller step or look at the state at that time"
    )]
    NotFinite {
        /// Time of the last good state, s.
        t: f64,
        /// The coordinate or equation that is not finite.
        quantity: &'static str,
    },
    /// Gauss–Newton does not come closer to C = 0.
    #[error(
        "position projection stalled at t = {t} s: |C| = {residual:.3e} after {passes} passes (tolerance \
         {tolerance:.1e}); largest row: {row}. Take a smaller step"
    )]
    ProjectionStalled {
        /// Time, s.
        t: f64,
        /// Largest |C|.
        residual: f64,
        /// Name of the row that has it.
        row: &'static str,
        /// Passes done.
        passes: usize,
        /// The tolerance that was not reached.
        tolerance: f64,
    },
}

/// No consistent start was found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StartError {
    /// A start value is NaN or infinite.
    #[error("start value `{name}` is {value}; give it a finite value")]
    NotFinite {
        /// Name of the coordinate or velocity.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A start value leaves no digits for the geometry.
    #[error("start value `{name}` is {value:e}, beyond {largest:e}, where rounding hides the geometry; start nearer")]
    TooLarge {
        /// Name of the coordinate or velocity.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Largest magnitude that is accepted.
        largest: f64,
    },
    /// The given values and the constraints contradict each other.
    #[error(
        "the start contradicts the constraints: {} of {} cannot be met, the best start leaves {residual:.3e} \
         (tolerance {tolerance:.1e}); held: {}. Give fewer values, or values that fit", .level, .rows.join(", "), list_or_nothing(.held)
    )]
    Contradiction {
        /// `position` or `velocity`.
        level: &'static str,
        /// Rows that are not met, the worst first.
        rows: Vec<&'static str>,
        /// Largest residual of the best start.
        residual: f64,
        /// The tolerance that was not reached.
        tolerance: f64,
        /// Names of the given values.
        held: Vec<&'static str>,
    },
}

fn list_or_nothing(names: &[&str]) -> String {
    if names.is_empty() { "nothing".to_owned() } else { names.join(", ") }
}
