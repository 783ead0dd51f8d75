//! Kernels that loop over the members of each item.
//!
//! A pass of a loop knows where the bodies that it refers to stand (`slots`), and counts on where its results go (`place`).

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::loops::{about, looped, members, whole};
use crate::emit::kernel::{self, Body, Numbers};
use crate::emit::scene::give;
use crate::mechanics::{Group, RowTemplate, Templates};
use crate::model::whole::Whole;
use crate::model::{BodyId, Loop, Model, Slot};
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::{SumId, Symbol};

/// Writes the kernels of a scene.
pub struct Emitter<'a> {
    pub model: &'a Model,
    pub templates: &'a Templates<'a>,
    pub pool: &'a mut ConstantPool,
}

/// What a kernel writes for a member: expressions, and where they go.
pub struct Written<'t> {
    pub loops: &'t [Loop],
    pub slots: &'t [BodyId],
    pub sums: Vec<SumId>,
    /// From the expressions to statements.
    pub put: Box<dyn Fn(Vec<TokenStream>) -> TokenStream + 't>,
}

/// The methods that read the vector of constants, by trait.
pub struct Methods {
    pub equations: TokenStream,
    pub scene: TokenStream,
    pub events: Option<TokenStream>,
}

impl Emitter<'_> {
    pub fn methods(&mut self) -> Methods {
        let templates = self.templates;
        let mass_matrix = self.mass_matrix();
        let rows = || templates.rows.iter();
        let stacked = |sums: &dyn Fn(&RowTemplate<'_>) -> Vec<SumId>, only_positions: bool| {
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
                let places: Vec<TokenStream> = places.collect();
                quote!(#(out[#places] = out[#places] + #values;)*)
            }),
        });
        let position = self.kernel(Numbers::Any, quote!(), position);
        let velocity = self.kernel(Numbers::Any, quote!(), velocity);
        let jacobian = self.kernel(Numbers::Any, quote!(), jacobian);
        let convective = self.kernel(Numbers::Any, quote!(), convective);
        let force = self.kernel(Numbers::Any, quote!(out.fill(T::from_f64(0.0));), forces.collect());
        let points = self.kernel(Numbers::F64, quote!(), points);
        let outputs = self.kernel(Numbers::F64, quote!(), outputs);
        let events = templates.events.iter().map(|event| stack(&[], &event.slots, vec![event.event.value]));
        let events: Vec<_> = events.collect();
        let events = (!events.is_empty()).then(|| {
            let events = self.kernel(Numbers::F64, quote!(), events);
            quote! {
                fn events(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
                    #events
                }
            }
        });
        let power = self.power();
        let potential = self.potential();
        let start = self.start();
        let equations = quote! {
            fn mass_matrix(&self, c: &[T], m: &mut [T]) {
                #mass_matrix
            }
            fn position_constraint(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
                #position
            }
            fn velocity_constraint(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
                #velocity
            }
            fn velocity_jacobian(&self, c: &[T], t: T, q: &[T], out: &mut [T]) {
                #jacobian
            }
            fn convective_term(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
                #convective
            }
            fn applied_force(&self, c: &[T], t: T, q: &[T], v: &[T], out: &mut [T]) {
                #force
            }
        };
        let scene = quote! {
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
            fn start(&self, c: &[f64], start: &mut ezy::Start) {
                #start
            }
        };
        Methods { equations, scene, events }
    }

    fn mass_matrix(&mut self) -> TokenStream {
        let arrays = self.model.arrays.iter().zip(&self.templates.masses).map(|(array, masses)| {
            let Body { statements, outputs } = self.lowered(Numbers::Any, masses, &[], &no_other);
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
    fn kernel(&mut self, numbers: Numbers, opening: TokenStream, written: Vec<Written<'_>>) -> TokenStream {
        let firsts = firsts(self.model);
        let loops: Vec<TokenStream> = written.iter().map(|written| self.written(numbers, written, &no_other)).collect();
        quote!(#firsts let mut place = 0; #opening #(#loops)*)
    }

    pub fn written(
        &mut self,
        numbers: Numbers,
        written: &Written<'_>,
        other: &dyn Fn(Symbol) -> TokenStream,
    ) -> TokenStream {
        let Body { statements, outputs } = self.lowered(numbers, &written.sums, written.slots, other);
        let slots = slot_places(self.model, written.slots);
        let put = (written.put)(outputs);
        let body = quote!(#slots #statements #put);
        looped(self.model, written.loops, &|from, to| quote!(#from..#to), body)
    }

    /// Powers by group; the rows that move with time need to know where their multipliers stand.
    fn power(&mut self) -> TokenStream {
        let templates = self.templates;
        let firsts = firsts(self.model);
        let group = |group: Group| templates.groups.iter().position(|other| *other == group).unwrap_or(0);
        let forces: Vec<TokenStream> = templates
            .forces
            .iter()
            .filter(|force| !force.power.is_zero())
            .map(|force| {
                let i = group(force.group);
                let add = move |values: Vec<TokenStream>| quote!(#(out[#i] += #values;)*);
                let (loops, slots) = (&force.force.loops[..], &force.slots[..]);
                self.written(
                    Numbers::F64,
                    &Written { loops, slots, sums: vec![force.power], put: Box::new(add) },
                    &no_other,
                )
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
                self.written(Numbers::F64, &Written { loops, slots, sums, put: Box::new(add) }, &multiplier)
            })
            .collect();
        quote!(#firsts out.fill(0.0); #(#forces)* let mut place = 0; #(#rows)*)
    }

    fn potential(&mut self) -> TokenStream {
        let templates = self.templates;
        let firsts = firsts(self.model);
        let parts: Vec<TokenStream> = templates
            .forces
            .iter()
            .filter(|force| !force.potential.is_zero())
            .map(|force| {
                let add = |values: Vec<TokenStream>| quote!(#(total += #values;)*);
                let (loops, slots) = (&force.force.loops[..], &force.slots[..]);
                self.written(
                    Numbers::F64,
                    &Written { loops, slots, sums: vec![force.potential], put: Box::new(add) },
                    &no_other,
                )
            })
            .collect();
        quote!(#firsts let mut total = 0.0; #(#parts)* total)
    }

    fn start(&mut self) -> TokenStream {
        let firsts = firsts(self.model);
        let gives: Vec<TokenStream> = self
            .templates
            .start
            .iter()
            .map(|(given, value)| {
                let slots = [given.body];
                let give = move |values: Vec<TokenStream>| {
                    let place = coordinate(&[given.body], 3 * given.body.0 + given.component as usize);
                    let give = give(given.rate, given.near);
                    quote!(#(start.#give(#place, #values);)*)
                };
                let loops = &given.loops[..];
                self.written(
                    Numbers::F64,
                    &Written { loops, slots: &slots, sums: vec![*value], put: Box::new(give) },
                    &no_other,
                )
            })
            .collect();
        quote!(#firsts #(#gives)*)
    }

    fn lowered(
        &mut self,
        numbers: Numbers,
        sums: &[SumId],
        slots: &[BodyId],
        other: &dyn Fn(Symbol) -> TokenStream,
    ) -> Body {
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
                numbers.convert(quote!((#value as f64)))
            }
            None => other(symbol),
        };
        kernel::body_at(numbers, &program, symbols, &|i| coordinate(slots, i), &index_or_other)
    }
}

/// Index of the first body of each array.
pub fn firsts(model: &Model) -> TokenStream {
    let mut behind = quote!(0);
    let firsts = model.arrays.iter().map(|array| {
        let first = about("first", array);
        let declared = quote!(let #first: i64 = #behind;);
        let members = members(model, array);
        behind = quote!(#first + #members);
        declared
    });
    firsts.collect()
}

/// Index of the first coordinate of each body that a pass refers to.
pub fn slot_places(model: &Model, slots: &[BodyId]) -> TokenStream {
    let places = slots.iter().map(|body| {
        let Slot { array, index } = &model.bodies[body.0].slot;
        let lengths = &model.arrays[*array].lengths;
        let place = index.iter().zip(lengths).fold(None, |place: Option<TokenStream>, (index, length)| {
            let (index, length) = (whole(model, index), whole(model, length));
            Some(match place {
                None => index,
                Some(place) => quote!(((#place) * #length + #index)),
            })
        });
        let first = about("first", &model.arrays[*array]);
        let place = place.map(|place| quote!(+ #place));
        quote!(3 * (#first #place) as usize)
    });
    let n = Literal::usize_unsuffixed(slots.len());
    quote!(let slots: [usize; #n] = [#(#places),*];)
}

/// Expressions one after the other.
fn stack<'t>(loops: &'t [Loop], slots: &'t [BodyId], sums: Vec<SumId>) -> Written<'t> {
    Written { loops, slots, sums, put: Box::new(|values| quote!(#(out[place] = #values; place += 1;)*)) }
}

/// Place in q of a coordinate of a slot.
pub fn coordinate(slots: &[BodyId], i: usize) -> TokenStream {
    let slot = slots.iter().position(|body| body.0 == i / 3).unwrap_or(0);
    let [slot, component] = [slot, i % 3].map(Literal::usize_unsuffixed);
    quote!(slots[#slot] + #component)
}

/// For kernels that read nothing besides.
fn no_other(_: Symbol) -> TokenStream {
    quote!(f64::NAN)
}
