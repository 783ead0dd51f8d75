//! Colours, dashes and markers: distinct in colour, in lightness and in pattern.

use super::canvas::{Color, WHITE};

/// A marker at each point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    TriangleDown,
    Cross,
    Plus,
    Ring,
}

/// How a curve is drawn.
#[derive(Debug, Clone)]
pub(super) struct Look {
    pub color: Color,
    /// Lengths of strokes and gaps in points, empty for a solid line.
    pub dash: &'static [f64],
    /// Width in points; 0: markers only.
    pub width: f64,
    pub marker: Option<Marker>,
    /// Size of a marker in points.
    pub size: f64,
}

/// How many looks differ in all of colour, dash and marker.
const N_LOOKS: usize = 8;

/// Navy, vermilion, sky blue, green, gold, purple, grey, rose: neighbours differ in lightness.
const COLORS: [Color; N_LOOKS] = [
    [0, 45, 98],
    [213, 84, 0],
    [86, 180, 233],
    [0, 110, 80],
    [206, 165, 20],
    [118, 42, 131],
    [106, 106, 106],
    [214, 115, 165],
];
const DASHES: [&[f64]; N_LOOKS] = [
    &[],
    &[9.0, 4.0],
    &[9.0, 3.0, 2.0, 3.0],
    &[4.0, 2.5],
    &[16.0, 4.0],
    &[9.0, 3.0, 2.0, 3.0, 2.0, 3.0],
    &[2.0, 2.5],
    &[16.0, 3.0, 5.0, 3.0],
];
const MARKERS: [Marker; N_LOOKS] = [
    Marker::Circle,
    Marker::Square,
    Marker::Triangle,
    Marker::Diamond,
    Marker::TriangleDown,
    Marker::Cross,
    Marker::Plus,
    Marker::Ring,
];

const LINE: f64 = 1.7;
const MARKER: f64 = 7.0;
/// How far the halo of a curve goes beyond it, both sides together.
const HALO: f64 = 3.0;
/// Grey of the lightest body, of 255; the lines of the grid are lighter.
const LIGHTEST_BODY: f64 = 150.0;

impl Look {
    /// The look of line `index`; colours come again after eight lines, with other dashes, and both after 64.
    pub(super) fn line(index: usize) -> Self {
        let pattern = (index + index / N_LOOKS) % N_LOOKS;
        Self { color: COLORS[index % N_LOOKS], dash: DASHES[pattern], width: LINE, marker: None, size: MARKER }
    }

    pub(super) fn with_marker(self, index: usize) -> Self {
        Self { marker: Some(MARKERS[(index + index / N_LOOKS) % N_LOOKS]), ..self }
    }

    pub(super) fn without_line(self) -> Self {
        Self { width: 0.0, size: 4.5, ..self }
    }

    /// What lies under a curve so that it is seen on any colour.
    pub(super) fn halo(&self) -> Self {
        let (width, size) = (self.width + HALO, self.size + HALO);
        Self { color: WHITE, dash: &[], width, marker: Some(Marker::Circle), size }
    }

    pub(super) fn band() -> Self {
        Self { color: [170, 205, 235], dash: &[], width: 6.0, marker: None, size: 0.0 }
    }

    pub(super) fn guide() -> Self {
        Self { color: [110; 3], dash: &[1.5, 3.0], width: 1.3, marker: None, size: 0.0 }
    }

    pub(super) fn body(shade: f64) -> Self {
        Self { color: grey(shade), dash: &[], width: 2.2, marker: None, size: 0.0 }
    }

    pub(super) fn wheel(shade: f64) -> Self {
        Self { width: 4.6, ..Self::body(shade) }
    }

    pub(super) fn hinge() -> Self {
        Self { color: [0; 3], dash: &[], width: 0.0, marker: Some(Marker::Ring), size: 7.0 }
    }

    /// Small full dots.
    pub(super) fn marks() -> Self {
        Self { color: [0; 3], dash: &[], width: 0.0, marker: Some(Marker::Circle), size: 5.0 }
    }
}

fn grey(shade: f64) -> Color {
    [(LIGHTEST_BODY * (1.0 - shade.clamp(0.0, 1.0))) as u8; 3]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn invariant_looks_of_64_lines_are_distinct_even_without_colour_of_the_first_eight() {
        let looks: Vec<Look> = (0..64).map(|i| Look::line(i).with_marker(i)).collect();
        let lightness = |c: Color| 299 * u32::from(c[0]) + 587 * u32::from(c[1]) + 114 * u32::from(c[2]);
        let bits = |dash: &[f64]| dash.iter().map(|length| length.to_bits()).collect::<Vec<_>>();
        let all: HashSet<_> = looks.iter().map(|look| (look.color, bits(look.dash))).collect();
        let grey: HashSet<_> = looks[..8].iter().map(|look| bits(look.dash)).collect();
        let markers: HashSet<_> = looks[..8].iter().map(|look| look.marker).collect();
        assert_eq!((all.len(), grey.len(), markers.len()), (64, 8, 8));
        // a twentieth of the range of grey between neighbours
        assert!(looks[..8].windows(2).all(|pair| lightness(pair[0].color).abs_diff(lightness(pair[1].color)) > 12_750));
    }
}
