//! A stop: the distances of its quantity from its bounds, and its constraint while the contact is closed.

use super::expression::Writer;
use super::rows::{ResidualKind, ScalarRow};
use crate::model::{Bound, Expr, Mode, Model, Scene, Stop};
use crate::symbolic::SumId;

/// The event functions of a stop.
#[derive(Debug)]
pub struct Contact {
    /// Distance and its rate for each end of the stop: positive inside, negative beyond.
    pub gaps: Vec<[SumId; 2]>,
    pub restitution: SumId,
}

impl Contact {
    pub fn derive(writer: &mut Writer<'_>, stop: &Stop) -> Self {
        let gaps = stop.ends().map(|(bound, value)| {
            let beyond = excess(writer, stop, value);
            let gap = match bound {
                Bound::Lower => beyond,
                Bound::Upper => writer.algebra.neg(beyond),
            };
            [gap, writer.time_derivative(gap)]
        });
        let gaps = gaps.collect();
        Self { gaps, restitution: writer.write(&stop.restitution) }
    }

    /// Every value, in the order of the kernel.
    pub fn values(&self) -> Vec<SumId> {
        self.gaps.iter().flatten().copied().chain([self.restitution]).collect()
    }
}

/// The row of a stop that holds: quantity − bound. `None` in a scene that has none, or whose stop does not hold.
pub fn row(writer: &mut Writer<'_>, model: &Model, scene: &Scene) -> Option<ScalarRow> {
    let Some(Mode::Rests(bound)) = scene.mode else { return None };
    let stop = model.stop_of(scene)?;
    let (_, value) = stop.ends().find(|(end, _)| *end == bound)?;
    Some(ScalarRow {
        name: stop.name.to_string(),
        kind: "stop",
        unit: stop.multiplier_unit.clone(),
        residual: ResidualKind::Position(excess(writer, stop, value)),
        // it is no row of the model
        family: model.rows.len(),
    })
}

/// The quantity less a bound.
fn excess(writer: &mut Writer<'_>, stop: &Stop, bound: &Expr) -> SumId {
    let (quantity, bound) = (writer.write(&stop.quantity), writer.write(bound));
    writer.algebra.sub(quantity, bound)
}
