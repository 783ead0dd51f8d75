//! `gear G: a ~ b ratio r offset e`: a turns r times as far as b.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// C = φ_a − r φ_b − e.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let [a, b] = [0, 1].map(|i| writer.angle(of.bodies[i]));
    let (ratio, offset) = (writer.setting(of, 0), writer.setting(of, 1));
    let turned = writer.algebra.mul(ratio, b);
    let difference = writer.algebra.sub(a, turned);
    let value = writer.algebra.sub(difference, offset);
    vec![Component::named("", "N*m", value)]
}
