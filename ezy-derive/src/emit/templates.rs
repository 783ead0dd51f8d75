//! What a scene with arrays says of its items: equations by template, and the calls that describe a member.

use proc_macro2::TokenStream;
use quote::quote;

use super::equation::Equation;
use super::equations::{OfItems, indices};
use super::info::{formula, name_of, option};
use crate::mechanics::{
    EventKind, EventTemplate, ForceTemplate, OutputTemplate, PointTemplate, RowTemplate, Templates,
};
use crate::model::whole::WholeNames;
use crate::model::{BodyId, Component, Coordinate, Loop, Model, StartValue};
use crate::symbolic::print::print;

/// An item of the model file, repeated or not.
pub struct Template<'m> {
    pub loops: &'m [Loop],
    /// The bodies that it refers to.
    pub slots: &'m [BodyId],
    kind: Kind<'m>,
}

enum Kind<'m> {
    Bodies(usize),
    Row(&'m RowTemplate<'m>),
    Force(&'m ForceTemplate<'m>),
    Point(&'m PointTemplate<'m>),
    Output(&'m OutputTemplate<'m>),
    Event(&'m EventTemplate),
    Start,
}

/// Every item, in the order of the emitted table.
pub fn all<'m>(model: &Model, templates: &'m Templates<'m>) -> Vec<Template<'m>> {
    let bodies = (0..model.arrays.len()).map(|i| Template { loops: &[], slots: &[], kind: Kind::Bodies(i) });
    let rows =
        templates.rows.iter().map(|row| Template { loops: &row.row.loops, slots: &row.slots, kind: Kind::Row(row) });
    let forces = templates.forces.iter().map(|force| Template {
        loops: &force.force.loops,
        slots: &force.slots,
        kind: Kind::Force(force),
    });
    let points = templates.points.iter().map(|point| Template {
        loops: &point.point.loops,
        slots: &point.slots,
        kind: Kind::Point(point),
    });
    let outputs = templates.outputs.iter().map(|output| Template {
        loops: &output.output.loops,
        slots: &output.slots,
        kind: Kind::Output(output),
    });
    let events =
        templates.events.iter().map(|event| Template { loops: &[], slots: &event.slots, kind: Kind::Event(event) });
    let starts = templates.start.iter().map(|(given, _)| {
        let given: &StartValue = given;
        Template { loops: &given.loops, slots: std::slice::from_ref(&given.body), kind: Kind::Start }
    });
    bodies.chain(rows).chain(forces).chain(points).chain(outputs).chain(events).chain(starts).collect()
}

