//! Partial derivatives.

use super::sum::{Algebra, Atom, AtomId, Monomial, SumId, Symbol};
use crate::function::Function;
use crate::work;

impl Algebra {
    /// ∂a/∂x, with every other symbol held.
    pub fn diff(&mut self, a: SumId, x: Symbol) -> SumId {
        work::count(1);
        if let Some(&known) = self.derivatives.get(&(a, x)) {
            return known;
        }
        let dependence = self.dependence(a);
        let Some(places) = dependence.get(&x) else { return SumId::ZERO };
        let derivative = self.diff_terms(a, places, x);
        self.derivatives.insert((a, x), derivative);
        derivative
    }

    /// Of the terms that hold x.
    fn diff_terms(&mut self, a: SumId, places: &[usize], x: Symbol) -> SumId {
        work::count(places.len());
        let mut parts = Vec::new();
        for &place in places {
            let (monomial, k) = self.terms(a)[place];
            let factors = self.monomial(monomial).clone();
            for (i, &(atom, n)) in factors.iter().enumerate() {
                let inner = self.diff_atom(atom, x);
                if inner.is_zero() {
                    continue;
                }
                let mut rest: Monomial = factors.clone();
                rest[i].1 -= 1;
                rest.retain(|&(_, n)| n != 0);
                let n = self.coefficients.number(f64::from(n));
                let k = self.coefficients.mul(k, n);
                let outer = self.product(rest, k);
                parts.push(self.mul(outer, inner));
            }
        }
        self.total(&parts)
    }

    fn diff_atom(&mut self, atom: AtomId, x: Symbol) -> SumId {
        match self.atom(atom).clone() {
            Atom::Symbol(symbol) => {
                if symbol == x {
                    SumId::ONE
                } else {
                    SumId::ZERO
                }
            }
            Atom::Group(a) => self.diff(a, x),
            Atom::Cos(angle) => {
                let rate = self.diff(angle, x);
                let (sin, _) = self.sin_cos(angle);
                let product = self.mul(sin, rate);
                self.neg(product)
            }
            Atom::Sin(angle) => {
                let rate = self.diff(angle, x);
                let (_, cos) = self.sin_cos(angle);
                self.mul(cos, rate)
            }
            Atom::Call(function, arguments) => self.diff_call(function, &arguments, x),
        }
    }

    fn diff_call(&mut self, function: Function, arguments: &[SumId], x: Symbol) -> SumId {
        let rates: Vec<SumId> = arguments.iter().map(|&a| self.diff(a, x)).collect();
        if rates.iter().all(|rate| rate.is_zero()) {
            return SumId::ZERO;
        }
        let value = self.atom_sum(Atom::Call(function, arguments.to_vec()));
        let (u, du) = (arguments[0], rates[0]);
        match function {
            Function::Sin | Function::Cos => diff_trigonometry(self, function, u, du),
            Function::Tan => {
                let square = self.power(value, 2);
                let slope = self.add(SumId::ONE, square);
                self.mul(slope, du)
            }
            Function::Asin | Function::Acos => {
                let square = self.power(u, 2);
                let rest = self.sub(SumId::ONE, square);
                let root = self.call(Function::Sqrt, vec![rest]);
                let slope = self.div(du, root);
                if function == Function::Acos { self.neg(slope) } else { slope }
            }
            Function::Sqrt => {
                let two = self.number(2.0);
                let double = self.mul(two, value);
                self.div(du, double)
            }
            Function::Exp => self.mul(value, du),
            Function::Ln => self.div(du, u),
            Function::Tanh => {
                let square = self.power(value, 2);
                let slope = self.sub(SumId::ONE, square);
                self.mul(slope, du)
            }
            Function::Abs => {
                let sign = self.call(Function::Sign, vec![u]);
                self.mul(sign, du)
            }
            Function::Sign => SumId::ZERO,
            Function::Atan2 => {
                let (w, dw) = (arguments[1], rates[1]);
                let (a, b) = (self.mul(w, du), self.mul(u, dw));
                let top = self.sub(a, b);
                let (uu, ww) = (self.power(u, 2), self.power(w, 2));
                let bottom = self.add(uu, ww);
                self.div(top, bottom)
            }
            Function::Min | Function::Max => {
                // (du + dw)/2 ± sign(u − w) (du − dw)/2
                let (w, dw) = (arguments[1], rates[1]);
                let difference = self.sub(u, w);
                let sign = self.call(Function::Sign, vec![difference]);
                let sign = if function == Function::Min { self.neg(sign) } else { sign };
                let (sum, gap) = (self.add(du, dw), self.sub(du, dw));
                let blend = self.mul(sign, gap);
                let twice = self.add(sum, blend);
                let half = self.coefficients.number(0.5);
                self.scale(twice, half)
            }
            Function::Pow => self.diff_power(arguments, &rates, value),
        }
    }

    /// d(uʷ) = w u^(w−1) du + uʷ ln(u) dw
    fn diff_power(&mut self, arguments: &[SumId], rates: &[SumId], value: SumId) -> SumId {
        let (u, w) = (arguments[0], arguments[1]);
        let exponent = self.sub(w, SumId::ONE);
        let lower = self.pow(u, exponent);
        let slope = self.mul(w, lower);
        let first = self.mul(slope, rates[0]);
        if rates[1].is_zero() {
            return first;
        }
        let logarithm = self.call(Function::Ln, vec![u]);
        let growth = self.mul(value, logarithm);
        let second = self.mul(growth, rates[1]);
        self.add(first, second)
    }
}

/// Derivative of a sine or cosine that was not split into [`Atom::Sin`] and [`Atom::Cos`].
fn diff_trigonometry(algebra: &mut Algebra, function: Function, u: SumId, du: SumId) -> SumId {
    let (sin, cos) = algebra.sin_cos(u);
    if function == Function::Sin {
        algebra.mul(cos, du)
    } else {
        let slope = algebra.mul(sin, du);
        algebra.neg(slope)
    }
}
