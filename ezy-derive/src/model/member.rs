//! `owner.member`: coordinates and velocities of bodies, points and hinges.

use super::context::{Context, Motion, Purpose};
use super::names::Symbol;
use super::value::Value;
use super::{Component, Expr};
use crate::diag::{Extent, names};
use crate::parse::ast;
use proc_macro2::Ident;

const BODY: &[&str] = &["x", "y", "phi", "vx", "vy", "omega", "r", "v"];
const POINT: &[&str] = &["x", "y", "vx", "vy", "r", "v"];
const HINGE: &[&str] = &["x", "y", "vx", "vy", "r", "v", "angle", "rate"];

/// What a member is; of a hinge, φ is its angle.
#[derive(Clone, Copy)]
enum Shape {
    Component(Component),
    Vector,
}

impl Shape {
    /// By its name, with whether it is a velocity.
    fn of(member: &str) -> Option<(Self, bool)> {
        let named = |rate| move |component: &Component| component.name(rate) == member;
        let component = |rate| Component::ALL.into_iter().find(named(rate)).map(|found| (Self::Component(found), rate));
        match member {
            "r" => Some((Self::Vector, false)),
            "v" => Some((Self::Vector, true)),
            "angle" => Some((Self::Component(Component::Phi), false)),
            "rate" => Some((Self::Component(Component::Phi), true)),
            _ => component(false).or(component(true)),
        }
    }

    fn value(self, rate: bool, of: impl Fn(Component) -> Expr) -> Value {
        match self {
            Self::Component(component) => Value::scalar(of(component), component.dimension(rate)),
            Self::Vector => Value::vector(of(Component::X), of(Component::Y), Component::X.dimension(rate)),
        }
    }
}

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
                self.names.unknown(owner, |known| names::unknown(owner, names::OWNER, &known.owners()))
            };
            return self.diag.refuse(error);
        };
        if symbol == Symbol::Broken {
            return None;
        }
        let members = Self::members(symbol);
        let known = members.iter().find(|known| member == *known);
        let Some((shape, rate)) = known.and_then(|known| Shape::of(known)) else {
            return self.diag.refuse(match members {
                [] => names::no_members(member, owner, symbol.what()),
                _ => names::unknown_member(member, owner, symbol.what(), members),
            });
        };
        let value = self.member_value(owner, symbol, shape, rate)?;
        let moving = if rate { Motion::Velocity } else { Motion::Position };
        self.forbid_motion(Extent { first: owner.span(), last: member.span() }, moving, purpose)?;
        Some(value)
    }

    /// The value of a member that the owner has.
    fn member_value(&mut self, owner: &ast::Name, symbol: Symbol, shape: Shape, rate: bool) -> Option<Value> {
        let of = |position: Expr, velocity: Expr| if rate { velocity } else { position };
        let is_angle = matches!(shape, Shape::Component(Component::Phi));
        Some(match symbol {
            Symbol::Body(_) | Symbol::Bodies(_) => {
                let id = self.body(owner, false)?;
                shape.value(rate, |component| of(Expr::Coordinate(id, component), Expr::Velocity(id, component)))
            }
            Symbol::Hinge(row, _) if is_angle => {
                self.refuse_index(owner, symbol.what())?;
                shape.value(rate, |_| of(Expr::HingeAngle(row), Expr::HingeRate(row)))
            }
            Symbol::Hinges(_, id) if is_angle => {
                let angle = self.hinge_member(id, owner, rate)?;
                shape.value(rate, |_| angle.clone())
            }
            Symbol::Point(id) | Symbol::Hinge(_, id) => {
                self.refuse_index(owner, symbol.what())?;
                shape
                    .value(rate, |component| of(Expr::PointPosition(id, component), Expr::PointVelocity(id, component)))
            }
            Symbol::Points(id) | Symbol::Hinges(_, id) => {
                let place = self.with_member(id, owner, |context, source| context.source_place(source))?;
                let place = || Box::new(place.clone());
                let at =
                    |component| of(Expr::MemberPosition(place(), component), Expr::MemberVelocity(place(), component));
                shape.value(rate, at)
            }
            _ => return None,
        })
    }
}
