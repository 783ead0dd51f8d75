//! Outputs: values that are computed on request.

use super::context::{Context, Purpose};
use super::names::Scope;
use super::unit::Unit;
use super::value::Form;
use super::{Expr, Loop, Output};
use crate::parse::ast;

impl Context<'_> {
    /// The scalar outputs of a declaration: one, or two of a vector.
    pub fn output(&mut self, output: &ast::Output, item: &ast::Item, effect: Scope) -> Vec<Output> {
        let loops = self.enter(&item.loops);
        self.check_declared_name(&output.name, &item.loops);
        let outputs = self.outputs(output, &item.documentation, &loops, effect);
        self.leave();
        outputs
    }

    fn outputs(&mut self, output: &ast::Output, documentation: &str, loops: &[Loop], effect: Scope) -> Vec<Output> {
        let unit = output.unit.as_ref().map(|unit| Unit::resolve(unit, self.diag));
        let what = format!("output `{}`", output.name.word);
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
            name: output.name.word.clone(),
            suffix: suffix.to_owned(),
            loops: loops.to_vec(),
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
