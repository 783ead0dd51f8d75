//! The type of a scene with arrays: kernels that loop over the members of each item, and the loops that describe a
//! run with given counts.
//!
//! A pass of a loop knows where the bodies that it refers to stand (`slots`), and counts on where its results go.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::kernel::{self, Body};
use super::templates::{self, Template};
use super::{constants, info, page, scene, scene_type};
use crate::mechanics::{Group, Templates};
use crate::model::whole::Whole;
use crate::model::{Array, BodyId, Loop, Model, Scene, Slot};
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::{SumId, Symbol};

/// The struct, its defaults and its equations.
pub fn items(model: &Model, scene: &Scene, templates: &Templates<'_>) -> TokenStream {
    let mut pool = ConstantPool::default();
    let mut emitter = Emitter { model, templates, pool: &mut pool };
    let methods = emitter.methods();
    let n_inputs = templates.inputs.len();
    let n_constants = pool.coefficients().len();
    let n_fixed = n_inputs + n_constants;
    let constants = constants::statements(model, &templates.algebra.coefficients, &pool, n_inputs);
    let type_name = scene_type(scene);
    let structure = structure(model, scene, templates, &type_name);
    let parameters: Vec<&Ident> = templates.parameters.iter().map(|id| &model.parameters[id.0].name).collect();
    let (parameter, set_parameter) = scene::parameter_access(&parameters);
    let counts: Vec<&Ident> = model.counts.iter().map(|count| &count.name).collect();
    let places: Vec<usize> = (0..counts.len()).collect();
    let all = templates::all(model, templates);
    let infos = all.iter().map(|template| template.info(model, templates));
    let fixed = fixed(model, scene, templates, n_constants);
    let describe = describe(model, templates, &all);
    quote! {
        #structure

        impl #type_name {
            /// What is known of the scene when it is compiled: everything but its sizes.
            const FIXED: ::ezy_core::model::SceneInfo = #fixed;

            const TEMPLATES: &'static [::ezy_core::model::TemplateInfo] = &[#(#infos),*];

            fn describe(&self, layout: &mut ::ezy_core::layout::Layout) {
                #describe
            }
        }

        #[automatically_derived]
        impl ::ezy_core::model::Scene for #type_name {
            fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
                static KNOWN: ::ezy_core::layout::Known = ::ezy_core::layout::Known::new();
                KNOWN.info(&Self::FIXED, &[#(self.#counts),*], |layout| self.describe(layout))
            }
            fn count(&self, index: usize) -> usize {
                match index { #(#places => self.#counts,)* _ => 0 }
            }
            fn set_count(&mut self, index: usize, value: usize) {
                match index { #(#places => self.#counts = value,)* _ => {} }
            }
            fn parameter(&self, index: usize) -> f64 {
                #parameter
            }
            fn set_parameter(&mut self, index: usize, value: f64) {
                #set_parameter
            }
            fn constants(&self, c: &mut [f64]) {
                let c = ::ezy_core::kernel::array_mut::<#n_fixed>(c);
                #constants
            }
            #methods
        }
    }
}

fn structure(model: &Model, scene: &Scene, templates: &Templates<'_>, type_name: &Ident) -> TokenStream {
    let parameters: Vec<_> = templates.parameters.iter().map(|id| &model.parameters[id.0]).collect();
    let counts = model.counts.iter().map(|count| {
        let name = &count.name;
        let documentation = match count.documentation.trim() {
            "" => format!("Count `{name}`; default {}.", count.default),
            text => format!("{text}; default {}.", count.default),
        };
        quote!(#[doc = #documentation] pub #name: usize)
    });
    let fields = counts.chain(parameters.iter().map(|parameter| scene::field(parameter)));
    let count_defaults = model.counts.iter().map(|count| {
        let (name, value) = (&count.name, Literal::usize_unsuffixed(usize::try_from(count.default).unwrap_or(1)));
        quote!(#name: #value)
    });
    let defaults = parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, parameter.default);
        quote!(#name: #value)
    });
    let defaults = count_defaults.chain(defaults);
    let title = scene::title(model, scene);
    let page = page::repeated(model, templates);
    quote! {
        #[doc = #title]
        #[doc = ""]
        #page
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #type_name {
            #(#fields),*
        }

        impl ::core::default::Default for #type_name {
            fn default() -> Self {
                Self { #(#defaults),* }
            }
        }
    }
}

