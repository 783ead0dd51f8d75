//! Events: conditions that begin to hold while a scene runs.

use super::context::{Context, Motion, Purpose, motion};
use super::names::{Scope, Symbol};
use super::{EffectId, Event, Expr};
use crate::diag::{Extent, scenes};
use crate::parse::ast;

impl Context<'_> {
    pub fn event(&mut self, event: &ast::Event, documentation: &str, effect: Scope) -> Option<Event> {
        let what = format!("event `{}`", event.name);
        let value = self.condition(&event.condition, &what, effect)?;
        let (name, documentation) = (event.name.to_string(), documentation.to_owned());
        Some(Event { name, documentation, effect, value, relation: event.condition.relation })
    }

    /// The value that passes zero: the left side minus the right side.
    fn condition(&mut self, condition: &ast::Condition, what: &str, scope: Scope) -> Option<Expr> {
        let purpose = Purpose::moving(scope);
        let (left, right) = (&condition.left, &condition.right);
        let sign = (condition.relation.sign(), condition.at);
        let (value, _) = self.difference([left, right], sign, &purpose, &format!("a side of {what}"))?;
        if motion(&value) == Motion::Parameters {
            let at = Extent { first: left.extent().first, last: right.extent().last };
            return self.diag.refuse(scenes::condition_never_changes(at, what));
        }
        Some(value)
    }

    /// What ends a scene before its time: places of declared events, and conditions of its own.
    pub fn ends(
        &mut self,
        scene: &ast::Scene,
        effects: &[EffectId],
        known: &[&ast::Effect],
    ) -> (Vec<usize>, Vec<Event>) {
        let (mut declared, mut own) = (Vec::new(), Vec::new());
        for end in &scene.ends {
            match end {
                ast::End::Condition(condition) => {
                    let value = self.condition(condition, "this condition", None);
                    own.extend(value.map(|value| Event {
                        name: condition.text.clone(),
                        documentation: String::new(),
                        effect: None,
                        value,
                        relation: condition.relation,
                    }));
                }
                ast::End::Event(name) => match self.names.event(name) {
                    Some(Symbol::Event(_, Some(effect))) if !effects.contains(&effect) => {
                        let effect = &known[effect.0].name;
                        self.diag.error(scenes::ends_at_event_of_other_effect(name, &scene.name, effect));
                    }
                    Some(Symbol::Event(i, _)) => declared.push(i),
                    Some(Symbol::Broken) => {}
                    symbol => {
                        let error = scenes::ends_at_no_event(name, symbol.map(Symbol::what), &self.names.events());
                        self.diag.error(error);
                    }
                },
            }
        }
        (declared, own)
    }
}
