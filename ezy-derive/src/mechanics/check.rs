//! Rules that need the equations: empty constraints, redundant ones, more constraint equations than coordinates, velocity
//! constraints that are not linear in velocities or that are integrable.
//!
//! Dependence is decided at random states with random parameters, so that a finding holds for all of them.

use super::scene::Equations;
use super::symbols::{Meaning, Symbols};
use crate::diag::{Diagnostics, equations as message};
use crate::model::{Model, RowId, Scene};
use crate::symbolic::evaluate::Point;
use crate::symbolic::{Algebra, SumId, Symbol};

mod assembled;
mod basis;
mod integrable;
mod overfixed;
#[cfg(test)]
mod tests;
mod welded;

use basis::{Basis, Row, largest};

/// Random states at which rows are compared.
const SAMPLES: u64 = 3;

/// A row is dependent when elimination reduces it below this part: rounding leaves 1e-15, random independent rows keep 1e-3.
const DEPENDENT: f64 = 1e-9;

/// Longest sum that is accepted: longer ones take minutes to plan and to compile. A rod has thirty terms.
pub const LONGEST_SUM: usize = 2000;

/// Reports faulty rows of the scenes of a model at the words that declare them, each once. Works on equations of its
/// own: what it writes down must not change the order of what is emitted.
///
/// In a model with arrays every reference to a member counts as a body of its own, so that only faults are found which
/// do not depend on the counts.
pub fn rows(model: &Model, diag: &mut Diagnostics) {
    welded::wheels(model, diag);
    let mut reported = Vec::new();
    let mut seen: Vec<Vec<RowId>> = Vec::new();
    let mut starts = Vec::new();
    for scene in &model.scenes {
        let selected: Vec<RowId> = model.rows_of(scene).map(|(id, _)| id).collect();
        let (known_rows, known_start) = (seen.contains(&selected), starts.contains(&(selected.clone(), scene.start)));
        if known_start {
            continue;
        }
        let mut equations = Equations::derive(model, scene);
        // a stop is open wherever rows are compared
        if let Some(stop) = equations.constraints.rows.iter().position(|row| row.kind == "stop") {
            equations.constraints.remove_position_row(stop);
        }
        starts.push((selected.clone(), scene.start));
        let n_errors = diag.n_errors();
        if !known_rows {
            seen.push(selected);
            rows_of_scene(model, &mut equations, &mut reported, diag);
            if diag.n_errors() == n_errors {
                integrable::rows(model, &mut equations, &mut reported, diag);
            }
        }
        if diag.n_errors() == n_errors {
            overfixed::start(model, scene, &mut equations, diag);
        }
    }
}

/// Reports stops that are too long as the row that they become.
pub fn stops(model: &Model, diag: &mut Diagnostics) {
    for stop in &model.stops {
        let uses = |scene: &&Scene| model.stop_of(scene).is_some_and(|of| std::ptr::eq(of, stop));
        let Some(scene) = model.scenes.iter().find(uses) else { continue };
        let equations = Equations::derive(model, scene);
        let constraints = &equations.constraints;
        let rows = constraints.rows.iter().zip(&constraints.convective).filter(|(row, _)| row.kind == "stop");
        let n_terms = rows.map(|(_, &sum)| equations.algebra.terms(sum).len()).max().unwrap_or_default();
        if n_terms > LONGEST_SUM {
            diag.error(message::too_long(&stop.name, &format!("stop `{}`", stop.name), n_terms, LONGEST_SUM));
        }
    }
}

