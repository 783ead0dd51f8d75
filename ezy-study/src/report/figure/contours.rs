//! A map within its axes: cells and contours.

use super::canvas::{Canvas, Frame, Place, Segment};
use super::color_bar::{CONTOUR_WIDTH, ColorBar};
use super::contour::{Contour, contour, length};
use super::map::Grid;
use super::panel::Scales;
use super::room::Room;
use super::{contour_labels, hatch, range, raster};

/// What extends less, in points, is a speck of noise.
const LEAST: f64 = 18.0;
/// Contours that cover a larger part of the map than this hide the noise that they are drawn over, and make the file large.
const MOST_COVERED: f64 = 0.15;

/// Draws cells and contours; `room` knows what will lie over them, and in the end the labels of contours, too.
pub(super) fn draw_map(canvas: &mut Canvas, scales: &Scales, grid: &Grid, bar: &ColorBar, room: &mut Room) {
    let ([x_low, x_high], [y_low, y_high]) = (grid.x.limits(), grid.y.limits());
    let ([left, bottom], [right, top]) = (scales.place([x_low, y_low]), scales.place([x_high, y_high]));
    let frame = Frame { left, top, right, bottom };
    canvas.image(raster::cells(grid, &bar.scale, &frame), frame);
    if grid.has_missing() {
        hatch::draw(canvas, &frame, |[x, y]| {
            let part = [(x - left) / frame.width(), (bottom - y) / frame.height()];
            grid.value(grid.x.cell_at(part[0]), grid.y.cell_at(part[1])).is_nan()
        });
    }
    let contours = contours(scales, grid, bar);
    for contour in &contours {
        let outline = contour.pieces.iter().flat_map(|places| {
            let lines = places[1..].iter().map(|place| Segment::Line(*place));
            std::iter::once(Segment::Move(places[0])).chain(lines)
        });
        canvas.stroke(outline.collect(), bar.scale.ink(contour.value), CONTOUR_WIDTH, &[]);
    }
    contour_labels::draw(canvas, &contours, bar, room);
}

/// The contours at the ticks of the colour bar; none where they would hide the map.
fn contours(scales: &Scales, grid: &Grid, bar: &ColorBar) -> Vec<Contour> {
    // contours of a constant value are rounding
    if grid.extent().is_none_or(range::is_single) {
        return Vec::new();
    }
    let at = |(value, label): &(f64, String)| {
        let pieces = contour(grid, *value).into_iter();
        let pieces = pieces.map(|piece| piece.into_iter().map(|point| scales.place(point)).collect::<Vec<_>>());
        Contour { value: *value, label: label.clone(), pieces: pieces.filter(|piece| extent(piece) >= LEAST).collect() }
    };
    let all: Vec<Contour> = bar.ticks.major.iter().map(at).filter(|contour| !contour.pieces.is_empty()).collect();
    let covered: f64 = all.iter().flat_map(|contour| &contour.pieces).map(|piece| CONTOUR_WIDTH * length(piece)).sum();
    let is_seen = covered <= MOST_COVERED * scales.frame.width() * scales.frame.height();
    if is_seen { all } else { Vec::new() }
}

