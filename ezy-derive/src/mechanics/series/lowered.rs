//! The values of a scene or an item that have series, written in one program.

use std::collections::BTreeMap;

use super::level::{Level, Source};
use super::product::{Factor, Product, RightFactor, Term as SumTerm, terms};
use super::slot::Slots;
use super::{Step, Symbols};
use crate::function::Function;
use crate::mechanics::constraints::Constraints;
use crate::mechanics::symbols::Meaning;
use crate::symbolic::interner::Interner;
use crate::symbolic::lower::Lowering;
use crate::symbolic::program::{NodeId, Program, Value};
use crate::symbolic::{Algebra, SumId};

/// A term of a matrix times a vector: an outer coefficient and the product that it multiplies.
pub struct Term {
    pub outer: Value,
    pub product: Product,
}

/// What an order of the equations of motion is made of.
pub struct Lowered {
    /// C of each position constraint.
    pub position: Vec<Value>,
    /// s_t of each velocity constraint, and S v.
    pub velocity: Vec<(Value, Vec<Term>)>,
    /// By coordinate: F and Gᵀ λ.
    pub force: Vec<(usize, Value, Vec<Term>)>,
    /// h, then s.
    pub convective: Vec<Value>,
}

/// The same as expressions.
pub struct Sums {
    position: Vec<SumId>,
    velocity: Vec<(SumId, Vec<SumTerm>)>,
    force: Vec<(usize, SumId, Vec<SumTerm>)>,
    convective: Vec<SumId>,
}

impl Sums {
    /// Rows, and the forces on the coordinates that they or the rows touch.
    pub fn new(algebra: &mut Algebra, constraints: Option<&Constraints>, force: &[(usize, SumId)]) -> Self {
        let Some(constraints) = constraints else {
            let force = force.iter().map(|&(i, force)| (i, force, Vec::new())).collect();
            return Self { position: Vec::new(), velocity: Vec::new(), force, convective: Vec::new() };
        };
        let velocity_rows = constraints.n_position_rows..constraints.rows.len();
        let velocity = velocity_rows.map(|row| (constraints.drift[row], terms(algebra, &constraints.jacobian[row])));
        let velocity = velocity.collect();
        // of each coordinate that is touched: its force, and the rows that touch it
        let mut touched: BTreeMap<usize, (SumId, Vec<(usize, SumId)>)> = BTreeMap::new();
        for (row, entries) in constraints.jacobian.iter().enumerate() {
            entries.iter().for_each(|&(column, g)| touched.entry(column).or_default().1.push((row, g)));
        }
        for &(i, force) in force.iter().rev() {
            touched.entry(i).or_default().0 = force;
        }
        let of_coordinate = |(i, (force, column)): (usize, (SumId, Vec<_>))| (i, force, terms(algebra, &column));
        let force = touched.into_iter().map(of_coordinate).collect();
        Self { position: constraints.position.clone(), velocity, force, convective: constraints.convective.clone() }
    }

    pub fn lower(&self, lowering: &mut Lowering<'_>) -> Lowered {
        let mut all = |sums: &[SumId]| sums.iter().map(|&sum| lowering.lower(sum)).collect::<Vec<_>>();
        let (position, convective) = (all(&self.position), all(&self.convective));
        let velocity = self.velocity.iter().map(|(drift, rates)| {
            let drift = lowering.lower(*drift);
            (drift, rates.iter().map(|rate| lowered_term(lowering, rate, RightFactor::Rates)).collect())
        });
        let velocity = velocity.collect();
        let force = self.force.iter().map(|(i, force, reaction)| {
            let force = lowering.lower(*force);
            let reaction = reaction.iter().map(|term| lowered_term(lowering, term, RightFactor::Multipliers));
            (*i, force, reaction.collect())
        });
        let force = force.collect();
        Lowered { position, velocity, force, convective }
    }
}

fn lowered_term(lowering: &mut Lowering<'_>, term: &SumTerm, right: fn(Vec<(Value, usize)>) -> RightFactor) -> Term {
    let left = lowering.lower(term.left);
    let outer = lowering.coefficient(term.outer);
    let factors = term.right.iter().map(|&(k, i)| (lowering.coefficient(k), i)).collect();
    let outer = if left.negative { outer.neg() } else { outer };
    Term { outer, product: Product { left: Factor { node: left.node, scaled: false }, right: right(factors) } }
}

impl Lowered {
    /// The step that these values are expanded in.
    ///
    /// # Errors
    /// A function that has no Taylor series.
    pub fn step<'e>(&self, program: Program, symbols: &'e mut Symbols, slots: Slots) -> Result<Step<'e>, Function> {
        let level_of = |symbol| match symbols.meaning(symbol) {
            Meaning::Time => Level::Clock,
            Meaning::Coordinate(_) => Level::Position,
            Meaning::Input(_) => Level::Fixed,
            Meaning::Velocity(_) | Meaning::Named(_) => Level::Velocity,
        };
        let source = Source::new(program, &self.roots(), level_of)?;
        Ok(Step {
            source,
            symbols,
            slots,
            products: Interner::default(),
            base: Interner::default(),
            kept: Interner::default(),
            of_item: false,
        })
    }

    fn roots(&self) -> Vec<NodeId> {
        let rates = self.velocity.iter().flat_map(|(_, terms)| terms);
        let reactions = self.force.iter().flat_map(|(.., terms)| terms);
        let factors = reactions.chain(rates).map(|term| term.product.left.node);
        let forces = self.force.iter().map(|(_, force, _)| force);
        let drift = self.velocity.iter().map(|(drift, _)| drift);
        self.position.iter().chain(forces).chain(drift).map(|value| value.node).chain(factors).collect()
    }
}
