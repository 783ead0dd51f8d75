//! Function calls: what is constant becomes a coefficient, cosines of sums are split by angle.

use super::coefficient::Coefficient;
use super::sum::{Algebra, Atom, MonomialId, SumId, Symbol};
use crate::function::Function;

impl Algebra {
    pub fn call(&mut self, function: Function, arguments: Vec<SumId>) -> SumId {
        let constants: Option<Vec<Coefficient>> = arguments.iter().map(|&x| self.as_coefficient(x)).collect();
        if let Some(constants) = constants {
            let value = self.coefficients.call(function, constants);
            return self.constant(value);
        }
        match (function, arguments.as_slice()) {
            (Function::Sin, &[x]) => self.sin_cos(x).0,
            (Function::Cos, &[x]) => self.sin_cos(x).1,
            _ => self.atom_sum(Atom::Call(function, arguments)),
        }
    }

    /// Sine and cosine of an angle. A sum of body angles and constants is split by the addition theorems, so
    /// that a kernel needs one sine–cosine pair for each body angle and no other.
    pub fn sin_cos(&mut self, angle: SumId) -> (SumId, SumId) {
        if let Some(k) = self.as_coefficient(angle) {
            let sin = self.coefficients.call(Function::Sin, vec![k]);
            let cos = self.coefficients.call(Function::Cos, vec![k]);
            return (self.constant(sin), self.constant(cos));
        }
        let terms = self.terms(angle).clone();
        if terms.len() > 1 && terms.iter().all(|&(monomial, k)| self.splits(monomial, k)) {
            let mut sin = SumId::ZERO;
            let mut cos = SumId::ONE;
            for term in terms {
                let part = self.sum(vec![term]);
                let (s, c) = self.sin_cos(part);
                let (sc, cs) = (self.mul(sin, c), self.mul(cos, s));
                let (cc, ss) = (self.mul(cos, c), self.mul(sin, s));
                sin = self.add(sc, cs);
                cos = self.sub(cc, ss);
            }
            return (sin, cos);
        }
        let negative = terms[0].1.negative;
        let positive = if negative { self.neg(angle) } else { angle };
        let (sin, cos) = (self.atom_sum(Atom::Sin(positive)), self.atom_sum(Atom::Cos(positive)));
        if negative { (self.neg(sin), cos) } else { (sin, cos) }
    }

    /// Whether a term of an angle is a constant or a bare symbol other than time.
    fn splits(&self, monomial: MonomialId, k: Coefficient) -> bool {
        match self.monomial(monomial).as_slice() {
            [] => true,
            [(atom, 1)] => k.is_unit() && matches!(self.atom(*atom), Atom::Symbol(symbol) if *symbol != Symbol::TIME),
            _ => false,
        }
    }
}
