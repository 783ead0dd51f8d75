//! `weld W: a ~ b angle e`: two points coincide and b does not turn against a.

use super::{Component, hinge};
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// C = (r_a − r_b, φ_b − φ_a − e).
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let mut rows = hinge::rows(writer, of);
    let turned = writer.turned_by(of.places[0].body, of.places[1].body, of.settings[0].as_ref());
    rows.push(Component::named("angle", "N*m", turned));
    rows
}
