//! Starts: which coordinates and velocities are given.

use super::constant::literal;
use super::context::{Context, Purpose};
use super::{Component, Start, StartValue};
use crate::diag::scenes;
use crate::parse::ast::{self, Quantity};
use proc_macro2::Ident;

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

impl Context<'_> {
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
            for (value, (component, rate)) in given.values.iter().zip(components(given.quantity)) {
                let Some(value) = value else { continue };
                let name = format!("{}.{}", &*given.body, component.name(*rate));
                let what = format!("the start value of `{name}`");
                let purpose = Purpose::fixed(None, what.clone());
                let resolved = self.scalar(value, &purpose, &what, Some(component.dimension(*rate)));
                let same = |other: &StartValue| (other.body, other.component, other.rate) == (body, *component, *rate);
                if let Some(first) = values.iter().position(same) {
                    self.diag.error(scenes::start_gives_twice(&given.word, &start.name, &name, words[first]));
                    continue;
                }
                let Some(resolved) = resolved else { continue };
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
