//! Rows and forces: what is written for each part of their form.

use super::constant::literal;
use super::context::{Context, Motion, Purpose};
use super::dimension::Dimension;
use super::names::{Scope, Symbol};
use super::unit::Unit;
use super::{Arguments, Expr, Force, Place, Row, RowId};
use crate::diag::rules;
use crate::grammar::{Class, Expected, IfAbsent, Setting};
use crate::parse::ast::{self, Phrase, Statement};
use proc_macro2::{Ident, Span};

impl Context<'_> {
    /// A row; `name` is its own or the one that it got.
    pub fn row(
        &mut self,
        statement: &Statement,
        loops: &[ast::Loop],
        name: &Ident,
        id: RowId,
        effect: Scope,
    ) -> Option<Row> {
        let loops_of_row = self.enter(loops);
        if let Some(name) = &statement.name {
            self.check_declared_name(name, loops);
        }
        let subject = format!("{} `{name}`", statement.word.word);
        let arguments = self.arguments(statement, subject, effect, Some(id));
        self.leave();
        Some(Row { name: name.clone(), word: statement.word, effect, loops: loops_of_row, arguments: arguments? })
    }

    /// A force, the declaration of this number; of a gravity that acts on arrays, one for each of them.
    pub fn force(
        &mut self,
        statement: &Statement,
        loops: &[ast::Loop],
        effect: Scope,
        declaration: usize,
    ) -> Vec<Force> {
        let loops = self.enter(loops);
        let (word, name) = (statement.word, statement.what_and_where());
        let arguments = self.arguments(statement, format!("this {}", word.word), effect, None);
        let forces = match arguments {
            None => Vec::new(),
            Some(arguments) if word.acts_on_all_bodies() && self.is_repeated() => {
                let on = |(body, loops)| {
                    let arguments = Arguments {
                        bodies: vec![Some(body)],
                        vector: arguments.vector.clone(),
                        ..Arguments::default()
                    };
                    Force { word, name: name.clone(), declaration, effect, loops, arguments }
                };
                self.all_bodies().into_iter().map(on).collect()
            }
            Some(arguments) => vec![Force { word, name, declaration, effect, loops, arguments }],
        };
        self.leave();
        forces
    }

    fn arguments(
        &mut self,
        statement: &Statement,
        subject: String,
        scope: Scope,
        row: Option<RowId>,
    ) -> Option<Arguments> {
        let purpose = match statement.word.class {
            Class::PositionRow => Purpose::up_to(scope, subject.clone(), Motion::Position),
            Class::VelocityRow => Purpose::up_to(scope, subject.clone(), Motion::Velocity),
            Class::Force => Purpose::moving(scope),
        };
        let n_errors = self.diag.n_errors();
        let mut reader = Reader { context: self, statement, subject, purpose, row, arguments: Arguments::default() };
        statement.phrases.iter().for_each(|phrase| reader.phrase(phrase));
        let arguments = reader.arguments;
        (self.diag.n_errors() == n_errors).then_some(arguments)
    }
}

impl Statement {
    /// What it is and where: `spring A ~ B`, `force at P`, `torque arm`; of a place on a body the body.
    pub fn what_and_where(&self) -> String {
        let places = self.phrases.iter().filter_map(|phrase| match phrase {
            Phrase::Pair(pair) => Some(format!(" {} ~ {}", pair[0].owner().text, pair[1].owner().text)),
            Phrase::At(place) => Some(format!(" at {}", place.owner().text)),
            Phrase::Couple(a, b) => Some(format!(" {} ~ {}", a.text, b.text)),
            Phrase::Body(body) => Some(format!(" {}", body.text)),
            _ => None,
        });
        std::iter::once(self.word.word.to_owned()).chain(places).collect()
    }
}

/// Collects the arguments of one statement; what is missing after a fault is never looked at.
struct Reader<'r, 'a> {
    context: &'r mut Context<'a>,
    statement: &'r Statement,
    /// "hinge `B`", or "this spring".
    subject: String,
    purpose: Purpose,
    row: Option<RowId>,
    arguments: Arguments,
}

