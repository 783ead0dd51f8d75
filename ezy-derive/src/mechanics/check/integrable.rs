//! Integrable velocity constraints: they integrate to position constraints.
//!
//! On the surface of the position constraints, ω v + s_t = 0 is the rate of a position constraint when dω vanishes on all
//! motions that all of them allow (Frobenius). Time counts as one more coordinate, with s_t as its entry. With one degree of
//! freedom or none every row is integrable; then only a row that is closed already is reported.
//!
//! Source: Frobenius, J. reine angew. Math. 82 (1877); as in Bloch, Nonholonomic Mechanics and Control, ch. 2.

use std::collections::{BTreeMap, BTreeSet};

use super::basis::{Basis, Row, largest};
use super::{DEPENDENT, RandomState, SAMPLES};
use crate::diag::{Diagnostics, equations as message};
use crate::mechanics::rows::ResidualKind;
use crate::mechanics::scene::Equations;
use crate::model::Model;
use crate::symbolic::{SumId, Symbol};

/// dω counts as zero below this part of its entries: rounding leaves 1e-14 of them.
const CLOSED: f64 = 1e-9;

pub fn rows(model: &Model, equations: &mut Equations, reported: &mut Vec<usize>, diag: &mut Diagnostics) {
    let n_h = equations.constraints.n_position_rows;
    let n_c = equations.constraints.rows.len();
    if n_h == n_c {
        return;
    }
    let forms: Vec<Form> = (0..n_c).map(|row| Form::new(equations, row)).collect();
    let samples: Vec<Sample> = (0..SAMPLES).map(|seed| Sample::new(equations, &forms[..n_h], seed)).collect();
    for (row, form) in equations.constraints.rows.iter().zip(&forms).skip(n_h) {
        // up to a limit there is no word for positions
        let has_limit = model.rows[row.family].limit().is_some();
        if !has_limit
            && !reported.contains(&row.family)
            && samples.iter().all(|sample| sample.integrates(equations, form))
        {
            diag.warning(message::integrates(&model.rows[row.family].name, row.kind, &row.name));
            reported.push(row.family);
        }
    }
}

/// A row as a form on coordinates and time, with its slopes; zeros are left out.
struct Form {
    entries: Vec<(usize, SumId)>,
    /// (j, i, ∂ω_j/∂q_i); empty for position constraints, which are closed.
    slopes: Vec<(usize, usize, SumId)>,
}

impl Form {
    fn new(equations: &mut Equations, row: usize) -> Self {
        let Equations { algebra, symbols, constraints, .. } = equations;
        let time = symbols.n_coordinates();
        let mut entries = constraints.jacobian[row].clone();
        // the rate without its part in velocities
        let mut drift = constraints.velocity[row];
        for &(i, entry) in &constraints.jacobian[row] {
            let velocity = algebra.symbol(symbols.velocity_at(i));
            let part = algebra.mul(entry, velocity);
            drift = algebra.sub(drift, part);
        }
        if !drift.is_zero() {
            entries.push((time, drift));
        }
        let mut slopes = Vec::new();
        if matches!(constraints.rows[row].residual, ResidualKind::Velocity(_)) {
            for &(j, entry) in &entries {
                for symbol in algebra.symbols_of(entry) {
                    let i = if symbol == Symbol::TIME { Some(time) } else { symbols.coordinate_of(symbol) };
                    slopes.extend(i.map(|i| (j, i, algebra.diff(entry, symbol))));
                }
            }
        }
        Self { entries, slopes }
    }

    fn at(&self, equations: &Equations, state: &RandomState<'_>) -> Row {
        self.entries.iter().map(|&(column, entry)| (column, equations.algebra.evaluate(entry, state))).collect()
    }
}

/// The motions that the position constraints allow at a random state.
struct Sample {
    seed: u64,
    /// Each coordinate, and time, as a combination of free ones.
    space: Vec<Row>,
    /// Largest entry of the motion of each free coordinate.
    sizes: Row,
}

impl Sample {
    fn new(equations: &Equations, position_rows: &[Form], seed: u64) -> Self {
        let state = RandomState { symbols: &equations.symbols, seed };
        let mut basis = Basis::default();
        for form in position_rows {
            let reduced = basis.reduce(form.at(equations, &state));
            if reduced.size() > DEPENDENT {
                basis.push(reduced);
            }
        }
        let space = basis.null_space(equations.symbols.n_coordinates() + 1);
        let mut sizes = Row::new();
        for (&free, x) in space.iter().flatten() {
            let size = sizes.entry(free).or_insert(0.0);
            *size = x.abs().max(*size);
        }
        Self { seed, space, sizes }
    }

    fn integrates(&self, equations: &Equations, form: &Form) -> bool {
        let state = RandomState { symbols: &equations.symbols, seed: self.seed };
        let slopes = form.slopes.iter().map(|&(j, i, slope)| (j, i, equations.algebra.evaluate(slope, &state)));
        let slopes: Vec<(usize, usize, f64)> = slopes.collect();
        let size = slopes.iter().fold(f64::MIN_POSITIVE, |largest, (.., x)| largest.max(x.abs()));
        let n_motions = self.sizes.len();
        // along the row of velocities itself, where enough motions are left
        let mut along = Row::new();
        for (column, x) in form.at(equations, &state) {
            self.space[column].iter().for_each(|(&free, y)| *along.entry(free).or_insert(0.0) += x * y);
        }
        let (free, rate) = largest(&along);
        let crossed = (rate.abs() > DEPENDENT && n_motions > 3).then_some(free);
        let motions = self.motions(&slopes, &along, crossed);
        let curl = |x: &Row, y: &Row| {
            let product = |i: &usize, j: &usize| Some(x.get(i)? * y.get(j)?);
            let part = |i, j| product(i, j).unwrap_or(0.0) - product(j, i).unwrap_or(0.0);
            slopes.iter().map(|(j, i, slope)| slope * part(i, j)).sum::<f64>()
        };
        let pairs = motions.iter().enumerate().flat_map(|(i, x)| motions[..i].iter().map(move |y| (x, y)));
        n_motions > 2 && pairs.into_iter().all(|(x, y)| curl(x, y).abs() <= CLOSED * size)
    }

    /// The motions that move what the slopes read, by those coordinates, none with an entry far above one. Each is that of
    /// a free coordinate; `crossed` is moved besides so that `along` stays zero.
    fn motions(&self, slopes: &[(usize, usize, f64)], along: &Row, crossed: Option<usize>) -> Vec<Row> {
        let columns: BTreeSet<usize> = slopes.iter().flat_map(|&(j, i, _)| [j, i]).collect();
        let mut motions: BTreeMap<usize, Row> = BTreeMap::new();
        for &column in &columns {
            for (&free, &x) in &self.space[column] {
                motions.entry(free).or_default().insert(column, x);
            }
        }
        if let Some(crossed) = crossed {
            let besides = motions.remove(&crossed).unwrap_or_default();
            for (&free, rate) in along.iter().filter(|(free, _)| **free != crossed) {
                let factor = rate / along[&crossed];
                let motion = motions.entry(free).or_default();
                for (&column, x) in &besides {
                    *motion.entry(column).or_insert(0.0) -= factor * x;
                }
                let size = self.sizes[&free] + (factor * self.sizes[&crossed]).abs();
                motion.values_mut().for_each(|x| *x *= self.sizes[&free] / size);
            }
        }
        for (free, motion) in &mut motions {
            motion.values_mut().for_each(|x| *x /= self.sizes[free]);
        }
        motions.into_values().collect()
    }
}
