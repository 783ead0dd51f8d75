//! The kernels that solve: accelerations with multipliers, the mass-weighted correction, and both at one configuration.

use super::block::{Solved, System};
use super::elimination::Reduced;
use super::scene::Equations;
use crate::symbolic::coefficient::Coefficient;
use crate::symbolic::lower::{ConstantPool, Lowering};
use crate::symbolic::program::{Node, Program, Value};
use crate::symbolic::{SumId, Symbol};

/// A pivot vanishes below this fraction of the diagonal that it started from; `ezy_core::__private::PIVOT_TOLERANCE`.
const PIVOT_TOLERANCE: f64 = 1e-10;

/// Most rows of G that one body may be in for a straight-line elimination. All of them are coupled through it: r rows cost
/// r³/3 operations. rustc sets this limit: a release build takes some 100 s and 1 GB at 24 rows, some 500 s and 2 GB at 36
/// (`docs/decisions/041-no-elimination-of-wide-hubs.md`). `analytic_elimination_is_written_up_to_24_rows_of_a_body` in
/// `growth.rs` checks it.
const MOST_ROWS_OF_A_BODY: usize = 24;

/// Whether an elimination is written: not where rustc would take minutes for it.
pub fn is_worth_writing(equations: &Equations) -> bool {
    let mut n_rows = vec![0; equations.mass.len()];
    let entries = equations.constraints.jacobian.iter().flatten();
    entries.for_each(|&(column, _)| n_rows[column] += 1);
    n_rows.into_iter().all(|n| n <= MOST_ROWS_OF_A_BODY)
}

/// A program that ends in a solution.
#[derive(Debug)]
pub struct Solver {
    /// Outputs: the solution, then value and threshold of each pivot in the order of `pivots`.
    pub program: Program,
    pub n_outputs: usize,
    /// Rows of each watched pivot.
    pub pivots: Vec<Vec<usize>>,
}

impl Solver {
    fn new(mut program: Program, outputs: Vec<Value>, pivots: Vec<(Vec<usize>, Value, Value)>) -> Self {
        let n_outputs = outputs.len();
        let watched = pivots.iter().flat_map(|&(_, pivot, threshold)| [pivot, threshold]);
        outputs.into_iter().chain(watched).for_each(|output| program.push_output(output));
        program.settle_signs();
        Self { program, n_outputs, pivots: pivots.into_iter().map(|(rows, ..)| rows).collect() }
    }
}

/// What the eliminations of a scene solve for.
pub struct Solutions {
    /// `M a + Gᵀ λ = F`, `G a = −[h; s]`: outputs a, then λ.
    pub accelerations: Solver,
    /// `delta = −M⁻¹ Gᵀ ν` with `A ν = residual`: outputs delta.
    pub correction: Solver,
    /// The residuals that it reads, ascending.
    pub residuals: Vec<Symbol>,
    /// Residuals of the velocity constraints, velocities corrected by them, and a and λ at those, by one elimination.
    pub projected: Solver,
    /// Blocks in the order of elimination, with whether the pivot is constant.
    pub order: Vec<(Vec<usize>, bool)>,
}

