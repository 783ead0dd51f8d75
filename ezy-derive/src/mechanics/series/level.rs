//! What each value of a program depends on, and the companions that its recurrence needs.

use std::collections::{BTreeMap, BTreeSet};

use crate::function::Function;
use crate::symbolic::Symbol;
use crate::symbolic::program::{Node, NodeId, Program, Value};

/// What a value varies with; greater ones vary with more.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Nothing within a step.
    Fixed,
    /// Time, linearly: coefficients from the second on vanish.
    Clock,
    /// Time and positions.
    Position,
    /// Velocities, or first-order states, too.
    Velocity,
}

/// A program of which some values have series.
#[derive(Debug)]
pub struct Source {
    pub program: Program,
    levels: Vec<Level>,
    companions: BTreeMap<NodeId, Vec<NodeId>>,
}

impl Source {
    /// Prepares the values that `roots` need; `level_of` says what an input varies with.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn new(program: Program, roots: &[NodeId], level_of: impl Fn(Symbol) -> Level) -> Result<Self, Function> {
        let mut source = Self { program, levels: Vec::new(), companions: BTreeMap::new() };
        source.find_levels(&level_of);
        let mut waiting = roots.to_vec();
        let mut prepared = BTreeSet::new();
        while let Some(id) = waiting.pop() {
            if source.level(id) == Level::Fixed || !prepared.insert(id) {
                continue;
            }
            let companions = source.companions_of(id)?;
            source.find_levels(&level_of);
            waiting.extend(source.program.node(id).operands());
            waiting.extend(&companions);
            source.companions.insert(id, companions);
        }
        Ok(source)
    }

    /// The levels of the nodes added last.
    fn find_levels(&mut self, level_of: &impl Fn(Symbol) -> Level) {
        for i in self.levels.len()..self.program.len() {
            let level = self.find_level(NodeId(i), level_of);
            self.levels.push(level);
        }
    }

    pub fn level(&self, id: NodeId) -> Level {
        self.levels[id.0]
    }

    /// What the recurrence of a value reads besides its operands; in the order of `companions_of`.
    pub fn companion(&self, id: NodeId, i: usize) -> NodeId {
        self.companions.get(&id).and_then(|all| all.get(i)).copied().unwrap_or(id)
    }

    fn find_level(&self, id: NodeId, level_of: &impl Fn(Symbol) -> Level) -> Level {
        let node = self.program.node(id);
        let operands = node.operands();
        let highest = operands.iter().map(|&operand| self.level(operand)).max().unwrap_or(Level::Fixed);
        match node {
            Node::Input(symbol) => level_of(*symbol),
            Node::Constant(_) | Node::Literal(_) => Level::Fixed,
            Node::Add(..) | Node::Sub(..) | Node::Neg(_) => highest,
            Node::Mul(a, b) if self.level(*a).min(self.level(*b)) == Level::Fixed => highest,
            Node::Div(_, b) if self.level(*b) == Level::Fixed => highest,
            _ if highest == Level::Clock => Level::Position,
            _ => highest,
        }
    }

    fn companions_of(&mut self, id: NodeId) -> Result<Vec<NodeId>, Function> {
        match self.program.node(id).clone() {
            Node::Sin(angle) => Ok(vec![self.program.leaf(Node::Cos(angle)).node]),
            Node::Cos(angle) => Ok(vec![self.program.leaf(Node::Sin(angle)).node]),
            Node::Div(_, b) => Ok(vec![self.reciprocal(b)]),
            Node::Call(function, arguments) => self.companions_of_call(id, function, &arguments),
            _ => Ok(Vec::new()),
        }
    }

    fn companions_of_call(
        &mut self,
        id: NodeId,
        function: Function,
        arguments: &[NodeId],
    ) -> Result<Vec<NodeId>, Function> {
        let x = arguments[0];
        let one = self.program.literal(1.0);
        match function {
            Function::Sqrt => {
                let twice = self.program.add(plus(id), plus(id));
                let half = self.program.div(one, twice);
                Ok(vec![half.node])
            }
            Function::Exp => Ok(Vec::new()),
            // a divisor kept from zero
            Function::Max if self.is_least(arguments[1]) => Ok(Vec::new()),
            Function::Ln => Ok(vec![self.reciprocal(x)]),
            // 1 ± y², the slope
            Function::Tan | Function::Tanh => {
                let square = self.program.mul(plus(id), plus(id));
                let slope = if function == Function::Tan {
                    self.program.add(one, square)
                } else {
                    self.program.sub(one, square)
                };
                Ok(vec![self.program.positive(slope)])
            }
            // √(1 − x²), the inverse slope
            Function::Asin | Function::Acos => {
                let square = self.program.mul(plus(x), plus(x));
                let rest = self.program.sub(one, square);
                let root = self.program.call(Function::Sqrt, &[rest]).node;
                Ok(vec![root, self.reciprocal(root)])
            }
            // x² + y²
            Function::Atan2 => {
                let [a, b] = [arguments[0], arguments[1]].map(|z| self.program.mul(plus(z), plus(z)));
                let sum = self.program.add(a, b).node;
                Ok(vec![sum, self.reciprocal(sum)])
            }
            Function::Pow if self.level(arguments[1]) == Level::Fixed => Ok(vec![self.reciprocal(x)]),
            _ => Err(function),
        }
    }

    fn is_least(&self, id: NodeId) -> bool {
        *self.program.node(id) == Node::Literal(f64::MIN_POSITIVE.to_bits())
    }

    fn reciprocal(&mut self, x: NodeId) -> NodeId {
        let one = self.program.literal(1.0);
        self.program.div(one, plus(x)).node
    }
}

/// A node as it is.
pub fn plus(node: NodeId) -> Value {
    Value { node, negative: false }
}
