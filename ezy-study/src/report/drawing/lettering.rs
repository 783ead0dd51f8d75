//! Text in a drawing: names of the model as they are typeset, and where there is room for them.

use super::elements::Vector;
use super::number;
use crate::report::page::escape;

/// Left, top, right and bottom, pixels.
pub(super) type Area = [f64; 4];

/// Width of a letter, in sizes of the font; of lengths, which are in italics and have their indices smaller.
const LETTER: f64 = 0.56;
const LETTER_OF_LENGTH: f64 = 0.47;
/// Distance of lines, in sizes of the font.
const LINE: f64 = 1.2;
/// Signs of a line: a longer text would widen the sheet, on which the mechanism then takes a smaller part.
const WIDEST: usize = 20;
/// What is behind so many lines is left out.
const MOST_LINES: usize = 3;

/// `l_centre/2` as SVG: what follows `_`, and digits behind a letter, stand lower.
pub(super) fn typeset(text: &str) -> String {
    let mut svg = String::new();
    let mut rest = text.trim();
    while let Some(first) = rest.chars().next() {
        let is_name = |c: char| c.is_alphanumeric() || c == '_';
        let end = rest.find(|c| !is_name(c)).unwrap_or(rest.len());
        if !first.is_alphabetic() || end == 0 {
            let end = rest.find(char::is_alphabetic).unwrap_or(rest.len());
            svg += &escape(&rest[..end]).replace('*', "\u{2009}").replace('-', "\u{2212}");
            rest = &rest[end..];
            continue;
        }
        let (name, after) = rest.split_at(end);
        let stem = name.find(|c: char| c == '_' || c.is_ascii_digit()).unwrap_or(name.len());
        let (stem, index) = name.split_at(stem);
        svg += greek(stem);
        let index = index.trim_start_matches('_').replace('_', ",");
        if !index.is_empty() {
            svg += &format!("<tspan dy=\"4\" font-size=\"70%\">{index}</tspan><tspan dy=\"-4\">\u{200b}</tspan>");
        }
        rest = after;
    }
    svg
}

/// A Greek letter by its name.
fn greek(name: &str) -> &str {
    const LETTERS: [(&str, &str); 12] = [
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("delta", "δ"),
        ("epsilon", "ε"),
        ("lambda", "λ"),
        ("mu", "μ"),
        ("nu", "ν"),
        ("rho", "ρ"),
        ("phi", "φ"),
        ("theta", "θ"),
        ("omega", "ω"),
    ];
    LETTERS.iter().find(|(known, _)| *known == name).map_or(name, |(_, letter)| letter)
}

/// A text in lines, which end at blanks, behind `*` and behind `/`; `…` stands for what is left out.
fn lines(text: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut piece = String::new();
    let mut parts = text.split_inclusive([' ', '*', '/']).peekable();
    while let Some(part) = parts.next() {
        piece += part;
        // a sign stands before its term
        if matches!(part, "+ " | "- ") && parts.peek().is_some() {
            continue;
        }
        let n = |text: &str| text.trim_end().chars().count();
        let is_full = lines.last().is_some_and(|line| !line.is_empty() && n(&(line.clone() + &piece)) > WIDEST);
        if is_full {
            lines.push(String::new());
        }
        if n(&piece) > WIDEST {
            piece = piece.chars().take(WIDEST - 1).chain(['…']).collect();
        }
        if let Some(line) = lines.last_mut() {
            *line += &std::mem::take(&mut piece);
        }
    }
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1] = format!("{}…", lines[MOST_LINES - 1].trim_end());
    }
    lines
}

/// What is taken on the sheet, and the text that has been put there.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    taken: Vec<Area>,
    texts: Vec<Area>,
    /// Parts of the text that has been put.
    pub svg: String,
}

impl Sheet {
    /// Takes an area.
    pub(super) fn take(&mut self, area: Area) {
        self.taken.push(area);
    }

    /// Takes what is within `half` of a line.
    pub(super) fn take_line(&mut self, [a, b]: [Vector; 2], half: f64) {
        let n = ((b[0] - a[0]).hypot(b[1] - a[1]) / half.max(1.0)).ceil().max(1.0);
        for i in 0..=n as usize {
            let part = i as f64 / n;
            let [x, y] = [0, 1].map(|k| a[k] + part * (b[k] - a[k]));
            self.take([x - half, y - half, x + half, y + half]);
        }
    }

    /// How much of an area is taken, square pixels.
    pub(super) fn overlap(&self, area: Area) -> f64 {
        self.taken.iter().map(|other| shared(area, *other)).sum()
    }

