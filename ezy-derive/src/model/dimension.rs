//! Dimensions, to find sums of different quantities. Angles are dimensionless.

use crate::diag::values::PLAIN_NUMBER;
use std::fmt;

/// What is known about the dimension of an expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Unknown: it contains a number or parameter without unit, which may have any dimension.
    Unknown,
    /// The value of a function: dimensionless as a factor, any dimension by itself.
    Plain,
    Known(Dimension),
}

impl Measure {
    pub fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (Self::Plain, other) | (other, Self::Plain) => other,
            (Self::Known(a), Self::Known(b)) => Self::Known(a.times(b)),
        }
    }

    pub fn over(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            (measure, Self::Plain) => measure,
            (Self::Plain, Self::Known(b)) => Self::Known(Dimension::NONE.over(b)),
            (Self::Known(a), Self::Known(b)) => Self::Known(a.over(b)),
        }
    }

    /// What is known of a sum.
    pub fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Known(_), _) | (Self::Unknown, Self::Plain) => self,
            _ => other,
        }
    }

    /// A power; `None` is an exponent that is not a number.
    pub fn power(self, exponent: Option<f64>) -> Self {
        match (self, exponent) {
            (Self::Plain, _) => Self::Plain,
            (Self::Known(dimension), Some(exponent)) => dimension.power(exponent).map_or(Self::Unknown, Self::Known),
            _ => Self::Unknown,
        }
    }

    pub const fn known(self) -> Option<Dimension> {
        match self {
            Self::Known(dimension) => Some(dimension),
            _ => None,
        }
    }
}

impl From<Dimension> for Measure {
    fn from(dimension: Dimension) -> Self {
        Self::Known(dimension)
    }
}

/// A power of metre, kilogram, second and ampere, each in sixths, so that square and cube roots stay whole.
#[derive(Debug, Clone, Copy)]
pub struct Dimension {
    metre: i32,
    kilogram: i32,
    second: i32,
    ampere: i32,
    /// Whether angles take part, so that messages say `rad`.
    angular: bool,
}

/// Angles are dimensionless.
impl PartialEq for Dimension {
    fn eq(&self, other: &Self) -> bool {
        let powers = |of: &Self| [of.metre, of.kilogram, of.second, of.ampere];
        powers(self) == powers(other)
    }
}

impl Eq for Dimension {}

const ONE: i32 = 6;

/// What messages call a dimension, where the base units would not be recognised.
const NAMED: [(Dimension, &str); 12] = [
    (Dimension::ANGULAR_VELOCITY, "rad/s"),
    (Dimension::FORCE, "N"),
    (Dimension::TORQUE, "N*m"),
    (Dimension::base(2, 1, -3), "W"),
    (Dimension::base(0, 1, -2), "N/m"),
    (Dimension::base(0, 1, -1), "N*s/m"),
    (Dimension::base(2, 1, -1), "N*m*s"),
    (Dimension::VOLTAGE, "V"),
    (Dimension::RESISTANCE, "ohm"),
    (Dimension::INDUCTANCE, "H"),
    (Dimension::electric(2, 1, -4, -1), "V/s"),
    (Dimension::electric(2, 1, -2, -1), "N*m/A"),
];

impl Dimension {
    pub const NONE: Self = Self::base(0, 0, 0);
    pub const LENGTH: Self = Self::base(1, 0, 0);
    pub const TIME: Self = Self::base(0, 0, 1);
    pub const VELOCITY: Self = Self::base(1, 0, -1);
    pub const ANGLE: Self = Self { angular: true, ..Self::NONE };
    pub const ANGULAR_VELOCITY: Self = Self { angular: true, ..Self::base(0, 0, -1) };
    pub const MASS: Self = Self::base(0, 1, 0);
    pub const INERTIA: Self = Self::base(2, 1, 0);
    pub const FORCE: Self = Self::base(1, 1, -2);
    pub const TORQUE: Self = Self::base(2, 1, -2);
    pub const CURRENT: Self = Self::electric(0, 0, 0, 1);
    pub const VOLTAGE: Self = Self::electric(2, 1, -3, -1);
    pub const RESISTANCE: Self = Self::electric(2, 1, -3, -2);
    pub const INDUCTANCE: Self = Self::electric(2, 1, -2, -2);

    /// m^metre kg^kilogram s^second
    pub const fn base(metre: i32, kilogram: i32, second: i32) -> Self {
        Self::electric(metre, kilogram, second, 0)
    }

    /// m^metre kg^kilogram s^second A^ampere
    const fn electric(metre: i32, kilogram: i32, second: i32, ampere: i32) -> Self {
        Self {
            metre: ONE * metre,
            kilogram: ONE * kilogram,
            second: ONE * second,
            ampere: ONE * ampere,
            angular: false,
        }
    }

    pub fn times(self, other: Self) -> Self {
        Self { angular: self.angular || other.angular, ..self.combine(other, |a, b| a + b) }
    }

    pub fn over(self, other: Self) -> Self {
        Self { angular: self.angular != other.angular, ..self.combine(other, |a, b| a - b) }
    }

    /// `None` when the power is not a whole number of sixths.
    pub fn power(self, exponent: f64) -> Option<Self> {
        let scale = |power: i32| {
            let power = f64::from(power) * exponent;
            (power.fract() == 0.0 && power.abs() < 1e6).then_some(power as i32)
        };
        let [metre, kilogram, second, ampere] = [self.metre, self.kilogram, self.second, self.ampere].map(scale);
        Some(Self { metre: metre?, kilogram: kilogram?, second: second?, ampere: ampere?, angular: self.angular })
    }

    /// In a sentence: "`+` stands between m and …".
    pub fn in_words(self) -> String {
        if self == Self::NONE && !self.angular { PLAIN_NUMBER.to_owned() } else { self.to_string() }
    }

    fn combine(self, other: Self, f: impl Fn(i32, i32) -> i32) -> Self {
        Self {
            metre: f(self.metre, other.metre),
            kilogram: f(self.kilogram, other.kilogram),
            second: f(self.second, other.second),
            ampere: f(self.ampere, other.ampere),
            angular: false,
        }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::NONE {
            return f.write_str(if self.angular { "rad" } else { "1" });
        }
        if let Some((_, name)) = NAMED.iter().find(|(named, _)| named == self) {
            return f.write_str(name);
        }
        let units = [("kg", self.kilogram), ("m", self.metre), ("s", self.second), ("A", self.ampere)];
        let power = |(unit, power): (&str, i32)| match power.abs() {
            ONE => unit.to_owned(),
            power if power % ONE == 0 => format!("{unit}^{}", power / ONE),
            power => {
                // sixths that are not whole are halves, thirds or sixths
                let common = [3, 2, 1].into_iter().find(|n| power % n == 0).unwrap_or(1);
                format!("{unit}^({}/{})", power / common, ONE / common)
            }
        };
        let above: Vec<String> = units.into_iter().filter(|(_, power)| *power > 0).map(power).collect();
        let below = units.into_iter().filter(|(_, power)| *power < 0).map(power);
        f.write_str(&if above.is_empty() { "1".to_owned() } else { above.join("*") })?;
        below.into_iter().try_for_each(|unit| write!(f, "/{unit}"))
    }
}
