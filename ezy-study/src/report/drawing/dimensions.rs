//! Dimension lines: the lengths that fix points to bodies, as the model names them.

use super::elements::{Elements, Placed, Vector};
use super::lettering::Sheet;
use super::number;

/// Distance of a dimension line from its body, and of the next one from it, pixels.
const LANE: f64 = 27.0;
/// Lanes in the order in which they are tried: below, then above.
const LANES: [f64; 8] = [1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0];
/// Room that a dimension line needs to both sides, pixels.
const ROOM: f64 = 10.0;
/// Shorter lengths have no dimension line, pixels.
const SHORTEST: f64 = 12.0;
const MOST: usize = 16;
const MOST_OF_A_NAME: usize = 2;
/// Size of the lettering, pixels.
const LETTERS: f64 = 18.0;

/// A length along an axis of a body.
struct Dimension {
    body: usize,
    text: String,
    /// Ends in the axes of the body, m.
    ends: [Vector; 2],
}

/// The dimension lines of all bodies as SVG; what they need is taken from the sheet.
pub(super) fn dimensions(sheet: &mut Sheet, elements: &Elements, at: &Placed, scale: f64) -> String {
    let mut svg = String::new();
    for dimension in all(elements, at).into_iter().take(MOST) {
        let [a, b] = dimension.ends.map(|[x, y]| {
            let (sin, cos) = at.angle(dimension.body).sin_cos();
            let [cx, cy] = at.centre(dimension.body);
            [(cx + x * cos - y * sin) * scale, -(cy + x * sin + y * cos) * scale]
        });
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if length < SHORTEST {
            continue;
        }
        // across, downwards or to the right on the sheet
        let mut across = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
        if across[1] < -1e-9 || (across[1].abs() <= 1e-9 && across[0] < 0.0) {
            across = across.map(|x| -x);
        }
        let moved = |lane: f64| [a, b].map(|p| [p[0] + lane * LANE * across[0], p[1] + lane * LANE * across[1]]);
        let crowded = |lane: &f64| -> f64 {
            let [a, b] = moved(*lane);
            let steps = (length / ROOM).ceil();
            let areas = (1..steps as usize).map(|i| {
                let [x, y] = [0, 1].map(|k| a[k] + i as f64 / steps * (b[k] - a[k]));
                sheet.overlap([x - ROOM / 2.0, y - ROOM / 2.0, x + ROOM / 2.0, y + ROOM / 2.0])
            });
            areas.sum::<f64>() + lane.abs()
        };
        let best = LANES.iter().copied().min_by(|x, y| crowded(x).total_cmp(&crowded(y)));
        let lane = best.unwrap_or(1.0);
        let ends = moved(lane);
        let middle = [0, 1].map(|k| (ends[0][k] + ends[1][k]) / 2.0);
        let side = lane.signum() * 11.0;
        let offsets = [side, -side].map(|side| [side * across[0], side * across[1]]);
        if !sheet.put(&dimension.text, "length", LETTERS, middle, &offsets) {
            continue;
        }
        let beyond = |p: Vector| [0, 1].map(|k| number(p[k] + lane.signum() * 5.0 * across[k]));
        let extension = |from: Vector, to: Vector| {
            let [x, y] = beyond(to);
            format!("M{} {}L{x} {y}", number(from[0]), number(from[1]))
        };
        svg += &format!("<path class=\"extension\" d=\"{}{}\"/>\n", extension(a, ends[0]), extension(b, ends[1]));
        svg += &format!("<path class=\"thin\" d=\"{}\"/>\n", arrow(ends));
        sheet.take_line(ends, ROOM / 2.0);
    }
    svg
}

/// A line with arrowheads at its ends; of a short line they are outside.
fn arrow([a, b]: [Vector; 2]) -> String {
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let along = [0, 1].map(|k| (b[k] - a[k]) / length);
    let head = |at: Vector, side: f64| {
        let wing = |turn: f64| {
            let [x, y] = [0, 1].map(|k| at[k] + side * 7.0 * along[k]);
            format!("{} {}", number(x - turn * 2.4 * along[1]), number(y + turn * 2.4 * along[0]))
        };
        format!("M{}L{} {}L{}", wing(1.0), number(at[0]), number(at[1]), wing(-1.0))
    };
    let side = if length < 20.0 { -1.0 } else { 1.0 };
    let line = format!("M{} {}L{} {}", number(a[0]), number(a[1]), number(b[0]), number(b[1]));
    line + &head(a, side) + &head(b, -side)
}

/// Lengths that are not zero, each once for a body, and few of the same name: members of an array have the same ones.
fn all(elements: &Elements, at: &Placed) -> Vec<Dimension> {
    let mut all: Vec<Dimension> = Vec::new();
    for (i, element) in elements.iter() {
        for (k, point) in element.points.iter().enumerate() {
            let Some(body) = point.body else { continue };
            let [x, y] = at.local(elements.point(i, k));
            let sides = [[[0.0, 0.0], [x, 0.0]], [[x, 0.0], [x, y]]];
            for (text, ends) in point.text.into_iter().zip(sides) {
                let text = without_sign(text);
                let same = all.iter().filter(|other| other.text == text);
                let is_known = same.clone().any(|other| other.body == body && other.ends == ends);
                if !matches!(&*text, "0" | "") && !is_known && same.count() < MOST_OF_A_NAME {
                    all.push(Dimension { body, text, ends });
                }
            }
        }
    }
    all
}

/// `-a` as `a`, `-a - b` as `a + b`: a length has no sign. A difference stays as it is, and so does what is in brackets.
fn without_sign(text: &str) -> String {
    let Some(rest) = text.strip_prefix('-') else { return text.to_owned() };
    let (mut depth, mut length) = (0, String::new());
    for (i, letter) in rest.char_indices() {
        depth += i32::from(letter == '(') - i32::from(letter == ')');
        let sign = depth == 0 && rest[..i].ends_with(' ') && rest[i + letter.len_utf8()..].starts_with(' ');
        match letter {
            '+' if sign => return text.to_owned(),
            '-' if sign => length.push('+'),
            _ => length.push(letter),
        }
    }
    length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_lengths_have_no_sign() {
        let lengths = ["a", "-a", "-a - b", "l - a", "-a + b", "-(k - 1)*a"].map(without_sign);
        assert_eq!(lengths, ["a", "a", "a + b", "l - a", "-a + b", "(k - 1)*a"]);
    }
}
