//! Counts, arrays and `for`: names with indices become the bodies and places that they stand for.
//!
//! Every distinct reference to a member of an array, `link[i-1]`, is a body of its own for all later stages: a *slot*,
//! of which a pass of the `for` says which member it is. So equations are derived once for all members.

use super::constant::constant;
use super::context::{ArraySource, Context, PointSource, State};
use super::names::Symbol;
use super::whole::{CountId, IndexId, Values, Whole, WholeNames};
use super::{Array, BodyId, Component, Count, Expr, Loop, Place, Slot};
use crate::diag::{Extent, names, repeats, rules};
use crate::parse::ast::{self, Operator};
use proc_macro2::Ident;

impl<'a> Context<'a> {
    pub fn count(&mut self, count: &ast::Count, documentation: &str) -> Count {
        let at = count.value.extent();
        let value = constant(&count.value, &format!("count `{}`", count.name));
        let value = self.diag.keep(value);
        if let Some(value) = value.filter(|value| value.fract() != 0.0 || !(1.0..1e9).contains(value)) {
            self.diag.error(repeats::count_not_whole(at, &count.name, value));
        }
        let default = value.map_or(1, |value| value.max(1.0) as i64);
        Count { name: count.name.clone(), default, documentation: documentation.to_owned() }
    }

    /// An index must not hide a name, nor the index of a `for` around.
    pub fn check_index_names(&mut self, loops: &[(ast::Loop, Vec<ast::Loop>)]) {
        for (range, outer) in loops {
            let name = &range.variable;
            if let Some(symbol) = self.names.lookup(None, name) {
                self.diag.error(repeats::index_shadows(name, symbol.what()));
            } else if outer.iter().any(|other| other.variable == *name) {
                self.diag.error(repeats::index_shadows(name, "the index of a `for` around"));
            } else if ["t", "pi", "ground"].iter().any(|word| name == word) {
                self.diag.error(repeats::index_shadows(name, "a word of the language"));
            }
        }
    }

    /// Begins an item inside these `for`; [`Self::leave`] ends it.
    pub fn enter(&mut self, loops: &[ast::Loop]) -> Vec<Loop> {
        self.loops.clear();
        self.bound.clear();
        for range in loops {
            let [from, to] = [&range.from, &range.to].map(|bound| self.whole(bound).unwrap_or(Whole::Number(0)));
            self.bind(&range.variable.to_string(), from, to);
        }
        self.loops.clone()
    }

    pub fn leave(&mut self) {
        self.loops.clear();
        self.bound.clear();
    }

    /// One more `for` around the present item.
    fn bind(&mut self, name: &str, from: Whole, to: Whole) -> Whole {
        let index = IndexId(self.indices.len());
        self.indices.push(name.to_owned());
        self.bound.push((name.to_owned(), Whole::Index(index)));
        self.loops.push(Loop { index, from, to });
        Whole::Index(index)
    }

    /// The whole number of an index or of a bound.
    pub fn whole(&mut self, expr: &ast::Expr) -> Option<Whole> {
        match expr {
            ast::Expr::Number { value, .. } if value.fract() == 0.0 && value.abs() < 1e9 => {
                Some(Whole::Number(*value as i64))
            }
            ast::Expr::Name(name) => self.whole_name(name),
            ast::Expr::Negative { operand, .. } => {
                self.whole(operand).map(|value| Whole::difference(Whole::Number(0), value))
            }
            ast::Expr::Binary { operator, left, right, .. } => {
                let make = match operator {
                    Operator::Add => Whole::sum,
                    Operator::Subtract => Whole::difference,
                    Operator::Multiply => Whole::product,
                    Operator::Divide | Operator::Power => {
                        self.diag.error(repeats::not_an_index(expr.extent()));
                        return None;
                    }
                };
                let (left, right) = (self.whole(left), self.whole(right));
                Some(make(left?, right?))
            }
            _ => {
                self.diag.error(repeats::not_an_index(expr.extent()));
                None
            }
        }
    }

    fn whole_name(&mut self, name: &Ident) -> Option<Whole> {
        if let Some(value) = self.index_value(name) {
            return Some(value);
        }
        match self.names.lookup(None, name) {
            Some(Symbol::Count(id)) => Some(Whole::Count(id)),
            Some(Symbol::Broken) => None,
            _ => {
                let counts = self.counts.iter().map(|(name, _)| name.clone());
                let known: Vec<String> = counts.chain(self.bound.iter().map(|(name, _)| name.clone())).collect();
                self.diag.error(repeats::unknown_index(name, &known));
                None
            }
        }
    }

