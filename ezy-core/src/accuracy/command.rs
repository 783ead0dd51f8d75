//! A method with its setting, as it is typed.

use crate::integrate::Method;

/// The step of a method with a fixed step, s, or the relative tolerance of one that chooses its steps.
pub(crate) fn setting(method: Method) -> f64 {
    match method {
        Method::Rk4 { step_s } => step_s,
        Method::Dop853(tolerance) | Method::Taylor(tolerance) | Method::Radau(tolerance) => tolerance.relative,
    }
}

/// The method's setting as an option of the command line: `--step 0.001`, `--rtol 1e-9`.
pub(super) fn command(method: Method) -> String {
    match method {
        Method::Rk4 { step_s } => format!("--step {}", number(step_s)),
        _ => format!("--rtol {}", number(setting(method))),
    }
}

/// A setting with the digits it was made with: `0.001`, `1e-9`, `3.2e-7`.
fn number(value: f64) -> String {
    if (1e-3..1e4).contains(&value) { format!("{value}") } else { format!("{value:e}") }
}
