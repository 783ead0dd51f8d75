//! Products, quotients and powers in normal form.

use super::coefficient::Coefficient;
use super::sum::{Algebra, Atom, AtomId, Monomial, MonomialId, SumId, Terms};
use crate::function::Function;

/// Whole exponents up to this size are multiplied out; larger ones call `pow`.
const LARGEST_WHOLE_EXPONENT: f64 = 8.0;

impl Algebra {
    /// `a b`. Two factors of several terms are multiplied out only when one of them holds nothing but sines
    /// and cosines: products of lengths or of speeds stay factored, because expanding `(x₁ − x₂)²` cancels.
    pub fn mul(&mut self, a: SumId, b: SumId) -> SumId {
        let several = self.terms(a).len() > 1 && self.terms(b).len() > 1;
        if several && !self.is_trigonometric(a) && !self.is_trigonometric(b) {
            let (a, b) = (self.group(a), self.group(b));
            return self.expand(a, b);
        }
        self.expand(a, b)
    }

    /// `a / b`
    pub fn div(&mut self, a: SumId, b: SumId) -> SumId {
        if let Some(k) = self.as_coefficient(b) {
            if k.is_zero() {
                // kept, so that it shows at run time: 0/0 is not 0
                let top = self.as_coefficient(a).unwrap_or(Coefficient::ONE);
                let undefined = self.coefficients.div(top, k);
                return self.constant(undefined);
            }
            let inverse = self.coefficients.div(Coefficient::ONE, k);
            let mut terms = self.terms(a).clone();
            for (_, factor) in &mut terms {
                *factor =
                    if factor.is_unit() && !factor.negative { inverse } else { self.coefficients.div(*factor, k) };
            }
            return self.sum(terms);
        }
        let inverse = self.reciprocal(b);
        self.mul(a, inverse)
    }

    /// `a^n` for a whole n.
    pub fn power(&mut self, a: SumId, n: i32) -> SumId {
        if n < 0 {
            let inverse = self.reciprocal(a);
            return self.power(inverse, -n);
        }
        let base = if n > 1 && self.terms(a).len() > 1 && !self.is_trigonometric(a) { self.group(a) } else { a };
        (0..n).fold(SumId::ONE, |product, _| self.expand(product, base))
    }

    /// `a^b`
    pub fn pow(&mut self, a: SumId, b: SumId) -> SumId {
        let exponent = self.as_coefficient(b).and_then(|k| self.coefficients.as_number(k));
        match exponent {
            Some(n) if n.fract() == 0.0 && n.abs() <= LARGEST_WHOLE_EXPONENT => self.power(a, n as i32),
            Some(0.5) => self.call(Function::Sqrt, vec![a]),
            _ => self.call(Function::Pow, vec![a, b]),
        }
    }

    /// The sum as one factor. Its first term is positive, so that `a − b` and `b − a` share it.
    fn group(&mut self, a: SumId) -> SumId {
        let negative = match self.terms(a).as_slice() {
            [_, _, ..] => self.terms(a)[0].1.negative,
            _ => return a,
        };
        let positive = if negative { self.neg(a) } else { a };
        let group = self.atom_sum(Atom::Group(positive));
        if negative { self.neg(group) } else { group }
    }

    fn reciprocal(&mut self, a: SumId) -> SumId {
        let single = self.group(a);
        match self.terms(single).as_slice() {
            [(monomial, k)] => {
                let (monomial, k) = (*monomial, *k);
                let inverse: Monomial = self.monomial(monomial).iter().map(|&(atom, n)| (atom, -n)).collect();
                let k = self.coefficients.div(Coefficient::ONE, k);
                self.product(inverse, k)
            }
            _ => {
                let infinite = self.coefficients.div(Coefficient::ONE, Coefficient::ZERO);
                self.constant(infinite)
            }
        }
    }

    /// Whether every atom is a sine or a cosine.
    pub fn is_trigonometric(&self, a: SumId) -> bool {
        self.terms(a).iter().all(|&(monomial, _)| {
            self.monomial(monomial).iter().all(|&(atom, n)| n > 0 && self.is_trigonometric_atom(atom))
        })
    }

    pub fn is_trigonometric_atom(&self, atom: AtomId) -> bool {
        matches!(self.atom(atom), Atom::Cos(_) | Atom::Sin(_))
    }

    fn expand(&mut self, a: SumId, b: SumId) -> SumId {
        let (left, right) = (self.terms(a).clone(), self.terms(b).clone());
        let mut out: Terms = Vec::with_capacity(left.len() * right.len());
        for &(x, kx) in &left {
            for &(y, ky) in &right {
                let k = self.coefficients.mul(kx, ky);
                let product = merge(self.monomial(x), self.monomial(y));
                self.push_reduced(product, k, &mut out);
            }
        }
        self.sum(out)
    }

    /// Appends a product with `sin² = 1 − cos²` applied until no sine has an exponent above one.
    fn push_reduced(&mut self, monomial: Monomial, k: Coefficient, out: &mut Terms) {
        let square = monomial.iter().position(|&(atom, n)| n >= 2 && matches!(self.atom(atom), Atom::Sin(_)));
        let Some(i) = square else {
            let monomial: MonomialId = self.intern_monomial(monomial);
            out.push((monomial, k));
            return;
        };
        let Atom::Sin(angle) = *self.atom(monomial[i].0) else { return };
        let cos = self.intern_atom(Atom::Cos(angle));
        let mut rest = monomial;
        rest[i].1 -= 2;
        rest.retain(|&(_, n)| n != 0);
        let with_cos = merge(&rest, &[(cos, 2)]);
        self.push_reduced(rest, k, out);
        self.push_reduced(with_cos, k.neg(), out);
    }
}

/// Product of two monomials, ascending, exponents added.
fn merge(a: &[(AtomId, i32)], b: &[(AtomId, i32)]) -> Monomial {
    let mut out: Monomial = [a, b].concat();
    out.sort_by_key(|(atom, _)| *atom);
    out.dedup_by(|next, kept| {
        let same = next.0 == kept.0;
        if same {
            kept.1 += next.1;
        }
        same
    });
    out.retain(|&(_, n)| n != 0);
    out
}
