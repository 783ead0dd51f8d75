//! From the tree to the model: declare every name, then resolve every use.

use super::constant::constant;
use super::context::{ArraySource, Context, Lazy, PointSource};
use super::mechanism::Declared;
use super::names::{Names, Scope, Symbol};
use super::repeat::count_symbol;
use super::scene::{Choice, parameters};
use super::unit::Unit;
use super::{Body, Count, Effect, EffectId, InputId, Model, Parameter, ParameterId, Point, PointId, RowId};
use crate::diag::{Diagnostics, names, rules, scenes};
use crate::parse::ast::{self, Item, ItemKind, Phrase};
use proc_macro2::Ident;

/// The model, if there is no error, neither here nor before.
pub fn resolve(ast: ast::Model, diag: &mut Diagnostics) -> Option<Model> {
    let mut resolver = Resolver {
        context: Context {
            diag,
            names: Names::default(),
            units: Vec::new(),
            input_units: Vec::new(),
            lets: Vec::new(),
            n_lets_in_work: 0,
            points: Vec::new(),
            point_arrays: Vec::new(),
            counts: Vec::new(),
            indices: Vec::new(),
            loops: Vec::new(),
            bound: Vec::new(),
            shared_parameters: Default::default(),
            arrays: Vec::new(),
            slots: Vec::new(),
        },
        counts: Vec::new(),
        parameters: Vec::new(),
        inputs: Vec::new(),
        effects: Vec::new(),
        events: Vec::new(),
        stops: Vec::new(),
        rows: Vec::new(),
    };
    resolver.declare_model(&ast);
    let model = resolver.resolve(&ast);
    resolver.context.diag.is_empty().then_some(model)
}

struct Resolver<'a> {
    context: Context<'a>,
    counts: Vec<Count>,
    parameters: Vec<Parameter>,
    inputs: Vec<Parameter>,
    effects: Vec<&'a ast::Effect>,
    /// Events of the model, then of its effects, with documentation.
    events: Vec<(&'a ast::Event, &'a str, Scope)>,
    /// Stops of the model, then of its effects.
    stops: Vec<(&'a ast::Stop, Scope)>,
    /// Rows of the model, then of its effects.
    rows: Vec<RowSource<'a>>,
}

/// Where a row is declared.
struct RowSource<'a> {
    statement: &'a ast::Statement,
    loops: &'a [ast::Loop],
    scope: Scope,
}

