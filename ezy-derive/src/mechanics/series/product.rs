//! Products of series: which sums `Σ x_j y_{n−j}` a scene needs.

use std::collections::BTreeMap;

use crate::symbolic::SumId;
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::program::{NodeId, Value};
use crate::symbolic::sum::{Algebra, MonomialId};

/// A product of series with the factor on the left known to order n − 1 when the sums for n are formed.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Product {
    pub left: Factor,
    pub right: RightFactor,
}

/// The series of a value, or with each coefficient times its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Factor {
    pub node: NodeId,
    pub scaled: bool,
}

/// What stands on the right.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum RightFactor {
    /// A value that depends on positions and time.
    Position(NodeId),
    /// A value that is known two orders later: it depends on velocities, or its partner does.
    Velocity(NodeId),
    /// `Σ k v_i` as coefficients of q times their order.
    Rates(Vec<(Value, usize)>),
    /// `Σ k λ_i`, known two orders later.
    Multipliers(Vec<(Value, usize)>),
}

/// `Σ x_i y_i` over varying entries x_i, in the fewest products: an outer coefficient, the varying factor, and the sum
/// that it multiplies.
#[derive(Debug, Clone, PartialEq)]
pub struct Term {
    pub outer: Coefficient,
    pub left: SumId,
    pub right: Vec<(Coefficient, usize)>,
}

/// Products of `entries` (index, x_i). Either each entry is a factor, or each product of atoms that occurs in them.
pub fn terms(algebra: &mut Algebra, entries: &[(usize, SumId)]) -> Vec<Term> {
    let varying = |algebra: &Algebra, entry: SumId| {
        algebra.terms(entry).iter().filter(|(monomial, _)| *monomial != MonomialId::ONE).copied().collect::<Vec<_>>()
    };
    let mut by_entry: BTreeMap<SumId, Vec<(Coefficient, usize)>> = BTreeMap::new();
    let mut by_monomial: BTreeMap<SumId, Vec<(Coefficient, usize)>> = BTreeMap::new();
    for &(i, entry) in entries {
        let parts = varying(algebra, entry);
        for &(monomial, k) in &parts {
            let factors = algebra.monomial(monomial).clone();
            let left = algebra.product(factors, Coefficient::ONE);
            by_monomial.entry(left).or_default().push((k, i));
            if parts.len() == 1 {
                by_entry.entry(left).or_default().push((k, i));
            }
        }
        if parts.len() > 1 {
            let left = algebra.sum(parts);
            by_entry.entry(left).or_default().push((Coefficient::ONE, i));
        }
    }
    let fewest = if by_monomial.len() < by_entry.len() { by_monomial } else { by_entry };
    let single = |right: Vec<(Coefficient, usize)>| match right.as_slice() {
        [(k, i)] => (*k, vec![(Coefficient::ONE, *i)]),
        _ => (Coefficient::ONE, right),
    };
    fewest
        .into_iter()
        .map(|(left, right)| {
            let (outer, right) = single(right);
            Term { outer, left, right }
        })
        .collect()
}
