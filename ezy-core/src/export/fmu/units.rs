//! Units as powers of SI base units.

/// Powers of kg, m, s, A and rad, and the factor to them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Base {
    pub powers: [i32; 5],
    pub factor: f64,
}

/// The names of these powers in a description.
pub(super) const NAMES: [&str; 5] = ["kg", "m", "s", "A", "rad"];

/// Units by their names: powers of kg, m, s, A, rad, and the factor.
const KNOWN: [(&str, [i32; 5], f64); 22] = [
    ("1", [0, 0, 0, 0, 0], 1.0),
    ("kg", [1, 0, 0, 0, 0], 1.0),
    ("g", [1, 0, 0, 0, 0], 1e-3),
    ("m", [0, 1, 0, 0, 0], 1.0),
    ("cm", [0, 1, 0, 0, 0], 1e-2),
    ("mm", [0, 1, 0, 0, 0], 1e-3),
    ("km", [0, 1, 0, 0, 0], 1e3),
    ("s", [0, 0, 1, 0, 0], 1.0),
    ("ms", [0, 0, 1, 0, 0], 1e-3),
    ("min", [0, 0, 1, 0, 0], 60.0),
    ("h", [0, 0, 1, 0, 0], 3600.0),
    ("A", [0, 0, 0, 1, 0], 1.0),
    ("rad", [0, 0, 0, 0, 1], 1.0),
    ("deg", [0, 0, 0, 0, 1], std::f64::consts::PI / 180.0),
    ("N", [1, 1, -2, 0, 0], 1.0),
    ("kN", [1, 1, -2, 0, 0], 1e3),
    ("J", [1, 2, -2, 0, 0], 1.0),
    ("W", [1, 2, -3, 0, 0], 1.0),
    ("V", [1, 2, -3, -1, 0], 1.0),
    ("ohm", [1, 2, -3, -2, 0], 1.0),
    ("H", [1, 2, -2, -2, 0], 1.0),
    ("Hz", [0, 0, -1, 0, 0], 1.0),
];

/// A unit as it is written: names with whole powers, multiplied and divided. `None` where a name is not known.
pub(super) fn base(unit: &str) -> Option<Base> {
    let mut found = Base { powers: [0; 5], factor: 1.0 };
    let mut sign = 1;
    let mut rest = unit;
    loop {
        let end = rest.find(['*', '/']).unwrap_or(rest.len());
        let (name, power) =
            rest[..end].trim().split_once('^').map_or((rest[..end].trim(), "1"), |(name, power)| (name, power));
        let power: i32 = sign * power.parse::<i32>().ok()?;
        let (_, powers, factor) = KNOWN.iter().find(|(known, ..)| *known == name)?;
        found.powers.iter_mut().zip(powers).for_each(|(sum, of)| *sum += power * of);
        found.factor *= factor.powi(power);
        let Some(operator) = rest[end..].chars().next() else { return Some(found) };
        sign = if operator == '/' { -1 } else { 1 };
        rest = &rest[end + 1..];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_units_are_powers_of_base_units() {
        let powers = |unit| base(unit).map(|of| (of.powers, of.factor));
        assert_eq!(powers("N*m/rad"), Some(([1, 2, -2, 0, -1], 1.0)));
        assert_eq!(powers("kg*m^2"), Some(([1, 2, 0, 0, 0], 1.0)));
        assert_eq!(powers("1/s"), Some(([0, 0, -1, 0, 0], 1.0)));
        assert_eq!(powers("mm/s^2"), Some(([0, 1, -2, 0, 0], 1e-3)));
        assert_eq!([powers("furlong"), powers("m^x"), powers("")], [None; 3]);
    }
}
