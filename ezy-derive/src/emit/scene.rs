//! The type of a scene: its parameters as fields, its equations as methods.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::abbreviations::Abbreviations;
use super::constants::Constants;
use super::kernel::{self, Body, Numbers};
use super::{info, modes, page, scene_type, series, slopes};
use crate::mechanics::Equations;
use crate::mechanics::series::Series;
use crate::mechanics::slopes::{Slope, Slopes};
use crate::mechanics::solve::{self, Correction, Solver};
use crate::model::{Model, Parameter, Scene};
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::{SumId, Symbol};

/// The struct, its defaults and its equations; and what the page of the model says of it.
pub fn items(model: &Model, scene: &Scene, mut equations: Equations) -> (TokenStream, page::Summary) {
    let mut pool = ConstantPool::default();
    let accelerations = solve::accelerations(&mut equations, &mut pool);
    let Correction { solver: correction, residuals } = solve::correction(&mut equations, &mut pool);
    let series = Series::derive(&mut equations, &mut pool);
    let Equations { algebra, symbols, constraints, force, .. } = &mut equations;
    let slopes = Slopes::derive(algebra, symbols, Some(constraints), force.iter().copied().enumerate());
    let Methods { equations: kernels, scene: methods } =
        methods(&equations, &mut pool, &accelerations, &correction, &residuals, slopes.as_ref());

    let n_constants = pool.coefficients().len();
    let n_inputs = equations.inputs.len();
    let coefficients = &equations.algebra.coefficients;
    let constants = Constants { model, parameters: &equations.parameters, coefficients }.method(&pool, n_inputs);
    let names = &Abbreviations::new(&equations);
    let (accelerations, correction) = (&accelerations, &correction);
    let emitted = info::Emitted { accelerations, correction, series: &series, n_constants, names };
    let info = info::scene(model, scene, &equations, &emitted);
    let type_name = scene_type(scene);
    let structure = structure(model, scene, &equations, &type_name, &emitted);
    let parameters: Vec<&Ident> = equations.parameters.iter().map(|id| &model.parameters[id.0].name).collect();
    let (parameter, set_parameter) = parameter_access(&parameters);
    let modes = modes::access(model, scene, &parameters);
    let summary = page::Summary::new(model, scene, type_name.to_string(), &equations, &emitted);
    let recurrences = series.as_ref().ok();
    let recurrences =
        recurrences.map(|series| series::implementation(&type_name, &equations, series, n_inputs + n_constants));
    let access_to_series = series.is_ok().then(access_to_series);
    let items = quote! {
        #structure

        impl #type_name {
            /// What is known of the scene when it is compiled.
            pub const INFO: ::ezy_core::model::SceneInfo = #info;
        }

        #[automatically_derived]
        impl<T: ::ezy_core::scalar::Scalar> ::ezy_core::model::Equations<T> for self::#type_name {
            #constants
            #kernels
        }

        #[automatically_derived]
        impl ::ezy_core::model::Scene for #type_name {
            fn info(&self) -> &'static ::ezy_core::model::SceneInfo {
                static INFO: ::ezy_core::model::SceneInfo = #type_name::INFO;
                &INFO
            }
            fn parameter(&self, index: usize) -> f64 {
                #parameter
            }
            fn set_parameter(&mut self, index: usize, value: f64) {
                #set_parameter
            }
            #methods
            #access_to_series
            #modes
        }

        #recurrences
    };
    (items, summary)
}

/// The methods that hand out the series.
pub fn access_to_series() -> TokenStream {
    quote! {
        fn series(&self) -> ::core::option::Option<&dyn ::ezy_core::model::Series<f64>> {
            ::core::option::Option::Some(self)
        }

        fn precise(&self) -> ::core::option::Option<&dyn ::ezy_core::model::PreciseScene> {
            ::core::option::Option::Some(self)
        }
    }
}

/// The methods that read the vector of constants, by trait.
struct Methods {
    equations: TokenStream,
    scene: TokenStream,
}

