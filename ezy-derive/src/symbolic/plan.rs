//! The cheapest form of a sum: which factors are taken out, and in which order terms are added.

use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::coefficient::{Coefficient, CoefficientId, unsigned};
use super::interner::Interner;
use super::sum::{Algebra, AtomId, Monomial, MonomialId, SumId};
use crate::work;

/// A way to write a sum.
#[derive(Debug)]
pub enum Plan {
    /// Coefficient times a product.
    Term(Coefficient, Monomial),
    /// A coefficient taken out.
    Scale(Coefficient, Rc<Plan>),
    /// An atom taken out, or divided by when its exponent is negative.
    Factor(AtomId, i32, Rc<Plan>),
    Sum(Vec<Rc<Plan>>),
}

/// Longer sums take out the most frequent factor without a search.
const LARGEST_SEARCHED_SUM: usize = 12;

/// Parts of the sums of one kernel that are searched; further ones take out the most frequent factor, too. A dozen products of
/// powers have millions of parts, the kernels of a vehicle some thousands.
const MOST_SEARCHED_PARTS: usize = 100_000;

/// A term of a sum; its product is one of the planner's.
type Term = (MonomialId, Coefficient);

/// Remembers the plans of sums already met.
#[derive(Debug, Default)]
pub struct Planner {
    plans: FxHashMap<Vec<Term>, (usize, Rc<Plan>)>,
    /// Parts that were searched.
    n_searched: usize,
    /// Products of sums and what is left of them.
    monomials: Interner<Monomial>,
    /// A product without a factor, where it has it.
    quotients: FxHashMap<(MonomialId, AtomId, i32), Option<MonomialId>>,
}

/// What could be taken out of a sum.
#[derive(Debug, Clone, Copy)]
enum Candidate {
    Coefficient(CoefficientId),
    Atom(AtomId, i32),
}

impl Planner {
    /// The cheapest of the plans considered; on equal cost, coefficients before sines and cosines before the rest.
    pub fn plan(&mut self, algebra: &Algebra, sum: SumId) -> Rc<Plan> {
        // what does not vary is added last, so that the varying part can be shared
        let (fixed, varying): (Vec<_>, Vec<_>) =
            algebra.terms(sum).iter().partition(|(monomial, _)| *monomial == MonomialId::ONE);
        let mut own =
            |&(monomial, k): &Term| (MonomialId(self.monomials.intern(algebra.monomial(monomial).clone())), k);
        let terms = varying.iter().chain(&fixed).map(&mut own).collect();
        self.search(algebra, terms).1
    }

    fn search(&mut self, algebra: &Algebra, terms: Vec<Term>) -> (usize, Rc<Plan>) {
        if let [(monomial, k)] = terms.as_slice() {
            let monomial = self.monomials.get(monomial.0);
            let factors: usize = monomial.iter().map(|(_, n)| n.unsigned_abs() as usize).sum();
            let cost = (factors + usize::from(!k.is_unit())).saturating_sub(1);
            return (cost, Rc::new(Plan::Term(*k, monomial.clone())));
        }
        if let Some(known) = self.plans.get(&terms) {
            return known.clone();
        }
        work::count(terms.len());
        let mut candidates = self.candidates(algebra, &terms);
        self.n_searched += 1;
        if terms.len() > LARGEST_SEARCHED_SUM || self.n_searched > MOST_SEARCHED_PARTS {
            candidates.truncate(1);
        }
        let mut best: Option<(usize, Rc<Plan>)> = None;
        for candidate in candidates {
            let dearest = best.as_ref().map_or(usize::MAX, |(cost, _)| *cost);
            best = self.take_out(algebra, &terms, candidate, dearest).or(best);
        }
        let best = best.unwrap_or_else(|| self.flat(algebra, &terms));
        self.plans.insert(terms, best.clone());
        best
    }

