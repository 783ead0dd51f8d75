//! The equations of a scene with arrays: each item once, for all members that a run will have.

use super::constraints::Constraints;
use super::event::SceneEvent;
use super::expression::Writer;
use super::forces::Load;
use super::jacobians::Jacobians;
use super::kinematics::Vector;
use super::rows;
use super::scene::{Group, called, drives, rates};
use super::series::Series;
use super::symbols::Symbols;
use crate::function::Function;
use crate::model::{
    Array, BodyId, Component, Coordinate, Force, InputId, Loop, Model, Output, ParameterId, Point, Row, Scene,
    StartValue,
};
use crate::symbolic::lower::ConstantPool;
use crate::symbolic::{Algebra, SumId, Symbol};

/// Everything that is emitted for a scene with arrays. Coordinates are those of the model's slots.
#[derive(Debug)]
pub struct Templates<'m> {
    pub algebra: Algebra,
    pub symbols: Symbols,
    /// Parameters of the model and of the scene's effects.
    pub parameters: Vec<ParameterId>,
    /// Inputs of the model and of the scene's effects, then their first-order states.
    pub inputs: Vec<InputId>,
    /// Rates of the first-order states, in their units over s, with the bodies that they read.
    pub rates: Vec<(SumId, Vec<BodyId>)>,
    /// Mass, mass and inertia of a member, by [`Model::arrays`].
    pub masses: Vec<(&'m Array, [SumId; Component::ALL.len()])>,
    /// Position constraints first.
    pub rows: Vec<RowTemplate<'m>>,
    pub forces: Vec<ForceTemplate<'m>>,
    /// The groups whose work is counted, in order.
    pub groups: Vec<Group>,
    pub points: Vec<PointTemplate<'m>>,
    pub outputs: Vec<OutputTemplate<'m>>,
    pub events: Vec<EventTemplate>,
    pub start: Vec<(&'m StartValue, SumId)>,
}

/// A declared row.
#[derive(Debug)]
pub struct RowTemplate<'m> {
    pub row: &'m Row,
    /// The bodies that it reads or moves.
    pub slots: Vec<BodyId>,
    /// Its own rows alone.
    pub constraints: Constraints,
    /// Symbols of the multipliers of rows that move with time, with the place among its own rows.
    pub multipliers: Vec<(Symbol, usize)>,
    /// Power of those rows.
    pub power: SumId,
}

/// A declared force.
#[derive(Debug)]
pub struct ForceTemplate<'m> {
    pub force: &'m Force,
    /// The bodies that it reads or moves.
    pub slots: Vec<BodyId>,
    pub group: Group,
    /// What it adds to F, by coordinate; zeros left out.
    pub entries: Vec<(usize, SumId)>,
    pub power: SumId,
    pub potential: SumId,
}

/// A named point.
#[derive(Debug)]
pub struct PointTemplate<'m> {
    pub point: &'m Point,
    pub slots: Vec<BodyId>,
    pub position: Vector,
}

#[derive(Debug)]
pub struct OutputTemplate<'m> {
    pub output: &'m Output,
    pub slots: Vec<BodyId>,
    pub value: SumId,
}

#[derive(Debug)]
pub struct EventTemplate {
    pub event: SceneEvent,
    pub slots: Vec<BodyId>,
}

impl RowTemplate<'_> {
    pub fn is_position(&self) -> bool {
        self.constraints.n_position_rows > 0
    }
}

