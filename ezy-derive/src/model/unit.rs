//! Units: dimension and size in SI units.

use super::Expr;
use super::dimension::Dimension;
use crate::diag::{Diagnostics, names};
use crate::parse::ast;
use crate::units::{NAMES, spelling};
use std::f64::consts::PI;

/// A unit is `times / over * pi^pi` SI units; whole numbers, so that 200 mm is the f64 nearest to 0.2 m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    pub times: f64,
    pub over: f64,
    pub pi: i32,
    pub dimension: Dimension,
}

#[derive(Clone, Copy)]
struct Known {
    name: &'static str,
    times: f64,
    over: f64,
    pi: i32,
    dimension: Dimension,
}

const fn known(name: &'static str, times: f64, over: f64, dimension: Dimension) -> Known {
    Known { name, times, over, pi: 0, dimension }
}

const ENERGY: Dimension = Dimension::TORQUE;
const POWER: Dimension = Dimension::base(2, 1, -3);

static KNOWN: [Known; 36] = [
    known("m", 1.0, 1.0, Dimension::LENGTH),
    known("mm", 1.0, 1e3, Dimension::LENGTH),
    known("cm", 1.0, 1e2, Dimension::LENGTH),
    known("km", 1e3, 1.0, Dimension::LENGTH),
    known("kg", 1.0, 1.0, Dimension::MASS),
    known("g", 1.0, 1e3, Dimension::MASS),
    known("t", 1e3, 1.0, Dimension::MASS),
    known("s", 1.0, 1.0, Dimension::TIME),
    known("ms", 1.0, 1e3, Dimension::TIME),
    known("us", 1.0, 1e6, Dimension::TIME),
    known("min", 60.0, 1.0, Dimension::TIME),
    known("h", 3600.0, 1.0, Dimension::TIME),
    known("rad", 1.0, 1.0, Dimension::ANGLE),
    known("mrad", 1.0, 1e3, Dimension::ANGLE),
    Known { name: "deg", times: 1.0, over: 180.0, pi: 1, dimension: Dimension::ANGLE },
    known("Hz", 1.0, 1.0, Dimension::ANGULAR_VELOCITY),
    known("kHz", 1e3, 1.0, Dimension::ANGULAR_VELOCITY),
    known("N", 1.0, 1.0, Dimension::FORCE),
    known("mN", 1.0, 1e3, Dimension::FORCE),
    known("kN", 1e3, 1.0, Dimension::FORCE),
    known("MN", 1e6, 1.0, Dimension::FORCE),
    known("J", 1.0, 1.0, ENERGY),
    known("mJ", 1.0, 1e3, ENERGY),
    known("kJ", 1e3, 1.0, ENERGY),
    known("MJ", 1e6, 1.0, ENERGY),
    known("W", 1.0, 1.0, POWER),
    known("kW", 1e3, 1.0, POWER),
    known("MW", 1e6, 1.0, POWER),
    known("A", 1.0, 1.0, Dimension::CURRENT),
    known("mA", 1.0, 1e3, Dimension::CURRENT),
    known("V", 1.0, 1.0, Dimension::VOLTAGE),
    known("mV", 1.0, 1e3, Dimension::VOLTAGE),
    known("kV", 1e3, 1.0, Dimension::VOLTAGE),
    known("ohm", 1.0, 1.0, Dimension::RESISTANCE),
    known("H", 1.0, 1.0, Dimension::INDUCTANCE),
    known("mH", 1.0, 1e3, Dimension::INDUCTANCE),
];

impl Unit {
    pub const ONE: Self = Self { times: 1.0, over: 1.0, pi: 0, dimension: Dimension::NONE };

    /// A unit of the language's own tables.
    pub fn of_text(text: &str) -> Option<Self> {
        let unit = crate::parse::unit_of_text(text).ok()?;
        Self::resolve(&unit, &mut Diagnostics::default())
    }

    /// Reports every unknown name.
    pub fn resolve(unit: &ast::Unit, diag: &mut Diagnostics) -> Option<Self> {
        let factors: Vec<Option<Self>> = unit.factors.iter().map(|factor| Self::factor(factor, diag)).collect();
        factors.into_iter().try_fold(Self::ONE, |product, factor| Some(product.times(factor?)))
    }

    fn factor(factor: &ast::UnitFactor, diag: &mut Diagnostics) -> Option<Self> {
        let Some(known) = KNOWN.iter().find(|known| factor.name == known.name) else {
            let instead = spelling(&factor.name.to_string());
            let instead = instead.map(|instead| (instead.factor(factor.exponent), instead.is));
            diag.error(names::unknown_unit(&factor.name, instead, &NAMES));
            return None;
        };
        let one = Self { times: known.times, over: known.over, pi: known.pi, dimension: known.dimension };
        let base = if factor.exponent < 0 { one.inverse() } else { one };
        Some((0..factor.exponent.abs()).fold(Self::ONE, |product, _| product.times(base)))
    }

    fn times(self, other: Self) -> Self {
        Self {
            times: self.times * other.times,
            over: self.over * other.over,
            pi: self.pi + other.pi,
            dimension: self.dimension.times(other.dimension),
        }
    }

    /// `value` of this unit, in SI units.
    pub fn to_si(self, value: f64) -> f64 {
        value * self.times * PI.powi(self.pi) / self.over
    }

    /// A number of this unit, in SI units; pi stays a symbol.
    pub fn expr_of_number(self, value: f64) -> Expr {
        match self.pi {
            0 => Expr::Number(self.to_si(value)),
            pi => {
                (0..pi.abs()).fold(Expr::Number(value * self.times), |value, _| {
                    if pi > 0 { value * Expr::Pi } else { value / Expr::Pi }
                }) / Expr::Number(self.over)
            }
        }
    }

    /// `1/unit`
    pub fn inverse(self) -> Self {
        Self { times: self.over, over: self.times, pi: -self.pi, dimension: Dimension::NONE.over(self.dimension) }
    }

    /// Whether numbers of this unit are in SI units.
    pub fn is_si(self) -> bool {
        self.times == self.over && self.pi == 0
    }

    /// A value of this unit, in SI units; those leave no operation.
    pub fn expr_to_si(self, value: Expr) -> Expr {
        if self.is_si() { value } else { value * Expr::Conversion(self) }
    }

    /// A value in SI units, in this unit.
    pub fn expr_from_si(self, value: Expr) -> Expr {
        self.inverse().expr_to_si(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_known_units_are_those_of_the_parser() {
        assert_eq!(KNOWN.map(|known| known.name), NAMES);
    }
}
