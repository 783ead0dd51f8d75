//! A force at a place.

use crate::mechanics::expression::Writer;
use crate::mechanics::kinematics::Vector;
use crate::model::Place;
use crate::symbolic::SumId;

/// Q_i = f · ∂r/∂q_i
pub fn add(writer: &mut Writer<'_>, at: &Place, force: Vector, generalised: &mut [SumId]) {
    let position = writer.position(at);
    for (i, entry) in generalised.iter_mut().enumerate() {
        let coordinate = writer.symbols.coordinate_at(i);
        let slope = position.map(|r| writer.algebra.diff(r, coordinate));
        let part = writer.dot(force, slope);
        *entry = writer.algebra.add(*entry, part);
    }
}
