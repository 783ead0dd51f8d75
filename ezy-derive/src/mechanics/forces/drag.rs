//! `drag at P: linear k1, quadratic k2, angular k3`: against the motion of a place and of its body.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// The force −(k1 + k2 |v|) v on P and the torque −k3 φ̇ on its body.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let velocity = writer.velocity(&of.places[0]);
    let mut factor = writer.setting(of, 0);
    if of.settings[1].is_some() {
        let speed = writer.length(velocity);
        let quadratic = writer.setting(of, 1);
        let part = writer.algebra.mul(quadratic, speed);
        factor = writer.algebra.add(factor, part);
    }
    let against = writer.algebra.neg(factor);
    let force = velocity.map(|v| writer.algebra.mul(against, v));
    load.at(writer, &of.places[0], force);
    if of.settings[2].is_some() {
        let body = of.places[0].body;
        let angle = writer.angle(body);
        let rate = writer.time_derivative(angle);
        let angular = writer.setting(of, 2);
        let product = writer.algebra.mul(angular, rate);
        let torque = writer.algebra.neg(product);
        load.turn(writer, body, torque);
    }
}
