//! Expressions: each name becomes an id, vectors become components.

use super::constant::literal;
use super::context::{Context, Motion, Purpose, motion};
use super::dimension::{Dimension, Measure};
use super::names::Symbol;
use super::unit::Unit;
use super::value::{Form, Value};
use super::{Direction, Expr, InputId};
use crate::diag::{names, repeats, rules, values};
use crate::function::Operator;
use crate::parse::ast;
use proc_macro2::{Ident, Span};

impl Context<'_> {
    /// The value of an expression; `None` when faults were reported. Numbers that overflow or are undefined are faults
    /// of the smallest expression that makes them.
    pub fn value(&mut self, expr: &ast::Expr, purpose: &Purpose) -> Option<Value> {
        let value = self.unchecked_value(expr, purpose)?;
        let components = match &value.form {
            Form::Scalar(x) => [literal(x), None],
            Form::Vector(x, y) => [literal(x), literal(y)],
        };
        match components.into_iter().flatten().find(|x| !x.is_finite()) {
            Some(number) => self.diag.refuse(values::constant_not_finite(expr.extent(), "this expression", number)),
            None => Some(value),
        }
    }

    fn unchecked_value(&mut self, expr: &ast::Expr, purpose: &Purpose) -> Option<Value> {
        match expr {
            ast::Expr::Number { value, .. } => Some(Value::scalar(Expr::Number(*value), Measure::Unknown)),
            ast::Expr::Quantity { value, unit, .. } => self.quantity(*value, unit, purpose),
            ast::Expr::Name(name) => self.name(name, purpose),
            ast::Expr::Indexed(name) => {
                self.indexed_value(name, purpose.scope);
                None
            }
            ast::Expr::Member { owner, member } => self.member(owner, member, purpose),
            ast::Expr::Call { function, arguments, end } => self.call(function, arguments, *end, purpose),
            ast::Expr::Vector { x, y, .. } => self.vector(x, y, purpose),
            ast::Expr::Negative { operand, .. } => self.value(operand, purpose).map(Value::negative),
            ast::Expr::Binary { operator, span, left, right } => {
                let (left, right) = (self.value(left, purpose), self.value(right, purpose));
                let by_zero = |value: &Value| matches!(&value.form, Form::Scalar(x) if literal(x) == Some(0.0));
                if *operator == Operator::Divide && right.as_ref().is_some_and(by_zero) {
                    return self.diag.refuse(values::division_by_zero(*span));
                }
                let result = left?.binary(*operator, *span, right?);
                self.diag.keep(result)
            }
        }
    }

    /// A number of a unit, in SI units.
    fn quantity(&mut self, value: f64, unit: &ast::Unit, purpose: &Purpose) -> Option<Value> {
        // behind `*` and `/` a name may be meant as a value, unless brackets say that it is none
        let behind_signs = if unit.text.starts_with('(') { &[] } else { unit.factors.get(1..).unwrap_or_default() };
        for ast::UnitFactor { name, .. } in behind_signs {
            if self.names.lookup(purpose.scope, name).is_some() {
                return self.diag.refuse(values::unit_or_value(name, &unit.text));
            }
        }
        let unit = Unit::resolve(unit, self.diag)?;
        Some(Value::scalar(unit.expr_of_number(value), unit.dimension))
    }

    /// A scalar of this dimension; `what` it is, for the message.
    pub fn scalar(
        &mut self,
        expr: &ast::Expr,
        purpose: &Purpose,
        what: &str,
        dimension: Option<Dimension>,
    ) -> Option<Expr> {
        let (value, found) = self.scalar_of_any_dimension(expr, purpose, what)?;
        self.check_dimension(expr, what, found, dimension)?;
        Some(value)
    }

    /// A scalar and what is known of its dimension.
    pub fn scalar_of_any_dimension(
        &mut self,
        expr: &ast::Expr,
        purpose: &Purpose,
        what: &str,
    ) -> Option<(Expr, Measure)> {
        let value = self.value(expr, purpose)?;
        let measure = value.measure;
        Some((self.as_scalar(value, expr, what)?, measure))
    }

    /// The components of a vector of this dimension.
    pub fn components(
        &mut self,
        expr: &ast::Expr,
        purpose: &Purpose,
        what: &str,
        dimension: Option<Dimension>,
    ) -> Option<(Expr, Expr)> {
        let value = self.value(expr, purpose)?;
        let Form::Vector(x, y) = value.form else {
            return self.diag.refuse(values::expected_vector(expr.extent(), what));
        };
        self.check_dimension(expr, what, value.measure, dimension)?;
        Some((x, y))
    }

    /// The left side minus the right side, both scalars of one dimension; `what` a side is, for the message.
    pub fn difference(
        &mut self,
        sides: [&ast::Expr; 2],
        (sign, at): (&str, Span),
        purpose: &Purpose,
        what: &str,
    ) -> Option<(Expr, Measure)> {
        let [left, right] = sides.map(|side| self.value(side, purpose));
        let (left, right) = (left?, right?);
        if let Some((a, b)) = left.measure.known().zip(right.measure.known()).filter(|(a, b)| a != b) {
            return self.diag.refuse(values::unlike_sides(at, sign, &a.in_words(), &b.in_words()));
        }
        let measure = left.measure.or(right.measure);
        let (a, b) = (self.as_scalar(left, sides[0], what)?, self.as_scalar(right, sides[1], what)?);
        Some((a - b, measure))
    }

    fn as_scalar(&mut self, value: Value, expr: &ast::Expr, what: &str) -> Option<Expr> {
        let Form::Scalar(scalar) = value.form else {
            return self.diag.refuse(values::expected_scalar(expr.extent(), what));
        };
        Some(scalar)
    }

    /// Reports a value of another dimension than is wanted, when both are known.
    pub fn check_dimension(
        &mut self,
        expr: &ast::Expr,
        what: &str,
        found: Measure,
        wanted: Option<Dimension>,
    ) -> Option<()> {
        match found.known().zip(wanted) {
            Some((found, wanted)) if found != wanted => {
                self.diag.refuse(values::wrong_dimension(expr.extent(), what, &found.in_words(), &wanted.in_words()))
            }
            _ => Some(()),
        }
    }

    fn vector(&mut self, x: &ast::Expr, y: &ast::Expr, purpose: &Purpose) -> Option<Value> {
        let what = "a component of a vector";
        let first = self.scalar_of_any_dimension(x, purpose, what);
        let second = self.scalar_of_any_dimension(y, purpose, what);
        let ((first, measure), (second, found)) = (first?, second?);
        self.check_dimension(y, what, found, measure.known())?;
        Some(Value::vector(first, second, measure.or(found)))
    }

    fn name(&mut self, name: &Ident, purpose: &Purpose) -> Option<Value> {
        if name == "pi" {
            return Some(Value::scalar(Expr::Pi, Measure::Unknown));
        }
        if name == "t" {
            self.forbid_motion(name, Motion::Time, purpose)?;
            return Some(Value::scalar(Expr::Time, Dimension::TIME));
        }
        if let Some(index) = self.index_value(name) {
            return Some(Value::scalar(self.number_of(&index), Measure::Unknown));
        }
        match self.names.lookup(purpose.scope, name) {
            Some(Symbol::Count(id)) => Some(Value::scalar(Expr::Count(id), Measure::Unknown)),
            Some(Symbol::Parameter(id)) => {
                let unit = self.units.get(id.0).copied().flatten();
                let measure = unit.map_or(Measure::Unknown, |unit| unit.dimension.into());
                Some(Value::scalar(Expr::Parameter(id), measure))
            }
            Some(Symbol::Input(id)) => {
                let part = self.input_parts.get(id.0).copied().flatten();
                let (expr, moves) = match part {
                    Some(part @ (ast::Part::Value | ast::Part::Rate)) => {
                        let expr = Expr::Integrated(InputId(id.0 - part as usize), part);
                        let moves = motion(&expr);
                        (expr, moves)
                    }
                    _ => (Expr::Input(id), Motion::Input),
                };
                self.forbid_motion(name, moves, purpose)?;
                Some(self.of_unit(id, expr))
            }
            Some(Symbol::State(id)) => {
                self.forbid_motion(name, Motion::State, purpose)?;
                Some(self.of_unit(id, Expr::State(id)))
            }
            Some(Symbol::Let(id)) => {
                let value = self.let_value(id, name)?;
                let moves = match &value.form {
                    Form::Scalar(value) => motion(value),
                    Form::Vector(x, y) => motion(x).max(motion(y)),
                };
                self.forbid_motion(name, moves, purpose)?;
                Some(value)
            }
            Some(Symbol::Broken) => None,
            Some(symbol) => {
                let members = Self::members(symbol);
                self.diag.refuse(names::not_a_value(name, symbol.what(), members))
            }
            None if name == "ground" => self.diag.refuse(names::not_a_value(name, "the fixed ground", &[])),
            None => {
                let error = self.names.unknown(name, |known| {
                    let values = known.values(purpose.scope);
                    match self.alike.filter(|_| !names::is_similar(name, &values)) {
                        Some(array) => repeats::no_index(name, &self.with_index(array, name)),
                        None => names::unknown(name, names::VALUE, &values),
                    }
                });
                self.diag.refuse(error)
            }
        }
    }

    /// An input or a state, in its declared unit, as a value in SI units.
    fn of_unit(&self, id: InputId, expr: Expr) -> Value {
        match self.input_units.get(id.0).copied().flatten() {
            Some(unit) => Value::scalar(unit.expr_to_si(expr), unit.dimension),
            None => Value::scalar(expr, Measure::Unknown),
        }
    }

    /// Reports the use of something that moves more than the purpose allows.
    pub fn forbid_motion(
        &mut self,
        at: impl Into<crate::diag::Extent>,
        motion: Motion,
        purpose: &Purpose,
    ) -> Option<()> {
        match &purpose.limit {
            Some((what, limit)) if motion > *limit => {
                let remedy = if purpose.is_stop { remedy_in_stop(motion) } else { remedy(motion, *limit) };
                self.diag.refuse(values::must_not_move(at, what, motion.text(), remedy))
            }
            _ => Some(()),
        }
    }

    /// A direction of a body that is not known to have no length.
    pub fn direction(&mut self, direction: &ast::OnBody, scope: super::names::Scope) -> Option<Direction> {
        let purpose = Purpose::fixed(scope, "a direction".into());
        let body = self.body_or_ground(&direction.body);
        let x = self.scalar(&direction.x, &purpose, "a component of a direction", None);
        let y = self.scalar(&direction.y, &purpose, "a component of a direction", None);
        let (body, x, y) = (body?, x?, y?);
        let zero = |component: &Expr| literal(component) == Some(0.0);
        if zero(&x) && zero(&y) {
            let last = direction.y.extent().last;
            let at = crate::diag::Extent { first: direction.x.extent().first, last };
            return self.diag.refuse(rules::direction_without_length(at, &direction.body));
        }
        Some(Direction { body, x, y })
    }
}

/// What to write in place of something that moves more than `limit`.
const fn remedy(motion: Motion, limit: Motion) -> &'static str {
    match (motion, limit) {
        (_, Motion::Parameters) => "write an expression of numbers, `pi` and parameters",
        (Motion::Input, _) => {
            "a constraint needs its rate: declare it `by acceleration`, as `input angle: rad = 0 by acceleration;`"
        }
        (Motion::State, _) => {
            "a constraint is differentiated to accelerations, and a state is not: write a force that depends on it, \
             such as `torque wheel: k*current;`"
        }
        _ => "a position constraint knows positions and `t`; write `velocity constraint` for a velocity constraint",
    }
}

/// What to write in place of something that a stop cannot follow.
const fn remedy_in_stop(motion: Motion) -> &'static str {
    match motion {
        Motion::Input => {
            "the constraint of a stop needs its rate: declare it `by acceleration`, as `input height: m = 0 by acceleration;`"
        }
        Motion::State => "a stop bounds positions; an `event` tells when a state passes a value",
        _ => "a stop bounds positions; an `event` tells when a velocity passes a value",
    }
}
