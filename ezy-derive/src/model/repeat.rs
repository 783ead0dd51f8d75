//! Counts and `for`: whole numbers of a model, and the passes that a declaration is repeated in.

use super::constant::constant;
use super::context::Context;
use super::names::Symbol;
use super::whole::{CountId, IndexId, QuotientId, Values, Whole};
use super::{Count, Expr, Loop};
use crate::diag::repeats;
use crate::function::Operator;
use crate::parse::ast;
use proc_macro2::Ident;

impl Context<'_> {
    pub fn count(&mut self, count: &ast::Count, documentation: &str) -> Count {
        let at = count.value.extent();
        let value = constant(&count.value, &format!("count `{}`", count.name), "a run can be given another count");
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
            if let Some(symbol) = self.names.lookup(None, name).filter(|symbol| *symbol != Symbol::Broken) {
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
        self.alike = None;
    }

    /// One more `for` around the present item.
    pub fn bind(&mut self, name: &str, from: Whole, to: Whole) -> Whole {
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
                let (left, right) = (self.whole(left), self.whole(right));
                let (left, right) = (left?, right?);
                let made = match operator {
                    Operator::Add => Some(Whole::sum(left, right)),
                    Operator::Subtract => Some(Whole::difference(left, right)),
                    Operator::Multiply => Some(Whole::product(left, right)),
                    Operator::Divide => Whole::quotient(left, right),
                    Operator::Power => None,
                };
                made.or_else(|| self.diag.refuse(repeats::not_an_index(expr.extent())))
            }
            _ => self.diag.refuse(repeats::not_an_index(expr.extent())),
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
                self.diag.refuse(repeats::unknown_index(name, &known))
            }
        }
    }

    /// The index of a `for` around the present item.
    pub fn index_value(&self, name: &Ident) -> Option<Whole> {
        self.bound.iter().rev().find(|(bound, _)| name == bound).map(|(_, value)| value.clone())
    }

    /// A whole number as a value.
    pub fn number_of(&mut self, whole: &Whole) -> Expr {
        match whole {
            Whole::Number(number) => Expr::Number(*number as f64),
            Whole::Count(id) => Expr::Count(*id),
            Whole::Index(id) => Expr::Index(*id),
            Whole::Sum(a, b) => self.number_of(a) + self.number_of(b),
            Whole::Difference(a, b) => self.number_of(a) - self.number_of(b),
            Whole::Product(a, b) => self.number_of(a) * self.number_of(b),
            Whole::Quotient(..) => {
                let known = self.quotients.iter().position(|other| other == whole);
                Expr::Quotient(QuotientId(known.unwrap_or_else(|| {
                    self.quotients.push(whole.clone());
                    self.quotients.len() - 1
                })))
            }
        }
    }

    /// The values of a whole number at the ends of all `for` around, with the declared counts; none where a `for` has
    /// no pass.
    pub fn extremes(&self, value: &Whole) -> Vec<i64> {
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
}

/// The count of a declaration.
pub fn count_symbol(n_counts: usize) -> Symbol {
    Symbol::Count(CountId(n_counts))
}
