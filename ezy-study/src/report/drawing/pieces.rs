//! The SVG that parts are made of, as outlines: paths of lines and arcs of circles, circles, rectangles.

use std::f64::consts::{FRAC_PI_8, TAU};

use crate::report::figure::outline::{Place, Segment};

/// An outline and what it is in the style.
pub(super) struct Piece<'s> {
    pub class: &'s str,
    pub outline: Vec<Segment>,
}

/// The elements of a text of SVG.
pub(super) fn pieces(svg: &str) -> Vec<Piece<'_>> {
    svg.split('<').filter_map(piece).collect()
}

fn piece(element: &str) -> Option<Piece<'_>> {
    let text = |name: &str| Some(element.split_once(&format!(" {name}=\""))?.1.split_once('"')?.0);
    let number = |name: &str| text(name)?.parse::<f64>().ok();
    let outline = match element.split_whitespace().next()? {
        "path" => path(text("d")?),
        "circle" => circle(number("r")?),
        "rect" => rectangle([number("x")?, number("y")?, number("width")?, number("height")?], number("rx")?),
        _ => return None,
    };
    Some(Piece { class: text("class")?, outline })
}

fn circle(r: f64) -> Vec<Segment> {
    path(&format!("M{} 0A{r} {r} 0 1 1 {r} 0A{r} {r} 0 1 1 {} 0Z", -r, -r))
}

fn rectangle([x, y, width, height]: [f64; 4], r: f64) -> Vec<Segment> {
    let (right, bottom) = (x + width, y + height);
    let [left_in, right_in, top_in, bottom_in] = [x + r, right - r, y + r, bottom - r];
    let corner = |x: f64, y: f64| if r > 0.0 { format!("A{r} {r} 0 0 1 {x} {y}") } else { String::new() };
    let [a, b, c, d] = [corner(right, top_in), corner(right_in, bottom), corner(x, bottom_in), corner(left_in, y)];
    path(&format!("M{left_in} {y}H{right_in}{a}V{bottom_in}{b}H{left_in}{c}V{top_in}{d}Z"))
}

/// The attribute `d` of a path, in absolute coordinates; other commands are left out.
fn path(d: &str) -> Vec<Segment> {
    let starts: Vec<usize> = d.char_indices().filter(|(_, sign)| sign.is_ascii_uppercase()).map(|(i, _)| i).collect();
    let ends = starts.iter().skip(1).copied().chain([d.len()]);
    let (mut outline, mut at) = (Vec::new(), [0.0; 2]);
    for (&start, end) in starts.iter().zip(ends) {
        let numbers: Vec<f64> = d[start + 1..end].split_whitespace().filter_map(|x| x.parse().ok()).collect();
        let segment = match (&d[start..=start], &numbers[..]) {
            ("M", &[x, y]) => {
                at = [x, y];
                outline.push(Segment::Move(at));
                continue;
            }
            ("A", &[r, _, _, large, sweep, x, y]) => {
                outline.extend(arc(at, r, large != 0.0, sweep != 0.0, [x, y]));
                at = [x, y];
                continue;
            }
            ("L", &[x, y]) => [x, y],
            ("H", &[x]) => [x, at[1]],
            ("V", &[y]) => [at[0], y],
            ("Z", []) => {
                outline.push(Segment::Close);
                continue;
            }
            _ => continue,
        };
        at = segment;
        outline.push(Segment::Line(at));
    }
    outline
}

