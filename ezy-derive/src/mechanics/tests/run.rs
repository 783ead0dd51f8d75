//! Programs, run node by node.

use super::Trial;
use super::oracle::State;
use crate::mechanics::solve::Solver;
use crate::mechanics::symbols::Meaning;
use crate::symbolic::Symbol;
use crate::symbolic::program::{Node, Program};

/// The solution that a solver computes at a state; `other` gives what it reads besides.
pub fn solution(trial: &Trial, solver: &Solver, state: &State, other: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
    let mut outputs = outputs(trial, &solver.program, state, other);
    outputs.truncate(solver.n_outputs);
    outputs
}

/// All that a program computes at a state.
pub fn outputs(trial: &Trial, program: &Program, state: &State, other: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
    let n_nodes = program.live().last().map_or(0, |id| id.0 + 1);
    let mut values = vec![f64::NAN; n_nodes];
    for id in program.live() {
        let of = |operand: &crate::symbolic::program::NodeId| values[operand.0];
        values[id.0] = match program.node(id) {
            Node::Input(symbol) => match trial.equations.symbols.meaning(*symbol) {
                Meaning::Time => state.t,
                Meaning::Coordinate(i) => state.q[i],
                Meaning::Velocity(i) => state.v[i],
                _ => other(*symbol),
            },
            Node::Constant(i) => trial.numbers[*i],
            Node::Literal(bits) => f64::from_bits(*bits),
            Node::Add(a, b) => of(a) + of(b),
            Node::Sub(a, b) => of(a) - of(b),
            Node::Mul(a, b) => of(a) * of(b),
            Node::Div(a, b) => of(a) / of(b),
            Node::Neg(a) => -of(a),
            Node::Sin(a) => of(a).sin(),
            Node::Cos(a) => of(a).cos(),
            Node::Call(function, arguments) => function.evaluate(&arguments.iter().map(of).collect::<Vec<_>>()),
        };
    }
    program.outputs().iter().map(|output| values[output.node.0]).collect()
}
