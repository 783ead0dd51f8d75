//! From the tree to the model: declare every name, then resolve every use.

use super::constant::constant;
use super::context::{ArraySource, Context, Lazy, PointSource};
use super::names::{Scope, Symbol};
use super::repeat::count_symbol;
use super::scene::{Choice, parameters};
use super::unit::Unit;
use super::value::Form;
use super::{Body, Effect, EffectId, InputId, Model, NamedValue, Parameter, ParameterId, Point, PointId, RowId, Slot};
use crate::diag::{Diagnostics, names, rules, scenes};
use crate::parse::ast::{self, Item, ItemKind, Phrase};
use proc_macro2::Ident;

/// The model, if there is no error, neither here nor before.
pub fn resolve(ast: ast::Model, diag: &mut Diagnostics) -> Option<Model> {
    let mut resolver = Resolver {
        context: Context::new(diag),
        model: Model::of_nothing(&ast),
        effects: Vec::new(),
        states: Vec::new(),
        events: Vec::new(),
        stops: Vec::new(),
        rows: Vec::new(),
        bodies: Vec::new(),
    };
    resolver.declare_model(&ast);
    resolver.resolve_values();
    ast.items.iter().for_each(|item| resolver.item(item, None));
    resolver.resolve_scenes(&ast);
    resolver.context.diag.is_empty().then_some(resolver.model)
}

struct Resolver<'a> {
    context: Context<'a>,
    /// What is resolved so far.
    model: Model,
    effects: Vec<&'a ast::Effect>,
    /// First-order states of the model, then of its effects, with their rates.
    states: Vec<(&'a Ident, InputId, &'a ast::Expr, Scope)>,
    /// Events of the model, then of its effects, with documentation.
    events: Vec<(&'a ast::Event, &'a str, Scope)>,
    /// Stops of the model, then of its effects.
    stops: Vec<(&'a ast::Stop, Scope)>,
    /// Rows of the model, then of its effects.
    rows: Vec<RowSource<'a>>,
    /// Declared bodies, single or arrays, with the `for` around.
    bodies: Vec<(&'a ast::Body, &'a [ast::Loop])>,
}

