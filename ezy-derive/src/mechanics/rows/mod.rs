//! The kinds of constraint rows. Each states its expression once, as C or as S v.

mod hinge;
mod skate;

use super::expression::Writer;
use crate::model::{Row, RowKind};
use crate::symbolic::SumId;

/// What a row demands to be zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Demand {
    /// C(q, t)
    Position(SumId),
    /// S(q, t) v + s_t(q, t)
    Velocity(SumId),
}

/// One scalar row.
#[derive(Debug)]
pub struct ScalarRow {
    pub name: String,
    /// The word that declared it.
    pub kind: &'static str,
    /// Unit of its multiplier.
    pub unit: &'static str,
    pub demand: Demand,
    /// Rows with the same number were declared together and are eliminated together.
    pub family: usize,
}

/// The scalar rows of a declared row.
pub fn scalar_rows(writer: &mut Writer<'_>, row: &Row, family: usize) -> Vec<ScalarRow> {
    let name = row.name.to_string();
    match &row.kind {
        RowKind::Hinge { a, b } => hinge::rows(writer, &name, a, b, family),
        RowKind::Skate { at, along } => skate::rows(writer, &name, at, along, family),
    }
}
