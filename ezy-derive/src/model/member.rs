//! `owner.member`: coordinates and velocities of bodies, points and hinges.

use super::context::{Context, Motion, Purpose};
use super::dimension::Dimension;
use super::names::Symbol;
use super::value::Value;
use super::{BodyId, Component, Expr, Place, PointId};
use crate::diag::{Extent, names};
use crate::parse::ast;
use proc_macro2::Ident;

const BODY: &[&str] = &["x", "y", "phi", "vx", "vy", "omega", "r", "v"];
const POINT: &[&str] = &["x", "y", "vx", "vy", "r", "v"];
const HINGE: &[&str] = &["x", "y", "vx", "vy", "r", "v", "angle", "rate"];

impl Context<'_> {
    /// What can stand behind the dot.
    pub const fn members(symbol: Symbol) -> &'static [&'static str] {
        match symbol {
            Symbol::Body(_) | Symbol::Bodies(_) => BODY,
            Symbol::Point(_) | Symbol::Points(_) => POINT,
            Symbol::Hinge(..) | Symbol::Hinges(..) => HINGE,
            _ => &[],
        }
    }

    pub fn member(&mut self, owner: &ast::Name, member: &Ident, purpose: &Purpose) -> Option<Value> {
        let Some(symbol) = self.names.lookup(purpose.scope, owner) else {
            let error = if ["ground", "t", "pi"].iter().any(|word| owner.word == word) {
                names::no_members(member, owner, "a name of the language")
            } else {
                self.names.unknown(owner, |known| names::unknown_owner(owner, &known.owners()))
            };
            self.diag.error(error);
            return None;
        };
        let name = member.to_string();
        let value = match symbol {
            Symbol::Broken => return None,
            Symbol::Body(_) | Symbol::Bodies(_) => body_member(self.body(owner, false)?, &name),
            Symbol::Point(id) => {
                self.refuse_index(owner, symbol.what())?;
                point_member(&Carrier::Point(id), &name)
            }
            Symbol::Hinge(row, point) => {
                self.refuse_index(owner, symbol.what())?;
                match name.as_str() {
                    "angle" => Some(Value::scalar(Expr::HingeAngle(row), Dimension::ANGLE)),
                    "rate" => Some(Value::scalar(Expr::HingeRate(row), Dimension::ANGULAR_VELOCITY)),
                    _ => point_member(&Carrier::Point(point), &name),
                }
            }
            Symbol::Hinges(_, id) if name == "angle" => {
                Some(Value::scalar(self.hinge_member(id, owner, false)?, Dimension::ANGLE))
            }
            Symbol::Hinges(_, id) if name == "rate" => {
                Some(Value::scalar(self.hinge_member(id, owner, true)?, Dimension::ANGULAR_VELOCITY))
            }
            Symbol::Points(id) | Symbol::Hinges(_, id) => {
                let place = self.with_member(id, owner, |context, source| context.source_place(source))?;
                point_member(&Carrier::Member(place), &name)
            }
            Symbol::Count(_)
            | Symbol::Parameter(_)
            | Symbol::Input(_)
            | Symbol::Output
            | Symbol::Event(..)
            | Symbol::Stop
            | Symbol::Let(_)
            | Symbol::Row(..) => {
                self.diag.error(names::no_members(member, owner, symbol.what()));
                return None;
            }
        };
        let Some(value) = value else {
            self.diag.error(names::unknown_member(member, owner, symbol.what(), Self::members(symbol)));
            return None;
        };
        let position = matches!(name.as_str(), "x" | "y" | "phi" | "r" | "angle");
        let moving = if position { Motion::Position } else { Motion::Velocity };
        self.forbid_motion(Extent { first: owner.span(), last: member.span() }, moving, purpose)?;
        Some(value)
    }
}

fn body_member(id: BodyId, member: &str) -> Option<Value> {
    let coordinate = |component| Expr::Coordinate(id, component);
    let velocity = |component| Expr::Velocity(id, component);
    for component in Component::ALL {
        if member == component.name(false) {
            return Some(Value::scalar(coordinate(component), component.dimension(false)));
        }
        if member == component.name(true) {
            return Some(Value::scalar(velocity(component), component.dimension(true)));
        }
    }
    match member {
        "r" => Some(Value::vector(coordinate(Component::X), coordinate(Component::Y), Dimension::LENGTH)),
        "v" => Some(Value::vector(velocity(Component::X), velocity(Component::Y), Dimension::VELOCITY)),
        _ => None,
    }
}

/// What carries the members of a point.
enum Carrier {
    Point(PointId),
    /// A member of an array.
    Member(Place),
}

fn point_member(carrier: &Carrier, member: &str) -> Option<Value> {
    let position = |component| match carrier {
        Carrier::Point(id) => Expr::PointPosition(*id, component),
        Carrier::Member(place) => Expr::MemberPosition(Box::new(place.clone()), component),
    };
    let velocity = |component| match carrier {
        Carrier::Point(id) => Expr::PointVelocity(*id, component),
        Carrier::Member(place) => Expr::MemberVelocity(Box::new(place.clone()), component),
    };
    Some(match member {
        "x" => Value::scalar(position(Component::X), Dimension::LENGTH),
        "y" => Value::scalar(position(Component::Y), Dimension::LENGTH),
        "vx" => Value::scalar(velocity(Component::X), Dimension::VELOCITY),
        "vy" => Value::scalar(velocity(Component::Y), Dimension::VELOCITY),
        "r" => Value::vector(position(Component::X), position(Component::Y), Dimension::LENGTH),
        "v" => Value::vector(velocity(Component::X), velocity(Component::Y), Dimension::VELOCITY),
        _ => return None,
    })
}
