//! The coefficient of each operation from lower coefficients of its operands.
//!
//! With `S(x, y)` for `Σ x_j y_{n−j}` over j = 1 … n − 1, and θx for the series `j x_j`.
//!
//! # Source
//! Moore, Interval Analysis (1966); Jorba, Zou, Exp. Math. 14 (2005), section 2.

use rustc_hash::FxHashMap;

use super::Step;
use super::level::{Level, plus};
use super::product::{Factor, Product, RightFactor};
use crate::function::Function;
use crate::mechanics::kernels::{Ahead, Slot};
use crate::mechanics::symbols::Meaning;
use crate::symbolic::program::{Node, NodeId, Program, Value};

/// Which coefficients a program finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Of order 1, at the start of a step.
    First,
    /// Of order k + 2, with q of that order left out.
    WithoutUnknown,
    /// Of order k + 2.
    Position,
    /// Of order k.
    Velocity,
}

impl Target {
    /// Its order, from k on.
    const fn ahead(self) -> Ahead {
        match self {
            Self::First | Self::WithoutUnknown | Self::Position => 2,
            Self::Velocity => 0,
        }
    }
}

/// Coefficients of one order, written into a program.
pub struct Coefficients<'s, 'e> {
    pub step: &'s mut Step<'e>,
    pub program: Program,
    target: Target,
    found: FxHashMap<NodeId, Value>,
}

impl<'s, 'e> Coefficients<'s, 'e> {
    pub fn new(step: &'s mut Step<'e>, target: Target) -> Self {
        // the first coefficients go on from the values themselves
        let program = if target == Target::First { step.source.program.clone() } else { Program::default() };
        Self::within(step, target, program)
    }

    /// Writes on in a program.
    pub fn within(step: &'s mut Step<'e>, target: Target, program: Program) -> Self {
        Self { step, program, target, found: FxHashMap::default() }
    }

    pub fn input(&mut self, slot: Slot) -> Value {
        let symbol = self.step.slots.symbol(self.step.symbols, slot);
        self.program.leaf(Node::Input(symbol))
    }

    /// The value at the start of the step.
    pub fn start(&mut self, id: NodeId) -> Value {
        if self.target == Target::First {
            return plus(id);
        }
        self.step.start(id, &mut self.program)
    }

    /// A value that does not vary, from the program that it was found in.
    pub fn fixed(&mut self, value: Value) -> Value {
        let start = self.start(value.node);
        if value.negative { start.neg() } else { start }
    }

    pub fn of_value(&mut self, value: Value) -> Value {
        let found = self.of(value.node);
        if value.negative { found.neg() } else { found }
    }

    /// The coefficient of a value.
    pub fn of(&mut self, id: NodeId) -> Value {
        if let Some(&found) = self.found.get(&id) {
            return found;
        }
        let level = self.step.source.level(id);
        let value = if level == Level::Fixed {
            self.program.literal(0.0)
        } else if self.target == Target::Velocity && level < Level::Velocity {
            self.of_position(id)
        } else if level == Level::Clock && self.target != Target::First {
            self.program.literal(0.0)
        } else {
            let node = self.step.source.program.node(id).clone();
            self.operation(id, &node)
        };
        self.found.insert(id, value);
        value
    }

    /// Of order k, found before.
    fn of_position(&mut self, id: NodeId) -> Value {
        if let Node::Input(symbol) = self.step.source.program.node(id)
            && let Meaning::Coordinate(i) = self.step.symbols.meaning(*symbol)
        {
            return self.input(Slot::Coordinate(0, i));
        }
        let i = self.step.keep(id);
        self.input(Slot::Kept(0, i))
    }

    fn operation(&mut self, id: NodeId, node: &Node) -> Value {
        match *node {
            Node::Input(symbol) => self.variable(symbol),
            Node::Constant(_) | Node::Literal(_) => self.program.literal(0.0),
            Node::Add(a, b) => {
                let (a, b) = (self.of(a), self.of(b));
                self.program.add(a, b)
            }
            Node::Sub(a, b) => {
                let (a, b) = (self.of(a), self.of(b));
                self.program.sub(a, b)
            }
            Node::Neg(a) => self.of(a).neg(),
            Node::Mul(a, b) => self.product(a, b),
            Node::Div(a, b) => self.quotient(id, a, b),
            Node::Sin(angle) => self.trigonometry(id, angle, false),
            Node::Cos(angle) => self.trigonometry(id, angle, true),
            Node::Call(function, ref arguments) => self.call(id, function, arguments),
        }
    }

