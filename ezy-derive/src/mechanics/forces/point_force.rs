//! `force at P: f`, `force at P along d: f`, `force at P across d: f`.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::Arguments;

pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let force = match (&of.vector, of.directions.first()) {
        (Some((x, y)), _) => [writer.write(x), writer.write(y)],
        (None, Some(direction)) => {
            let along = writer.unit_direction(direction);
            let along = if of.across { writer.across(along) } else { along };
            let value = writer.write(&of.scalars[0]);
            along.map(|x| writer.algebra.mul(value, x))
        }
        (None, None) => return,
    };
    load.at(writer, &of.places[0], force);
}
