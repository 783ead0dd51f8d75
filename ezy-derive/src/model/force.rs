//! Torques and forces.

use super::context::{Context, Purpose};
use super::dimension::Dimension;
use super::names::Scope;
use super::{Force, ForceKind};
use crate::diag::rules;
use crate::parse::ast;

impl Context<'_> {
    pub fn torque(&mut self, torque: &ast::Torque, effect: Scope) -> Option<Force> {
        let dimension = Some(Dimension::TORQUE);
        let value = self.scalar(&torque.value, &Purpose::moving(effect), "a torque", dimension);
        let kind = match &torque.from {
            None => ForceKind::Torque { body: self.body(&torque.on, false)?, value: value? },
            Some(from) if *from == torque.on => {
                self.diag.error(rules::torque_on_itself(from));
                return None;
            }
            Some(from) => {
                let (a, b) = (self.body_or_ground(&torque.on), self.body_or_ground(from));
                ForceKind::TorquePair { a: a?, b: b?, value: value? }
            }
        };
        Some(Force { effect, kind })
    }

    pub fn force(&mut self, force: &ast::Force, effect: Scope) -> Option<Force> {
        let at = self.place(&force.at, effect);
        let (purpose, dimension) = (Purpose::moving(effect), Some(Dimension::FORCE));
        let kind = match &force.direction {
            None => {
                let components = self.components(&force.value, &purpose, "a force", dimension);
                let (at, (x, y)) = (at?, components?);
                ForceKind::ForceAt { at, x, y }
            }
            Some(ast::ForceDirection { across, direction }) => {
                let direction = self.direction(direction, effect);
                let value = self.scalar(&force.value, &purpose, "a force along a direction", dimension);
                ForceKind::ForceAlong { at: at?, direction: direction?, across: *across, value: value? }
            }
        };
        if let ForceKind::ForceAt { at, .. } | ForceKind::ForceAlong { at, .. } = &kind
            && at.body.is_none()
        {
            self.diag.error(rules::force_on_ground(force.at.owner()));
            return None;
        }
        Some(Force { effect, kind })
    }
}
