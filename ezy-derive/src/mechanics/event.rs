//! Event functions: declared ones, and the discontinuities of laws.

use std::collections::BTreeSet;

use super::expression::Writer;
use crate::function::Function;
use crate::model::{Event, Model, Relation, Scene};
use crate::symbolic::sum::Atom;
use crate::symbolic::{Algebra, SumId};

/// An event of a scene.
#[derive(Debug)]
pub struct SceneEvent {
    pub kind: EventKind,
    pub relation: Relation,
    pub value: SumId,
}

#[derive(Debug)]
pub enum EventKind {
    /// Name, documentation, and whether it ends a run.
    Declared { name: String, documentation: String, ends: bool },
    /// A discontinuity of a law.
    Discontinuity,
    /// A narrow layer in which a law changes its sign.
    Layer,
}

impl SceneEvent {
    /// The events that a scene calls for, in declared order, then its own conditions.
    pub fn declared(writer: &mut Writer<'_>, model: &Model, scene: &Scene) -> Vec<Self> {
        let event = |(event, ends): (&Event, bool)| {
            let (name, documentation) = (event.name.clone(), event.documentation.clone());
            let kind = EventKind::Declared { name, documentation, ends };
            Self { kind, relation: event.relation, value: writer.write(&event.value) }
        };
        model.events_of(scene).map(event).collect()
    }

    /// Arguments of functions that are not differentiable in one of the laws, each once.
    pub fn discontinuities(algebra: &mut Algebra, laws: &[SumId]) -> Vec<Self> {
        let (mut seen, mut values) = (BTreeSet::new(), Vec::new());
        for &law in laws {
            collect(algebra, law, &mut seen, &mut values);
        }
        let discontinuity = |value| Self { kind: EventKind::Discontinuity, relation: Relation::Equal, value };
        values.into_iter().map(discontinuity).collect()
    }

    /// Shares of smoothed laws, each once.
    pub fn layers(values: &[SumId]) -> impl Iterator<Item = Self> {
        let values: BTreeSet<_> = values.iter().copied().collect();
        values.into_iter().map(|value| Self { kind: EventKind::Layer, relation: Relation::Equal, value })
    }
}

fn collect(algebra: &mut Algebra, sum: SumId, seen: &mut BTreeSet<SumId>, values: &mut Vec<SumId>) {
    if !seen.insert(sum) {
        return;
    }
    let products = algebra.terms(sum).iter().map(|&(product, _)| product);
    let atoms: Vec<_> = products.flat_map(|product| algebra.monomial(product).iter().map(|&(atom, _)| atom)).collect();
    for atom in atoms {
        match algebra.atom(atom).clone() {
            Atom::Symbol(_) => {}
            Atom::Cos(inner) | Atom::Sin(inner) | Atom::Group(inner) => collect(algebra, inner, seen, values),
            Atom::Call(function, arguments) => {
                for &argument in &arguments {
                    collect(algebra, argument, seen, values);
                }
                let change = change_over(algebra, function, &arguments);
                let Some(value) = change.filter(|&value| algebra.as_coefficient(value).is_none()) else { continue };
                let opposite = algebra.neg(value);
                if !values.contains(&value) && !values.contains(&opposite) {
                    values.push(value);
                }
            }
        }
    }
}

/// The value that passes zero at the discontinuity of the function.
fn change_over(algebra: &mut Algebra, function: Function, arguments: &[SumId]) -> Option<SumId> {
    match (function, arguments) {
        (Function::Abs | Function::Sign, &[x]) => Some(x),
        (Function::Min | Function::Max, &[x, y]) => {
            // what only keeps a divisor from zero is no discontinuity
            let least = algebra.number(f64::MIN_POSITIVE);
            (x != least && y != least).then(|| algebra.sub(x, y))
        }
        _ => None,
    }
}