/// The part of the description that does not depend on counts.
fn fixed(model: &Model, scene: &Scene, templates: &Templates<'_>, n_constants: usize) -> TokenStream {
    let (model_name, name, documentation) = (model.name.to_string(), scene.name.to_string(), &scene.documentation);
    let parameters = info::parameters(model, &templates.parameters, &templates.symbols);
    let inputs = info::inputs(model, &templates.inputs, &templates.symbols);
    let effects = info::effects(model, &templates.groups);
    let until = scene.until_s;
    let counts = model.counts.iter().map(|count| {
        let (name, default, documentation) = (count.name.to_string(), count.default as usize, &count.documentation);
        quote!(::ezy_core::model::CountInfo { name: #name, default: #default, documentation: #documentation })
    });
    let defaults = model.counts.iter().map(|count| count.default as usize);
    quote! {
        ::ezy_core::model::SceneInfo {
            model: #model_name,
            name: #name,
            documentation: #documentation,
            bodies: &[],
            coordinates: &[],
            points: &[],
            rows: &[],
            n_position_rows: 0,
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            outputs: &[],
            effects: &[#(#effects),*],
            until_s: #until,
            n_constants: #n_constants,
            jacobian: ::ezy_core::model::SparsityPattern { starts: &[0], columns: &[] },
            jacobian_entries: &[],
            mass_entries: &[],
            force_entries: &[],
            potential_energy: ::ezy_core::model::Formula { text: "0", latex: "0", mathml: "<mn>0</mn>" },
            abbreviations: &[],
            elimination: &[],
            acceleration_operations: ::ezy_core::model::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            correction_operations: ::ezy_core::model::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            repeats: ::core::option::Option::Some(::ezy_core::model::Repeats {
                counts: &[#(#counts),*],
                values: &[#(#defaults),*],
                templates: Self::TEMPLATES,
                fault: ::core::option::Option::None,
            }),
        }
    }
}

/// The loops that describe a run: bodies, then every item with the bodies that it refers to.
fn describe(model: &Model, templates: &Templates<'_>, all: &[Template<'_>]) -> TokenStream {
    let arrays = model.arrays.iter().map(|array| {
        let (name, lengths, bodies) = (array.name.to_string(), about("lengths", array), about("bodies", array));
        let values = array.lengths.iter().map(|length| whole(model, length));
        quote! {
            let #lengths: &[usize] = &[#(usize::try_from(#values).unwrap_or(0)),*];
            let #bodies = layout.bodies(#name, #lengths);
        }
    });
    let members = all.iter().enumerate().filter(|(_, template)| template.is_repeated_item()).map(|(i, template)| {
        let at = template.loops.iter().map(|range| variable(model, range));
        let slots = template.slots.iter().map(|body| {
            let Slot { array, index } = &model.bodies[body.0].slot;
            let (bodies, index) =
                (about("bodies", &model.arrays[*array]), index.iter().map(|index| whole(model, index)));
            quote!(layout.member(&Self::TEMPLATES[#i], at, #bodies, &[#(#index),*]))
        });
        let describe = template.describe(i, templates);
        let n_slots = Literal::usize_unsuffixed(template.slots.len());
        let body = quote! {
            let at: &[i64] = &[#(#at),*];
            let slots: [usize; #n_slots] = [#(#slots),*];
            #describe
        };
        looped(model, template.loops, &|from, to| quote!(layout.range(#from, #to)), body)
    });
    quote!(#(#arrays)* #(#members)*)
}

/// The pass of a `for`, in all of its passes.
fn looped(
    model: &Model,
    loops: &[Loop],
    range: &dyn Fn(TokenStream, TokenStream) -> TokenStream,
    body: TokenStream,
) -> TokenStream {
    if loops.is_empty() {
        return quote!({ #body });
    }
    loops.iter().rev().fold(body, |inside, around| {
        let variable = variable(model, around);
        let range = range(whole(model, &around.from), whole(model, &around.to));
        quote!(for #variable in #range { #inside })
    })
}

/// A whole number as an `i64`.
fn whole(model: &Model, value: &Whole) -> TokenStream {
    match value {
        Whole::Number(number) => {
            let number = Literal::i64_unsuffixed(*number);
            quote!(#number)
        }
        Whole::Count(id) => {
            let field = &model.counts[id.0].name;
            quote!((self.#field as i64))
        }
        Whole::Index(id) => {
            let variable = format_ident!("at_{}", model.indices[id.0], span = Span::call_site());
            quote!(#variable)
        }
        Whole::Sum(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a + #b))
        }
        Whole::Difference(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a - #b))
        }
        Whole::Product(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a * #b))
        }
    }
}

/// How many bodies an array has, as an `i64`.
fn members(model: &Model, array: &Array) -> TokenStream {
    let mut lengths = array.lengths.iter().map(|length| whole(model, length));
    let first = lengths.next().unwrap_or_else(|| quote!(1));
    quote!(#first #(* #lengths)*)
}

fn variable(model: &Model, around: &Loop) -> TokenStream {
    whole(model, &Whole::Index(around.index))
}

/// Name in the emitted code of something about an array: `first_link`.
fn about(what: &str, array: &Array) -> Ident {
    format_ident!("{what}_{}", array.name, span = Span::call_site())
}

struct Emitter<'a> {
    model: &'a Model,
    templates: &'a Templates<'a>,
    pool: &'a mut ConstantPool,
}

/// What a kernel writes for a member: expressions, and where they go.
struct Written<'t> {
    loops: &'t [Loop],
    slots: &'t [BodyId],
    sums: Vec<SumId>,
    /// From the expressions to statements.
    put: Box<dyn Fn(Vec<TokenStream>) -> TokenStream + 't>,
}

impl Emitter<'_> {
    fn methods(&mut self) -> TokenStream {
        let templates = self.templates;
        let mass_matrix = self.mass_matrix();
        let rows = || templates.rows.iter();
        let stacked = |sums: &dyn Fn(&crate::mechanics::RowTemplate<'_>) -> Vec<SumId>, only_positions: bool| {
            let chosen = rows().filter(move |row| row.is_position() || !only_positions);
            chosen.map(|row| stack(&row.row.loops, &row.slots, sums(row))).collect::<Vec<_>>()
        };
        let position = stacked(&|row| row.constraints.position.clone(), true);
        let velocity = stacked(&|row| row.constraints.velocity.clone(), false);
        let jacobian =
            stacked(&|row| row.constraints.jacobian.iter().flatten().map(|&(_, entry)| entry).collect(), false);
        let convective = stacked(&|row| row.constraints.convective.clone(), false);
        let points = templates.points.iter();
        let points = points.map(|point| stack(&point.point.loops, &point.slots, point.position.to_vec())).collect();
        let outputs = templates.outputs.iter();
        let outputs = outputs.map(|output| stack(&output.output.loops, &output.slots, vec![output.value])).collect();
        let forces = templates.forces.iter().map(|force| Written {
            loops: &force.force.loops,
            slots: &force.slots,
            sums: force.entries.iter().map(|&(_, entry)| entry).collect(),
            put: Box::new(|values| {
                let places = force.entries.iter().map(|&(i, _)| coordinate(&force.slots, i));
                quote!(#(out[#places] += #values;)*)
            }),
        });
        let position = self.kernel(quote!(), position);
        let velocity = self.kernel(quote!(), velocity);
        let jacobian = self.kernel(quote!(), jacobian);
        let convective = self.kernel(quote!(), convective);
        let force = self.kernel(quote!(out.fill(0.0);), forces.collect());
        let points = self.kernel(quote!(), points);
        let outputs = self.kernel(quote!(), outputs);
        let power = self.power();
        let potential = self.potential();
        let start = self.start();
        quote! {
            fn mass_matrix(&self, c: &[f64], m: &mut [f64]) {
                #mass_matrix
            }
            fn position_constraint(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
                #position
            }
            fn velocity_constraint(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
                #velocity
            }
            fn velocity_jacobian(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
                #jacobian
            }
            fn convective_term(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
                #convective
            }
            fn applied_force(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
                #force
            }
            fn power(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
                #power
            }
            fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
                #potential
            }
            fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
                #points
            }
            fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
                #outputs
            }
            fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
                #start
            }
        }
    }

    fn mass_matrix(&mut self) -> TokenStream {
        let arrays = self.model.arrays.iter().zip(&self.templates.masses).map(|(array, masses)| {
            let Body { statements, outputs } = self.lowered(masses, &[], &no_other);
            let members = members(self.model, array);
            quote! {
                for _ in 0..#members {
                    #statements
                    #(m[place] = #outputs; place += 1;)*
                }
            }
        });
        let arrays: Vec<TokenStream> = arrays.collect();
        quote!(let mut place = 0; #(#arrays)*)
    }

    /// A kernel that writes `out`.
    fn kernel(&mut self, opening: TokenStream, written: Vec<Written<'_>>) -> TokenStream {
        let firsts = self.firsts();
        let loops: Vec<TokenStream> = written.iter().map(|written| self.written(written, &no_other)).collect();
        quote!(#firsts let mut place = 0; #opening #(#loops)*)
    }

    fn written(&mut self, written: &Written<'_>, other: &dyn Fn(Symbol) -> TokenStream) -> TokenStream {
        let Body { statements, outputs } = self.lowered(&written.sums, written.slots, other);
        let slots = self.slots(written.slots);
        let put = (written.put)(outputs);
        let body = quote!(#slots #statements #put);
        looped(self.model, written.loops, &|from, to| quote!(#from..#to), body)
    }

    /// Powers by group; the rows that move with time need to know where their multipliers stand.
    fn power(&mut self) -> TokenStream {
        let templates = self.templates;
        let firsts = self.firsts();
        let group = |group: Group| templates.groups.iter().position(|other| *other == group).unwrap_or(0);
        let forces: Vec<TokenStream> = templates
            .forces
            .iter()
            .filter(|force| !force.power.is_zero())
            .map(|force| {
                let i = group(force.group);
                let add = move |values: Vec<TokenStream>| quote!(#(out[#i] += #values;)*);
                let (loops, slots) = (&force.force.loops[..], &force.slots[..]);
                self.written(&Written { loops, slots, sums: vec![force.power], put: Box::new(add) }, &no_other)
            })
            .collect();
        let n_counted = templates.rows.iter().rposition(|row| !row.multipliers.is_empty()).map_or(0, |last| last + 1);
        let rows: Vec<TokenStream> = templates.rows[..n_counted]
            .iter()
            .map(|row| {
                let (i, n_rows) = (group(Group::Drives), row.constraints.rows.len());
                let add = move |values: Vec<TokenStream>| quote!(#(out[#i] += #values;)* place += #n_rows;);
                let sums = if row.multipliers.is_empty() { Vec::new() } else { vec![row.power] };
                let (loops, slots) = (&row.row.loops[..], &row.slots[..]);
                let multiplier = |symbol: Symbol| {
                    let own = row.multipliers.iter().find(|(other, _)| *other == symbol).map_or(0, |(_, own)| *own);
                    quote!(lambda[place + #own])
                };
                self.written(&Written { loops, slots, sums, put: Box::new(add) }, &multiplier)
            })
            .collect();
        quote!(#firsts out.fill(0.0); #(#forces)* let mut place = 0; #(#rows)*)
    }

    fn potential(&mut self) -> TokenStream {
        let templates = self.templates;
        let firsts = self.firsts();
        let parts: Vec<TokenStream> = templates
            .forces
            .iter()
            .filter(|force| !force.potential.is_zero())
            .map(|force| {
                let add = |values: Vec<TokenStream>| quote!(#(total += #values;)*);
                let (loops, slots) = (&force.force.loops[..], &force.slots[..]);
                self.written(&Written { loops, slots, sums: vec![force.potential], put: Box::new(add) }, &no_other)
            })
            .collect();
        quote!(#firsts let mut total = 0.0; #(#parts)* total)
    }

    fn start(&mut self) -> TokenStream {
        let firsts = self.firsts();
        let gives: Vec<TokenStream> = self
            .templates
            .start
            .iter()
            .map(|(given, value)| {
                let slots = [given.body];
                let give = move |values: Vec<TokenStream>| {
                    let place = coordinate(&[given.body], 3 * given.body.0 + given.component as usize);
                    if given.rate {
                        quote!(#(start.give_velocity(#place, #values);)*)
                    } else {
                        quote!(#(start.give_position(#place, #values);)*)
                    }
                };
                let loops = &given.loops[..];
                self.written(&Written { loops, slots: &slots, sums: vec![*value], put: Box::new(give) }, &no_other)
            })
            .collect();
        quote!(#firsts #(#gives)*)
    }

    fn lowered(&mut self, sums: &[SumId], slots: &[BodyId], other: &dyn Fn(Symbol) -> TokenStream) -> Body {
        let symbols = &self.templates.symbols;
        let mut lowering = Lowering::new(&self.templates.algebra, self.pool);
        for &sum in sums {
            let value = lowering.lower(sum);
            lowering.program.push_output(value);
        }
        let mut program = lowering.program;
        program.settle_signs();
        let index_or_other = |symbol: Symbol| match symbols.index_of(symbol) {
            Some(id) => {
                let value = whole(self.model, &Whole::Index(id));
                quote!((#value as f64))
            }
            None => other(symbol),
        };
        kernel::body_at(&program, symbols, &|i| coordinate(slots, i), &index_or_other)
    }

    /// Index of the first body of each array.
    fn firsts(&self) -> TokenStream {
        let mut behind = quote!(0);
        let firsts = self.model.arrays.iter().map(|array| {
            let first = about("first", array);
            let declared = quote!(let #first: i64 = #behind;);
            let members = members(self.model, array);
            behind = quote!(#first + #members);
            declared
        });
        firsts.collect()
    }

    /// Index of the first coordinate of each body that a pass refers to.
    fn slots(&self, slots: &[BodyId]) -> TokenStream {
        let places = slots.iter().map(|body| {
            let Slot { array, index } = &self.model.bodies[body.0].slot;
            let lengths = &self.model.arrays[*array].lengths;
            let place = index.iter().zip(lengths).fold(None, |place: Option<TokenStream>, (index, length)| {
                let (index, length) = (whole(self.model, index), whole(self.model, length));
                Some(match place {
                    None => index,
                    Some(place) => quote!(((#place) * #length + #index)),
                })
            });
            let first = about("first", &self.model.arrays[*array]);
            let place = place.map(|place| quote!(+ #place));
            quote!(3 * (#first #place) as usize)
        });
        let n = Literal::usize_unsuffixed(slots.len());
        quote!(let slots: [usize; #n] = [#(#places),*];)
    }
}

/// Expressions one after the other.
fn stack<'t>(loops: &'t [Loop], slots: &'t [BodyId], sums: Vec<SumId>) -> Written<'t> {
    Written { loops, slots, sums, put: Box::new(|values| quote!(#(out[place] = #values; place += 1;)*)) }
}

/// Place in q of a coordinate of a slot.
fn coordinate(slots: &[BodyId], i: usize) -> TokenStream {
    let slot = slots.iter().position(|body| body.0 == i / 3).unwrap_or(0);
    let [slot, component] = [slot, i % 3].map(Literal::usize_unsuffixed);
    quote!(slots[#slot] + #component)
}

/// For kernels that read nothing besides.
fn no_other(_: Symbol) -> TokenStream {
    quote!(f64::NAN)
}