fn rows_of_scene(model: &Model, equations: &mut Equations, reported: &mut Vec<usize>, diag: &mut Diagnostics) {
    let n_errors = diag.n_errors();
    let constraints = &equations.constraints;
    let (n_q, n_c) = (equations.mass.len(), constraints.rows.len());
    for (i, row) in constraints.rows.iter().enumerate() {
        if reported.contains(&row.family) {
            continue;
        }
        let name = &model.rows[row.family].name;
        let n_terms = equations.algebra.terms(constraints.convective[i]).len();
        if n_terms > LONGEST_SUM {
            diag.error(message::too_long(name, &format!("constraint `{}`", row.name), n_terms, LONGEST_SUM));
            reported.push(row.family);
            continue;
        }
        let mut entries = constraints.jacobian[i].iter().map(|&(_, entry)| entry);
        if constraints.jacobian[i].is_empty() {
            diag.error(message::restricts_nothing(name, &row.name));
            reported.push(row.family);
        } else if entries.any(|entry| moves_with_velocity(&mut equations.algebra, &equations.symbols, entry)) {
            diag.error(message::not_linear(name, row.kind, &row.name));
            reported.push(row.family);
        }
    }
    if n_c > n_q {
        // at random states, which do not satisfy them, such rows are dependent in any case
        diag.warning(message::more_rows_than_coordinates(&model.name, n_c, n_q));
    }
    if n_c > n_q || diag.n_errors() > n_errors {
        return;
    }
    let constraints = &equations.constraints;
    let found: Vec<Vec<(usize, Vec<usize>)>> = (0..SAMPLES)
        .map(|seed| dependent_rows(equations, &RandomState { symbols: &equations.symbols, seed }))
        .collect();
    for (i, others) in &found[0] {
        let family = constraints.rows[*i].family;
        let always = found.iter().all(|sample| sample.iter().any(|(row, _)| row == i));
        if always && !reported.contains(&family) {
            let names: Vec<&str> = others.iter().map(|&row| constraints.rows[row].name.as_str()).collect();
            diag.error(message::dependent(&model.rows[family].name, &constraints.rows[*i].name, &names));
            reported.push(family);
        }
    }
    if diag.n_errors() == n_errors && model.counts.is_empty() {
        assembled::rows(model, equations, reported, diag);
    }
}

fn moves_with_velocity(algebra: &mut Algebra, symbols: &Symbols, entry: SumId) -> bool {
    let mut velocities = algebra.symbols_of(entry).into_iter().filter(|&symbol| symbols.velocity_of(symbol).is_some());
    velocities.any(|velocity| !algebra.diff(entry, velocity).is_zero())
}

/// Rows that are combinations of earlier ones, with the rows they combine.
fn dependent_rows(equations: &Equations, state: &impl Point) -> Vec<(usize, Vec<usize>)> {
    let value = |entry: SumId| equations.algebra.evaluate(entry, state);
    let row = |entries: &Vec<(usize, SumId)>| entries.iter().map(|&(column, entry)| (column, value(entry))).collect();
    let mut rows: Vec<Row> = equations.constraints.jacobian.iter().map(row).collect();
    scale_columns(&mut rows);
    let (mut basis, mut taken) = (Basis::default(), Vec::new());
    let mut dependent = Vec::new();
    for (i, row) in rows.into_iter().enumerate() {
        let size = largest(&row).1.abs();
        let reduced = basis.reduce(row);
        if reduced.size() <= DEPENDENT * size {
            let others = basis.combination(&reduced).into_iter().filter(|(_, factor)| factor.abs() > DEPENDENT);
            dependent.push((i, others.map(|(place, _)| taken[place]).collect()));
            continue;
        }
        basis.push(reduced);
        taken.push(i);
    }
    dependent
}

/// Scales the largest entry of each column to one, so that long lever arms do not hide short ones.
fn scale_columns(rows: &mut [Row]) {
    let mut sizes = Row::new();
    for (&column, x) in rows.iter().flatten() {
        let size = sizes.entry(column).or_insert(0.0);
        *size = x.abs().max(*size);
    }
    for (column, x) in rows.iter_mut().flatten() {
        if sizes[column] > 0.0 {
            *x /= sizes[column];
        }
    }
}

/// A generic state.
struct RandomState<'a> {
    symbols: &'a Symbols,
    seed: u64,
}

impl Point for RandomState<'_> {
    fn symbol(&self, symbol: Symbol) -> f64 {
        let offset = match self.symbols.meaning(symbol) {
            Meaning::Time => 0.1,
            _ => -1.5,
        };
        offset + 3.0 * fraction(self.seed, u64::from(symbol.0))
    }

    fn parameter(&self, index: usize) -> f64 {
        0.5 + fraction(self.seed, 1_000_003 + index as u64)
    }
}

/// A number in [0, 1) that repeats (SplitMix64, Steele, Lea, Flood 2014).
fn fraction(seed: u64, index: u64) -> f64 {
    let mut z = (seed + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ index.wrapping_mul(0xd134_2543_de82_ef95);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 / (1_u64 << 53) as f64
}
