//! `skate S: at P along d`: P has no velocity across d.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// S v = n · v_P, with n the unit vector along d turned by +90°.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let along = writer.unit_direction(&of.directions[0]);
    let normal = writer.across(along);
    let velocity = writer.velocity(&of.places[0]);
    Component::only(writer.dot(normal, velocity))
}
