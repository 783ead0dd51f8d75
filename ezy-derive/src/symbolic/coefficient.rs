//! Expressions in parameters alone, shared by value.

use rustc_hash::FxHashMap;

use super::fingerprint::Fingerprint;
use crate::function::Function;

/// Index of a node of [`Coefficients`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CoefficientId(pub u32);

/// A node or its negative: `x` and `−x` share one node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Coefficient {
    pub id: CoefficientId,
    pub negative: bool,
}

/// How a coefficient is computed.
#[derive(Debug, Clone, PartialEq)]
pub enum CoefficientNode {
    /// Never negative.
    Number(f64),
    Pi,
    Parameter(usize),
    /// `times * pi^pi / over`: what turns numbers of a unit into SI units.
    Conversion {
        times: f64,
        over: f64,
        pi: i32,
    },
    Add(Coefficient, Coefficient),
    Mul(CoefficientId, CoefficientId),
    Div(CoefficientId, CoefficientId),
    Call(Function, Vec<Coefficient>),
}

/// All coefficients of a scene; ids are given in order of creation.
#[derive(Debug)]
pub struct Coefficients {
    nodes: Vec<(CoefficientNode, Fingerprint)>,
    ids: FxHashMap<Fingerprint, CoefficientId>,
}

impl Coefficient {
    pub const ZERO: Self = Self { id: CoefficientId(0), negative: false };
    pub const ONE: Self = Self { id: CoefficientId(1), negative: false };

    pub fn is_zero(self) -> bool {
        self.id == Self::ZERO.id
    }

    /// Whether this is 1 or −1.
    pub fn is_unit(self) -> bool {
        self.id == Self::ONE.id
    }

    pub fn neg(self) -> Self {
        if self.is_zero() { self } else { Self { id: self.id, negative: !self.negative } }
    }
}

impl Coefficients {
    pub fn new() -> Self {
        let mut new = Self { nodes: Vec::new(), ids: FxHashMap::default() };
        new.intern(CoefficientNode::Number(0.0), Fingerprint::ZERO);
        new.intern(CoefficientNode::Number(1.0), Fingerprint::ONE);
        new
    }

    pub fn node(&self, id: CoefficientId) -> &CoefficientNode {
        &self.nodes[id.0 as usize].0
    }

    /// The number, when the coefficient is one.
    pub fn as_number(&self, x: Coefficient) -> Option<f64> {
        match self.node(x.id) {
            CoefficientNode::Number(value) => Some(if x.negative { -value } else { *value }),
            _ => None,
        }
    }

    pub fn number(&mut self, x: f64) -> Coefficient {
        let magnitude = self.intern(CoefficientNode::Number(x.abs()), Fingerprint::number(x.abs()));
        if x < 0.0 { magnitude.neg() } else { magnitude }
    }

    pub fn pi(&mut self) -> Coefficient {
        self.intern(CoefficientNode::Pi, Fingerprint::random(&[0]))
    }

    pub fn parameter(&mut self, index: usize) -> Coefficient {
        self.intern(CoefficientNode::Parameter(index), Fingerprint::random(&[1, index as u64]))
    }

    /// Kept apart from equal numbers, since equations between quantities do not show it.
    pub fn conversion(&mut self, times: f64, over: f64, pi: i32) -> Coefficient {
        let key =
            |times: f64, over: f64, pi: i32| Fingerprint::random(&[4, times.to_bits(), over.to_bits(), pi as u64]);
        let is_inverse = times < over || (times == over && pi < 0);
        let fingerprint = if is_inverse { key(over, times, -pi).inverse() } else { key(times, over, pi) };
        self.intern(CoefficientNode::Conversion { times, over, pi }, fingerprint)
    }

