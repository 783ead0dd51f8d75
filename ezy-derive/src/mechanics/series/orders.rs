//! The programs of a step: its start, the right side of an order, and what follows from a solution.

use super::level::{Level, plus};
use super::lowered::{Lowered, Term};
use super::product::{Product, RightFactor};
use super::recurrence::{Coefficients, Target};
use super::{Slot, Slots, Step};
use crate::mechanics::kernels::{Pass, Put};
use crate::symbolic::program::{Node, Program, Value};

/// Outputs of a program as they are written.
#[derive(Default)]
pub struct Outputs {
    values: Vec<Value>,
    puts: Vec<Put>,
}

impl Outputs {
    pub fn push(&mut self, target: Slot, value: Value) {
        self.values.push(value);
        self.puts.push(Put::Slot(target));
    }

    /// The pass that puts them there, and gives what is watched besides.
    pub fn pass<'m>(self, slots: &Slots, mut program: Program, watched: impl Iterator<Item = Value>) -> Pass<'m> {
        self.values.into_iter().chain(watched).for_each(|value| program.push_output(value));
        program.settle_signs();
        let reads = slots.reads(&program);
        Pass::once(program, self.puts, reads)
    }
}

/// `Σ outer · sum` of the terms of a row or column.
fn total(coefficients: &mut Coefficients<'_, '_>, terms: &[Term]) -> Value {
    let mut total = coefficients.program.literal(0.0);
    for term in terms {
        let i = coefficients.step.product(term.product.clone());
        let (outer, sum) = (coefficients.fixed(term.outer), coefficients.input(Slot::Sum(i)));
        let product = coefficients.program.mul(outer, sum);
        total = coefficients.program.add(total, product);
    }
    total
}

/// z_{k+1} = ż_k / (k + 1), and
/// f_k = F_k − Σ_{j≥1} G_jᵀ λ_{k−j}; r_k = −(k + 1)(k + 2) Ĉ_{k+2} or −(k + 1) (S v + s_t)^_{k+1}, with the unknown left out.
pub fn right_side<'m>(step: &mut Step<'_>, lowered: &Lowered) -> Pass<'m> {
    let mut outputs = Outputs::default();
    let mut of = Coefficients::new(step, Target::Velocity);
    for (i, force, reaction) in &lowered.force {
        let (force, reaction) = (of.of_value(*force), total(&mut of, reaction));
        let value = of.program.sub(force, reaction);
        outputs.push(Slot::Force(*i), value);
    }
    for (i, rate) in lowered.rates.iter().enumerate() {
        let (rate, inverse) = (of.of_value(*rate), of.input(Slot::InverseOrder(1)));
        let value = of.program.mul(rate, inverse);
        outputs.push(Slot::State(1, i), value);
    }
    let program = std::mem::take(&mut of.program);
    let mut of = Coefficients::within(step, Target::WithoutUnknown, program);
    for (row, &position) in lowered.position.iter().enumerate() {
        let value = of.of_value(position);
        let (first, second) = (of.input(Slot::Order(1)), of.input(Slot::Order(2)));
        let factor = of.program.mul(first, second);
        let value = of.program.mul(factor, value);
        outputs.push(Slot::Row(row), value.neg());
    }
    for (i, (drift, rates)) in lowered.velocity.iter().enumerate() {
        let mut value = total(&mut of, rates);
        if of.step.source.level(drift.node) > Level::Fixed {
            let kept = of.step.keep(drift.node);
            let kept = of.input(Slot::Kept(1, kept));
            let kept = if drift.negative { kept.neg() } else { kept };
            value = of.program.add(value, kept);
        }
        let order = of.input(Slot::Order(1));
        let value = of.program.mul(order, value);
        outputs.push(Slot::Row(lowered.position.len() + i), value.neg());
    }
    let program = std::mem::take(&mut of.program);
    let mut of = Coefficients::within(step, Target::Velocity, program);
    let mut i = 0;
    // what is written may need further products
    while i < of.step.products.len() {
        let Product { left, right } = of.step.products.values()[i].clone();
        if let RightFactor::Velocity(right) = right {
            let (left, right, zero) = (of.factor(left), of.of(right), of.program.literal(0.0));
            outputs.push(Slot::Left(0, i), left);
            // read by the next order before it is known
            outputs.push(Slot::Left(1, i), zero);
            outputs.push(Slot::Right(2, i), right);
        }
        i += 1;
    }
    outputs.pass(&of.step.slots, of.program, std::iter::empty())
}

