//! Colours of values: from dark to light, so that a map keeps its meaning in grey print and for colour-blind readers.

use super::canvas::{BLACK, Color, WHITE};

/// Every 17th of the 256 colours of viridis (S. van der Walt and N. J. Smith, 2015, for matplotlib; public domain, CC0). What is
/// interpolated between them differs from the original by 7 of 255 at most.
const ANCHORS: [Color; 16] = [
    [68, 1, 84],
    [72, 26, 108],
    [71, 47, 125],
    [65, 68, 135],
    [57, 86, 140],
    [49, 104, 142],
    [42, 120, 142],
    [35, 136, 142],
    [31, 152, 139],
    [34, 168, 132],
    [53, 183, 121],
    [84, 197, 104],
    [122, 209, 81],
    [165, 219, 54],
    [210, 226, 27],
    [253, 231, 37],
];

/// Colours that are told apart: steps that the eye does not see, and few enough for small files.
pub(super) const N_COLORS: usize = 128;

/// Lightness L* above which a ground takes dark lines.
const LIGHT: f64 = 55.0;

/// The colours of values within limits.
#[derive(Debug, Clone, Copy)]
pub(super) struct ColorScale {
    /// The values of the darkest and of the lightest colour.
    pub limits: [f64; 2],
}

impl ColorScale {
    /// The colour of a value.
    pub(super) fn color(&self, value: f64) -> Color {
        color((self.part(value) * N_COLORS as f64) as usize)
    }

    /// What is seen on the colour of a value: black or white.
    pub(super) fn ink(&self, value: f64) -> Color {
        if lightness(self.color(value)) > LIGHT { BLACK } else { WHITE }
    }

    /// Where a value lies between the limits, from 0 to 1.
    pub(super) fn part(&self, value: f64) -> f64 {
        let [low, high] = self.limits;
        // halves, so that a span of the largest numbers is one
        ((0.5 * value - 0.5 * low) / (0.5 * high - 0.5 * low)).clamp(0.0, 1.0)
    }
}

/// Colour `index` of [`N_COLORS`]; the last one beyond them.
pub(super) fn color(index: usize) -> Color {
    let place = index.min(N_COLORS - 1) as f64 / (N_COLORS - 1) as f64 * (ANCHORS.len() - 1) as f64;
    let k = (place as usize).min(ANCHORS.len() - 2);
    let part = place - k as f64;
    let mixed = |i: usize| f64::from(ANCHORS[k][i]) * (1.0 - part) + f64::from(ANCHORS[k + 1][i]) * part;
    [mixed(0), mixed(1), mixed(2)].map(|value| value.round() as u8)
}

/// Lightness L* of CIELAB, from 0 (black) to 100 (white).
pub(super) fn lightness(color: Color) -> f64 {
    let linear = color.map(|value| {
        let value = f64::from(value) / 255.0;
        if value <= 0.040_45 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    });
    let luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    if luminance > 216.0 / 24389.0 { 116.0 * luminance.cbrt() - 16.0 } else { 24389.0 / 27.0 * luminance }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightness of the ends of viridis, and how far a rounded colour is from it: half a unit of 255 in each part.
    const ENDS: [f64; 2] = [14.5, 91.2];
    const ROUNDING: f64 = 0.5;
    /// How far the lightness is from a straight line: what is seen as even. Viridis has 1.5, interpolation adds to it.
    const UNEVEN: f64 = 2.5;

    #[test]
    fn analytic_lightness_of_black_grey_and_white_is_that_of_the_standard() {
        // grey 119 is L* = 50 (IEC 61966-2-1 with CIE 15)
        for (grey, expected) in [(0, 0.0), (119, 50.0), (255, 100.0)] {
            assert!((lightness([grey; 3]) - expected).abs() < ROUNDING, "{grey}");
        }
    }

    #[test]
    fn invariant_lightness_of_the_colour_scale_grows_evenly() {
        let all: Vec<f64> = (0..N_COLORS).map(|k| lightness(color(k))).collect();
        assert!(all.windows(2).all(|pair| pair[0] < pair[1]), "{all:?}");
        let (first, last) = (all[0], all[N_COLORS - 1]);
        assert!((first - ENDS[0]).abs() < ROUNDING && (last - ENDS[1]).abs() < ROUNDING, "{first} {last}");
        for (k, lightness) in all.iter().enumerate() {
            let even = first + (last - first) * k as f64 / (N_COLORS - 1) as f64;
            assert!((lightness - even).abs() < UNEVEN, "colour {k}: {lightness} in place of {even}");
        }
    }

    #[test]
    fn invariant_values_at_and_beyond_the_limits_have_the_colours_of_the_ends() {
        let scale = ColorScale { limits: [-f64::MAX, f64::MAX] };
        assert_eq!([-f64::MAX, f64::MAX].map(|value| scale.color(value)), [ANCHORS[0], ANCHORS[15]]);
        let scale = ColorScale { limits: [1.0, 2.0] };
        assert_eq!([0.0, 1.0, 2.0, 3.0].map(|value| scale.part(value)), [0.0, 0.0, 1.0, 1.0]);
    }
}
