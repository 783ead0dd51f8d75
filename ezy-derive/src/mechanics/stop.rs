//! A stop: the distances of its quantity from its bounds, and its constraint while the contact is closed.

use super::expression::Writer;
use super::rows::{ResidualKind, ScalarRow};
use crate::model::{Bound, Expr, Model, Scene, Stop, Switch};
use crate::symbolic::SumId;
use crate::symbolic::coefficient::Coefficient;

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

/// The row of a stop that holds: quantity − bound, of two bounds the one of its side. `None` in a scene without a stop.
pub fn row(writer: &mut Writer<'_>, model: &Model, scene: &Scene) -> Option<ScalarRow> {
    let stop = model.stop_of(scene)?;
    let residual = match &stop.bounds {
        [Some(lower), Some(upper)] => {
            let side = writer.switch(&stop.name, Switch::Side)?;
            let weights = [share(writer, side), share(writer, side.neg())];
            let parts = [lower, upper].map(|bound| excess(writer, stop, bound));
            let parts = [0, 1].map(|i| writer.algebra.scale(parts[i], weights[i]));
            writer.algebra.total(&parts)
        }
        [bound, other] => excess(writer, stop, bound.as_ref().or(other.as_ref())?),
    };
    Some(ScalarRow {
        name: stop.name.to_string(),
        kind: "stop",
        unit: stop.multiplier_unit.clone(),
        residual: ResidualKind::Position(residual),
        // it is no row of the model
        family: model.rows.len(),
        holds: writer.switch(&stop.name, Switch::Holds),
    })
}

/// (1 + side)/2: without rounding 1 on this side and 0 on the other one.
fn share(writer: &mut Writer<'_>, side: Coefficient) -> Coefficient {
    let coefficients = &mut writer.algebra.coefficients;
    let (sum, half) = (coefficients.add(Coefficient::ONE, side), coefficients.number(0.5));
    coefficients.mul(sum, half)
}

/// The quantity less a bound.
fn excess(writer: &mut Writer<'_>, stop: &Stop, bound: &Expr) -> SumId {
    let (quantity, bound) = (writer.write(&stop.quantity), writer.write(bound));
    writer.algebra.sub(quantity, bound)
}
