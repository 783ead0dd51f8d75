//! Where the coordinates of a planar body stand in q, and which of them are angles: asked here and nowhere else. Bodies of all kinds:
//! `body_kind.rs`.

use super::BodyKind;
use crate::scalar::Scalar;

/// A planar body has x, y and φ, which stand together.
pub(crate) const N_OF_BODY: usize = BodyKind::Planar.positions().len();

/// How many bodies have `n_q` coordinates.
pub(crate) const fn n_bodies(n_q: usize) -> usize {
    n_q / N_OF_BODY
}

/// What stands at x, y and φ of a body, in q or in what is ordered as q is.
pub(crate) fn of_body(q: &[f64], body: usize) -> [f64; N_OF_BODY] {
    std::array::from_fn(|component| q[place(body, component)])
}

/// Place in q of a coordinate of a body: 0 for x, 1 for y, 2 for φ.
pub(crate) const fn place(body: usize, component: usize) -> usize {
    N_OF_BODY * body + component
}

/// The body of a coordinate, and which of its coordinates that is.
pub(crate) const fn body_and_component(coordinate: usize) -> (usize, usize) {
    (coordinate / N_OF_BODY, coordinate % N_OF_BODY)
}

/// Whether a coordinate is an angle; the others are lengths.
pub(crate) const fn is_angle(coordinate: usize) -> bool {
    body_and_component(coordinate).1 == 2
}

/// [sin φ, cos φ] of each planar body.
pub fn sines<T: Scalar>(q: &[T]) -> Vec<[T; 2]> {
    let mut table = vec![[T::from_f64(0.0); 2]; n_bodies(q.len())];
    write_sines(q, &mut table);
    table
}

/// Writes [sin φ, cos φ] of each planar body.
#[inline(always)]
pub(crate) fn write_sines<T: Scalar>(q: &[T], table: &mut [[T; 2]]) {
    let bodies = q.as_chunks::<N_OF_BODY>().0;
    for (bodies, table) in bodies.chunks(8).zip(table.chunks_mut(8)) {
        let angles = std::array::from_fn(|i| bodies.get(i).map_or(T::from_f64(0.0), |[_, _, phi]| *phi));
        table.copy_from_slice(&T::sin_cos_of_eight(&angles)[..table.len()]);
    }
}
