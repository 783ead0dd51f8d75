//! Other sums in place of atoms.

use super::sum::{Algebra, Atom, AtomId, SumId, Symbol};

impl Algebra {
    /// `a` with what `other` says in place of each atom; the atom itself, with the same done within it, where that says nothing.
    pub fn substitute(&mut self, a: SumId, other: &mut dyn FnMut(&mut Self, &Atom) -> Option<SumId>) -> SumId {
        let mut parts = Vec::new();
        for (monomial, k) in self.terms(a).clone() {
            let mut part = self.constant(k);
            for (atom, n) in self.monomial(monomial).clone() {
                let factor = self.substitute_in_atom(atom, other);
                let factor = self.power(factor, n);
                part = self.mul(part, factor);
            }
            parts.push(part);
        }
        self.total(&parts)
    }

    /// `a` with zero in place of every symbol that `vanishes`.
    pub fn at_zero(&mut self, a: SumId, vanishes: &dyn Fn(Symbol) -> bool) -> SumId {
        self.substitute(a, &mut |_, atom| match atom {
            Atom::Symbol(symbol) if vanishes(*symbol) => Some(SumId::ZERO),
            _ => None,
        })
    }

    fn substitute_in_atom(&mut self, atom: AtomId, other: &mut dyn FnMut(&mut Self, &Atom) -> Option<SumId>) -> SumId {
        let atom = self.atom(atom).clone();
        if let Some(found) = other(self, &atom) {
            return found;
        }
        match atom {
            Atom::Symbol(_) => self.atom_sum(atom),
            // where nothing changes it stays whole
            Atom::Group(inner) => match self.substitute(inner, other) {
                same if same == inner => self.atom_sum(atom),
                changed => changed,
            },
            Atom::Sin(angle) | Atom::Cos(angle) => {
                let inner = self.substitute(angle, other);
                if inner == angle {
                    return self.atom_sum(atom);
                }
                let (sin, cos) = self.sin_cos(inner);
                if matches!(atom, Atom::Sin(_)) { sin } else { cos }
            }
            Atom::Call(function, arguments) => {
                let arguments = arguments.into_iter().map(|argument| self.substitute(argument, other)).collect();
                self.call(function, arguments)
            }
        }
    }
}
