//! `let` values and named places: resolved when first used, so that their order does not matter.

use super::context::{Context, PointSource, Purpose, State};
use super::names::{Scope, Symbol};
use super::value::{Form, Value};
use super::{BodyId, Expr, Place, PointId};
use crate::diag::{names, rules, values};
use crate::parse::ast;
use proc_macro2::Ident;

/// Values are inserted where they are used: more parts than this would make the equations explode.
const MAX_PARTS: usize = 2_000;
/// The same for the depth of an expression, which bounds the recursion of all later stages.
const MAX_DEPTH: usize = 300;
/// Values used before they are declared are resolved by recursion, whose depth this bounds.
const MAX_LETS_IN_WORK: usize = 32;

impl Context<'_> {
    /// The value of a `let`, used at `at`.
    pub fn let_value(&mut self, id: usize, at: &Ident) -> Option<Value> {
        let (scope, source) = self.lets[id].source;
        match &self.lets[id].state {
            State::Done(value) => return Some(value.clone()),
            State::Faulty => return None,
            State::InWork => {
                return self.diag.refuse(values::cyclic_let(at, &source.name));
            }
            State::Waiting => {}
        }
        if self.n_lets_in_work == MAX_LETS_IN_WORK {
            return self.diag.refuse(values::let_used_too_early(&source.name));
        }
        self.lets[id].state = State::InWork;
        self.n_lets_in_work += 1;
        let value = self.value(&source.value, &Purpose::moving(scope));
        self.n_lets_in_work -= 1;
        let value = value.filter(|value| {
            let (parts, depth) = match &value.form {
                Form::Scalar(value) => size(value),
                Form::Vector(x, y) => (size(x).0 + size(y).0, size(x).1.max(size(y).1)),
            };
            let small = parts <= MAX_PARTS && depth <= MAX_DEPTH;
            if !small {
                self.diag.error(values::let_too_large(&source.name));
            }
            small
        });
        self.lets[id].state = value.clone().map_or(State::Faulty, State::Done);
        value
    }

    /// A place in the text.
    pub fn place(&mut self, place: &ast::Place, scope: Scope) -> Option<Place> {
        match place {
            ast::Place::OnBody(place) => self.on_body(place, scope),
            ast::Place::Named(name) => match self.names.lookup(scope, name) {
                Some(symbol @ (Symbol::Point(id) | Symbol::Hinge(_, id))) => {
                    self.refuse_index(name, symbol.what())?;
                    self.point_place(id, name)
                }
                Some(Symbol::Points(id) | Symbol::Hinges(_, id)) => {
                    self.with_member(id, name, |context, source| context.source_place(source))
                }
                Some(Symbol::Broken) => None,
                Some(symbol) => {
                    let carries = matches!(symbol, Symbol::Body(_));
                    self.diag.refuse(names::not_a_place(name, symbol.what(), carries, !name.indices.is_empty()))
                }
                None if name.word == "ground" => {
                    self.diag.refuse(names::not_a_place(name, "the fixed ground", true, !name.indices.is_empty()))
                }
                None => {
                    let error = self.names.unknown(name, |known| names::unknown(name, names::POINT, &known.places()));
                    self.diag.refuse(error)
                }
            },
        }
    }

    /// The place of a named point, used at `at`.
    pub fn point_place(&mut self, id: PointId, at: &Ident) -> Option<Place> {
        match &self.points[id.0].state {
            State::Done(place) => return Some(place.clone()),
            State::Faulty => return None,
            State::InWork => {
                return self.diag.refuse(rules::cyclic_place(at));
            }
            State::Waiting => {}
        }
        self.points[id.0].state = State::InWork;
        let place = self.source_place(self.points[id.0].source);
        self.points[id.0].state = place.clone().map_or(State::Faulty, State::Done);
        place
    }

    /// The place of a point, or the first one of a hinge.
    pub fn source_place(&mut self, source: PointSource<'_>) -> Option<Place> {
        match source {
            PointSource::Point(point) => self.on_body(&point.place, None),
            PointSource::Hinge(_, place, _, scope) => self.place(place, scope),
        }
    }

    fn on_body(&mut self, place: &ast::OnBody, scope: Scope) -> Option<Place> {
        let purpose = Purpose::fixed(scope, "a point on a body".into());
        let length = Some(super::dimension::Dimension::LENGTH);
        let body = self.body_or_ground(&place.body);
        let x = self.scalar(&place.x, &purpose, "a point", length);
        let y = self.scalar(&place.y, &purpose, "a point", length);
        Some(Place { body: body?, x: x?, y: y? })
    }

    /// A body, or `Some(None)` for the ground.
    pub fn body_or_ground(&mut self, name: &ast::Name) -> Option<Option<BodyId>> {
        if name.word == "ground" {
            return self.refuse_index(name, "the fixed ground").map(|()| None);
        }
        self.body(name, true).map(Some)
    }

    /// A body that is not the ground.
    pub fn body(&mut self, name: &ast::Name, or_ground: bool) -> Option<BodyId> {
        let error = match self.names.lookup(None, name) {
            Some(Symbol::Body(id)) => return self.refuse_index(name, "a body").map(|()| id),
            Some(Symbol::Bodies(array)) => return self.body_member(array, name),
            Some(Symbol::Broken) => return None,
            Some(symbol) => names::not_a_body(name, symbol.what()),
            None if name.word == "ground" => rules::ground_is_no_body(name),
            None => {
                let ground: &[&str] = if or_ground { &["ground"] } else { &[] };
                names::unknown(name, names::BODY, &[ground, &self.names.bodies()].concat())
            }
        };
        self.diag.refuse(error)
    }
}

/// Parts and depth of an expression.
fn size(expr: &Expr) -> (usize, usize) {
    let parts = expr.operands().into_iter().map(size);
    let (parts, depth) = parts.fold((0, 0), |sum, part| (sum.0 + part.0, sum.1.max(part.1)));
    (parts + 1, depth + 1)
}
