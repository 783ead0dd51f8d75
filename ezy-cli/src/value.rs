//! Numbers and assignments as typed on the command line.

use std::f64::consts::PI;

/// `NAME=VALUE`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Assignment {
    pub name: String,
    pub value: f64,
}

/// Reads `NAME=VALUE`.
pub(super) fn parse_assignment(text: &str) -> Result<Assignment, String> {
    let (name, value) = text.split_once('=').ok_or("it has no `=`; write NAME=VALUE, such as m0=3")?;
    if name.trim().is_empty() {
        return Err("it has no name before `=`; write NAME=VALUE, such as m0=3".to_owned());
    }
    Ok(Assignment { name: name.trim().to_owned(), value: parse_number(value)? })
}

/// Reads a finite number: a sign, factors that are numbers or `pi` between `*` and `/`.
pub(super) fn parse_number(text: &str) -> Result<f64, String> {
    evaluate(text.trim())
        .filter(|value| value.is_finite())
        .ok_or_else(|| format!("`{text}` is not a finite number; {}", number_alone(text)))
}

/// How to write a number, above all one that has a unit.
fn number_alone(text: &str) -> String {
    let unit_at = text.find(|c: char| c.is_alphabetic() || c == '°' || c == '%').unwrap_or(text.len());
    let (number, unit) = (text[..unit_at].trim(), text[unit_at..].trim());
    match unit {
        _ if unit.is_empty() || evaluate(number).is_none() => "write 2, -0.5, 1e-3, pi, -pi/2 or 2*pi".to_owned(),
        "deg" | "degree" | "degrees" | "°" => format!("for radians write {number}*pi/180"),
        _ => format!("write it without `{unit}`, in the unit that help or the model file says"),
    }
}

/// Reads a whole number that is not negative, also as `1e6`.
pub(super) fn parse_count(text: &str) -> Result<u64, String> {
    let count = parse_number(text).ok().filter(|x| x.fract() == 0.0 && (0.0..=LARGEST_COUNT).contains(x));
    count.map(|x| x as u64).ok_or_else(|| format!("`{text}` is not a whole number from 0 up; write 1000 or 1e6"))
}

/// Up to here every whole number is an `f64`.
const LARGEST_COUNT: f64 = 9e15;

fn evaluate(text: &str) -> Option<f64> {
    let (sign, magnitude) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let mut value = sign;
    let mut rest = magnitude;
    let mut divide = false;
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let factor = factor(rest[..end].trim())?;
        value = if divide { value / factor } else { value * factor };
        if end == rest.len() {
            return Some(value);
        }
        divide = rest[end..].starts_with('/');
        rest = &rest[end + 1..];
    }
}

fn factor(text: &str) -> Option<f64> {
    match text {
        "pi" => Some(PI),
        _ if text.starts_with(|c: char| c.is_ascii_digit() || c == '.') => text.parse().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_numbers_with_pi_are_products_from_left_to_right() {
        let cases = [
            ("2", 2.0),
            (" -0.5", -0.5),
            ("1e-3", 1e-3),
            ("pi", PI),
            ("-pi/2", -PI / 2.0),
            ("2*pi", 2.0 * PI),
            ("3*pi/4", 3.0 * PI / 4.0),
        ];
        for (text, value) in cases {
            assert_eq!(parse_number(text), Ok(value), "{text}");
        }
    }

    #[test]
    fn invariant_what_is_no_finite_number_is_refused() {
        for text in ["", "nan", "inf", "-", "1/0", "1e999", "--1", "2**3", "pi pi", "m0"] {
            assert!(parse_number(text).is_err(), "{text}");
        }
    }

    #[test]
    fn invariant_number_with_a_unit_is_refused_with_the_number_to_write() {
        let refused = |text: &str| parse_number(text).unwrap_err();
        assert!(refused("30deg").ends_with("write 30*pi/180") && refused("-30 °").ends_with("write -30*pi/180"));
        assert!(refused("5 s").contains("without `s`") && refused("abc").ends_with("2*pi"));
    }

    #[test]
    fn analytic_counts_are_whole_numbers_from_zero_up() {
        assert_eq!((parse_count("0"), parse_count("1e6")), (Ok(0), Ok(1_000_000)));
        for text in ["-1", "0.5", "1e300", "nan", ""] {
            assert!(parse_count(text).is_err(), "{text}");
        }
    }

    #[test]
    fn invariant_assignment_needs_a_name_and_an_equals_sign() {
        assert_eq!(parse_assignment("bar.phi=pi"), Ok(Assignment { name: "bar.phi".to_owned(), value: PI }));
        assert!(parse_assignment("bar.phi").is_err() && parse_assignment("=2").is_err());
    }
}
