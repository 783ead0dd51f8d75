//! `spring a ~ b: stiffness k, length l, damping c`: along the line between two places; without a length, the vector law
//! −k d − c ḋ, which has no line where the places coincide.

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
        // a spring without length needs no root; of one with a length the square of the stretch is kept whole, since
        // multiplied out it would cancel
        let square = if length.is_zero() {
            square
        } else {
            let distance = writer.algebra.pow(square, half);
            let stretch = writer.algebra.sub(distance, length);
            writer.algebra.mul(stretch, stretch)
        };
        let bracket = writer.algebra.mul(half, square);
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
        if length.is_zero() {
            damper::along_motion(writer, gap, damping, load);
        } else {
            damper::along_line(writer, gap, damping, load);
        }
    }
}
