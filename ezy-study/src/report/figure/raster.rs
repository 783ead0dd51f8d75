//! The cells of a map as pixels.

use super::canvas::{Color, Frame, Raster};
use super::color_scale::{self, ColorScale};
use super::map::{Grid, Side};

/// Pixels in a point at least: where cells are not equally wide, their edges are off by half a pixel.
const PIXELS_OF_POINT: f64 = 1.5;

/// Grey of cells without value.
pub(super) const MISSING: Color = [0xe4; 3];

/// The cells in the colours of their values, to fill `frame`.
pub(super) fn cells(grid: &Grid, scale: &ColorScale, frame: &Frame) -> Raster {
    let (across, down) = (pixels(&grid.x, frame.width()), pixels(&grid.y, frame.height()));
    let color = |value: f64| if value.is_nan() { MISSING } else { scale.color(value) };
    let rows = down.iter().rev().flat_map(|i_y| across.iter().map(|i_x| color(grid.value(*i_x, *i_y))));
    Raster { n_across: across.len() as u32, n_down: down.len() as u32, pixels: rows.collect() }
}

/// All colours: from the left, or from below.
pub(super) fn all_colors(is_upright: bool) -> Raster {
    let n = color_scale::N_COLORS;
    let colors = (0..n).map(color_scale::color);
    let [n_across, n_down] = if is_upright { [1, n as u32] } else { [n as u32, 1] };
    Raster { n_across, n_down, pixels: if is_upright { colors.rev().collect() } else { colors.collect() } }
}

/// The cell of each pixel along a side. Cells of equal width have the same number of pixels.
fn pixels(side: &Side, length: f64) -> Vec<usize> {
    let n_of_cell = (PIXELS_OF_POINT * length / side.len() as f64).ceil().max(1.0) as usize;
    let n = n_of_cell * side.len();
    (0..n).map(|k| side.cell_at((k as f64 + 0.5) / n as f64)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figure::hatch;
    use crate::report::figure::map::Map;

    const FRAME: Frame = Frame { left: 10.0, top: 20.0, right: 110.0, bottom: 80.0 };

    fn raster(x: &[f64], y: &[f64], z: &[f64]) -> Raster {
        let grid = Map::new("z", x.to_vec(), y.to_vec(), z.to_vec()).grid.unwrap();
        let scale = ColorScale { limits: grid.extent().unwrap() };
        cells(&grid, &scale, &FRAME)
    }

    /// The colour in the middle of a part of the raster.
    fn at(raster: &Raster, [across, down]: [f64; 2]) -> Color {
        let [i, j] = [across * f64::from(raster.n_across), down * f64::from(raster.n_down)].map(|x| x as usize);
        raster.pixels[j * raster.n_across as usize + i]
    }

    #[test]
    fn analytic_pixels_have_the_colours_of_their_cells_with_y_upwards() {
        let raster = raster(&[0.0, 1.0], &[5.0, 6.0], &[0.0, 1.0, 1.0, 0.0]);
        let (dark, light) = (color_scale::color(0), color_scale::color(usize::MAX));
        let corners = [[0.01, 0.99], [0.49, 0.51], [0.51, 0.49], [0.99, 0.01], [0.49, 0.49], [0.51, 0.51]];
        assert_eq!(corners.map(|corner| at(&raster, corner)), [dark, dark, dark, dark, light, light]);
    }

    #[test]
    fn analytic_cells_of_unequal_width_keep_their_edges_within_a_pixel() {
        // edges at −3, 2, 8 and 15
        let raster = raster(&[-0.5, 4.5, 11.5], &[0.0], &[0.0, 1.0, 0.0]);
        let n = raster.n_across as usize;
        let light = raster.pixels[..n].iter().filter(|color| **color == color_scale::color(usize::MAX)).count();
        assert!((light as f64 - n as f64 * 6.0 / 18.0).abs() <= 1.0, "{light} of {n}");
    }

    #[test]
    fn invariant_missing_cells_are_grey_with_lines_that_grey_print_shows() {
        let raster = raster(&[0.0, 1.0], &[0.0], &[f64::NAN, 1.0]);
        let n = raster.n_across as usize;
        let (left, right) = raster.pixels[..n].split_at(n / 2);
        assert!(left.iter().all(|color| *color == MISSING) && !right.contains(&MISSING));
        // a quarter of the range of lightness
        assert!(color_scale::lightness(MISSING) - color_scale::lightness(hatch::COLOR) > 25.0);
    }
}