    fn variable(&mut self, symbol: crate::symbolic::Symbol) -> Value {
        match (self.step.symbols.meaning(symbol), self.target) {
            (Meaning::Time, _) => self.program.literal(1.0),
            (Meaning::Coordinate(i), Target::First) => {
                let velocity = self.step.symbols.velocity_at(i);
                self.program.leaf(Node::Input(velocity))
            }
            (Meaning::Coordinate(i), Target::Position) => self.coordinate(i),
            (Meaning::Velocity(i), Target::Velocity) => {
                let (order, q) = (self.input(Slot::Order(1)), self.input(Slot::Coordinate(1, i)));
                self.program.mul(order, q)
            }
            (Meaning::Input(_), Target::Velocity) => match self.step.symbols.state_of(symbol) {
                Some(i) => self.input(Slot::State(0, i)),
                None => self.program.literal(0.0),
            },
            _ => self.program.literal(0.0),
        }
    }

    /// q_{k+2} = a_k / ((k + 1)(k + 2)), which items read.
    pub fn coordinate(&mut self, i: usize) -> Value {
        if self.step.of_item {
            return self.input(Slot::Coordinate(2, i));
        }
        let a = self.input(Slot::Acceleration(i));
        let (first, second) = (self.input(Slot::InverseOrder(1)), self.input(Slot::InverseOrder(2)));
        let inverse = self.program.mul(first, second);
        self.program.mul(a, inverse)
    }

    /// 1/n
    fn inverse_order(&mut self) -> Value {
        match self.target {
            Target::First => self.program.literal(1.0),
            _ => self.input(Slot::InverseOrder(self.target.ahead())),
        }
    }

    /// The coefficient of a factor as products store it.
    pub fn factor(&mut self, factor: Factor) -> Value {
        let value = self.of(factor.node);
        if !factor.scaled || self.target == Target::First {
            return value;
        }
        let order = self.input(Slot::Order(self.target.ahead()));
        self.program.mul(order, value)
    }

    /// S(x, y) or S(θx, y)
    fn sum(&mut self, left: Factor, right: NodeId) -> Value {
        if self.target == Target::First || self.step.source.level(right) == Level::Fixed {
            return self.program.literal(0.0);
        }
        let right = match self.target {
            Target::Velocity => RightFactor::Velocity(right),
            _ => RightFactor::Position(right),
        };
        let i = self.step.product(Product { left, right });
        self.input(Slot::Sum(i))
    }

    fn plain(&mut self, left: NodeId, right: NodeId) -> Value {
        self.sum(Factor { node: left, scaled: false }, right)
    }

    /// S(θx, y) / n
    fn scaled(&mut self, left: NodeId, right: NodeId) -> Value {
        let sum = self.sum(Factor { node: left, scaled: true }, right);
        let inverse = self.inverse_order();
        self.program.mul(sum, inverse)
    }

    /// (x y)_n = S(x, y) + x_0 y_n + x_n y_0
    fn product(&mut self, a: NodeId, b: NodeId) -> Value {
        let level = |id| self.step.source.level(id);
        if level(a) == Level::Fixed || level(b) == Level::Fixed {
            let (fixed, varying) = if level(a) == Level::Fixed { (a, b) } else { (b, a) };
            let (start, varying) = (self.start(fixed), self.of(varying));
            return self.program.mul(start, varying);
        }
        let (low, high) = (a.min(b), a.max(b));
        let sum = self.plain(low, high);
        let first = self.start_times(a, b);
        let second = if a == b { first } else { self.start_times(b, a) };
        let ends = self.program.add(first, second);
        self.program.add(sum, ends)
    }

    /// x_0 y_n
    fn start_times(&mut self, x: NodeId, y: NodeId) -> Value {
        let y = self.of(y);
        if self.program.is_zero(y) {
            return y;
        }
        let x = self.start(x);
        self.program.mul(x, y)
    }

    /// q = a/b: q_n = (a_n − S(b, q) − b_n q_0) / b_0
    fn quotient(&mut self, id: NodeId, a: NodeId, b: NodeId) -> Value {
        let mut top = self.of(a);
        if self.step.source.level(b) > Level::Fixed {
            let sum = self.plain(b, id);
            let end = self.start_times(id, b);
            top = self.program.sub(top, sum);
            top = self.program.sub(top, end);
        }
        let inverse = self.step.source.companion(id, 0);
        let inverse = self.start(inverse);
        self.program.mul(top, inverse)
    }

