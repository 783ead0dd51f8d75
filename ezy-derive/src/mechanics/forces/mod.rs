//! The kinds of forces. Each adds its generalised force Q = Σ (∂r/∂q)ᵀ f to a vector.

mod point_force;
mod torque;

use super::expression::Writer;
use crate::model::{Force, ForceKind};
use crate::symbolic::SumId;

/// Adds one force to the generalised forces `q`, `n_q` long.
pub fn add(writer: &mut Writer<'_>, force: &Force, generalised: &mut [SumId]) {
    match &force.kind {
        ForceKind::Torque { body, value } => torque::add(writer, Some(*body), value, false, generalised),
        ForceKind::TorquePair { a, b, value } => {
            torque::add(writer, *a, value, false, generalised);
            torque::add(writer, *b, value, true, generalised);
        }
        ForceKind::ForceAt { at, x, y } => {
            let force = [writer.write(x), writer.write(y)];
            point_force::add(writer, at, force, generalised);
        }
        ForceKind::ForceAlong { at, direction, across, value } => {
            let along = writer.unit_direction(direction);
            let along = if *across { writer.across(along) } else { along };
            let value = writer.write(value);
            let force = along.map(|x| writer.algebra.mul(value, x));
            point_force::add(writer, at, force, generalised);
        }
    }
}