impl Template<'_> {
    /// Whether its members refer to bodies; arrays of bodies are described by themselves.
    pub fn is_repeated_item(&self) -> bool {
        !matches!(self.kind, Kind::Bodies(_))
    }

    /// The call that describes a member, which knows its indices `at` and its bodies `slots`.
    pub fn describe(&self, i: usize, templates: &Templates<'_>) -> TokenStream {
        match &self.kind {
            Kind::Bodies(_) | Kind::Force(_) | Kind::Event(_) | Kind::Start => quote!(),
            Kind::Row(_) => quote!(layout.rows(&Self::TEMPLATES[#i], at, &slots);),
            Kind::Point(point) => {
                let name = point.point.name.to_string();
                let place = point.point.place.body.and_then(|body| self.slots.iter().position(|slot| *slot == body));
                let body = option(place.map(|slot| quote!(slots[#slot])));
                quote!(layout.point(#name, at, #body);)
            }
            Kind::Output(output) => {
                let value = formula(&print(&templates.algebra, &templates.symbols, output.value));
                let (output, suffix) = (output.output, &output.output.suffix);
                let (name, unit, documentation) =
                    (name_of(&output.name.to_string()), &output.unit, &output.documentation);
                quote! {
                    const OUTPUT: ezy::OutputInfo = ezy::OutputInfo {
                        name: #name,
                        unit: #unit,
                        documentation: #documentation,
                        formula: #value,
                    };
                    layout.output(&OUTPUT, at, #suffix);
                }
            }
        }
    }

    /// Its equations, with its indices in them.
    pub fn equations(&self, of: &OfItems<'_>) -> Vec<Equation> {
        match &self.kind {
            Kind::Bodies(i) => of.of_bodies(&of.templates.masses[*i].1, &coordinates(of.model, *i)),
            Kind::Row(row) => of.of_row(row),
            Kind::Force(force) => of.of_force(force),
            Kind::Point(point) => of.of_values("position", &self.name(of.model), &point.position),
            Kind::Output(output) => of.of_values("value", &self.name(of.model), &[output.value]),
            Kind::Event(_) | Kind::Start => Vec::new(),
        }
    }

    /// `hinge pin, i in 1..n`
    pub fn title(&self, model: &Model) -> String {
        let (word, name) = (self.word(), self.name(model));
        let words = if name.is_empty() { word.to_owned() } else { format!("{word} {name}") };
        std::iter::once(words).chain(self.ranges(model)).collect::<Vec<_>>().join(", ")
    }

    fn word(&self) -> &'static str {
        match &self.kind {
            Kind::Bodies(_) => "body",
            Kind::Row(row) => row.row.word.word,
            Kind::Force(force) => force.force.word.word,
            Kind::Point(_) => "point",
            Kind::Output(_) => "output",
            Kind::Event(_) => "event",
            Kind::Start => "start",
        }
    }

    /// Empty for what has none.
    fn name(&self, model: &Model) -> String {
        match &self.kind {
            Kind::Bodies(i) => model.arrays[*i].name.to_string(),
            Kind::Row(row) => row.row.name.to_string(),
            Kind::Point(point) => point.point.name.to_string(),
            Kind::Output(output) => output.output.name.to_string(),
            Kind::Event(EventTemplate { event, .. }) => match &event.kind {
                EventKind::Declared { name, .. } => name.clone(),
                EventKind::Discontinuity | EventKind::Layer => String::new(),
            },
            Kind::Force(_) | Kind::Start => String::new(),
        }
    }

    fn ranges(&self, model: &Model) -> Vec<String> {
        match &self.kind {
            Kind::Bodies(i) => ranges(model, &model.arrays[*i].loops),
            _ => ranges(model, self.loops),
        }
    }

    /// The value of `TemplateInfo`.
    pub fn info(&self, of: &OfItems<'_>) -> TokenStream {
        let (model, word, name) = (of.model, self.word(), self.name(of.model));
        let (title, ranges) = (self.title(model), self.ranges(model));
        let rows = match &self.kind {
            Kind::Row(row) => rows(of, row),
            _ => Vec::new(),
        };
        let equations = self.equations(of);
        let equations = equations.iter().map(Equation::tokens);
        quote! {
            ezy::TemplateInfo {
                name: #name,
                word: #word,
                ranges: &[#(#ranges),*],
                title: #title,
                rows: &[#(#rows),*],
                equations: &[#(#equations),*],
            }
        }
    }
}

fn rows(of: &OfItems<'_>, template: &RowTemplate<'_>) -> Vec<TokenStream> {
    let constraints = &template.constraints;
    let (position, stem) = (template.is_position(), template.row.name.to_string());
    let row = |(i, row): (usize, &crate::mechanics::ScalarRow)| {
        let suffix = row.name.strip_prefix(&stem).unwrap_or_default();
        let name = name_of(&format!("{stem}{}{suffix}", indices(of.model, &template.row.loops)));
        let (kind, unit) = (row.kind, &row.unit);
        let constraint = formula(&of.print(if position { constraints.position[i] } else { constraints.velocity[i] }));
        let convective = formula(&of.print(constraints.convective[i]));
        let entries = constraints.jacobian[i].iter().map(|&(i, _)| {
            let Coordinate { body, component } = Coordinate::at(i);
            let slot = template.slots.iter().position(|slot| *slot == body).unwrap_or(0);
            let component = component as usize;
            quote!(ezy::SlotCoordinate { slot: #slot, component: #component })
        });
        quote! {
            ezy::RowTemplate {
                suffix: #suffix,
                row: ezy::RowInfo {
                    name: #name,
                    kind: #kind,
                    multiplier_unit: #unit,
                    constraint: #constraint,
                    convective_term: #convective,
                },
                position: #position,
                entries: &[#(#entries),*],
            }
        }
    };
    constraints.rows.iter().enumerate().map(row).collect()
}

/// `body[i].x` and the others of a body of an array.
fn coordinates(model: &Model, i: usize) -> Vec<String> {
    let array = &model.arrays[i];
    let body = format!("{}{}", array.name, indices(model, &array.loops));
    Component::ALL.map(|component| format!("{body}.{}", component.name(false))).to_vec()
}

/// `i in 1..n`
fn ranges(model: &Model, loops: &[Loop]) -> Vec<String> {
    let counts = count_names(model);
    let names = WholeNames { counts: &counts, indices: &model.indices };
    let range = |around: &Loop| {
        format!("{} in {}..{}", model.indices[around.index.0], around.from.text(&names), around.to.text(&names))
    };
    loops.iter().map(range).collect()
}

fn count_names(model: &Model) -> Vec<String> {
    model.counts.iter().map(|count| count.name.to_string()).collect()
}
