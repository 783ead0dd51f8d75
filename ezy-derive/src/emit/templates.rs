//! What a scene with arrays says of its items: equations by template, and the calls that describe a member.

use proc_macro2::TokenStream;
use quote::quote;

use super::info::{formula, option};
use crate::mechanics::{
    EventKind, EventTemplate, ForceTemplate, OutputTemplate, PointTemplate, RowTemplate, Templates,
};
use crate::model::whole::WholeNames;
use crate::model::{BodyId, Component, Coordinate, EffectId, Loop, Model, StartValue};
use crate::symbolic::SumId;
use crate::symbolic::print::print;
use crate::symbolic::spelling;

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
                let (name, unit, documentation) = (&output.name, &output.unit, &output.documentation);
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

    /// The value of `TemplateInfo`.
    pub fn info(&self, model: &Model, templates: &Templates<'_>) -> TokenStream {
        let printed = |sum| formula(&print(&templates.algebra, &templates.symbols, sum));
        let on_slots = |entries: &[(usize, SumId)]| {
            let entries = entries.iter().map(|&(i, entry)| {
                let Coordinate { body, component } = Coordinate::at(i);
                let slot = self.slots.iter().position(|slot| *slot == body).unwrap_or(0);
                let (component, symbol) = (component as usize, formula(&templates.symbols.coordinate_names()[i]));
                let entry = printed(entry);
                quote! {
                    (
                        ezy::SlotCoordinate { slot: #slot, component: #component, symbol: #symbol },
                        #entry,
                    )
                }
            });
            quote!(&[#(#entries),*])
        };
        let nothing = || (quote!(&[]), quote!(&[]), quote!(&[]));
        let (name, word, effect, (rows, forces, masses)) = match &self.kind {
            Kind::Bodies(i) => {
                let entries = masses(model, *i, &templates.masses[*i], &printed);
                (model.arrays[*i].name.to_string(), "body", None, (quote!(&[]), quote!(&[]), entries))
            }
            Kind::Row(row) => {
                let rows = rows(model, row, on_slots, printed);
                let entries = (quote!(&[#(#rows),*]), quote!(&[]), quote!(&[]));
                (row.row.name.to_string(), row.row.word.word, row.row.effect, entries)
            }
            Kind::Force(force) => {
                let entries = (quote!(&[]), on_slots(&force.entries), quote!(&[]));
                (String::new(), force.force.word.word, force.force.effect, entries)
            }
            Kind::Point(point) => (point.point.name.to_string(), "point", None, nothing()),
            Kind::Output(output) => (output.output.name.clone(), "output", output.output.effect, nothing()),
            Kind::Event(event) => {
                let name = match &event.event.kind {
                    EventKind::Declared { name, .. } => name.clone(),
                    EventKind::Discontinuity => String::new(),
                };
                (name, "event", None, nothing())
            }
            Kind::Start => (String::new(), "start", None, nothing()),
        };
        let ranges = match &self.kind {
            Kind::Bodies(i) => lengths(model, *i),
            _ => ranges(model, self.loops),
        };
        let effect = option(effect.map(|effect: EffectId| model.effects[effect.0].name.to_string()));
        quote! {
            ezy::TemplateInfo {
                name: #name,
                word: #word,
                ranges: &[#(#ranges),*],
                effect: #effect,
                rows: #rows,
                forces: #forces,
                masses: #masses,
            }
        }
    }
}

fn rows(
    model: &Model,
    template: &RowTemplate<'_>,
    on_slots: impl Fn(&[(usize, SumId)]) -> TokenStream,
    printed: impl Fn(SumId) -> TokenStream,
) -> Vec<TokenStream> {
    let constraints = &template.constraints;
    let (position, stem) = (template.is_position(), template.row.name.to_string());
    let row = |(i, row): (usize, &crate::mechanics::ScalarRow)| {
        let suffix = row.name.strip_prefix(&stem).unwrap_or_default();
        let name = format!("{stem}{}{suffix}", indices(model, &template.row.loops));
        let (kind, unit) = (row.kind, &row.unit);
        let constraint = printed(if position { constraints.position[i] } else { constraints.velocity[i] });
        let convective = printed(constraints.convective[i]);
        let entries = on_slots(&constraints.jacobian[i]);
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
                entries: #entries,
            }
        }
    };
    constraints.rows.iter().enumerate().map(row).collect()
}

/// Names of the indices of an array, for its own equations.
const INDICES: [&str; 4] = ["i", "j", "k", "l"];

fn masses(model: &Model, i: usize, masses: &[SumId], printed: &dyn Fn(SumId) -> TokenStream) -> TokenStream {
    let array = &model.arrays[i];
    let indices: Vec<&str> = INDICES.iter().copied().cycle().take(array.lengths.len()).collect();
    let body = match indices.is_empty() {
        true => array.name.to_string(),
        false => format!("{}[{}]", array.name, indices.join(",")),
    };
    let entries = Component::ALL.into_iter().zip(masses).map(|(component, &mass)| {
        let (component, letter) = (component as usize, component.name(false));
        let symbol = formula(&spelling::of_body(&format!("{body}.{letter}"), letter, &body, false));
        let mass = printed(mass);
        quote!((ezy::SlotCoordinate { slot: 0, component: #component, symbol: #symbol }, #mass))
    });
    quote!(&[#(#entries),*])
}

/// `i in 0..n` of an array of bodies.
pub fn lengths(model: &Model, i: usize) -> Vec<String> {
    let counts = count_names(model);
    let names = WholeNames { counts: &counts, indices: &model.indices };
    let lengths = model.arrays[i].lengths.iter().zip(INDICES.iter().cycle());
    lengths.map(|(length, index)| format!("{index} in 0..{}", length.text(&names))).collect()
}

/// `i in 1..n`
pub fn ranges(model: &Model, loops: &[Loop]) -> Vec<String> {
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

/// `[i]`, or nothing outside any `for`.
pub fn indices(model: &Model, loops: &[Loop]) -> String {
    let names: Vec<&str> = loops.iter().map(|around| model.indices[around.index.0].as_str()).collect();
    if names.is_empty() { String::new() } else { format!("[{}]", names.join(",")) }
}