/// Where a row is declared.
struct RowSource<'a> {
    statement: &'a ast::Statement,
    /// Its own, or `constraint_1`, `constraint_2`, … of constraints that have none.
    name: Ident,
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
        for (i, (body, loops)) in self.bodies.iter().enumerate() {
            self.context.resolve_lengths(i, &body.name, loops);
        }
        self.context.check_index_names(&ast.loops);
    }

    fn declare(&mut self, item: &'a Item, scope: Scope) {
        let (name, symbol) = match &item.kind {
            ItemKind::Parameter(parameter) => {
                let (resolved, unit) = self.parameter(parameter, "parameter", &item.documentation, scope);
                self.model.parameters.push(resolved);
                self.context.units.push(unit);
                (&parameter.name, Symbol::Parameter(ParameterId(self.context.units.len() - 1)))
            }
            ItemKind::Input(input) => {
                let what = if input.rate.is_some() { "state" } else { "input" };
                let (resolved, unit) = self.parameter(input, what, &item.documentation, scope);
                self.model.inputs.push(resolved);
                self.context.input_units.push(unit);
                self.context.input_parts.push(input.part);
                let id = InputId(self.context.input_units.len() - 1);
                self.states.extend(input.rate.as_ref().map(|rate| (&input.name, id, rate, scope)));
                let symbol = if input.rate.is_some() { Symbol::State(id) } else { Symbol::Input(id) };
                (&input.name, symbol)
            }
            ItemKind::Count(count) => {
                let resolved = self.context.count(count, &item.documentation);
                self.context.counts.push((count.name.to_string(), resolved.default));
                self.model.counts.push(resolved);
                (&count.name, count_symbol(self.model.counts.len() - 1))
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
                self.context.lets.push(Lazy::waiting((scope, value)));
                (&value.name, Symbol::Let(self.context.lets.len() - 1))
            }
            ItemKind::Body(body) => {
                self.bodies.push((body, &item.loops));
                (&body.name.word, self.context.declare_bodies(body, &item.loops))
            }
            ItemKind::Point(point) => {
                let source = PointSource::Point(point);
                (&point.name.word, self.declare_point(source, &item.loops, Symbol::Point, Symbol::Points))
            }
            ItemKind::Statement(row) if row.word.is_row() => {
                let symbol = self.declare_row(row, &item.loops, scope);
                let Some(name) = &row.name else { return };
                (&name.word, symbol)
            }
            _ => return,
        };
        self.context.names.declare(scope, name, symbol, self.context.diag);
    }

    fn parameter(
        &mut self,
        parameter: &ast::Parameter,
        what: &str,
        documentation: &str,
        effect: Scope,
    ) -> (Parameter, Option<Unit>) {
        let diag = &mut *self.context.diag;
        let unit = parameter.unit.as_ref().and_then(|unit| Unit::resolve(unit, diag));
        let value = constant(
            &parameter.value,
            &format!("the value of {what} `{}`", parameter.name),
            "`let name = …;` computes with parameters",
        );
        let resolved = Parameter {
            name: parameter.name.clone(),
            unit: parameter.unit.as_ref().map_or_else(String::new, |unit| unit.text.clone()),
            size: unit.unwrap_or(Unit::ONE),
            default: diag.keep(value).unwrap_or(f64::NAN),
            default_text: parameter.value_text.clone(),
            documentation: documentation.to_owned(),
            effect,
            part: parameter.part,
            rate: None,
        };
        (resolved, unit)
    }

    /// A single point, or an array of those that a `for` declares.
    fn declare_point(
        &mut self,
        source: PointSource<'a>,
        loops: &'a [ast::Loop],
        single: impl FnOnce(PointId) -> Symbol,
        array: impl FnOnce(usize) -> Symbol,
    ) -> Symbol {
        if loops.is_empty() {
            self.context.points.push(Lazy::waiting(source));
            return single(PointId(self.context.points.len() - 1));
        }
        self.context.point_arrays.push(Lazy::waiting(ArraySource { source, loops }));
        array(self.context.point_arrays.len() - 1)
    }

    fn declare_row(&mut self, row: &'a ast::Statement, loops: &'a [ast::Loop], scope: Scope) -> Symbol {
        let id = RowId(self.rows.len());
        let n_unnamed = self.rows.iter().filter(|row| row.statement.name.is_none()).count();
        let name = match &row.name {
            Some(name) => name.word.clone(),
            None => {
                let word = row.word.word.replace(' ', "_");
                Ident::new(&format!("{word}_{}", n_unnamed + 1), row.keyword.span())
            }
        };
        self.rows.push(RowSource { statement: row, name, loops, scope });
        match (&row.name, &row.phrases[..]) {
            (Some(name), [Phrase::Pair(pair), ..]) if row.word.is_hinge() => {
                let source = PointSource::Hinge(&name.word, &pair[0], &pair[1], scope);
                let (single, array) = (|point| Symbol::Hinge(id, point), |array| Symbol::Hinges(id, array));
                self.declare_point(source, loops, single, array)
            }
            _ => Symbol::Row(id, row.word.word),
        }
    }

    /// `let` values, points, rows, rates of states, events and stops.
    fn resolve_values(&mut self) {
        let (context, model) = (&mut self.context, &mut self.model);
        for id in 0..context.lets.len() {
            let (effect, source) = context.lets[id].source;
            let Some(value) = context.let_value(id, &source.name) else { continue };
            let components = match value.form {
                Form::Scalar(value) => vec![(source.name.to_string(), value)],
                Form::Vector(x, y) => vec![(format!("{}.x", source.name), x), (format!("{}.y", source.name), y)],
            };
            model.lets.extend(components.into_iter().map(|(name, value)| NamedValue { name, effect, value }));
        }
        for id in 0..context.points.len() {
            let name = context.checked_name(context.points[id].source, &[]);
            let place = context.point_place(PointId(id), name);
            model.points.extend(place.map(|place| Point { name: name.clone(), loops: Vec::new(), place }));
        }
        for id in 0..context.point_arrays.len() {
            let ArraySource { source, loops: written } = context.point_arrays[id].source;
            let loops = context.enter(written);
            let name = context.checked_name(source, written);
            let place = context.declared_member(id);
            model.points.extend(place.map(|place| Point { name: name.clone(), loops, place }));
            context.leave();
        }
        for (i, row) in self.rows.iter().enumerate() {
            model.rows.extend(context.row(row.statement, row.loops, &row.name, RowId(i), row.scope));
        }
        for &(name, id, rate, scope) in &self.states {
            model.inputs[id.0].rate = context.state_rate(name, id, rate, scope);
        }
        for (event, documentation, scope) in &self.events {
            model.events.extend(context.event(event, documentation, *scope));
        }
        model.stops.extend(self.stops.iter().filter_map(|(stop, scope)| context.stop(stop, *scope)));
        let defaults = model.parameters.iter().map(|parameter| parameter.size.to_si(parameter.default));
        let defaults: Vec<f64> = defaults.collect();
        for (array, (body, loops)) in self.bodies.iter().enumerate() {
            context.body_item(array, body, loops, &defaults);
        }
    }

    /// An item that no other one refers to by an expression.
    fn item(&mut self, item: &'a Item, scope: Scope) {
        let (context, model) = (&mut self.context, &mut self.model);
        match &item.kind {
            ItemKind::Output(output) => model.outputs.extend(context.output(output, item, scope)),
            ItemKind::Statement(force) if !force.word.is_row() => {
                let declaration = model.forces.last().map_or(0, |last| last.declaration + 1);
                model.forces.extend(context.force(force, &item.loops, scope, declaration));
            }
            ItemKind::Release(row) if scope.is_none() => context.diag.error(scenes::release_outside_effect(row)),
            ItemKind::Effect(effect) => self.effect(effect, item.documentation.clone()),
            ItemKind::Start(start) => model.starts.push(context.start(start)),
            _ => {}
        }
    }

    fn effect(&mut self, effect: &'a ast::Effect, documentation: String) {
        let id = EffectId(self.model.effects.len());
        effect.items.iter().for_each(|item| self.item(item, Some(id)));
        let releases = self.context.releases(effect, id);
        self.model.effects.push(Effect { name: effect.name.clone(), documentation, releases });
    }

    /// The scenes, and what holds of the model as a whole.
    fn resolve_scenes(&mut self, ast: &'a ast::Model) {
        let (context, model) = (&mut self.context, &mut self.model);
        context.check_massless(&self.bodies, &model.rows);
        let effect_names: Vec<&Ident> = self.effects.iter().map(|effect| &effect.name).collect();
        let start_names: Vec<&Ident> = model.starts.iter().map(|start| &start.name).collect();
        context.check_unique(&effect_names, "an effect");
        context.check_unique(&start_names, "a start");
        for name in effect_names {
            if ["model", "drives", "stops"].iter().any(|group| name == group) {
                context.diag.error(scenes::effect_with_name_of_a_group(name));
            }
        }
        let scenes = ast.items.iter().filter_map(|item| match &item.kind {
            ItemKind::Scene(scene) => Some((scene, &item.documentation)),
            _ => None,
        });
        let (scenes, documentation): (Vec<&ast::Scene>, Vec<&String>) = scenes.unzip();
        context.check_scene_types(&scenes);
        let choice = Choice { starts: start_names, effects: &self.effects, broken: &ast.broken };
        for (scene, documentation) in scenes.iter().zip(documentation) {
            model.scenes.extend(context.scene(scene, documentation.clone(), &choice));
        }
        let row_names: Vec<&Ident> = self.rows.iter().map(|row| &row.name).collect();
        context.check_releases(&model.scenes, &model.effects, &row_names);
        context.check_whole(ast, scenes.len());
        if context.diag.is_empty() {
            context.warn_unused_parameters(&choice, &scenes);
        }
        model.bodies = context.bodies();
        model.indices = std::mem::take(&mut context.indices);
        model.quotients = std::mem::take(&mut context.quotients);
        model.arrays = std::mem::take(&mut context.arrays);
        if context.diag.is_empty() {
            context.check_modes(model);
        }
    }
}

