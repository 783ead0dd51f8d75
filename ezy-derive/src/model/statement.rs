//! Rows and forces: what is written for each part of their form.

use super::constant::at_defaults;
use super::context::{Context, Motion, Purpose};
use super::dimension::Dimension;
use super::names::{Scope, Symbol};
use super::unit::Unit;
use super::value::Form;
use super::{Arguments, Expr, Force, Row, RowId};
use crate::diag::{rules, values};
use crate::grammar::{Class, IfAbsent};
use crate::parse::ast::{self, Phrase, Statement};
use proc_macro2::Ident;

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
        let arguments = self.arguments(statement, Some(name), effect, Some(id));
        self.leave();
        Some(Row { name: name.clone(), word: statement.word, effect, loops: loops_of_row, arguments: arguments? })
    }

    /// A force; of a gravity that acts on arrays, one for each of them.
    pub fn force(&mut self, statement: &Statement, loops: &[ast::Loop], effect: Scope) -> Vec<Force> {
        let loops = self.enter(loops);
        let arguments = self.arguments(statement, None, effect, None);
        let word = statement.word;
        let forces = match arguments {
            None => Vec::new(),
            Some(arguments) if word.acts_on_all_bodies() && self.is_repeated() => {
                let on = |(body, loops)| {
                    let arguments = Arguments {
                        bodies: vec![Some(body)],
                        vector: arguments.vector.clone(),
                        ..Arguments::default()
                    };
                    Force { word, effect, loops, arguments }
                };
                self.all_bodies().into_iter().map(on).collect()
            }
            Some(arguments) => vec![Force { word, effect, loops, arguments }],
        };
        self.leave();
        forces
    }

    fn arguments(
        &mut self,
        statement: &Statement,
        name: Option<&Ident>,
        scope: Scope,
        row: Option<RowId>,
    ) -> Option<Arguments> {
        let word = statement.word;
        let subject = match name {
            Some(name) => format!("{} `{name}`", word.word),
            None => format!("this {}", word.word),
        };
        let purpose = match word.class {
            Class::PositionRow => Purpose::up_to(scope, subject.clone(), Motion::Position),
            Class::VelocityRow => Purpose::up_to(scope, subject.clone(), Motion::Velocity),
            Class::Force => Purpose::moving(scope),
        };
        let n_errors = self.diag.n_errors();
        let mut arguments = Arguments::default();
        for phrase in &statement.phrases {
            self.phrase(phrase, &subject, &purpose, statement, row, &mut arguments);
        }
        (self.diag.n_errors() == n_errors).then_some(arguments)
    }

    /// Adds what a phrase gives; what is missing after a fault is never looked at.
    fn phrase(
        &mut self,
        phrase: &Phrase,
        subject: &str,
        purpose: &Purpose,
        statement: &Statement,
        row: Option<RowId>,
        arguments: &mut Arguments,
    ) {
        let scope = purpose.scope;
        match phrase {
            Phrase::Pair(pair) => {
                let [a, b] = &**pair;
                let first = match statement.name.as_ref().and_then(|name| self.names.lookup(scope, name)) {
                    // the hinge's own point: its faults are told once
                    Some(Symbol::Hinge(id, point)) if Some(id) == row => self.point_place(point, a.owner()),
                    Some(Symbol::Hinges(id, point)) if Some(id) == row => self.declared_member(point),
                    _ => self.place(a, scope),
                };
                let second = self.place(b, scope);
                if let (Some(first), Some(second)) = (&first, &second)
                    && first.body == second.body
                {
                    self.diag.error(rules::within_body(b.owner(), subject, first.body.is_none()));
                }
                arguments.places.extend([first, second].into_iter().flatten());
            }
            Phrase::At(at) => {
                let place = self.place(at, scope);
                if place.as_ref().is_some_and(|place| place.body.is_none()) {
                    self.diag.error(rules::on_ground(at.owner(), subject));
                }
                arguments.places.extend(place);
            }
            Phrase::Couple(a, b) => {
                let single = a.indices.is_empty() && b.indices.is_empty();
                if single && a.word == b.word {
                    self.diag.error(rules::couple_of_one(b, subject));
                    return;
                }
                let bodies = [self.body_or_ground(a), self.body_or_ground(b)];
                if !single && bodies[0].is_some() && bodies[0] == bodies[1] {
                    self.diag.error(rules::couple_of_one(b, subject));
                }
                arguments.bodies.extend(bodies.into_iter().flatten());
            }
            Phrase::Body(body) => arguments.bodies.extend(self.body(body, false).map(Some)),
            Phrase::Direction { across, direction } => {
                arguments.across = *across;
                arguments.directions.extend(self.direction(direction, scope));
            }
            Phrase::Scalar(asked, value) => {
                arguments.scalars.extend(self.scalar(value, purpose, asked.what, Some(dimension(asked.unit))));
            }
            Phrase::Vector(asked, value) => {
                arguments.vector = self.components(value, purpose, asked.what, Some(dimension(asked.unit)));
            }
            Phrase::Equation { left, equals, right } => {
                let sides = (self.value(left, purpose), self.value(right, purpose));
                let (Some(a), Some(b)) = sides else { return };
                if let (Some(a), Some(b)) = (a.measure.known(), b.measure.known())
                    && a != b
                {
                    self.diag.error(values::unlike_sides(*equals, "=", &a.in_words(), &b.in_words()));
                    return;
                }
                let measure = a.measure.or(b.measure);
                arguments.multiplier_unit = measure.known().map_or_else(String::new, |dimension| {
                    // reaction times rate of the row is power
                    let velocity = statement.word.class == Class::VelocityRow;
                    let work = if velocity { Dimension::TORQUE.over(Dimension::TIME) } else { Dimension::TORQUE };
                    work.over(dimension).to_string()
                });
                match (a.form, b.form) {
                    (Form::Scalar(a), Form::Scalar(b)) => {
                        arguments.scalars.push(Expr::Sub(Box::new(a), Box::new(b)));
                    }
                    (Form::Vector(..), _) => self.diag.error(values::expected_scalar(left.extent(), subject)),
                    (_, Form::Vector(..)) => self.diag.error(values::expected_scalar(right.extent(), subject)),
                }
            }
            Phrase::Settings(known, given) => {
                // a limit of a row of velocities is a force
                let limit = Purpose::moving(scope);
                let purpose = if statement.word.class == Class::VelocityRow { &limit } else { purpose };
                for (setting, value) in known.iter().zip(given) {
                    let what = format!("`{}` of {subject}", setting.word);
                    arguments.settings.push(match (value, setting.if_absent) {
                        (Some(value), _) => {
                            let resolved = self.scalar(value, purpose, &what, Some(dimension(setting.unit)));
                            let number = resolved.as_ref().and_then(|value| at_defaults(value, &[]));
                            if let Some(number) = number.filter(|number| setting.positive && *number <= 0.0) {
                                self.diag.error(rules::not_positive(value.extent(), &what, number, setting.unit));
                            }
                            resolved
                        }
                        (None, IfAbsent::Number(number)) => Some(Expr::Number(number)),
                        (None, _) => None,
                    });
                }
            }
        }
    }
}

/// The dimension of a unit of the table of keywords.
fn dimension(unit: &str) -> Dimension {
    Unit::of_text(unit).map_or(Dimension::NONE, |unit| unit.dimension)
}
