//! Values of expressions at a point: the second route by which everything derived here is checked.

use super::coefficient::{Coefficient, CoefficientNode};
use super::sum::{Algebra, Atom, AtomId, SumId, Symbol};
use crate::work;

/// Where an expression is evaluated.
pub trait Point {
    fn symbol(&self, symbol: Symbol) -> f64;
    fn parameter(&self, index: usize) -> f64;
}

impl Algebra {
    pub fn evaluate(&self, sum: SumId, at: &impl Point) -> f64 {
        work::count(self.terms(sum).len());
        self.terms(sum)
            .iter()
            .map(|&(monomial, k)| {
                let factors = self.monomial(monomial).iter();
                factors.fold(self.evaluate_coefficient(k, at), |x, &(atom, n)| x * self.evaluate_atom(atom, at).powi(n))
            })
            .sum()
    }

    pub fn evaluate_coefficient(&self, k: Coefficient, at: &impl Point) -> f64 {
        let unsigned = |id| self.evaluate_coefficient(super::coefficient::unsigned(id), at);
        let magnitude = match self.coefficients.node(k.id) {
            CoefficientNode::Number(x) => *x,
            CoefficientNode::Pi => std::f64::consts::PI,
            CoefficientNode::Parameter(index) => at.parameter(*index),
            CoefficientNode::Conversion { times, over, pi } => times * std::f64::consts::PI.powi(*pi) / over,
            CoefficientNode::Add(a, b) => self.evaluate_coefficient(*a, at) + self.evaluate_coefficient(*b, at),
            CoefficientNode::Mul(a, b) => unsigned(*a) * unsigned(*b),
            CoefficientNode::Div(a, b) => unsigned(*a) / unsigned(*b),
            CoefficientNode::Call(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(|&x| self.evaluate_coefficient(x, at)).collect();
                function.evaluate(&arguments)
            }
        };
        if k.negative { -magnitude } else { magnitude }
    }

    fn evaluate_atom(&self, atom: AtomId, at: &impl Point) -> f64 {
        match self.atom(atom) {
            Atom::Symbol(symbol) => at.symbol(*symbol),
            Atom::Cos(angle) => self.evaluate(*angle, at).cos(),
            Atom::Sin(angle) => self.evaluate(*angle, at).sin(),
            Atom::Group(sum) => self.evaluate(*sum, at),
            Atom::Call(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(|&x| self.evaluate(x, at)).collect();
                function.evaluate(&arguments)
            }
        }
    }
}
