//! The description of a scene: names, units, equations, sparsity, counts.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::abbreviations::Abbreviations;
use super::equation::Equation;
use super::equations;
use crate::function::Function;
use crate::mechanics::derived::Straight;
use crate::mechanics::kernels::{Kernel, Quantity};
use crate::mechanics::symbols::Symbols;
use crate::mechanics::{Derived, Equations, EventKind, Group, SceneEvent};
use crate::model::{Bound, Coordinate, DeclaredSwitch, InputId, Model, Parameter, ParameterId, Part, Relation, Scene};
use crate::symbolic::SumId;
use crate::symbolic::print::{Names, Printed};
use crate::symbolic::program::Count;

/// The value of `SceneInfo` for a scene.
pub fn scene(model: &Model, derived: &Derived<'_>, of: &Straight, names: &Abbreviations<'_>) -> TokenStream {
    let (scene, equations) = (&derived.scene, &of.equations);
    let model_name = model.name.to_string();
    let name = scene.name.to_string();
    let documentation = &scene.documentation;
    let fingerprint = model.fingerprint;
    let bodies = model.bodies.iter().map(|body| name_of(&body.name.to_string()));
    let velocities = coordinates(equations.symbols.velocity_names(), "/s");
    let coordinates = coordinates(equations.symbols.coordinate_names(), "");
    let points: Vec<_> = (equations.points.iter())
        .map(|point| {
            let (name, body) = (name_of(&point.name), option(point.body.map(|body| body.0)));
            let position = point.position.map(|x| formula_of(names, x));
            let position = option(Some(quote!([#(#position),*])));
            quote!(ezy::PointInfo { name: #name, body: #body, position: #position })
        })
        .collect();
    let rows = rows(equations, names);
    let n_position_rows = equations.constraints.n_position_rows;
    let parameters = parameters(model, &equations.parameters, &equations.symbols);
    let integrated_inputs = integrated_inputs(model, &equations.inputs);
    let [inputs, states] = inputs_and_states(model, &equations.inputs, &equations.symbols);
    let outputs = outputs(model, equations, names);
    let events = equations.events.iter().map(|event| self::event(event, &names.print(event.value)));
    let events: Vec<_> = events.collect();
    let limited_skates = limited_skates(model, scene, equations, names);
    let stop = option(stop(model, scene, equations, names));
    let switches = equations.symbols.switches().iter();
    let switches = switches.filter_map(|DeclaredSwitch { of, name, start, documentation, .. }| {
        let row = row_named(equations, of)?;
        Some(quote!(ezy::SwitchInfo { row: #row, name: #name, start: #start, documentation: #documentation }))
    });
    let effects = effects(model, &equations.power.iter().map(|(group, _)| *group).collect::<Vec<_>>());
    let until = scene.until_s;
    let n_constants = derived.constants.coefficients().len();
    let feedback = match derived.feedback() {
        Some(coordinates) => quote!(::core::option::Option::Some(&[#(#coordinates),*])),
        None => quote!(::core::option::Option::None),
    };
    let count_of = |quantity| derived.kernels.get(&quantity).map(Kernel::count).unwrap_or_default();
    let quasi_velocities = option(of.quasi.as_ref().map(|quasi| {
        let formulas = quasi.values.iter().map(|&value| formula_of(names, value));
        let feedback = &quasi.feedback;
        let integrals = quasi.integrals.iter().map(|(i, k)| quote!((#i, #k)));
        let (integrated, n_read, has_free_body) = (&quasi.integrated, quasi.n_read, quasi.has_free_body);
        let (n_of_time, n_angles) = (quasi.time_symbols.len(), quasi.angles.outputs().len());
        let operations = operations(count_of(Quantity::QuasiAccelerations));
        quote! {
            ezy::QuasiVelocitiesInfo {
                formulas: &[#(#formulas),*],
                feedback: &[#(#feedback),*],
                integrals: &[#(#integrals),*],
                integrated: &[#(#integrated),*],
                n_read: #n_read,
                has_free_body: #has_free_body,
                n_of_time: #n_of_time,
                n_angles: #n_angles,
                operations: #operations,
            }
        }
    }));
    let (starts, columns) = pattern(equations);
    let entries = equations.constraints.jacobian.iter().flatten();
    let jacobian_entries: Vec<_> = entries.map(|&(_, entry)| formula_of(names, entry)).collect();
    let mass_entries: Vec<_> = equations.mass_entries.iter().map(|&mass| formula_of(names, mass)).collect();
    let force_entries: Vec<_> = equations.force.iter().map(|&force| formula_of(names, force)).collect();
    let potential_energy = formula_of(names, equations.potential);
    let written = equations::of_scene(equations, names);
    let written = written.iter().map(Equation::tokens);
    // last, since they are what printing met
    let abbreviations = names.definitions().into_iter().map(|(symbol, value)| {
        let (symbol, formula) = (formula(&symbol), formula(&value));
        quote!(ezy::Abbreviation { symbol: #symbol, formula: #formula })
    });
    let elimination = of.elimination.iter().map(
        |(rows, constant_pivot)| quote!(ezy::EliminationStep { rows: &[#(#rows),*], constant_pivot: #constant_pivot }),
    );
    let [acceleration_operations, correction_operations] =
        [Quantity::Accelerations, Quantity::Correction].map(|quantity| operations(count_of(quantity)));
    let series = series(derived.series_cost());
    let [bodies, coordinates, velocities, points, rows, outputs] =
        [list(bodies), list(coordinates), list(velocities), list(points), list(rows), list(outputs)];
    quote! {
        ezy::SceneInfo {
            model: #model_name,
            name: #name,
            documentation: #documentation,
            fingerprint: #fingerprint,
            bodies: #bodies,
            kinds: ezy::List::Borrowed(&[]),
            coordinates: #coordinates,
            velocities: #velocities,
            points: #points,
            rows: #rows,
            n_position_rows: #n_position_rows,
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            integrated_inputs: &[#(#integrated_inputs),*],
            states: &[#(#states),*],
            outputs: #outputs,
            events: &[#(#events),*],
            limited_skates: &[#(#limited_skates),*],
            stop: #stop,
            switches: &[#(#switches),*],
            effects: &[#(#effects),*],
            until_s: #until,
            n_constants: #n_constants,
            jacobian: ezy::SparsityPattern::new(&[#(#starts),*], &[#(#columns),*]),
            jacobian_entries: &[#(#jacobian_entries),*],
            mass_entries: &[#(#mass_entries),*],
            force_entries: &[#(#force_entries),*],
            potential_energy: #potential_energy,
            abbreviations: &[#(#abbreviations),*],
            equations: &[#(#written),*],
            elimination: &[#(#elimination),*],
            acceleration_operations: #acceleration_operations,
            correction_operations: #correction_operations,
            feedback: #feedback,
            quasi_velocities: #quasi_velocities,
            series: #series,
            repeats: ::core::option::Option::None,
        }
    }
}

/// A name as a description holds it.
pub fn name_of(text: &str) -> TokenStream {
    quote!(ezy::Name::Borrowed(#text))
}

/// A list as a description holds it.
pub fn list<T: quote::ToTokens>(items: impl IntoIterator<Item = T>) -> TokenStream {
    let items = items.into_iter();
    quote!(ezy::List::Borrowed(&[#(#items),*]))
}

/// Number of products and operations of one order, or why there is no series.
pub fn series(cost: Result<(usize, Count), Function>) -> TokenStream {
    match cost {
        Ok((n_products, count)) => {
            let operations = operations(count);
            quote!(ezy::SeriesInfo::Analytic { n_products: #n_products, operations: #operations })
        }
        Err(function) => {
            let function = function.name();
            quote!(ezy::SeriesInfo::NotAnalytic { function: #function })
        }
    }
}

/// Descriptions of groups of forces.
pub fn effects(model: &Model, groups: &[Group]) -> Vec<TokenStream> {
    groups
        .iter()
        .map(|group| {
            let (name, documentation) = match group {
                Group::Effect(id) => (model.effects[id.0].name.to_string(), model.effects[id.0].documentation.as_str()),
                Group::Model => ("model".to_owned(), "Forces that every scene has."),
                Group::Drives => ("drives".to_owned(), "Rows that move with time."),
                Group::Stops => ("stops".to_owned(), "Impacts on a stop."),
            };
            quote!(ezy::EffectInfo { name: #name, documentation: #documentation })
        })
        .collect()
}

/// Coordinates, or velocities with their `per_second`.
fn coordinates(names: &[Printed], per_second: &str) -> Vec<TokenStream> {
    (names.iter().enumerate())
        .map(|(i, printed)| {
            let (name, symbol) = (name_of(&printed.text), option(Some(formula(printed))));
            let unit = [Coordinate::at(i).component.unit(), per_second].concat();
            quote!(ezy::CoordinateInfo { name: #name, unit: #unit, symbol: #symbol })
        })
        .collect()
}

fn rows(equations: &Equations, names: &Abbreviations<'_>) -> Vec<TokenStream> {
    let constraints = &equations.constraints;
    (constraints.rows.iter().enumerate())
        .map(|(i, row)| {
            let (name, kind, unit) = (name_of(&row.name), row.kind, &row.unit);
            let constraint = constraints.position.get(i).copied().unwrap_or(constraints.velocity[i]);
            let constraint = formula_of(names, constraint);
            let convective = formula_of(names, constraints.convective[i]);
            quote! {
                ezy::RowInfo {
                    name: #name,
                    kind: #kind,
                    multiplier_unit: #unit,
                    constraint: #constraint,
                    convective_term: #convective,
                }
            }
        })
        .collect()
}

pub fn parameters(model: &Model, parameters: &[ParameterId], symbols: &Symbols) -> Vec<TokenStream> {
    (parameters.iter())
        .map(|id| {
            let members = declared(model, &model.parameters[id.0], &symbols.parameter(id.0));
            quote!(ezy::ParameterInfo { #members })
        })
        .collect()
}

/// Inputs and first-order states.
pub fn inputs_and_states(model: &Model, inputs: &[InputId], symbols: &Symbols) -> [Vec<TokenStream>; 2] {
    let members = |id: InputId| {
        let symbol = symbols.symbol(symbols.input(id)?);
        Some(declared(model, &model.inputs[id.0], &symbol))
    };
    let [inputs, states] = model.split_states(inputs).map(|ids| ids.iter().filter_map(|&id| members(id)));
    [
        inputs.map(|members| quote!(ezy::InputInfo { #members })).collect(),
        states.map(|members| quote!(ezy::StateInfo { #members })).collect(),
    ]
}

/// The places of inputs `by acceleration`.
pub fn integrated_inputs(model: &Model, inputs: &[InputId]) -> Vec<usize> {
    (0..inputs.len()).filter(|&i| model.inputs[inputs[i].0].part == Some(Part::Value)).collect()
}

/// The members that parameters, inputs and states have in common.
fn declared(model: &Model, parameter: &Parameter, symbol: &Printed) -> TokenStream {
    let (name, unit, default) = (parameter.name.to_string(), &parameter.unit, parameter.default);
    let (default_text, documentation) = (&parameter.default_text, &parameter.documentation);
    let effect = option(parameter.effect.map(|effect| model.effects[effect.0].name.to_string()));
    let symbol = formula(symbol);
    quote! {
        name: #name,
        unit: #unit,
        default: #default,
        default_text: #default_text,
        documentation: #documentation,
        effect: #effect,
        symbol: #symbol,
    }
}

fn outputs(model: &Model, equations: &Equations, names: &Abbreviations<'_>) -> Vec<TokenStream> {
    (equations.outputs.iter())
        .map(|&(i, value)| {
            let output = &model.outputs[i];
            let (name, unit, documentation) =
                (name_of(&format!("{}{}", output.name, output.suffix)), &output.unit, &output.documentation);
            let formula = formula_of(names, value);
            quote! {
                ezy::OutputInfo {
                    name: #name,
                    unit: #unit,
                    documentation: #documentation,
                    formula: #formula,
                }
            }
        })
        .collect()
}

/// The skates with a limit.
fn limited_skates(model: &Model, scene: &Scene, equations: &Equations, names: &Abbreviations<'_>) -> Vec<TokenStream> {
    let skates = model.limited_skates_of(scene).zip(&equations.limited_skates);
    let skates = skates.filter_map(|((row, _), [limit, velocity])| {
        let name = row.name.to_string();
        let i_row = row_named(equations, &name)?;
        let [limit, velocity] = [limit, velocity].map(|x| formula_of(names, *x));
        let slides = change(&row.name, "slides", &limit, "The skate would need more than its limit.");
        let stops = change(&row.name, "stops", &velocity, "The velocity across the skate comes back to zero.");
        Some(quote! {
            ezy::StickSlipInfo { name: #name, row: #i_row, limit: #limit, slides: #slides, stops: #stops }
        })
    });
    skates.collect()
}

/// The place of the row with this name.
fn row_named(equations: &Equations, name: &str) -> Option<usize> {
    equations.constraints.rows.iter().position(|row| row.name == name)
}

/// The stop.
fn stop(model: &Model, scene: &Scene, equations: &Equations, names: &Abbreviations<'_>) -> Option<TokenStream> {
    let (contact, stop) = (equations.contact.as_ref()?, model.stop_of(scene)?);
    let name = stop.name.to_string();
    let i_row = row_named(equations, &name)?;
    let restitution = formula_of(names, contact.restitution);
    let gaps: Vec<_> = contact.gaps.iter().map(|[gap, _]| formula_of(names, *gap)).collect();
    let sides = stop.ends().map(|(bound, _)| match bound {
        Bound::Lower => 1i8,
        Bound::Upper => -1i8,
    });
    let gap = &gaps[0];
    let hits = gaps.iter().map(|gap| change(&stop.name, "hits", gap, "The quantity reaches a bound."));
    let holds = change(&stop.name, "holds", gap, "The quantity comes to rest on a bound.");
    let lets_go = change(&stop.name, "lets go", gap, "The stop would have to pull.");
    Some(quote! {
        &ezy::StopInfo {
            name: #name,
            row: #i_row,
            sides: &[#(#sides),*],
            restitution: #restitution,
            hits: &[#(#hits),*],
            holds: #holds,
            lets_go: #lets_go,
        }
    })
}

/// A change of mode as an event.
fn change(of: &Ident, what: &str, formula: &TokenStream, documentation: &str) -> TokenStream {
    let name = format!("{of} {what}");
    quote! {
        ezy::EventInfo {
            name: #name,
            kind: ezy::EventKind::Mark,
            direction: ezy::Direction::Falling,
            formula: #formula,
            documentation: #documentation,
        }
    }
}

/// The description of an event whose value is printed so.
pub fn event(event: &SceneEvent, printed: &Printed) -> TokenStream {
    let text = &printed.text;
    let (name, documentation, kind) = match &event.kind {
        EventKind::Declared { name, documentation, ends } => {
            (quote!(#name), documentation.as_str(), if *ends { quote!(End) } else { quote!(Mark) })
        }
        EventKind::Discontinuity => (quote!(#text), "", quote!(Discontinuity)),
        EventKind::Layer => (quote!(#text), "", quote!(Layer)),
    };
    let formula = formula(printed);
    let direction = match event.relation {
        Relation::Less => quote!(Falling),
        Relation::Greater => quote!(Rising),
        Relation::Equal => quote!(Either),
    };
    quote! {
        ezy::EventInfo {
            name: #name,
            kind: ezy::EventKind::#kind,
            direction: ezy::Direction::#direction,
            formula: #formula,
            documentation: #documentation,
        }
    }
}

/// Row starts and columns of G.
fn pattern(equations: &Equations) -> (Vec<u32>, Vec<u32>) {
    let (mut starts, mut columns) = (vec![0], Vec::new());
    for row in &equations.constraints.jacobian {
        columns.extend(row.iter().map(|(column, _)| *column as u32));
        starts.push(columns.len() as u32);
    }
    (starts, columns)
}

fn operations(count: Count) -> TokenStream {
    let Count { add, mul, div, trig, calls } = count;
    quote!(ezy::Operations { add: #add, mul: #mul, div: #div, trig: #trig, calls: #calls })
}

fn formula_of(names: &Abbreviations<'_>, sum: SumId) -> TokenStream {
    formula(&names.print(sum))
}

pub fn formula(printed: &Printed) -> TokenStream {
    let Printed { text, latex, mathml, .. } = printed;
    let mathml = format!("<mrow>{mathml}</mrow>");
    quote!(ezy::Formula { text: #text, latex: #latex, mathml: #mathml })
}

pub fn option<T: quote::ToTokens>(value: Option<T>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}
