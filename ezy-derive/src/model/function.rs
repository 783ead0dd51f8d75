//! Calls: the functions of the language, their arguments and dimensions.

use super::context::{Context, Purpose};
use super::dimension::{Dimension, Measure};
use super::names::Symbol;
use super::value::{Form, Value};
use super::{Component, Expr, Function};
use crate::diag::{Extent, names, values};
use crate::parse::ast;
use proc_macro2::{Ident, Span};

/// Functions of scalars.
const SCALAR: [(&str, Function, usize, Rule); 14] = [
    ("sin", Function::Sin, 1, Rule::Plain),
    ("cos", Function::Cos, 1, Rule::Plain),
    ("tan", Function::Tan, 1, Rule::Plain),
    ("asin", Function::Asin, 1, Rule::Arc),
    ("acos", Function::Acos, 1, Rule::Arc),
    ("atan2", Function::Atan2, 2, Rule::ArcOfRatio),
    ("sqrt", Function::Sqrt, 1, Rule::Root),
    ("exp", Function::Exp, 1, Rule::Plain),
    ("ln", Function::Ln, 1, Rule::Plain),
    ("tanh", Function::Tanh, 1, Rule::Plain),
    ("abs", Function::Abs, 1, Rule::Same),
    ("min", Function::Min, 2, Rule::Same),
    ("max", Function::Max, 2, Rule::Same),
    ("sign", Function::Sign, 1, Rule::Sign),
];

/// Functions of vectors, with the number of their arguments.
const VECTOR: [(&str, usize); 3] = [("dot", 2), ("cross", 2), ("norm", 1)];

/// Functions that are written out: `slip_angle(point, body)`, `smooth_step(x, from, to)`.
const WRITTEN_OUT: [(&str, usize); 2] = [("slip_angle", 2), ("smooth_step", 3)];

