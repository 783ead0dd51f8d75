//! `roll R: at P along d = u`: P has the velocity u along d, such as the radius times the rate of a wheel.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// S v + s_t = e · v_P − u, with e the unit vector along d.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let along = writer.unit_direction(&of.directions[0]);
    let velocity = writer.velocity(&of.places[0]);
    let speed = writer.dot(along, velocity);
    let rolling = writer.write(&of.scalars[0]);
    Component::only(writer.algebra.sub(speed, rolling))
}