    /// Puts text where most room is: at one of the offsets of its middle from a point. False where it would lie on other text at
    /// each of them: it is then left out, since neither could be read.
    pub(super) fn put(&mut self, text: &str, class: &str, size: f64, at: Vector, offsets: &[Vector]) -> bool {
        let lines = lines(text);
        let n_signs = lines.iter().map(|line| line.trim_end().chars().count()).max().unwrap_or(0);
        let letter = if class == "length" { LETTER_OF_LENGTH } else { LETTER };
        let (width, height) = (letter * size * n_signs as f64, size * (1.0 + LINE * (lines.len() - 1) as f64));
        // a text of one line is as high as the offsets expect
        let beside = [width / 2.0, (height - size) / 2.0];
        let area = |offset: &Vector| {
            let side = |k: usize| if offset[k] == 0.0 { 0.0 } else { offset[k].signum() * beside[k] };
            let [x, y] = [0, 1].map(|k| at[k] + offset[k] + side(k));
            [x - width / 2.0 - 2.0, y - height / 2.0 - 1.0, x + width / 2.0 + 2.0, y + height / 2.0 + 1.0]
        };
        let is_free = |area: &Area| self.texts.iter().all(|text| shared(*area, *text) == 0.0);
        // of equal room the first has it, whatever the rounding
        let areas = offsets.iter().map(area).filter(is_free).map(|area| (self.overlap(area).round(), area));
        let Some((_, area)) = areas.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
        let x = number((area[0] + area[2]) / 2.0);
        let first = (area[1] + area[3]) / 2.0 + size * (0.35 - 0.5 * LINE * (lines.len() - 1) as f64);
        let is_whole = !lines.iter().any(|line| line.ends_with('…'));
        let title = if is_whole { String::new() } else { format!("<title>{}</title>", escape(text)) };
        for (i, line) in lines.iter().enumerate() {
            let y = number(first + LINE * size * i as f64);
            let line = if class == "length" { typeset(line) } else { escape(line) };
            self.svg +=
                &format!("<text class=\"{class}\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{title}{line}</text>\n");
        }
        self.take(area);
        self.texts.push(area);
        true
    }

    /// The box around all of it.
    pub(super) fn bounds(&self) -> Area {
        let all = self.taken.iter().copied();
        let joined = all.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])]);
        joined.unwrap_or([0.0, 0.0, 100.0, 100.0])
    }
}

/// Square pixels that two areas share.
fn shared(a: Area, b: Area) -> f64 {
    let side = |k: usize| (a[k + 2].min(b[k + 2]) - a[k].max(b[k])).max(0.0);
    side(0) * side(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_names_are_typeset_with_their_indices_lower() {
        assert_eq!(typeset("b"), "b");
        assert_eq!(typeset("-2*b"), "\u{2212}2\u{2009}b");
        let low =
            |index: &str| format!("<tspan dy=\"4\" font-size=\"70%\">{index}</tspan><tspan dy=\"-4\">\u{200b}</tspan>");
        assert_eq!(typeset("m1"), format!("m{}", low("1")));
        assert_eq!(typeset("l_centre/2"), format!("l{}/2", low("centre")));
        assert_eq!(typeset("omega"), "ω");
    }

    #[test]
    fn invariant_lines_of_a_text_are_short_and_hold_its_signs_in_order() {
        assert_eq!(lines("l/2"), ["l/2"]);
        assert_eq!(lines("wheel_base/2 - axle_offset + toe"), ["wheel_base/2 ", "- axle_offset + toe"]);
        assert_eq!(lines("stiffness*(length_at_rest - l)"), ["stiffness*", "(length_at_rest - l)"]);
        let name = "x".repeat(50);
        let long = format!("sqrt({name}^2 + {})", (0..30).map(|i| format!("l{i}*b")).collect::<Vec<_>>().join(" - "));
        for text in [&*name, &long, "", "+ ", "a ", &"b/".repeat(60), &"ä*".repeat(15)] {
            let lines = lines(text);
            assert!((1..=MOST_LINES).contains(&lines.len()), "{lines:?}");
            assert!(lines.iter().all(|line| line.trim_end().chars().count() <= WIDEST + 1), "{lines:?}");
            let is_whole = !lines.iter().any(|line| line.contains('…'));
            assert!(!is_whole || lines.concat() == text, "{text}: {lines:?}");
        }
    }

    #[test]
    fn invariant_text_in_lines_is_no_wider_than_its_longest() {
        let mut sheet = Sheet::default();
        sheet.put("wheel_base/2 - axle_offset + toe", "label", 10.0, [0.0; 2], &[[0.0; 2]]);
        let [left, top, right, bottom] = sheet.bounds();
        assert!(right - left <= LETTER * 10.0 * WIDEST as f64 + 4.0 && bottom - top > 20.0, "{:?}", sheet.bounds());
        assert_eq!(sheet.svg.matches("<text").count(), 2);
    }

    #[test]
    fn invariant_text_that_would_lie_on_text_is_left_out() {
        let mut sheet = Sheet::default();
        assert!(sheet.put("first", "label", 10.0, [0.0; 2], &[[0.0, 0.0]]));
        assert!(!sheet.put("second", "label", 10.0, [5.0, 0.0], &[[0.0, 0.0], [8.0, 3.0]]));
        assert!(sheet.put("third", "label", 10.0, [5.0, 0.0], &[[0.0, 0.0], [0.0, 30.0]]));
        assert_eq!(sheet.svg.matches("<text").count(), 2);
    }

    #[test]
    fn invariant_text_goes_where_room_is() {
        let mut sheet = Sheet::default();
        sheet.take([0.0, -20.0, 60.0, 20.0]);
        sheet.put("name", "label", 10.0, [0.0; 2], &[[10.0, 0.0], [-10.0, 0.0]]);
        assert!(sheet.svg.contains("x=\"-21.2\""), "{}", sheet.svg);
        assert!(sheet.bounds()[0] < -30.0);
    }
}
