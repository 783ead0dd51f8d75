//! The Taylor series of a motion: the recurrences of all coefficients, from the expressions that everything else is
//! derived from.
//!
//! At every order k the equations of motion are `[M G₀ᵀ; G₀ 0] [a_k; λ_k] = [f_k; r_k]`. What is emitted are four
//! programs: values and factors at the start of a step, the right side of an order, its solution, and what follows from
//! it. `ezy_core::__private::Series` says how they are called.

mod level;
mod lowered;
mod orders;
mod product;
mod recurrence;
mod slot;
mod solution;

use crate::function::Function;
use crate::mechanics::constraints::Constraints;
use crate::mechanics::scene::Equations;
use crate::mechanics::solve::{self, Elimination};
use crate::mechanics::symbols::Symbols;
use crate::symbolic::interner::Interner;
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::{Count, Node, NodeId, Program, Value};
use crate::symbolic::{Algebra, SumId};
use level::{Level, Source};
use lowered::Sums;
use product::Product;
pub use slot::{Ahead, Slot, Slots};

/// A program and where each of its outputs is written.
#[derive(Debug)]
pub struct Kernel {
    pub program: Program,
    pub targets: Vec<Slot>,
}

/// The recurrences of a scene, or of an item of a scene with counts.
#[derive(Debug)]
pub struct Recurrences {
    /// Values at the start of a step. For it, what is one order ahead of k is of order 0. Its outputs past the targets are
    /// pivots and their thresholds.
    pub begin: Kernel,
    /// f and r of order k.
    pub right_side: Kernel,
    /// Order k + 2 of q, for a scene, and of what depends on positions and time.
    pub finish: Kernel,
    pub slots: Slots,
    pub n_base: usize,
    pub n_kept: usize,
    pub n_products: usize,
}

/// The recurrences of a scene.
#[derive(Debug)]
pub struct Series {
    pub recurrences: Recurrences,
    /// `None` for a scene without elimination, whose solver finds a and λ.
    pub solution: Option<Solution>,
}

/// How a scene with an elimination solves.
#[derive(Debug)]
pub struct Solution {
    /// Rows of each watched pivot.
    pub pivots: Vec<Vec<usize>>,
    /// a and λ of order k.
    pub kernel: Kernel,
}

/// What the programs of a step share.
#[derive(Debug)]
pub struct Step<'e> {
    source: Source,
    symbols: &'e mut Symbols,
    slots: Slots,
    products: Interner<Product>,
    /// Values at the start that are read later.
    base: Interner<NodeId>,
    /// Values whose coefficients are read later.
    kept: Interner<NodeId>,
    /// Whether q of an order is found outside, for all items together.
    of_item: bool,
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
        let elimination =
            solve::is_worth_writing(equations).then(|| Elimination::of_right_side(equations, &force, &row));
        let force: Vec<_> = equations.force.iter().copied().enumerate().collect();
        let sums = Sums::new(&mut equations.algebra, Some(&equations.constraints), &force);
        let mut extended = constants.clone();
        let mut lowering = Lowering::new(&equations.algebra, &mut extended);
        let lowered = sums.lower(&mut lowering);
        let name_of = |symbol| equations.symbols.code_name(symbol);
        let written = elimination.map(|elimination| elimination.write(&mut lowering, &name_of));
        let program = lowering.program;
        let mut step = lowered.step(program, &mut equations.symbols, slots)?;
        *constants = extended;
        let right_side = orders::right_side(&mut step, &lowered);
        let finish = orders::finish(&mut step, 0..n_q);
        let solution = written.as_ref().map(|written| solution::kernel(&mut step, written));
        let pivots = written.map(|written| written.pivots).unwrap_or_default();
        let begin = orders::begin(&mut step, &lowered, &pivots);
        let pivots = pivots.into_iter().map(|(rows, ..)| rows).collect();
        let solution = solution.map(|kernel| Solution { pivots, kernel });
        Ok(Self { recurrences: step.recurrences(begin, right_side, finish), solution })
    }

    /// Products and operations of one order.
    pub fn cost(&self) -> (usize, Count) {
        let (n_products, count) = self.recurrences.cost();
        let solution = self.solution.iter().map(|solution| solution.kernel.program.count());
        (n_products, std::iter::once(count).chain(solution).sum())
    }
}

impl Recurrences {
    /// Of an item of a scene with counts: its rows, or its force by coordinate.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn of_item(
        algebra: &mut Algebra,
        symbols: &mut Symbols,
        constants: &mut ConstantPool,
        constraints: Option<&Constraints>,
        force: &[(usize, SumId)],
    ) -> Result<Self, Function> {
        let sums = Sums::new(algebra, constraints, force);
        let mut lowering = Lowering::new(algebra, constants);
        let lowered = sums.lower(&mut lowering);
        let program = lowering.program;
        let mut step = lowered.step(program, symbols, Slots::default())?;
        step.of_item = true;
        let right_side = orders::right_side(&mut step, &lowered);
        let finish = orders::finish(&mut step, 0..0);
        let begin = orders::begin(&mut step, &lowered, &[]);
        Ok(step.recurrences(begin, right_side, finish))
    }
}

impl Recurrences {
    /// Products and operations of one order, without those of a solution.
    pub fn cost(&self) -> (usize, Count) {
        let kernels = [&self.right_side, &self.finish];
        (self.n_products, kernels.map(|kernel| kernel.program.count()).into_iter().sum())
    }
}

impl Step<'_> {
    fn recurrences(self, begin: Kernel, right_side: Kernel, finish: Kernel) -> Recurrences {
        let Self { slots, products, base, kept, .. } = self;
        let (n_base, n_kept, n_products) = (base.len(), kept.len(), products.len());
        Recurrences { begin, right_side, finish, slots, n_base, n_kept, n_products }
    }

    /// Place of a product among all.
    fn product(&mut self, product: Product) -> usize {
        self.products.intern(product) as usize
    }

    /// Place of a value among those whose coefficients are kept.
    fn keep(&mut self, id: NodeId) -> usize {
        self.kept.intern(id) as usize
    }

    /// The value at the start of the step, in a program of later orders.
    fn start(&mut self, id: NodeId, program: &mut Program) -> Value {
        let node = self.source.program.node(id);
        let symbol = match node {
            Node::Constant(_) | Node::Literal(_) => return program.leaf(node.clone()),
            Node::Input(symbol) if self.source.level(id) == Level::Fixed => *symbol,
            _ => {
                let i = self.base.intern(id) as usize;
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
