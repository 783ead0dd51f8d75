//! Lines of equal value by marching squares (Lorensen and Cline 1987, in the plane).

use std::collections::{BTreeMap, BTreeSet};

use super::canvas::Place;
use super::map::Grid;

/// A contour in a picture.
pub(super) struct Contour {
    pub value: f64,
    /// The value as the colour bar writes it.
    pub label: String,
    pub pieces: Vec<Vec<Place>>,
}

/// The length of a line.
pub(super) fn length(places: &[Place]) -> f64 {
    places.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).sum()
}

/// The pieces of the line on which the values are `level`, in the coordinates of the grid.
///
/// Values are interpolated linearly along the sides of the squares whose corners are four cell centres; squares with a missing corner
/// have no line. A piece ends at the outer centres or at a missing cell, or it closes: its last point is then its first.
pub(super) fn contour(grid: &Grid, level: f64) -> Vec<Vec<[f64; 2]>> {
    let mut joined: BTreeMap<Side, Vec<Side>> = BTreeMap::new();
    for j in 1..grid.y.len() {
        for i in 1..grid.x.len() {
            for [a, b] in pieces_within(grid, [i - 1, j - 1], level) {
                joined.entry(a).or_default().push(b);
                joined.entry(b).or_default().push(a);
            }
        }
    }
    // first what has ends, so that no piece begins in its middle
    let ends = joined.iter().filter(|(_, others)| others.len() == 1).map(|(side, _)| *side);
    let starts: Vec<Side> = ends.chain(joined.keys().copied()).collect();
    let mut known = BTreeSet::new();
    let pieces = starts.into_iter().filter_map(|start| piece(&joined, start, &mut known));
    pieces.map(|sides| sides.into_iter().map(|side| crossing(grid, side, level)).collect()).collect()
}

/// A side of a square: from cell `from` to the next one across or up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    from: [usize; 2],
    is_upright: bool,
}

/// The lines within the square whose lower left corner is cell (i, j): none, one, or two at a saddle.
fn pieces_within(grid: &Grid, [i, j]: [usize; 2], level: f64) -> Vec<[Side; 2]> {
    // anticlockwise; side k goes from corner k to the next one
    let values = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| grid.value(i, j));
    if values.iter().any(|value| value.is_nan()) {
        return Vec::new();
    }
    let side = |from, is_upright| Side { from, is_upright };
    let sides = [side([i, j], false), side([i + 1, j], true), side([i, j + 1], false), side([i, j], true)];
    let above = values.map(|value| value >= level);
    let crossed: Vec<Side> = (0..4).filter(|k| above[*k] != above[(k + 1) % 4]).map(|k| sides[k]).collect();
    match crossed[..] {
        [a, b] => vec![[a, b]],
        [lower, right, upper, left] => {
            let mean: f64 = values.iter().map(|value| 0.25 * value).sum();
            // the middle belongs to the corners (i, j) and (i + 1, j + 1): the other two are cut off
            let cuts_others = (mean >= level) == above[0];
            if cuts_others { vec![[lower, right], [upper, left]] } else { vec![[left, lower], [right, upper]] }
        }
        _ => Vec::new(),
    }
}

/// The sides along a piece from one of them on; `None` if it is known.
fn piece(joined: &BTreeMap<Side, Vec<Side>>, start: Side, known: &mut BTreeSet<Side>) -> Option<Vec<Side>> {
    known.insert(start).then_some(())?;
    let mut sides = vec![start];
    let mut last = start;
    while let Some(next) = joined[&last].iter().copied().find(|side| !known.contains(side)) {
        known.insert(next);
        sides.push(next);
        last = next;
    }
    if sides.len() > 2 && joined[&last].contains(&start) {
        sides.push(start);
    }
    Some(sides)
}

