//! `skate S: at P along d`: P has no velocity across d.

use super::{Demand, ScalarRow};
use crate::mechanics::expression::Writer;
use crate::model::{Direction, Place};

/// S v = n · v_P, with n the unit vector along d turned by +90°.
pub fn rows(writer: &mut Writer<'_>, name: &str, at: &Place, along: &Direction, family: usize) -> Vec<ScalarRow> {
    let along = writer.unit_direction(along);
    let normal = writer.across(along);
    let velocity = writer.velocity(at);
    let slip = writer.dot(normal, velocity);
    vec![ScalarRow { name: name.to_owned(), kind: "skate", unit: "N", demand: Demand::Velocity(slip), family }]
}
