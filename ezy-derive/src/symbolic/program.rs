//! Straight-line programs: what a kernel computes, operation by operation.

use std::collections::BTreeSet;

use rustc_hash::FxHashMap;

use super::sum::Symbol;
use crate::function::Function;
use crate::work;

/// Index of a node; operands always come before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub usize);

/// One operation or input.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Node {
    Input(Symbol),
    /// Entry of the vector of constants.
    Constant(usize),
    /// Bits of a non-negative number.
    Literal(u64),
    Add(NodeId, NodeId),
    Sub(NodeId, NodeId),
    Mul(NodeId, NodeId),
    Div(NodeId, NodeId),
    Neg(NodeId),
    Sin(NodeId),
    Cos(NodeId),
    Call(Function, Vec<NodeId>),
}

/// A node or its negative. Signs travel to the outputs, where most of them vanish into subtractions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Value {
    pub node: NodeId,
    pub negative: bool,
}

impl Value {
    #[must_use]
    pub fn neg(self) -> Self {
        Self { node: self.node, negative: !self.negative }
    }
}

/// Nodes in order, shared: the same operation on the same operands is one node.
#[derive(Debug, Clone, Default)]
pub struct Program {
    nodes: Vec<Node>,
    ids: FxHashMap<Node, NodeId>,
    names: FxHashMap<NodeId, String>,
    hints: FxHashMap<NodeId, String>,
    outputs: Vec<Value>,
}

/// Operations of a program, counted as emitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Count {
    pub add: usize,
    pub mul: usize,
    pub div: usize,
    pub trig: usize,
    pub calls: usize,
}

impl Count {
    /// Trigonometry and other calls are counted apart.
    pub fn arithmetic(&self) -> usize {
        self.add + self.mul + self.div
    }
}

impl std::iter::Sum for Count {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), |a, b| Self {
            add: a.add + b.add,
            mul: a.mul + b.mul,
            div: a.div + b.div,
            trig: a.trig + b.trig,
            calls: a.calls + b.calls,
        })
    }
}