impl<'m> Templates<'m> {
    pub fn derive(model: &'m Model, scene: &'m Scene) -> Self {
        let mut algebra = Algebra::new();
        let (parameters, inputs) = called(model, scene);
        let mut symbols = Symbols::new(model, &inputs, Vec::new());
        let mut writer = Writer::new(model, &mut algebra, &symbols);
        let masses = model.arrays.iter().map(|array| {
            let (mass, inertia) = (writer.write(&array.mass), writer.write(&array.inertia));
            (array, Component::ALL.map(|component| component.inertia(mass, inertia)))
        });
        let masses = masses.collect();
        let forces = forces(model, &mut writer, scene);
        let points = model.points.iter().map(|point| {
            let position = writer.position(&point.place);
            PointTemplate { point, slots: slots(&mut writer, &position), position }
        });
        let points = points.collect();
        let outputs = model.outputs_of(scene).map(|(_, output)| {
            let value = writer.write(&output.value);
            OutputTemplate { output, slots: slots(&mut writer, &[value]), value }
        });
        let outputs = outputs.collect();
        let events = SceneEvent::declared(&mut writer, model, scene).into_iter();
        let events = events.map(|event| EventTemplate { slots: slots(&mut writer, &[event.value]), event });
        let events = events.collect();
        let rates = rates(&mut writer, &inputs).into_iter();
        let rates = rates.map(|rate| (rate, slots(&mut writer, &[rate]))).collect();
        let start = model.starts[scene.start.0].values.iter();
        let start = start.map(|given| (given, writer.write(&given.value))).collect();
        let rows = model.rows_of(scene).map(|(id, row)| {
            let scalar_rows = rows::scalar_rows(&mut writer, row, id);
            let constraints = Constraints::derive(&mut writer, scalar_rows);
            let sums = [&constraints.velocity[..], &constraints.convective].concat();
            (row, slots(&mut writer, &sums), constraints)
        });
        let (position, velocity): (Vec<_>, Vec<_>) = rows.partition(|(.., rows)| rows.n_position_rows > 0);
        let rows = position.into_iter().chain(velocity);
        let rows: Vec<_> =
            rows.map(|(row, slots, rows)| RowTemplate::new(&mut algebra, &mut symbols, row, slots, rows)).collect();
        // forces of the model that have a potential do no work to record
        let works = |force: &ForceTemplate| force.group == Group::Model && !force.power.is_zero();
        let of_model = forces.iter().any(works).then_some(Group::Model);
        let drives = rows.iter().any(|row| !row.multipliers.is_empty()).then_some(Group::Drives);
        let groups = of_model.into_iter().chain(scene.effects.iter().copied().map(Group::Effect)).chain(drives);
        let groups = groups.collect();
        Self {
            algebra,
            symbols,
            parameters,
            inputs,
            rates,
            masses,
            rows,
            forces,
            groups,
            points,
            outputs,
            events,
            start,
        }
    }
}

impl<'m> RowTemplate<'m> {
    fn new(
        algebra: &mut Algebra,
        symbols: &mut Symbols,
        row: &'m Row,
        slots: Vec<BodyId>,
        constraints: Constraints,
    ) -> Self {
        let mut groups = Vec::new();
        let multipliers = drives(algebra, symbols, &constraints, None, &mut groups);
        let power = groups.first().map_or(SumId::ZERO, |&(_, power)| power);
        Self { row, slots, constraints, multipliers, power }
    }
}

/// A row, a force or a rate of a scene with counts, as series and Jacobians see it.
pub struct Item<'t, 'm> {
    pub loops: &'m [Loop],
    pub slots: &'t [BodyId],
    pub constraints: Option<&'t Constraints>,
    /// What it adds to F, by coordinate.
    pub force: &'t [(usize, SumId)],
    /// Of a first-order state.
    pub rate: &'t [SumId],
}

impl Item<'_, '_> {
    /// Rows of the residual besides those of forces.
    pub fn n_rows(&self) -> usize {
        self.constraints.map_or(0, |constraints| constraints.rows.len()) + self.rate.len()
    }
}

/// Rows, then forces, then rates.
fn items<'t, 'm>(
    rows: &'t [RowTemplate<'m>],
    forces: &'t [ForceTemplate<'m>],
    rates: &'t [(SumId, Vec<BodyId>)],
) -> impl Iterator<Item = Item<'t, 'm>> {
    let rows = rows.iter().map(|of| {
        let (loops, constraints) = (&of.row.loops[..], Some(&of.constraints));
        Item { loops, slots: &of.slots, constraints, force: &[], rate: &[] }
    });
    let forces = forces.iter().map(|of| {
        let (loops, force) = (&of.force.loops[..], &of.entries[..]);
        Item { loops, slots: &of.slots, constraints: None, force, rate: &[] }
    });
    let rates = rates.iter().map(|(rate, slots)| Item {
        loops: &[],
        slots,
        constraints: None,
        force: &[],
        rate: std::slice::from_ref(rate),
    });
    rows.chain(forces).chain(rates)
}

