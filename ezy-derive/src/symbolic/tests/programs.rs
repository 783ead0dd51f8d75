//! Programs: operations on values with signs, what is live, and what is counted.

use super::super::Symbol;
use super::super::program::{Count, Node, NodeId, Program, Split, Value};
use super::{Sample, run, run_with};
use crate::function::Function;
use crate::random::Random;
use crate::symbolic::evaluate::Point;

/// The same operations in the same order.
const EXACT: f64 = 0.0;

/// A random program, its values in plain numbers, and which of them are outputs.
fn random_program(seed: u64) -> (Program, Vec<f64>) {
    let mut random = Random::new(seed);
    let mut program = Program::default();
    let mut values: Vec<(Value, f64)> = Vec::new();
    for x in [0.0, 1.0, -1.0, 2.5, -0.75] {
        values.push((program.literal(x), x));
    }
    for i in 1..4 {
        values.push((program.leaf(Node::Input(Symbol(i))), Sample(0.0).symbol(Symbol(i))));
    }
    for _ in 0..30 {
        let [(a, x), (b, y)] = [*random.of(&values), *random.of(&values)];
        let made = match random.below(7) {
            0 => (program.add(a, b), x + y),
            1 | 2 => (program.sub(a, b), x - y),
            3 => (program.mul(a, b), x * y),
            4 if y != 0.0 => (program.div(a, b), x / y),
            5 => (a.neg(), -x),
            _ => (program.call(Function::Max, &[a, b]), x.max(y)),
        };
        values.push(made);
    }
    let mut expected = Vec::new();
    for _ in 0..4 {
        let (value, x) = *random.of(&values[8..]);
        program.push_output(value);
        expected.push(x);
    }
    (program, expected)
}

/// The nodes that the outputs need, by going through them.
fn reached(program: &Program) -> Vec<NodeId> {
    let mut waiting: Vec<NodeId> = program.outputs().iter().map(|output| output.node).collect();
    let mut reached = Vec::new();
    while let Some(id) = waiting.pop() {
        if reached.contains(&id) {
            continue;
        }
        reached.push(id);
        match program.node(id) {
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => waiting.extend([*a, *b]),
            Node::Neg(a) | Node::Sin(a) | Node::Cos(a) => waiting.push(*a),
            Node::Call(_, arguments) => waiting.extend(arguments),
            Node::Input(_) | Node::Constant(_) | Node::Literal(_) => {}
        }
    }
    reached.sort();
    reached
}

#[test]
fn cross_random_programs_have_the_values_of_their_operations() {
    for seed in 0..300 {
        let (mut program, expected) = random_program(seed);
        let compare = |program: &Program, what: &str| {
            let found = run(program, &[]);
            let close = found.iter().zip(&expected).all(|(x, y)| (x - y).abs() <= EXACT);
            assert!(close && found.len() == expected.len(), "{seed}, {what}: {found:?} {expected:?}");
        };
        compare(&program, "with signs");
        let before = program.count();
        let n_negative = program.outputs().iter().filter(|output| output.negative).count();
        program.settle_signs();
        compare(&program, "settled");
        assert!(program.outputs().iter().all(|output| !output.negative), "{seed}");
        let live = program.live();
        assert_eq!(live, reached(&program), "{seed}");
        let of_kind = |is: fn(&Node) -> bool| live.iter().filter(|id| is(program.node(**id))).count();
        let count = program.count();
        assert_eq!(count.add, of_kind(|node| matches!(node, Node::Add(..) | Node::Sub(..) | Node::Neg(_))), "{seed}");
        assert_eq!(count.mul, of_kind(|node| matches!(node, Node::Mul(..))), "{seed}");
        assert_eq!(count.div, of_kind(|node| matches!(node, Node::Div(..))), "{seed}");
        assert_eq!((count.calls, count.trig), (of_kind(|node| matches!(node, Node::Call(..))), 0), "{seed}");
        assert!(count.add <= before.add + n_negative, "{seed}: a sign costs one operation at most");
        let inputs: Vec<Symbol> = live
            .iter()
            .filter_map(|id| match program.node(*id) {
                Node::Input(symbol) => Some(*symbol),
                _ => None,
            })
            .collect();
        assert_eq!((program.inputs(), program.constants().count()), (inputs, 0), "{seed}");
        let uses = program.uses();
        for id in (0..program.len()).map(NodeId) {
            let by_nodes = live.iter().flat_map(|user| program.node(*user).operands()).filter(|of| *of == id).count();
            let by_outputs = program.outputs().iter().filter(|output| output.node == id).count();
            assert_eq!(uses[id.0], by_nodes + by_outputs, "{seed}: {id:?}");
        }
    }
}

