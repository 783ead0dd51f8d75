//! The lower triangle of K in compressed columns.

/// Compressed columns, sorted, with a place on the diagonal of each row of G. Entries of G at one place share it.
pub(super) struct LowerTriangle {
    pub column_starts: Vec<usize>,
    pub row_indices: Vec<usize>,
    /// Where each mass stands among the values.
    pub mass_places: Vec<usize>,
    /// Where each entry of G stands.
    pub jacobian_places: Vec<usize>,
    /// Where the diagonal of each row of G stands.
    pub row_places: Vec<usize>,
}

impl LowerTriangle {
    /// From the (row, column) of each entry of G, in any order.
    pub(super) fn new(n_q: usize, n_rows: usize, entries: &[(usize, usize)]) -> Self {
        let mut by_column = vec![Vec::new(); n_q];
        for (k, &(row, column)) in entries.iter().enumerate() {
            by_column[column].push((row, k));
        }
        let (mut column_starts, mut row_indices) = (vec![0], Vec::new());
        let mut mass_places = Vec::with_capacity(n_q);
        let mut jacobian_places = vec![0; entries.len()];
        for (column, list) in by_column.iter_mut().enumerate() {
            list.sort_unstable();
            mass_places.push(row_indices.len());
            row_indices.push(column);
            let mut last = None;
            for &(row, k) in &*list {
                if last != Some(row) {
                    row_indices.push(n_q + row);
                    last = Some(row);
                }
                jacobian_places[k] = row_indices.len() - 1;
            }
            column_starts.push(row_indices.len());
        }
        let mut row_places = Vec::with_capacity(n_rows);
        for row in 0..n_rows {
            row_places.push(row_indices.len());
            row_indices.push(n_q + row);
            column_starts.push(row_indices.len());
        }
        Self { column_starts, row_indices, mass_places, jacobian_places, row_places }
    }
}
