//! `slider S: a ~ b along d angle e`: a slot in which b does not turn against a.

use super::{Component, slot};
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// C = (n · (r_b − r_a), φ_b − φ_a − e).
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let across = slot::off_line(writer, of);
    let turned = writer.turned_by(of.places[0].body, of.places[1].body, of.settings[0].as_ref());
    vec![Component::named("across", "N", across), Component::named("angle", "N*m", turned)]
}
