//! The part of the solution that is repeated at every order: what depends on the right side.

use rustc_hash::FxHashMap;

use super::orders::Outputs;
use super::{Slot, Step};
use crate::mechanics::kernels::Pass;
use crate::mechanics::solve::Written;
use crate::symbolic::program::{Node, NodeId, Program, Value};

/// a and λ from f, r and what is known at the start of the step.
pub fn pass<'m>(step: &mut Step<'_>, written: &Written) -> Pass<'m> {
    let mut copy = Copy { repeated: repeated(step), step, program: Program::default(), done: FxHashMap::default() };
    let mut outputs = Outputs::default();
    for (i, &value) in written.solution.iter().enumerate() {
        let value = copy.value(value);
        outputs.push(Slot::Acceleration(i), value);
    }
    for (i, &value) in written.multipliers.iter().enumerate() {
        let value = copy.value(value);
        outputs.push(Slot::Multiplier(i), value);
    }
    outputs.pass(&copy.step.slots, copy.program, std::iter::empty())
}

/// Which nodes depend on the right side.
fn repeated(step: &Step<'_>) -> Vec<bool> {
    let program = &step.source.program;
    let mut repeated = vec![false; program.len()];
    for i in 0..program.len() {
        let node = program.node(NodeId(i));
        repeated[i] = match node {
            Node::Input(symbol) => step.slots.slot(*symbol).is_some(),
            _ => node.operands().iter().any(|operand| repeated[operand.0]),
        };
    }
    repeated
}

struct Copy<'s, 'e> {
    step: &'s mut Step<'e>,
    repeated: Vec<bool>,
    program: Program,
    done: FxHashMap<NodeId, Value>,
}

impl Copy<'_, '_> {
    fn value(&mut self, value: Value) -> Value {
        let copied = self.node(value.node);
        if value.negative { copied.neg() } else { copied }
    }

    fn node(&mut self, id: NodeId) -> Value {
        if let Some(&value) = self.done.get(&id) {
            return value;
        }
        let value = if self.repeated[id.0] { self.operation(id) } else { self.step.start(id, &mut self.program) };
        if let Some(name) = self.step.source.program.name(id) {
            self.program.set_name(value, name);
        }
        self.done.insert(id, value);
        value
    }

    fn operation(&mut self, id: NodeId) -> Value {
        let node = self.step.source.program.node(id).clone();
        let operands: Vec<Value> = node.operands().into_iter().map(|operand| self.node(operand)).collect();
        match (node, operands.as_slice()) {
            (Node::Add(..), &[a, b]) => self.program.add(a, b),
            (Node::Sub(..), &[a, b]) => self.program.sub(a, b),
            (Node::Mul(..), &[a, b]) => self.program.mul(a, b),
            (Node::Div(..), &[a, b]) => self.program.div(a, b),
            (Node::Neg(_), &[a]) => a.neg(),
            // nothing else is done with a right side
            (node, _) => self.program.leaf(node),
        }
    }
}
