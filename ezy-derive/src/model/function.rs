//! Calls: the functions of the language, their arguments and dimensions.

use super::context::{Context, Purpose};
use super::dimension::{Dimension, Measure};
use super::names::Symbol;
use super::value::{Form, Value};
use super::{Component, Expr, Function, Operator};
use crate::diag::{Extent, names, values};
use crate::parse::ast;
use proc_macro2::{Ident, Span};

/// Functions of scalars.
const SCALAR: [(Function, Rule); 14] = [
    (Function::Sin, Rule::Plain),
    (Function::Cos, Rule::Plain),
    (Function::Tan, Rule::Plain),
    (Function::Asin, Rule::Arc),
    (Function::Acos, Rule::Arc),
    (Function::Atan2, Rule::ArcOfRatio),
    (Function::Sqrt, Rule::Root),
    (Function::Exp, Rule::Plain),
    (Function::Ln, Rule::Plain),
    (Function::Tanh, Rule::Plain),
    (Function::Abs, Rule::Same),
    (Function::Min, Rule::Same),
    (Function::Max, Rule::Same),
    (Function::Sign, Rule::Sign),
];

type Call = fn(&mut Context<'_>, &[ast::Expr], &Purpose) -> Option<Value>;

/// Functions that are written out, with the number of their arguments.
const WRITTEN_OUT: [(&str, usize, Call); 5] = [
    ("dot", 2, |context, arguments, purpose| context.product("dot", Value::dot, arguments, purpose)),
    ("cross", 2, |context, arguments, purpose| context.product("cross", Value::cross, arguments, purpose)),
    ("norm", 1, |context, arguments, purpose| context.norm(arguments, purpose)),
    ("slip_angle", 2, |context, arguments, purpose| context.slip_angle(arguments, purpose)),
    ("smooth_step", 3, |context, arguments, purpose| context.smooth_step(arguments, purpose)),
];

/// What a function asks of dimensions, and what it gives.
#[derive(Debug, Clone, Copy)]
enum Rule {
    /// A plain number or an angle; a plain number.
    Plain,
    /// A plain number; an angle.
    Arc,
    /// Like arguments; an angle.
    ArcOfRatio,
    /// Anything; a plain number.
    Sign,
    /// Like arguments; the same dimension.
    Same,
    /// The square root of the dimension.
    Root,
}

impl Context<'_> {
    pub fn call(&mut self, function: &Ident, arguments: &[ast::Expr], end: Span, purpose: &Purpose) -> Option<Value> {
        if self.names.lookup(purpose.scope, function) == Some(Symbol::Broken) {
            return None;
        }
        let scalar = SCALAR.iter().find(|(known, _)| function == known.name());
        let written_out = WRITTEN_OUT.iter().find(|(known, ..)| function == known);
        let arity = scalar.map(|(known, _)| known.arity()).or(written_out.map(|(_, arity, _)| *arity));
        if let Some(arity) = arity.filter(|arity| *arity != arguments.len()) {
            return self.diag.refuse(values::arity(function, arity, arguments.len()));
        }
        match (scalar, written_out) {
            (Some((function, rule)), _) => self.scalar_call(*function, *rule, arguments, purpose),
            (_, Some((.., call))) => call(self, arguments, purpose),
            _ => {
                let error = self.not_a_function(function, Extent { first: function.span(), last: end }, purpose);
                self.diag.refuse(error)
            }
        }
    }

    fn not_a_function(&self, function: &Ident, call: Extent, purpose: &Purpose) -> syn::Error {
        let symbol = self.names.lookup(purpose.scope, function);
        if function == "ground" || matches!(symbol, Some(Symbol::Body(_))) {
            return values::place_as_value(call, function);
        }
        match symbol {
            Some(symbol @ (Symbol::Parameter(_) | Symbol::Input(_) | Symbol::State(_) | Symbol::Let(_))) => {
                values::called_value(function, symbol.what())
            }
            _ => names::unknown_function(function),
        }
    }

    fn scalar_call(
        &mut self,
        function: Function,
        rule: Rule,
        arguments: &[ast::Expr],
        purpose: &Purpose,
    ) -> Option<Value> {
        let is_of_angle = matches!(function, Function::Sin | Function::Cos | Function::Tan);
        let wanted = |found, before: Measure| match rule {
            // `sin(t)` is understood: 1 rad/s
            Rule::Plain if found == Measure::Known(Dimension::TIME) => None,
            Rule::Plain if is_of_angle => Some(Dimension::ANGLE),
            Rule::Plain | Rule::Arc => Some(Dimension::NONE),
            _ => before.known(),
        };
        let (resolved, measure) = self.scalars(function.name(), arguments, purpose, wanted)?;
        let measure = match rule {
            Rule::Plain | Rule::Sign => Measure::Plain,
            Rule::Arc | Rule::ArcOfRatio => Dimension::ANGLE.into(),
            Rule::Same => measure,
            Rule::Root => measure.power(Some(0.5)),
        };
        Some(Value::scalar(Expr::Call(function, resolved), measure))
    }

    /// Scalar arguments and what is known of their dimension. `wanted`: of what was found, and of the arguments before.
    fn scalars(
        &mut self,
        name: &str,
        arguments: &[ast::Expr],
        purpose: &Purpose,
        wanted: impl Fn(Measure, Measure) -> Option<Dimension>,
    ) -> Option<(Vec<Expr>, Measure)> {
        let what = format!("an argument of `{name}`");
        let (mut resolved, mut measure) = (Vec::new(), Measure::Unknown);
        for argument in arguments {
            let Some((value, found)) = self.scalar_of_any_dimension(argument, purpose, &what) else { continue };
            if self.check_dimension(argument, &what, found, wanted(found, measure)).is_some() {
                resolved.push(value);
            }
            measure = measure.or(found);
        }
        (resolved.len() == arguments.len()).then_some((resolved, measure))
    }

    /// Vector arguments.
    fn vectors<const N: usize>(
        &mut self,
        name: &str,
        arguments: &[ast::Expr],
        purpose: &Purpose,
    ) -> Option<[(Expr, Expr, Measure); N]> {
        let mut resolved = Vec::new();
        for argument in arguments {
            let Some(value) = self.value(argument, purpose) else { continue };
            match value.form {
                Form::Vector(x, y) => resolved.push((x, y, value.measure)),
                Form::Scalar(_) => {
                    let what = format!("an argument of `{name}`");
                    self.diag.error(values::expected_vector(argument.extent(), &what));
                }
            }
        }
        resolved.try_into().ok()
    }

    fn product(
        &mut self,
        name: &str,
        product: fn(Expr, Expr, Expr, Expr) -> Expr,
        arguments: &[ast::Expr],
        purpose: &Purpose,
    ) -> Option<Value> {
        let [(ax, ay, a), (bx, by, b)] = self.vectors(name, arguments, purpose)?;
        Some(Value::scalar(product(ax, ay, bx, by), a.times(b)))
    }

    fn norm(&mut self, arguments: &[ast::Expr], purpose: &Purpose) -> Option<Value> {
        let [(x, y, measure)] = self.vectors("norm", arguments, purpose)?;
        let square = Value::dot(x.clone(), y.clone(), x, y);
        Some(Value::scalar(Expr::Call(Function::Sqrt, vec![square]), measure))
    }

    /// `slip_angle(P, body)`: from the x axis of the body, whichever way it rolls, to the velocity of P:
    /// atan2(v · n, |v · e|).
    fn slip_angle(&mut self, arguments: &[ast::Expr], purpose: &Purpose) -> Option<Value> {
        let names = arguments.iter().map(ast::Expr::as_name).collect::<Option<Vec<_>>>();
        let Some([point, body]) = names.as_deref() else {
            let other = arguments.iter().find(|argument| argument.as_name().is_none())?;
            return self.diag.refuse(values::expected_name(other.extent(), "slip_angle", "slip_angle(A, seat)"));
        };
        let velocity = self.member(point, &Ident::new("v", point.span()), purpose);
        let (velocity, body) = (velocity?, self.body(body, false)?);
        let Form::Vector(vx, vy) = velocity.form else { return None };
        let angle = |function| Expr::Call(function, vec![Expr::Coordinate(body, Component::Phi)]);
        let (ex, ey) = (angle(Function::Cos), angle(Function::Sin));
        let forward = Value::dot(ex.clone(), ey.clone(), vx.clone(), vy.clone());
        let sideward = Value::cross(ex, ey, vx, vy);
        let forward = Expr::Call(Function::Abs, vec![forward]);
        Some(Value::scalar(Expr::Call(Function::Atan2, vec![sideward, forward]), Dimension::ANGLE))
    }

    /// `smooth_step(x, from, to)`: 0 before, 1 behind, s³ (10 − 15 s + 6 s²) between, with two continuous derivatives.
    fn smooth_step(&mut self, arguments: &[ast::Expr], purpose: &Purpose) -> Option<Value> {
        let (resolved, _) = self.scalars("smooth_step", arguments, purpose, |_, before| before.known())?;
        let [x, from, to] = <[Expr; 3]>::try_from(resolved).ok()?;
        let ratio = (x - from.clone()) / (to - from);
        let above = Expr::Call(Function::Max, vec![ratio, Expr::Number(0.0)]);
        let s = Expr::Call(Function::Min, vec![above, Expr::Number(1.0)]);
        let cube = Expr::binary(Operator::Power, s.clone(), Expr::Number(3.0));
        let inner = Expr::Number(6.0) * s.clone() - Expr::Number(15.0);
        Some(Value::scalar(cube * (s * inner + Expr::Number(10.0)), Measure::Plain))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_functions_are_those_of_the_parser() {
        let scalar = SCALAR.iter().map(|(known, _)| known.name());
        let all: Vec<&str> = scalar.chain(WRITTEN_OUT.iter().map(|(name, ..)| *name)).collect();
        assert_eq!(all, crate::function::FUNCTIONS);
    }
}