impl Reader<'_, '_> {
    fn phrase(&mut self, phrase: &Phrase) {
        match phrase {
            Phrase::Pair(pair) => self.pair(pair),
            Phrase::At(at) => self.at(at),
            Phrase::Couple(a, b) => self.couple(a, b),
            Phrase::Body(body) => self.arguments.bodies.extend(self.context.body(body, false).map(Some)),
            Phrase::Direction { across, direction } => {
                self.arguments.across = *across;
                self.arguments.directions.extend(self.context.direction(direction, self.purpose.scope));
            }
            Phrase::Scalar(Expected { what, unit }, value) => {
                self.arguments.scalars.extend(self.context.scalar(value, &self.purpose, what, dimension(unit)));
            }
            Phrase::Vector(Expected { what, unit }, value) => {
                self.arguments.vector = self.context.components(value, &self.purpose, what, dimension(unit));
            }
            Phrase::Equation { left, equals, right } => self.equation([left, right], *equals),
            Phrase::Settings(known, given) => self.settings(known, given),
        }
    }

    /// Two points, which must not be on one body.
    fn pair(&mut self, [a, b]: &[ast::Place; 2]) {
        let (first, second) = (self.first_place(a), self.context.place(b, self.purpose.scope));
        let bodies = first.as_ref().zip(second.as_ref()).map(|(first, second)| (first.body, second.body));
        if let Some((first, _)) = bodies.filter(|(first, second)| first == second) {
            self.context.diag.error(rules::within_body(b.owner(), &self.subject, first.is_none()));
        }
        self.arguments.places.extend([first, second].into_iter().flatten());
    }

    /// The first point of a hinge is the point of its name, whose faults are told once.
    fn first_place(&mut self, place: &ast::Place) -> Option<Place> {
        let name = self.statement.name.as_ref();
        match name.and_then(|name| self.context.names.lookup(self.purpose.scope, name)) {
            Some(Symbol::Hinge(id, point)) if Some(id) == self.row => self.context.point_place(point, place.owner()),
            Some(Symbol::Hinges(id, point)) if Some(id) == self.row => self.context.declared_member(point),
            _ => self.context.place(place, self.purpose.scope),
        }
    }

    fn at(&mut self, at: &ast::Place) {
        let place = self.context.place(at, self.purpose.scope);
        if place.as_ref().is_some_and(|place| place.body.is_none()) {
            self.context.diag.error(rules::on_ground(at.owner(), &self.subject));
        }
        self.arguments.places.extend(place);
    }

    /// Two bodies, or members of arrays, which must differ.
    fn couple(&mut self, a: &ast::Name, b: &ast::Name) {
        let single = a.indices.is_empty() && b.indices.is_empty();
        if single && a.word == b.word {
            self.context.diag.error(rules::couple_of_one(b, &self.subject));
            return;
        }
        let bodies = [a, b].map(|name| self.context.body_or_ground(name));
        if !single && bodies[0].is_some() && bodies[0] == bodies[1] {
            self.context.diag.error(rules::couple_of_one(b, &self.subject));
        }
        self.arguments.bodies.extend(bodies.into_iter().flatten());
    }

    /// Reaction times rate of the row is power, which gives the unit of the multiplier.
    fn equation(&mut self, sides: [&ast::Expr; 2], equals: Span) {
        let difference = self.context.difference(sides, ("=", equals), &self.purpose, &self.subject);
        let Some((value, measure)) = difference else { return };
        let work = match self.statement.word.class {
            Class::VelocityRow => Dimension::TORQUE.over(Dimension::TIME),
            _ => Dimension::TORQUE,
        };
        self.arguments.multiplier_unit = measure.known().map_or_else(String::new, |unit| work.over(unit).to_string());
        self.arguments.scalars.push(value);
    }

    fn settings(&mut self, known: &[Setting], given: &[Option<ast::Expr>]) {
        if self.statement.word.class == Class::VelocityRow {
            // a limit of a row of velocities is a force
            self.purpose = Purpose::moving(self.purpose.scope);
        }
        for (setting, value) in known.iter().zip(given) {
            let value = match (value, setting.if_absent) {
                (Some(value), _) => self.setting(setting, value),
                (None, IfAbsent::Number(number)) => Some(Expr::Number(number)),
                (None, _) => None,
            };
            self.arguments.settings.push(value);
        }
    }

    fn setting(&mut self, setting: &Setting, value: &ast::Expr) -> Option<Expr> {
        let what = format!("`{}` of {}", setting.word, self.subject);
        let resolved = self.context.scalar(value, &self.purpose, &what, dimension(setting.unit));
        let number = resolved.as_ref().and_then(literal);
        if let Some(number) = number.filter(|number| setting.positive && *number <= 0.0) {
            self.context.diag.error(rules::not_positive(value.extent(), &what, number, setting.unit));
        }
        resolved
    }
}

/// The dimension of a unit of the table of keywords.
fn dimension(unit: &str) -> Option<Dimension> {
    Some(Unit::of_text(unit).map_or(Dimension::NONE, |unit| unit.dimension))
}
