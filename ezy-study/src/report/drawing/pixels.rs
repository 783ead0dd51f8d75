//! Frames of a motion as pixels, with the colours of a page on white and the time.

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Pixmap, Stroke, Transform};

use super::film::Film;
use super::parts::Pose;
use super::pieces::{Piece, pieces};
use crate::report::figure::lettering;
use crate::report::figure::png::path;

/// Red, green, blue.
pub(super) type Rgb = [u8; 3];

// those of `drawing.css`
pub(super) const INK: Rgb = [0x1b, 0x1d, 0x21];
pub(super) const PAPER: Rgb = [0xff; 3];
pub(super) const RUBBER: Rgb = [0x8a, 0x8f, 0x98];
pub(super) const HUES: [Rgb; 6] = [
    [0x3b, 0x82, 0xc4],
    [0xd0, 0x8a, 0x1d],
    [0x3f, 0x9a, 0x5f],
    [0x90, 0x61, 0xc2],
    [0xc2, 0x50, 0x6a],
    [0x5f, 0x74, 0x80],
];
pub(super) const BODY_OPACITY: f64 = 0.2;

/// Size of the time and its distance from the corner, pixels of the SVG file.
const LETTERS: f64 = 20.0;

/// How a piece is drawn: colour and opacity of its inside, width and opacity of its line.
struct Look {
    fill: Option<(Rgb, f64)>,
    line: Option<(f64, f64)>,
}

/// The look of a piece in a part, both by their classes.
fn look(part: &str, piece: &str) -> Look {
    let hue = part.strip_prefix("hue").and_then(|digit| digit.parse::<usize>().ok()).unwrap_or(0);
    let (fill, line) = match piece {
        "body" => (Some((HUES[hue % HUES.len()], BODY_OPACITY)), Some((1.6, 1.0))),
        "paper" => (Some((PAPER, 1.0)), Some((1.6, 1.0))),
        "rubber" => (Some((RUBBER, 1.0)), Some((1.6, 1.0))),
        "solid" => (Some((INK, 1.0)), None),
        "thin" => (None, Some((1.0, 1.0))),
        "rod" => (None, Some((3.5, 1.0))),
        "extension" => (None, Some((0.7, 0.55))),
        _ => (None, Some((1.6, 1.0))),
    };
    Look { fill, line }
}

impl Film<'_> {
    /// A frame as the bytes of a PNG file so many pixels wide; `None` where that is too large.
    pub fn png(&self, frame: usize, width: u32) -> Option<Vec<u8>> {
        self.pixels(frame, width)?.encode_png().ok()
    }

    /// A frame as pixels, all of them opaque.
    pub(super) fn pixels(&self, frame: usize, width: u32) -> Option<Pixmap> {
        let at = self.frames.get(frame)?;
        let [left, top, view_width, view_height] = self.view;
        let scale = f64::from(width) / view_width;
        // lines and letters are as large as in the SVG file
        let line = scale / self.size();
        let mut pixels = Pixmap::new(width, (view_height * scale).round().max(1.0) as u32)?;
        let [red, green, blue] = PAPER;
        pixels.fill(Color::from_rgba8(red, green, blue, u8::MAX));
        let [dx, dy] = self.camera(at);
        let camera =
            Transform::from_translate((dx - left) as f32, (dy - top) as f32).post_scale(scale as f32, scale as f32);
        for piece in pieces(&self.trace()) {
            draw(&mut pixels, "", &piece, camera, line);
        }
        for part in self.parts() {
            let Pose { x, y, turn, stretch } = self.drawing.pose(part, at);
            let place = camera
                .pre_translate(x as f32, y as f32)
                .pre_rotate(turn.unwrap_or(0.0) as f32)
                .pre_scale(stretch.unwrap_or(1.0) as f32, 1.0);
            for piece in pieces(&part.svg) {
                draw(&mut pixels, &part.class, &piece, place, line);
            }
        }
        let size = LETTERS * line;
        let outline = lettering::outline(&self.time(at.t), size, |[x, y]| [x + 0.6 * size, 1.4 * size - y]);
        if let Some(text) = path(&outline) {
            pixels.fill_path(&text, &paint(INK, 1.0), FillRule::Winding, Transform::identity(), None);
        }
        Some(pixels)
    }

    /// `t = 1.25 s`, with as many decimals as tell frames apart.
    fn time(&self, t: f64) -> String {
        let span = self.frames.last().map_or(0.0, |last| last.t - self.frames[0].t);
        let decimals = if span > 0.0 { (2.0 - span.log10().floor()).clamp(0.0, 6.0) } else { 0.0 };
        format!("t = {t:.*} s", decimals as usize)
    }
}

fn draw(pixels: &mut Pixmap, part: &str, piece: &Piece<'_>, place: Transform, line: f64) {
    // a line is as wide in a part that is stretched
    let Some(path) = path(&piece.outline).and_then(|path| path.transform(place)) else { return };
    let Look { fill, line: stroke } = look(part, piece.class);
    if let Some((color, opacity)) = fill {
        pixels.fill_path(&path, &paint(color, opacity), FillRule::Winding, Transform::identity(), None);
    }
    if let Some((width, opacity)) = stroke {
        let (line_cap, line_join) = (LineCap::Round, LineJoin::Round);
        let stroke = Stroke { width: (width * line) as f32, line_cap, line_join, ..Stroke::default() };
        pixels.stroke_path(&path, &paint(INK, opacity), &stroke, Transform::identity(), None);
    }
}

fn paint([red, green, blue]: Rgb, opacity: f64) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, (255.0 * opacity).round() as u8);
    paint
}

#[cfg(test)]
mod tests {
    use super::super::STYLE;
    use super::super::sketch::OF_A_FILE;
    use super::*;

    #[test]
    fn cross_colours_and_widths_are_those_of_the_style() {
        let hexadecimal = |[red, green, blue]: Rgb| format!("#{red:02x}{green:02x}{blue:02x}");
        assert!(OF_A_FILE.contains(&hexadecimal(INK)) && STYLE.contains(&hexadecimal(RUBBER)));
        for (i, hue) in HUES.into_iter().enumerate() {
            assert!(STYLE.contains(&format!(".ezy .hue{i} {{ --hue: {}; }}", hexadecimal(hue))), "{i}");
        }
        assert!(STYLE.contains("fill-opacity: .2;") && BODY_OPACITY == 0.2);
        assert!(STYLE.contains(".ezy .rubber { stroke: currentColor; stroke-width: 1.6;"));
        for (class, width) in [("thin", "1"), ("rod", "3.5")] {
            assert!(STYLE.contains(&format!(".ezy .{class} {{ fill: none; stroke-width: {width}; }}")), "{class}");
            let (drawn, _) = look("", class).line.unwrap();
            assert_eq!(drawn, width.parse::<f64>().unwrap());
        }
    }
}
