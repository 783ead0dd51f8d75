//! Names of units: those of the language, which the parser recognises behind numbers, and others, which messages translate.
//! Dimensions of units are in `model`.

/// In the order of the manual.
pub const NAMES: [&str; 36] = [
    "m", "mm", "cm", "km", "kg", "g", "t", "s", "ms", "us", "min", "h", "rad", "mrad", "deg", "Hz", "kHz", "N", "mN",
    "kN", "MN", "J", "mJ", "kJ", "MJ", "W", "kW", "MW", "A", "mA", "V", "mV", "kV", "ohm", "H", "mH",
];

/// Other signs for units of the language.
const OTHERWISE: [(&str, &str); 13] = [
    ("hr", "h"),
    ("hrs", "h"),
    ("kgs", "kg"),
    ("radps", "rad/s"),
    ("mps", "m/s"),
    ("kmh", "km/h"),
    ("kph", "km/h"),
    ("kmph", "km/h"),
    ("Nms", "N*m*s"),
    ("Nmm", "N*mm"),
    ("Pa", "N/m^2"),
    ("kPa", "kN/m^2"),
    ("MPa", "MN/m^2"),
];

/// Units of another size, and how much they are.
const OF_OTHER_SIZE: [(&str, &str, &str); 24] = [
    ("rpm", "deg/s", "6"),
    ("rps", "deg/s", "360"),
    ("rev", "deg", "360"),
    ("mg", "g", "0.001"),
    ("Mg", "kg", "1000"),
    ("um", "mm", "0.001"),
    ("dm", "cm", "10"),
    ("mW", "W", "0.001"),
    ("mHz", "Hz", "0.001"),
    ("MHz", "kHz", "1000"),
    ("mph", "m/s", "0.44704"),
    ("inch", "mm", "25.4"),
    ("ft", "m", "0.3048"),
    ("yd", "mm", "914.4"),
    ("mile", "km", "1.609344"),
    ("knot", "km/h", "1.852"),
    ("day", "h", "24"),
    ("oz", "g", "28.349523125"),
    ("lb", "kg", "0.45359237"),
    ("lbf", "N", "4.4482216152605"),
    ("kgf", "N", "9.80665"),
    ("psi", "kN/m^2", "6.894757293168"),
    ("atm", "kN/m^2", "101.325"),
    ("hp", "W", "745.7"),
];

/// How units are written in full, plurals included: their beginnings.
const SPELLED_OUT: [(&str, &str); 17] = [
    ("kilog", "kg"),
    ("gram", "g"),
    ("meter", "m"),
    ("metre", "m"),
    ("millim", "mm"),
    ("centim", "cm"),
    ("sec", "s"),
    ("hour", "h"),
    ("radian", "rad"),
    ("degree", "deg"),
    ("newton", "N"),
    ("joule", "J"),
    ("watt", "W"),
    ("amp", "A"),
    ("volt", "V"),
    ("ohms", "ohm"),
    ("henr", "H"),
];

/// What may stand before another unit without a sign between them: `Nm`, `kgm2`.
const FACTORS: [&str; 10] = ["N", "mN", "kN", "MN", "kg", "J", "kJ", "MJ", "W", "kW"];

/// What to write for a name that is no unit.
#[derive(Debug, PartialEq)]
pub struct Spelling {
    pub unit: String,
    /// How many of these it is, unless one.
    pub is: Option<&'static str>,
}

impl Spelling {
    /// As a factor with this exponent, which is written behind it or by the `/` before it.
    pub fn factor(&self, exponent: i32) -> String {
        let single = !self.unit.contains(['*', '/', '^']);
        let power = exponent.abs() == 1 && !self.unit.contains(['*', '/']);
        if exponent == 1 || single || power { self.unit.clone() } else { format!("({})", self.unit) }
    }
}

pub fn is_known(name: &str) -> bool {
    NAMES.contains(&name)
}

/// The unit that is meant by a name that is none.
pub fn spelling(name: &str) -> Option<Spelling> {
    if let Some((_, unit, is)) = OF_OTHER_SIZE.iter().find(|(other, ..)| *other == name) {
        return Some(Spelling { unit: (*unit).to_owned(), is: Some(is) });
    }
    let unit = match OTHERWISE.iter().find(|(other, _)| *other == name) {
        Some((_, unit)) => Some((*unit).to_owned()),
        None => run_together(name).or_else(|| spelled_out(name)),
    };
    unit.map(|unit| Spelling { unit, is: None })
}

/// `s2` is `s^2`, `kgm2` is `kg*m^2`.
fn run_together(name: &str) -> Option<String> {
    let letters = name.trim_end_matches(|sign: char| sign.is_ascii_digit());
    let power = match &name[letters.len()..] {
        "" => String::new(),
        digits => format!("^{digits}"),
    };
    if is_known(letters) && !power.is_empty() {
        return Some(format!("{letters}{power}"));
    }
    let factor = FACTORS.iter().find(|factor| letters.strip_prefix(**factor).is_some_and(is_known))?;
    Some(format!("{factor}*{}{power}", &letters[factor.len()..]))
}

fn spelled_out(name: &str) -> Option<String> {
    let name = name.to_lowercase();
    SPELLED_OUT.iter().find(|(begin, _)| name.starts_with(begin)).map(|(_, unit)| (*unit).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_spelling_of_other_names_is_in_units_of_the_language() {
        let tables = OTHERWISE.iter().chain(&SPELLED_OUT).map(|(name, unit)| (*name, *unit));
        for (name, unit) in tables.chain(OF_OTHER_SIZE.iter().map(|(name, unit, _)| (*name, *unit))) {
            assert!(!is_known(name), "{name}");
            let unit = crate::parse::unit_of_text(unit).expect("a unit");
            assert!(unit.factors.iter().all(|factor| is_known(&factor.name.to_string())), "{}", unit.text);
        }
    }

    #[test]
    fn analytic_spelling_of_units_that_are_run_together() {
        for (name, unit) in [("Nm", "N*m"), ("kNm", "kN*m"), ("s2", "s^2"), ("mm2", "mm^2"), ("kgm2", "kg*m^2")] {
            assert_eq!(spelling(name), Some(Spelling { unit: unit.to_owned(), is: None }));
        }
    }
}
