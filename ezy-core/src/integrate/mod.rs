//! Methods that advance a state: one method a file. Knows no files and no constraints but through
//! [`System`](crate::dynamics::System).

mod compensated;
mod dop853;
mod gauss;
mod hermite;
mod radau;
mod rk4;
mod step_control;
mod taylor;

pub(crate) use dop853::{Dop853, ERROR_ORDER as DOP853_ERROR_ORDER, StiffnessWatch};
pub(crate) use gauss::{Collocated, Gauss, GaussControl};
pub(crate) use hermite::{Node, interpolate};
pub(crate) use radau::{Attempt, Radau, RadauControl, tolerance_of_estimate};
pub(crate) use rk4::Rk4;
pub use step_control::Tolerance;
pub(crate) use step_control::{Clock, StepControl};
pub use taylor::{PreciseError, PreciseMotion};
pub(crate) use taylor::{Taylor, taylor_order};

/// How a run is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// The classical Runge–Kutta method of order 4 with a fixed step.
    Rk4 {
        /// Step, s; the last one is shortened to land on the end.
        step_s: f64,
    },
    /// The method of Dormand and Prince of order 8 with steps that keep to a tolerance.
    Dop853(Tolerance),
    /// Taylor's method, with order and steps that keep to a tolerance; for scenes whose laws are analytic.
    Taylor(Tolerance),
    /// Gauss–Legendre collocation of order 16, with steps that keep to a tolerance; for smooth motions.
    Gauss(Tolerance),
    /// The implicit method Radau IIA of order 5, with steps that keep to a tolerance; for stiff scenes.
    Radau(Tolerance),
}

impl Method {
    /// The classical Runge–Kutta method with a fixed step, s.
    pub const fn rk4(step_s: f64) -> Self {
        Self::Rk4 { step_s }
    }

    /// The method of Dormand and Prince of order 8, with one number for the relative and the absolute tolerance (m, rad,
    /// m/s, rad/s).
    pub const fn dop853(tolerance: f64) -> Self {
        Self::Dop853(Tolerance::new(tolerance, tolerance))
    }

    /// Taylor's method, with one number for the relative and the absolute tolerance (m, rad, m/s, rad/s).
    pub const fn taylor(tolerance: f64) -> Self {
        Self::Taylor(Tolerance::new(tolerance, tolerance))
    }

    /// Gauss–Legendre collocation, with one number for the relative and the absolute tolerance (m, rad, m/s, rad/s).
    pub const fn gauss(tolerance: f64) -> Self {
        Self::Gauss(Tolerance::new(tolerance, tolerance))
    }

    /// Radau IIA of order 5, with one number for the relative and the absolute tolerance (m, rad, m/s, rad/s).
    pub const fn radau(tolerance: f64) -> Self {
        Self::Radau(Tolerance::new(tolerance, tolerance))
    }

    /// Tolerance of a method that chooses its steps; none for one with a fixed step.
    pub const fn tolerance(self) -> Option<Tolerance> {
        match self {
            Self::Rk4 { .. } => None,
            Self::Dop853(tolerance) | Self::Taylor(tolerance) | Self::Gauss(tolerance) | Self::Radau(tolerance) => {
                Some(tolerance)
            }
        }
    }

    /// The method that a run takes: a relative tolerance below [`Tolerance::SMALLEST_RELATIVE`], which is rounding, is lifted to it.
    #[must_use]
    pub fn lifted(self) -> Self {
        self.with_tolerance(|tolerance| match tolerance.relative {
            relative if relative > 0.0 => {
                Tolerance { relative: relative.max(Tolerance::SMALLEST_RELATIVE), ..tolerance }
            }
            _ => tolerance,
        })
    }

    /// The same method with an absolute tolerance of angles, rad, in place of `absolute + relative · |φ|`: for rotors, whose angles grow
    /// while only their remainder after whole turns matters. A method with a fixed step has no tolerance and stays what it is.
    ///
    /// A run ends with an error where an angle becomes so large that doubles near it are farther apart than this.
    #[must_use]
    pub fn angle_tolerance(self, rad: f64) -> Self {
        self.with_tolerance(|tolerance| Tolerance { angle: Some(rad), ..tolerance })
    }

    fn with_tolerance(self, with: impl Fn(Tolerance) -> Tolerance) -> Self {
        match self {
            Self::Rk4 { .. } => self,
            Self::Dop853(tolerance) => Self::Dop853(with(tolerance)),
            Self::Taylor(tolerance) => Self::Taylor(with(tolerance)),
            Self::Gauss(tolerance) => Self::Gauss(with(tolerance)),
            Self::Radau(tolerance) => Self::Radau(with(tolerance)),
        }
    }

    /// Name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 { .. } => "rk4",
            Self::Dop853(_) => "dop853",
            Self::Taylor(_) => "taylor",
            Self::Gauss(_) => "gauss",
            Self::Radau(_) => "radau",
        }
    }
}

impl Default for Method {
    /// DOP853 at [`Tolerance::DEFAULT`]: it keeps a tolerance, whatever the time scale of the motion.
    fn default() -> Self {
        Self::dop853(Tolerance::DEFAULT)
    }
}