impl Solutions {
    /// None where an elimination is not worth writing.
    pub fn derive(equations: &mut Equations, constants: &mut ConstantPool) -> Option<Self> {
        if !is_worth_writing(equations) {
            return None;
        }
        let n_rows = equations.constraints.rows.len();
        let residuals: Vec<Symbol> =
            (0..n_rows).map(|i| equations.symbols.new_named(format!("residual_{i}"))).collect();
        let of_accelerations = accelerations(equations);
        let of_correction = correction(equations, &residuals);
        let name_of = |symbol| equations.symbols.code_name(symbol);
        let mut lower = Lowering::new(&equations.algebra, constants);
        let written = of_accelerations.write(&mut lower, &name_of);
        let order = written.order.clone();
        let outputs = [written.solution, written.multipliers].concat();
        let accelerations = Solver::new(lower.program, outputs, written.pivots);

        let mut lower = Lowering::new(&equations.algebra, constants);
        let written = of_correction.write(&mut lower, &name_of);
        let correction = Solver::new(lower.program, written.solution, written.pivots);

        let mut lower = Lowering::new(&equations.algebra, constants);
        let mut outputs = Vec::new();
        for (&symbol, &rate) in residuals.iter().zip(&equations.constraints.velocity) {
            let value = lower.lower(rate);
            lower.bind(symbol, value);
            outputs.push(value);
        }
        let written = of_correction.write(&mut lower, &|symbol| format!("projection_{}", name_of(symbol)));
        lower.forget();
        for (i, delta) in written.solution.into_iter().enumerate() {
            let symbol = equations.symbols.velocity_at(i);
            let before = lower.program.leaf(Node::Input(symbol));
            let value = lower.program.add(before, delta);
            lower.program.set_name(value, &format!("projected_{}", name_of(symbol)));
            lower.bind(symbol, value);
            outputs.push(value);
        }
        let written = of_accelerations.write(&mut lower, &name_of);
        outputs.extend(written.solution);
        outputs.extend(written.multipliers);
        let projected = Solver::new(lower.program, outputs, written.pivots);
        Some(Self { accelerations, correction, residuals, projected, order })
    }
}

fn accelerations(equations: &mut Equations) -> Elimination {
    let mut forces = Vec::new();
    for i in 0..equations.force.len() {
        forces.push(named_force(equations, i));
    }
    let mut right_side = equations.constraints.convective.clone();
    for (row, entry) in right_side.iter_mut().enumerate() {
        for &(k, g) in &equations.constraints.jacobian[row] {
            let algebra = &mut equations.algebra;
            let inverse = algebra.coefficients.div(Coefficient::ONE, equations.mass[k]);
            let product = algebra.mul(g, forces[k].value);
            let product = algebra.scale(product, inverse);
            *entry = algebra.add(*entry, product);
        }
    }
    let reduced = Reduced::new(equations, right_side);
    let solution = reactions(equations, &reduced.multipliers)
        .into_iter()
        .enumerate()
        .map(|(i, reaction)| {
            let total = equations.algebra.add(forces[i].value, reaction);
            divide_by_mass(equations, total, i)
        })
        .collect::<Vec<_>>();
    let named = forces.iter().filter_map(|force| force.named).collect::<Vec<_>>();
    Elimination::new(equations, named, reduced, solution)
}

fn correction(equations: &mut Equations, residuals: &[Symbol]) -> Elimination {
    let right_side = residuals.iter().map(|&symbol| equations.algebra.symbol(symbol)).collect();
    let reduced = Reduced::new(equations, right_side);
    let solution = reactions(equations, &reduced.multipliers)
        .into_iter()
        .enumerate()
        .map(|(i, reaction)| divide_by_mass(equations, reaction, i))
        .collect::<Vec<_>>();
    Elimination::new(equations, Vec::new(), reduced, solution)
}

/// An applied force as it enters the equations: itself, or a symbol when it has several terms.
struct NamedForce {
    value: SumId,
    named: Option<(Symbol, SumId)>,
}

fn named_force(equations: &mut Equations, i: usize) -> NamedForce {
    let force = equations.force[i];
    if equations.algebra.terms(force).len() <= 1 {
        return NamedForce { value: force, named: None };
    }
    let name = equations.symbols.code_name(equations.symbols.coordinate_at(i));
    let symbol = equations.symbols.new_named(format!("force_{name}"));
    NamedForce { value: equations.algebra.symbol(symbol), named: Some((symbol, force)) }
}

/// −Gᵀ λ
fn reactions(equations: &mut Equations, multipliers: &[Symbol]) -> Vec<SumId> {
    let (algebra, constraints) = (&mut equations.algebra, &equations.constraints);
    let mut columns: Vec<Vec<(usize, SumId)>> = vec![Vec::new(); equations.mass.len()];
    for (row, entries) in constraints.jacobian.iter().enumerate() {
        entries.iter().for_each(|&(column, g)| columns[column].push((row, g)));
    }
    columns
        .into_iter()
        .map(|column| {
            let mut parts = Vec::new();
            for (row, g) in column {
                let lambda = algebra.symbol(multipliers[row]);
                let product = algebra.mul(g, lambda);
                parts.push(algebra.neg(product));
            }
            algebra.total(&parts)
        })
        .collect()
}

