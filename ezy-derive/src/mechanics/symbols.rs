//! The symbols of a scene: time, coordinates, velocities, and values named on the way.

use proc_macro2::Ident;

use crate::model::whole::{Whole, WholeNames};
use crate::model::{BodyId, Component, Coordinate, DeclaredSwitch, InputId, Model, Switch};
use crate::symbolic::coefficient::{Coefficient, CoefficientId};
use crate::symbolic::print::{Names, Printed};
use crate::symbolic::spelling;
use crate::symbolic::{SumId, Symbol};

/// Symbols in fixed places: time, then `n_q` coordinates, `n_q` velocities, the inputs, the first-order states, then what a kernel
/// names.
#[derive(Debug)]
pub struct Symbols {
    coordinates: Vec<Printed>,
    velocities: Vec<Printed>,
    inputs: Vec<(InputId, Printed)>,
    /// How many of them are first-order states, the last ones.
    n_states: usize,
    /// Parameters, then whole numbers ([`Model::whole`]), then switches.
    parameters: Vec<Printed>,
    switches: Vec<DeclaredSwitch>,
    lets: Vec<Let>,
    named: Vec<String>,
}

/// A component of a `let` value.
#[derive(Debug)]
pub struct Let {
    pub name: Printed,
    pub value: SumId,
    /// The value, when it is computed from parameters.
    pub coefficient: Option<Coefficient>,
}

/// What a symbol stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    Time,
    Coordinate(usize),
    Velocity(usize),
    Input(usize),
    /// Index into the values that a kernel names or reads besides.
    Named(usize),
}

impl Symbols {
    /// The symbols of a scene with these inputs, behind which its first-order states stand, and with these switches.
    pub fn new(model: &Model, inputs: &[InputId], switches: Vec<DeclaredSwitch>) -> Self {
        let (mut coordinates, mut velocities) = (Vec::new(), Vec::new());
        for body in &model.bodies {
            let body = body.name.clone();
            for component in Component::ALL {
                let [position, velocity] = [false, true].map(|rate| component.name(rate));
                coordinates.push(spelling::of_body(&format!("{body}.{position}"), position, &body, false));
                velocities.push(spelling::of_body(&format!("{body}.{velocity}"), position, &body, true));
            }
        }
        let counts = model.counts.iter().map(|count| &count.name);
        let parameters = model.parameters.iter().map(|p| &p.name).chain(counts).map(ToString::to_string);
        let parameters = parameters.chain(model.indices.iter().cloned()).map(|name| spelling::name(&name));
        let parameters = parameters.chain(model.quotients.iter().map(|of| quotient(model, of)));
        let parameters = parameters.chain(switches.iter().map(|switch| spelling::name(&switch.name))).collect();
        let n_states = inputs.iter().filter(|id| model.inputs[id.0].rate.is_some()).count();
        let inputs = inputs.iter().map(|&id| (id, spelling::name(&model.inputs[id.0].name.to_string()))).collect();
        Self { coordinates, velocities, inputs, n_states, parameters, switches, lets: Vec::new(), named: Vec::new() }
    }

    pub fn name_lets(&mut self, lets: Vec<Let>) {
        self.lets = lets;
    }

    pub fn lets(&self) -> &[Let] {
        &self.lets
    }

    /// The `let` that computes a coefficient, or its negative, from parameters.
    pub fn let_of(&self, id: CoefficientId) -> Option<&Let> {
        self.lets.iter().find(|of| of.coefficient.is_some_and(|k| k.id == id))
    }

    /// What says how rows take part that are switched on and off.
    pub fn switches(&self) -> &[DeclaredSwitch] {
        &self.switches
    }

    /// A switch of a row, by its place behind parameters and whole numbers.
    pub fn switch(&self, of: &Ident, switch: Switch) -> Option<usize> {
        let i = self.switches.iter().position(|declared| declared.switch == switch && *of == declared.of)?;
        Some(self.parameters.len() - self.switches.len() + i)
    }

    pub fn n_coordinates(&self) -> usize {
        self.coordinates.len()
    }

    pub fn coordinate(&self, body: BodyId, component: Component) -> Symbol {
        self.coordinate_at(Coordinate { body, component }.place())
    }

    pub fn velocity(&self, body: BodyId, component: Component) -> Symbol {
        self.velocity_at(Coordinate { body, component }.place())
    }

    pub fn coordinate_at(&self, i: usize) -> Symbol {
        symbol(1 + i)
    }

    pub fn velocity_at(&self, i: usize) -> Symbol {
        symbol(1 + self.n_coordinates() + i)
    }

