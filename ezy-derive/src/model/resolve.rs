//! From the tree to the model: declare every name, then resolve every use.

use super::constant::constant;
use super::context::{Context, Lazy, PointSource};
use super::names::{Names, Scope, Symbol};
use super::scene::{Choice, parameters};
use super::unit::Unit;
use super::{BodyId, Effect, EffectId, InputId, Model, Parameter, ParameterId, Point, PointId, RowId};
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
        },
        parameters: Vec::new(),
        inputs: Vec::new(),
        effects: Vec::new(),
        n_bodies: 0,
        rows: Vec::new(),
    };
    resolver.declare_model(&ast);
    let model = resolver.resolve(&ast);
    resolver.context.diag.is_empty().then_some(model)
}

struct Resolver<'a> {
    context: Context<'a>,
    parameters: Vec<Parameter>,
    inputs: Vec<Parameter>,
    effects: Vec<&'a ast::Effect>,
    n_bodies: usize,
    /// Rows of the model, then of its effects.
    rows: Vec<(&'a ast::Statement, Scope)>,
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
                self.context.names.open_effect();
                for item in &effect.items {
                    self.declare(item, Some(id));
                }
            }
        }
        for name in &ast.broken {
            self.context.names.declare_broken(name);
        }
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
            ItemKind::Output(output) => (&output.name, Symbol::Output),
            ItemKind::Let(value) => {
                context.lets.push(Lazy::waiting((scope, value)));
                (&value.name, Symbol::Let(context.lets.len() - 1))
            }
            ItemKind::Body(body) => {
                self.n_bodies += 1;
                (&body.name, Symbol::Body(BodyId(self.n_bodies - 1)))
            }
            ItemKind::Point(point) => {
                context.points.push(Lazy::waiting(PointSource::Point(point)));
                (&point.name, Symbol::Point(PointId(context.points.len() - 1)))
            }
            ItemKind::Statement(row) if row.word.is_row() => {
                let id = RowId(self.rows.len());
                self.rows.push((row, scope));
                let Some(name) = &row.name else { return };
                let first = row.phrases.first();
                let symbol = match first {
                    Some(Phrase::Pair(place, _)) if row.word.is_hinge() => {
                        context.points.push(Lazy::waiting(PointSource::Hinge(name, place)));
                        Symbol::Hinge(id, PointId(context.points.len() - 1))
                    }
                    _ => Symbol::Row(id, row.word.word),
                };
                (name, symbol)
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
                PointSource::Point(point) => &point.name,
                PointSource::Hinge(name, _) => name,
            };
            let place = context.point_place(PointId(id), name);
            points.extend(place.map(|place| Point { name: name.clone(), place }));
        }
        let (mut bodies, mut rows, mut forces, mut effects) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (mut starts, mut start_names, mut scenes) = (Vec::new(), Vec::new(), Vec::new());
        for (i, (&(statement, effect), name)) in self.rows.iter().zip(&row_names).enumerate() {
            rows.extend(context.row(statement, name, RowId(i), effect));
        }
        let mut outputs = Vec::new();
        for item in &ast.items {
            match &item.kind {
                ItemKind::Output(output) => outputs.extend(context.output(output, &item.documentation, None)),
                ItemKind::Body(body) => {
                    bodies.extend(context.body_item(body, &defaults).map(|resolved| (body, resolved)));
                }
                ItemKind::Statement(force) if !force.word.is_row() => forces.extend(context.force(force, None)),
                ItemKind::Release(row) => context.diag.error(scenes::release_outside_effect(row)),
                ItemKind::Effect(effect) => {
                    let id = EffectId(effects.len());
                    for item in &effect.items {
                        if let ItemKind::Output(output) = &item.kind {
                            outputs.extend(context.output(output, &item.documentation, Some(id)));
                        }
                    }
                    let inner = effect.items.iter().filter_map(|item| match &item.kind {
                        ItemKind::Statement(force) if !force.word.is_row() => Some(force),
                        _ => None,
                    });
                    forces.extend(inner.filter_map(|force| context.force(force, Some(id))));
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
        for name in effect_names.into_iter().filter(|name| *name == "model" || *name == "drives") {
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
        context.check_whole(ast, self.n_bodies, scene_items.len());
        if context.diag.is_empty() {
            context.warn_unused_parameters(&choice, &scene_items);
        }
        Model {
            visibility: ast.visibility.clone(),
            name: ast.name.clone(),
            documentation: ast.documentation.clone(),
            bodies: bodies.into_iter().map(|(_, body)| body).collect(),
            parameters: std::mem::take(&mut self.parameters),
            inputs: std::mem::take(&mut self.inputs),
            outputs,
            points,
            rows,
            forces,
            effects,
            starts,
            scenes,
        }
    }
}

/// Names of rows that got none: `constraint_1`, `constraint_2`, …
impl Resolver<'_> {
    fn row_names(&self) -> Vec<Ident> {
        let mut n_unnamed = 0;
        let mut name = |statement: &ast::Statement| match &statement.name {
            Some(name) => name.clone(),
            None => {
                n_unnamed += 1;
                Ident::new(&format!("{}_{n_unnamed}", statement.word.word.replace(' ', "_")), statement.keyword.span())
            }
        };
        self.rows.iter().map(|(statement, _)| name(statement)).collect()
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
    let value = constant(&parameter.value, &format!("the value of {what} `{}`", parameter.name));
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