/// Both parts together compute what the whole does, with the same operations, each in one of them.
#[test]
fn cross_random_programs_in_two_have_the_values_of_the_whole() {
    /// Symbols of their own for what is handed on.
    const FIRST: u32 = 100;
    let mut n_handed_on = 0;
    for seed in 0..300 {
        let (program, expected) = random_program(seed);
        let is_held = |symbol: Symbol| symbol.0 <= 2;
        let mut next = FIRST;
        let Split { first, symbols, rest } = program.split(&is_held, &mut || {
            next += 1;
            Symbol(next - 1)
        });
        let handed_on = run(&first, &[]);
        n_handed_on += handed_on.len();
        assert_eq!(symbols, (FIRST..next).map(Symbol).collect::<Vec<_>>(), "{seed}");
        let input = |symbol: Symbol| match symbol.0.checked_sub(FIRST) {
            Some(place) => handed_on[place as usize],
            None => Sample(0.0).symbol(symbol),
        };
        let found = run_with(&rest, &[], &input);
        let close = found.iter().zip(&expected).all(|(x, y)| (x - y).abs() <= EXACT);
        assert!(close && found.len() == expected.len(), "{seed}: {found:?} {expected:?}");
        assert!(first.inputs().into_iter().all(is_held), "{seed}");
        let read = rest.inputs();
        assert!(symbols.iter().all(|symbol| read.contains(symbol)), "{seed}");
        assert_eq!([first.count(), rest.count()].into_iter().sum::<Count>(), program.count(), "{seed}");
    }
    assert!(n_handed_on > 300, "{n_handed_on}");
}

/// Three inputs.
fn inputs(program: &mut Program) -> [Value; 3] {
    [1, 2, 3].map(|i| program.leaf(Node::Input(Symbol(i))))
}

#[test]
fn analytic_equal_operations_are_one_node() {
    let mut program = Program::default();
    let [x, y, _] = inputs(&mut program);
    assert_eq!(program.add(x, y), program.add(y, x));
    assert_eq!(program.mul(x, y), program.mul(y, x));
    assert_eq!(program.sub(x, y), program.sub(y, x).neg());
    assert_eq!(program.mul(x.neg(), y), program.mul(x, y).neg());
    assert_eq!(program.mul(x.neg(), y.neg()), program.mul(x, y));
    assert_eq!(program.div(x.neg(), y.neg()), program.div(x, y));
    assert_ne!(program.div(x, y), program.div(y, x));
    assert_eq!(program.add(x.neg(), y.neg()), program.add(x, y).neg());
    let (zero, one) = (program.literal(0.0), program.literal(1.0));
    assert_eq!(program.literal(-1.0), one.neg());
    assert!(program.is_zero(zero) && !program.is_zero(one) && !program.is_zero(x) && !zero.negative);
    assert_eq!([program.add(x, zero), program.add(zero, x), program.sub(x, zero), program.mul(one, x)], [x; 4]);
    assert_eq!([program.mul(x, one), program.div(x, one), program.sub(zero, x).neg()], [x; 3]);
    let minus_one = one.neg();
    assert_eq!([program.mul(x, minus_one), program.div(x, minus_one)], [x.neg(); 2]);
    let vanished = [program.sub(x, x), program.mul(x, zero), program.mul(zero, x), program.div(zero, x)];
    assert!(vanished.iter().all(|value| program.is_zero(*value)), "{vanished:?}");
    let sum = program.add(x, x);
    assert!(matches!(program.node(sum.node), Node::Add(a, b) if a == b), "x + x is no zero");
    let found = program.find(&Node::Add(x.node, x.node));
    assert_eq!((found, program.find(&Node::Neg(x.node))), (Some(sum.node), None));
    let held = [x.neg(), x, zero.neg()].map(|value| program.positive(value));
    assert_eq!((program.node(held[0]), held[1], held[2]), (&Node::Neg(x.node), x.node, zero.node));
}

