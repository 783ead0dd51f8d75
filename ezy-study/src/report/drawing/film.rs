//! Frames of a motion as pictures: one by one, or as one picture that moves.

use super::elements::{Placed, Vector};
use super::parts::{Drawing, Part, Pose};
use super::sketch::{OF_A_FILE, drawn};
use super::{STYLE, number};
use crate::report::page::escape;
use ezy_core::model::coordinate::n_bodies;

/// A motion larger than so many times the mechanism is shown from a camera that moves with the first body.
const FAR: f64 = 4.0;
/// Larger side of the picture, pixels.
const LARGEST: f64 = 960.0;
/// Around the picture, pixels.
const MARGIN: f64 = 40.0;

/// A motion that is shown on one sheet.
#[derive(Debug)]
pub struct Film<'a> {
    pub(super) drawing: &'a Drawing,
    pub(super) frames: &'a [Placed],
    title: String,
    /// Left, top, width and height, pixels.
    pub(super) view: [f64; 4],
    /// Whether the camera moves with the first body.
    follows: bool,
}

impl<'a> Film<'a> {
    /// Of frames in equal steps of time.
    pub fn new(drawing: &'a Drawing, frames: &'a [Placed], title: &str) -> Self {
        let whole = frames.iter().fold(EMPTY, |all, frame| joined(all, outline(drawing, frame)));
        let [left, top, width, height] = drawing.outline();
        let size = width.max(height).max(1.0);
        let follows = (whole[2] - whole[0]).max(whole[3] - whole[1]) > FAR * size;
        let view = match frames.first() {
            Some(first) if follows => {
                let [x, y] = drawing.pixels(first.centre(0));
                [x - size, y - 0.7 * size, 2.0 * size, 1.4 * size]
            }
            Some(_) => [whole[0], whole[1], whole[2] - whole[0], whole[3] - whole[1]],
            None => [left, top, width, height],
        };
        let [x, y, width, height] = view;
        let view = [x - MARGIN, y - MARGIN, width + 2.0 * MARGIN, height + 2.0 * MARGIN].map(f64::round);
        Self { drawing, frames, title: escape(title), view, follows }
    }

    /// Pixels across a frame whose longer side has 960.
    pub fn width(&self) -> u32 {
        let [_, _, width, height] = self.view;
        (LARGEST * width / width.max(height)).round().max(1.0) as u32
    }

    /// Each frame as the text of an SVG file.
    pub fn frames(&self) -> impl Iterator<Item = String> + '_ {
        self.frames.iter().map(|frame| {
            let parts: String = self.parts().map(|part| drawn(self.drawing, part, frame)).collect();
            let [x, y] = self.camera(frame);
            self.file(
                "",
                &format!("<g transform=\"translate({} {})\">\n{}{parts}</g>\n", number(x), number(y), self.trace()),
            )
        })
    }

    /// All frames as one SVG file that moves for so many seconds, over and over.
    pub fn moving(&self, seconds: f64) -> String {
        let mut style = format!(
            ".part, .camera {{ animation: {seconds}s linear infinite; }}\n\
             @media (prefers-reduced-motion: reduce) {{ .part, .camera {{ animation: none; }} }}\n"
        );
        let [first, ..] = self.frames else { return self.file("", "") };
        let mut parts = String::new();
        for (i, part) in self.parts().enumerate() {
            style += &format!("#p{i} {{ animation-name: p{i}; }}\n@keyframes p{i} {{ {} }}\n", self.keyframes(part));
            parts += &drawn(self.drawing, part, first).replacen("<g ", &format!("<g id=\"p{i}\" "), 1);
        }
        if self.follows {
            let keys = self.keys(|frame| {
                let [x, y] = self.camera(frame);
                format!("translate({}px,{}px)", number(x), number(y))
            });
            style += &format!(".camera {{ animation-name: camera; }}\n@keyframes camera {{ {keys} }}\n");
        }
        self.file(&style, &format!("<g class=\"camera\">\n{}{parts}</g>\n", self.trace()))
    }

    /// The parts that move; the arc of a torque would point one way also where the torque has changed its sign.
    pub(super) fn parts(&self) -> impl Iterator<Item = &Part> {
        self.drawing.parts.iter().filter(|part| part.class != "torque")
    }

    fn keyframes(&self, part: &Part) -> String {
        let mut last = None;
        self.keys(|frame| {
            let Pose { x, y, turn, stretch } = self.drawing.pose(part, frame);
            let turn = turn.map(|turn| {
                // the shorter way from one frame to the next
                let turn = last.map_or(turn, |last: f64| turn - 360.0 * ((turn - last) / 360.0).round());
                last = Some(turn);
                format!(" rotate({}deg)", number(turn))
            });
            let stretch = stretch.map(|stretch| format!(" scale({},1)", (stretch * 1e4).round() / 1e4));
            let [turn, stretch] = [turn, stretch].map(Option::unwrap_or_default);
            format!("translate({}px,{}px){turn}{stretch}", number(x), number(y))
        })
    }

    fn keys(&self, mut transform: impl FnMut(&Placed) -> String) -> String {
        let n = (self.frames.len().max(2) - 1) as f64;
        let keys = self
            .frames
            .iter()
            .enumerate()
            .map(|(i, frame)| format!("{}%{{transform:{}}}", number(100.0 * i as f64 / n), transform(frame)));
        keys.collect()
    }

    /// How far the sheet moves, pixels.
    pub(super) fn camera(&self, frame: &Placed) -> Vector {
        match (self.follows, self.frames.first()) {
            (true, Some(first)) => {
                let [from, to] = [first, frame].map(|frame| self.drawing.pixels(frame.centre(0)));
                [from[0] - to[0], from[1] - to[1]]
            }
            _ => [0.0; 2],
        }
    }

    /// The path of the first body, so that it is seen to move.
    pub(super) fn trace(&self) -> String {
        let points = self.frames.iter().map(|frame| self.drawing.pixels(frame.centre(0)));
        let points: Vec<String> = points.map(|[x, y]| format!("{} {}", number(x), number(y))).collect();
        format!("<path class=\"extension\" d=\"M{}\"/>\n", points.join("L"))
    }

    /// Pixels of the SVG file for a pixel of the drawing.
    pub(super) fn size(&self) -> f64 {
        LARGEST / self.view[2].max(self.view[3]).max(LARGEST)
    }

    fn file(&self, style: &str, content: &str) -> String {
        let ([x, y, w, h], title) = (self.view, &self.title);
        let [width, height] = [w, h].map(|side| (side * self.size()).round());
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ezy\" viewBox=\"{x} {y} {w} {h}\" width=\"{width}\" height=\"{height}\">\n\
             <title>{title}</title>\n<style>\n{OF_A_FILE}{STYLE}{style}</style>\n{content}</svg>\n"
        )
    }
}

/// Left, top, right and bottom of nothing.
const EMPTY: [f64; 4] = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];

fn joined(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]
}

/// Left, top, right and bottom of all points and centres of mass, pixels.
fn outline(drawing: &Drawing, frame: &Placed) -> [f64; 4] {
    let points = drawing.elements.points().map(|point| frame.position(point));
    let centres = (0..n_bodies(frame.q.len())).map(|i| frame.centre(i));
    points.chain(centres).map(|point| drawing.pixels(point)).fold(EMPTY, |all, [x, y]| joined(all, [x, y, x, y]))
}
