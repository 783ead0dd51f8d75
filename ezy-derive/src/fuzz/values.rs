//! Random expressions of given units.

use crate::random::Random;

/// What an expression may depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Depends {
    /// Parameters alone.
    Parameters,
    /// The time, too.
    Time,
    /// Positions, too.
    Positions,
    /// Velocities, too.
    Velocities,
    /// Inputs, too.
    Everything,
}

/// Names that expressions can use, and the declarations that they make on their way.
#[derive(Debug, Default)]
pub struct Names {
    /// Parameters and values: name, unit, what they depend on.
    pub values: Vec<(String, &'static str, Depends)>,
    /// Bodies as they are written here: `seat`, in a loop `link[i-1]`.
    pub bodies: Vec<String>,
    pub points: Vec<String>,
    pub hinges: Vec<String>,
    /// Counts and indices of loops.
    pub whole: Vec<String>,
    pub declarations: String,
}

/// Numbers as they are written.
const NUMBERS: [&str; 11] = ["1", "2", "0.5", "1.5e1", "3e-2", "12", "0.125", "2.75", "1e3", "7", "0.3"];
/// Numbers that nobody writes in good faith.
const EXTREMES: [&str; 6] = ["0", "1e300", "1e-300", "5e-324", "1.7e308", "123456789012345678901234567890"];

/// Units in other words, by which the parameters of a unit may be declared.
const SPELLINGS: [(&str, &[&str]); 9] = [
    ("1", &["1", "rad", "m/m"]),
    ("m", &["m", "mm", "cm", "km"]),
    ("rad", &["rad", "deg", "mrad"]),
    ("m/s", &["m/s", "mm/s", "km/h"]),
    ("rad/s", &["rad/s", "deg/s", "Hz", "1/s"]),
    ("N", &["N", "kN", "kg*m/s^2", "J/m"]),
    ("N*m", &["N*m", "J", "kg*m^2/s^2"]),
    ("N/m", &["N/m", "kN/mm", "kg/s^2"]),
    ("N*s/m", &["N*s/m", "kg/s"]),
];

/// Deeper expressions are only longer.
const DEPTH: usize = 3;

pub struct Values<'a> {
    pub random: &'a mut Random,
    pub names: &'a mut Names,
}