/// An output with a minus turns a subtraction that nothing else reads, also within a product; what something else reads is negated.
#[test]
fn analytic_signs_of_outputs_vanish_into_subtractions() {
    let settled = |make: fn(&mut Program, [Value; 3])| {
        let mut program = Program::default();
        let inputs = inputs(&mut program);
        make(&mut program, inputs);
        let expected: Vec<f64> = run(&program, &[]);
        program.settle_signs();
        assert_eq!(run(&program, &[]), expected);
        let is_negation = |id: &NodeId| matches!(program.node(*id), Node::Neg(_));
        program.live().iter().filter(|id| is_negation(id)).count()
    };
    let n = settled(|program, [x, y, _]| {
        let difference = program.sub(x, y);
        program.push_output(difference.neg());
    });
    assert_eq!(n, 0, "a difference is turned");
    let n = settled(|program, [x, y, z]| {
        let difference = program.sub(x, y);
        let product = program.mul(z, difference);
        program.push_output(product.neg());
    });
    assert_eq!(n, 0, "as a factor");
    let n = settled(|program, [x, y, z]| {
        let difference = program.sub(x, y);
        let quotient = program.div(difference, z);
        program.push_output(quotient.neg());
    });
    assert_eq!(n, 0, "above a line");
    let n = settled(|program, [x, y, z]| {
        let difference = program.sub(x, y);
        let quotient = program.div(z, difference);
        program.push_output(quotient.neg());
    });
    assert_eq!(n, 1, "below a line it is left");
    let n = settled(|program, [x, y, z]| {
        let difference = program.sub(x, y);
        let product = program.mul(z, difference);
        program.push_output(product.neg());
        program.push_output(difference);
    });
    assert_eq!(n, 1, "what another output reads is left");
    let n = settled(|program, [x, _, _]| program.push_output(x.neg()));
    assert_eq!(n, 1, "an input is left");
    let n = settled(|program, [x, y, _]| {
        let sum = program.add(x, y);
        program.push_output(sum.neg());
        program.push_output(sum.neg());
        let zero = program.literal(0.0);
        program.push_output(zero.neg());
    });
    assert_eq!(n, 1, "one negative for both, none for zero");
}

/// A sine beside a cosine of the same angle costs nothing more.
#[test]
fn analytic_counts_of_operations() {
    let mut program = Program::default();
    let [x, y, z] = inputs(&mut program);
    let [sin, cos, alone] = [Node::Sin(x.node), Node::Cos(x.node), Node::Sin(y.node)].map(|node| program.leaf(node));
    let constant = program.leaf(Node::Constant(3));
    let (a, b) = (program.mul(sin, cos), program.mul(constant, alone));
    let (c, d) = (program.div(a, z), program.sub(a, b));
    let e = program.call(Function::Exp, &[d.neg()]);
    let unused = program.mul(e, e);
    let total = program.add(c, e);
    program.push_output(total);
    assert_eq!(program.constants().count(), 1);
    // the negative of d is an operation of its own
    let expected = Count { add: 3, mul: 2, div: 1, trig: 2, calls: 1 };
    assert_eq!(program.count(), expected);
    program.push_output(unused);
    let more = Count { mul: 3, ..expected };
    assert_eq!(program.count(), more);
    let sum = Count { add: 6, mul: 5, div: 2, trig: 4, calls: 2 };
    assert_eq!([expected, more].into_iter().sum::<Count>(), sum);
}

#[test]
fn analytic_the_first_name_of_a_value_stays() {
    let mut program = Program::default();
    let [x, y, z] = inputs(&mut program);
    program.set_name(x, "first");
    program.set_name(x.neg(), "second");
    program.set_name(y.neg(), "depth");
    program.set_hint(x.neg(), "height");
    program.set_hint(x, "width");
    assert_eq!([x, y, z].map(|value| program.name(value.node)), [Some("first"), Some("minus_depth"), None]);
    assert_eq!([x, y].map(|value| program.hint(value.node)), [Some("minus_height"), None]);
}