    pub fn add(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
        if a.is_zero() {
            return b;
        }
        if b.is_zero() {
            return a;
        }
        let fingerprint = self.fingerprint(a).add(self.fingerprint(b));
        match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) => self.folded(x + y, fingerprint),
            _ => self.intern(CoefficientNode::Add(a, b), fingerprint),
        }
    }

    pub fn mul(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
        let negative = a.negative != b.negative;
        let magnitude = self.mul_magnitudes(a.id, b.id);
        if negative { magnitude.neg() } else { magnitude }
    }

    /// `a / b`; a division by an exact zero is kept, so that it shows at run time as a non-finite constant.
    pub fn div(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
        let negative = a.negative != b.negative;
        let magnitude = self.div_magnitudes(a.id, b.id);
        if negative { magnitude.neg() } else { magnitude }
    }

    pub fn call(&mut self, function: Function, arguments: Vec<Coefficient>) -> Coefficient {
        let numbers: Option<Vec<f64>> = arguments.iter().map(|&x| self.as_number(x)).collect();
        if let Some(numbers) = numbers {
            let value = function.evaluate(&numbers);
            if value.is_finite() {
                return self.number(value);
            }
        }
        let mut key = vec![2, function as u64];
        for &x in &arguments {
            key.extend(self.fingerprint(x).words());
        }
        self.intern(CoefficientNode::Call(function, arguments), Fingerprint::random(&key))
    }

    fn mul_magnitudes(&mut self, a: CoefficientId, b: CoefficientId) -> Coefficient {
        let (x, y) = (unsigned(a), unsigned(b));
        if x.is_zero() || y.is_unit() {
            return x;
        }
        if y.is_zero() || x.is_unit() {
            return y;
        }
        let fingerprint = self.fingerprint(x).mul(self.fingerprint(y));
        match (self.as_number(x), self.as_number(y)) {
            (Some(x), Some(y)) => self.folded(x * y, fingerprint),
            _ => self.intern(CoefficientNode::Mul(a, b), fingerprint),
        }
    }

    fn div_magnitudes(&mut self, a: CoefficientId, b: CoefficientId) -> Coefficient {
        let (x, y) = (unsigned(a), unsigned(b));
        if y.is_unit() || (x.is_zero() && !y.is_zero()) {
            return x;
        }
        if y.is_zero() {
            let key = [3, u64::from(a.0), u64::from(b.0)];
            return self.intern(CoefficientNode::Div(a, b), Fingerprint::random(&key));
        }
        let fingerprint = self.fingerprint(x).mul(self.fingerprint(y).inverse());
        match (self.as_number(x), self.as_number(y)) {
            (Some(x), Some(y)) => self.folded(x / y, fingerprint),
            _ => self.intern(CoefficientNode::Div(a, b), fingerprint),
        }
    }

    /// A number that came from folding; its fingerprint is that of the exact result.
    fn folded(&mut self, value: f64, fingerprint: Fingerprint) -> Coefficient {
        if value < 0.0 {
            self.intern(CoefficientNode::Number(-value), fingerprint.neg()).neg()
        } else {
            self.intern(CoefficientNode::Number(value), fingerprint)
        }
    }

    fn fingerprint(&self, x: Coefficient) -> Fingerprint {
        let value = self.nodes[x.id.0 as usize].1;
        if x.negative { value.neg() } else { value }
    }

    fn intern(&mut self, node: CoefficientNode, fingerprint: Fingerprint) -> Coefficient {
        if let Some(&id) = self.ids.get(&fingerprint) {
            return unsigned(id);
        }
        if let Some(&id) = self.ids.get(&fingerprint.neg()) {
            return unsigned(id).neg();
        }
        let id = CoefficientId(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        self.nodes.push((node, fingerprint));
        self.ids.insert(fingerprint, id);
        unsigned(id)
    }
}

