//! `torque a: m`, `torque a ~ b: m` with the reaction on b.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let torque = writer.write(&of.scalars[0]);
    load.turn(writer, of.bodies[0], torque);
    if let Some(&reacting) = of.bodies.get(1) {
        let reaction = writer.algebra.neg(torque);
        load.turn(writer, reacting, reaction);
    }
}