/// Part of a circle as parabolas, of an eighth of half a turn each: the error is 4e-4 of the radius.
fn arc(from: Place, r: f64, large: bool, sweep: bool, to: Place) -> Vec<Segment> {
    let half = [(to[0] - from[0]) / 2.0, (to[1] - from[1]) / 2.0];
    let half_chord = half[0].hypot(half[1]);
    if half_chord == 0.0 {
        return Vec::new();
    }
    // a circle that does not reach both ends grows until it does
    let r = r.max(half_chord);
    let height = (r * r - half_chord * half_chord).max(0.0).sqrt() / half_chord;
    let side = if large == sweep { -height } else { height };
    let centre = [from[0] + half[0] - side * half[1], from[1] + half[1] + side * half[0]];
    let angle = |[x, y]: Place| (y - centre[1]).atan2(x - centre[0]);
    let turn = (angle(to) - angle(from)).rem_euclid(TAU);
    let turn = if sweep { turn } else { turn - TAU };
    let n = (turn.abs() / FRAC_PI_8).ceil().max(1.0);
    let step = turn / n;
    let place = |angle: f64, r: f64| [centre[0] + r * angle.cos(), centre[1] + r * angle.sin()];
    let parabola = |i: usize| {
        let start = angle(from) + step * i as f64;
        Segment::Curve(place(start + step / 2.0, r / (step / 2.0).cos()), place(start + step, r))
    };
    (0..n as usize).map(parabola).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of parabolas for arcs, relative to the radius.
    const OF_PARABOLAS: f64 = 4e-4;

    fn ends(outline: &[Segment]) -> Vec<Place> {
        let end = |segment: &Segment| match *segment {
            Segment::Move(end) | Segment::Line(end) | Segment::Curve(_, end) => Some(end),
            Segment::Close => None,
        };
        outline.iter().filter_map(end).collect()
    }

    #[test]
    fn analytic_circle_has_its_radius_along_every_parabola() {
        let outline = circle(3.0);
        let ends = ends(&outline);
        for (segment, from) in outline.iter().skip(1).zip(&ends) {
            if let Segment::Curve(control, to) = segment {
                let middle = [0, 1].map(|k| 0.25 * from[k] + 0.5 * control[k] + 0.25 * to[k]);
                for [x, y] in [middle, *to] {
                    assert!((x.hypot(y) / 3.0 - 1.0).abs() < OF_PARABOLAS, "{x} {y}");
                }
            }
        }
        // all around, and back
        assert!(ends.iter().any(|[_, y]| *y < -2.9) && ends.iter().any(|[_, y]| *y > 2.9));
    }

    #[test]
    fn analytic_arc_is_the_one_of_four_that_its_flags_name() {
        // from (1, 0) to (0, 1) about (0, 0) or (1, 1); sweep is clockwise where y is downwards
        for (large, sweep, through) in [
            (false, true, [0.5_f64.sqrt(), 0.5_f64.sqrt()]),
            (false, false, [1.0 - 0.5_f64.sqrt(), 1.0 - 0.5_f64.sqrt()]),
            (true, true, [1.0 + 0.5_f64.sqrt(), 1.0 + 0.5_f64.sqrt()]),
            (true, false, [-(0.5_f64.sqrt()), -(0.5_f64.sqrt())]),
        ] {
            let ends = ends(&arc([1.0, 0.0], 1.0, large, sweep, [0.0, 1.0]));
            let distance = |[x, y]: &Place| (x - through[0]).hypot(y - through[1]);
            let nearest = ends.iter().map(distance).fold(f64::INFINITY, f64::min);
            // no farther than half a parabola is long; the other arcs are 0.4 away
            assert!(nearest < 0.2, "{large} {sweep}: {ends:?}");
        }
    }

    #[test]
    fn analytic_rectangle_and_lines_have_their_corners() {
        let all = pieces(
            "<rect class=\"paper\" x=\"-1\" y=\"-2\" width=\"2\" height=\"4\" rx=\"0\"/><path class=\"line\" d=\"M0 1H5V-3\"/>",
        );
        assert_eq!(all.iter().map(|piece| piece.class).collect::<Vec<_>>(), ["paper", "line"]);
        let corners = [[-1.0, -2.0], [1.0, -2.0], [1.0, 2.0], [-1.0, 2.0]];
        assert!(corners.iter().all(|corner| ends(&all[0].outline).contains(corner)));
        assert_eq!(ends(&all[1].outline), [[0.0, 1.0], [5.0, 1.0], [5.0, -3.0]]);
    }
}
