//! A torque on a body; on the ground it has no effect.

use crate::mechanics::expression::Writer;
use crate::mechanics::symbols::index;
use crate::model::{BodyId, Component, Expr};
use crate::symbolic::SumId;

pub fn add(writer: &mut Writer<'_>, body: Option<BodyId>, value: &Expr, reaction: bool, generalised: &mut [SumId]) {
    let Some(body) = body else { return };
    let value = writer.write(value);
    let value = if reaction { writer.algebra.neg(value) } else { value };
    let entry = &mut generalised[index(body, Component::Phi)];
    *entry = writer.algebra.add(*entry, value);
}
