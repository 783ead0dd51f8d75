//! Sums of products of atoms in normal form.

use std::collections::BTreeMap;
use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::coefficient::{Coefficient, Coefficients};
use super::interner::Interner;
use crate::function::Function;
use crate::work;

/// A variable of an expression; what it stands for is known to the caller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Symbol(pub u32);

impl Symbol {
    /// Time is always the first symbol.
    pub const TIME: Self = Self(0);
}

/// For each symbol of a sum, the places of the terms that hold it, ascending.
pub type Dependence = BTreeMap<Symbol, Vec<usize>>;

/// Index of a sum: equal sums have equal ids.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SumId(pub u32);

/// Index of an atom.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AtomId(pub u32);

/// Index of a product of atoms.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MonomialId(pub u32);

/// What a product can contain.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Atom {
    Symbol(Symbol),
    Cos(SumId),
    Sin(SumId),
    Call(Function, Vec<SumId>),
    /// A sum in parentheses: kept whole because multiplying it out would lose digits.
    Group(SumId),
}

/// A product of atoms with whole exponents, ascending by atom; no exponent is zero.
pub type Monomial = Vec<(AtomId, i32)>;

/// Terms ascending by monomial; no coefficient is zero.
pub type Terms = Vec<(MonomialId, Coefficient)>;

/// All expressions of a scene; ids are given in order of creation, so that results repeat.
#[derive(Debug)]
pub struct Algebra {
    pub coefficients: Coefficients,
    atoms: Interner<Atom>,
    monomials: Interner<Monomial>,
    sums: Interner<Terms>,
    /// Of sums that were differentiated: without it the time would double with every law inside of a law.
    pub(super) derivatives: FxHashMap<(SumId, Symbol), SumId>,
    /// Of sums that were differentiated or asked for their symbols.
    pub(super) dependences: FxHashMap<SumId, Arc<Dependence>>,
}

impl SumId {
    pub const ZERO: Self = Self(0);
    pub const ONE: Self = Self(1);

    pub fn is_zero(self) -> bool {
        self == Self::ZERO
    }
}

impl MonomialId {
    /// The empty product, 1.
    pub const ONE: Self = Self(0);
}

impl Algebra {
    pub fn new() -> Self {
        let mut new = Self {
            coefficients: Coefficients::new(),
            atoms: Interner::default(),
            monomials: Interner::default(),
            sums: Interner::default(),
            derivatives: FxHashMap::default(),
            dependences: FxHashMap::default(),
        };
        new.monomials.intern(Vec::new());
        new.sums.intern(Vec::new());
        new.sums.intern(vec![(MonomialId::ONE, Coefficient::ONE)]);
        new
    }

    pub fn atom(&self, id: AtomId) -> &Atom {
        self.atoms.get(id.0)
    }

    pub fn monomial(&self, id: MonomialId) -> &Monomial {
        self.monomials.get(id.0)
    }

    pub fn terms(&self, id: SumId) -> &Terms {
        self.sums.get(id.0)
    }

    /// The value, when the sum does not depend on the motion.
    pub fn as_coefficient(&self, id: SumId) -> Option<Coefficient> {
        match self.terms(id).as_slice() {
            [] => Some(Coefficient::ZERO),
            [(MonomialId::ONE, k)] => Some(*k),
            _ => None,
        }
    }

    /// The symbol, when the sum is nothing else.
    pub fn as_symbol(&self, id: SumId) -> Option<Symbol> {
        let [(monomial, Coefficient::ONE)] = self.terms(id)[..] else { return None };
        let [(atom, 1)] = self.monomial(monomial)[..] else { return None };
        match self.atom(atom) {
            Atom::Symbol(symbol) => Some(*symbol),
            _ => None,
        }
    }

    pub fn constant(&mut self, k: Coefficient) -> SumId {
        self.sum(vec![(MonomialId::ONE, k)])
    }

    pub fn number(&mut self, x: f64) -> SumId {
        let k = self.coefficients.number(x);
        self.constant(k)
    }

    pub fn symbol(&mut self, symbol: Symbol) -> SumId {
        self.atom_sum(Atom::Symbol(symbol))
    }

    /// The sum that is one atom.
    pub fn atom_sum(&mut self, atom: Atom) -> SumId {
        let id = self.intern_atom(atom);
        self.product(vec![(id, 1)], Coefficient::ONE)
    }

    pub fn intern_atom(&mut self, atom: Atom) -> AtomId {
        AtomId(self.atoms.intern(atom))
    }

    /// One term. The monomial must be in normal form.
    pub fn product(&mut self, monomial: Monomial, k: Coefficient) -> SumId {
        let monomial = MonomialId(self.monomials.intern(monomial));
        self.sum(vec![(monomial, k)])
    }

    pub fn intern_monomial(&mut self, monomial: Monomial) -> MonomialId {
        MonomialId(self.monomials.intern(monomial))
    }

    /// Adds like terms and sorts.
    pub fn sum(&mut self, mut terms: Terms) -> SumId {
        work::count(terms.len());
        terms.sort_by_key(|(monomial, _)| *monomial);
        let mut merged: Terms = Vec::with_capacity(terms.len());
        for (monomial, k) in terms {
            match merged.last_mut() {
                Some((last, total)) if *last == monomial => *total = self.coefficients.add(*total, k),
                _ => merged.push((monomial, k)),
            }
        }
        merged.retain(|(_, k)| !k.is_zero());
        SumId(self.sums.intern(merged))
    }

    pub fn add(&mut self, a: SumId, b: SumId) -> SumId {
        let terms = [self.terms(a).as_slice(), self.terms(b).as_slice()].concat();
        self.sum(terms)
    }

    pub fn neg(&mut self, a: SumId) -> SumId {
        self.scale(a, Coefficient::ONE.neg())
    }

    pub fn sub(&mut self, a: SumId, b: SumId) -> SumId {
        let minus_b = self.neg(b);
        self.add(a, minus_b)
    }

    pub fn scale(&mut self, a: SumId, k: Coefficient) -> SumId {
        let mut terms = self.terms(a).clone();
        for (_, factor) in &mut terms {
            *factor = self.coefficients.mul(*factor, k);
        }
        self.sum(terms)
    }

    /// The sum of many; cheaper than repeated [`Algebra::add`].
    pub fn total(&mut self, parts: &[SumId]) -> SumId {
        let terms: Terms = parts.iter().flat_map(|&part| self.terms(part).clone()).collect();
        self.sum(terms)
    }
}

impl Default for Algebra {
    fn default() -> Self {
        Self::new()
    }
}