fn divide_by_mass(equations: &mut Equations, force: SumId, i: usize) -> SumId {
    let algebra = &mut equations.algebra;
    let inverse = algebra.coefficients.div(Coefficient::ONE, equations.mass[i]);
    algebra.scale(force, inverse)
}

/// A solution ready to be written into a program: no new expressions are needed.
pub struct Elimination {
    named: Vec<(Symbol, SumId)>,
    reduced: Reduced,
    solution: Vec<SumId>,
    blocks: Vec<Vec<usize>>,
    thresholds: Thresholds,
}

/// A solution in a program.
pub struct Written {
    /// What was solved for.
    pub solution: Vec<Value>,
    /// By row.
    pub multipliers: Vec<Value>,
    /// Rows, pivot and threshold of each watched pivot, in the order of elimination.
    pub pivots: Vec<(Vec<usize>, Value, Value)>,
    /// Blocks in the order of elimination, with whether the pivot is constant.
    pub order: Vec<(Vec<usize>, bool)>,
}

impl Elimination {
    fn new(equations: &mut Equations, named: Vec<(Symbol, SumId)>, reduced: Reduced, solution: Vec<SumId>) -> Self {
        let blocks = blocks(equations, &reduced);
        let thresholds = thresholds(equations, &reduced, &blocks);
        Self { named, reduced, solution, blocks, thresholds }
    }

    /// `M a + Gᵀ λ = f`, `G a = r` with symbols for f and r.
    pub fn of_right_side(equations: &mut Equations, force: &[Symbol], row: &[Symbol]) -> Self {
        let force: Vec<SumId> = force.iter().map(|&symbol| equations.algebra.symbol(symbol)).collect();
        let mut right_side = Vec::new();
        for (i, &symbol) in row.iter().enumerate() {
            let algebra = &mut equations.algebra;
            let value = algebra.symbol(symbol);
            let mut entry = algebra.neg(value);
            for &(k, g) in &equations.constraints.jacobian[i] {
                let inverse = algebra.coefficients.div(Coefficient::ONE, equations.mass[k]);
                let product = algebra.mul(g, force[k]);
                let product = algebra.scale(product, inverse);
                entry = algebra.add(entry, product);
            }
            right_side.push(entry);
        }
        let reduced = Reduced::new(equations, right_side);
        let reactions = reactions(equations, &reduced.multipliers);
        let solution = reactions.into_iter().enumerate().map(|(i, reaction)| {
            let total = equations.algebra.add(force[i], reaction);
            divide_by_mass(equations, total, i)
        });
        let solution = solution.collect();
        Self::new(equations, Vec::new(), reduced, solution)
    }

