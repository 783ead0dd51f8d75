//! How a sum is best written: which factors are taken out, and in which order terms are added.

use std::collections::HashMap;
use std::rc::Rc;

use super::coefficient::{Coefficient, CoefficientId, unsigned};
use super::sum::{Algebra, AtomId, Monomial, SumId};

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

/// Sums with more terms take the most frequent factor out without looking at alternatives.
const LARGEST_SEARCHED_SUM: usize = 12;

type Term = (Monomial, Coefficient);

/// Remembers the plans of sums already met.
#[derive(Debug, Default)]
pub struct Planner {
    plans: HashMap<Vec<Term>, (usize, Rc<Plan>)>,
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
        let mut terms: Vec<Term> =
            algebra.terms(sum).iter().map(|&(monomial, k)| (algebra.monomial(monomial).clone(), k)).collect();
        // what does not vary is added last, so that the varying part can be shared
        terms.sort_by_key(|(monomial, _)| monomial.is_empty());
        self.search(algebra, terms).1
    }

    fn search(&mut self, algebra: &Algebra, terms: Vec<Term>) -> (usize, Rc<Plan>) {
        if let [(monomial, k)] = terms.as_slice() {
            let factors: usize = monomial.iter().map(|(_, n)| n.unsigned_abs() as usize).sum();
            let cost = (factors + usize::from(!k.is_unit())).saturating_sub(1);
            return (cost, Rc::new(Plan::Term(*k, monomial.clone())));
        }
        if let Some(known) = self.plans.get(&terms) {
            return known.clone();
        }
        let mut candidates = candidates(algebra, &terms);
        if terms.len() > LARGEST_SEARCHED_SUM {
            candidates.truncate(1);
        }
        let mut best: Option<(usize, Rc<Plan>)> = None;
        for candidate in candidates {
            let found = self.take_out(algebra, &terms, candidate);
            if best.as_ref().is_none_or(|(cost, _)| found.0 < *cost) {
                best = Some(found);
            }
        }
        let best = best.unwrap_or_else(|| self.flat(algebra, &terms));
        self.plans.insert(terms, best.clone());
        best
    }

    fn take_out(&mut self, algebra: &Algebra, terms: &[Term], candidate: Candidate) -> (usize, Rc<Plan>) {
        let (mut inside, mut outside) = (Vec::new(), Vec::new());
        for (monomial, k) in terms {
            match candidate {
                Candidate::Coefficient(id) if k.id == id => {
                    inside.push((monomial.clone(), Coefficient { negative: k.negative, ..Coefficient::ONE }));
                }
                Candidate::Atom(atom, n) if exponent(monomial, atom) * n > 0 => {
                    let mut rest = monomial.clone();
                    rest.iter_mut().filter(|(a, _)| *a == atom).for_each(|(_, e)| *e -= n);
                    rest.retain(|(_, e)| *e != 0);
                    inside.push((rest, *k));
                }
                _ => outside.push((monomial.clone(), *k)),
            }
        }
        let (inner_cost, inner) = self.search(algebra, inside);
        let product = Rc::new(match candidate {
            Candidate::Coefficient(id) => Plan::Scale(unsigned(id), inner),
            Candidate::Atom(atom, n) => Plan::Factor(atom, n, inner),
        });
        if outside.is_empty() {
            return (inner_cost + 1, product);
        }
        let (outer_cost, outer) = self.search(algebra, outside);
        let mut parts = vec![product];
        match &*outer {
            Plan::Sum(more) => parts.extend(more.iter().cloned()),
            _ => parts.push(outer),
        }
        (inner_cost + 1 + outer_cost + 1, Rc::new(Plan::Sum(parts)))
    }

    fn flat(&mut self, algebra: &Algebra, terms: &[Term]) -> (usize, Rc<Plan>) {
        let parts: Vec<_> = terms.iter().map(|term| self.search(algebra, vec![term.clone()])).collect();
        let cost = parts.iter().map(|(cost, _)| cost).sum::<usize>() + parts.len().saturating_sub(1);
        (cost, Rc::new(Plan::Sum(parts.into_iter().map(|(_, plan)| plan).collect())))
    }
}

/// Everything that at least two terms share, best first.
fn candidates(algebra: &Algebra, terms: &[Term]) -> Vec<Candidate> {
    let mut coefficients: Vec<(CoefficientId, usize)> = Vec::new();
    let mut atoms: Vec<((AtomId, i32), usize)> = Vec::new();
    for (monomial, k) in terms {
        if !k.is_unit() {
            count(&mut coefficients, k.id);
        }
        for &(atom, n) in monomial {
            count(&mut atoms, (atom, n.signum()));
        }
    }
    coefficients.retain(|(_, n)| *n > 1);
    atoms.retain(|(_, n)| *n > 1);
    coefficients.sort_by_key(|&(id, n)| (std::cmp::Reverse(n), id));
    atoms.sort_by_key(|&((atom, n), uses)| (std::cmp::Reverse(uses), !algebra.is_trigonometric_atom(atom), atom, n));
    let coefficients = coefficients.into_iter().map(|(id, _)| Candidate::Coefficient(id));
    let atoms = atoms.into_iter().map(|((atom, n), _)| Candidate::Atom(atom, n));
    coefficients.chain(atoms).collect()
}

fn count<K: PartialEq>(list: &mut Vec<(K, usize)>, key: K) {
    match list.iter_mut().find(|(known, _)| *known == key) {
        Some((_, n)) => *n += 1,
        None => list.push((key, 1)),
    }
}

fn exponent(monomial: &Monomial, atom: AtomId) -> i32 {
    monomial.iter().find(|(a, _)| *a == atom).map_or(0, |&(_, n)| n)
}
