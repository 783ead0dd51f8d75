//! `damper a ~ b: damping c`: against the rate of the distance between two places.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::mechanics::kinematics::Vector;
use crate::model::Arguments;
use crate::symbolic::SumId;

pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let gap = writer.gap(&of.places[0], &of.places[1]);
    let damping = writer.setting(of, 0);
    along_line(writer, gap, damping, load);
}

/// −c ṡ along d/s, with s = |d|: the force −c (d·ḋ) d/(d·d) on the second place; none where the places coincide.
pub fn along_line(writer: &mut Writer<'_>, gap: Vector, damping: SumId, load: &mut Load) {
    let rate = gap.map(|x| writer.time_derivative(x));
    let (product, square) = (writer.dot(gap, rate), writer.dot(gap, gap));
    let square = writer.at_least_something(square);
    let ratio = writer.algebra.div(product, square);
    let pull = writer.algebra.mul(damping, ratio);
    let pull = writer.algebra.neg(pull);
    let force = gap.map(|x| writer.algebra.mul(pull, x));
    load.between(writer, gap, force);
}

/// The force −c ḋ on the second place.
pub fn along_motion(writer: &mut Writer<'_>, gap: Vector, damping: SumId, load: &mut Load) {
    let against = writer.algebra.neg(damping);
    let rate = gap.map(|x| writer.time_derivative(x));
    let force = rate.map(|x| writer.algebra.mul(against, x));
    load.between(writer, gap, force);
}
