//! `spring a ~ b: stiffness k, length l, damping c`: along the line between two places.

use super::{Load, damper};
use crate::mechanics::expression::Writer;
use crate::model::Arguments;
use crate::symbolic::SumId;

/// V = k (s − l)²/2 with s the distance; a moving stiffness or length makes it a force −k (s − l) that does work.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let gap = writer.gap(&of.places[0], &of.places[1]);
    let (stiffness, length) = (writer.setting(of, 0), writer.setting(of, 1));
    let square = writer.dot(gap, gap);
    let half = writer.algebra.number(0.5);
    if writer.is_steady(stiffness) && writer.is_steady(length) {
        // multiplied out, so that a spring without length needs no root
        let mut bracket = writer.algebra.mul(half, square);
        if !length.is_zero() {
            let distance = writer.algebra.pow(square, half);
            let product = writer.algebra.mul(length, distance);
            let length_square = writer.algebra.mul(length, length);
            let constant = writer.algebra.mul(half, length_square);
            bracket = writer.algebra.sub(bracket, product);
            bracket = writer.algebra.add(bracket, constant);
        }
        let potential = writer.algebra.mul(stiffness, bracket);
        load.potential(writer, potential);
    } else {
        let distance = writer.algebra.pow(square, half);
        let ratio = writer.algebra.div(length, distance);
        let stretch = writer.algebra.sub(ratio, SumId::ONE);
        let pull = writer.algebra.mul(stiffness, stretch);
        let force = gap.map(|x| writer.algebra.mul(pull, x));
        load.between(writer, gap, force);
    }
    if of.settings[2].is_some() {
        let damping = writer.setting(of, 2);
        damper::along_line(writer, gap, damping, load);
    }
}
