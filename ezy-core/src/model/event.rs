//! Events of a scene, and what changes its constraints: stick–slip friction and unilateral contact.

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
    /// None: a smoothed law turns around there within a layer that may be narrow, as friction does. The value is the share of the
    /// largest force, from -1 to 1. DOP853 is careful with a step that passes the layer.
    Layer,
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
    pub(crate) fn counts(self, side: f64) -> bool {
        match self {
            Self::Rising => side > 0.0,
            Self::Falling => side < 0.0,
            Self::Either => true,
        }
    }
}

/// The skate with a limit. It holds while its multiplier is within the limit.
///
/// Beyond the limit the skate slides: a force of the size of the limit opposes the velocity across it, until that velocity
/// returns to zero. Then it holds again, or slides to the other side if its reaction still exceeds the limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StickSlipInfo {
    /// Its name, and that of its constraint.
    pub name: &'static str,
    /// Index of its constraint in [`SceneInfo::rows`](super::SceneInfo::rows).
    pub row: usize,
    /// The limit, N.
    pub limit: Formula,
    /// It begins to slide.
    pub slides: EventInfo,
    /// It stops sliding to one side.
    pub stops: EventInfo,
}

/// The stop of a scene.
///
/// When the quantity reaches a bound, an impact reverses its rate and multiplies it by the restitution; all constraints are
/// satisfied after it. When the quantity would stay there, the contact closes: the stop is a constraint, `quantity - bound`, as
/// long as it pushes. Its multiplier is negative on the lower end and positive on the upper one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopInfo {
    /// Its name, and that of its constraint.
    pub name: &'static str,
    /// Index of its constraint in [`SceneInfo::rows`](super::SceneInfo::rows).
    pub row: usize,
    /// For each end 1 where it is the lower one, -1 where it is the upper one.
    pub sides: &'static [i8],
    /// Rate after an impact over the rate before it.
    pub restitution: Formula,
    /// The quantity reaches an end; for each one.
    pub hits: &'static [EventInfo],
    /// The contact closes.
    pub holds: EventInfo,
    /// The contact opens: it would have to pull.
    pub lets_go: EventInfo,
}

impl StopInfo {
    /// Name of an end: `lower` or `upper`.
    pub const fn end(&self, i: usize) -> &'static str {
        if self.sides[i] > 0 { "lower" } else { "upper" }
    }
}
