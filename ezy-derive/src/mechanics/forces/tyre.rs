//! `tyre at P along d: stiffness c, limit f, speed u, tread w`: a force against the slip.
//!
//! The slip velocity is v_s = v_P − w e for a wheel that rolls at the speed w along e, and v_P across d for one that rolls freely.
//! The slip angle α = atan2(|v_s|, |w|) is the angle whose tangent is the theoretical slip (Pacejka, Tire and Vehicle Dynamics, ch. 3.2);
//! of a wheel that rolls freely it is the angle between d and v_P.

use super::Load;
use crate::function::Function;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;
use crate::symbolic::SumId;

/// The force −c α against the slip; with a limit, −f tanh(c α/f); with a speed u, √(w² + u²) in place of |w|, so that the
/// force goes through zero at standstill.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let along = writer.unit_direction(&of.directions[0]);
    let across = writer.across(along);
    let velocity = writer.velocity(&of.places[0]);
    let (forward, sideward) = (writer.dot(velocity, along), writer.dot(velocity, across));
    if of.settings[3].is_none() {
        let value = magnitude(writer, of, sideward, forward);
        let against = writer.algebra.neg(value);
        let force = across.map(|x| writer.algebra.mul(against, x));
        load.at(writer, &of.places[0], force);
        return;
    }
    let tread = writer.setting(of, 3);
    let slip = [writer.algebra.sub(forward, tread), sideward];
    let square = writer.dot(slip, slip);
    let square = writer.at_least_something(square);
    let half = writer.algebra.number(0.5);
    let speed = writer.algebra.pow(square, half);
    let value = magnitude(writer, of, speed, tread);
    let ratio = writer.algebra.div(value, speed);
    let against = writer.algebra.neg(ratio);
    let [lengthwise, crosswise] = slip.map(|v| writer.algebra.mul(against, v));
    let force = std::array::from_fn(|i| {
        let parts = [writer.algebra.mul(lengthwise, along[i]), writer.algebra.mul(crosswise, across[i])];
        writer.algebra.total(&parts)
    });
    load.at(writer, &of.places[0], force);
    load.on_tread(writer, tread, lengthwise);
}

/// The force at a slip velocity of a wheel that rolls at a speed.
fn magnitude(writer: &mut Writer<'_>, of: &Arguments, slip: SumId, rolling: SumId) -> SumId {
    let rolling = if of.settings[2].is_some() {
        let knee = writer.setting(of, 2);
        writer.length([rolling, knee])
    } else {
        writer.algebra.call(Function::Abs, vec![rolling])
    };
    let angle = writer.algebra.call(Function::Atan2, vec![slip, rolling]);
    let stiffness = writer.setting(of, 0);
    let value = writer.algebra.mul(stiffness, angle);
    if of.settings[1].is_none() {
        return value;
    }
    let limit = writer.setting(of, 1);
    let divisor = writer.at_least_something(limit);
    let ratio = writer.algebra.div(value, divisor);
    let bounded = writer.algebra.call(Function::Tanh, vec![ratio]);
    writer.algebra.mul(limit, bounded)
}
