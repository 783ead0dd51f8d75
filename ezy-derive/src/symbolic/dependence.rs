//! Which symbols a sum depends on, and through which of its terms.

use std::sync::Arc;

use super::sum::{Algebra, Atom, Dependence, SumId, Symbol};
use crate::work;

impl Algebra {
    /// Found once for each sum: a derivative looks at the terms that hold its symbol alone.
    pub fn dependence(&mut self, sum: SumId) -> Arc<Dependence> {
        if let Some(known) = self.dependences.get(&sum) {
            return Arc::clone(known);
        }
        work::count(self.terms(sum).len());
        let mut found = Dependence::new();
        for place in 0..self.terms(sum).len() {
            let monomial = self.terms(sum)[place].0;
            for i in 0..self.monomial(monomial).len() {
                let atom = self.monomial(monomial)[i].0;
                for symbol in self.symbols_of_atom(self.atom(atom).clone()) {
                    let places = found.entry(symbol).or_default();
                    if places.last() != Some(&place) {
                        places.push(place);
                    }
                }
            }
        }
        let found = Arc::new(found);
        self.dependences.insert(sum, Arc::clone(&found));
        found
    }

    /// Every symbol of an expression, each once, ascending.
    pub fn symbols_of(&mut self, sum: SumId) -> Vec<Symbol> {
        let symbols: Vec<Symbol> = self.dependence(sum).keys().copied().collect();
        work::count(symbols.len());
        symbols
    }

    fn symbols_of_atom(&mut self, atom: Atom) -> Vec<Symbol> {
        match atom {
            Atom::Symbol(symbol) => vec![symbol],
            Atom::Cos(inner) | Atom::Sin(inner) | Atom::Group(inner) => self.symbols_of(inner),
            Atom::Call(_, arguments) => arguments.into_iter().flat_map(|argument| self.symbols_of(argument)).collect(),
        }
    }
}
