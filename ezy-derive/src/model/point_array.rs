//! Points and hinges that are declared in a `for`: each use is resolved anew, with its own indices.

use super::context::{ArraySource, Context, PointSource, State};
use super::whole::{Values, Whole};
use super::{BodyId, Component, Expr, Place};
use crate::diag::{repeats, rules};
use crate::parse::ast;

impl<'a> Context<'a> {
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
            return self.diag.refuse(repeats::without_index(name, source.what_array()));
        }
        let indices = self.indices_of(name, loops.len())?;
        match self.point_arrays[id].state {
            State::Faulty => return None,
            State::InWork => {
                return self.diag.refuse(rules::cyclic_place(name));
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
            return self.diag.refuse(repeats::out_of_declared_range(at, name, wrong, from, to));
        }
        Some(())
    }

    /// φ_b − φ_a of a member of an array of hinges, or its rate.
    pub fn hinge_member(&mut self, id: usize, name: &ast::Name, rate: bool) -> Option<Expr> {
        let [a, b] = self.with_member(id, name, |context, source| {
            let PointSource::Hinge(_, a, b, scope) = source else { return None };
            let (a, b) = (context.place(a, scope), context.place(b, scope));
            Some([a?.body, b?.body])
        })?;
        let angle = |body: Option<BodyId>| match body {
            None => Expr::Number(0.0),
            Some(body) if rate => Expr::Velocity(body, Component::Phi),
            Some(body) => Expr::Coordinate(body, Component::Phi),
        };
        Some(angle(b) - angle(a))
    }
}
