//! The Taylor series of a motion: the recurrences of all coefficients, from the expressions that everything else is
//! derived from.
//!
//! At every order k the equations of motion are `[M G₀ᵀ; G₀ 0] [a_k; λ_k] = [f_k; r_k]`. What is emitted are four
//! programs: values and factors at the start of a step, the right side of an order, its solution, and what follows from
//! it. `ezy_core::model::Series` says how they are called.

mod level;
mod product;
mod recurrence;
mod slot;
mod solution;

use crate::function::Function;
use crate::mechanics::Equations;
use crate::mechanics::solve::Elimination;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::symbolic::SumId;
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::{Count, Node, NodeId, Program, Value};
use level::{Level, Source, plus};
use product::{Factor, Product, RightFactor, terms};
use recurrence::{Coefficients, Target};
pub use slot::{Ahead, Slot, Slots};

/// A program and where each of its outputs is written.
#[derive(Debug)]
pub struct Kernel {
    pub program: Program,
    pub targets: Vec<Slot>,
}

/// The recurrences of a scene.
#[derive(Debug)]
pub struct Series {
    /// Values at the start of a step. For it, what is one order ahead of k is of order 0. Its outputs past the targets are
    /// pivots and their thresholds.
    pub begin: Kernel,
    /// Rows of each watched pivot.
    pub pivots: Vec<Vec<usize>>,
    /// f and r of order k.
    pub right_side: Kernel,
    /// a and λ of order k.
    pub solution: Kernel,
    /// Order k + 2 of q and of what depends on positions and time.
    pub finish: Kernel,
    pub slots: Slots,
    pub n_base: usize,
    pub n_kept: usize,
    pub n_products: usize,
}

/// What the programs of a step share.
#[derive(Debug)]
pub struct Step<'e> {
    source: Source,
    symbols: &'e mut Symbols,
    slots: Slots,
    products: Vec<Product>,
    /// Values at the start that are read later.
    base: Vec<NodeId>,
    /// Values whose coefficients are read later.
    kept: Vec<NodeId>,
}

/// A term of a matrix times a vector: an outer coefficient and the product that it multiplies.
struct Term {
    outer: Value,
    product: Product,
}

/// The values that have series, in the program that all of them are written in.
struct Lowered {
    /// C of each position row.
    position: Vec<Value>,
    /// s_t of each velocity row, and S v.
    velocity: Vec<(Value, Vec<Term>)>,
    force: Vec<Value>,
    /// Gᵀ λ, by coordinate.
    reaction: Vec<Vec<Term>>,
    convective: Vec<Value>,
}

impl Series {
    /// # Errors
    /// A function that has no Taylor series.
    pub fn derive(equations: &mut Equations, constants: &mut ConstantPool) -> Result<Self, Function> {
        let (n_q, n_c) = (equations.mass.len(), equations.constraints.rows.len());
        let mut slots = Slots::default();
        let mut all = |slot: fn(usize) -> Slot, n: usize| -> Vec<_> {
            (0..n).map(|i| slots.symbol(&mut equations.symbols, slot(i))).collect()
        };
        let (force, row) = (all(Slot::Force, n_q), all(Slot::Row, n_c));
        let elimination = Elimination::of_right_side(equations, &force, &row);
        let sums = Sums::new(equations);
        let mut extended = constants.clone();
        let mut lowering = Lowering::new(&equations.algebra, &mut extended);
        let lowered = sums.lower(equations, &mut lowering);
        let written = elimination.write(&mut lowering, &|symbol| equations.symbols.code_name(symbol));
        let program = lowering.program;
        let level_of = |symbol| match equations.symbols.meaning(symbol) {
            Meaning::Time => Level::Clock,
            Meaning::Coordinate(_) => Level::Position,
            Meaning::Input(_) => Level::Fixed,
            _ => Level::Velocity,
        };
        let source = Source::new(program, &lowered.roots(), level_of)?;
        *constants = extended;
        let (products, base, kept) = (Vec::new(), Vec::new(), Vec::new());
        let mut step = Step { source, symbols: &mut equations.symbols, slots, products, base, kept };
        let right_side = right_side(&mut step, &lowered);
        let finish = finish(&mut step, n_q);
        let solution = solution::kernel(&mut step, &written);
        let begin = begin(&mut step, &lowered, &written.pivots);
        Ok(Self {
            begin,
            pivots: written.pivots.into_iter().map(|(rows, ..)| rows).collect(),
            right_side,
            solution,
            finish,
            n_base: step.base.len(),
            n_kept: step.kept.len(),
            n_products: step.products.len(),
            slots: step.slots,
        })
    }
}

