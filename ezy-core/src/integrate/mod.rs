//! Methods that advance a state: one method a file. Knows no files and no constraints but through
//! [`System`](crate::dynamics::System).

mod clock;
mod hermite;
mod rk4;

pub use clock::Clock;
pub use hermite::{Knot, interpolate};
pub use rk4::Rk4;

/// How a run is integrated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Method {
    /// The classical Runge–Kutta method of order 4 with a fixed step.
    Rk4 {
        /// Step, s; the last one is shortened to land on the end.
        step_s: f64,
    },
}

impl Method {
    /// The classical Runge–Kutta method with a fixed step, s.
    pub const fn rk4(step_s: f64) -> Self {
        Self::Rk4 { step_s }
    }

    /// Name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 { .. } => "rk4",
        }
    }
}

impl Default for Method {
    /// RK4 at 1 ms: 1e-10 over a minute for motions that take a second to turn.
    fn default() -> Self {
        Self::rk4(1e-3)
    }
}
