//! Rows of numbers brought to echelon form one by one, in their order, without zeros.

use std::collections::{BTreeMap, BTreeSet};

use crate::work;

/// A row by column; columns that are not there hold zero.
pub type Row = BTreeMap<usize, f64>;

/// Rows so far that are independent of those before them.
#[derive(Default)]
pub struct Basis {
    rows: Vec<Reduced>,
    /// Places in `rows` by pivot column.
    by_column: BTreeMap<usize, usize>,
}

/// What rows before it leave of a row.
pub struct Reduced {
    row: Row,
    /// Its largest column, the first of several, and what it holds.
    column: usize,
    pivot: f64,
    /// Rows of the basis that were subtracted, with their factors.
    factors: Vec<(usize, f64)>,
}

impl Reduced {
    /// Size of its largest entry.
    pub fn size(&self) -> f64 {
        self.pivot.abs()
    }
}

/// The largest entry in size, the first of several.
pub fn largest(row: &Row) -> (usize, f64) {
    row.iter().fold((0, 0.0), |best, (&column, &x)| if x.abs() > f64::abs(best.1) { (column, x) } else { best })
}

impl Basis {
    /// Subtracts the rows of the basis.
    pub fn reduce(&self, mut row: Row) -> Reduced {
        let place = |column: &usize| self.by_column.get(column).copied();
        let mut waiting: BTreeSet<usize> = row.keys().filter_map(place).collect();
        let mut factors = Vec::new();
        while let Some(next) = waiting.pop_first() {
            let of = &self.rows[next];
            let factor = row.get(&of.column).map_or(0.0, |x| x / of.pivot);
            if factor == 0.0 {
                continue;
            }
            work::count(of.row.len());
            for (&column, &x) in &of.row {
                *row.entry(column).or_insert(0.0) -= factor * x;
                waiting.extend(place(&column).filter(|&other| other > next));
            }
            row.remove(&of.column);
            factors.push((next, factor));
        }
        let (column, pivot) = largest(&row);
        Reduced { row, column, pivot, factors }
    }

    /// Takes a row in.
    pub fn push(&mut self, reduced: Reduced) {
        self.by_column.insert(reduced.column, self.rows.len());
        self.rows.push(reduced);
    }

    /// The rows of the basis as they were taken in that a reduced row combines, with their factors.
    pub fn combination(&self, reduced: &Reduced) -> Vec<(usize, f64)> {
        let mut weights = vec![0.0; self.rows.len()];
        reduced.factors.iter().for_each(|&(place, factor)| weights[place] = factor);
        for place in (0..weights.len()).rev() {
            for &(other, factor) in &self.rows[place].factors {
                weights[other] -= weights[place] * factor;
            }
        }
        weights.into_iter().enumerate().collect()
    }

    /// Each coordinate of the vectors that every row takes to zero, as a combination of the free ones.
    pub fn null_space(&self, n_columns: usize) -> Vec<Row> {
        let mut space: Vec<Row> = (0..n_columns).map(|column| Row::from([(column, 1.0)])).collect();
        for of in self.rows.iter().rev() {
            let mut combination = Row::new();
            for (&column, x) in of.row.iter().filter(|(column, _)| **column != of.column) {
                work::count(space[column].len());
                for (&free, y) in &space[column] {
                    *combination.entry(free).or_insert(0.0) -= x / of.pivot * y;
                }
            }
            space[of.column] = combination;
        }
        space
    }
}