impl<'a> Resolver<'a> {
    fn declare_model(&mut self, ast: &'a ast::Model) {
        for item in &ast.items {
            self.declare(item, None);
        }
        for item in &ast.items {
            if let ItemKind::Effect(effect) = &item.kind {
                let id = EffectId(self.effects.len());
                self.effects.push(effect);
                self.context.names.open_effect(&effect.name);
                for item in &effect.items {
                    self.declare(item, Some(id));
                }
            }
        }
        for name in &ast.broken {
            self.context.names.declare_broken(name);
        }
        let bodies = ast.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Body(body) => Some(&body.name),
            _ => None,
        });
        bodies.enumerate().for_each(|(i, name)| self.context.resolve_lengths(i, name));
        self.context.check_index_names(&ast.loops);
    }

    fn declare(&mut self, item: &'a Item, scope: Scope) {
        let context = &mut self.context;
        let (name, symbol) = match &item.kind {
            ItemKind::Parameter(parameter) => {
                let id = ParameterId(self.parameters.len());
                context.units.push(parameter.unit.as_ref().and_then(|unit| Unit::resolve(unit, context.diag)));
                self.parameters.push(parameter_of(parameter, "parameter", &item.documentation, scope, context));
                (&parameter.name, Symbol::Parameter(id))
            }
            ItemKind::Input(input) => {
                let id = InputId(self.inputs.len());
                context.input_units.push(input.unit.as_ref().and_then(|unit| Unit::resolve(unit, context.diag)));
                self.inputs.push(parameter_of(input, "input", &item.documentation, scope, context));
                (&input.name, Symbol::Input(id))
            }
            ItemKind::Count(count) => {
                let resolved = context.count(count, &item.documentation);
                context.counts.push((count.name.to_string(), resolved.default));
                self.counts.push(resolved);
                (&count.name, count_symbol(self.counts.len() - 1))
            }
            ItemKind::Output(output) => (&output.name.word, Symbol::Output),
            ItemKind::Event(event) => {
                self.events.push((event, &item.documentation, scope));
                (&event.name, Symbol::Event(self.events.len() - 1, scope))
            }
            ItemKind::Stop(stop) => {
                self.stops.push((stop, scope));
                (&stop.name, Symbol::Stop)
            }
            ItemKind::Let(value) => {
                context.lets.push(Lazy::waiting((scope, value)));
                (&value.name, Symbol::Let(context.lets.len() - 1))
            }
            ItemKind::Body(body) => (&body.name.word, context.declare_bodies(body)),
            ItemKind::Point(point) => {
                let source = PointSource::Point(point);
                let symbol = match &item.loops[..] {
                    [] => {
                        context.points.push(Lazy::waiting(source));
                        Symbol::Point(PointId(context.points.len() - 1))
                    }
                    loops => {
                        context.point_arrays.push(Lazy::waiting(ArraySource { source, loops }));
                        Symbol::Points(context.point_arrays.len() - 1)
                    }
                };
                (&point.name.word, symbol)
            }
            ItemKind::Statement(row) if row.word.is_row() => {
                let id = RowId(self.rows.len());
                self.rows.push(RowSource { statement: row, loops: &item.loops, scope });
                let Some(name) = &row.name else { return };
                let first = row.phrases.first();
                let symbol = match first {
                    Some(Phrase::Pair(pair)) if row.word.is_hinge() => {
                        let [a, b] = &**pair;
                        let source = PointSource::Hinge(&name.word, a, b, scope);
                        if item.loops.is_empty() {
                            context.points.push(Lazy::waiting(source));
                            Symbol::Hinge(id, PointId(context.points.len() - 1))
                        } else {
                            context.point_arrays.push(Lazy::waiting(ArraySource { source, loops: &item.loops }));
                            Symbol::Hinges(id, context.point_arrays.len() - 1)
                        }
                    }
                    _ => Symbol::Row(id, row.word.word),
                };
                (&name.word, symbol)
            }
            _ => return,
        };
        context.names.declare(scope, name, symbol, context.diag);
    }

    fn resolve(&mut self, ast: &'a ast::Model) -> Model {
        let defaults: Vec<f64> = self.parameters.iter().map(|parameter| parameter.default).collect();
        let row_names = self.row_names();
        let context = &mut self.context;
        for id in 0..context.lets.len() {
            let (_, source) = context.lets[id].source;
            context.let_value(id, &source.name);
        }
        let mut points = Vec::new();
        for id in 0..context.points.len() {
            let name = match context.points[id].source {
                PointSource::Point(point) => {
                    context.check_declared_name(&point.name, &[]);
                    &point.name.word
                }
                PointSource::Hinge(name, ..) => name,
            };
            let place = context.point_place(PointId(id), name);
            points.extend(place.map(|place| Point { name: name.clone(), loops: Vec::new(), place }));
        }
        for id in 0..context.point_arrays.len() {
            let ArraySource { source, loops: written } = context.point_arrays[id].source;
            let loops = context.enter(written);
            let name = match source {
                PointSource::Point(point) => {
                    context.check_declared_name(&point.name, written);
                    &point.name.word
                }
                PointSource::Hinge(name, ..) => name,
            };
            let place = context.declared_member(id);
            points.extend(place.map(|place| Point { name: name.clone(), loops, place }));
            context.leave();
        }
        let (mut bodies, mut rows, mut forces, mut effects) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (mut starts, mut start_names, mut scenes) = (Vec::new(), Vec::new(), Vec::new());
        for (i, (row, name)) in self.rows.iter().zip(&row_names).enumerate() {
            rows.extend(context.row(row.statement, row.loops, name, RowId(i), row.scope));
        }
        let events = self.events.iter().filter_map(|(event, text, scope)| context.event(event, text, *scope));
        let events = events.collect();
        let stops = self.stops.iter().filter_map(|(stop, scope)| context.stop(stop, *scope)).collect();
        let (mut outputs, mut n_arrays) = (Vec::new(), 0);
        for item in &ast.items {
            match &item.kind {
                ItemKind::Output(output) => outputs.extend(context.output(output, item, None)),
                ItemKind::Body(body) => {
                    let array = n_arrays;
                    n_arrays += 1;
                    bodies.extend(context.body_item(body, &defaults).map(|resolved| (array, body, resolved)));
                }
                ItemKind::Statement(force) if !force.word.is_row() => {
                    forces.extend(context.force(force, &item.loops, None));
                }
                ItemKind::Release(row) => context.diag.error(scenes::release_outside_effect(row)),
                ItemKind::Effect(effect) => {
                    let id = EffectId(effects.len());
                    for item in &effect.items {
                        if let ItemKind::Output(output) = &item.kind {
                            outputs.extend(context.output(output, item, Some(id)));
                        }
                    }
                    let inner = effect.items.iter().filter_map(|item| match &item.kind {
                        ItemKind::Statement(force) if !force.word.is_row() => Some((force, &item.loops)),
                        _ => None,
                    });
                    forces.extend(inner.flat_map(|(force, loops)| context.force(force, loops, Some(id))));
                    effects.push(Effect {
                        name: effect.name.clone(),
                        documentation: item.documentation.clone(),
                        releases: context.releases(effect, id),
                    });
                }
                ItemKind::Start(start) => {
                    starts.push(context.start(start));
                    start_names.push(&start.name);
                }
                ItemKind::Scene(scene) => scenes.push((item, scene)),
                _ => {}
            }
        }
        context.check_massless(&bodies, &rows);
        let effect_names: Vec<&Ident> = self.effects.iter().map(|effect| &effect.name).collect();
        unique(&effect_names, "an effect", context.diag);
        unique(&start_names, "a start", context.diag);
        for name in
            effect_names.into_iter().filter(|name| ["model", "drives", "stops"].iter().any(|group| name == group))
        {
            context.diag.error(scenes::effect_with_name_of_a_group(name));
        }
        let scene_items: Vec<&ast::Scene> = scenes.iter().map(|(_, scene)| *scene).collect();
        context.check_scene_types(&scene_items);
        let choice = Choice { starts: start_names, effects: self.effects.clone(), broken: &ast.broken };
        let scenes: Vec<_> = scenes
            .into_iter()
            .filter_map(|(item, scene)| context.scene(scene, item.documentation.clone(), &choice))
            .collect();
        context.check_releases(&scenes, &effects, &row_names);
        context.check_whole(ast, context.arrays.len(), scene_items.len());
        if context.diag.is_empty() {
            context.warn_unused_parameters(&choice, &scene_items);
        }
        let model = Model {
            core: ast.core.clone(),
            visibility: ast.visibility.clone(),
            name: ast.name.clone(),
            documentation: ast.documentation.clone(),
            counts: std::mem::take(&mut self.counts),
            bodies: context.bodies(&bodies),
            indices: std::mem::take(&mut context.indices),
            arrays: std::mem::take(&mut context.arrays),
            parameters: std::mem::take(&mut self.parameters),
            inputs: std::mem::take(&mut self.inputs),
            outputs,
            events,
            points,
            rows,
            stops,
            forces,
            effects,
            starts,
            scenes,
        };
        if context.diag.is_empty() {
            context.check_modes(&model);
        }
        model
    }
}

