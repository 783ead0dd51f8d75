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
use crate::symbolic::program::{Node, NodeId, Program, Value};
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
    /// Rates of the first-order states.
    pub rates: Vec<Value>,
}

/// The same as expressions.
pub struct Sums {
    position: Vec<SumId>,
    velocity: Vec<(SumId, Vec<SumTerm>)>,
    force: Vec<(usize, SumId, Vec<SumTerm>)>,
    convective: Vec<SumId>,
    rates: Vec<SumId>,
}

impl Sums {
    /// Rows, the forces on the coordinates that they or the rows touch, and rates of first-order states.
    pub fn new(
        algebra: &mut Algebra,
        constraints: Option<&Constraints>,
        force: &[(usize, SumId)],
        rates: &[SumId],
    ) -> Self {
        let rates = rates.to_vec();
        let Some(constraints) = constraints else {
            let force = force.iter().map(|&(i, force)| (i, force, Vec::new())).collect();
            return Self { position: Vec::new(), velocity: Vec::new(), force, convective: Vec::new(), rates };
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
        let (position, convective) = (constraints.position.clone(), constraints.convective.clone());
        Self { position, velocity, force, convective, rates }
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
        let rates = self.rates.iter().map(|&rate| lowering.lower(rate)).collect();
        Lowered { position, velocity, force, convective, rates }
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
    pub fn step<'e>(&self, mut program: Program, symbols: &'e mut Symbols, slots: Slots) -> Result<Step<'e>, Function> {
        let mut kept = Interner::default();
        // whoever finds the rates keeps the states, before anything else
        for state in symbols.states().take(self.rates.len()) {
            kept.intern(program.leaf(Node::Input(state)).node);
        }
        let level_of = |symbol| match symbols.meaning(symbol) {
            Meaning::Time => Level::Clock,
            Meaning::Coordinate(_) => Level::Position,
            Meaning::Input(_) if symbols.state_of(symbol).is_some() => Level::Velocity,
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
            kept,
            of_item: false,
        })
    }

    fn roots(&self) -> Vec<NodeId> {
        let rates = self.velocity.iter().flat_map(|(_, terms)| terms);
        let reactions = self.force.iter().flat_map(|(.., terms)| terms);
        let factors = reactions.chain(rates).map(|term| term.product.left.node);
        let forces = self.force.iter().map(|(_, force, _)| force);
        let drift = self.velocity.iter().map(|(drift, _)| drift);
        let values = self.position.iter().chain(forces).chain(drift).chain(&self.rates);
        values.map(|value| value.node).chain(factors).collect()
    }
}
