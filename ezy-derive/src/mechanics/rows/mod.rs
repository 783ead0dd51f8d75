//! The kinds of constraints. Each states its expression once, as C or as S v.

mod equation;
mod gear;
mod hinge;
mod rod;
mod roll;
mod skate;
mod slider;
mod slot;
mod weld;

use super::expression::Writer;
use crate::grammar::Class;
use crate::model::{Row, RowId, Switch};
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::{Algebra, SumId};

/// The residual of a constraint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResidualKind {
    /// C(q, t)
    Position(SumId),
    /// S(q, t) v + s_t(q, t)
    Velocity(SumId),
}

/// One scalar constraint equation.
#[derive(Debug)]
pub struct ScalarRow {
    pub name: String,
    /// The word that declared it.
    pub kind: &'static str,
    /// Unit of its multiplier.
    pub unit: String,
    pub residual: ResidualKind,
    /// Rows with the same number were declared together and are eliminated together.
    pub family: usize,
    /// Of a row that is switched the factor of its equation.
    pub holds: Option<Coefficient>,
}

impl ScalarRow {
    /// The residual as equations have it: of a row that is switched off it is zero.
    pub fn switched(&self, algebra: &mut Algebra) -> ResidualKind {
        let Some(holds) = self.holds else { return self.residual };
        match self.residual {
            ResidualKind::Position(c) => ResidualKind::Position(algebra.scale(c, holds)),
            ResidualKind::Velocity(rate) => ResidualKind::Velocity(algebra.scale(rate, holds)),
        }
    }
}

/// A scalar equation of a kind: its suffix (`x` in `B.x`), the multiplier's unit, and C or S v.
pub struct Component {
    suffix: &'static str,
    unit: String,
    value: SumId,
}

impl Component {
    /// The only equation of a declaration, with a multiplier in N.
    fn only(value: SumId) -> Vec<Self> {
        vec![Self::named("", "N", value)]
    }

    fn named(suffix: &'static str, unit: &str, value: SumId) -> Self {
        Self { suffix, unit: unit.to_owned(), value }
    }
}

/// The scalar equations of a declared constraint.
pub fn scalar_rows(writer: &mut Writer<'_>, row: &Row, id: RowId) -> Vec<ScalarRow> {
    let of = &row.arguments;
    let components = match row.word.word {
        "hinge" => hinge::rows(writer, of),
        "slider" => slider::rows(writer, of),
        "slot" => slot::rows(writer, of),
        "rod" => rod::rows(writer, of),
        "weld" => weld::rows(writer, of),
        "gear" => gear::rows(writer, of),
        "skate" => skate::rows(writer, of),
        "roll" => roll::rows(writer, of),
        "drive" | "constraint" | "velocity constraint" => equation::rows(writer, of),
        other => unreachable!("`{other}` is no row of the table of keywords"),
    };
    let name = |suffix: &str| if suffix.is_empty() { row.name.to_string() } else { format!("{}.{suffix}", row.name) };
    let residual = |value| match row.word.class {
        Class::VelocityRow => ResidualKind::Velocity(value),
        _ => ResidualKind::Position(value),
    };
    let holds = writer.switch(&row.name, Switch::Holds);
    let rows = components.into_iter().map(|component| ScalarRow {
        name: name(component.suffix),
        kind: row.word.word,
        unit: component.unit,
        residual: residual(component.value),
        family: id.0,
        holds,
    });
    rows.collect()
}
