//! Text as outlines of an embedded face: a picture looks the same on every machine.
//!
//! `face/outlines.txt` holds letters of DejaVu Sans: Latin, Greek, signs of mathematics, raised and lowered digits.
//! `face/outlines.py` writes it from the face, whose licence stands beside it.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::outline::{Place, Segment};

/// How far capitals and digits rise above the base line, and letters fall below it, of the size.
pub(super) const RISE: f64 = 0.76;
pub(super) const FALL: f64 = 0.24;

/// Units of the face in an em.
const UNITS_OF_EM: f64 = 2048.0;

/// What stands for a letter that the face lacks: U+FFFD.
const MISSING: char = '\u{fffd}';

struct Glyph {
    width: f64,
    outline: Vec<Segment>,
}

static FACE: LazyLock<HashMap<char, Glyph>> = LazyLock::new(|| {
    let lines = include_str!("face/outlines.txt").lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(glyph).collect()
});

/// Reads a line `41 1401 M700 1294L426 551Z`.
fn glyph(line: &str) -> Option<(char, Glyph)> {
    let mut parts = line.splitn(3, ' ');
    let letter = char::from_u32(u32::from_str_radix(parts.next()?, 16).ok()?)?;
    let width = parts.next()?.parse().ok()?;
    let text = parts.next().unwrap_or_default();
    let starts: Vec<usize> = text.char_indices().filter(|(_, c)| c.is_ascii_uppercase()).map(|(i, _)| i).collect();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    let outline = starts.iter().zip(ends).map(|(&start, end)| segment(&text[start..end])).collect::<Option<_>>()?;
    Some((letter, Glyph { width, outline }))
}

fn segment(text: &str) -> Option<Segment> {
    let numbers = text[1..].split_whitespace().map(|number| number.parse().ok()).collect::<Option<Vec<f64>>>()?;
    match (&text[..1], &numbers[..]) {
        ("M", &[x, y]) => Some(Segment::Move([x, y])),
        ("L", &[x, y]) => Some(Segment::Line([x, y])),
        ("Q", &[cx, cy, x, y]) => Some(Segment::Curve([cx, cy], [x, y])),
        ("Z", []) => Some(Segment::Close),
        _ => None,
    }
}

fn glyphs(text: &str) -> impl Iterator<Item = &'static Glyph> {
    text.chars().filter_map(|letter| FACE.get(&letter).or_else(|| FACE.get(&MISSING)))
}

/// Width of a line of text.
pub(super) fn width(text: &str, size: f64) -> f64 {
    glyphs(text).map(|glyph| glyph.width).sum::<f64>() * size / UNITS_OF_EM
}

/// Outline of a line of text; `place` takes a place to the right of its start and above its base line to that of the picture.
pub(crate) fn outline(text: &str, size: f64, place: impl Fn(Place) -> Place) -> Vec<Segment> {
    let scale = size / UNITS_OF_EM;
    let mut start = 0.0;
    let mut outline = Vec::new();
    for glyph in glyphs(text) {
        let at = |[x, y]: Place| place([(start + x) * scale, y * scale]);
        outline.extend(glyph.outline.iter().map(|segment| match *segment {
            Segment::Move(end) => Segment::Move(at(end)),
            Segment::Line(end) => Segment::Line(at(end)),
            Segment::Curve(control, end) => Segment::Curve(at(control), at(end)),
            Segment::Close => Segment::Close,
        }));
        start += glyph.width;
    }
    outline
}

/// Lines of words, each no wider than `room` where its words allow it.
pub(super) fn wrapped(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => *line = format!("{line} {word}"),
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_face_has_every_letter_that_ticks_and_units_take() {
        let letters = "0123456789−+.,·×/()[]|⁻⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉°′λφωψαβγμπΔ√∞≤≥–—…";
        let lacking: Vec<char> = letters.chars().filter(|letter| !FACE.contains_key(letter)).collect();
        assert!(lacking.is_empty(), "{lacking:?}");
        // every line but the two of comment was read
        assert_eq!(FACE.len(), include_str!("face/outlines.txt").lines().count() - 2);
    }

    #[test]
    fn invariant_digits_are_equally_wide_so_that_columns_of_numbers_stand_below_each_other() {
        assert!("123456789−+".chars().take(9).all(|digit| FACE[&digit].width == FACE[&'0'].width));
    }

    #[test]
    fn invariant_letter_that_the_face_lacks_is_shown_as_missing() {
        assert_eq!(width("\u{4e00}", 10.0), width("\u{fffd}", 10.0));
        assert!(width("\u{fffd}", 10.0) > 0.0);
    }
}
