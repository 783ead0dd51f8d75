//! A picture as PNG.

use tiny_skia::{
    FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapPaint, PremultipliedColorU8, Stroke, StrokeDash,
    Transform,
};

use super::canvas::{Canvas, Color, Raster, Segment, Shape};

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
            Shape::Image { raster, frame } => {
                let Some(image) = pixels_of(raster) else { continue };
                let of_pixel = [frame.width() / f64::from(raster.n_across), frame.height() / f64::from(raster.n_down)];
                let [across, down, left, top] = [of_pixel[0], of_pixel[1], frame.left, frame.top].map(|x| x as f32);
                let place = Transform::from_row(across, 0.0, 0.0, down, left, top).post_concat(scale);
                // the quality of the default is that without blur
                pixels.draw_pixmap(0, 0, image.as_ref(), &PixmapPaint::default(), place, None);
            }
        }
    }
    pixels.encode_png().ok()
}

/// The raster as the bytes of a file; `None` if it has no pixels.
pub(super) fn of_raster(raster: &Raster) -> Option<Vec<u8>> {
    pixels_of(raster)?.encode_png().ok()
}

fn pixels_of(raster: &Raster) -> Option<Pixmap> {
    let mut pixels = Pixmap::new(raster.n_across, raster.n_down)?;
    for (pixel, [red, green, blue]) in pixels.pixels_mut().iter_mut().zip(&raster.pixels) {
        *pixel = PremultipliedColorU8::from_rgba(*red, *green, *blue, u8::MAX)?;
    }
    Some(pixels)
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