/// Order k + 2 of `coordinates` and of what depends on positions.
pub fn finish<'m>(step: &mut Step<'_>, lowered: &Lowered, coordinates: std::ops::Range<usize>) -> Pass<'m> {
    let mut outputs = Outputs::default();
    let mut of = Coefficients::new(step, Target::Position);
    for i in coordinates {
        let value = of.coordinate(i);
        outputs.push(Slot::Coordinate(2, i), value);
    }
    // states, which are kept first, are known earlier
    let (mut i, mut k) = (0, lowered.rates.len());
    while i < of.step.products.len() || k < of.step.kept.len() {
        if let Some(Product { left, right }) = of.step.products.values().get(i).cloned() {
            let right = match right {
                RightFactor::Velocity(_) => None,
                RightFactor::Position(node) => Some(of.of(node)),
                RightFactor::Rates(rates) => {
                    let parts = rates.into_iter().map(|(k, i)| (k, of.coordinate(i))).collect::<Vec<_>>();
                    let (sum, order) = (combination(&mut of, parts), of.input(Slot::Order(2)));
                    Some(of.program.mul(order, sum))
                }
                RightFactor::Multipliers(multipliers) => {
                    let parts = multipliers.into_iter().map(|(k, i)| (k, of.input(Slot::Multiplier(i))));
                    let parts = parts.collect::<Vec<_>>();
                    Some(combination(&mut of, parts))
                }
            };
            if let Some(right) = right {
                let left = of.factor(left);
                outputs.push(Slot::Left(2, i), left);
                outputs.push(Slot::Right(2, i), right);
            }
            i += 1;
        } else {
            let value = of.of(of.step.kept.values()[k]);
            outputs.push(Slot::Kept(2, k), value);
            k += 1;
        }
    }
    outputs.pass(&of.step.slots, of.program, std::iter::empty())
}

/// Σ k x
fn combination(of: &mut Coefficients<'_, '_>, parts: Vec<(Value, Value)>) -> Value {
    let mut total = of.program.literal(0.0);
    for (k, value) in parts {
        let k = of.fixed(k);
        let product = of.program.mul(k, value);
        total = of.program.add(total, product);
    }
    total
}

/// Order 0 and 1 of everything; then the watched pivots.
pub fn begin<'m>(step: &mut Step<'_>, lowered: &Lowered, pivots: &[(Vec<usize>, Value, Value)]) -> Pass<'m> {
    let mut outputs = Outputs::default();
    let (products, kept, base) =
        (step.products.values().to_vec(), step.kept.values().to_vec(), step.base.values().to_vec());
    let mut of = Coefficients::new(step, Target::First);
    base.into_iter().enumerate().for_each(|(i, node)| outputs.push(Slot::Base(i), plus(node)));
    lowered.force.iter().for_each(|&(i, value, _)| outputs.push(Slot::Force(i), value));
    lowered.convective.iter().enumerate().for_each(|(i, value)| outputs.push(Slot::Row(i), value.neg()));
    for (i, Product { left, right }) in products.into_iter().enumerate() {
        let zero = of.program.literal(0.0);
        let (left, first) = match right {
            RightFactor::Velocity(right) => {
                outputs.push(Slot::Right(3, i), plus(right));
                (zero, zero)
            }
            RightFactor::Position(right) => (of.factor(left), of.of(right)),
            RightFactor::Multipliers(_) => (of.factor(left), zero),
            RightFactor::Rates(rates) => {
                let velocity = |of: &mut Coefficients<'_, '_>, i| {
                    let symbol = of.step.symbols.velocity_at(i);
                    of.program.leaf(Node::Input(symbol))
                };
                let parts = rates.into_iter().map(|(k, i)| (k, velocity(&mut of, i))).collect();
                (of.factor(left), combination(&mut of, parts))
            }
        };
        outputs.push(Slot::Left(2, i), left);
        outputs.push(Slot::Right(2, i), first);
    }
    for (i, (&node, &rate)) in kept.iter().zip(&lowered.rates).enumerate() {
        outputs.push(Slot::State(1, i), plus(node));
        outputs.push(Slot::State(2, i), rate);
    }
    for (i, node) in kept.into_iter().enumerate().skip(lowered.rates.len()) {
        outputs.push(Slot::Kept(1, i), plus(node));
        let first = of.of(node);
        outputs.push(Slot::Kept(2, i), first);
    }
    let watched = pivots.iter().flat_map(|&(_, pivot, threshold)| [pivot, threshold]);
    outputs.pass(&of.step.slots, of.program, watched)
}
