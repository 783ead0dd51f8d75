//! First-order states: numbers with a rate of their own.

use super::context::{Context, Purpose};
use super::dimension::Dimension;
use super::names::Scope;
use super::{Expr, InputId};
use crate::parse::ast;
use proc_macro2::Ident;

impl Context<'_> {
    /// The rate of a state, in its unit over s.
    pub fn state_rate(&mut self, name: &Ident, id: InputId, rate: &ast::Expr, effect: Scope) -> Option<Expr> {
        let what = format!("the rate of state `{name}`");
        let unit = self.input_units[id.0];
        let dimension = unit.map(|unit| unit.dimension.over(Dimension::TIME));
        let value = self.scalar(rate, &Purpose::moving(effect), &what, dimension)?;
        Some(unit.map_or(value.clone(), |unit| unit.expr_from_si(value)))
    }
}
