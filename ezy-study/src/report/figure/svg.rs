//! A picture as SVG: outlines, and the cells of maps as images within the text, so that it needs neither fonts nor other files and
//! looks the same in every program.

use std::fmt::Write as _;

use super::canvas::{Canvas, Color, Place, Segment, Shape};
use super::png;
use crate::report::page::escape;

/// The picture as a document.
pub(super) fn svg(canvas: &Canvas) -> String {
    let [width, height] = [canvas.width, canvas.height].map(number);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         fill=\"none\" stroke-linejoin=\"round\">\n"
    );
    for shape in &canvas.shapes {
        text += &element(shape);
    }
    text + "</svg>\n"
}

fn element(shape: &Shape) -> String {
    match shape {
        Shape::Stroke { outline, color, width, dash } => {
            let dash = dash.iter().copied().map(number).collect::<Vec<_>>().join(" ");
            let dash = if dash.is_empty() { dash } else { format!(" stroke-dasharray=\"{dash}\"") };
            let (d, color, width) = (path(outline), hexadecimal(*color), number(*width));
            format!("<path stroke=\"{color}\" stroke-width=\"{width}\"{dash} d=\"{d}\"/>\n")
        }
        Shape::Fill { outline, color } => {
            format!("<path fill=\"{}\" d=\"{}\"/>\n", hexadecimal(*color), path(outline))
        }
        Shape::Text { outline, color, text, .. } => {
            let (d, color, text) = (path(outline), hexadecimal(*color), escape(text));
            format!("<path aria-label=\"{text}\" fill=\"{color}\" d=\"{d}\"/>\n")
        }
        Shape::Image { raster, frame } => {
            let [x, y, width, height] = [frame.left, frame.top, frame.width(), frame.height()].map(number);
            let bytes = base64(&png::of_raster(raster).unwrap_or_default());
            format!(
                "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
                 style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{bytes}\"/>\n"
            )
        }
    }
}

/// Bytes in letters (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, k| bits << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * k)) as usize & 63];
            text.push(if k <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

fn path(outline: &[Segment]) -> String {
    let mut text = String::new();
    let place = |[x, y]: Place| format!("{} {}", number(x), number(y));
    for segment in outline {
        _ = match segment {
            Segment::Move(end) => write!(text, "M{}", place(*end)),
            Segment::Line(end) => write!(text, "L{}", place(*end)),
            Segment::Curve(control, end) => write!(text, "Q{} {}", place(*control), place(*end)),
            Segment::Close => write!(text, "Z"),
        };
    }
    text
}

/// With two decimals at most: a hundredth of a point is not seen.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

fn hexadecimal([red, green, blue]: Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_base64_is_that_of_rfc_4648() {
        // section 10
        let known =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("fooba", "Zm9vYmE=")];
        for (text, expected) in known {
            assert_eq!(base64(text.as_bytes()), expected);
        }
        assert_eq!(base64(&[0xff, 0xef, 0xbe]), "/+++");
    }
}