impl Series {
    /// Operations of one order, without the sums of products.
    pub fn operations(&self) -> Count {
        [&self.right_side, &self.solution, &self.finish].map(|kernel| kernel.program.count()).into_iter().sum()
    }
}

/// The same as expressions.
struct Sums {
    velocity: Vec<(SumId, Vec<product::Term>)>,
    reaction: Vec<Vec<product::Term>>,
}

impl Sums {
    fn new(equations: &mut Equations) -> Self {
        let (algebra, constraints) = (&mut equations.algebra, &equations.constraints);
        let velocity_rows = constraints.n_position_rows..constraints.rows.len();
        let velocity = velocity_rows.map(|row| (constraints.drift[row], terms(algebra, &constraints.jacobian[row])));
        let velocity = velocity.collect();
        let column = |i: usize| {
            let rows = constraints.jacobian.iter().enumerate();
            let entries = rows.flat_map(|(row, entries)| entries.iter().map(move |&(column, g)| (row, column, g)));
            entries.filter(|&(_, column, _)| column == i).map(|(row, _, g)| (row, g)).collect::<Vec<_>>()
        };
        let reaction = (0..equations.mass.len()).map(|i| terms(algebra, &column(i))).collect();
        Self { velocity, reaction }
    }

    fn lower(&self, equations: &Equations, lowering: &mut Lowering<'_>) -> Lowered {
        let mut all = |sums: &[SumId]| sums.iter().map(|&sum| lowering.lower(sum)).collect::<Vec<_>>();
        let position = all(&equations.constraints.position);
        let force = all(&equations.force);
        let convective = all(&equations.constraints.convective);
        let mut term = |term: &product::Term, right: fn(Vec<(Value, usize)>) -> RightFactor| {
            let left = lowering.lower(term.left);
            let outer = lowering.coefficient(term.outer);
            let factors = term.right.iter().map(|&(k, i)| (lowering.coefficient(k), i)).collect();
            let left_factor = Factor { node: left.node, scaled: false };
            let outer = if left.negative { outer.neg() } else { outer };
            Term { outer, product: Product { left: left_factor, right: right(factors) } }
        };
        let mut terms = |all: &[product::Term], right| all.iter().map(|one| term(one, right)).collect::<Vec<_>>();
        let reaction = self.reaction.iter().map(|all| terms(all, RightFactor::Multipliers)).collect();
        let rates: Vec<_> = self.velocity.iter().map(|(_, all)| terms(all, RightFactor::Rates)).collect();
        let drift = self.velocity.iter().map(|&(drift, _)| lowering.lower(drift)).collect::<Vec<_>>();
        let velocity = drift.into_iter().zip(rates).collect();
        Lowered { position, velocity, force, reaction, convective }
    }
}

impl Lowered {
    fn roots(&self) -> Vec<NodeId> {
        let rates = self.velocity.iter().flat_map(|(_, terms)| terms);
        let factors = self.reaction.iter().flatten().chain(rates).map(|term| term.product.left.node);
        let drift = self.velocity.iter().map(|(drift, _)| drift);
        let values = self.position.iter().chain(&self.force).chain(drift);
        values.map(|value| value.node).chain(factors).collect()
    }
}

impl Step<'_> {
    /// Place of a product among all.
    fn product(&mut self, product: Product) -> usize {
        place(&mut self.products, product)
    }

    /// Place of a value among those whose coefficients are kept.
    fn keep(&mut self, id: NodeId) -> usize {
        place(&mut self.kept, id)
    }

    /// The value at the start of the step, in a program of later orders.
    fn start(&mut self, id: NodeId, program: &mut Program) -> Value {
        let node = self.source.program.node(id);
        let symbol = match node {
            Node::Constant(_) | Node::Literal(_) => return program.leaf(node.clone()),
            Node::Input(symbol) if self.source.level(id) == Level::Fixed => *symbol,
            _ => {
                let i = place(&mut self.base, id);
                self.slots.symbol(self.symbols, Slot::Base(i))
            }
        };
        program.leaf(Node::Input(symbol))
    }

    /// The first coefficient of a value that is linear in time.
    fn slope(&mut self, id: NodeId, program: &mut Program) -> Value {
        if self.source.level(id) == Level::Fixed {
            return program.literal(0.0);
        }
        match *self.source.program.node(id) {
            Node::Add(a, b) => {
                let (a, b) = (self.slope(a, program), self.slope(b, program));
                program.add(a, b)
            }
            Node::Sub(a, b) => {
                let (a, b) = (self.slope(a, program), self.slope(b, program));
                program.sub(a, b)
            }
            Node::Neg(a) => self.slope(a, program).neg(),
            Node::Mul(a, b) if self.source.level(a) == Level::Fixed => {
                let (a, b) = (self.start(a, program), self.slope(b, program));
                program.mul(a, b)
            }
            Node::Mul(a, b) => {
                let (a, b) = (self.slope(a, program), self.start(b, program));
                program.mul(a, b)
            }
            Node::Div(a, b) => {
                let (a, b) = (self.slope(a, program), self.start(b, program));
                program.div(a, b)
            }
            // time
            _ => program.literal(1.0),
        }
    }
}

