//! The equations of one scene: its own selection of rows and effects, derived from scratch.

use super::constraints::Constraints;
use super::event::SceneEvent;
use super::expression::Writer;
use super::forces::{Load, sliding};
use super::kinematics::Vector;
use super::rows;
use super::stop::{self, Contact};
use super::symbols::Symbols;
use crate::model::{BodyId, Component, Coordinate, EffectId, InputId, Model, ParameterId, Scene};
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::{Algebra, SumId, Symbol};

/// Everything that is emitted for a scene, as expressions.
#[derive(Debug)]
pub struct Equations {
    pub algebra: Algebra,
    pub symbols: Symbols,
    /// Parameters of the model and of the scene's effects.
    pub parameters: Vec<ParameterId>,
    /// Inputs of the model and of the scene's effects, then their first-order states.
    pub inputs: Vec<InputId>,
    /// Rates of the first-order states, in their units over s.
    pub rates: Vec<SumId>,
    /// Outputs of the model and of the scene's effects: place in [`Model::outputs`] and value.
    pub outputs: Vec<(usize, SumId)>,
    /// Events, then discontinuities and layers of F.
    pub events: Vec<SceneEvent>,
    /// What each skate with a limit holds up to, N, and the velocity across it, m/s.
    pub limited_skates: Vec<[SumId; 2]>,
    /// What its stop looks at.
    pub contact: Option<Contact>,
    /// Diagonal of M.
    pub mass: Vec<Coefficient>,
    /// The same as expressions.
    pub mass_entries: Vec<SumId>,
    pub constraints: Constraints,
    /// F, `n_q` long.
    pub force: Vec<SumId>,
    /// Power of each group of forces, without those that have a potential.
    pub power: Vec<(Group, SumId)>,
    /// Symbols of the multipliers that `power` reads, with their rows.
    pub multipliers: Vec<(Symbol, usize)>,
    /// V(q, t).
    pub potential: SumId,
    pub points: Vec<PointPosition>,
    pub start: Vec<GivenValue>,
}

/// Forces whose work is counted together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// Outside any effect.
    Model,
    Effect(EffectId),
    /// Rows that move with time.
    Drives,
    /// Impacts on a stop, and a stop that moves with time.
    Stops,
}

/// Where a named point is.
#[derive(Debug)]
pub struct PointPosition {
    pub name: String,
    pub body: Option<BodyId>,
    pub position: Vector,
}

/// A start value: place in q or v, and what it is.
#[derive(Debug)]
pub struct GivenValue {
    pub index: usize,
    pub rate: bool,
    pub near: bool,
    pub value: SumId,
}

impl Equations {
    pub fn derive(model: &Model, scene: &Scene) -> Self {
        let mut algebra = Algebra::new();
        let (parameters, inputs) = called(model, scene);
        let mut symbols = Symbols::new(model, &inputs, model.switches_of(scene));
        let mut writer = Writer::new(model, &mut algebra, &symbols);

        let mass = mass_matrix(&mut writer);
        let scalar_rows = model.rows_of(scene).flat_map(|(id, row)| rows::scalar_rows(&mut writer, row, id));
        let mut scalar_rows: Vec<_> = scalar_rows.collect();
        scalar_rows.extend(stop::row(&mut writer, model, scene));
        let constraints = Constraints::derive(&mut writer, scalar_rows);
        let Applied { force, mut power, potential } = applied_forces(&mut writer, scene);
        let points = points(&mut writer);
        let rates = rates(&mut writer, &inputs);
        let start = start(&mut writer, scene);
        let outputs = model.outputs_of(scene).map(|(i, output)| (i, writer.write(&output.value))).collect();
        let mut events = SceneEvent::declared(&mut writer, model, scene);
        let limited_skates = model.limited_skates_of(scene);
        let limited_skates = limited_skates.map(|(row, limit)| sliding::limit_and_velocity(&mut writer, row, limit));
        let limited_skates: Vec<_> = limited_skates.collect();
        let contact = model.stop_of(scene).map(|stop| Contact::derive(&mut writer, stop));
        let limits = limited_skates.iter().map(|[limit, _]| limit);
        let laws: Vec<SumId> = force.iter().chain(limits).chain(&rates).copied().collect();
        events.extend(SceneEvent::discontinuities(writer.algebra, &laws));
        events.extend(SceneEvent::layers(&writer.layers));
        let mass_entries = mass.iter().map(|&k| algebra.constant(k)).collect();
        let stop = model.stop_of(scene).map(|stop| stop.name.to_string());
        let multipliers = drives(&mut algebra, &mut symbols, &constraints, stop.as_deref(), &mut power);
        Self {
            algebra,
            symbols,
            parameters,
            inputs,
            rates,
            outputs,
            events,
            limited_skates,
            contact,
            mass,
            mass_entries,
            constraints,
            force,
            power,
            multipliers,
            potential,
            points,
            start,
        }
    }
}

