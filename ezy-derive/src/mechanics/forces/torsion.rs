//! `torsion a ~ b: stiffness k, angle e, damping c`: against the angle between two bodies.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

/// V = k (φ_b − φ_a − e)²/2, and the torque −c (φ̇_b − φ̇_a) on b; moving values make it a torque that does work.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let twist = writer.turned_by(of.bodies[0], of.bodies[1], of.settings[1].as_ref());
    let stiffness = writer.setting(of, 0);
    let angle = writer.setting(of, 1);
    if writer.is_steady(stiffness) && writer.is_steady(angle) {
        let square = writer.algebra.mul(twist, twist);
        let half = writer.algebra.number(0.5);
        let energy = writer.algebra.mul(half, square);
        let potential = writer.algebra.mul(stiffness, energy);
        load.potential(writer, potential);
    } else {
        let product = writer.algebra.mul(stiffness, twist);
        let torque = writer.algebra.neg(product);
        load.couple(writer, &of.bodies, torque);
    }
    if of.settings[2].is_some() {
        let damping = writer.setting(of, 2);
        let turned = writer.turned_by(of.bodies[0], of.bodies[1], None);
        let rate = writer.time_derivative(turned);
        let product = writer.algebra.mul(damping, rate);
        let torque = writer.algebra.neg(product);
        load.couple(writer, &of.bodies, torque);
    }
}
