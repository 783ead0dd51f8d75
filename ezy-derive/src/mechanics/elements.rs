//! Points, constraints and forces as a picture of the scene shows them: where they are fixed to bodies, and how the model
//! names these lengths. No equation of motion reads them.

use super::expression::Writer;
use super::forces::Load;
use super::symbols::Symbols;
use super::templates::slots;
use crate::grammar::Part;
use crate::model::{Arguments, BodyId, Component, Coordinate, Expr, Force, Loop, Model, Scene};
use crate::symbolic::{Algebra, SumId};

/// A point, a constraint or a force.
#[derive(Debug)]
pub struct Element<'m> {
    /// The word that declares it.
    pub word: &'static str,
    /// Empty for a force.
    pub name: String,
    pub loops: &'m [Loop],
    /// The bodies that it refers to.
    pub slots: Vec<BodyId>,
    pub points: Vec<Fixed>,
    pub directions: Vec<Fixed>,
    /// Bodies that are named without a point.
    pub bodies: Vec<Option<BodyId>>,
    /// Settings by their words, where they are not zero.
    pub settings: Vec<(&'static str, SumId)>,
    pub load: Option<(BodyId, Loading)>,
}

/// A point or a direction in the axes of its body; `None` is the ground.
#[derive(Debug)]
pub struct Fixed {
    pub body: Option<BodyId>,
    pub local: [SumId; 2],
    /// Whether a coordinate depends on an index of a `for`.
    pub by_index: [bool; 2],
}

/// What a force does to its first body that can move.
#[derive(Debug)]
pub enum Loading {
    /// Along the axes of the ground, N.
    Force([SumId; 2]),
    /// N m
    Torque(SumId),
}

impl Element<'_> {
    /// What its kernel writes: points, directions, then the load.
    pub fn values(&self) -> Vec<SumId> {
        let fixed = self.points.iter().chain(&self.directions).flat_map(|fixed| fixed.local);
        let load = self.load.iter().flat_map(|(_, load)| match load {
            Loading::Force(force) => force.to_vec(),
            Loading::Torque(torque) => vec![*torque],
        });
        fixed.chain(load).collect()
    }
}

/// The elements of a scene: points that are no hinge, then constraints, then forces.
pub fn elements<'m>(model: &'m Model, scene: &'m Scene, algebra: &mut Algebra, symbols: &Symbols) -> Vec<Element<'m>> {
    let mut writer = Writer::new(model, algebra, symbols);
    let is_row = |name: &str| model.rows.iter().any(|row| row.name == name);
    let points = model.points.iter().filter(|point| !is_row(&point.name.to_string()));
    let mut all: Vec<Element<'m>> = Vec::new();
    for point in points {
        let arguments = Arguments { places: vec![point.place.clone()], ..Arguments::default() };
        let mut element = element(&mut writer, "point", &[], &arguments, &point.loops);
        element.name = point.name.to_string();
        all.push(element);
    }
    for (_, row) in model.rows_of(scene) {
        let mut element = element(&mut writer, row.word.word, row.word.form, &row.arguments, &row.loops);
        element.name = row.name.to_string();
        all.push(element);
    }
    for force in model.forces.iter().filter(|force| scene.calls_for(force.effect)) {
        let mut element = element(&mut writer, force.word.word, force.word.form, &force.arguments, &force.loops);
        element.load = loading(&mut writer, force);
        all.push(element);
    }
    // an equation between coordinates has no place
    all.retain(|element| !element.points.is_empty() || !element.bodies.is_empty());
    for element in &mut all {
        let mut bodies = slots(&mut writer, &element.values());
        let fixed = element.points.iter().chain(&element.directions).filter_map(|fixed| fixed.body);
        bodies.extend(fixed.chain(element.bodies.iter().copied().flatten()));
        bodies.extend(element.load.iter().map(|(body, _)| *body));
        bodies.sort_unstable();
        bodies.dedup();
        element.slots = bodies;
    }
    all
}

fn element<'m>(
    writer: &mut Writer<'_>,
    word: &'static str,
    form: &'static [Part],
    of: &Arguments,
    loops: &'m [Loop],
) -> Element<'m> {
    let points = of.places.iter().map(|place| fixed(writer, place.body, [&place.x, &place.y]));
    let points = points.collect();
    let directions = of.directions.iter().map(|direction| fixed(writer, direction.body, [&direction.x, &direction.y]));
    let directions = directions.collect();
    let words = form.iter().find_map(|part| match part {
        Part::Settings(settings) => Some(*settings),
        _ => None,
    });
    let values = words.unwrap_or_default().iter().zip(&of.settings);
    let settings = values.filter_map(|(setting, value)| Some((setting.word, writer.write(value.as_ref()?))));
    let settings = settings.filter(|(_, value)| !value.is_zero()).collect();
    let bodies = of.bodies.clone();
    Element { word, name: String::new(), loops, slots: Vec::new(), points, directions, bodies, settings, load: None }
}

fn fixed(writer: &mut Writer<'_>, body: Option<BodyId>, coordinates: [&Expr; 2]) -> Fixed {
    Fixed { body, local: coordinates.map(|of| writer.write(of)), by_index: coordinates.map(Expr::reads_index) }
}

/// What a force does to the first of its bodies that can move; gravity acts on all bodies and is left out.
fn loading(writer: &mut Writer<'_>, force: &Force) -> Option<(BodyId, Loading)> {
    let of = &force.arguments;
    let mut load = Load::new(writer.symbols.n_coordinates());
    let place = |body, component| Coordinate { body, component }.place();
    if let Some(body) = of.places.iter().find_map(|place| place.body) {
        load.add(writer, force);
        let (generalised, _) = load.finish(writer);
        let force = [Component::X, Component::Y].map(|component| generalised[place(body, component)]);
        return Some((body, Loading::Force(force)));
    }
    let body = of.bodies.iter().copied().flatten().next()?;
    load.add(writer, force);
    let (generalised, _) = load.finish(writer);
    Some((body, Loading::Torque(generalised[place(body, Component::Phi)])))
}
