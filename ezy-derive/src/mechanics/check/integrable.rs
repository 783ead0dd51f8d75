//! Integrable velocity constraints: they integrate to position constraints.
//!
//! On the surface of the position constraints, ω v + s_t = 0 is the rate of a position constraint when dω vanishes on all
//! motions that all of them allow (Frobenius). Time counts as one more coordinate, with s_t as its entry. With one degree of
//! freedom or none every row is integrable; then only a row that is closed already is reported.
//!
//! Source: Frobenius, J. reine angew. Math. 82 (1877); as in Bloch, Nonholonomic Mechanics and Control, ch. 2.

use super::{DEPENDENT, RandomState, SAMPLES};
use crate::diag::{Diagnostics, equations as message};
use crate::mechanics::rows::Demand;
use crate::mechanics::scene::Equations;
use crate::model::Model;
use crate::symbolic::{SumId, Symbol};

/// dω counts as zero below this part of its entries: rounding leaves 1e-14 of them.
const CLOSED: f64 = 1e-9;

pub fn rows(model: &Model, equations: &mut Equations, reported: &mut Vec<usize>, diag: &mut Diagnostics) {
    let forms: Vec<Form> = (0..equations.constraints.rows.len()).map(|row| Form::new(equations, row)).collect();
    for (i, row) in equations.constraints.rows.iter().enumerate() {
        let velocity = matches!(row.demand, Demand::Velocity(_));
        if velocity
            && !reported.contains(&row.family)
            && (0..SAMPLES).all(|seed| integrates(equations, &forms, i, seed))
        {
            diag.warning(message::integrates(&model.rows[row.family].name, row.kind, &row.name));
            reported.push(row.family);
        }
    }
}

/// A row as a form on coordinates and time, with its slopes.
struct Form {
    entries: Vec<SumId>,
    /// `slopes[j][i]` = ∂ω_j/∂q_i; empty for position rows, which are closed.
    slopes: Vec<Vec<SumId>>,
}

impl Form {
    fn new(equations: &mut Equations, row: usize) -> Self {
        let n_q = equations.mass.len();
        let constraints = &equations.constraints;
        let mut entries = vec![SumId::ZERO; n_q + 1];
        for &(column, entry) in &constraints.jacobian[row] {
            entries[column] = entry;
        }
        let (algebra, symbols) = (&mut equations.algebra, &equations.symbols);
        // the rate without its part in velocities
        let mut drift = constraints.velocity[row];
        for (i, &entry) in entries[..n_q].iter().enumerate() {
            let velocity = algebra.symbol(symbols.velocity_at(i));
            let part = algebra.mul(entry, velocity);
            drift = algebra.sub(drift, part);
        }
        entries[n_q] = drift;
        let slopes = match constraints.rows[row].demand {
            Demand::Position(_) => Vec::new(),
            Demand::Velocity(_) => {
                let coordinate = |i| if i < n_q { symbols.coordinate_at(i) } else { Symbol::TIME };
                let slope = |entry: SumId| (0..=n_q).map(|i| algebra.diff(entry, coordinate(i))).collect();
                entries.iter().copied().map(slope).collect()
            }
        };
        Self { entries, slopes }
    }
}

fn integrates(equations: &Equations, forms: &[Form], row: usize, seed: u64) -> bool {
    let state = RandomState { symbols: &equations.symbols, seed };
    let value = |sum: SumId| equations.algebra.evaluate(sum, &state);
    let values = |sums: &[SumId]| sums.iter().map(|&sum| value(sum)).collect::<Vec<f64>>();
    let n_h = equations.constraints.n_position_rows;
    let mut rows: Vec<Vec<f64>> = forms[..n_h].iter().map(|form| values(&form.entries)).collect();
    rows.push(values(&forms[row].entries));
    let mut motions = null_space(rows.clone());
    if motions.len() < 3 {
        rows.pop();
        motions = null_space(rows);
    }
    let slopes: Vec<Vec<f64>> = forms[row].slopes.iter().map(|slopes| values(slopes)).collect();
    let size = slopes.iter().flatten().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let curl = |x: &[f64], y: &[f64]| {
        let n = slopes.len();
        (0..n)
            .flat_map(|i| (0..n).map(move |j| (i, j)))
            .map(|(i, j)| (slopes[j][i] - slopes[i][j]) * x[i] * y[j])
            .sum::<f64>()
    };
    let pairs = motions.iter().enumerate().flat_map(|(i, x)| motions[..i].iter().map(move |y| (x, y)));
    motions.len() > 2 && pairs.into_iter().all(|(x, y)| curl(x, y).abs() <= CLOSED * size.max(f64::MIN_POSITIVE))
}

/// Motions that all rows allow, each with largest entry one.
fn null_space(mut rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = rows.first().map_or(0, Vec::len);
    let mut pivots: Vec<usize> = Vec::new();
    let mut rank = 0;
    while rank < rows.len() {
        let entries = (rank..rows.len()).flat_map(|i| (0..n).map(move |j| (i, j)));
        let size = |&(i, j): &(usize, usize)| rows[i][j].abs();
        let Some((i, j)) = entries.max_by(|a, b| size(a).total_cmp(&size(b))).filter(|at| size(at) > DEPENDENT) else {
            break;
        };
        rows.swap(rank, i);
        let pivot = rows[rank].clone();
        for (other, row) in rows.iter_mut().enumerate() {
            if other != rank {
                let factor = row[j] / pivot[j];
                row.iter_mut().zip(&pivot).for_each(|(x, y)| *x -= factor * y);
            }
        }
        pivots.push(j);
        rank += 1;
    }
    let free = (0..n).filter(|j| !pivots.contains(j));
    let motion = |free: usize| {
        let mut motion = vec![0.0; n];
        motion[free] = 1.0;
        for (row, &pivot) in rows.iter().zip(&pivots) {
            motion[pivot] = -row[free] / row[pivot];
        }
        let largest = motion.iter().fold(1.0, |largest: f64, x| largest.max(x.abs()));
        motion.iter_mut().for_each(|x| *x /= largest);
        motion
    };
    free.map(motion).collect()
}
