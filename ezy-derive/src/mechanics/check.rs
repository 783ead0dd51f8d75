//! Rules that need the equations: empty constraints, redundant ones, more constraint equations than coordinates, velocity
//! constraints that are not linear in velocities or that are integrable.
//!
//! Dependence is decided at random states with random parameters, so that a finding holds for all of them.

use super::scene::Equations;
use super::symbols::{Meaning, Symbols};
use crate::diag::{Diagnostics, equations as message};
use crate::model::{Mode, Model, RowId, Scene};
use crate::symbolic::evaluate::Point;
use crate::symbolic::{Algebra, SumId, Symbol};

mod assembled;
mod integrable;
mod overfixed;

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
            overfixed::start(model, scene, &equations, diag);
        }
    }
}

/// Reports stops that are too long as the row that they become.
pub fn stops(model: &Model, diag: &mut Diagnostics) {
    for stop in &model.stops {
        let uses = |scene: &&Scene| model.stop_of(scene).is_some_and(|of| std::ptr::eq(of, stop));
        let Some(scene) = model.scenes.iter().find(uses) else { continue };
        let mode = model.modes_of(scene).into_iter().find(|mode| matches!(mode, Mode::Rests(_)));
        let equations = Equations::derive(model, &Scene { mode, ..scene.clone() });
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
            diag.error(message::too_long(name, &format!("row `{}`", row.name), n_terms, LONGEST_SUM));
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
    (0..symbols.n_coordinates()).any(|i| !algebra.diff(entry, symbols.velocity_at(i)).is_zero())
}

/// Rows that are combinations of earlier ones, with the rows they combine.
fn dependent_rows(equations: &Equations, state: &impl Point) -> Vec<(usize, Vec<usize>)> {
    let constraints = &equations.constraints;
    let n_q = equations.mass.len();
    let mut rows = vec![vec![0.0; n_q]; constraints.rows.len()];
    for (row, entries) in rows.iter_mut().zip(&constraints.jacobian) {
        for &(column, entry) in entries {
            row[column] = equations.algebra.evaluate(entry, state);
        }
    }
    scale_columns(&mut rows);
    let mut basis: Vec<BasisRow> = Vec::new();
    let mut dependent = Vec::new();
    for (i, mut row) in rows.into_iter().enumerate() {
        let size = largest(&row).1;
        let mut used = vec![0.0; i];
        for reduced in &basis {
            let factor = row[reduced.column] / reduced.row[reduced.column];
            row.iter_mut().zip(&reduced.row).for_each(|(x, y)| *x -= factor * y);
            used.iter_mut().zip(&reduced.combination).for_each(|(x, y)| *x += factor * y);
        }
        let (column, left) = largest(&row);
        if left <= DEPENDENT * size {
            let others = (0..i).filter(|&j| f64::abs(used[j]) > DEPENDENT).collect();
            dependent.push((i, others));
            continue;
        }
        let mut combination: Vec<f64> = used.iter().map(|x| -x).collect();
        combination.push(1.0);
        basis.push(BasisRow { row, column, combination });
    }
    dependent
}

/// Scales the largest entry of each column to one, so that long lever arms do not hide short ones.
fn scale_columns(rows: &mut [Vec<f64>]) {
    for column in 0..rows.first().map_or(0, Vec::len) {
        let largest = rows.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
        if largest > 0.0 {
            rows.iter_mut().for_each(|row| row[column] /= largest);
        }
    }
}

/// A row after elimination, its largest column, and which declared rows it combines.
struct BasisRow {
    row: Vec<f64>,
    column: usize,
    combination: Vec<f64>,
}

fn largest(row: &[f64]) -> (usize, f64) {
    let values = row.iter().map(|x| x.abs()).enumerate();
    values.fold((0, 0.0), |best, next| if next.1 > best.1 { next } else { best })
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
