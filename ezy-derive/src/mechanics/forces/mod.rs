//! The kinds of forces. Each adds its generalised forces, or its potential, to a load.

mod damper;
mod drag;
mod friction;
mod gravity;
mod point_force;
pub mod sliding;
mod spring;
mod torque;
mod torsion;
mod tyre;

use std::collections::BTreeSet;

use super::expression::Writer;
use super::kinematics::Vector;
use crate::model::{BodyId, Component, Coordinate, Force, Place};
use crate::symbolic::{SumId, Symbol};

/// Generalised force of a group of forces: Q = Σ (∂r/∂q)ᵀ f − ∂V/∂q.
pub struct Load {
    /// The part of Q without a potential, `n_q` long; its work is counted.
    pub work_force: Vec<SumId>,
    /// V(q, t).
    pub potential: SumId,
}

impl Load {
    pub fn new(n_coordinates: usize) -> Self {
        Self { work_force: vec![SumId::ZERO; n_coordinates], potential: SumId::ZERO }
    }

    /// Adds one force.
    pub fn add(&mut self, writer: &mut Writer<'_>, force: &Force) {
        let of = &force.arguments;
        match force.word.word {
            "gravity" => gravity::add(writer, of, self),
            "force" => point_force::add(writer, of, self),
            "torque" => torque::add(writer, of, self),
            "spring" => spring::add(writer, of, self),
            "damper" => damper::add(writer, of, self),
            "torsion" => torsion::add(writer, of, self),
            "drag" => drag::add(writer, of, self),
            "friction" => friction::add(writer, of, self),
            "tyre" => tyre::add(writer, of, self),
            other => unreachable!("`{other}` is no force of the table of keywords"),
        }
    }

    /// A force on a point.
    fn at(&mut self, writer: &mut Writer<'_>, place: &Place, force: Vector) {
        let position = writer.position(place);
        self.along_slopes(writer, position, force);
    }

    /// Equal and opposite forces of two points on each other, `force` on the second one.
    fn between(&mut self, writer: &mut Writer<'_>, gap: Vector, force: Vector) {
        self.along_slopes(writer, gap, force);
    }

    /// Q_i += f · ∂r/∂q_i
    fn along_slopes(&mut self, writer: &mut Writer<'_>, position: Vector, force: Vector) {
        let symbols: BTreeSet<Symbol> = position.iter().flat_map(|&r| writer.algebra.symbols_of(r)).collect();
        for coordinate in symbols {
            let Some(i) = writer.symbols.coordinate_of(coordinate) else { continue };
            let entry = &mut self.work_force[i];
            let slope = position.map(|r| writer.algebra.diff(r, coordinate));
            let part = writer.dot(force, slope);
            *entry = writer.algebra.add(*entry, part);
        }
    }

    /// The reaction on what moves a tread, to the force along it on the point that it touches: −f ∂w/∂v.
    fn on_tread(&mut self, writer: &mut Writer<'_>, tread: SumId, force: SumId) {
        let symbols = writer.algebra.symbols_of(tread);
        for velocity in symbols {
            let Some(i) = writer.symbols.velocity_of(velocity) else { continue };
            let slope = writer.algebra.diff(tread, velocity);
            let part = writer.algebra.mul(force, slope);
            self.work_force[i] = writer.algebra.sub(self.work_force[i], part);
        }
    }

    /// A torque on a body; on the ground it has no effect.
    fn turn(&mut self, writer: &mut Writer<'_>, body: Option<BodyId>, torque: SumId) {
        let Some(body) = body else { return };
        let entry = &mut self.work_force[Coordinate { body, component: Component::Phi }.place()];
        *entry = writer.algebra.add(*entry, torque);
    }

    /// Equal and opposite torques, `torque` on the second body.
    fn couple(&mut self, writer: &mut Writer<'_>, bodies: &[Option<BodyId>], torque: SumId) {
        let reaction = writer.algebra.neg(torque);
        self.turn(writer, bodies[0], reaction);
        self.turn(writer, bodies[1], torque);
    }

    /// The force of a potential V(q, t).
    fn potential(&mut self, writer: &mut Writer<'_>, potential: SumId) {
        self.potential = writer.algebra.add(self.potential, potential);
    }

    /// Q, and the power that changes kinetic and potential energy: v · Q_work + ∂V/∂t.
    pub fn finish(&self, writer: &mut Writer<'_>) -> (Vec<SumId>, SumId) {
        let mut total = Vec::new();
        let mut power = vec![writer.algebra.diff(self.potential, Symbol::TIME)];
        for (i, &force) in self.work_force.iter().enumerate() {
            let slope = writer.algebra.diff(self.potential, writer.symbols.coordinate_at(i));
            total.push(writer.algebra.sub(force, slope));
            let rate = writer.algebra.symbol(writer.symbols.velocity_at(i));
            power.push(writer.algebra.mul(force, rate));
        }
        (total, writer.algebra.total(&power))
    }
}