fn methods(
    equations: &Equations,
    pool: &mut ConstantPool,
    accelerations: &Solver,
    correction: &Solver,
    residuals: &[Symbol],
    slopes: Option<&Slopes>,
) -> Methods {
    let constraints = &equations.constraints;
    let (n_q, n_c) = (equations.mass.len(), constraints.rows.len());
    let jacobian: Vec<SumId> = constraints.jacobian.iter().flatten().map(|&(_, entry)| entry).collect();
    let points: Vec<SumId> = equations.points.iter().flat_map(|point| point.position).collect();
    let power: Vec<SumId> = equations.power.iter().map(|&(_, power)| power).collect();
    let outputs: Vec<SumId> = equations.outputs.iter().map(|&(_, value)| value).collect();
    let other = |symbol: Symbol| {
        let i = residuals.binary_search(&symbol).unwrap_or_default();
        quote!(residual[#i])
    };
    let multiplier = |symbol: Symbol| {
        let row = equations.multipliers.iter().find(|(other, _)| *other == symbol).map_or(0, |(_, row)| *row);
        quote!(lambda[#row])
    };
    let mut emitter = Emitter { equations, pool };
    let kernels = [
        emitter.method(Numbers::Any, "mass_matrix", &[], "m", &equations.mass_entries),
        emitter.method(Numbers::Any, "position_constraint", &["q"], "out", &constraints.position),
        emitter.method(Numbers::Any, "velocity_constraint", &["q", "v"], "out", &constraints.velocity),
        emitter.method(Numbers::Any, "velocity_jacobian", &["q"], "out", &jacobian),
        emitter.method(Numbers::Any, "convective_term", &["q", "v"], "out", &constraints.convective),
        emitter.method(Numbers::Any, "applied_force", &["q", "v"], "out", &equations.force),
    ];
    let bodies = [
        emitter.method_with(Numbers::F64, "power", &["q", "v", "lambda"], "out", &power, &multiplier),
        emitter.method(Numbers::F64, "points", &["q"], "out", &points),
        emitter.method(Numbers::F64, "outputs", &["q", "v"], "out", &outputs),
    ];
    let Body { statements, outputs } = emitter.lowered(Numbers::F64, &[equations.potential], &no_other);
    let potential = quote!(#statements #(#outputs)*);
    let start = emitter.start();
    let slope_kernel = slopes.map(|slopes| emitter.slopes(slopes));
    let accelerations = emitter.solver(accelerations, &[("a", n_q), ("lambda", n_c)], &other);
    let correction = emitter.solver(correction, &[("delta", n_q)], &other);
    let events: Vec<SumId> = equations.events.iter().map(|event| event.value).collect();
    let grip = equations.grip.map(|grip| emitter.method(Numbers::F64, "grip", &["q", "v"], "out", &grip));
    let contact = equations.contact.as_ref();
    let stop = contact.map(|of| emitter.method(Numbers::F64, "stop", &["q", "v"], "out", &of.values()));
    let events = (!events.is_empty()).then(|| emitter.method(Numbers::F64, "events", &["q", "v"], "out", &events));
    let n_fixed = equations.inputs.len() + emitter.pool.coefficients().len();
    let opening = |numbers: Numbers, reads: &[(&str, usize)], writes: &[(&str, usize)]| {
        let reads = reads.iter().map(|&(name, n)| open(numbers, name, name, n, false));
        let writes = writes.iter().map(|&(name, n)| open(numbers, name, name, n, true));
        quote!(#(#reads)* #(#writes)*)
    };
    let kernels = kernels.map(|method| method.finish(n_fixed, n_q, n_c));
    let bodies =
        bodies.into_iter().chain(events).chain(grip).chain(stop).map(|method| method.finish(n_fixed, n_q, n_c));
    let read_by_potential: &[(&str, usize)] = &[("c", n_fixed), ("q", n_q)];
    let potential_opening =
        opening(Numbers::F64, if equations.potential.is_zero() { &[] } else { read_by_potential }, &[]);
    let slopes = slopes.map(|slopes| {
        let slope_opening = opening(
            Numbers::F64,
            &[("c", n_fixed), ("q", n_q), ("v", n_q), ("a", n_q), ("lambda", n_c)],
            &[("by_q", slopes.by_q.len()), ("by_v", slopes.by_v.len())],
        );
        slopes::methods(slope_places(slopes), quote!(#slope_opening #slope_kernel))
    });
    let start_opening = opening(Numbers::F64, &[("c", n_fixed)], &[]);
    let accelerations_opening =
        opening(Numbers::Any, &[("c", n_fixed), ("q", n_q), ("v", n_q)], &[("a", n_q), ("lambda", n_c)]);
    let correction_opening = opening(Numbers::Any, &[("c", n_fixed), ("q", n_q), ("residual", n_c)], &[("delta", n_q)]);
    let equations = quote! {
        #(#kernels)*
        #[inline]
        fn accelerations(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            v: &[T],
            a: &mut [T],
            lambda: &mut [T],
        ) -> ::ezy_core::model::Pivots {
            #accelerations_opening
            #accelerations
        }
        #[inline]
        fn correction(
            &self,
            c: &[T],
            t: T,
            q: &[T],
            residual: &[T],
            delta: &mut [T],
        ) -> ::ezy_core::model::Pivots {
            #correction_opening
            #correction
        }
    };
    let scene = quote! {
        #(#bodies)*
        fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
            #potential_opening
            #potential
        }
        fn start(&self, c: &[f64], start: &mut ::ezy_core::model::Start) {
            #start_opening
            #start
        }
        #slopes
    };
    Methods { equations, scene }
}

/// Turns a slice into an array, so that its length is checked once.
fn open(numbers: Numbers, name: &str, slice: &str, n: usize, written: bool) -> TokenStream {
    let (name, slice, number) = (argument(name), argument(slice), numbers.name());
    if written {
        quote!(let #name = ::ezy_core::kernel::array_mut::<#n, #number>(#slice);)
    } else {
        quote!(let #name = ::ezy_core::kernel::array::<#n, #number>(#slice);)
    }
}

fn argument(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// The method that takes a start value.
pub fn give(rate: bool, near: bool) -> Ident {
    argument(match (rate, near) {
        (false, false) => "give_position",
        (true, false) => "give_velocity",
        (false, true) => "near_position",
        (true, true) => "near_velocity",
    })
}

/// A method that writes one vector; the number of constants is known only when all methods are lowered.
struct Method {
    numbers: Numbers,
    name: &'static str,
    reads: &'static [&'static str],
    target: &'static str,
    n_outputs: usize,
    body: TokenStream,
}

impl Method {
    fn finish(self, n_fixed: usize, n_q: usize, n_c: usize) -> TokenStream {
        let Self { numbers, name, reads, target, n_outputs, body } = self;
        let (name, output, number) = (argument(name), argument(target), numbers.name());
        let arguments = reads.iter().map(|read| {
            let read = argument(read);
            quote!(#read: &[#number])
        });
        let time = if reads.is_empty() { quote!() } else { quote!(t: #number,) };
        let opening = std::iter::once(open(numbers, "c", "c", n_fixed, false))
            .chain(reads.iter().map(|&read| open(numbers, read, read, if read == "lambda" { n_c } else { n_q }, false)))
            .chain(std::iter::once(open(numbers, "out", target, n_outputs, true)));
        quote! {
            fn #name(&self, c: &[#number], #time #(#arguments,)* #output: &mut [#number]) {
                #(#opening)*
                #body
            }
        }
    }
}

/// For kernels that read nothing besides.
fn no_other(_: Symbol) -> TokenStream {
    quote!(f64::NAN)
}

struct Emitter<'a> {
    equations: &'a Equations,
    pool: &'a mut ConstantPool,
}

impl Emitter<'_> {
    fn method(
        &mut self,
        numbers: Numbers,
        name: &'static str,
        reads: &'static [&'static str],
        target: &'static str,
        sums: &[SumId],
    ) -> Method {
        self.method_with(numbers, name, reads, target, sums, &no_other)
    }

    /// A method that reads more than time, coordinates, velocities and inputs; `other` says where.
    fn method_with(
        &mut self,
        numbers: Numbers,
        name: &'static str,
        reads: &'static [&'static str],
        target: &'static str,
        sums: &[SumId],
        other: &dyn Fn(Symbol) -> TokenStream,
    ) -> Method {
        let Body { statements, outputs } = self.lowered(numbers, sums, other);
        let writes = outputs.iter().enumerate().map(|(i, output)| quote!(out[#i] = #output;));
        let writes = kernel::sequence(writes);
        let body = quote!(#statements #writes);
        Method { numbers, name, reads, target, n_outputs: sums.len(), body }
    }

    fn lowered(&mut self, numbers: Numbers, sums: &[SumId], other: &dyn Fn(Symbol) -> TokenStream) -> Body {
        let mut lowering = Lowering::new(&self.equations.algebra, self.pool);
        for &sum in sums {
            let value = lowering.lower(sum);
            lowering.program.push_output(value);
        }
        let mut program = lowering.program;
        program.settle_signs();
        kernel::body(numbers, &program, &self.equations.symbols, other)
    }

    fn start(&mut self) -> TokenStream {
        let sums: Vec<SumId> = self.equations.start.iter().map(|given| given.value).collect();
        let Body { statements, outputs } = self.lowered(Numbers::F64, &sums, &no_other);
        let gives = self.equations.start.iter().zip(outputs).map(|(given, value)| {
            let i = given.index;
            let give = give(given.rate, given.near);
            quote!(start.#give(#i, #value);)
        });
        let gives = kernel::sequence(gives);
        quote!(#statements #gives)
    }

    fn slopes(&mut self, slopes: &Slopes) -> TokenStream {
        let other = |symbol: Symbol| slopes::source(slopes, symbol, &|i| quote!(a[#i]), &|row| quote!(lambda[#row]));
        let Body { statements, outputs } = self.lowered(Numbers::F64, &slopes.values(), &other);
        let (by_q, by_v) = outputs.split_at(slopes.by_q.len());
        let by_q = by_q.iter().enumerate().map(|(i, slope)| quote!(by_q[#i] = #slope;));
        let by_v = by_v.iter().enumerate().map(|(i, slope)| quote!(by_v[#i] = #slope;));
        let writes = kernel::sequence(by_q.chain(by_v));
        quote!(#statements #writes)
    }

    /// Writes a solution into the named slices and returns what its pivots are.
    fn solver(
        &mut self,
        solver: &Solver,
        slices: &[(&str, usize)],
        other: &dyn Fn(Symbol) -> TokenStream,
    ) -> TokenStream {
        let Body { statements, outputs } = kernel::body(Numbers::Any, &solver.program, &self.equations.symbols, other);
        let (solution, pivots) = outputs.split_at(solver.n_outputs);
        let targets = slices.iter().flat_map(|&(name, length)| {
            let name = argument(name);
            (0..length).map(move |i| quote!(#name[#i]))
        });
        let writes = targets.zip(solution).map(|(target, value)| quote!(#target = #value;));
        let writes = kernel::sequence(writes);
        let seen = kernel::pivots(solver.is_written().then_some(&solver.pivots), pivots);
        quote! {
            #statements
            #writes
            #seen
        }
    }
}

fn slope_places(slopes: &Slopes) -> TokenStream {
    let list = |slopes: &[Slope]| -> Vec<TokenStream> {
        slopes.iter().map(|Slope { row, column, .. }| quote!((#row, #column))).collect()
    };
    let (by_q, by_v) = (list(&slopes.by_q), list(&slopes.by_v));
    quote! {
        ::core::option::Option::Some(::ezy_core::model::SlopePlaces {
            by_q: ::std::vec![#(#by_q),*],
            by_v: ::std::vec![#(#by_v),*],
        })
    }
}

fn structure(
    model: &Model,
    scene: &Scene,
    equations: &Equations,
    type_name: &Ident,
    emitted: &info::Emitted<'_>,
) -> TokenStream {
    let count = emitted.accelerations.program.count();
    let page = page::scene(model, equations, emitted);
    let title = title(model, scene);
    let cost = if emitted.accelerations.is_written() {
        format!(
            "Cost of the accelerations and multipliers: {} mul, {} add, {} div, {} sin–cos.",
            count.mul, count.add, count.div, count.trig
        )
    } else {
        page::SOLVED_SPARSE.to_owned()
    };
    let parameters: Vec<_> = equations.parameters.iter().map(|id| &model.parameters[id.0]).collect();
    let fields = parameters.iter().map(|parameter| field(parameter));
    let defaults = parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, parameter.default);
        quote!(#name: #value)
    });
    quote! {
        #[doc = #title]
        #[doc = ""]
        #[doc = #cost]
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

/// The first line of the documentation of a scene.
pub fn title(model: &Model, scene: &Scene) -> String {
    if scene.documentation.trim().is_empty() {
        format!("Scene `{}` of `{}`.", scene.name, model.name)
    } else {
        scene.documentation.clone()
    }
}

/// The field of a parameter.
pub fn field(parameter: &Parameter) -> TokenStream {
    let name = &parameter.name;
    let unit = if parameter.unit.is_empty() { "1" } else { &parameter.unit };
    let title = match parameter.documentation.trim() {
        "" => format!("Parameter `{name}`"),
        text => text.to_owned(),
    };
    let documentation = format!("{title} ({unit}); default `{}`.", parameter.default_text);
    quote!(#[doc = #documentation] pub #name: f64)
}

/// Bodies of `parameter` and `set_parameter`.
pub fn parameter_access(names: &[&Ident]) -> (TokenStream, TokenStream) {
    let indices: Vec<usize> = (0..names.len()).collect();
    (
        quote!(match index { #(#indices => self.#names,)* _ => f64::NAN }),
        quote!(match index { #(#indices => self.#names = value,)* _ => {} }),
    )
}
