//! Markers as outlines.

use super::canvas::{Canvas, Place, Segment, WHITE};
use super::look::{Look, Marker};

/// Width of the strokes of a cross and of a ring, in points.
const STROKE: f64 = 1.5;
/// Half of the side of a square that looks as large as a circle, of its radius; the same for a triangle's height.
const SQUARE: f64 = 0.88;
const TRIANGLE: f64 = 1.15;

/// Draws the marker of a look at a place.
pub(super) fn draw(canvas: &mut Canvas, look: &Look, [x, y]: Place) {
    let Some(marker) = look.marker else { return };
    let r = 0.5 * look.size;
    let corners = |corners: &[Place]| -> Vec<Segment> {
        let place = |corner: &Place| [x + r * corner[0], y + r * corner[1]];
        let mut outline: Vec<Segment> = corners.iter().map(|corner| Segment::Line(place(corner))).collect();
        outline[0] = Segment::Move(place(&corners[0]));
        outline.push(Segment::Close);
        outline
    };
    let (t, s) = (TRIANGLE, SQUARE);
    let mut fill = |outline| canvas.fill_outline(outline, look.color);
    match marker {
        Marker::Circle => fill(circle([x, y], r)),
        Marker::Square => fill(corners(&[[-s, -s], [s, -s], [s, s], [-s, s]])),
        Marker::Diamond => fill(corners(&[[0.0, -t], [t, 0.0], [0.0, t], [-t, 0.0]])),
        Marker::Triangle => fill(corners(&[[0.0, -t], [t, t * 0.75], [-t, t * 0.75]])),
        Marker::TriangleDown => fill(corners(&[[0.0, t], [t, -t * 0.75], [-t, -t * 0.75]])),
        Marker::Ring => {
            canvas.fill_outline(circle([x, y], r), WHITE);
            canvas.stroke(circle([x, y], r), look.color, STROKE, &[]);
        }
        Marker::Cross | Marker::Plus => {
            let arms = if marker == Marker::Cross { [[s, s], [s, -s]] } else { [[t, 0.0], [0.0, t]] };
            for [dx, dy] in arms {
                canvas.line([x - r * dx, y - r * dy], [x + r * dx, y + r * dy], look.color, STROKE);
            }
        }
    }
}

/// A circle as eight parabolas, which differ from it by a thousandth of its radius.
fn circle([x, y]: Place, r: f64) -> Vec<Segment> {
    const EIGHTH: f64 = std::f64::consts::FRAC_PI_4;
    let at = |angle: f64, r: f64| [x + r * angle.cos(), y + r * angle.sin()];
    let arc = |k: u8| {
        let angle = f64::from(k) * EIGHTH;
        Segment::Curve(at(angle + 0.5 * EIGHTH, r / (0.5 * EIGHTH).cos()), at(angle + EIGHTH, r))
    };
    let start = std::iter::once(Segment::Move(at(0.0, r)));
    start.chain((0..8).map(arc)).chain([Segment::Close]).collect()
}