/// Parameters and inputs of the model and of the scene's effects; first-order states stand behind the inputs.
pub fn called(model: &Model, scene: &Scene) -> (Vec<ParameterId>, Vec<InputId>) {
    let parameters = (0..model.parameters.len()).map(ParameterId);
    let inputs = (0..model.inputs.len()).map(InputId);
    let inputs = inputs.filter(|id| scene.calls_for(model.inputs[id.0].effect));
    let (inputs, states): (Vec<_>, Vec<_>) = inputs.partition(|id| model.inputs[id.0].rate.is_none());
    let parameters = parameters.filter(|id| scene.calls_for(model.parameters[id.0].effect));
    (parameters.collect(), [inputs, states].concat())
}

/// The rates of the first-order states among these.
pub fn rates(writer: &mut Writer<'_>, inputs: &[InputId]) -> Vec<SumId> {
    let model = writer.model;
    inputs.iter().filter_map(|id| model.inputs[id.0].rate.as_ref()).map(|rate| writer.write(rate)).collect()
}

fn mass_matrix(writer: &mut Writer<'_>) -> Vec<Coefficient> {
    let model = writer.model;
    let mut diagonal = Vec::new();
    for body in &model.bodies {
        let (mass, inertia) = (writer.coefficient(&body.mass), writer.coefficient(&body.inertia));
        diagonal.extend(Component::ALL.map(|component| component.inertia(mass, inertia)));
    }
    diagonal
}

/// The forces that a scene calls for.
struct Applied {
    force: Vec<SumId>,
    power: Vec<(Group, SumId)>,
    potential: SumId,
}

/// F, the power of each group of forces, and the potential energy of all.
fn applied_forces(writer: &mut Writer<'_>, scene: &Scene) -> Applied {
    let model = writer.model;
    let n_q = writer.symbols.n_coordinates();
    let mut applied = Applied { force: vec![SumId::ZERO; n_q], power: Vec::new(), potential: SumId::ZERO };
    let groups = std::iter::once(None).chain(scene.effects.iter().copied().map(Some));
    for group in groups {
        let forces: Vec<_> = model.forces.iter().filter(|force| force.effect == group).collect();
        let mut load = Load::new(n_q);
        for force in forces {
            load.add(writer, force);
        }
        let limited_skates: Vec<_> = model.limited_skates_of(scene).filter(|(row, _)| row.effect == group).collect();
        for (row, limit) in &limited_skates {
            sliding::add(writer, row, limit, &mut load);
        }
        let (generalised, power) = load.finish(writer);
        for (total, part) in applied.force.iter_mut().zip(generalised) {
            *total = writer.algebra.add(*total, part);
        }
        applied.potential = writer.algebra.add(applied.potential, load.potential);
        // forces of the model that have a potential, or none, do no work to record
        if group.is_some() || !limited_skates.is_empty() || !power.is_zero() {
            applied.power.push((group.map_or(Group::Model, Group::Effect), power));
        }
    }
    applied
}

/// Adds the power Σ λ_i g_t,i of the constraints that move with time, a `stop` in a group of its own;
/// returns the symbols of these λ_i with their rows.
///
/// From M a + Gᵀ λ = F and G v = −g_t: d/dt ½ vᵀ M v = F·v − λ·G v = F·v + λ·g_t.
pub fn drives(
    algebra: &mut Algebra,
    symbols: &mut Symbols,
    constraints: &Constraints,
    stop: Option<&str>,
    power: &mut Vec<(Group, SumId)>,
) -> Vec<(Symbol, usize)> {
    let driven = constraints.drift.iter().enumerate().filter(|(_, drift)| !drift.is_zero());
    let (mut multipliers, mut parts, mut parts_of_stop) = (Vec::new(), Vec::new(), Vec::new());
    for (row, &drift) in driven {
        let symbol = symbols.new_named(format!("lambda_{row}"));
        let lambda = algebra.symbol(symbol);
        let is_stop = stop.is_some_and(|stop| constraints.rows[row].name == stop);
        let parts = if is_stop { &mut parts_of_stop } else { &mut parts };
        parts.push(algebra.mul(lambda, drift));
        multipliers.push((symbol, row));
    }
    if !parts.is_empty() {
        power.push((Group::Drives, algebra.total(&parts)));
    }
    if stop.is_some() {
        power.push((Group::Stops, algebra.total(&parts_of_stop)));
    }
    multipliers
}

fn points(writer: &mut Writer<'_>) -> Vec<PointPosition> {
    let model = writer.model;
    model
        .points
        .iter()
        .map(|point| PointPosition {
            name: point.name.to_string(),
            body: point.place.body,
            position: writer.position(&point.place),
        })
        .collect()
}

fn start(writer: &mut Writer<'_>, scene: &Scene) -> Vec<GivenValue> {
    let model = writer.model;
    model.starts[scene.start.0]
        .values
        .iter()
        .map(|given| GivenValue {
            index: Coordinate { body: given.body, component: given.component }.place(),
            rate: given.rate,
            near: given.near,
            value: writer.write(&given.value),
        })
        .collect()
}
