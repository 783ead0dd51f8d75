//! In which order the sparse factorisation takes coordinates and rows.

use super::SparseKktError;
use super::tolerances::sizes::{HUB_ROWS, MAX_PAIRS};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMat;
use faer::sparse::linalg::amd;

/// A permutation of the `n_q + n_c` unknowns.
pub(super) struct Order {
    /// Unknown at each position.
    pub forward: Vec<usize>,
    /// Position of each unknown.
    pub inverse: Vec<usize>,
    /// Whether columns with many rows stand after these rows.
    pub hubs_last: bool,
}

/// Every coordinate before the rows that touch it, as late as possible; rows by minimum degree of the graph in which
/// two rows are neighbours when they share a coordinate. For a tree of bodies the fill is that of the joints which
/// meet at one body.
///
/// With `hubs_last`, coordinates in many rows come after these rows, as long as each row keeps another coordinate.
///
/// # Errors
/// [`SparseKktError`] when the graph is too large or the analysis fails.
pub(super) fn bodies_before_rows(
    n_q: usize,
    n_rows: usize,
    entries: &[(usize, usize)],
    hubs_last: bool,
) -> Result<Order, SparseKktError> {
    let n = n_q + n_rows;
    let mut rows_of = vec![Vec::new(); n_q];
    let mut columns_of = vec![Vec::new(); n_rows];
    for &(row, column) in entries {
        if rows_of[column].last() != Some(&row) {
            rows_of[column].push(row);
        }
        columns_of[row].push(column);
    }
    let late: Vec<bool> = rows_of.iter().map(|rows| hubs_last && rows.len() > HUB_ROWS).collect();
    let pairs: usize = (0..n_q).filter(|&i| !late[i]).map(|i| rows_of[i].len() * rows_of[i].len()).sum();
    if pairs > MAX_PAIRS {
        return Err(SparseKktError { n, cause: format!("{pairs} pairs of rows share a coordinate") });
    }
    let rows = minimum_degree(n_rows, (0..n_q).filter(|&i| !late[i]).map(|i| &rows_of[i][..]))
        .map_err(|cause| SparseKktError { n, cause })?;
    let only_hubs = |row: usize| columns_of[row].iter().all(|&column| late[column]);
    let (last_rows, first_rows): (Vec<usize>, Vec<usize>) = rows.into_iter().partition(|&row| only_hubs(row));

    let mut forward = Vec::with_capacity(n);
    let mut placed = late.clone();
    for row in first_rows {
        for &column in &columns_of[row] {
            if !std::mem::replace(&mut placed[column], true) {
                forward.push(column);
            }
        }
        forward.push(n_q + row);
    }
    forward.extend((0..n_q).filter(|&i| !placed[i] || late[i]));
    forward.extend(last_rows.iter().map(|row| n_q + row));
    let mut inverse = vec![0; n];
    for (position, &i) in forward.iter().enumerate() {
        inverse[i] = position;
    }
    Ok(Order { forward, inverse, hubs_last: late.contains(&true) })
}

/// Order of the rows; each clique holds rows that are neighbours of each other.
pub(super) fn minimum_degree<'c>(n: usize, cliques: impl Iterator<Item = &'c [usize]>) -> Result<Vec<usize>, String> {
    let mut neighbours = vec![Vec::new(); n];
    for clique in cliques {
        for (i, &row) in clique.iter().enumerate() {
            neighbours[row].extend_from_slice(&clique[i + 1..]);
        }
    }
    let (mut starts, mut indices) = (vec![0], Vec::new());
    for mut list in neighbours {
        list.sort_unstable();
        list.dedup();
        indices.append(&mut list);
        starts.push(indices.len());
    }
    let n_entries = indices.len();
    let graph = SymbolicSparseColMat::new_checked(n, n, starts, None, indices);
    let (mut order, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = MemBuffer::try_new(amd::order_scratch::<usize>(n, n_entries)).map_err(|e| format!("{e:?}"))?;
    let stack = MemStack::new(&mut memory);
    amd::order(&mut order, &mut inverse, graph.as_ref(), amd::Control::default(), stack)
        .map_err(|e| format!("{e:?}"))?;
    Ok(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_a_hub_that_couples_all_rows_is_refused_before_memory_is_full() {
        // 1.6 GB of neighbours
        let n = 20_000;
        let entries: Vec<(usize, usize)> = (0..n).map(|row| (row, 0)).collect();
        let refused = bodies_before_rows(1, n, &entries, false).err().unwrap();
        assert!(refused.cause.starts_with("400000000 pairs of rows"), "{refused}");
        // as long as a body has no more than a few hundred joints nothing is refused
        assert!(bodies_before_rows(1, 2_000, &entries[..2_000], false).is_ok());
    }
}