    /// Writes the solution; `name_of` names the temporaries.
    pub fn write(&self, lowering: &mut Lowering<'_>, name_of: &dyn Fn(Symbol) -> String) -> Written {
        let Self { named, reduced, solution, blocks, thresholds } = self;
        for &(symbol, force) in named {
            let value = lowering.lower(force);
            lowering.program.set_name(value, &name_of(symbol));
            lowering.bind(symbol, value);
        }
        for step in &reduced.steps {
            let value = lowering.lower(step.right_side);
            lowering.program.set_name(value, &name_of(step.symbol));
            lowering.bind(step.symbol, value);
        }
        let row_name = |i: usize| {
            let name = name_of(reduced.multipliers[reduced.rest[i]]);
            name.split_once("lambda_").map_or_else(|| name.clone(), |(_, row)| row.to_owned())
        };
        let mut matrix = Vec::new();
        for (i, row) in reduced.matrix.iter().enumerate() {
            let mut values = Vec::new();
            for (place, &(j, entry)) in row.iter().enumerate() {
                if place < j {
                    lowering.lower(SumId::ZERO);
                }
                let value = lowering.lower(entry);
                lowering.program.set_hint(value, &format!("A_{}_{}", row_name(i), row_name(j)));
                values.push((j, value));
            }
            if row.len() < reduced.rest.len() {
                lowering.lower(SumId::ZERO);
            }
            matrix.push(values);
        }
        let mut right_side = Vec::new();
        for (i, &entry) in reduced.right_side.iter().enumerate() {
            let value = lowering.lower(entry);
            lowering.program.set_hint(value, &format!("right_side_{}", row_name(i)));
            right_side.push(value);
        }
        let system = System::new(&mut lowering.program, matrix, right_side);
        let Solved { solution: found, pivots } = system.solve(blocks);

        let zero = lowering.program.literal(0.0);
        let mut multipliers = vec![zero; reduced.multipliers.len()];
        for (&row, &value) in reduced.rest.iter().zip(&found) {
            multipliers[row] = value;
            lowering.program.set_name(value, &name_of(reduced.multipliers[row]));
            lowering.bind(reduced.multipliers[row], value);
        }
        for &(row, sum) in &reduced.back_substitution {
            let value = lowering.lower(sum);
            multipliers[row] = value;
            lowering.program.set_name(value, &name_of(reduced.multipliers[row]));
            lowering.bind(reduced.multipliers[row], value);
        }
        let solution = solution.iter().map(|&sum| lowering.lower(sum)).collect();
        let (mut watched, mut order) = (Vec::new(), Vec::new());
        for (step, threshold) in reduced.steps.iter().zip(&thresholds.constant) {
            let (pivot, threshold) = (lowering.coefficient(step.pivot), lowering.lower(*threshold));
            watched.push((vec![step.row], pivot, threshold));
            order.push((vec![step.row], true));
        }
        for (i, pivot) in pivots {
            let rows: Vec<usize> = blocks[i].iter().map(|&i| reduced.rest[i]).collect();
            let names: Vec<String> = blocks[i].iter().map(|&i| row_name(i)).collect();
            lowering.program.set_hint(pivot, &format!("pivot_{}", names.join("_")));
            watched.push((rows.clone(), pivot, lowering.lower(thresholds.moving[i])));
            order.push((rows, false));
        }
        Written { solution, multipliers, pivots: watched, order }
    }
}

/// Rows of one declaration in pairs; indices into `reduced.rest`.
fn blocks(equations: &Equations, reduced: &Reduced) -> Vec<Vec<usize>> {
    let family = |i: &usize| equations.constraints.rows[reduced.rest[*i]].family;
    let rest: Vec<usize> = (0..reduced.rest.len()).collect();
    rest.chunk_by(|a, b| family(a) == family(b)).flat_map(|rows| rows.chunks(2)).map(<[usize]>::to_vec).collect()
}

/// Thresholds below which a pivot counts as vanished.
struct Thresholds {
    constant: Vec<SumId>,
    moving: Vec<SumId>,
}

/// A single pivot is compared with its own diagonal, the determinant of a pair with the square of its trace:
/// the trace of a hinge between bodies does not vary, so the comparison costs nothing.
fn thresholds(equations: &mut Equations, reduced: &Reduced, blocks: &[Vec<usize>]) -> Thresholds {
    let algebra = &mut equations.algebra;
    let tolerance = algebra.number(PIVOT_TOLERANCE);
    let constant = reduced.steps.iter().map(|step| algebra.mul(tolerance, step.diagonal)).collect();
    let moving = blocks
        .iter()
        .map(|block| {
            let diagonals: Vec<SumId> = block.iter().map(|&i| reduced.diagonal[i]).collect();
            let trace = algebra.total(&diagonals);
            let scale = if block.len() == 2 { algebra.mul(trace, trace) } else { trace };
            algebra.mul(tolerance, scale)
        })
        .collect();
    Thresholds { constant, moving }
}
