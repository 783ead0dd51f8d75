//! The colour bar of a map: which colour stands for which value.

use super::canvas::{Anchor, BLACK, Canvas, Frame};
use super::color_scale::ColorScale;
use super::legend::SIZE;
use super::map::{Grid, Map};
use super::panel::{TICK, TICK_GAP, TICK_SIZE};
use super::sheet::{LABEL_SIZE, LINE, Width};
use super::ticks::{self, Ticks};
use super::{hatch, lettering, range, raster};

/// Width of contours in points, and of their marks in the bar.
pub(super) const CONTOUR_WIDTH: f64 = 0.9;
/// Thickness of the bar, and its distance from the axes beside it and from the text above it.
const THICKNESS: f64 = 16.0;
const BESIDE: f64 = 18.0;
const BELOW: f64 = 10.0;
/// Space between tick labels and the name of the values.
const LABEL_GAP: f64 = 6.0;
/// Between the bar and the sample of cells without value, and what stands beside this sample.
const SAMPLE_GAP: f64 = 10.0;
const NO_VALUE: &str = "no value";
const NO_VALUE_GAP: f64 = 5.0;
/// From the bar up to its scale, which stands above the label of a tick at its end.
const HEAD: f64 = 11.0;
/// Ticks, which are the values of contours, at most.
const MOST_TICKS: usize = 12;
/// Least space between labels beside each other.
const TICK_SPACE: f64 = 8.0;

/// The colour bar of a map.
pub(super) struct ColorBar {
    pub scale: ColorScale,
    pub ticks: Ticks,
    /// Name and unit of the values, in lines.
    label: Vec<String>,
    has_missing: bool,
    width: Width,
}

impl ColorBar {
    /// The colour bar of `map` in a picture of this width, with about `length` for its name or its ticks; `extent` is that of the values.
    pub(super) fn new(map: &Map, grid: &Grid, extent: [f64; 2], width: Width, length: f64) -> Self {
        let limits = range::widened(extent, 0.0);
        let has_missing = grid.has_missing();
        let length = if has_missing { length - THICKNESS - SAMPLE_GAP } else { length };
        let ticks = match width {
            Width::Wide => ticks::linear(limits, MOST_TICKS),
            Width::Narrow => ticks_with_room(limits, length),
        };
        Self {
            scale: ColorScale { limits },
            ticks,
            label: lettering::wrapped(&map.z_label, LABEL_SIZE, length),
            has_missing,
            width,
        }
    }

    /// Width that it takes beside the axes.
    pub(super) fn beside(&self) -> f64 {
        if self.width == Width::Narrow {
            return 0.0;
        }
        let labels = self.ticks.major.iter().map(|(_, label)| label.as_str());
        let labels = labels.map(|label| lettering::width(label, TICK_SIZE)).fold(0.0, f64::max);
        let name = LABEL_GAP + self.label.len() as f64 * LINE * LABEL_SIZE;
        let scale = self.ticks.scale.as_ref().map_or(0.0, |scale| lettering::width(scale, TICK_SIZE));
        let no_value = if self.has_missing { NO_VALUE_GAP + lettering::width(NO_VALUE, SIZE) } else { 0.0 };
        let right = (TICK + TICK_GAP + labels + name).max(no_value).max(scale - THICKNESS);
        BESIDE + THICKNESS + right
    }

    /// Height that its scale takes above the axes.
    pub(super) fn above(&self) -> f64 {
        if self.width == Width::Wide && self.ticks.scale.is_some() { HEAD + LINE * TICK_SIZE } else { 0.0 }
    }

