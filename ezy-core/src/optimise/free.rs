//! A quantity that is free to be found, and its bounds.

use super::OptimiseError;

/// A free quantity: a parameter of a scene, a start value, an input, or any number that the caller's run takes.
///
/// ```
/// use ezy_core::optimise::Free;
///
/// let damping = Free::new("c", 0.1).within(0.0, f64::INFINITY);
/// let length = Free::between("l", 0.5, 2.0);
/// assert_eq!((damping.start, length.start), (0.1, 1.25));
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Free {
    /// Its name, for results and messages.
    pub name: String,
    /// Value with which a fit begins.
    pub start: f64,
    /// Lower bound; −∞ for none.
    pub lower: f64,
    /// Upper bound; ∞ for none.
    pub upper: f64,
}

/// A start on a bound is moved inside by this part of its scale: on the bound itself the transformation has no slope.
const START_INSIDE: f64 = 1e-3;
/// A value this near to a bound, in parts of the scale, is at the bound: the transformation never passes it.
const AT_BOUND: f64 = 1e-6;
/// Least distance from a bound over which predictions change, in parts of the scale: nearer, differences of runs are lost in their error.
const BESIDE_A_BOUND: f64 = 1e-3;

impl Free {
    /// A free quantity without bounds.
    pub fn new(name: impl Into<String>, start: f64) -> Self {
        Self { name: name.into(), start, lower: f64::NEG_INFINITY, upper: f64::INFINITY }
    }

    /// A free quantity between two bounds; a fit starts in their middle.
    pub fn between(name: impl Into<String>, lower: f64, upper: f64) -> Self {
        Self { name: name.into(), start: lower + 0.5 * (upper - lower), lower, upper }
    }

    /// The same quantity with bounds; infinities stand for none.
    #[must_use]
    pub fn within(mut self, lower: f64, upper: f64) -> Self {
        (self.lower, self.upper) = (lower, upper);
        self
    }

    /// Refuses bounds that leave nothing free, and starts outside.
    pub(super) fn checked(&self) -> Result<(), OptimiseError> {
        let Self { name, start, lower, upper } = self;
        if lower < upper && start.is_finite() && (lower..=upper).contains(&start) {
            return Ok(());
        }
        Err(OptimiseError::Bounds { name: name.clone(), start: *start, lower: *lower, upper: *upper })
    }

    /// Size of changes of the value that matter.
    pub(super) fn scale(&self) -> f64 {
        let width = self.upper - self.lower;
        match (self.start.abs(), width.is_finite()) {
            (0.0, true) => width,
            (0.0, false) => 1.0,
            (size, true) => size.min(width),
            (size, false) => size,
        }
    }

    /// As [`Free::scale`], at a value that the fit has come to. Beside a bound, such as a mass near zero, predictions change over the
    /// distance from it.
    pub(super) fn scale_at(&self, value: f64) -> f64 {
        let scale = self.scale();
        let from_bound = (value - self.lower).min(self.upper - value);
        scale.max(value.abs()).min(from_bound.max(BESIDE_A_BOUND * scale))
    }

    /// The value that belongs to the unbounded `u`: the transformation of MINUIT (James and Roos, Computer Physics
    /// Communications 10 (1975), 343), which is smooth and takes every value between the bounds.
    pub(super) fn value(&self, u: f64) -> f64 {
        let Self { lower, upper, .. } = *self;
        let s = self.scale();
        let value = match (lower.is_finite(), upper.is_finite()) {
            (false, false) => s * u,
            (true, false) => lower + s * ((u * u + 1.0).sqrt() - 1.0),
            (false, true) => upper - s * ((u * u + 1.0).sqrt() - 1.0),
            (true, true) => lower + 0.5 * (upper - lower) * (1.0 + u.sin()),
        };
        value.clamp(lower, upper)
    }

    /// Derivative of [`Free::value`].
    pub(super) fn slope(&self, u: f64) -> f64 {
        let s = self.scale();
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (false, false) => s,
            (true, false) => s * u / (u * u + 1.0).sqrt(),
            (false, true) => -s * u / (u * u + 1.0).sqrt(),
            (true, true) => 0.5 * (self.upper - self.lower) * u.cos(),
        }
    }

    /// The `u` of the start, off the bounds.
    pub(super) fn start_inside(&self) -> f64 {
        let Self { start, lower, upper, .. } = *self;
        let s = self.scale();
        let beyond = |distance: f64| ((distance.max(START_INSIDE * s) / s + 1.0).powi(2) - 1.0).sqrt();
        match (lower.is_finite(), upper.is_finite()) {
            (false, false) => start / s,
            (true, false) => beyond(start - lower),
            (false, true) => beyond(upper - start),
            (true, true) => {
                let part = ((start - lower) / (upper - lower)).clamp(START_INSIDE, 1.0 - START_INSIDE);
                (2.0 * part - 1.0).asin()
            }
        }
    }

    /// Whether a value is at a bound.
    pub(super) fn is_at_bound(&self, value: f64) -> bool {
        let near = AT_BOUND * self.scale();
        value - self.lower <= near || self.upper - value <= near
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sines and roots near a bound keep half of the digits.
    const HALF_OF_THE_DIGITS: f64 = 1e-7;
    /// Central differences with a step of 1e-6: h² and rounding over h.
    const OF_DIFFERENCES: f64 = 1e-8;

    fn kinds() -> [Free; 5] {
        [
            Free::new("free", 3.0),
            Free::new("zero", 0.0),
            Free::new("above", 3.0).within(1.0, f64::INFINITY),
            Free::new("below", -3.0).within(f64::NEG_INFINITY, 2.0),
            Free::new("between", 1.5).within(1.0, 4.0),
        ]
    }

    #[test]
    fn invariant_free_value_starts_where_it_shall_and_keeps_its_bounds() {
        for free in kinds() {
            assert!((free.value(free.start_inside()) - free.start).abs() <= HALF_OF_THE_DIGITS, "{free:?}");
            for u in [-1e9, -7.0, -0.1, 0.0, 2.0, 1e9] {
                assert!((free.lower..=free.upper).contains(&free.value(u)), "{free:?} at {u}");
            }
        }
    }

    #[test]
    fn fd_slope_of_a_free_value() {
        for free in kinds() {
            for u in [-2.0, -0.3, 0.7, 1.2] {
                let h = 1e-6;
                let difference = (free.value(u + h) - free.value(u - h)) / (2.0 * h);
                assert!((difference - free.slope(u)).abs() <= OF_DIFFERENCES * free.scale(), "{free:?} at {u}");
            }
        }
    }

    #[test]
    fn invariant_start_on_a_bound_has_a_slope_and_bounds_without_room_are_refused() {
        for free in [Free::new("c", 0.0).within(0.0, 2.0), Free::new("c", 0.0).within(0.0, f64::INFINITY)] {
            assert!(free.slope(free.start_inside()) > 0.0 && free.checked().is_ok(), "{free:?}");
        }
        for free in [Free::between("c", 1.0, 1.0), Free::new("c", 3.0).within(0.0, 2.0), Free::new("c", f64::NAN)] {
            assert!(matches!(free.checked(), Err(OptimiseError::Bounds { .. })), "{free:?}");
        }
    }
}
