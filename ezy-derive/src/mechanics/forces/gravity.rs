//! `gravity g`: the same acceleration for every body.

use super::Load;
use crate::mechanics::expression::Writer;
use crate::model::{Arguments, BodyId, Component, Coordinate};

/// V = −Σ m g · r; where g moves, it is a force m g that does work.
pub fn add(writer: &mut Writer<'_>, of: &Arguments, load: &mut Load) {
    let Some((x, y)) = &of.vector else { return };
    let g = [writer.write(x), writer.write(y)];
    let steady = g.iter().all(|&g| writer.is_steady(g));
    let all = (0..writer.model.bodies.len()).map(BodyId);
    let named: Vec<BodyId> = of.bodies.iter().copied().flatten().collect();
    for body in if named.is_empty() { all.collect() } else { named } {
        let mass = writer.write(&writer.model.bodies[body.0].mass);
        for (g, component) in g.into_iter().zip([Component::X, Component::Y]) {
            let weight = writer.algebra.mul(mass, g);
            if steady {
                let coordinate = writer.symbols.coordinate(body, component);
                let coordinate = writer.algebra.symbol(coordinate);
                let work = writer.algebra.mul(weight, coordinate);
                let potential = writer.algebra.neg(work);
                load.potential(writer, potential);
            } else {
                let entry = &mut load.work_force[Coordinate { body, component }.place()];
                *entry = writer.algebra.add(*entry, weight);
            }
        }
    }
}
