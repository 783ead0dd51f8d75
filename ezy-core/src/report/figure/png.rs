//! A picture as PNG.

use tiny_skia::{FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform};

use super::canvas::{Canvas, Color, Segment, Shape};

/// Pixels in a point: 2000 across, sharp on a projector.
const PIXELS_OF_POINT: f32 = 2.5;

/// The picture as the bytes of a file; `None` where it has more pixels than can be kept.
pub(super) fn png(canvas: &Canvas) -> Option<Vec<u8>> {
    let [width, height] = [canvas.width, canvas.height].map(|points| (points as f32 * PIXELS_OF_POINT).round() as u32);
    let mut pixels = Pixmap::new(width, height)?;
    let scale = Transform::from_scale(PIXELS_OF_POINT, PIXELS_OF_POINT);
    for shape in &canvas.shapes {
        match shape {
            Shape::Stroke { outline, color, width, dash } => {
                let Some(path) = path(outline) else { continue };
                let dash = StrokeDash::new(dash.iter().map(|length| *length as f32).collect(), 0.0);
                let stroke = Stroke { width: *width as f32, line_join: LineJoin::Round, dash, ..Stroke::default() };
                pixels.stroke_path(&path, &paint(*color), &stroke, scale, None);
            }
            Shape::Fill { outline, color } | Shape::Text { outline, color, .. } => {
                let Some(path) = path(outline) else { continue };
                pixels.fill_path(&path, &paint(*color), FillRule::Winding, scale, None);
            }
        }
    }
    pixels.encode_png().ok()
}

fn paint([red, green, blue]: Color) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, u8::MAX);
    paint
}

/// `None` for an outline without extent, of which nothing is seen.
pub(crate) fn path(outline: &[Segment]) -> Option<Path> {
    let mut path = PathBuilder::new();
    for segment in outline {
        match segment {
            Segment::Move([x, y]) => path.move_to(*x as f32, *y as f32),
            Segment::Line([x, y]) => path.line_to(*x as f32, *y as f32),
            Segment::Curve([cx, cy], [x, y]) => path.quad_to(*cx as f32, *cy as f32, *x as f32, *y as f32),
            Segment::Close => path.close(),
        }
    }
    path.finish()
}
