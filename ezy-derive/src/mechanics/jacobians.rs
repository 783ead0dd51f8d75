//! How the equations of motion change with coordinates, velocities and first-order states.
//!
//! Their residual is R = [F − M a − Gᵀ λ; −(G a + [h; s]); r − ż] with the rates r of the states; M does not depend on the state.

use std::collections::BTreeMap;

use super::check::LONGEST_SUM;
use super::constraints::Constraints;
use super::kernels::{Put, Read};
use super::symbols::{Meaning, Symbols};
use crate::symbolic::{Algebra, SumId, Symbol};

/// Jacobians with more terms take minutes to derive, and their code takes longer to compile: a vehicle has some hundreds.
const MOST_TERMS: usize = 20_000;

/// The derivatives of R that are not zero.
#[derive(Debug)]
pub struct Jacobians {
    /// What they read besides time, coordinates, velocities and inputs; ascending by symbol.
    pub reads: Vec<(Symbol, Read)>,
    pub by_q: Vec<JacobianEntry>,
    pub by_v: Vec<JacobianEntry>,
    /// By the states; these read neither accelerations nor multipliers.
    pub by_z: Vec<JacobianEntry>,
}

/// An entry: rows of R are coordinates, then rows of G, then first-order states.
#[derive(Debug)]
pub struct JacobianEntry {
    pub row: usize,
    pub column: usize,
    pub value: SumId,
}

impl Jacobians {
    /// Of rows, forces and rates together; `force` by coordinate, `rates` of states one after the other. `None` when they are too long to write.
    pub fn derive(
        algebra: &mut Algebra,
        symbols: &mut Symbols,
        constraints: Option<&Constraints>,
        force: impl IntoIterator<Item = (usize, SumId)>,
        rates: &[SumId],
    ) -> Option<Self> {
        let (mut residual, mut reads) = (BTreeMap::new(), Vec::new());
        if let Some(constraints) = constraints {
            subtract_rows(algebra, symbols, constraints, &mut residual, &mut reads);
        }
        for (i, part) in force {
            let entry = residual.entry(i).or_insert(SumId::ZERO);
            *entry = algebra.add(*entry, part);
        }
        let n_rows = constraints.map_or(0, |constraints| constraints.rows.len());
        let first = symbols.n_coordinates() + n_rows;
        residual.extend(rates.iter().enumerate().map(|(i, rate)| (first + i, *rate)));
        let mut jacobians = Self { reads, by_q: Vec::new(), by_v: Vec::new(), by_z: Vec::new() };
        let mut n_terms = 0;
        for (row, sum) in residual {
            for symbol in algebra.symbols_of(sum) {
                let (entries, column) = match symbols.meaning(symbol) {
                    Meaning::Coordinate(i) => (&mut jacobians.by_q, i),
                    Meaning::Velocity(i) => (&mut jacobians.by_v, i),
                    _ => match symbols.state_of(symbol) {
                        Some(i) => (&mut jacobians.by_z, i),
                        None => continue,
                    },
                };
                let value = algebra.diff(sum, symbol);
                let length = algebra.terms(value).len();
                n_terms += length;
                if length > LONGEST_SUM || n_terms > MOST_TERMS {
                    return None;
                }
                if !value.is_zero() {
                    entries.push(JacobianEntry { row, column, value });
                }
            }
        }
        Some(jacobians)
    }

    /// Values by coordinates, then by velocities.
    pub fn values(&self) -> Vec<SumId> {
        self.by_q.iter().chain(&self.by_v).map(|entry| entry.value).collect()
    }

    /// Where these go: to the first vector and to the second one.
    pub fn puts(&self) -> Vec<Put> {
        [vec![Put::Next(0); self.by_q.len()], vec![Put::Next(1); self.by_v.len()]].concat()
    }

    /// Values by first-order states.
    pub fn values_by_states(&self) -> Vec<SumId> {
        self.by_z.iter().map(|entry| entry.value).collect()
    }
}

/// Subtracts Gᵀ λ from the rows of the coordinates, and G a + [h; s] from those of G.
fn subtract_rows(
    algebra: &mut Algebra,
    symbols: &mut Symbols,
    constraints: &Constraints,
    residual: &mut BTreeMap<usize, SumId>,
    reads: &mut Vec<(Symbol, Read)>,
) {
    let n_q = symbols.n_coordinates();
    let mut accelerations = BTreeMap::new();
    for (row, entries) in constraints.jacobian.iter().enumerate() {
        let multiplier = symbols.new_named(format!("multiplier_{row}"));
        reads.push((multiplier, Read::Multiplier(row)));
        let lambda = algebra.symbol(multiplier);
        let mut parts = vec![constraints.convective[row]];
        for &(i, g) in entries {
            let acceleration = *accelerations.entry(i).or_insert_with(|| {
                let symbol = symbols.new_named(format!("acceleration_{i}"));
                reads.push((symbol, Read::Acceleration(i)));
                symbol
            });
            let a = algebra.symbol(acceleration);
            parts.push(algebra.mul(g, a));
            let reaction = algebra.mul(g, lambda);
            let force = residual.entry(i).or_insert(SumId::ZERO);
            *force = algebra.sub(*force, reaction);
        }
        let sum = algebra.total(&parts);
        residual.insert(n_q + row, algebra.neg(sum));
    }
}
