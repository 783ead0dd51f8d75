//! `slot S: a ~ b along d`: the point on b stays on the line through the point on a along d.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;
use crate::symbolic::SumId;

pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    Component::only(off_line(writer, of))
}

/// C = n · (r_b − r_a), with n the unit vector along d turned by +90°.
pub fn off_line(writer: &mut Writer<'_>, of: &Arguments) -> SumId {
    let along = writer.unit_direction(&of.directions[0]);
    let normal = writer.across(along);
    let gap = writer.gap(&of.places[0], &of.places[1]);
    writer.dot(normal, gap)
}