impl Program {
    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0]
    }

    /// The node of an operation, if the program has it.
    pub fn find(&self, node: &Node) -> Option<NodeId> {
        self.ids.get(node).copied()
    }

    /// Name for a temporary, if it was given one.
    pub fn name(&self, id: NodeId) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// Names the temporary that holds a value or its negative; the first name stays.
    pub fn set_name(&mut self, value: Value, name: &str) {
        let name = if value.negative { format!("minus_{name}") } else { name.to_owned() };
        self.names.entry(value.node).or_insert(name);
    }

    /// Name for a temporary whose operands give it none.
    pub fn hint(&self, id: NodeId) -> Option<&str> {
        self.hints.get(&id).map(String::as_str)
    }

    /// Names a value in passing: it may still be written within another expression. The first hint stays.
    pub fn set_hint(&mut self, value: Value, name: &str) {
        let name = if value.negative { format!("minus_{name}") } else { name.to_owned() };
        self.hints.entry(value.node).or_insert(name);
    }

    pub fn outputs(&self) -> &[Value] {
        &self.outputs
    }

    pub fn push_output(&mut self, value: Value) {
        self.outputs.push(value);
    }

    pub fn literal(&mut self, x: f64) -> Value {
        let node = self.intern(Node::Literal(x.abs().to_bits()));
        Value { node, negative: x < 0.0 }
    }

    pub fn leaf(&mut self, node: Node) -> Value {
        Value { node: self.intern(node), negative: false }
    }

    pub fn is_zero(&self, x: Value) -> bool {
        self.is_literal(x, 0.0)
    }

    pub fn add(&mut self, a: Value, b: Value) -> Value {
        if self.is_zero(a) {
            return b;
        }
        if self.is_zero(b) {
            return a;
        }
        if a.node == b.node && a.negative != b.negative {
            return self.literal(0.0);
        }
        match (a.negative, b.negative) {
            (false, true) => self.sub_nodes(a.node, b.node),
            (true, false) => self.sub_nodes(b.node, a.node),
            (negative, _) => {
                let (x, y) = ordered(a.node, b.node);
                Value { node: self.intern(Node::Add(x, y)), negative }
            }
        }
    }

    pub fn sub(&mut self, a: Value, b: Value) -> Value {
        self.add(a, b.neg())
    }

    pub fn mul(&mut self, a: Value, b: Value) -> Value {
        let negative = a.negative != b.negative;
        if self.is_zero(a) || self.is_literal(b, 1.0) {
            return Value { node: a.node, negative };
        }
        if self.is_zero(b) || self.is_literal(a, 1.0) {
            return Value { node: b.node, negative };
        }
        let (x, y) = ordered(a.node, b.node);
        Value { node: self.intern(Node::Mul(x, y)), negative }
    }

    pub fn div(&mut self, a: Value, b: Value) -> Value {
        let negative = a.negative != b.negative;
        if self.is_zero(a) || self.is_literal(b, 1.0) {
            return Value { node: a.node, negative };
        }
        Value { node: self.intern(Node::Div(a.node, b.node)), negative }
    }

    pub fn call(&mut self, function: Function, arguments: &[Value]) -> Value {
        let arguments = arguments.iter().map(|&x| self.positive(x)).collect();
        self.leaf(Node::Call(function, arguments))
    }

    /// The node that holds the value with its sign.
    pub fn positive(&mut self, x: Value) -> NodeId {
        if x.negative && !self.is_zero(x) { self.intern(Node::Neg(x.node)) } else { x.node }
    }

    /// Turns signed outputs into plain ones: swaps a subtraction that nothing else uses, else negates.
    pub fn settle_signs(&mut self) {
        let mut uses = self.uses();
        for i in 0..self.outputs.len() {
            let output = self.outputs[i];
            if !output.negative {
                continue;
            }
            if self.is_zero(output) || self.flip(output.node, &uses) {
                self.outputs[i].negative = false;
            } else {
                let node = self.intern(Node::Neg(output.node));
                uses.resize(self.nodes.len(), 0);
                // the output reads the negative instead; a negative that nothing read before reads the node in its place
                if uses[node.0] > 0 {
                    uses[output.node.0] -= 1;
                }
                uses[node.0] += 1;
                self.outputs[i] = Value { node, negative: false };
            }
        }
    }

    /// Nodes that the outputs need, in order.
    pub fn live(&self) -> Vec<NodeId> {
        let uses = self.uses();
        (0..self.nodes.len()).map(NodeId).filter(|id| uses[id.0] > 0).collect()
    }

    /// How often each node is used by live nodes and outputs.
    pub fn uses(&self) -> Vec<usize> {
        work::count(self.nodes.len());
        let mut uses = vec![0; self.nodes.len()];
        for output in &self.outputs {
            uses[output.node.0] += 1;
        }
        for i in (0..self.nodes.len()).rev() {
            if uses[i] > 0 {
                for operand in self.nodes[i].operands() {
                    uses[operand.0] += 1;
                }
            }
        }
        uses
    }

    /// The symbols that the outputs need.
    pub fn inputs(&self) -> Vec<Symbol> {
        let symbol = |id| match self.node(id) {
            Node::Input(symbol) => Some(*symbol),
            _ => None,
        };
        self.live().into_iter().filter_map(symbol).collect()
    }

    /// Whether the outputs need the vector of constants.
    /// The constants that it reads.
    pub fn constants(&self) -> impl Iterator<Item = usize> {
        self.live().into_iter().filter_map(|id| match self.node(id) {
            Node::Constant(i) => Some(*i),
            _ => None,
        })
    }

    pub fn count(&self) -> Count {
        let live = self.live();
        let mut count = Count::default();
        for &id in &live {
            match self.node(id) {
                Node::Add(..) | Node::Sub(..) | Node::Neg(_) => count.add += 1,
                Node::Mul(..) => count.mul += 1,
                Node::Div(..) => count.div += 1,
                Node::Sin(angle) => {
                    let paired = self.ids.get(&Node::Cos(*angle)).is_some_and(|cos| live.binary_search(cos).is_ok());
                    count.trig += usize::from(!paired);
                }
                Node::Cos(_) => count.trig += 1,
                Node::Call(..) => count.calls += 1,
                Node::Input(_) | Node::Constant(_) | Node::Literal(_) => {}
            }
        }
        count
    }

    /// The same values, of which these are the outputs, with symbols in place of some.
    pub fn reading(&self, outputs: &[Value], given: &[(NodeId, Symbol)]) -> Self {
        let mut program = Self { outputs: outputs.to_vec(), ..self.clone() };
        for &(id, symbol) in given {
            let known = std::mem::replace(&mut program.nodes[id.0], Node::Input(symbol));
            program.ids.remove(&known);
            program.ids.insert(Node::Input(symbol), id);
        }
        program
    }

    /// Angles whose sine or cosine the outputs need.
    pub fn angles(&self) -> Vec<NodeId> {
        let angle = |id| match self.node(id) {
            Node::Sin(angle) | Node::Cos(angle) => Some(*angle),
            _ => None,
        };
        let angles: BTreeSet<NodeId> = self.live().into_iter().filter_map(angle).collect();
        angles.into_iter().collect()
    }

    /// The program in two: values that depend on nothing but what is `held`, and what reads them by new symbols. The first one has a value for
    /// each of these.
    pub fn split(&self, held: &dyn Fn(Symbol) -> bool, new_symbol: &mut dyn FnMut() -> Symbol) -> Split {
        let live = self.live();
        let is_leaf = |id: NodeId| matches!(self.node(id), Node::Input(_) | Node::Constant(_) | Node::Literal(_));
        let mut is_held = vec![false; self.nodes.len()];
        for &id in &live {
            is_held[id.0] = match self.node(id) {
                Node::Input(symbol) => held(*symbol),
                node => node.operands().iter().all(|operand| is_held[operand.0]),
            };
        }
        let mut is_handed_on = vec![false; self.nodes.len()];
        let read = live.iter().filter(|id| !is_held[id.0]).flat_map(|&id| self.node(id).operands());
        for id in read.chain(self.outputs.iter().map(|output| output.node)) {
            is_handed_on[id.0] = is_held[id.0] && !is_leaf(id);
        }
        let mut split = Split { first: Self::default(), symbols: Vec::new(), rest: Self::default() };
        let mut places: FxHashMap<NodeId, [NodeId; 2]> = FxHashMap::default();
        for id in live {
            let moved = |program: &mut Self, of: usize| {
                let node = self.node(id).clone().map(|operand| places[&operand][of]);
                let new = program.intern(node);
                self.names.get(&id).into_iter().for_each(|name| drop(program.names.insert(new, name.clone())));
                self.hints.get(&id).into_iter().for_each(|hint| drop(program.hints.insert(new, hint.clone())));
                new
            };
            let in_first = if is_held[id.0] { moved(&mut split.first, 0) } else { id };
            let in_rest = if is_handed_on[id.0] {
                let symbol = new_symbol();
                split.first.push_output(Value { node: in_first, negative: false });
                split.symbols.push(symbol);
                split.rest.leaf(Node::Input(symbol)).node
            } else if is_held[id.0] && !is_leaf(id) {
                id
            } else {
                moved(&mut split.rest, 1)
            };
            places.insert(id, [in_first, in_rest]);
        }
        for output in &self.outputs {
            split.rest.push_output(Value { node: places[&output.node][1], negative: output.negative });
        }
        split
    }

    /// Changes the sign of a node in place where that costs nothing and nothing else sees it.
    fn flip(&mut self, id: NodeId, uses: &[usize]) -> bool {
        if uses[id.0] != 1 {
            return false;
        }
        match *self.node(id) {
            Node::Sub(a, b) => {
                self.nodes[id.0] = Node::Sub(b, a);
                true
            }
            Node::Mul(a, b) => self.flip(b, uses) || self.flip(a, uses),
            Node::Div(a, _) => self.flip(a, uses),
            _ => false,
        }
    }

    fn sub_nodes(&mut self, a: NodeId, b: NodeId) -> Value {
        if let Some(&node) = self.ids.get(&Node::Sub(b, a)) {
            return Value { node, negative: true };
        }
        Value { node: self.intern(Node::Sub(a, b)), negative: false }
    }

    fn is_literal(&self, x: Value, number: f64) -> bool {
        self.nodes[x.node.0] == Node::Literal(number.to_bits())
    }

    fn intern(&mut self, node: Node) -> NodeId {
        work::count(1);
        if let Some(&id) = self.ids.get(&node) {
            return id;
        }
        let id = NodeId(self.nodes.len());
        self.nodes.push(node.clone());
        self.ids.insert(node, id);
        id
    }
}