    /// The index of a `for` around the present item.
    pub fn index_value(&self, name: &Ident) -> Option<Whole> {
        self.bound.iter().rev().find(|(bound, _)| name == bound).map(|(_, value)| value.clone())
    }

    /// A declared array of bodies; a single body has no lengths.
    pub fn declare_bodies(&mut self, body: &ast::Body) -> Symbol {
        let id = self.arrays.len();
        let (mass, inertia) = (Expr::Number(0.0), Expr::Number(0.0));
        self.arrays.push(Array { name: body.name.word.clone(), lengths: Vec::new(), mass, inertia });
        if !body.name.indices.is_empty() {
            return Symbol::Bodies(id);
        }
        self.slots.push(Slot { array: id, index: Vec::new() });
        Symbol::Body(BodyId(self.slots.len() - 1))
    }

    /// The lengths of a declared array, once all counts are known.
    pub fn resolve_lengths(&mut self, id: usize, name: &ast::Name) {
        let lengths = name.indices.iter().map(|length| self.whole(length).unwrap_or(Whole::Number(1)));
        self.arrays[id].lengths = lengths.collect();
    }

    /// Whether the sizes of the model are numbers of a run.
    pub fn is_repeated(&self) -> bool {
        !self.counts.is_empty() || !self.indices.is_empty() || self.arrays.iter().any(|a| !a.lengths.is_empty())
    }

