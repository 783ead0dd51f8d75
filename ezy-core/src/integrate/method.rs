//! The table of methods, and the choice of one with its step or tolerance.

use super::family::{Family, MethodInfo, Sizes};
use super::integrator::Integrator;
use super::step_control::Tolerance;
use super::{dop853, gauss, midpoint, radau, rk4, taylor};
use crate::dynamics::{Dynamics, System, SystemError};
use crate::model::SceneRef;
use crate::scalar::Scalar;

/// From lines `Kind = module::Family, steps constructor;` the kinds, their constructors as methods, and the way to each family.
macro_rules! methods {
    ($($(#[doc = $doc:literal])* $kind:ident = $module:ident::$family:ident, $steps:ident $constructor:ident;)*) => {
        /// A method, without its step or tolerance.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum MethodKind {
            $($(#[doc = $doc])* $kind,)*
        }

        impl MethodKind {
            /// Every method.
            pub const ALL: &[Self] = &[$(Self::$kind,)*];

            /// Name, order and needs of the method.
            pub const fn info(self) -> &'static MethodInfo {
                match self {
                    $(Self::$kind => &<$module::$family as Family>::INFO,)*
                }
            }

            /// For numbers of any type; none where it needs more than accelerations.
            pub(crate) fn in_any_number<D: Dynamics<T>, T: Scalar>(
                self,
                sizes: Sizes,
                tolerance: Tolerance,
            ) -> Option<Box<dyn Integrator<D, T>>> {
                match self {
                    $(Self::$kind => <$module::$family as Family>::in_any_number(sizes, tolerance),)*
                }
            }

            /// For a system; none where its scene lacks what the method needs. `is_projected`: whether the ends of steps are projected, positions
            /// and velocities in the metric of the masses.
            ///
            /// # Errors
            /// [`SystemError`] when there is no memory for the analysis of a large scene.
            pub(crate) fn of_system<P: SceneRef>(
                self,
                system: &System<P>,
                n_works: usize,
                tolerance: Tolerance,
                is_projected: bool,
            ) -> Result<Option<Box<dyn Integrator<System<P>>>>, SystemError> {
                let (scene, method) = (system.info(), self.info());
                if scene.n_states() > 0 && !method.takes_states || !(scene.is_planar() || method.takes_any_body) {
                    return Ok(None);
                }
                match self {
                    $(Self::$kind => <$module::$family as Family>::of_system(system, n_works, tolerance, is_projected),)*
                }
            }
        }

        impl Method {
            $(methods!(@$steps $(#[doc = $doc])* $kind $constructor);)*
        }
    };
    (@fixed $(#[doc = $doc:literal])* $kind:ident $constructor:ident) => {
        $(#[doc = $doc])*
        ///
        /// With this fixed step, s; the last one is shortened to land on the end.
        pub const fn $constructor(step_s: f64) -> Self {
            Self::fixed(MethodKind::$kind, step_s)
        }
    };
    (@chosen $(#[doc = $doc:literal])* $kind:ident $constructor:ident) => {
        $(#[doc = $doc])*
        ///
        /// With one number for the relative and the absolute tolerance (m, rad, m/s, rad/s).
        pub const fn $constructor(tolerance: f64) -> Self {
            Self::chosen(MethodKind::$kind, Tolerance::new(tolerance, tolerance))
        }
    };
}

methods! {
    /// Taylor's method, with order and steps that keep to a tolerance; for scenes whose laws are analytic.
    Taylor = taylor::AlongSeries, chosen taylor;
    /// The method of Dormand and Prince of order 8 with steps that keep to a tolerance.
    Dop853 = dop853::Adaptive, chosen dop853;
    /// Gauss–Legendre collocation of order 16, with steps that keep to a tolerance; for smooth motions.
    Gauss = gauss::Collocation, chosen gauss;
    /// The implicit method Radau IIA of order 5, with steps that keep to a tolerance; for stiff scenes.
    Radau = radau::Implicit, chosen radau;
    /// The classical Runge–Kutta method of order 4 with a fixed step.
    Rk4 = rk4::Rk4, fixed rk4;
    /// The explicit midpoint method of order 2 with a fixed step, to compare with.
    Midpoint = midpoint::Midpoint, fixed midpoint;
}

/// How a run is integrated: a method, and its fixed step or its tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    kind: MethodKind,
    steps: Steps,
}

/// The lengths of steps.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Steps {
    /// Each is so long, s.
    Fixed(f64),
    /// The method chooses them, with errors within this.
    Chosen(Tolerance),
}

impl MethodKind {
    /// Name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        self.info().name
    }

    /// The method with this fixed step, s; none for one that chooses its steps.
    pub const fn with_step(self, step_s: f64) -> Option<Method> {
        if self.info().chooses_steps { None } else { Some(Method::fixed(self, step_s)) }
    }

    /// The method with this tolerance; none for one with a fixed step.
    pub const fn with_tolerance(self, tolerance: Tolerance) -> Option<Method> {
        if self.info().chooses_steps { Some(Method::chosen(self, tolerance)) } else { None }
    }
}

impl Method {
    const fn fixed(kind: MethodKind, step_s: f64) -> Self {
        Self { kind, steps: Steps::Fixed(step_s) }
    }

    const fn chosen(kind: MethodKind, tolerance: Tolerance) -> Self {
        Self { kind, steps: Steps::Chosen(tolerance) }
    }

    /// Which method it is.
    pub const fn kind(self) -> MethodKind {
        self.kind
    }

    /// Name, order and needs of the method.
    pub const fn info(self) -> &'static MethodInfo {
        self.kind.info()
    }

    /// Name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        self.kind.name()
    }

    /// The fixed step, s; none of a method that chooses its steps.
    pub const fn step_s(self) -> Option<f64> {
        match self.steps {
            Steps::Fixed(step_s) => Some(step_s),
            Steps::Chosen(_) => None,
        }
    }

    /// Tolerance of a method that chooses its steps; none for one with a fixed step.
    pub const fn tolerance(self) -> Option<Tolerance> {
        match self.steps {
            Steps::Fixed(_) => None,
            Steps::Chosen(tolerance) => Some(tolerance),
        }
    }

    /// The fixed step, s, or the relative tolerance.
    pub const fn setting(self) -> f64 {
        match self.steps {
            Steps::Fixed(step_s) => step_s,
            Steps::Chosen(tolerance) => tolerance.relative,
        }
    }

    /// The same method with this tolerance; one with a fixed step stays what it is.
    #[must_use]
    pub const fn with_tolerance(self, tolerance: Tolerance) -> Self {
        match self.steps {
            Steps::Fixed(_) => self,
            Steps::Chosen(_) => Self::chosen(self.kind, tolerance),
        }
    }

    /// A tolerance below which errors are what the iteration of an implicit method leaves; 0 of others.
    pub const fn iteration_floor(self) -> f64 {
        let info = self.kind.info();
        if info.is_implicit { info.rounding } else { 0.0 }
    }

    /// The method that a run takes: a relative tolerance below [`Tolerance::SMALLEST_RELATIVE`], which is rounding, is lifted to it.
    #[must_use]
    pub fn lifted(self) -> Self {
        match self.steps {
            Steps::Chosen(tolerance) if tolerance.relative > 0.0 => {
                let relative = tolerance.relative.max(Tolerance::SMALLEST_RELATIVE);
                self.with_tolerance(Tolerance { relative, ..tolerance })
            }
            _ => self,
        }
    }

    /// The same method with an absolute tolerance of angles, rad, in place of `absolute + relative · |φ|`: for rotors, whose angles grow
    /// while only their remainder after whole turns matters. A method with a fixed step has no tolerance and stays what it is.
    ///
    /// A run ends with an error where an angle becomes so large that doubles near it are farther apart than this.
    #[must_use]
    pub const fn angle_tolerance(self, rad: f64) -> Self {
        match self.steps {
            Steps::Fixed(_) => self,
            Steps::Chosen(tolerance) => self.with_tolerance(Tolerance { angle: Some(rad), ..tolerance }),
        }
    }
}

impl Default for Method {
    /// DOP853 at [`Tolerance::DEFAULT`]: it keeps a tolerance, whatever the time scale of the motion.
    fn default() -> Self {
        Self::dop853(Tolerance::DEFAULT)
    }
}
