//! The value of a sum where some of its symbols are zero.

use super::sum::{Algebra, Atom, AtomId, SumId, Symbol};

impl Algebra {
    /// `a` with every symbol that `vanishes` replaced by zero. Symbols inside sines and calls are kept: this is used for
    /// velocity constraints, which are linear in the symbols that vanish.
    pub fn at_zero(&mut self, a: SumId, vanishes: &dyn Fn(Symbol) -> bool) -> SumId {
        let mut parts = Vec::new();
        for (monomial, k) in self.terms(a).clone() {
            let mut part = self.constant(k);
            for (atom, n) in self.monomial(monomial).clone() {
                let factor = self.atom_at_zero(atom, vanishes);
                let factor = self.power(factor, n);
                part = self.mul(part, factor);
            }
            parts.push(part);
        }
        self.total(&parts)
    }

    fn atom_at_zero(&mut self, atom: AtomId, vanishes: &dyn Fn(Symbol) -> bool) -> SumId {
        match self.atom(atom).clone() {
            Atom::Symbol(symbol) if vanishes(symbol) => SumId::ZERO,
            Atom::Group(a) => self.at_zero(a, vanishes),
            kept => self.atom_sum(kept),
        }
    }
}
