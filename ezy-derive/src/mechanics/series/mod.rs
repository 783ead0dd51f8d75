//! The Taylor series of a motion: the recurrences of all coefficients, from the expressions that everything else is
//! derived from.
//!
//! A first-order state is like a velocity whose acceleration is its rate: z_{k+1} = ż_k / (k + 1) is known with the forces of order k, and forces of
//! order k + 1 read it.
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
use crate::mechanics::kernels::{Entries, Pass, Slot};
use crate::mechanics::scene::Equations;
use crate::mechanics::solve::{self, Elimination, Written};
use crate::mechanics::symbols::Symbols;
use crate::model::{BodyId, Loop};
use crate::symbolic::interner::Interner;
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::{Node, NodeId, Program, Value};
use crate::symbolic::{Algebra, SumId};
use level::{Level, Source};
use lowered::{Lowered, Sums};
use product::Product;
use slot::Slots;

/// The recurrences of a scene, or of an item of a scene with counts.
#[derive(Debug)]
pub struct Series<'m> {
    /// Values at the start of a step. For it, what is one order ahead of k is of order 0. Its outputs past those that are
    /// put somewhere are pivots and their thresholds.
    pub begin: Pass<'m>,
    /// f and r of order k, and order k + 1 of the first-order states.
    pub right_side: Pass<'m>,
    /// `None` without elimination: a and λ come from elsewhere.
    pub solution: Option<Solution<'m>>,
    /// Order k + 2 of q, for a scene, and of what depends on positions and time alone.
    pub finish: Pass<'m>,
}

/// How a scene with an elimination solves.
#[derive(Debug)]
pub struct Solution<'m> {
    /// Rows of each watched pivot.
    pub pivots: Vec<Vec<usize>>,
    /// a and λ of order k.
    pub pass: Pass<'m>,
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

impl Series<'_> {
    /// Of a scene.
    ///
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
        let sums = Sums::new(&mut equations.algebra, Some(&equations.constraints), &force, &equations.rates);
        let mut extended = constants.clone();
        let mut lowering = Lowering::new(&equations.algebra, &mut extended);
        let lowered = sums.lower(&mut lowering);
        let name_of = |symbol| equations.symbols.code_name(symbol);
        let written = elimination.map(|elimination| elimination.write(&mut lowering, &name_of));
        let program = lowering.program;
        let mut step = lowered.step(program, &mut equations.symbols, slots)?;
        *constants = extended;
        Ok(step.series(&lowered, n_q, n_c, written))
    }

    /// Of an item of a scene with counts: its rows, or its force by coordinate, or the rates of all first-order states.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn of_item(
        algebra: &mut Algebra,
        symbols: &mut Symbols,
        constants: &mut ConstantPool,
        constraints: Option<&Constraints>,
        force: &[(usize, SumId)],
        rates: &[SumId],
    ) -> Result<Self, Function> {
        let sums = Sums::new(algebra, constraints, force, rates);
        let mut lowering = Lowering::new(algebra, constants);
        let lowered = sums.lower(&mut lowering);
        let program = lowering.program;
        let mut step = lowered.step(program, symbols, Slots::default())?;
        step.of_item = true;
        Ok(step.series(&lowered, 0, constraints.map_or(0, |constraints| constraints.rows.len()), None))
    }
}

impl<'m> Series<'m> {
    /// For each member of an item.
    pub fn of_members(self, loops: &'m [Loop], slots: &[BodyId]) -> Self {
        let of_members = |pass| Pass { loops, slots: slots.to_vec(), ..pass };
        let [begin, right_side, finish] = [self.begin, self.right_side, self.finish].map(of_members);
        Self { begin, right_side, finish, ..self }
    }
}

impl Step<'_> {
    /// All passes; q of order k + 2 is found for the first `n_q` coordinates.
    fn series<'m>(&mut self, lowered: &Lowered, n_q: usize, n_rows: usize, written: Option<Written>) -> Series<'m> {
        let right_side = orders::right_side(self, lowered);
        let finish = orders::finish(self, lowered, 0..n_q);
        let solution = written.as_ref().map(|written| solution::pass(self, written));
        let pivots = written.map(|written| written.pivots).unwrap_or_default();
        let begin = orders::begin(self, lowered, &pivots);
        let pivots = pivots.into_iter().map(|(rows, ..)| rows).collect();
        let solution = solution.map(|pass| Solution { pivots, pass });
        let (n_products, n_base, n_kept) = (self.products.len(), self.base.len(), self.kept.len());
        let lengths = [
            (Entries::Rows, n_rows),
            (Entries::Products, n_products),
            (Entries::Base, n_base),
            (Entries::Kept, n_kept),
        ];
        let [begin, right_side, finish] =
            [begin, right_side, finish].map(|pass| Pass { lengths: lengths.to_vec(), ..pass });
        Series { begin, right_side, solution, finish }
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
            // first-order states stand in `c`, too
            Node::Input(symbol)
                if self.source.level(id) == Level::Fixed || self.symbols.state_of(*symbol).is_some() =>
            {
                *symbol
            }
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
