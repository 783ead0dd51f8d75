//! Whether a start is assembled in the mode that its near values ask for: why so, in docs/decisions/047.

use super::assembly::Assembly;
use super::error::StartError;
use super::moved::MovedValue;
use super::tolerances::rank::NEARLY_DEPENDENT;
use super::{State, System};
use crate::linalg::{LARGEST_DIAGNOSED, singular_values};
use crate::model::coordinate::is_angle;
use crate::model::{SceneRef, Start};
use nalgebra::DMatrix;

/// As many rows as coordinates that they determine, and no smaller part of them does.
struct Block {
    rows: Vec<usize>,
    coordinates: Vec<usize>,
}

impl<P: SceneRef> Assembly<'_, P> {
    /// Whether the coordinates `found` are in the assembly mode of `guess`, where near values are as given.
    ///
    /// # Errors
    /// [`StartError::OtherAssemblyMode`].
    pub(super) fn check_mode(&mut self, start: &Start, guess: &[f64], found: &State) -> Result<(), StartError> {
        // elbows are those of planar loops
        if self.system.info.n_unknowns() > LARGEST_DIAGNOSED || !self.system.info.is_planar() {
            return Ok(());
        }
        let [asked, reached] = [guess, &found.q].map(|q| {
            let System { scene, fixed, factors, sines, .. } = &mut *self.system;
            factors.jacobian_at(scene, fixed, sines, start.t, q).to_vec()
        });
        let mut of_row = vec![Vec::new(); self.system.info.n_position_rows];
        for (k, row, column) in self.system.info.jacobian.entries().filter(|e| e.1 < self.system.info.n_position_rows) {
            if asked[k] != 0.0 || reached[k] != 0.0 {
                of_row[row].push(column);
            }
        }
        let held = (0..guess.len()).map(|i| start.q_given[i] && !start.q_near[i]).collect();
        let blocks = Partition::new(&of_row, held).blocks(&self.drivers(start, guess, &found.q));
        let is_guessed = |block: &Block| block.coordinates.iter().all(|&i| !is_angle(i) || start.q_near[i]);
        let folded = blocks
            .iter()
            .filter(|block| is_guessed(block) && self.side(block, &asked) * self.side(block, &reached) < 0.0);
        let coordinates = folded.flat_map(|block| &block.coordinates).filter(|&&i| start.q_near[i]);
        let value = |&i: &usize| MovedValue::of(&self.system.info.coordinates[i], start.q[i], found.q[i]);
        let mut values: Vec<MovedValue> = coordinates.map(value).collect();
        if values.is_empty() {
            return Ok(());
        }
        values.sort_by(|a, b| (b.got - b.given).abs().total_cmp(&(a.got - a.given).abs()));
        Err(StartError::OtherAssemblyMode { values })
    }

    /// Coordinates in the order in which they may be taken for drivers: near values that moved least first, angles before lengths;
    /// then what is not given.
    fn drivers(&self, start: &Start, guess: &[f64], found: &[f64]) -> Vec<usize> {
        let moved = |i: usize| (found[i] - guess[i]).abs();
        let mut drivers: Vec<usize> = (0..guess.len()).filter(|&i| start.q_near[i] || !start.q_given[i]).collect();
        // what is not given is a place rather than an angle
        let rank = |i: usize| (!start.q_near[i], is_angle(i) != start.q_near[i]);
        drivers.sort_by(|&i, &j| rank(i).cmp(&rank(j)).then(moved(i).total_cmp(&moved(j))));
        drivers
    }

    /// Sign of the determinant of a block of G; zero where its rows nearly depend on each other.
    fn side(&self, block: &Block, jacobian: &[f64]) -> f64 {
        let n = block.rows.len();
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        for (k, row, column) in self.system.info.jacobian.entries() {
            let place =
                block.rows.iter().position(|&r| r == row).zip(block.coordinates.iter().position(|&c| c == column));
            if let Some(place) = place {
                matrix[place] += jacobian[k] / self.system.geometry.units[column];
            }
        }
        for mut row in matrix.row_iter_mut() {
            let length = row.norm();
            row /= length;
        }
        let Some(svd) = singular_values(matrix.clone(), false, false) else { return 0.0 };
        if svd.singular_values.min() > NEARLY_DEPENDENT { matrix.determinant().signum() } else { 0.0 }
    }
}