    /// The slot of a member of an array of bodies.
    pub fn body_member(&mut self, array: usize, name: &ast::Name) -> Option<BodyId> {
        if name.indices.is_empty() {
            self.diag.error(repeats::without_index(name, "an array of bodies"));
            return None;
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
                self.diag.error(repeats::out_of_range(at.extent(), name, wrong, length, &counts));
                return None;
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
    fn indices_of(&mut self, name: &ast::Name, wanted: usize) -> Option<Vec<Whole>> {
        let indices: Vec<Option<Whole>> = name.indices.iter().map(|index| self.whole(index)).collect();
        let indices: Option<Vec<Whole>> = indices.into_iter().collect();
        if name.indices.len() != wanted {
            self.diag.error(repeats::number_of_indices(name.into(), name, wanted, name.indices.len()));
            return None;
        }
        indices
    }

    /// The values of a whole number at the ends of all `for` around, with the declared counts; none where a `for` has
    /// no pass.
    fn extremes(&self, value: &Whole) -> Vec<i64> {
        let counts: Vec<i64> = self.counts.iter().map(|(_, value)| *value).collect();
        let mut corners: Vec<Vec<(IndexId, i64)>> = vec![Vec::new()];
        for range in &self.loops {
            let mut next = Vec::new();
            for corner in &corners {
                let values = Values { counts: &counts, indices: corner };
                let (Some(from), Some(to)) = (range.from.evaluate(&values), range.to.evaluate(&values)) else {
                    continue;
                };
                if from < to {
                    next.extend([from, to - 1].map(|end| [&corner[..], &[(range.index, end)]].concat()));
                }
            }
            corners = next;
        }
        corners.iter().filter_map(|indices| value.evaluate(&Values { counts: &counts, indices })).collect()
    }

    /// The names that a declaration in the present `for` has to carry as indices.
    pub fn check_declared_name(&mut self, name: &ast::Name, loops: &[ast::Loop]) {
        let variables: Vec<String> = loops.iter().map(|range| range.variable.to_string()).collect();
        let written = |index: &ast::Expr, variable: &String| matches!(index, ast::Expr::Name(name) if name == variable);
        let same = name.indices.len() == variables.len()
            && name.indices.iter().zip(&variables).all(|(index, variable)| written(index, variable));
        if !same {
            self.diag.error(match variables.is_empty() {
                true => repeats::name_with_index(name.into(), name),
                false => repeats::name_needs_indices(name.into(), name, &variables),
            });
        }
    }

    /// Runs `resolve` for the member of a declared array of points or hinges, with its indices in place of those that
    /// the declaration uses. `None` after a fault, which is told once.
    pub fn with_member<T>(
        &mut self,
        id: usize,
        name: &ast::Name,
        resolve: impl FnOnce(&mut Self, PointSource<'a>) -> Option<T>,
    ) -> Option<T> {
        let ArraySource { source, loops } = self.point_arrays[id].source;
        if name.indices.is_empty() {
            self.diag.error(repeats::without_index(name, source.what_array()));
            return None;
        }
        let indices = self.indices_of(name, loops.len())?;
        match self.point_arrays[id].state {
            State::Faulty => return None,
            State::InWork => {
                self.diag.error(rules::cyclic_place(name));
                return None;
            }
            State::Waiting | State::Done(()) => {}
        }
        self.check_declared_range(name, &indices, loops)?;
        let bound = loops.iter().zip(indices).map(|(range, index)| (range.variable.to_string(), index)).collect();
        self.in_work(id, bound, |context| resolve(context, source))
    }

    /// Resolves the declaration of an array of points itself, inside its own `for`.
    pub fn declared_member(&mut self, id: usize) -> Option<Place> {
        if matches!(self.point_arrays[id].state, State::Faulty) {
            return None;
        }
        let source = self.point_arrays[id].source.source;
        let bound = self.bound.clone();
        self.in_work(id, bound, |context| context.source_place(source))
    }

    fn in_work<T>(
        &mut self,
        id: usize,
        bound: Vec<(String, Whole)>,
        resolve: impl FnOnce(&mut Self) -> Option<T>,
    ) -> Option<T> {
        let outer = std::mem::replace(&mut self.bound, bound);
        self.point_arrays[id].state = State::InWork;
        let result = resolve(self);
        self.point_arrays[id].state = if result.is_some() { State::Done(()) } else { State::Faulty };
        self.bound = outer;
        result
    }

    /// With the declared counts, members must have been declared.
    fn check_declared_range(&mut self, name: &ast::Name, indices: &[Whole], loops: &[ast::Loop]) -> Option<()> {
        let [range] = loops else { return Some(()) };
        let counts: Vec<i64> = self.counts.iter().map(|(_, value)| *value).collect();
        let values = Values { counts: &counts, indices: &[] };
        let outer = std::mem::take(&mut self.bound);
        let bounds = [&range.from, &range.to].map(|bound| self.whole(bound).and_then(|bound| bound.evaluate(&values)));
        self.bound = outer;
        let [Some(from), Some(to)] = bounds else { return None };
        let wrong = self.extremes(&indices[0]).into_iter().find(|value| !(from..to).contains(value));
        if let Some(wrong) = wrong {
            let at = name.indices[0].extent();
            self.diag.error(repeats::out_of_declared_range(at, name, wrong, from, to));
            return None;
        }
        Some(())
    }

    /// φ_b − φ_a of a member of an array of hinges, or its rate.
    pub fn hinge_member(&mut self, id: usize, name: &ast::Name, rate: bool) -> Option<Expr> {
        let [a, b] = self.with_member(id, name, |context, source| {
            let PointSource::Hinge(_, a, b) = source else { return None };
            let (a, b) = (context.place(a, None), context.place(b, None));
            Some([a?.body, b?.body])
        })?;
        let angle = |body: Option<BodyId>| match body {
            None => Expr::Number(0.0),
            Some(body) if rate => Expr::Velocity(body, Component::Phi),
            Some(body) => Expr::Coordinate(body, Component::Phi),
        };
        Some(Expr::Sub(Box::new(angle(b)), Box::new(angle(a))))
    }

    /// One gravity for each array of bodies, in a `for` of its own, and for each single body.
    pub fn all_bodies(&mut self) -> Vec<(BodyId, Vec<Loop>)> {
        let around = (self.loops.clone(), self.bound.clone());
        let free = |name: &&&str| self.bound.iter().all(|(bound, _)| bound != *name);
        let free: Vec<&str> = ["i", "j", "k", "l", "i1", "j1", "k1", "l1"].iter().filter(free).copied().collect();
        let mut all = Vec::new();
        for array in 0..self.arrays.len() {
            let lengths = self.arrays[array].lengths.clone();
            let names = free.iter().cycle();
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
        self.diag.error(repeats::index_on_single(Extent::from(name), name, what));
        None
    }

    /// Reports a member that is used as a value.
    pub fn indexed_value(&mut self, name: &ast::Name) {
        let error = match self.names.lookup(None, name) {
            Some(Symbol::Broken) => return,
            Some(symbol @ (Symbol::Bodies(_) | Symbol::Points(_) | Symbol::Hinges(..))) => {
                repeats::no_value(name.into(), name, Self::members(symbol))
            }
            Some(symbol) => repeats::index_on_single(name.into(), name, symbol.what()),
            None => names::unknown_owner(name, &self.names.owners()),
        };
        self.diag.error(error);
    }
}

/// The count of a declaration.
pub fn count_symbol(n_counts: usize) -> Symbol {
    Symbol::Count(CountId(n_counts))
}
