//! `tyre at P along d: stiffness c, limit f, speed u`: a side force against the slip angle.

use super::Load;
use crate::function::Function;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// The force −c α across d, with the slip angle α = atan2(v_across, |v_along|); with a limit, −f tanh(c α/f); with a
/// speed u, √(v_along² + u²) in place of |v_along|, so that the force goes through zero at standstill.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let along = writer.unit_direction(&of.directions[0]);
    let across = writer.across(along);
    let velocity = writer.velocity(&of.places[0]);
    let (forward, sideward) = (writer.dot(velocity, along), writer.dot(velocity, across));
    let forward = if of.settings[2].is_some() {
        let knee = writer.setting(of, 2);
        writer.length([forward, knee])
    } else {
        writer.algebra.call(Function::Abs, vec![forward])
    };
    let slip = writer.algebra.call(Function::Atan2, vec![sideward, forward]);
    let stiffness = writer.setting(of, 0);
    let mut value = writer.algebra.mul(stiffness, slip);
    if of.settings[1].is_some() {
        let limit = writer.setting(of, 1);
        let divisor = writer.at_least_something(limit);
        let ratio = writer.algebra.div(value, divisor);
        let bounded = writer.algebra.call(Function::Tanh, vec![ratio]);
        value = writer.algebra.mul(limit, bounded);
    }
    let against = writer.algebra.neg(value);
    let force = across.map(|x| writer.algebra.mul(against, x));
    load.at(writer, &of.places[0], force);
}