impl<'m> Templates<'m> {
    pub fn items(&self) -> impl Iterator<Item = Item<'_, 'm>> {
        items(&self.rows, &self.forces, &self.rates)
    }

    /// The series of the first-order states, then of each item.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn series(&mut self, constants: &mut ConstantPool) -> Result<Vec<Series<'m>>, Function> {
        let Self { algebra, symbols, rows, forces, rates, .. } = self;
        let mut extended = constants.clone();
        let mut series = Vec::new();
        if !rates.is_empty() {
            let mut slots: Vec<BodyId> = rates.iter().flat_map(|(_, slots)| slots).copied().collect();
            slots.sort_unstable();
            slots.dedup();
            let rates: Vec<SumId> = rates.iter().map(|&(rate, _)| rate).collect();
            let of_states = Series::of_item(algebra, symbols, &mut extended, None, &[], &rates)?;
            series.push(of_states.of_members(&[], &slots));
        }
        let of_item = |item: Item<'_, 'm>| {
            let series = Series::of_item(algebra, symbols, &mut extended, item.constraints, item.force, &[])?;
            Ok(series.of_members(item.loops, item.slots))
        };
        series.extend(items(rows, forces, &[]).map(of_item).collect::<Result<Vec<_>, _>>()?);
        *constants = extended;
        Ok(series)
    }

    /// The Jacobians of each item; `None` when some are too long to write.
    pub fn jacobians(&mut self) -> Option<Vec<Jacobians>> {
        let Self { algebra, symbols, rows, forces, rates, .. } = self;
        let of_item =
            |item: Item| Jacobians::derive(algebra, symbols, item.constraints, item.force.iter().copied(), item.rate);
        items(rows, forces, rates).map(of_item).collect()
    }
}

/// Each force that a scene calls for by itself.
fn forces<'m>(model: &'m Model, writer: &mut Writer<'_>, scene: &Scene) -> Vec<ForceTemplate<'m>> {
    let groups = std::iter::once(None).chain(scene.effects.iter().copied().map(Some));
    let of_group = |group| model.forces.iter().filter(move |force| force.effect == group);
    let mut derived = Vec::new();
    for force in groups.flat_map(of_group) {
        let mut load = Load::new(writer.symbols.n_coordinates());
        load.add(writer, force);
        let (generalised, power) = load.finish(writer);
        let entries: Vec<_> = generalised.into_iter().enumerate().filter(|(_, entry)| !entry.is_zero()).collect();
        let mut sums: Vec<SumId> = entries.iter().map(|&(_, entry)| entry).collect();
        sums.extend([power, load.potential]);
        let mut slots = slots(writer, &sums);
        slots.extend(entries.iter().map(|&(i, _)| Coordinate::at(i).body));
        slots.sort_unstable();
        slots.dedup();
        let group = force.effect.map_or(Group::Model, Group::Effect);
        derived.push(ForceTemplate { force, slots, group, entries, power, potential: load.potential });
    }
    derived
}

/// The bodies whose coordinates or velocities some of the sums read.
pub fn slots(writer: &mut Writer<'_>, sums: &[SumId]) -> Vec<BodyId> {
    let (algebra, symbols) = (&mut writer.algebra, writer.symbols);
    let body_of =
        |symbol| symbols.coordinate_of(symbol).or(symbols.velocity_of(symbol)).map(|i| Coordinate::at(i).body);
    let mut bodies: Vec<BodyId> = sums.iter().flat_map(|&sum| algebra.symbols_of(sum)).filter_map(body_of).collect();
    bodies.sort_unstable();
    bodies.dedup();
    let mut reads = |symbol| sums.iter().any(|&sum| !algebra.diff(sum, symbol).is_zero());
    bodies.retain(|body| {
        let mut places = Coordinate::of(*body).into_iter().map(Coordinate::place);
        places.any(|i| reads(symbols.coordinate_at(i)) || reads(symbols.velocity_at(i)))
    });
    bodies
}
