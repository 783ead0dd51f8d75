//! Scenes: one start, one end, and the effects that are called for.

use std::collections::{BTreeMap, BTreeSet};

use super::case::camel_case;
use super::constant::constant;
use super::context::Context;
use super::names::Symbol;
use super::unit::Unit;
use super::{Effect, EffectId, Model, RowId, Scene, StartId};
use crate::diag::{names, scenes};
use crate::parse::ast;
use proc_macro2::Ident;

/// What scenes choose from.
pub struct Choice<'a> {
    pub starts: Vec<&'a Ident>,
    pub effects: &'a [&'a ast::Effect],
    /// Names of items that could not be parsed.
    pub broken: &'a [Ident],
}

impl Context<'_> {
    pub fn scene(&mut self, scene: &ast::Scene, documentation: String, choice: &Choice) -> Option<Scene> {
        let start = self.scene_start(scene, choice);
        let until_s = self.scene_until(scene);
        let effects = self.scene_effects(scene, choice);
        self.check_shared_parameters(scene, &effects, choice);
        let (ends, conditions) = self.ends(scene, &effects, choice.effects);
        let name = scene.name.clone();
        Some(Scene { name, documentation, start: start?, until_s: until_s?, effects, ends, conditions })
    }

    /// The rows that an effect releases.
    pub fn releases(&mut self, effect: &ast::Effect, id: EffectId) -> Vec<RowId> {
        let mut released: Vec<(RowId, &Ident)> = Vec::new();
        for item in &effect.items {
            let ast::ItemKind::Release(name) = &item.kind else { continue };
            let symbol = self.names.lookup(Some(id), name);
            match symbol {
                Some(_) if self.names.is_of_effect(id, name) => {
                    self.diag.error(scenes::releases_own_row(name, &effect.name));
                }
                Some(Symbol::Hinge(row, _) | Symbol::Hinges(row, _) | Symbol::Row(row, _)) => {
                    match released.iter().find(|(other, _)| *other == row) {
                        Some((_, first)) => self.diag.error(scenes::released_twice(name, first)),
                        None => released.push((row, name)),
                    }
                }
                Some(Symbol::Broken) => {}
                _ => {
                    let error = scenes::releases_no_row(name, symbol.map(Symbol::what), &self.names.rows(None));
                    self.diag.error(error);
                }
            }
        }
        released.into_iter().map(|(row, _)| row).collect()
    }

    /// A row cannot be replaced by two laws at once. An effect that releases what another one releases is reported once.
    pub fn check_releases(&mut self, scenes: &[Scene], effects: &[Effect], rows: &[&Ident]) {
        let mut reported = BTreeSet::new();
        for scene in scenes {
            let mut released: BTreeMap<RowId, EffectId> = BTreeMap::new();
            for &second in &scene.effects {
                for &row in &effects[second.0].releases {
                    let first = *released.entry(row).or_insert(second);
                    if first != second && reported.insert((second, row)) {
                        let [first, second] = [first, second].map(|effect| &effects[effect.0].name);
                        self.diag.error(scenes::released_by_two(&scene.name, rows[row.0], first, second));
                    }
                }
            }
        }
    }

    fn scene_start(&mut self, scene: &ast::Scene, choice: &Choice) -> Option<StartId> {
        let known = strings(&choice.starts);
        let known: Vec<&str> = known.iter().map(String::as_str).collect();
        let Some(name) = &scene.start else {
            if !scene.broken {
                self.diag.error(scenes::scene_without_start(&scene.name, &known));
            }
            return None;
        };
        let found = choice.starts.iter().position(|start| *start == name);
        if found.is_none() && !choice.broken.contains(name) {
            self.diag.error(names::unknown(name, names::START, &known));
        }
        found.map(StartId)
    }

    fn scene_until(&mut self, scene: &ast::Scene) -> Option<f64> {
        let Some(until) = &scene.until else {
            if !scene.broken {
                self.diag.error(scenes::scene_without_until(&scene.name, !scene.ends.is_empty()));
            }
            return None;
        };
        let factor = ast::UnitFactor { name: until.unit.clone(), exponent: 1 };
        let unit = Unit::resolve(&ast::Unit { text: String::new(), factors: vec![factor] }, self.diag);
        let number = constant(&until.value, "the end of a scene", "a run can be given another end");
        let (unit, number) = (unit?, self.diag.keep(number)?);
        if unit.dimension != super::dimension::Dimension::TIME {
            return self.diag.refuse(scenes::until_in_wrong_unit(&until.unit));
        }
        let until_s = unit.to_si(number);
        if until_s > 0.0 && until_s.is_finite() {
            return Some(until_s);
        }
        self.diag.refuse(scenes::until_not_positive(until.value.extent(), &scene.name))
    }

    fn scene_effects(&mut self, scene: &ast::Scene, choice: &Choice) -> Vec<EffectId> {
        let mut effects: Vec<(EffectId, &Ident)> = Vec::new();
        for name in &scene.effects {
            let Some(index) = choice.effects.iter().position(|effect| effect.name == *name) else {
                if !choice.broken.contains(name) {
                    let known = strings(&choice.effects.iter().map(|effect| &effect.name).collect::<Vec<_>>());
                    let known: Vec<&str> = known.iter().map(String::as_str).collect();
                    self.diag.error(names::unknown(name, names::EFFECT, &known));
                }
                continue;
            };
            match effects.iter().find(|(id, _)| id.0 == index) {
                Some((_, first)) => self.diag.error(scenes::effect_twice(name, &scene.name, first)),
                None => effects.push((EffectId(index), name)),
            }
        }
        effects.into_iter().map(|(id, _)| id).collect()
    }

    /// The parameters of a scene are the fields of one type; its inputs, outputs, events and stops are known by their names.
    /// A declaration that repeats one of another effect is reported once, for the first scene and effect that meet it.
    fn check_shared_parameters(&mut self, scene: &ast::Scene, effects: &[EffectId], choice: &Choice) {
        let mut declared: BTreeMap<&Ident, EffectId> = BTreeMap::new();
        for &second in effects {
            for name in values(choice.effects[second.0]) {
                let first = *declared.entry(name).or_insert(second);
                if first != second && self.shared_parameters.insert((second, name.to_string())) {
                    let [first, second] = [first, second].map(|effect| &choice.effects[effect.0].name);
                    self.diag.error(scenes::shared_parameter(name, &scene.name, first, second));
                }
            }
        }
    }

    /// A skate with a limit or a stop gives a scene several modes: it has one stop at most, and bodies of its own. A stop that is
    /// too many is reported once, for the first scene that has it.
    pub fn check_modes(&mut self, model: &Model) {
        if model.is_repeated() {
            let limited = model.rows.iter().filter(|row| row.limit().is_some());
            limited.for_each(|row| self.diag.error(scenes::limit_with_counts(&row.name)));
            model.stops.iter().for_each(|stop| self.diag.error(scenes::stop_with_counts(&stop.name)));
            return;
        }
        let mut reported: Vec<&Ident> = Vec::new();
        for scene in &model.scenes {
            let stops: Vec<_> = model.stops_of(scene).map(|stop| &stop.name).collect();
            if let [first, second, ..] = stops[..]
                && !reported.iter().any(|name| std::ptr::eq(*name, second))
            {
                reported.push(second);
                self.diag.error(scenes::two_stops(&scene.name, first, second));
            }
        }
    }

    /// Types are the scenes' names in CamelCase: they must be names, and differ.
    pub fn check_scene_types(&mut self, scenes: &[&ast::Scene]) {
        for (i, scene) in scenes.iter().enumerate() {
            let type_name = camel_case(&scene.name.to_string());
            if crate::parse::is_rust_keyword(&type_name) {
                self.diag.error(scenes::no_type_name(&scene.name, &type_name));
            }
            let same = |other: &&&ast::Scene| camel_case(&other.name.to_string()) == type_name;
            match scenes[..i].iter().find(same) {
                Some(first) if first.name == scene.name => {
                    self.diag.error(names::declared_twice(&scene.name, "a scene", first.name.span()));
                }
                Some(first) => self.diag.error(scenes::same_type_name(&scene.name, &type_name, &first.name)),
                None => {}
            }
        }
    }
}

/// Names of the parameters of an effect.
pub fn parameters(effect: &ast::Effect) -> impl Iterator<Item = &Ident> {
    effect.items.iter().filter_map(|item| match &item.kind {
        ast::ItemKind::Parameter(parameter) => Some(&parameter.name),
        _ => None,
    })
}

/// Names of parameters, inputs, outputs, events and stops of an effect.
fn values(effect: &ast::Effect) -> impl Iterator<Item = &Ident> {
    effect.items.iter().filter_map(|item| match &item.kind {
        ast::ItemKind::Parameter(value) | ast::ItemKind::Input(value) => Some(&value.name),
        ast::ItemKind::Output(output) => Some(&output.name.word),
        ast::ItemKind::Event(event) => Some(&event.name),
        ast::ItemKind::Stop(stop) => Some(&stop.name),
        _ => None,
    })
}

fn strings(names: &[&Ident]) -> Vec<String> {
    names.iter().map(|name| name.to_string()).collect()
}