/// Functions of other languages, and what to write.
const ELSEWHERE: [(&str, &str); 26] = [
    ("atan", "atan2(y, x)"),
    ("arctan", "atan2(y, x)"),
    ("arctan2", "atan2(y, x)"),
    ("arcsin", "asin(x)"),
    ("arccos", "acos(x)"),
    ("cot", "1/tan(x)"),
    ("sinh", "(exp(x) - exp(-x))/2"),
    ("cosh", "(exp(x) + exp(-x))/2"),
    ("asinh", "ln(x + sqrt(x^2 + 1))"),
    ("acosh", "ln(x + sqrt(x^2 - 1))"),
    ("atanh", "ln((1 + x)/(1 - x))/2"),
    ("log", "ln(x)"),
    ("log2", "ln(x)/ln(2)"),
    ("log10", "ln(x)/ln(10)"),
    ("pow", "x^y"),
    ("sqr", "x^2"),
    ("square", "x^2"),
    ("cbrt", "x^(1/3)"),
    ("hypot", "norm((x, y))"),
    ("fabs", "abs(x)"),
    ("sgn", "sign(x)"),
    ("signum", "sign(x)"),
    ("step", "smooth_step(x, from, to)"),
    ("heaviside", "smooth_step(x, from, to)"),
    ("radians", "x*pi/180"),
    ("degrees", "x*180/pi"),
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
        let name = function.to_string();
        let scalar = SCALAR.iter().find(|(known, ..)| *known == name);
        let vector = VECTOR.iter().find(|(known, _)| *known == name);
        let written_out = WRITTEN_OUT.iter().find(|(known, _)| *known == name);
        if self.names.lookup(purpose.scope, function) == Some(Symbol::Broken) {
            return None;
        }
        let Some(arity) = scalar.map(|row| row.2).or(vector.or(written_out).map(|row| row.1)) else {
            let error = self.not_a_function(function, Extent { first: function.span(), last: end }, purpose);
            self.diag.error(error);
            return None;
        };
        if arguments.len() != arity {
            self.diag.error(values::arity(function, arity, arguments.len()));
            return None;
        }
        match scalar {
            Some((_, function, _, rule)) => self.scalar_call(&name, *function, *rule, arguments, purpose),
            None if name == "slip_angle" => self.slip_angle(arguments, purpose),
            None if name == "smooth_step" => self.smooth_step(arguments, purpose),
            None => self.vector_call(&name, arguments, purpose),
        }
    }

    fn not_a_function(&self, function: &Ident, call: Extent, purpose: &Purpose) -> syn::Error {
        let symbol = self.names.lookup(purpose.scope, function);
        if function == "ground" || matches!(symbol, Some(Symbol::Body(_))) {
            return values::place_as_value(call, function);
        }
        let others = VECTOR.iter().chain(&WRITTEN_OUT);
        let functions = SCALAR.iter().map(|row| row.0).chain(others.map(|row| row.0));
        let functions: Vec<&str> = functions.collect();
        match symbol {
            Some(symbol @ (Symbol::Parameter(_) | Symbol::Input(_) | Symbol::Let(_))) => {
                values::called_value(function, symbol.what())
            }
            _ => {
                let instead = ELSEWHERE.iter().find(|(other, _)| function == other).map(|(_, instead)| *instead);
                names::unknown_function(function, instead, &functions)
            }
        }
    }

    fn scalar_call(
        &mut self,
        name: &str,
        function: Function,
        rule: Rule,
        arguments: &[ast::Expr],
        purpose: &Purpose,
    ) -> Option<Value> {
        let what = format!("an argument of `{name}`");
        let mut measure = Measure::Unknown;
        let mut resolved = Vec::new();
        for argument in arguments {
            let Some((value, found)) = self.scalar_of_any_dimension(argument, purpose, &what) else { continue };
            let wanted = match rule {
                // `sin(t)` is understood: 1 rad/s
                Rule::Plain if found == Measure::Known(Dimension::TIME) => None,
                Rule::Plain if matches!(function, Function::Sin | Function::Cos | Function::Tan) => {
                    Some(Dimension::ANGLE)
                }
                Rule::Plain | Rule::Arc => Some(Dimension::NONE),
                _ => measure.known(),
            };
            if self.check_dimension(argument, &what, found, wanted).is_some() {
                resolved.push(value);
            }
            measure = measure.or(found);
        }
        let measure = match rule {
            Rule::Plain | Rule::Sign => Measure::Plain,
            Rule::Arc | Rule::ArcOfRatio => Dimension::ANGLE.into(),
            Rule::Same => measure,
            Rule::Root => measure.power(Some(0.5)),
        };
        (resolved.len() == arguments.len()).then(|| Value::scalar(Expr::Call(function, resolved), measure))
    }

    fn vector_call(&mut self, name: &str, arguments: &[ast::Expr], purpose: &Purpose) -> Option<Value> {
        let what = format!("an argument of `{name}`");
        let mut resolved = Vec::new();
        for argument in arguments {
            let Some(value) = self.value(argument, purpose) else { continue };
            match value.form {
                Form::Vector(x, y) => resolved.push((x, y, value.measure)),
                Form::Scalar(_) => self.diag.error(values::expected_vector(argument.extent(), &what)),
            }
        }
        if resolved.len() != arguments.len() {
            return None;
        }
        let (ax, ay, a) = resolved.first()?.clone();
        let Some((bx, by, b)) = resolved.get(1).cloned() else {
            let square = Value::dot(ax.clone(), ay.clone(), ax, ay);
            return Some(Value::scalar(Expr::Call(Function::Sqrt, vec![square]), a));
        };
        let value = if name == "dot" { Value::dot(ax, ay, bx, by) } else { Value::cross(ax, ay, bx, by) };
        Some(Value::scalar(value, a.times(b)))
    }

    /// `slip_angle(P, body)`: from the x axis of the body, whichever way it rolls, to the velocity of P:
    /// atan2(v · n, |v · e|).
    fn slip_angle(&mut self, arguments: &[ast::Expr], purpose: &Purpose) -> Option<Value> {
        let names = arguments.iter().map(ast::Expr::as_name).collect::<Option<Vec<_>>>();
        let Some([point, body]) = names.as_deref() else {
            let other = arguments.iter().find(|argument| argument.as_name().is_none())?;
            self.diag.error(values::expected_name(other.extent(), "slip_angle", "slip_angle(A, seat)"));
            return None;
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
        let what = "an argument of `smooth_step`";
        let mut resolved = Vec::new();
        let mut measure = Measure::Unknown;
        for argument in arguments {
            let Some((value, found)) = self.scalar_of_any_dimension(argument, purpose, what) else { continue };
            if self.check_dimension(argument, what, found, measure.known()).is_some() {
                resolved.push(value);
            }
            measure = measure.or(found);
        }
        let [x, from, to] = <[Expr; 3]>::try_from(resolved).ok()?;
        let number = |x| Box::new(Expr::Number(x));
        let sub = |a: Expr, b: Expr| Expr::Sub(Box::new(a), Box::new(b));
        let ratio = Expr::Div(Box::new(sub(x, from.clone())), Box::new(sub(to, from)));
        let above = Expr::Call(Function::Max, vec![ratio, Expr::Number(0.0)]);
        let s = Expr::Call(Function::Min, vec![above, Expr::Number(1.0)]);
        let cube = Expr::Pow(Box::new(s.clone()), number(3.0));
        let inner = sub(Expr::Mul(number(6.0), Box::new(s.clone())), Expr::Number(15.0));
        let bracket = Expr::Add(Box::new(Expr::Mul(Box::new(s), Box::new(inner))), number(10.0));
        Some(Value::scalar(Expr::Mul(Box::new(cube), Box::new(bracket)), Measure::Plain))
    }
}
