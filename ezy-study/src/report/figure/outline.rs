//! Outlines of shapes and letters.

/// A place: to the right and down, in points.
pub(crate) type Place = [f64; 2];

/// One part of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Segment {
    Move(Place),
    Line(Place),
    /// A parabola by its control point and its end.
    Curve(Place, Place),
    Close,
}
