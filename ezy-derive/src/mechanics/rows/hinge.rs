//! `hinge B: a ~ b`: two places coincide.

use super::{Demand, ScalarRow};
use crate::mechanics::expression::Writer;
use crate::model::Place;

/// C = place(a) − place(b), along x and along y.
pub fn rows(writer: &mut Writer<'_>, name: &str, a: &Place, b: &Place, family: usize) -> Vec<ScalarRow> {
    let (a, b) = (writer.position(a), writer.position(b));
    ["x", "y"]
        .into_iter()
        .zip(a.into_iter().zip(b))
        .map(|(axis, (a, b))| ScalarRow {
            name: format!("{name}.{axis}"),
            kind: "hinge",
            unit: "N",
            demand: Demand::Position(writer.algebra.sub(a, b)),
            family,
        })
        .collect()
}