/// A program in two.
pub struct Split {
    pub first: Program,
    /// What stands in the rest for the outputs of the first one.
    pub symbols: Vec<Symbol>,
    pub rest: Program,
}

impl Node {
    /// The same operation on other nodes.
    fn map(self, other: impl Fn(NodeId) -> NodeId) -> Self {
        match self {
            Self::Input(_) | Self::Constant(_) | Self::Literal(_) => self,
            Self::Add(a, b) => Self::Add(other(a), other(b)),
            Self::Sub(a, b) => Self::Sub(other(a), other(b)),
            Self::Mul(a, b) => Self::Mul(other(a), other(b)),
            Self::Div(a, b) => Self::Div(other(a), other(b)),
            Self::Neg(a) => Self::Neg(other(a)),
            Self::Sin(a) => Self::Sin(other(a)),
            Self::Cos(a) => Self::Cos(other(a)),
            Self::Call(function, arguments) => Self::Call(function, arguments.into_iter().map(other).collect()),
        }
    }

    /// The nodes that this one reads.
    pub fn operands(&self) -> Vec<NodeId> {
        match self {
            Self::Input(_) | Self::Constant(_) | Self::Literal(_) => Vec::new(),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) => vec![*a, *b],
            Self::Neg(a) | Self::Sin(a) | Self::Cos(a) => vec![*a],
            Self::Call(_, arguments) => arguments.clone(),
        }
    }
}

fn ordered(a: NodeId, b: NodeId) -> (NodeId, NodeId) {
    if a <= b { (a, b) } else { (b, a) }
}