impl Model {
    /// Without any item.
    fn of_nothing(ast: &ast::Model) -> Self {
        Self {
            core: ast.core.clone(),
            visibility: ast.visibility.clone(),
            name: ast.name.clone(),
            documentation: ast.documentation.clone(),
            fingerprint: ast.fingerprint,
            counts: Vec::new(),
            indices: Vec::new(),
            quotients: Vec::new(),
            arrays: Vec::new(),
            bodies: Vec::new(),
            lets: Vec::new(),
            parameters: Vec::new(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            events: Vec::new(),
            points: Vec::new(),
            rows: Vec::new(),
            stops: Vec::new(),
            forces: Vec::new(),
            effects: Vec::new(),
            starts: Vec::new(),
            scenes: Vec::new(),
        }
    }
}

impl Context<'_> {
    /// The name of a declared point or hinge; that of a point has the indices of the `for` around.
    fn checked_name<'s>(&mut self, source: PointSource<'s>, loops: &[ast::Loop]) -> &'s Ident {
        match source {
            PointSource::Point(point) => {
                self.check_declared_name(&point.name, loops);
                &point.name.word
            }
            PointSource::Hinge(name, ..) => name,
        }
    }

    /// Every slot with the mass and inertia of its member.
    fn bodies(&mut self) -> Vec<Body> {
        let slots = self.slots.clone();
        let body = |slot: Slot| {
            let array = self.arrays[slot.array].clone();
            let indices = array.loops.iter().zip(&slot.index);
            let indices: Vec<_> = indices.map(|(range, index)| (range.index, self.number_of(index))).collect();
            let [mass, inertia] = [&array.mass, &array.inertia].map(|of| of.with_indices(&indices));
            Body { name: self.slot_text(&slot), slot, mass, inertia }
        };
        slots.into_iter().map(body).collect()
    }

    fn check_unique(&mut self, names: &[&Ident], what: &str) {
        for (i, name) in names.iter().enumerate() {
            if let Some(first) = names[..i].iter().find(|first| *first == name) {
                self.diag.error(names::declared_twice(name, what, first.span()));
            }
        }
    }

    /// A model needs a body to move, a scene to run, and a module name.
    fn check_whole(&mut self, ast: &ast::Model, n_scenes: usize) {
        let module = super::case::snake_case(&ast.name.to_string());
        if crate::parse::is_rust_keyword(&module) {
            self.diag.error(rules::no_module_name(&ast.name, &module));
        }
        if ast.broken.is_empty() && self.arrays.is_empty() {
            self.diag.error(rules::model_without_body(&ast.name));
        }
        if ast.broken.is_empty() && n_scenes == 0 {
            self.diag.error(rules::model_without_scene(&ast.name));
        }
    }

    fn warn_unused_parameters(&mut self, choice: &Choice, scenes: &[&ast::Scene]) {
        for effect in choice.effects {
            if scenes.iter().any(|scene| scene.effects.contains(&effect.name)) {
                continue;
            }
            for name in parameters(effect) {
                self.diag.warning(scenes::parameter_of_unused_effect(name, &effect.name));
            }
        }
    }
}
