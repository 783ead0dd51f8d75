//! Starts: which coordinates and velocities are given.

use super::constant::literal;
use super::context::{Context, Purpose};
use super::{Component, Expr, Start, StartValue};
use crate::diag::scenes;
use crate::parse::ast::{self, GivenValues, Quantity};
use proc_macro2::Ident;
use std::f64::consts::TAU;

/// Coordinates and velocities that a quantity gives, `true` for a velocity.
const fn components(quantity: Quantity) -> &'static [(Component, bool)] {
    match quantity {
        Quantity::Position => &[(Component::X, false), (Component::Y, false)],
        Quantity::Angle => &[(Component::Phi, false)],
        Quantity::Velocity => &[(Component::X, true), (Component::Y, true)],
        Quantity::Rate => &[(Component::Phi, true)],
        Quantity::X => &[(Component::X, false)],
        Quantity::Y => &[(Component::Y, false)],
        Quantity::VelocityX => &[(Component::X, true)],
        Quantity::VelocityY => &[(Component::Y, true)],
    }
}

/// The number that an angle is, when no unit stands behind it.
fn bare_angle(given: &ast::Given) -> Option<f64> {
    let GivenValues::Each(values) = &given.values else { return None };
    match (given.quantity, &values[..]) {
        (Quantity::Angle, [Some(ast::Expr::Number { value, .. })]) => Some(*value),
        (Quantity::Angle, [Some(ast::Expr::Negative { operand, .. })]) => match **operand {
            ast::Expr::Number { value, .. } => Some(-value),
            _ => None,
        },
        _ => None,
    }
}

/// A component that a quantity gives.
enum Given {
    /// `_`
    Free,
    /// Its faults were reported.
    Broken,
    Value(Expr),
}

impl Given {
    fn of(value: Option<Expr>) -> Self {
        value.map_or(Self::Broken, Self::Value)
    }
}

impl Context<'_> {
    /// The components that a quantity gives, in order.
    fn given(&mut self, given: &ast::Given) -> Vec<Given> {
        let name = |component: Component, rate: bool| format!("{}.{}", &*given.body, component.name(rate));
        match &given.values {
            GivenValues::Each(values) => {
                let named = values.iter().zip(components(given.quantity));
                let each = named.map(|(value, (component, rate))| {
                    let Some(value) = value else { return Given::Free };
                    let what = format!("the start value of `{}`", name(*component, *rate));
                    let dimension = component.dimension(*rate);
                    Given::of(self.scalar(value, &Purpose::fixed(None, what.clone()), &what, Some(dimension)))
                });
                each.collect()
            }
            GivenValues::Vector(value) => {
                let what = format!("the start value of `{}`", &*given.body);
                let dimension = components(given.quantity).first().map(|(component, rate)| component.dimension(*rate));
                let both = self.components(value, &Purpose::fixed(None, what.clone()), &what, dimension);
                let (x, y) = both.unzip();
                vec![Given::of(x), Given::of(y)]
            }
        }
    }

    pub fn start(&mut self, start: &ast::Start) -> Start {
        let mut values: Vec<StartValue> = Vec::new();
        let mut words: Vec<&Ident> = Vec::new();
        for given in &start.given {
            if given.body.word == "ground" {
                self.diag.error(scenes::ground_starts(&given.body));
                continue;
            }
            let loops = self.enter(&given.loops);
            let Some(body) = self.body(&given.body, false) else { continue };
            let resolved = self.given(given);
            for (value, (component, rate)) in resolved.into_iter().zip(components(given.quantity)) {
                if matches!(value, Given::Free) {
                    continue;
                }
                let name = format!("{}.{}", &*given.body, component.name(*rate));
                let same = |other: &StartValue| (other.body, other.component, other.rate) == (body, *component, *rate);
                if let Some(first) = values.iter().position(same) {
                    self.diag.error(scenes::start_gives_twice(&given.word, &start.name, &name, words[first]));
                    continue;
                }
                let Given::Value(resolved) = value else { continue };
                if let Some(angle) = bare_angle(given).filter(|angle| angle.abs() > TAU) {
                    self.diag.warning(scenes::angle_beyond_a_turn(&given.word, &name, angle));
                }
                if let Some(rest) = start.at_rest.as_ref().filter(|_| *rate && literal(&resolved) != Some(0.0)) {
                    self.diag.error(scenes::moves_at_rest(rest, &start.name, &name, &given.word));
                }
                values.push(StartValue {
                    body,
                    component: *component,
                    rate: *rate,
                    near: given.near,
                    value: resolved,
                    loops: loops.clone(),
                });
                words.push(&given.word);
            }
        }
        self.leave();
        Start { name: start.name.clone(), values }
    }
}