/// The diagonal of the rectangle around places.
fn extent(places: &[Place]) -> f64 {
    let span = |k: usize| {
        let values = places.iter().map(|place| place[k]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    span(0).hypot(span(1))
}

#[cfg(test)]
mod tests {
    use crate::report::figure::canvas::{Frame, Shape};
    use crate::report::figure::draw::picture;
    use crate::report::figure::sheet::Width;
    use crate::report::figure::{Figure, FigureError, color_scale, png, raster};

    /// What a page carries without a thought.
    const MOST_BYTES: usize = 1_000_000;

    fn places(n: usize) -> Vec<f64> {
        (0..n).map(|k| k as f64 / n as f64).collect()
    }

    fn map(n_x: usize, n_y: usize, z: impl FnMut(usize) -> f64) -> Figure {
        let z = (0..n_x * n_y).map(z).collect();
        Figure::map("A map", "frequency [Hz]", "amplitude [m]", "speed [m/s]", places(n_x), places(n_y), z)
    }

    /// The colour of cell k of three beside each other in the bytes of a file.
    fn pixel(png: &[u8], frame: Frame, k: u8) -> [u8; 3] {
        let pixels = tiny_skia::Pixmap::decode_png(png).unwrap();
        let scale = f64::from(pixels.width()) / Width::Wide.points();
        let x = frame.left + frame.width() * (f64::from(k) + 0.5) / 3.0;
        let y = frame.top + frame.height() * 0.5;
        let pixel = pixels.pixel((x * scale) as u32, (y * scale) as u32).unwrap();
        [pixel.red(), pixel.green(), pixel.blue()]
    }

    #[test]
    fn cross_png_shows_cells_in_the_colours_and_places_of_the_svg() {
        let figure = map(3, 1, |k| [2.0, 5.0, 3.0][k]);
        let canvas = picture(&figure, Width::Wide).unwrap();
        let image = canvas.shapes.iter().find_map(|shape| match shape {
            Shape::Image { raster, frame } => Some((raster, *frame)),
            _ => None,
        });
        let (raster, frame) = image.unwrap();
        let png = png::png(&canvas).unwrap();
        for k in 0..3_u8 {
            let column = (usize::from(k) * 2 + 1) * raster.n_across as usize / 6;
            assert_eq!(pixel(&png, frame, k), raster.pixels[column], "cell {k}");
        }
        assert_eq!([0, 1].map(|k| pixel(&png, frame, k)), [0, usize::MAX].map(color_scale::color));
    }

    #[test]
    fn invariant_svg_of_a_million_cells_is_below_a_megabyte_even_of_noise() {
        let wave = map(1000, 1000, |k| (3e-5 * k as f64).sin() * (0.02 * (k % 1000) as f64).cos());
        let mut seed = 1_u64;
        let noise = map(256, 256, |_| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64
        });
        for (name, figure) in [("wave", wave), ("noise", noise)] {
            let picture = figure.picture().unwrap();
            let sizes = [picture.wide.len(), picture.narrow.len()];
            assert!(sizes.iter().all(|size| *size < MOST_BYTES), "{name}: {sizes:?}");
        }
    }

    #[test]
    fn invariant_map_without_values_is_empty_and_without_grid_says_why() {
        let nothing = map(4, 3, |_| f64::NAN).picture();
        assert!(matches!(nothing, Err(FigureError::Empty { .. })));
        let short = Figure::map("A map", "x", "y", "z", vec![0.0, 1.0], vec![0.0], vec![1.0]).picture();
        let text = short.map(|_| ()).unwrap_err().to_string();
        assert_eq!(
            text,
            "the map of figure `A map` has no grid: z has 1 values in place of 2 × 1; \
             give finite ascending x and y, and a z for each pair of them"
        );
    }

    #[test]
    fn invariant_maps_of_every_shape_and_size_of_numbers_are_drawn() {
        let values: [fn(usize) -> f64; 5] = [
            |_| 5.0,
            |k| 5.0 + 1e-15 * k as f64,
            |k| if k == 0 { 1.0 } else { f64::INFINITY },
            |k| (k as f64 - 3.0) * 1e299,
            |k| k as f64 * 1e-310,
        ];
        for (n_x, n_y) in [(1, 1), (1, 5), (5, 1), (2, 2), (300, 2)] {
            for (k, value) in values.iter().enumerate() {
                let canvas = picture(&map(n_x, n_y, value), Width::Narrow);
                let canvas = canvas.unwrap_or_else(|error| panic!("{n_x} × {n_y}, values {k}: {error}"));
                let is_image = |shape: &Shape| matches!(shape, Shape::Image { .. });
                let is_text =
                    |shape: &Shape, part: &str| matches!(shape, Shape::Text { text, .. } if text.contains(part));
                assert!(canvas.shapes.iter().any(is_image), "{n_x} × {n_y}, values {k}");
                let is_wrong = |shape: &Shape| is_text(shape, "NaN") || is_text(shape, "inf");
                assert!(!canvas.shapes.iter().any(is_wrong), "{n_x} × {n_y}, values {k}");
            }
        }
    }

    #[test]
    fn invariant_missing_cells_are_named_where_there_are_any() {
        let has_name = |figure: Figure| {
            let canvas = picture(&figure, Width::Narrow).unwrap();
            let is_grey = |shape: &Shape| matches!(shape, Shape::Fill { color, .. } if *color == raster::MISSING);
            let is_name = |shape: &Shape| matches!(shape, Shape::Text { text, .. } if text == "no value");
            [canvas.shapes.iter().any(is_grey), canvas.shapes.iter().any(is_name)]
        };
        assert_eq!(has_name(map(4, 4, |k| if k == 5 { f64::NAN } else { k as f64 })), [true; 2]);
        assert_eq!(has_name(map(4, 4, |k| k as f64)), [false; 2]);
    }
}
