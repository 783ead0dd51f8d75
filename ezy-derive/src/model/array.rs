//! Arrays of bodies: names with indices become bodies.
//!
//! Every distinct reference to a member of an array, `link[i-1]`, is a body of its own for all later stages: a *slot*,
//! and each pass of the `for` says which member it is. Equations are thus derived once for all members.

use super::context::Context;
use super::names::{Scope, Symbol};
use super::whole::{Values, Whole, WholeNames};
use super::{Array, BodyId, Expr, Loop, Slot};
use crate::diag::{Extent, names, repeats};
use crate::parse::ast;
use proc_macro2::Ident;

/// Names of indices where the model has none.
const INDICES: [&str; 8] = ["i", "j", "k", "l", "i1", "j1", "k1", "l1"];

impl Context<'_> {
    /// A declared array of bodies; a single body has no lengths.
    pub fn declare_bodies(&mut self, body: &ast::Body, loops: &[ast::Loop]) -> Symbol {
        let id = self.arrays.len();
        // until they are resolved
        let (mass, inertia) = (Expr::Number(1.0), Expr::Number(1.0));
        self.arrays.push(Array { name: body.name.word.clone(), lengths: Vec::new(), loops: Vec::new(), mass, inertia });
        if !body.name.indices.is_empty() || !loops.is_empty() {
            return Symbol::Bodies(id);
        }
        self.slots.push(Slot { array: id, index: Vec::new() });
        Symbol::Body(BodyId(self.slots.len() - 1))
    }

    /// The lengths of a declared array, once all counts are known: as written behind its name, or by the `for` around.
    pub fn resolve_lengths(&mut self, id: usize, name: &ast::Name, loops: &[ast::Loop]) {
        self.leave();
        if loops.is_empty() {
            let lengths: Vec<Whole> = name.indices.iter().map(|length| self.length(name, length)).collect();
            for (length, name) in lengths.iter().zip(INDICES.iter().cycle()) {
                self.bind(name, Whole::Number(0), length.clone());
            }
            self.arrays[id].lengths = lengths;
        } else {
            self.check_declared_name(name, loops);
            self.enter(loops);
            for (range, resolved) in loops.iter().zip(self.loops.clone()) {
                if resolved.from != Whole::Number(0) {
                    self.diag.error(repeats::array_from(range.from.extent(), name, &range.variable));
                } else if resolved.to.innermost().is_some() {
                    self.diag.error(repeats::length_by_index(range.to.extent(), name));
                }
            }
            self.arrays[id].lengths = self.loops.iter().map(|range| range.to.clone()).collect();
        }
        self.arrays[id].loops = self.loops.clone();
        self.leave();
    }

    /// A length behind the name of an array. A name that is no count may be meant as an index.
    fn length(&mut self, array: &ast::Name, length: &ast::Expr) -> Whole {
        let resolved = match length {
            ast::Expr::Name(name) if self.names.lookup(None, name).is_none() => {
                let count = self.counts.first().map_or("5", |(count, _)| count);
                let error = repeats::length_unknown(name, array, count);
                // its uses in the mass give no further errors
                self.names.declare_broken(name);
                self.diag.refuse(error)
            }
            _ => self.whole(length),
        };
        resolved.unwrap_or(Whole::Number(1))
    }

    /// Enters the `for` that an array is declared in; without one its members are alike.
    pub fn enter_array(&mut self, id: usize, loops: &[ast::Loop]) {
        self.leave();
        if loops.is_empty() {
            self.alike = (!self.arrays[id].lengths.is_empty()).then_some(id);
        } else {
            self.loops = self.arrays[id].loops.clone();
            let bound = self.loops.iter().map(|range| (self.indices[range.index.0].clone(), Whole::Index(range.index)));
            self.bound = bound.collect();
        }
    }

    /// The declaration of an array whose members differ by indices, of which `name` may be one.
    pub fn with_index(&self, array: usize, name: &Ident) -> String {
        let counts: Vec<String> = self.counts.iter().map(|(name, _)| name.clone()).collect();
        let whole_names = WholeNames { counts: &counts, indices: &self.indices };
        let Array { name: array, lengths, .. } = &self.arrays[array];
        let own = [name.to_string()];
        let indices = INDICES.map(str::to_owned);
        let indices = if lengths.len() == 1 { &own[..] } else { &indices[..lengths.len().min(INDICES.len())] };
        let inside = format!("body {array}[{}] {{ … }}", indices.join(", "));
        let around = indices.iter().zip(lengths).rev();
        around.fold(inside, |inside, (index, length)| {
            format!("for {index} in 0..{} {{ {inside} }}", length.text(&whole_names))
        })
    }

    /// Whether the sizes of the model are numbers of a run.
    pub fn is_repeated(&self) -> bool {
        !self.counts.is_empty() || !self.indices.is_empty() || self.arrays.iter().any(|a| !a.lengths.is_empty())
    }

    /// The slot of a member of an array of bodies.
    pub fn body_member(&mut self, array: usize, name: &ast::Name) -> Option<BodyId> {
        if name.indices.is_empty() {
            return self.diag.refuse(repeats::without_index(name, "an array of bodies"));
        }
        let lengths = self.arrays[array].lengths.clone();
        let index = self.indices_of(name, lengths.len())?;
        let counts: Vec<i64> = self.counts.iter().map(|(_, value)| *value).collect();
        for ((index, length), at) in index.iter().zip(&lengths).zip(&name.indices) {
            let known = matches!(length, Whole::Number(_));
            let length = length.evaluate(&Values { counts: &counts, indices: &[] })?;
            if let Some(wrong) = self.extremes(index).into_iter().find(|value| !(0..length).contains(value)) {
                let counts = self.counts.iter().map(|(name, value)| format!("{name} = {value}"));
                let counts = if known { String::new() } else { counts.collect::<Vec<_>>().join(", ") };
                return self.diag.refuse(repeats::out_of_range(at.extent(), name, wrong, length, &counts));
            }
        }
        Some(self.slot(array, index))
    }

    pub fn slot(&mut self, array: usize, index: Vec<Whole>) -> BodyId {
        let slot = Slot { array, index };
        let known = self.slots.iter().position(|other| *other == slot);
        BodyId(known.unwrap_or_else(|| {
            self.slots.push(slot);
            self.slots.len() - 1
        }))
    }

    /// The indices behind a name, as many as there should be.
    pub fn indices_of(&mut self, name: &ast::Name, wanted: usize) -> Option<Vec<Whole>> {
        let indices: Vec<Option<Whole>> = name.indices.iter().map(|index| self.whole(index)).collect();
        let indices: Option<Vec<Whole>> = indices.into_iter().collect();
        if name.indices.len() != wanted {
            return self.diag.refuse(repeats::number_of_indices(name.into(), name, wanted, name.indices.len()));
        }
        indices
    }

    /// One gravity for each array of bodies, in a `for` of its own, and for each single body.
    pub fn all_bodies(&mut self) -> Vec<(BodyId, Vec<Loop>)> {
        let around = (self.loops.clone(), self.bound.clone());
        let free = |name: &&&str| self.bound.iter().all(|(bound, _)| bound != *name);
        let free: Vec<String> = INDICES.iter().filter(free).map(ToString::to_string).collect();
        let mut all = Vec::new();
        for array in 0..self.arrays.len() {
            let Array { lengths, loops, .. } = self.arrays[array].clone();
            let own: Vec<String> = loops.iter().map(|range| self.indices[range.index.0].clone()).collect();
            let is_free = own.iter().all(|name| around.1.iter().all(|(bound, _)| bound != name));
            let names: Vec<String> = if is_free { own } else { free.clone() };
            let names = names.iter().cycle();
            let index = lengths.into_iter().zip(names).map(|(length, name)| self.bind(name, Whole::Number(0), length));
            let index = index.collect();
            let body = self.slot(array, index);
            all.push((body, self.loops.clone()));
            (self.loops, self.bound) = around.clone();
        }
        all
    }

    /// `link[i-1]`, for equations.
    pub fn slot_text(&self, slot: &Slot) -> String {
        let counts: Vec<String> = self.counts.iter().map(|(name, _)| name.clone()).collect();
        let names = WholeNames { counts: &counts, indices: &self.indices };
        let name = self.arrays[slot.array].name.to_string();
        if slot.index.is_empty() {
            return name;
        }
        format!("{name}[{}]", slot.index.iter().map(|index| index.text(&names)).collect::<Vec<_>>().join(","))
    }

    /// Reports indices behind a name that is no array.
    pub fn refuse_index(&mut self, name: &ast::Name, what: &str) -> Option<()> {
        if name.indices.is_empty() {
            return Some(());
        }
        self.diag.refuse(repeats::index_on_single(Extent::from(name), name, what))
    }

    /// Reports a member that is used as a value.
    pub fn indexed_value(&mut self, name: &ast::Name, scope: Scope) {
        let error = match self.names.lookup(scope, name) {
            Some(Symbol::Broken) => return,
            Some(symbol @ (Symbol::Bodies(_) | Symbol::Points(_) | Symbol::Hinges(..))) => {
                repeats::no_value(name.into(), name, Self::members(symbol))
            }
            Some(symbol) => repeats::index_on_single(name.into(), name, symbol.what()),
            None => self.names.unknown(name, |known| names::unknown(name, names::OWNER, &known.owners())),
        };
        self.diag.error(error);
    }
}