    /// The plan with this taken out, if it costs less than the dearest.
    fn take_out(
        &mut self,
        algebra: &Algebra,
        terms: &[Term],
        candidate: Candidate,
        dearest: usize,
    ) -> Option<(usize, Rc<Plan>)> {
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        for &(monomial, k) in terms {
            match candidate {
                Candidate::Coefficient(id) if k.id == id => {
                    inside.push((monomial, Coefficient { negative: k.negative, ..Coefficient::ONE }));
                }
                Candidate::Atom(atom, n) => match self.quotient(monomial, atom, n) {
                    Some(rest) => inside.push((rest, k)),
                    None => outside.push((monomial, k)),
                },
                _ => outside.push((monomial, k)),
            }
        }
        let (inner_cost, inner) = self.search(algebra, inside);
        // each term outside is one addition at least
        if inner_cost + 1 + outside.len() >= dearest {
            return None;
        }
        let product = Rc::new(match candidate {
            Candidate::Coefficient(id) => Plan::Scale(unsigned(id), inner),
            Candidate::Atom(atom, n) => Plan::Factor(atom, n, inner),
        });
        if outside.is_empty() {
            return Some((inner_cost + 1, product));
        }
        let (outer_cost, outer) = self.search(algebra, outside);
        let cost = inner_cost + 1 + outer_cost + 1;
        if cost >= dearest {
            return None;
        }
        let mut parts = vec![product];
        match &*outer {
            Plan::Sum(more) => parts.extend(more.iter().cloned()),
            _ => parts.push(outer),
        }
        Some((cost, Rc::new(Plan::Sum(parts))))
    }

    /// The product with one factor fewer, or with one division fewer where n is −1; none where it has no such factor.
    fn quotient(&mut self, monomial: MonomialId, atom: AtomId, n: i32) -> Option<MonomialId> {
        let monomials = &mut self.monomials;
        *self.quotients.entry((monomial, atom, n)).or_insert_with(|| {
            let mut rest = monomials.get(monomial.0).clone();
            let i = rest.iter().position(|(a, e)| *a == atom && e * n > 0)?;
            rest[i].1 -= n;
            rest.retain(|(_, e)| *e != 0);
            Some(MonomialId(monomials.intern(rest)))
        })
    }

    fn flat(&mut self, algebra: &Algebra, terms: &[Term]) -> (usize, Rc<Plan>) {
        let parts: Vec<_> = terms.iter().map(|&term| self.search(algebra, vec![term])).collect();
        let cost = parts.iter().map(|(cost, _)| cost).sum::<usize>() + parts.len().saturating_sub(1);
        (cost, Rc::new(Plan::Sum(parts.into_iter().map(|(_, plan)| plan).collect())))
    }

    /// Everything that at least two terms share, best first.
    fn candidates(&self, algebra: &Algebra, terms: &[Term]) -> Vec<Candidate> {
        let mut coefficients: Vec<(CoefficientId, usize)> = Vec::new();
        let mut atoms: Vec<((AtomId, i32), usize)> = Vec::new();
        for (monomial, k) in terms {
            if !k.is_unit() {
                count(&mut coefficients, k.id);
            }
            for &(atom, n) in self.monomials.get(monomial.0) {
                count(&mut atoms, (atom, n.signum()));
            }
        }
        coefficients.retain(|(_, n)| *n > 1);
        atoms.retain(|(_, n)| *n > 1);
        coefficients.sort_by_key(|&(id, n)| (std::cmp::Reverse(n), id));
        atoms
            .sort_by_key(|&((atom, n), uses)| (std::cmp::Reverse(uses), !algebra.is_trigonometric_atom(atom), atom, n));
        let coefficients = coefficients.into_iter().map(|(id, _)| Candidate::Coefficient(id));
        let atoms = atoms.into_iter().map(|((atom, n), _)| Candidate::Atom(atom, n));
        coefficients.chain(atoms).collect()
    }
}

fn count<K: PartialEq>(list: &mut Vec<(K, usize)>, key: K) {
    work::count(list.len());
    match list.iter_mut().find(|(known, _)| *known == key) {
        Some((_, n)) => *n += 1,
        None => list.push((key, 1)),
    }
}
