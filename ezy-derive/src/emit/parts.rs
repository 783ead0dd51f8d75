//! What the statements of a kernel are, and long kernels in parts. Each `let` opens a scope, and rustc overflows its stack on
//! some thousand scopes in each other.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::TokenStream;
use quote::quote;

use super::numbers::Numbers;
use crate::symbolic::program::{Node, NodeId, Program};

/// A kernel of so many statements stays in one piece. rustc 1.95 with debug information overflows its stack at some 3,000;
/// what a reader takes in at once is less, and parts cost no instruction (`docs/decisions/040-long-kernels-are-split.md`).
pub const LONGEST_WHOLE: usize = 400;
/// Statements of a part of a longer one, besides those of its end.
const LONGEST_PART: usize = 300;

/// Statements that declare nothing, in parts where they are many.
pub fn sequence(statements: impl IntoIterator<Item = TokenStream>) -> TokenStream {
    let statements: Vec<TokenStream> = statements.into_iter().collect();
    if statements.len() <= LONGEST_WHOLE {
        return quote!(#(#statements)*);
    }
    statements.chunks(LONGEST_PART).map(|part| quote!((|| { #(#part)* })();)).collect()
}

/// What is no statement of its own.
pub struct Writing {
    /// Sums and differences that take in the product among their operands, each with that product: one which nothing else
    /// reads and which has no name.
    pub fused: BTreeMap<NodeId, NodeId>,
    /// What is written where it is read.
    in_place: BTreeSet<NodeId>,
}

/// Most operations of an expression within another one.
const MOST_IN_PLACE: usize = 2;

impl Writing {
    /// What is short and read once is written in place, and so is a sign; an output only if it need not be kept.
    pub fn new(numbers: Numbers, program: &Program, live: &[NodeId], keep_outputs: bool) -> Self {
        let uses = program.uses();
        let read_once = |id: NodeId| uses[id.0] == 1 && program.name(id).is_none();
        let free = |id: &NodeId| matches!(program.node(*id), Node::Mul(..)) && read_once(*id);
        let products = live.iter().filter_map(|&id| match program.node(id) {
            Node::Add(a, b) | Node::Sub(a, b) => [*b, *a].into_iter().find(free).map(|product| (id, product)),
            _ => None,
        });
        let fused: BTreeMap<NodeId, NodeId> = products.filter(|_| numbers == Numbers::Any).collect();
        let taken_in: BTreeSet<NodeId> = fused.values().copied().collect();
        let outputs: BTreeSet<NodeId> = program.outputs().iter().map(|output| output.node).collect();
        let mut kept = if keep_outputs { outputs.clone() } else { BTreeSet::new() };
        kept.extend(live.iter().filter(|id| uses[id.0] > 1).filter_map(|&id| match program.node(id) {
            Node::Neg(a) => Some(*a),
            _ => None,
        }));
        let mut in_place: BTreeMap<NodeId, usize> = BTreeMap::new();
        for &id in live {
            let inside = program.node(id).operands().iter().filter_map(|operand| in_place.get(operand)).sum::<usize>();
            let operations = inside + usize::from(!taken_in.contains(&id));
            let is_in_place = match program.node(id) {
                Node::Literal(_) => true,
                Node::Input(_) | Node::Constant(_) | Node::Sin(_) | Node::Cos(_) => false,
                Node::Neg(_) => !kept.contains(&id),
                _ if taken_in.contains(&id) => true,
                _ => read_once(id) && !kept.contains(&id) && (operations <= MOST_IN_PLACE || outputs.contains(&id)),
            };
            if is_in_place {
                in_place.insert(id, operations);
            }
        }
        Self { fused, in_place: in_place.into_keys().collect() }
    }

    /// Whether a statement computes or names a node.
    pub fn is_statement(&self, id: NodeId) -> bool {
        !self.in_place.contains(&id)
    }

    /// What the statement of a node reads.
    pub fn reads(&self, program: &Program, id: NodeId) -> Vec<NodeId> {
        let through = |operand| match self.in_place.contains(&operand) {
            true => self.reads(program, operand),
            false => vec![operand],
        };
        program.node(id).operands().into_iter().flat_map(through).collect()
    }
}

/// The parts of a kernel, in order.
pub struct Parts(pub Vec<Part>);

/// Some of the statements of a kernel.
#[derive(Default)]
pub struct Part {
    /// The nodes that it computes, ascending.
    pub computed: Vec<NodeId>,
    /// What the kernel is given and the part reads.
    pub inputs: BTreeSet<NodeId>,
    /// What later parts or the outputs read.
    pub passed: BTreeSet<NodeId>,
}

impl Parts {
    pub fn new(program: &Program, live: &[NodeId], writing: &Writing) -> Self {
        let is_given = |id: NodeId| matches!(program.node(id), Node::Constant(_) | Node::Input(_));
        let outputs: BTreeSet<NodeId> = program.outputs().iter().map(|output| output.node).collect();
        let is_passed_on = |id: NodeId| !is_given(id) || outputs.contains(&id);
        let needed = live.iter().copied().filter(|&id| writing.is_statement(id) && is_passed_on(id));
        let (mut parts, mut home) = (vec![Part::default()], BTreeMap::new());
        for id in needed {
            let last = parts.len() - 1;
            let n = parts[last].computed.len() + parts[last].inputs.len();
            let at = *home.entry(id).or_insert(if n < LONGEST_PART { last } else { last + 1 });
            if at > last {
                parts.push(Part::default());
            }
            // a sine and a cosine are found together
            let partner = match *program.node(id) {
                Node::Sin(angle) => program.find(&Node::Cos(angle)),
                Node::Cos(angle) => program.find(&Node::Sin(angle)),
                _ => None,
            };
            if let Some(partner) = partner.filter(|partner| live.binary_search(partner).is_ok()) {
                home.entry(partner).or_insert(at);
            }
            if is_given(id) {
                parts[at].inputs.insert(id);
                continue;
            }
            parts[at].computed.push(id);
            for operand in writing.reads(program, id) {
                match home.get(&operand) {
                    Some(&home) if !is_given(operand) => {
                        if home < at {
                            parts[home].passed.insert(operand);
                        }
                    }
                    _ => {
                        parts[at].inputs.insert(operand);
                    }
                }
            }
        }
        for id in outputs.into_iter().filter(|&id| writing.is_statement(id)) {
            parts[home[&id]].passed.insert(id);
        }
        Self(parts)
    }

    /// Values that parts pass on.
    pub fn n_passed(&self) -> usize {
        self.0.iter().map(|part| part.passed.len()).sum()
    }
}
