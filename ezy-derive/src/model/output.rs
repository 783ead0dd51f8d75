//! Outputs: what is computed for whoever runs the scene.

use super::context::{Context, Purpose};
use super::names::Scope;
use super::unit::Unit;
use super::value::Form;
use super::{Expr, Output};
use crate::parse::ast;

impl Context<'_> {
    /// The scalar outputs of a declaration: one, or two of a vector.
    pub fn output(&mut self, output: &ast::Output, documentation: &str, effect: Scope) -> Vec<Output> {
        let unit = output.unit.as_ref().map(|unit| Unit::resolve(unit, self.diag));
        let what = format!("output `{}`", output.name);
        let Some(value) = self.value(&output.value, &Purpose::moving(effect)) else { return Vec::new() };
        let unit = match unit {
            Some(None) => return Vec::new(),
            Some(unit) => unit,
            None => None,
        };
        if self.check_dimension(&output.value, &what, value.measure, unit.map(|unit| unit.dimension)).is_none() {
            return Vec::new();
        }
        let scalar = |suffix: &str, value: Expr| Output {
            name: format!("{}{suffix}", output.name),
            unit: output.unit.as_ref().map_or_else(String::new, |unit| unit.text.clone()),
            documentation: documentation.to_owned(),
            effect,
            value: unit.map_or(value.clone(), |unit| unit.expr_from_si(value)),
        };
        match value.form {
            Form::Scalar(value) => vec![scalar("", value)],
            Form::Vector(x, y) => vec![scalar(".x", x), scalar(".y", y)],
        }
    }
}