/// Which coordinate each row determines.
struct Partition<'a> {
    /// Coordinates that each row reads.
    of_row: &'a [Vec<usize>],
    /// Coordinates that no row determines.
    is_held: Vec<bool>,
    /// The row that determines each coordinate.
    row_of: Vec<Option<usize>>,
}

impl<'a> Partition<'a> {
    /// As many rows as possible with a coordinate each.
    fn new(of_row: &'a [Vec<usize>], is_held: Vec<bool>) -> Self {
        let row_of = vec![None; is_held.len()];
        let mut new = Self { of_row, is_held, row_of };
        for row in 0..of_row.len() {
            new.place(row);
        }
        new
    }

    /// Finds a coordinate for a row, where others may have to take another one (augmenting path).
    fn place(&mut self, row: usize) -> bool {
        let mut is_seen = self.is_held.clone();
        self.place_beside(row, &mut is_seen)
    }

    fn place_beside(&mut self, row: usize, is_seen: &mut [bool]) -> bool {
        let of_row = self.of_row;
        for &column in &of_row[row] {
            if std::mem::replace(&mut is_seen[column], true) {
                continue;
            }
            if self.row_of[column].is_none_or(|other| self.place_beside(other, is_seen)) {
                self.row_of[column] = Some(row);
                return true;
            }
        }
        false
    }

    /// Holds a coordinate if the rows that have one can do without it.
    fn hold(&mut self, column: usize) {
        let row = self.row_of[column].take();
        self.is_held[column] = true;
        if let Some(row) = row
            && !self.place(row)
        {
            self.is_held[column] = false;
            self.row_of[column] = Some(row);
        }
    }

    /// The irreducible square blocks (Dulmage and Mendelsohn) once as many of the `drivers` are held as there is freedom. Rows beyond the
    /// number of coordinates, and what they read, are in no block.
    fn blocks(mut self, drivers: &[usize]) -> Vec<Block> {
        drivers.iter().for_each(|&column| self.hold(column));
        let n_rows = self.of_row.len();
        let mut coordinate_of = vec![None; n_rows];
        for (column, row) in self.row_of.iter().enumerate() {
            if let Some(row) = row {
                coordinate_of[*row] = Some(column);
            }
        }
        let reach: Vec<Vec<bool>> = (0..n_rows).map(|row| self.reached_from(row)).collect();
        let is_beyond = |row: usize| (0..n_rows).any(|other| coordinate_of[other].is_none() && reach[other][row]);
        let mut is_done = vec![false; n_rows];
        let mut blocks = Vec::new();
        for row in 0..n_rows {
            if is_done[row] || is_beyond(row) {
                continue;
            }
            let rows: Vec<usize> = (row..n_rows).filter(|&other| reach[row][other] && reach[other][row]).collect();
            rows.iter().for_each(|&row| is_done[row] = true);
            let coordinates = rows.iter().filter_map(|&row| coordinate_of[row]).collect();
            blocks.push(Block { rows, coordinates });
        }
        blocks
    }

    /// The rows that determine what a row reads, and so on; the row itself, too.
    fn reached_from(&self, row: usize) -> Vec<bool> {
        let mut is_reached = vec![false; self.of_row.len()];
        is_reached[row] = true;
        let mut left = vec![row];
        while let Some(row) = left.pop() {
            for other in self.of_row[row].iter().filter_map(|&column| self.row_of[column]) {
                if !std::mem::replace(&mut is_reached[other], true) {
                    left.push(other);
                }
            }
        }
        is_reached
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::dynamics::tests::linkage;
    use crate::linalg::Backend;

    /// Near values come first, angles before lengths, those that moved least before others; then what is not given, places before angles.
    #[test]
    fn invariant_drivers_are_chosen_among_near_values_that_moved_least() {
        let scene = linkage::Turns::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut start = Start::free(9);
        for i in [2, 3, 5, 7, 8] {
            (start.q_given[i], start.q_near[i]) = (true, i != 2);
        }
        let guess = [0.0; 9];
        let found = [0.5, 0.4, 0.0, 0.3, -0.1, -0.2, 0.6, 0.1, 0.05];
        // near: angles 8 (0.05) and 5 (0.2), lengths 7 (0.1) and 3 (0.3); not given: 4, 1, 0, 6; 2 is given
        assert_eq!(system.assembly().drivers(&start, &guess, &found), [8, 5, 7, 3, 4, 1, 0, 6]);
    }
}
