//! Expressions of the model file as sums.

use proc_macro2::Ident;

use super::symbols::Symbols;
use crate::function::{Function, Operator};
use crate::model::{self, Arguments, BodyId, Component, Expr, InputId, Model, Part, Switch};
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::{Algebra, SumId, Symbol};

/// Writes expressions of one model.
pub struct Writer<'a> {
    pub model: &'a Model,
    pub algebra: &'a mut Algebra,
    pub symbols: &'a Symbols,
    /// Whether the velocities have been created in the algebra.
    pub(super) knows_velocities: bool,
    /// Shares of the largest force that smoothed laws have, from -1 to 1.
    pub(super) layers: Vec<SumId>,
}

impl<'a> Writer<'a> {
    pub fn new(model: &'a Model, algebra: &'a mut Algebra, symbols: &'a Symbols) -> Self {
        Self { model, algebra, symbols, knows_velocities: false, layers: Vec::new() }
    }

    pub fn write(&mut self, expression: &Expr) -> SumId {
        match expression {
            Expr::Number(x) => self.algebra.number(*x),
            Expr::Pi => {
                let pi = self.algebra.coefficients.pi();
                self.algebra.constant(pi)
            }
            Expr::Conversion(unit) => {
                let conversion = self.algebra.coefficients.conversion(unit.times, unit.over, unit.pi);
                self.algebra.constant(conversion)
            }
            Expr::Time => self.algebra.symbol(Symbol::TIME),
            Expr::Parameter(id) => {
                let parameter = self.algebra.coefficients.parameter(id.0);
                self.algebra.constant(parameter)
            }
            Expr::Input(id) | Expr::State(id) => {
                self.symbols.input(*id).map_or(SumId::ZERO, |symbol| self.algebra.symbol(symbol))
            }
            Expr::Integrated(first, part) => self.integrated(*first, *part),
            Expr::Coordinate(body, component) => {
                let symbol = self.symbols.coordinate(*body, *component);
                self.algebra.symbol(symbol)
            }
            Expr::Velocity(body, component) => {
                let symbol = self.symbols.velocity(*body, *component);
                self.algebra.symbol(symbol)
            }
            Expr::PointPosition(point, component) => {
                let place = self.model.points[point.0].place.clone();
                self.position(&place)[*component as usize]
            }
            Expr::PointVelocity(point, component) => {
                let place = self.model.points[point.0].place.clone();
                self.velocity(&place)[*component as usize]
            }
            Expr::MemberPosition(place, component) => self.position(place)[*component as usize],
            Expr::MemberVelocity(place, component) => self.velocity(place)[*component as usize],
            Expr::Count(id) => self.whole(id.0),
            Expr::Index(id) => self.whole(self.model.counts.len() + id.0),
            Expr::Quotient(id) => self.whole(self.model.counts.len() + self.model.indices.len() + id.0),
            Expr::HingeAngle(row) => self.hinge_difference(*row, false),
            Expr::HingeRate(row) => self.hinge_difference(*row, true),
            Expr::Neg(a) => {
                let a = self.write(a);
                self.algebra.neg(a)
            }
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.write(a), self.write(b));
                self.binary(*operator, a, b)
            }
            Expr::Call(function, arguments) => {
                let arguments = arguments.iter().map(|x| self.write(x)).collect();
                self.algebra.call(*function, arguments)
            }
        }
    }

    /// The value s + ṡ τ + s̈ τ²/2 of an input by acceleration, or its rate ṡ + s̈ τ, with τ = t − since.
    fn integrated(&mut self, first: InputId, part: Part) -> SumId {
        let [value, rate, acceleration, since] =
            std::array::from_fn(|i| self.write(&Expr::Input(InputId(first.0 + i))));
        let time = self.algebra.symbol(Symbol::TIME);
        let elapsed = self.algebra.sub(time, since);
        let gained = self.algebra.mul(acceleration, elapsed);
        if part == Part::Rate {
            return self.algebra.add(rate, gained);
        }
        let half = self.algebra.number(0.5);
        let mean = self.algebra.mul(half, gained);
        let mean = self.algebra.add(rate, mean);
        let way = self.algebra.mul(mean, elapsed);
        self.algebra.add(value, way)
    }

    /// By its place in [`Model::whole`], behind the parameters.
    fn whole(&mut self, place: usize) -> SumId {
        let whole = self.algebra.coefficients.parameter(self.model.parameters.len() + place);
        self.algebra.constant(whole)
    }

    /// A number that the run sets for a row.
    pub fn switch(&mut self, of: &Ident, switch: Switch) -> Option<Coefficient> {
        self.symbols.switch(of, switch).map(|place| self.algebra.coefficients.parameter(place))
    }

    /// A value that `model` has checked to depend on parameters alone.
    pub fn coefficient(&mut self, expression: &Expr) -> Coefficient {
        let sum = self.write(expression);
        self.algebra.as_coefficient(sum).unwrap_or(Coefficient::ZERO)
    }

    fn binary(&mut self, operator: Operator, a: SumId, b: SumId) -> SumId {
        match operator {
            Operator::Add => self.algebra.add(a, b),
            Operator::Subtract => self.algebra.sub(a, b),
            Operator::Multiply => self.algebra.mul(a, b),
            Operator::Divide => self.algebra.div(a, b),
            Operator::Power => self.algebra.pow(a, b),
        }
    }

    /// A setting of a row or force; zero where the law has no such part.
    pub fn setting(&mut self, of: &Arguments, i: usize) -> SumId {
        of.settings[i].as_ref().map_or(SumId::ZERO, |value| self.write(value))
    }

    /// Whether a value depends on parameters alone.
    pub fn is_steady(&self, value: SumId) -> bool {
        self.algebra.as_coefficient(value).is_some()
    }

    /// A divisor that is not negative, kept from zero: 0/0 becomes 0.
    pub fn at_least_something(&mut self, divisor: SumId) -> SumId {
        let least = self.algebra.number(f64::MIN_POSITIVE);
        self.algebra.call(Function::Max, vec![divisor, least])
    }

    /// φ of a body; the ground does not turn.
    pub fn angle(&mut self, body: Option<BodyId>) -> SumId {
        body.map_or(SumId::ZERO, |body| {
            let symbol = self.symbols.coordinate(body, Component::Phi);
            self.algebra.symbol(symbol)
        })
    }

    /// φ_b − φ_a − offset.
    pub fn turned_by(&mut self, a: Option<BodyId>, b: Option<BodyId>, offset: Option<&Expr>) -> SumId {
        let (a, b) = (self.angle(a), self.angle(b));
        let turned = self.algebra.sub(b, a);
        let Some(offset) = offset else { return turned };
        let offset = self.write(offset);
        self.algebra.sub(turned, offset)
    }

    /// φ_b − φ_a of a hinge, or its rate.
    fn hinge_difference(&mut self, row: model::RowId, rate: bool) -> SumId {
        let places = &self.model.rows[row.0].arguments.places;
        let (a, b) = (places[0].body, places[1].body);
        let angle = self.turned_by(a, b, None);
        if rate { self.time_derivative(angle) } else { angle }
    }
}
