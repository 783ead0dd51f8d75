//! Numbers as people write them.

/// A text with its numbers as people write them: `-7.04e-2` as −7.04·10⁻², `1e-6` as 10⁻⁶, `-0.000` as 0.000.
///
/// What follows an option such as `--rtol` stays, so that it can be copied.
///
/// ```
/// use ezy_study::report::typeset::typeset;
///
/// assert_eq!(typeset("it changes by -7.04e-2 J (at most 1e-6)"), "it changes by −7.04·10⁻² J (at most 10⁻⁶)");
/// assert_eq!(typeset("ezy run … --rtol 1e-6"), "ezy run … --rtol 1e-6");
/// ```
pub fn typeset(text: &str) -> String {
    let mut follows_option = false;
    let words = text.split_inclusive(' ').map(|word| {
        let is_kept = std::mem::replace(&mut follows_option, word.starts_with("--"));
        let number = word
            .trim_start_matches(['(', '[', '|', '+', '='])
            .trim_end_matches([' ', ')', ']', '|', ',', '.', ';', ':']);
        match typeset_number(number) {
            Some(typeset) if !is_kept => word.replacen(number, &typeset, 1),
            _ => word.to_owned(),
        }
    });
    words.collect()
}

/// The number, if the text is one with a sign or an exponent.
fn typeset_number(text: &str) -> Option<String> {
    let (is_negative, magnitude) = text.strip_prefix('-').map_or((false, text), |magnitude| (true, magnitude));
    let (mantissa, exponent) = magnitude.split_once('e').unwrap_or((magnitude, "0"));
    let exponent: i32 = exponent.parse().ok()?;
    let is_decimal = mantissa.starts_with(|c: char| c.is_ascii_digit()) && mantissa.parse::<f64>().is_ok();
    // one digit before the point: others with an `e` among them are hashes
    let is_scientific = magnitude.contains('e') && mantissa.split('.').next().is_some_and(|whole| whole.len() == 1);
    if !is_decimal || !(is_scientific || is_negative && mantissa == magnitude) {
        return None;
    }
    let is_zero = !mantissa.contains(|c: char| matches!(c, '1'..='9'));
    let sign = if is_negative && !is_zero { "−" } else { "" };
    Some(match (exponent, mantissa) {
        _ if is_zero => mantissa.to_owned(),
        (0, _) => format!("{sign}{mantissa}"),
        (_, "1") => format!("{sign}{}", power_of_ten(exponent)),
        _ => format!("{sign}{mantissa}·{}", power_of_ten(exponent)),
    })
}

/// `10⁻⁶`.
pub(crate) fn power_of_ten(power: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(u32::from(digit) - u32::from('0') + u32::from('⁰')).unwrap_or(digit),
    };
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_numbers_have_a_minus_sign_and_powers_of_ten() {
        for (written, expected) in [
            ("-7.04e-2", "−7.04·10⁻²"),
            ("+1.20e10,", "+1.20·10¹⁰,"),
            ("|C| = 1e-12", "|C| = 10⁻¹²"),
            ("-0.000", "0.000"),
            ("0e0", "0"),
            ("-3", "−3"),
            ("2.5e0", "2.5"),
            (
                "−3 right-endpoint 2026-04-14 1.95.0 59807616e1 x86-64 bar-2 - -- e5 inf -inf",
                "−3 right-endpoint 2026-04-14 1.95.0 59807616e1 x86-64 bar-2 - -- e5 inf -inf",
            ),
            ("dop853 --rtol 1e-6 takes 2e-3 s", "dop853 --rtol 1e-6 takes 2·10⁻³ s"),
        ] {
            assert_eq!(typeset(written), expected);
        }
    }
}