    /// The symbol of an input or a first-order state; `None` in scenes that do not call for its effect.
    pub fn input(&self, id: InputId) -> Option<Symbol> {
        let i = self.inputs.iter().position(|(other, _)| *other == id)?;
        Some(symbol(1 + 2 * self.n_coordinates() + i))
    }

    pub fn n_inputs(&self) -> usize {
        self.inputs.len()
    }

    /// The first-order states in their order.
    pub fn states(&self) -> impl Iterator<Item = Symbol> + use<> {
        let first = 1 + 2 * self.n_coordinates() + self.n_inputs() - self.n_states;
        (first..first + self.n_states).map(symbol)
    }

    /// The place in z of the first-order state that a symbol stands for.
    pub fn state_of(&self, symbol: Symbol) -> Option<usize> {
        self.states().position(|state| state == symbol)
    }

    /// The place in q of the coordinate that a symbol stands for.
    pub fn coordinate_of(&self, symbol: Symbol) -> Option<usize> {
        match self.meaning(symbol) {
            Meaning::Coordinate(i) => Some(i),
            _ => None,
        }
    }

    /// The place in v of the velocity that a symbol stands for.
    pub fn velocity_of(&self, symbol: Symbol) -> Option<usize> {
        match self.meaning(symbol) {
            Meaning::Velocity(i) => Some(i),
            _ => None,
        }
    }

    /// A new symbol for a value that a kernel computes or reads.
    pub fn new_named(&mut self, name: String) -> Symbol {
        self.named.push(name);
        symbol(self.named.len() + 2 * self.n_coordinates() + self.n_inputs())
    }

    pub fn meaning(&self, symbol: Symbol) -> Meaning {
        let (i, n) = (symbol.0 as usize, self.n_coordinates());
        match i {
            0 => Meaning::Time,
            _ if i <= n => Meaning::Coordinate(i - 1),
            _ if i <= 2 * n => Meaning::Velocity(i - 1 - n),
            _ if i <= 2 * n + self.n_inputs() => Meaning::Input(i - 1 - 2 * n),
            _ => Meaning::Named(i - 1 - 2 * n - self.n_inputs()),
        }
    }

    /// Name of a symbol in the emitted code.
    pub fn code_name(&self, symbol: Symbol) -> String {
        match self.meaning(symbol) {
            Meaning::Time => "t".to_owned(),
            Meaning::Coordinate(i) => identifier(&self.coordinates[i].text),
            Meaning::Velocity(i) => identifier(&self.velocities[i].text),
            Meaning::Input(i) => self.inputs[i].1.text.clone(),
            Meaning::Named(i) => self.named[i].clone(),
        }
    }

    pub fn coordinate_names(&self) -> &[Printed] {
        &self.coordinates
    }

    pub fn velocity_names(&self) -> &[Printed] {
        &self.velocities
    }
}

impl Names for Symbols {
    fn symbol(&self, symbol: Symbol) -> Printed {
        match self.meaning(symbol) {
            Meaning::Time => Printed::atom("t", "t", "<mi>t</mi>"),
            Meaning::Coordinate(i) => self.coordinates[i].clone(),
            Meaning::Velocity(i) => self.velocities[i].clone(),
            Meaning::Input(i) => self.inputs[i].1.clone(),
            Meaning::Named(i) => spelling::name(&self.named[i]),
        }
    }

    fn parameter(&self, index: usize) -> Printed {
        self.parameters[index].clone()
    }

    fn coefficient(&self, id: CoefficientId) -> Option<(bool, Printed)> {
        let of = self.let_of(id)?;
        Some((of.coefficient.is_some_and(|k| k.negative), of.name.clone()))
    }
}

/// `floor(n/2)`
fn quotient(model: &Model, whole: &Whole) -> Printed {
    let counts: Vec<String> = model.counts.iter().map(|count| count.name.to_string()).collect();
    let text = whole.text(&WholeNames { counts: &counts, indices: &model.indices });
    let latex = format!("\\lfloor {} \\rfloor", text.replace('*', "\\,").replace('_', "\\_"));
    Printed::atom(format!("floor({text})"), latex, format!("<mrow><mo>⌊</mo><mtext>{text}</mtext><mo>⌋</mo></mrow>"))
}

/// `seat.x` as `seat_x`, `link[i-1].x` as `link_i_1_x`.
fn identifier(text: &str) -> String {
    let parts = text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join("_")
}

fn symbol(i: usize) -> Symbol {
    Symbol(u32::try_from(i).unwrap_or(u32::MAX))
}