    /// s_n = S(θx, c)/n + c_0 x_n, c_n = −S(θx, s)/n − s_0 x_n; for an angle linear in time s_n = x_1 c_{n−1} / n.
    fn trigonometry(&mut self, id: NodeId, angle: NodeId, negative: bool) -> Value {
        let other = self.step.source.companion(id, 0);
        let linear = self.step.source.level(angle) == Level::Clock;
        let value = if linear && self.target != Target::First {
            let i = self.step.keep(other);
            let (before, slope) = (self.input(Slot::Kept(1, i)), self.step.slope(angle, &mut self.program));
            let inverse = self.inverse_order();
            let slope = self.program.mul(slope, inverse);
            self.program.mul(slope, before)
        } else {
            let (sum, end) = (self.scaled(angle, other), self.start_times(other, angle));
            self.program.add(sum, end)
        };
        if negative { value.neg() } else { value }
    }

    fn call(&mut self, id: NodeId, function: Function, arguments: &[NodeId]) -> Value {
        let x = arguments[0];
        let companion = |this: &Self, i| this.step.source.companion(id, i);
        match function {
            // r_n = (x_n − S(r, r)) / (2 r_0)
            Function::Sqrt => {
                let (value, sum) = (self.of(x), self.plain(id, id));
                let top = self.program.sub(value, sum);
                let half = companion(self, 0);
                let half = self.start(half);
                self.program.mul(top, half)
            }
            // y_n = S(θx, y)/n + y_0 x_n
            Function::Exp => {
                let (sum, end) = (self.scaled(x, id), self.start_times(id, x));
                self.program.add(sum, end)
            }
            Function::Max => self.of(x),
            // y_n = (x_n − S(θy, x)/n) / x_0
            Function::Ln => {
                let (value, sum) = (self.of(x), self.scaled(id, x));
                let top = self.program.sub(value, sum);
                let inverse = companion(self, 0);
                let inverse = self.start(inverse);
                self.program.mul(top, inverse)
            }
            // y' = u x' with u = 1 ± y²
            Function::Tan | Function::Tanh => {
                let slope = companion(self, 0);
                let (sum, end) = (self.scaled(x, slope), self.start_times(slope, x));
                self.program.add(sum, end)
            }
            // r y' = ± x' with r = √(1 − x²)
            Function::Asin | Function::Acos => {
                let (value, root) = (self.of(x), companion(self, 0));
                let value = if function == Function::Asin { value } else { value.neg() };
                let sum = self.scaled(id, root);
                let top = self.program.sub(value, sum);
                let inverse = companion(self, 1);
                let inverse = self.start(inverse);
                self.program.mul(top, inverse)
            }
            Function::Atan2 => self.angle_of(id, x, arguments[1]),
            Function::Pow => self.power(id, x, arguments[1]),
            // has no series: refused before
            _ => self.program.literal(f64::NAN),
        }
    }

    /// u θ' = x y' − y x' with u = x² + y²
    fn angle_of(&mut self, id: NodeId, y: NodeId, x: NodeId) -> Value {
        let (square, inverse) = (self.step.source.companion(id, 0), self.step.source.companion(id, 1));
        let (first, second, third) = (self.scaled(y, x), self.scaled(x, y), self.scaled(id, square));
        let (rise, fall) = (self.start_times(x, y), self.start_times(y, x));
        let mut top = self.program.sub(first, second);
        top = self.program.sub(top, third);
        top = self.program.add(top, rise);
        top = self.program.sub(top, fall);
        let inverse = self.start(inverse);
        self.program.mul(top, inverse)
    }

    /// y = x^α: y_n = ((α + 1) S(θx, y)/n − S(x, y) + α y_0 x_n) / x_0
    fn power(&mut self, id: NodeId, x: NodeId, exponent: NodeId) -> Value {
        let exponent = self.start(exponent);
        let one = self.program.literal(1.0);
        let next = self.program.add(exponent, one);
        let (scaled, sum, end) = (self.scaled(x, id), self.plain(x, id), self.start_times(id, x));
        let scaled = self.program.mul(next, scaled);
        let end = self.program.mul(exponent, end);
        let mut top = self.program.sub(scaled, sum);
        top = self.program.add(top, end);
        let inverse = self.step.source.companion(id, 0);
        let inverse = self.start(inverse);
        self.program.mul(top, inverse)
    }
}