/// Names of constraints that have none: `constraint_1`, `constraint_2`, …
impl Resolver<'_> {
    fn row_names(&self) -> Vec<Ident> {
        let mut n_unnamed = 0;
        let mut name = |statement: &ast::Statement| match &statement.name {
            Some(name) => name.word.clone(),
            None => {
                n_unnamed += 1;
                Ident::new(&format!("{}_{n_unnamed}", statement.word.word.replace(' ', "_")), statement.keyword.span())
            }
        };
        self.rows.iter().map(|row| name(row.statement)).collect()
    }
}

fn parameter_of(
    parameter: &ast::Parameter,
    what: &str,
    documentation: &str,
    effect: Scope,
    context: &mut Context,
) -> Parameter {
    let unit = parameter.unit.as_ref();
    let value = constant(
        &parameter.value,
        &format!("the value of {what} `{}`", parameter.name),
        "`let name = …;` computes with parameters",
    );
    Parameter {
        name: parameter.name.clone(),
        unit: unit.map_or_else(String::new, |unit| unit.text.clone()),
        default: context.diag.keep(value).unwrap_or(f64::NAN),
        default_text: parameter.value_text.clone(),
        documentation: documentation.to_owned(),
        effect,
    }
}

fn unique(names: &[&Ident], what: &str, diag: &mut Diagnostics) {
    for (i, name) in names.iter().enumerate() {
        if let Some(first) = names[..i].iter().find(|first| *first == name) {
            diag.error(names::declared_twice(name, what, first.span()));
        }
    }
}

impl Context<'_> {
    /// Every slot with the mass and inertia of its array; only what follows a fault lacks some.
    fn bodies(&mut self, declared: &[(usize, &ast::Body, Declared)]) -> Vec<Body> {
        for (array, _, of) in declared {
            (self.arrays[*array].mass, self.arrays[*array].inertia) = (of.mass.clone(), of.inertia.clone());
        }
        let body = |slot: &super::Slot| {
            let (_, _, of) = declared.iter().find(|(array, ..)| *array == slot.array)?;
            let (mass, inertia) = (of.mass.clone(), of.inertia.clone());
            Some(Body { name: self.slot_text(slot), slot: slot.clone(), mass, inertia })
        };
        self.slots.iter().filter_map(body).collect()
    }

    /// A model needs a body to move, a scene to run, and a module name.
    fn check_whole(&mut self, ast: &ast::Model, n_bodies: usize, n_scenes: usize) {
        let module = super::case::snake_case(&ast.name.to_string());
        if crate::parse::is_rust_keyword(&module) {
            self.diag.error(rules::no_module_name(&ast.name, &module));
        }
        if ast.broken.is_empty() && n_bodies == 0 {
            self.diag.error(rules::model_without_body(&ast.name));
        }
        if ast.broken.is_empty() && n_scenes == 0 {
            self.diag.error(rules::model_without_scene(&ast.name));
        }
    }

    fn warn_unused_parameters(&mut self, choice: &Choice, scenes: &[&ast::Scene]) {
        for effect in &choice.effects {
            if scenes.iter().any(|scene| scene.effects.contains(&effect.name)) {
                continue;
            }
            for name in parameters(effect) {
                self.diag.warning(scenes::parameter_of_unused_effect(name, &effect.name));
            }
        }
    }
}
