//! Colours, dashes and markers: distinct in colour, in lightness and in pattern.

/// A marker at each point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Marker {
    None,
    Circle,
    Square,
    Triangle,
    Diamond,
}

/// How a curve is drawn.
#[derive(Debug, Clone)]
pub(super) struct Look {
    /// Red, green, blue.
    pub color: [u8; 3],
    /// Lengths of strokes and gaps in points, empty for a solid line.
    pub dash: &'static [f32],
    /// Width in points; 0: markers only.
    pub width_pt: f32,
    pub marker: Marker,
    /// Whether markers alone have an edge.
    pub is_ring: bool,
}

/// Navy, vermilion, sky blue, green: lightness 20, 52, 70, 40 of 100.
const LINE_COLORS: [[u8; 3]; 4] = [[0, 45, 98], [213, 84, 0], [86, 180, 233], [0, 110, 80]];
const LINE_DASHES: [&[f32]; 4] = [&[], &[9.0, 4.0], &[9.0, 3.0, 2.0, 3.0], &[4.0, 2.5]];
const LINE_MARKERS: [Marker; 4] = [Marker::Circle, Marker::Square, Marker::Triangle, Marker::Diamond];
/// Grey of the lightest body, of 255; the lines of the grid are lighter.
const LIGHTEST_BODY: f64 = 130.0;

impl Look {
    pub(super) fn line(index: usize) -> Self {
        let k = index % LINE_COLORS.len();
        Self { color: LINE_COLORS[k], dash: LINE_DASHES[k], width_pt: 1.8, marker: Marker::None, is_ring: false }
    }

    pub(super) fn with_marker(self, index: usize) -> Self {
        Self { marker: LINE_MARKERS[index % LINE_MARKERS.len()], ..self }
    }

    pub(super) fn without_line(self) -> Self {
        Self { width_pt: 0.0, ..self }
    }

    pub(super) fn band() -> Self {
        Self { color: [170, 205, 235], dash: &[], width_pt: 6.0, marker: Marker::None, is_ring: false }
    }

    pub(super) fn guide() -> Self {
        Self { color: [110, 110, 110], dash: &[1.5, 3.0], width_pt: 1.4, marker: Marker::None, is_ring: false }
    }

    pub(super) fn body(shade: f64) -> Self {
        Self { color: grey(shade), dash: &[], width_pt: 2.4, marker: Marker::None, is_ring: false }
    }

    pub(super) fn wheel(shade: f64) -> Self {
        Self { color: grey(shade), dash: &[], width_pt: 5.0, marker: Marker::None, is_ring: false }
    }

    pub(super) fn hinge() -> Self {
        Self { color: [255, 255, 255], dash: &[], width_pt: 0.0, marker: Marker::Circle, is_ring: true }
    }
}

fn grey(shade: f64) -> [u8; 3] {
    [(LIGHTEST_BODY * (1.0 - shade.clamp(0.0, 1.0))) as u8; 3]
}