pub fn unsigned(id: CoefficientId) -> Coefficient {
    Coefficient { id, negative: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_coefficients_with_equal_values_share_one_node() {
        let mut k = Coefficients::new();
        let (a, b) = (k.parameter(0), k.parameter(1));
        let sum = k.add(a, b);
        let square = k.mul(sum, sum);
        let (aa, ab, bb) = (k.mul(a, a), k.mul(a, b), k.mul(b, b));
        let two = k.number(2.0);
        let middle = k.mul(two, ab);
        let expanded = k.add(aa, middle);
        let expanded = k.add(expanded, bb);
        assert_eq!(square, expanded);
    }

    #[test]
    fn analytic_coefficient_that_cancels_is_zero() {
        let mut k = Coefficients::new();
        let (a, b) = (k.parameter(0), k.parameter(1));
        let quotient = k.div(a, b);
        let back = k.mul(quotient, b);
        assert!(k.add(back, a.neg()).is_zero());
    }

    #[test]
    fn analytic_numbers_are_folded_and_signs_are_kept_apart() {
        let mut k = Coefficients::new();
        let number = |k: &Coefficients, x: Coefficient| k.as_number(x);
        for (x, y) in [(2.0, 3.0), (2.0, -3.0), (-2.0, 0.5), (0.0, -1.5), (-1.0, 1.0), (4.0, 4.0), (-0.25, -0.25)] {
            let (a, b) = (k.number(x), k.number(y));
            let [sum, product, quotient] = [k.add(a, b), k.mul(a, b), k.div(a, b)];
            let found = [sum, product, quotient].map(|made| number(&k, made));
            assert_eq!(found, [x + y, x * y, x / y].map(|value| Some(value + 0.0)), "{x} {y}");
            assert_eq!(number(&k, a.neg()), Some(0.0 - x));
        }
        let [zero, one, minus] = [0.0, 1.0, -1.0].map(|x| k.number(x));
        assert_eq!((zero, one, minus), (Coefficient::ZERO, Coefficient::ONE, Coefficient::ONE.neg()));
        assert!(zero.neg() == zero && one.is_unit() && minus.is_unit() && !zero.is_unit() && !one.is_zero());
        // 0.1 + 0.2 keeps its exact value beside that of 0.3
        let [tenth, fifth] = [0.1, 0.2].map(|x| k.number(x));
        let sum = k.add(tenth, fifth);
        let back = k.add(sum, fifth.neg());
        assert_eq!(back, tenth);
    }

    #[test]
    fn analytic_units_and_zeros_leave_a_parameter_as_it_is() {
        let mut k = Coefficients::new();
        let p = k.parameter(0);
        let (zero, one, minus) = (Coefficient::ZERO, Coefficient::ONE, Coefficient::ONE.neg());
        assert_eq!([k.add(p, zero), k.add(zero, p), k.mul(p, one), k.mul(one, p), k.div(p, one)], [p; 5]);
        assert_eq!([k.mul(p, minus), k.mul(minus, p), k.div(p, minus), k.mul(p.neg(), one)], [p.neg(); 4]);
        assert_eq!([k.mul(p, zero), k.mul(zero, p), k.div(zero, p)], [zero; 3]);
        assert_eq!([k.div(p, p), k.div(p.neg(), p).neg(), k.mul(minus, minus)], [one; 3]);
        assert_eq!((k.as_number(p), k.mul(p.neg(), p.neg())), (None, k.mul(p, p)));
        assert_ne!(k.parameter(1), p);
        assert_ne!(k.pi(), p);
        let inverse = k.div(one, p);
        assert!(inverse != p && k.mul(inverse, p) == one);
    }

    /// Calls of numbers are numbers where they are finite; others are kept, each once.
    #[test]
    fn analytic_calls_are_folded_where_they_have_a_value() {
        let mut k = Coefficients::new();
        let [two, minus, p] = [k.number(2.0), k.number(-1.0), k.parameter(0)];
        let root = k.call(Function::Sqrt, vec![two]);
        assert_eq!(k.as_number(root), Some(2.0_f64.sqrt()));
        let undefined = k.call(Function::Sqrt, vec![minus]);
        assert!(k.as_number(undefined).is_none() && matches!(k.node(undefined.id), CoefficientNode::Call(..)));
        let of = |k: &mut Coefficients, function, x| k.call(function, vec![x]);
        let (sin, again, cos, of_minus) = (
            of(&mut k, Function::Sin, p),
            of(&mut k, Function::Sin, p),
            of(&mut k, Function::Cos, p),
            of(&mut k, Function::Sin, p.neg()),
        );
        assert!(sin == again && sin != cos && sin != of_minus, "one node for one call");
        assert_eq!(k.node(sin.id), &CoefficientNode::Call(Function::Sin, vec![p]));
    }

    /// A conversion is no number, and goes where its inverse comes.
    #[test]
    fn analytic_conversions_are_kept_apart_from_numbers_and_cancel() {
        let mut k = Coefficients::new();
        let of_number = k.number(1e3);
        let [kilo, milli] = [k.conversion(1e3, 1.0, 0), k.conversion(1.0, 1e3, 0)];
        let [degree, per_degree] = [k.conversion(1.0, 180.0, 1), k.conversion(180.0, 1.0, -1)];
        assert!(kilo != of_number && k.as_number(kilo).is_none() && degree != milli);
        assert_eq!([k.mul(kilo, milli), k.mul(degree, per_degree)], [Coefficient::ONE; 2]);
        assert_eq!(k.conversion(1e3, 1.0, 0), kilo);
    }

    #[test]
    fn analytic_divisions_by_zero_are_kept() {
        let mut k = Coefficients::new();
        let p = k.parameter(0);
        for top in [Coefficient::ZERO, Coefficient::ONE, p] {
            let kept = k.div(top, Coefficient::ZERO);
            assert_eq!(k.node(kept.id), &CoefficientNode::Div(top.id, Coefficient::ZERO.id));
            assert!(k.as_number(kept).is_none());
        }
    }
}
