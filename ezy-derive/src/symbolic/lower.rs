//! From sums to a straight-line program.

use rustc_hash::FxHashMap;
use std::rc::Rc;

use super::coefficient::{Coefficient, CoefficientId};
use super::plan::{Plan, Planner};
use super::program::{Node, Program, Value};
use super::sum::{Algebra, Atom, AtomId, Monomial, SumId, Symbol};
use crate::function::Function;

/// The coefficients that kernels read, in order of first use: the vector of constants of a scene.
#[derive(Debug, Clone, Default)]
pub struct ConstantPool {
    order: Vec<CoefficientId>,
    ids: FxHashMap<CoefficientId, usize>,
}

impl ConstantPool {
    /// Place of a coefficient in the vector.
    pub fn index(&mut self, id: CoefficientId) -> usize {
        *self.ids.entry(id).or_insert_with(|| {
            self.order.push(id);
            self.order.len() - 1
        })
    }

    pub fn coefficients(&self) -> &[CoefficientId] {
        &self.order
    }
}

/// Builds the program of one kernel.
#[derive(Debug)]
pub struct Lowering<'a> {
    pub algebra: &'a Algebra,
    pub program: Program,
    constants: &'a mut ConstantPool,
    planner: Planner,
    bindings: FxHashMap<Symbol, Value>,
    /// Sine and cosine of angles that are bare symbols.
    sines: FxHashMap<Symbol, [Value; 2]>,
    done: FxHashMap<SumId, Value>,
}

impl<'a> Lowering<'a> {
    pub fn new(algebra: &'a Algebra, constants: &'a mut ConstantPool) -> Self {
        Self {
            algebra,
            program: Program::default(),
            constants,
            planner: Planner::default(),
            bindings: FxHashMap::default(),
            sines: FxHashMap::default(),
            done: FxHashMap::default(),
        }
    }

    /// From here on `symbol` stands for a value already computed.
    pub fn bind(&mut self, symbol: Symbol, value: Value) {
        self.bindings.insert(symbol, value);
    }

    pub fn is_bound(&self, symbol: Symbol) -> bool {
        self.bindings.contains_key(&symbol)
    }

    /// What a symbol stands for.
    pub fn symbol(&mut self, symbol: Symbol) -> Value {
        match self.bindings.get(&symbol) {
            Some(&value) => value,
            None => self.program.leaf(Node::Input(symbol)),
        }
    }

    /// From here on these are sine and cosine of `symbol`, already computed.
    pub fn bind_sines(&mut self, symbol: Symbol, sines: [Value; 2]) {
        self.sines.insert(symbol, sines);
    }

    /// What was lowered is lowered anew, with other values bound; equal operations stay one.
    pub fn forget(&mut self) {
        self.done.clear();
    }

    pub fn lower(&mut self, sum: SumId) -> Value {
        if let Some(&value) = self.done.get(&sum) {
            return value;
        }
        let value = if sum.is_zero() {
            self.program.literal(0.0)
        } else {
            let plan = self.planner.plan(self.algebra, sum);
            self.write(&plan)
        };
        self.done.insert(sum, value);
        value
    }

    pub fn coefficient(&mut self, k: Coefficient) -> Value {
        if let Some(number) = self.algebra.coefficients.as_number(k) {
            return self.program.literal(number);
        }
        let index = self.constants.index(k.id);
        let value = self.program.leaf(Node::Constant(index));
        if k.negative { value.neg() } else { value }
    }

    fn write(&mut self, plan: &Rc<Plan>) -> Value {
        match &**plan {
            Plan::Term(k, monomial) => self.term(*k, monomial),
            Plan::Scale(k, inner) => {
                let inner = self.write(inner);
                let k = self.coefficient(*k);
                self.program.mul(k, inner)
            }
            Plan::Factor(atom, n, inner) => {
                let inner = self.write(inner);
                let atom = self.atom(*atom);
                if *n > 0 { self.program.mul(atom, inner) } else { self.program.div(inner, atom) }
            }
            Plan::Sum(parts) => {
                let mut total = self.program.literal(0.0);
                for part in parts {
                    let part = self.write(part);
                    total = self.program.add(total, part);
                }
                total
            }
        }
    }

    /// Coefficient, then everything but sines and cosines, then those: the prefix is what other rows share.
    fn term(&mut self, k: Coefficient, monomial: &Monomial) -> Value {
        let (trigonometric, other): (Vec<_>, Vec<_>) =
            monomial.iter().partition(|(atom, _)| self.algebra.is_trigonometric_atom(*atom));
        let mut product = self.coefficient(k);
        for &(atom, n) in other.iter().chain(&trigonometric) {
            let factor = self.atom(atom);
            for _ in 0..n.max(0) {
                product = self.program.mul(product, factor);
            }
        }
        for &(atom, n) in monomial {
            let factor = self.atom(atom);
            for _ in n..0 {
                product = self.program.div(product, factor);
            }
        }
        product
    }

    fn atom(&mut self, atom: AtomId) -> Value {
        match self.algebra.atom(atom).clone() {
            Atom::Symbol(symbol) => self.symbol(symbol),
            Atom::Group(sum) => self.lower(sum),
            Atom::Sin(angle) => {
                if let Some([sin, _]) = self.bound_sines(angle) {
                    return sin;
                }
                let angle = self.lower(angle);
                let sin = self.program.leaf(Node::Sin(angle.node));
                if angle.negative { sin.neg() } else { sin }
            }
            Atom::Cos(angle) => {
                if let Some([_, cos]) = self.bound_sines(angle) {
                    return cos;
                }
                let angle = self.lower(angle);
                self.program.leaf(Node::Cos(angle.node))
            }
            Atom::Call(function, arguments) => self.call(function, &arguments),
        }
    }

    fn bound_sines(&self, angle: SumId) -> Option<[Value; 2]> {
        self.sines.get(&self.algebra.as_symbol(angle)?).copied()
    }

    fn call(&mut self, function: Function, arguments: &[SumId]) -> Value {
        let arguments: Vec<Value> = arguments.iter().map(|&x| self.lower(x)).collect();
        self.program.call(function, &arguments)
    }
}