impl Values<'_> {
    /// A scalar of this unit.
    pub fn scalar(&mut self, unit: &'static str, depends: Depends) -> String {
        self.of(unit, depends, DEPTH)
    }

    /// A vector of this unit.
    pub fn vector(&mut self, unit: &'static str, depends: Depends) -> String {
        match self.random.below(6) {
            0 => format!("{} * {}", self.of("1", depends, 2), self.vector(unit, depends)),
            1 => format!("-{}", self.vector(unit, depends)),
            2 if unit == "N" && depends >= Depends::Velocities => {
                let (c, at) = (self.of("N*s/m", depends, 1), self.owner());
                format!("-{c} * {at}.v")
            }
            _ => format!("({}, {})", self.scalar(unit, depends), self.scalar(unit, depends)),
        }
    }

    fn of(&mut self, unit: &'static str, depends: Depends, depth: usize) -> String {
        if depth == 0 || self.random.once_in(4) {
            return self.leaf(unit, depends);
        }
        let depth = depth - 1;
        let more = |this: &mut Self| this.of(unit, depends, depth);
        match self.random.below(9) {
            0 => format!("{} + {}", more(self), more(self)),
            1 => format!("({} - {})", more(self), more(self)),
            2 | 3 => format!("({}) * {}", more(self), self.plain(depends, depth)),
            4 => format!("({}) / (2 + {})", more(self), self.plain(depends, depth)),
            5 => format!("{}({}, {})", self.random.of(&["min", "max"]), more(self), more(self)),
            6 => format!("abs({})", more(self)),
            7 => format!("-({})", more(self)),
            _ => format!("sqrt(({})^2)", more(self)),
        }
    }

    /// A number without unit.
    fn plain(&mut self, depends: Depends, depth: usize) -> String {
        if depth == 0 {
            return self.leaf("1", depends);
        }
        let depth = depth - 1;
        let units = ["1", "m", "rad", "m/s", "N"];
        match self.random.below(11) {
            0 => format!("{}({})", self.random.of(&["sin", "cos", "tan"]), self.of("rad", depends, depth)),
            1 => format!("{}({})", self.random.of(&["exp", "tanh"]), self.plain(depends, depth)),
            2 => format!("ln(2 + ({})^2)", self.plain(depends, depth)),
            3 => {
                let unit = *self.random.of(&units);
                format!("({}) / ({})", self.of(unit, depends, depth), self.of(unit, depends, depth))
            }
            4 => {
                let unit = *self.random.of(&units);
                format!("sign({})", self.of(unit, depends, depth))
            }
            5 => {
                let exponent = *self.random.of(&["2", "3", "-1", "0.5", "7", "(1/3)", "-2"]);
                format!("({})^{exponent}", self.plain(depends, depth))
            }
            6 => {
                let unit = *self.random.of(&units);
                let [x, from, to] = [0; 3].map(|_| self.of(unit, depends, depth));
                format!("smooth_step({x}, {from}, {to})")
            }
            7 if depends >= Depends::Time => format!("sin({} * t)", self.of("rad/s", Depends::Parameters, 1)),
            8 if !self.names.whole.is_empty() => self.random.of(&self.names.whole).clone(),
            _ => self.leaf("1", depends),
        }
    }

    fn leaf(&mut self, unit: &'static str, depends: Depends) -> String {
        match self.random.below(5) {
            0 => self.number().to_owned(),
            1 => self.parameter(unit, depends),
            2 if unit == "rad" => self.angle(depends),
            _ => self.moving(unit, depends).unwrap_or_else(|| self.parameter(unit, depends)),
        }
    }

    fn number(&mut self) -> &'static str {
        let numbers: &[&'static str] = if self.random.once_in(30) { &EXTREMES } else { &NUMBERS };
        numbers[self.random.below(numbers.len())]
    }

    /// A coordinate or velocity.
    fn moving(&mut self, unit: &str, depends: Depends) -> Option<String> {
        let member = match unit {
            "m" if depends >= Depends::Positions => *self.random.of(&["x", "y"]),
            "m/s" if depends >= Depends::Velocities => *self.random.of(&["vx", "vy"]),
            "rad" | "rad/s" if depends >= Depends::Positions => {
                let rate = unit == "rad/s";
                if rate && depends < Depends::Velocities {
                    return None;
                }
                let hinge = !self.names.hinges.is_empty() && self.random.once_in(3);
                let owner = if hinge { &self.names.hinges } else { &self.names.bodies };
                let owner = if owner.is_empty() { return None } else { self.random.of(owner).clone() };
                let member = [["phi", "omega"], ["angle", "rate"]][usize::from(hinge)][usize::from(rate)];
                return Some(format!("{owner}.{member}"));
            }
            _ => return None,
        };
        let owner = self.owner();
        Some(match (unit, self.random.below(6)) {
            ("m", 0) => format!("norm({owner}.r)"),
            ("m", 1) => format!("dot({owner}.r, (0.6, -0.8))"),
            ("m/s", 0) => format!("norm({owner}.v)"),
            ("m/s", 1) => format!("cross((0.6, 0.8), {owner}.v)"),
            _ => format!("{owner}.{member}"),
        })
    }

    fn angle(&mut self, depends: Depends) -> String {
        match self.random.below(4) {
            0 => format!("atan2({}, {})", self.leaf("m", depends), self.leaf("m", depends)),
            1 => format!("{}({})", self.random.of(&["asin", "acos"]), self.leaf("1", depends)),
            2 if depends >= Depends::Velocities && !self.names.points.is_empty() && !self.names.bodies.is_empty() => {
                let (point, body) = (self.random.of(&self.names.points).clone(), self.random.of(&self.names.bodies));
                format!("slip_angle({point}, {body})")
            }
            3 if depends >= Depends::Time => format!("{} * t", self.parameter("rad/s", Depends::Parameters)),
            _ => "pi/2".to_owned(),
        }
    }

    /// A body or a point.
    fn owner(&mut self) -> String {
        let point = !self.names.points.is_empty() && self.random.once_in(2);
        let names = if point { &self.names.points } else { &self.names.bodies };
        if names.is_empty() { "nobody".to_owned() } else { self.random.of(names).clone() }
    }

    /// The name of a parameter or value of this unit: one that is there, or a new parameter.
    pub fn parameter(&mut self, unit: &'static str, depends: Depends) -> String {
        let known = self.names.values.iter().filter(|(_, of, needs)| *of == unit && *needs <= depends);
        let known: Vec<&String> = known.map(|(name, ..)| name).collect();
        if !known.is_empty() && !self.random.once_in(3) {
            return (*self.random.of(&known)).clone();
        }
        let name = format!("p{}", self.names.values.len());
        let spellings = SPELLINGS.iter().find(|(of, _)| *of == unit);
        let written = spellings.map_or(unit, |(_, all)| *self.random.of::<&str>(all));
        let unit_text = if self.random.once_in(3) { String::new() } else { format!(": {written}") };
        let minus = if self.random.once_in(4) { "-" } else { "" };
        let number = self.number();
        self.names.declarations += &format!("param {name}{unit_text} = {minus}{number};\n");
        self.names.values.push((name.clone(), unit, Depends::Parameters));
        name
    }
}
