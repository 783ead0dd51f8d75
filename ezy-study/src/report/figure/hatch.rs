//! Lines over what has no value: they tell its grey from light colours in grey print.

use super::canvas::{Canvas, Color, Frame, Place, Segment};

/// Distance of the lines, their width, and how finely their ends are found, in points.
const DISTANCE: f64 = 5.0;
const WIDTH: f64 = 0.8;
const STEP: f64 = 0.25;

pub(super) const COLOR: Color = [0x9a; 3];

/// Lines that rise by 45° through the places of `frame` for which `is_hatched`.
pub(super) fn draw(canvas: &mut Canvas, frame: &Frame, is_hatched: impl Fn(Place) -> bool) {
    let mut outline = Vec::new();
    let n_lines = ((frame.width() + frame.height()) / DISTANCE) as usize;
    for k in 0..=n_lines {
        // where the line meets the left side, or would above or below it
        let bottom = frame.top + (k as f64 + 0.5) * DISTANCE;
        let [from, to] = [(bottom - frame.bottom).max(0.0), (bottom - frame.top).min(frame.width())];
        let place = |i: usize| [frame.left + from + i as f64 * STEP, bottom - from - i as f64 * STEP];
        let n_steps = ((to - from) / STEP).max(0.0) as usize;
        let mut is_drawn = false;
        for i in 0..n_steps {
            // a step is hatched if its middle is
            let [x, y] = place(i);
            if is_hatched([x + 0.5 * STEP, y - 0.5 * STEP]) != is_drawn {
                is_drawn = !is_drawn;
                outline.push(if is_drawn { Segment::Move([x, y]) } else { Segment::Line([x, y]) });
            }
        }
        if is_drawn {
            outline.push(Segment::Line(place(n_steps)));
        }
    }
    if !outline.is_empty() {
        canvas.stroke(outline, COLOR, WIDTH, &[]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::figure::canvas::Shape;

    #[test]
    fn invariant_lines_stay_within_what_is_hatched() {
        let frame = Frame { left: 10.0, top: 20.0, right: 110.0, bottom: 80.0 };
        let is_hatched = |[x, y]: Place| x > 40.0 && (y < 50.0 || x > 90.0);
        let mut canvas = Canvas::new(120.0, 100.0);
        draw(&mut canvas, &frame, is_hatched);
        let [Shape::Stroke { outline, .. }] = &canvas.shapes[..] else { panic!("one path") };
        assert!(outline.len() > 20);
        for pair in outline.chunks(2) {
            let [Segment::Move(from), Segment::Line(to)] = pair else { panic!("{pair:?}") };
            let at = |part: f64| [from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])];
            // ends are found to a step
            let inside = (1..10)
                .map(|k| at(f64::from(k) / 10.0))
                .all(|[x, y]| is_hatched([x + STEP, y - STEP]) || is_hatched([x - STEP, y + STEP]));
            assert!(
                inside
                    && frame.widened(1e-9).holds(&Frame { left: from[0], right: to[0], top: to[1], bottom: from[1] })
            );
        }
    }
}
