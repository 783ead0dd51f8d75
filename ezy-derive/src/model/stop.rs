//! Stops (unilateral contacts): quantities that stay within bounds.

use super::constant::literal;
use super::context::{Context, Motion, Purpose, motion};
use super::dimension::Dimension;
use super::names::Scope;
use super::{Expr, Stop};
use crate::diag::rules;
use crate::parse::ast;

impl Context<'_> {
    pub fn stop(&mut self, stop: &ast::Stop, effect: Scope) -> Option<Stop> {
        let what = format!("stop `{}`", stop.name);
        let purpose = Purpose::stop(effect, what.clone());
        let quantity = self.scalar_of_any_dimension(&stop.quantity, &purpose, &what);
        let dimension = quantity.as_ref().and_then(|(_, measure)| measure.known());
        let bounds = ["from", "to"].into_iter().zip(&stop.bounds);
        let mut bounds = bounds.map(|(word, bound)| {
            let bound = bound.as_ref()?;
            self.scalar(bound, &purpose, &format!("`{word}` of {what}"), dimension)
        });
        let bounds = std::array::from_fn(|_| bounds.next().flatten());
        let restitution = self.restitution(stop, &what, effect);
        let (quantity, _) = quantity?;
        if motion(&quantity) != Motion::Position {
            return self.diag.refuse(rules::stop_of_nothing(stop.quantity.extent(), &what));
        }
        let multiplier_unit = dimension.map_or_else(String::new, |of| Dimension::TORQUE.over(of).to_string());
        Some(Stop { name: stop.name.clone(), effect, quantity, bounds, restitution: restitution?, multiplier_unit })
    }

    /// Zero unless it is given; it may depend on how fast the impact is.
    fn restitution(&mut self, stop: &ast::Stop, what: &str, effect: Scope) -> Option<Expr> {
        let Some(given) = &stop.restitution else { return Some(Expr::Number(0.0)) };
        let what = format!("`restitution` of {what}");
        let value = self.scalar(given, &Purpose::moving(effect), &what, Some(Dimension::NONE))?;
        let number = literal(&value).filter(|number| !(0.0..=1.0).contains(number));
        if let Some(number) = number {
            self.diag.error(rules::no_restitution(given.extent(), &what, number));
        }
        Some(value)
    }
}
