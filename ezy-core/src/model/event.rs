//! Events of a scene.

use super::Formula;

/// An event function of a scene; the event is its root.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EventInfo {
    /// Name in the model file; of a condition behind `until` the condition as written; of a discontinuity its value.
    pub name: &'static str,
    /// The consequence.
    pub kind: EventKind,
    /// Direction in which the function passes zero.
    pub direction: Direction,
    /// The value: left side of the condition minus its right side, in SI units; what stands in `abs` or `sign`, or the
    /// difference of what stands in `min` or `max`.
    pub formula: Formula,
    /// Doc comment of the declaration.
    pub documentation: &'static str,
}

/// Consequence of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
    /// It is recorded; the motion is the same to the last bit.
    Mark,
    /// The run ends.
    End,
    /// None: a law has a discontinuity there, of its value or its slope, by `abs`, `sign`, `min` or `max`. DOP853, Radau and RK4
    /// end a step there.
    Discontinuity,
}

/// Direction of a root.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// Both ways.
    Either,
}

impl Direction {
    /// Whether a root counts that leads to this side of zero: 1 above, -1 below.
    pub fn counts(self, side: f64) -> bool {
        match self {
            Self::Rising => side > 0.0,
            Self::Falling => side < 0.0,
            Self::Either => true,
        }
    }
}