/// Where the value along a side is `level`.
fn crossing(grid: &Grid, Side { from: [i, j], is_upright }: Side, level: f64) -> [f64; 2] {
    let [to_i, to_j] = if is_upright { [i, j + 1] } else { [i + 1, j] };
    let (a, b) = (grid.value(i, j), grid.value(to_i, to_j));
    // halves, so that a span of the largest numbers is one
    let part = (0.5 * level - 0.5 * a) / (0.5 * b - 0.5 * a);
    let between = |a: f64, b: f64| a * (1.0 - part) + b * part;
    [between(grid.x.centers[i], grid.x.centers[to_i]), between(grid.y.centers[j], grid.y.centers[to_j])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figure::map::Map;

    /// Rounding of an interpolated place of size one.
    const ROUNDING: f64 = 1e-14;

    /// `n` places from −1 to 1.
    fn places(n: usize) -> Vec<f64> {
        (0..n).map(|k| -1.0 + 2.0 * k as f64 / (n - 1) as f64).collect()
    }

    /// f on `n_x` by `n_y` places.
    fn grid([n_x, n_y]: [usize; 2], f: impl Fn(f64, f64) -> f64) -> Grid {
        let (x, y) = (places(n_x), places(n_y));
        let z = y.iter().flat_map(|y| x.iter().map(|x| f(*x, *y))).collect();
        Map::new("z", x, y, z).grid.unwrap()
    }

    fn is_closed(piece: &[[f64; 2]]) -> bool {
        piece[0] == piece[piece.len() - 1]
    }

    fn is_at_border([x, y]: [f64; 2]) -> bool {
        x.abs() == 1.0 || y.abs() == 1.0
    }

    #[test]
    fn analytic_contour_of_a_paraboloid_is_a_circle_within_the_error_of_interpolation() {
        const N: usize = 41;
        const RADIUS: f64 = 0.63;
        // linear interpolation over h misses a value by h²/8 times the second derivative, which is 2, and the place by this over the
        // gradient 2 r, where r is smaller than the radius by the error itself
        const H: f64 = 2.0 / (N - 1) as f64;
        const ERROR: f64 = H * H / 8.0 * 2.0 / (2.0 * (RADIUS - H * H / (8.0 * RADIUS)));
        let pieces = contour(&grid([N, N], |x, y| x * x + y * y), RADIUS * RADIUS);
        assert_eq!(pieces.len(), 1);
        assert!(is_closed(&pieces[0]) && pieces[0].len() > N);
        let errors: Vec<f64> = pieces[0].iter().map(|[x, y]| (x.hypot(*y) - RADIUS).abs()).collect();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        assert!(worst < ERROR, "{worst} above {ERROR}");
        // and the bound is no guess: half of it is reached
        assert!(worst > 0.5 * ERROR, "{worst} far below {ERROR}");
    }

    #[test]
    fn analytic_contour_of_a_plane_is_its_line_from_border_to_border() {
        let pieces = contour(&grid([17, 8], |x, y| 2.0 * x - 0.7 * y + 0.1), 0.3);
        assert_eq!(pieces.len(), 1);
        let piece = &pieces[0];
        assert!(piece.iter().all(|[x, y]| (2.0 * x - 0.7 * y - 0.2).abs() < ROUNDING), "{piece:?}");
        assert!(is_at_border(piece[0]) && is_at_border(piece[piece.len() - 1]), "{piece:?}");
        assert!(piece.windows(2).all(|pair| pair[0][1] < pair[1][1]) || piece.windows(2).all(|p| p[0][1] > p[1][1]));
    }

    #[test]
    fn invariant_contours_end_at_the_border_or_close_and_pass_each_square_once() {
        let waves = grid([40, 33], |x, y| (7.0 * x).sin() * (9.0 * y + x).cos() + 0.2 * (31.0 * x * y).sin());
        for level in [-0.8, -0.3, 0.0, 0.25, 0.7] {
            let pieces = contour(&waves, level);
            assert!(pieces.len() > 3, "{}", pieces.len());
            for piece in &pieces {
                let [first, last] = [piece[0], piece[piece.len() - 1]];
                assert!(is_closed(piece) || (is_at_border(first) && is_at_border(last)), "{first:?} to {last:?}");
            }
            let mut points: Vec<_> = pieces
                .iter()
                .flat_map(|piece| &piece[usize::from(is_closed(piece))..])
                .map(|point| point.map(f64::to_bits))
                .collect();
            let n = points.len();
            points.sort_unstable();
            points.dedup();
            assert_eq!(points.len(), n);
        }
    }

    #[test]
    fn analytic_saddle_is_decided_by_the_mean_of_its_corners() {
        // lower left and upper right are high
        let square = |high: f64| grid([2, 2], move |x, y| if x == y { high } else { 0.0 });
        let cuts_off = |pieces: &[Vec<[f64; 2]>], [x, y]: [f64; 2]| {
            pieces.iter().any(|piece| piece.iter().any(|p| p[0] == x) && piece.iter().any(|p| p[1] == y))
        };
        for (high, joins_high) in [(3.0, true), (1.5, false)] {
            let pieces = contour(&square(high), 1.0);
            assert_eq!(pieces.len(), 2);
            // the corner that a piece cuts off is that of the two borders at which it ends
            assert_eq!(cuts_off(&pieces, [1.0, -1.0]), joins_high, "{pieces:?}");
            assert_eq!(cuts_off(&pieces, [-1.0, -1.0]), !joins_high, "{pieces:?}");
        }
    }

    #[test]
    fn invariant_squares_with_a_missing_corner_have_no_contour() {
        let hole = |x: f64, y: f64| x.hypot(y) < 0.3;
        let pieces = contour(&grid([41, 41], |x, y| if hole(x, y) { f64::NAN } else { x }), 0.01);
        assert_eq!(pieces.len(), 2);
        assert!(pieces.iter().flatten().all(|[x, y]| !hole(*x, *y)));
    }

    #[test]
    fn invariant_constant_values_and_single_rows_have_no_contour() {
        assert!(contour(&grid([5, 4], |_, _| 5.0), 5.0).is_empty());
        let row = Map::new("z", places(4), vec![0.0], vec![0.0, 1.0, 2.0, 3.0]).grid.unwrap();
        assert!(contour(&row, 1.5).is_empty());
    }
}
