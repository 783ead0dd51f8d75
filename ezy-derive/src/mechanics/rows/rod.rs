//! `rod R: a ~ b length l`: two points keep their distance.

use super::Component;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// C = (d·d/l − l)/2 with d = r_b − r_a. Its Jacobian has the unit vector along the rod, so the multiplier is the tension in
/// the rod. No square root is needed.
pub fn rows(writer: &mut Writer<'_>, of: &Arguments) -> Vec<Component> {
    let gap = writer.gap(&of.places[0], &of.places[1]);
    let square = writer.dot(gap, gap);
    let length = writer.setting(of, 0);
    let algebra = &mut writer.algebra;
    let ratio = algebra.div(square, length);
    let difference = algebra.sub(ratio, length);
    let half = algebra.number(0.5);
    Component::only(algebra.mul(half, difference))
}