    /// Draws it beside the axes.
    pub(super) fn draw_beside(&self, canvas: &mut Canvas, axes: &Frame) {
        let left = axes.right + BESIDE;
        let mut bar = Frame { left, top: axes.top, right: left + THICKNESS, bottom: axes.bottom };
        if self.has_missing {
            self.draw_no_value(canvas, [bar.left, bar.bottom - THICKNESS]);
            bar.bottom -= THICKNESS + SAMPLE_GAP;
        }
        canvas.image(raster::all_colors(true), bar);
        let mut right = 0.0_f64;
        for (value, label) in &self.ticks.major {
            let y = bar.bottom - self.scale.part(*value) * bar.height();
            canvas.line([bar.left, y], [bar.right, y], self.scale.ink(*value), CONTOUR_WIDTH);
            canvas.line([bar.right, y], [bar.right + TICK, y], BLACK, 1.0);
            let place = [bar.right + TICK + TICK_GAP, y + 0.36 * TICK_SIZE];
            right = right.max(canvas.text(label, place, Anchor::Start, TICK_SIZE).right);
        }
        canvas.frame(&bar, BLACK, 1.0);
        if let Some(scale) = &self.ticks.scale {
            canvas.text(scale, [bar.left, bar.top - HEAD], Anchor::Start, TICK_SIZE);
        }
        for (i, line) in self.label.iter().enumerate() {
            let x = right + LABEL_GAP + (i as f64 + 1.0) * LINE * LABEL_SIZE - 0.3 * LABEL_SIZE;
            canvas.text_upwards(line, [x, 0.5 * (bar.top + bar.bottom)], LABEL_SIZE);
        }
    }

    /// Draws it from `top` on, from `left` to `right`; returns where it ends.
    pub(super) fn draw_below(&self, canvas: &mut Canvas, [left, right]: [f64; 2], top: f64) -> f64 {
        let top = top + BELOW;
        let bar = Frame { left, top, right, bottom: top + THICKNESS };
        canvas.image(raster::all_colors(false), bar);
        let mut bottom = bar.bottom + TICK + TICK_GAP + LINE * TICK_SIZE;
        for (value, label) in &self.ticks.major {
            let x = bar.left + self.scale.part(*value) * bar.width();
            canvas.line([x, bar.top], [x, bar.bottom], self.scale.ink(*value), CONTOUR_WIDTH);
            canvas.line([x, bar.bottom], [x, bar.bottom + TICK], BLACK, 1.0);
            let base = bar.bottom + TICK + TICK_GAP + lettering::RISE * TICK_SIZE;
            canvas.text(label, [x, base], Anchor::Middle, TICK_SIZE);
        }
        canvas.frame(&bar, BLACK, 1.0);
        if let Some(scale) = &self.ticks.scale {
            bottom += LINE * TICK_SIZE;
            canvas.text(scale, [bar.right, bottom - 0.3 * TICK_SIZE], Anchor::End, TICK_SIZE);
        }
        for line in &self.label {
            bottom += LINE * LABEL_SIZE;
            canvas.text(line, [0.5 * (bar.left + bar.right), bottom - 0.2 * LABEL_SIZE], Anchor::Middle, LABEL_SIZE);
        }
        if self.has_missing {
            self.draw_no_value(canvas, [bar.left, bottom + SAMPLE_GAP]);
            bottom += SAMPLE_GAP + THICKNESS;
        }
        bottom
    }

    /// A sample of cells without value, from its upper left corner on.
    fn draw_no_value(&self, canvas: &mut Canvas, [left, top]: [f64; 2]) {
        let sample = Frame { left, top, right: left + THICKNESS, bottom: top + THICKNESS };
        canvas.fill(&sample, raster::MISSING);
        hatch::draw(canvas, &sample, |_| true);
        canvas.frame(&sample, BLACK, 1.0);
        let base = 0.5 * (sample.top + sample.bottom) + 0.36 * SIZE;
        canvas.text(NO_VALUE, [sample.right + NO_VALUE_GAP, base], Anchor::Start, SIZE);
    }
}

/// As many ticks as have room for their labels beside each other.
fn ticks_with_room(limits: [f64; 2], length: f64) -> Ticks {
    let has_room = |ticks: &Ticks| {
        let widths = ticks.major.iter().map(|(_, label)| lettering::width(label, TICK_SIZE) + TICK_SPACE);
        widths.fold(0.0, f64::max) * ticks.major.len() as f64 <= length
    };
    let mut tried = (2..=MOST_TICKS).rev().map(|n| ticks::linear(limits, n));
    tried.find(has_room).unwrap_or_else(|| ticks::linear(limits, 2))
}