fn place<T: PartialEq>(list: &mut Vec<T>, item: T) -> usize {
    let found = list.iter().position(|other| *other == item);
    found.unwrap_or_else(|| {
        list.push(item);
        list.len() - 1
    })
}

/// Outputs of a program as they are written.
#[derive(Default)]
struct Outputs {
    values: Vec<Value>,
    targets: Vec<Slot>,
}

impl Outputs {
    fn push(&mut self, target: Slot, value: Value) {
        self.values.push(value);
        self.targets.push(target);
    }

    fn kernel(self, mut program: Program) -> Kernel {
        self.values.into_iter().for_each(|value| program.push_output(value));
        program.settle_signs();
        Kernel { program, targets: self.targets }
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

/// f_k = F_k − Σ_{j≥1} G_jᵀ λ_{k−j}; r_k = −(k + 1)(k + 2) Ĉ_{k+2} or −(k + 1) (S v + s_t)^_{k+1}, with the unknown left out.
fn right_side(step: &mut Step<'_>, lowered: &Lowered) -> Kernel {
    let mut outputs = Outputs::default();
    let mut of = Coefficients::new(step, Target::Velocity);
    for (i, (&force, reaction)) in lowered.force.iter().zip(&lowered.reaction).enumerate() {
        let (force, reaction) = (of.of_value(force), total(&mut of, reaction));
        let value = of.program.sub(force, reaction);
        outputs.push(Slot::Force(i), value);
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
        let Product { left, right } = of.step.products[i].clone();
        if let RightFactor::Velocity(right) = right {
            let (left, right, zero) = (of.factor(left), of.of(right), of.program.literal(0.0));
            outputs.push(Slot::Left(0, i), left);
            // read by the next order before it is known
            outputs.push(Slot::Left(1, i), zero);
            outputs.push(Slot::Right(2, i), right);
        }
        i += 1;
    }
    outputs.kernel(of.program)
}

fn finish(step: &mut Step<'_>, n_q: usize) -> Kernel {
    let mut outputs = Outputs::default();
    let mut of = Coefficients::new(step, Target::Position);
    for i in 0..n_q {
        let value = of.coordinate(i);
        outputs.push(Slot::Coordinate(2, i), value);
    }
    let (mut i, mut k) = (0, 0);
    while i < of.step.products.len() || k < of.step.kept.len() {
        if let Some(Product { left, right }) = of.step.products.get(i).cloned() {
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
            let value = of.of(of.step.kept[k]);
            outputs.push(Slot::Kept(2, k), value);
            k += 1;
        }
    }
    outputs.kernel(of.program)
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

fn begin(step: &mut Step<'_>, lowered: &Lowered, pivots: &[(Vec<usize>, Value, Value)]) -> Kernel {
    let mut outputs = Outputs::default();
    let (products, kept, base) = (step.products.clone(), step.kept.clone(), step.base.clone());
    let mut of = Coefficients::new(step, Target::First);
    base.into_iter().enumerate().for_each(|(i, node)| outputs.push(Slot::Base(i), plus(node)));
    lowered.force.iter().enumerate().for_each(|(i, &value)| outputs.push(Slot::Force(i), value));
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
    for (i, node) in kept.into_iter().enumerate() {
        outputs.push(Slot::Kept(1, i), plus(node));
        let first = of.of(node);
        outputs.push(Slot::Kept(2, i), first);
    }
    let mut program = of.program;
    let Outputs { values, targets } = outputs;
    let watched = pivots.iter().flat_map(|&(_, pivot, threshold)| [pivot, threshold]);
    values.into_iter().chain(watched).for_each(|value| program.push_output(value));
    program.settle_signs();
    Kernel { program, targets }
}
