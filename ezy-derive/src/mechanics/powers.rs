//! The power that each force of a scene gives to its mechanism. No equation of motion reads it.

use super::expression::Writer;
use super::forces::{Load, sliding};
use super::symbols::Symbols;
use super::templates::slots;
use crate::model::{BodyId, EffectId, Loop, Model, Scene};
use crate::symbolic::{Algebra, SumId};

/// A declared force, with all members that it has, or a skate with a limit.
#[derive(Debug)]
pub struct ForceElement<'m> {
    /// What it is and where, as no other one of the scene: `spring A ~ B`.
    pub name: String,
    /// The word that declares it.
    pub word: &'static str,
    pub effect: Option<EffectId>,
    /// Whether it takes part in V.
    pub has_potential: bool,
    /// Whether it takes part in the power whose work is recorded.
    pub works: bool,
    /// What adds up to its power: one term, but for a gravity that acts on several arrays.
    pub terms: Vec<PowerTerm<'m>>,
}

/// The power of one member of a force.
#[derive(Debug)]
pub struct PowerTerm<'m> {
    /// The `for` around it, outermost first.
    pub loops: &'m [Loop],
    /// The bodies that it reads.
    pub slots: Vec<BodyId>,
    pub power: SumId,
}

/// The forces that a scene calls for in declared order, then its skates with a limit.
pub fn force_elements<'m>(
    model: &'m Model,
    scene: &'m Scene,
    algebra: &mut Algebra,
    symbols: &Symbols,
) -> Vec<ForceElement<'m>> {
    let mut writer = Writer::new(model, algebra, symbols);
    let mut all: Vec<ForceElement<'m>> = Vec::new();
    let mut last = None;
    for force in model.forces.iter().filter(|force| scene.calls_for(force.effect)) {
        let mut load = Load::new(writer.symbols.n_coordinates());
        load.add(&mut writer, force);
        let (has_potential, works, term) = term(&mut writer, &load, &force.loops);
        if last != Some(force.declaration) {
            let name = unused(&force.name, model, &all);
            let (word, effect) = (force.word.word, force.effect);
            all.push(ForceElement { name, word, effect, has_potential: false, works: false, terms: Vec::new() });
        }
        last = Some(force.declaration);
        if let Some(element) = all.last_mut() {
            element.has_potential |= has_potential;
            element.works |= works;
            element.terms.push(term);
        }
    }
    for (row, limit) in model.limited_skates_of(scene) {
        let mut load = Load::new(writer.symbols.n_coordinates());
        sliding::add(&mut writer, row, limit, &mut load);
        let (has_potential, works, term) = term(&mut writer, &load, &row.loops);
        let name = unused(&format!("{} {}", row.word.word, row.name), model, &all);
        let (word, effect) = (row.word.word, row.effect);
        all.push(ForceElement { name, word, effect, has_potential, works, terms: vec![term] });
    }
    all
}

/// Whether a load has a potential, whether work is recorded of it, and its power Q · v.
fn term<'m>(writer: &mut Writer<'_>, load: &Load, loops: &'m [Loop]) -> (bool, bool, PowerTerm<'m>) {
    let (generalised, recorded) = load.finish(writer);
    let rates = generalised.iter().enumerate().map(|(i, &force)| {
        let rate = writer.algebra.symbol(writer.symbols.velocity_at(i));
        writer.algebra.mul(force, rate)
    });
    let parts: Vec<SumId> = rates.collect();
    let power = writer.algebra.total(&parts);
    let term = PowerTerm { loops, slots: slots(writer, &[power]), power };
    (!load.potential.is_zero(), !recorded.is_zero(), term)
}

/// The name, with a number behind it where an effect or another force of the scene has it: both are told side by side.
fn unused(name: &str, model: &Model, all: &[ForceElement<'_>]) -> String {
    let is_used = |name: &str| {
        all.iter().any(|element| element.name == name) || model.effects.iter().any(|effect| effect.name == name)
    };
    let numbered = (2..).map(|n| format!("{name} ({n})"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !is_used(name)).unwrap_or_default()
}
