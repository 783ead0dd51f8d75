//! A picture as a list of shapes, in points from the upper left corner. Knows nothing of figures.

use super::lettering;
pub(super) use super::outline::{Place, Segment};

/// A picture, from back to front.
#[derive(Debug, Clone)]
pub(super) struct Canvas {
    pub width: f64,
    pub height: f64,
    pub shapes: Vec<Shape>,
}

/// Red, green, blue.
pub(super) type Color = [u8; 3];

pub(super) const BLACK: Color = [0x1a; 3];
pub(super) const WHITE: Color = [0xff; 3];

/// What is drawn.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// A line of some width; `dash` holds lengths of strokes and gaps, empty for a solid line.
    Stroke { outline: Vec<Segment>, color: Color, width: f64, dash: &'static [f64] },
    /// A filled outline.
    Fill { outline: Vec<Segment>, color: Color },
    /// A filled outline that reads `text` within `frame`.
    Text {
        outline: Vec<Segment>,
        color: Color,
        text: String,
        #[cfg_attr(not(test), allow(dead_code, reason = "tests look for texts that meet"))]
        frame: Frame,
    },
    /// Equal rectangles of one colour each that fill `frame`, without blur between them.
    Image { raster: Raster, frame: Frame },
}

/// Colours of equal rectangles, row by row from the upper left one.
#[derive(Debug, Clone)]
pub(super) struct Raster {
    pub n_across: u32,
    pub n_down: u32,
    pub pixels: Vec<Color>,
}

/// An upright rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Frame {
    pub(super) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The frame with `margin` more on each side.
    pub(super) fn widened(&self, margin: f64) -> Self {
        let Self { left, top, right, bottom } = *self;
        Self { left: left - margin, top: top - margin, right: right + margin, bottom: bottom + margin }
    }

    /// Whether `other` lies within.
    pub(super) fn holds(&self, other: &Self) -> bool {
        self.left <= other.left && other.right <= self.right && self.top <= other.top && other.bottom <= self.bottom
    }

    fn outline(&self) -> Vec<Segment> {
        let Self { left, top, right, bottom } = *self;
        vec![
            Segment::Move([left, top]),
            Segment::Line([right, top]),
            Segment::Line([right, bottom]),
            Segment::Line([left, bottom]),
            Segment::Close,
        ]
    }
}

/// Which part of a text stands at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Canvas {
    /// An empty sheet.
    pub(super) fn new(width: f64, height: f64) -> Self {
        Self { width, height, shapes: Vec::new() }
    }

    /// Sets the height, and makes the sheet white.
    pub(super) fn set_height(&mut self, height: f64) {
        self.height = height;
        let sheet = Frame { left: 0.0, top: 0.0, right: self.width, bottom: height };
        self.shapes.insert(0, Shape::Fill { outline: sheet.outline(), color: WHITE });
    }

    pub(super) fn fill(&mut self, frame: &Frame, color: Color) {
        self.fill_outline(frame.outline(), color);
    }

    pub(super) fn fill_outline(&mut self, outline: Vec<Segment>, color: Color) {
        self.shapes.push(Shape::Fill { outline, color });
    }

    pub(super) fn frame(&mut self, frame: &Frame, color: Color, width: f64) {
        self.stroke(frame.outline(), color, width, &[]);
    }

    pub(super) fn stroke(&mut self, outline: Vec<Segment>, color: Color, width: f64, dash: &'static [f64]) {
        self.shapes.push(Shape::Stroke { outline, color, width, dash });
    }

    pub(super) fn line(&mut self, from: Place, to: Place, color: Color, width: f64) {
        self.stroke(vec![Segment::Move(from), Segment::Line(to)], color, width, &[]);
    }

    /// Equal rectangles that fill `frame`.
    pub(super) fn image(&mut self, raster: Raster, frame: Frame) {
        self.shapes.push(Shape::Image { raster, frame });
    }

    /// A line of text with its base line at `place`, and where it stands.
    pub(super) fn text(&mut self, text: &str, place: Place, anchor: Anchor, size: f64) -> Frame {
        self.text_in(BLACK, text, place, anchor, size)
    }

    /// The same in a colour.
    pub(super) fn text_in(&mut self, color: Color, text: &str, place: Place, anchor: Anchor, size: f64) -> Frame {
        let width = lettering::width(text, size);
        let left = place[0] - shift(anchor, width);
        let outline = lettering::outline(text, size, |[x, y]| [left + x, place[1] - y]);
        let frame = Frame {
            left,
            right: left + width,
            top: place[1] - lettering::RISE * size,
            bottom: place[1] + lettering::FALL * size,
        };
        self.shapes.push(Shape::Text { outline, color, text: text.to_owned(), frame });
        frame
    }

    /// A line of text that reads upwards, its middle at `place`.
    pub(super) fn text_upwards(&mut self, text: &str, place: Place, size: f64) {
        let width = lettering::width(text, size);
        let bottom = place[1] + 0.5 * width;
        let outline = lettering::outline(text, size, |[x, y]| [place[0] - y, bottom - x]);
        let frame = Frame {
            left: place[0] - lettering::RISE * size,
            right: place[0] + lettering::FALL * size,
            top: bottom - width,
            bottom,
        };
        self.shapes.push(Shape::Text { outline, color: BLACK, text: text.to_owned(), frame });
    }
}

/// How far the start of a text lies before its anchor.
fn shift(anchor: Anchor, width: f64) -> f64 {
    match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * width,
        Anchor::End => width,
    }
}
