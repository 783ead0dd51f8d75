//! A skate beyond its limit slides: a force of the size of the limit opposes the velocity across it.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::mechanics::kinematics::Vector;
use crate::model::{Expr, Row, Switch};
use crate::symbolic::SumId;

/// The limit, and n · v_P: zero while the skate holds.
pub fn limit_and_velocity(writer: &mut Writer<'_>, row: &Row, limit: &Expr) -> [SumId; 2] {
    let normal = normal(writer, row);
    let velocity = writer.velocity(&row.arguments.places[0]);
    [writer.write(limit), writer.dot(normal, velocity)]
}

/// The side is constant while it slides, so that the law is smooth; it is 0 while the skate holds.
pub fn add(writer: &mut Writer<'_>, row: &Row, limit: &Expr, load: &mut Load) {
    let Some(side) = writer.switch(&row.name, Switch::Side) else { return };
    let normal = normal(writer, row);
    let limit = writer.write(limit);
    let force = writer.algebra.scale(limit, side.neg());
    let force = normal.map(|x| writer.algebra.mul(force, x));
    load.at(writer, &row.arguments.places[0], force);
}

/// The unit vector to the left of the direction.
fn normal(writer: &mut Writer<'_>, row: &Row) -> Vector {
    let along = writer.unit_direction(&row.arguments.directions[0]);
    writer.across(along)
}
