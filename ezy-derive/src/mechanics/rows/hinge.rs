//! `hinge B: a ~ b`: two points coincide.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// C = r_a − r_b, along x and along y.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let [a, b] = [0, 1].map(|i| writer.position(&of.places[i]));
    let [x, y] = [0, 1].map(|i| writer.algebra.sub(a[i], b[i]));
    vec![Component::named("x", "N", x), Component::named("y", "N", y)]
}
