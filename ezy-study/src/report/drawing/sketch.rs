//! A technical drawing of a mechanism: its parts, names, lengths and axes.

use super::dimensions::dimensions;
use super::elements::{Elements, Placed, Vector};
use super::lettering::Sheet;
use super::parts::{Drawing, Motion, Part};
use super::{STYLE, number};
use crate::report::page::escape;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::Sample;

/// Larger side of the mechanism on the sheet, pixels.
const SIDE: f64 = 560.0;
/// From one size that is tried to the next.
const SMALLER: f64 = 0.85;
const N_SIZES: i32 = 12;
/// Names are written up to so many.
const MOST_NAMES: usize = 24;
/// Size of the lettering of names, pixels.
const LETTERS: f64 = 15.0;
/// Around the sketch, pixels.
const MARGIN: f64 = 14.0;

/// Colours of a picture that is a file of its own; within a page it has those of the page.
pub(super) const OF_A_FILE: &str = "\
svg:root { color: #1b1d21; color-scheme: light dark; --paper: #fff; }
@media (prefers-color-scheme: dark) { svg:root { color: #e9eaee; --paper: #16181c; } }
";

/// The scene at a sample of a run, as the text of an SVG file.
pub fn sketch(scene: &dyn Scene, sample: &Sample<'_>) -> String {
    sheet(scene, sample, SIDE).0
}

/// The same on a sheet of at most so many pixels across and down, unless names and lengths alone need more. Letters stay as large as
/// they are; names for which there is no room are left out.
pub fn sketch_within(scene: &dyn Scene, sample: &Sample<'_>, [width, height]: [f64; 2]) -> String {
    let smallest = width.max(height) * SMALLER.powi(N_SIZES);
    let mut side = width.max(height);
    loop {
        let (svg, [w, h]) = sheet(scene, sample, side);
        if (w <= width && h <= height) || side <= smallest {
            return svg;
        }
        side *= SMALLER;
    }
}

/// The text of an SVG file, its width and its height.
fn sheet(scene: &dyn Scene, sample: &Sample<'_>, side: f64) -> (String, Vector) {
    let elements = Elements::new(scene);
    let at = elements.at_sample(scene, sample);
    let drawing = Drawing::new(scene, elements, &at, &[], Some(side));
    let info = scene.info();
    let parts: String = drawing.parts.iter().map(|part| drawn(&drawing, part, &at)).collect();
    let mut sheet = Sheet::default();
    let [left, top, width, height] = drawing.outline();
    sheet.take_line([[left, top], [left + width, top + height]], 0.0);
    let symbol = 10.0 * drawing.symbols;
    for point in drawing.elements.points() {
        let [x, y] = drawing.pixels(at.position(point));
        sheet.take([x - symbol, y - symbol, x + symbol, y + symbol]);
    }
    for part in &drawing.parts {
        if let Motion::At { point, along: Some(along) } = part.motion
            && part.class == "ground"
        {
            let ([x, y], [dx, dy]) = (drawing.pixels(at.position(point)), drawing.pixels(at.direction(along)));
            let length = dx.hypot(dy);
            let end = |along: f64| [x + along * dx / length, y + along * dy / length];
            sheet.take_line(part.reach.map(end), 12.0 * drawing.symbols);
        }
    }
    let lengths = dimensions(&mut sheet, &drawing.elements, &at, drawing.scale);
    names(&mut sheet, &drawing, &info, &at);
    let axes = axes(&mut sheet);
    let [left, top, right, bottom] = sheet.bounds();
    let [x, y, w, h] =
        [left - MARGIN, top - MARGIN, right - left + 2.0 * MARGIN, bottom - top + 2.0 * MARGIN].map(f64::round);
    let title = escape(&format!("{}, scene {}, at t = {} s", info.model, info.name, sample.t));
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ezy\" viewBox=\"{x} {y} {w} {h}\" width=\"{w}\" height=\"{h}\">\n\
         <title>{title}</title>\n<style>\n{OF_A_FILE}{STYLE}</style>\n{lengths}{parts}{axes}{}</svg>\n",
        sheet.svg
    );
    (svg, [w, h])
}

/// A part where it is.
pub(super) fn drawn(drawing: &Drawing, part: &Part, at: &Placed) -> String {
    let Part { class, title, svg, .. } = part;
    let transform = drawing.transform(part, at);
    format!("<g class=\"part {class}\" transform=\"{transform}\"><title>{title}</title>{svg}</g>\n")
}

/// Names of points, joints and bodies, and lengths of rods and stiffnesses beside them.
fn names(sheet: &mut Sheet, drawing: &Drawing, info: &SceneInfo, at: &Placed) {
    let mut labels: Vec<(Vector, String)> = Vec::new();
    for (i, element) in drawing.elements.iter().filter(|(_, element)| !element.points.is_empty()) {
        let place = match element.kind {
            "rod" | "spring" | "damper" => {
                let [a, b] = [0, 1].map(|k| drawing.pixels(at.position(drawing.elements.point(i, k))));
                let values: Vec<&str> = element.settings.iter().map(|(_, value)| *value).collect();
                let middle = [0, 1].map(|k| (a[k] + b[k]) / 2.0);
                sheet.take_line([a, b], 14.0 * drawing.symbols);
                let offsets = around(26.0);
                sheet.put(&values.join(", "), "length", LETTERS, middle, &offsets);
                continue;
            }
            _ => drawing.pixels(at.position(drawing.elements.point(i, 0))),
        };
        let is_near = |other: &Vector| (other[0] - place[0]).hypot(other[1] - place[1]) < 1.0;
        match labels.iter_mut().find(|(other, _)| is_near(other)) {
            // a point, or a hinge, has the shortest name there
            Some(_) if element.name.is_empty() => {}
            Some((_, text)) if element.name.len() < text.len() => *text = element.name.to_string(),
            Some(_) => {}
            None if element.name.is_empty() => {}
            None => labels.push((place, element.name.to_string())),
        }
    }
    let bodies =
        info.drawn_bodies().iter().enumerate().map(|(i, name)| (drawing.pixels(at.centre(i)), name.to_string()));
    labels.extend(bodies);
    if labels.len() > MOST_NAMES {
        return;
    }
    for (place, text) in labels {
        sheet.put(&text, "label", LETTERS, place, &around(15.0));
    }
}

/// Eight directions, beginning above to the right.
fn around(r: f64) -> [Vector; 8] {
    let d = 0.75 * r;
    [[d, -d], [-d, -d], [d, d], [-d, d], [0.0, -1.2 * r], [0.0, 1.2 * r], [r, 0.0], [-r, 0.0]]
}

/// The axes of the ground, in the lower left corner.
fn axes(sheet: &mut Sheet) -> String {
    let [left, _, _, bottom] = sheet.bounds();
    let (x, y) = (left + 4.0, bottom + 46.0);
    let path = |d: &str| format!("<path class=\"thin\" d=\"{d}\"/>");
    let [x0, y0] = [x, y].map(number);
    let arrows = format!("M{x0} {y0}h34m-6 -2.5l6 2.5l-6 2.5M{x0} {y0}v-34m-2.5 6l2.5 -6l2.5 6");
    sheet.take([x - 3.0, y - 36.0, x + 36.0, y + 3.0]);
    sheet.put("x", "length", LETTERS, [x + 42.0, y], &[[0.0, 0.0]]);
    sheet.put("y", "length", LETTERS, [x, y - 42.0], &[[0.0, 0.0]]);
    path(&arrows) + "\n"
}
