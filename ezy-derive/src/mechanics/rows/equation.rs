//! `drive D: a = b`, `constraint C: a = b`, `velocity constraint V: a = b`: what the user writes.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// The left side minus the right side.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let value = writer.write(&of.scalars[0]);
    vec![Component::named("", &of.multiplier_unit, value)]
}
