//! Where the coordinates of a planar body stand in q, and which of them are angles: asked here and nowhere else. Bodies of all kinds:
//! `body_kind.rs`.

use super::BodyKind;
use crate::scalar::Scalar;

/// A planar body has x, y and φ, which stand together.
pub const N_OF_BODY: usize = BodyKind::Planar.positions().len();

/// How many bodies have `n_q` coordinates.
pub const fn n_bodies(n_q: usize) -> usize {
    n_q / N_OF_BODY
}

/// What stands at x, y and φ of a body, in q or in what is ordered as q is.
pub fn of_body(q: &[f64], body: usize) -> [f64; N_OF_BODY] {
    std::array::from_fn(|component| q[place(body, component)])
}

/// Place in q of a coordinate of a body: 0 for x, 1 for y, 2 for φ.
pub const fn place(body: usize, component: usize) -> usize {
    N_OF_BODY * body + component
}

/// The body of a coordinate, and which of its coordinates that is.
pub const fn body_and_component(coordinate: usize) -> (usize, usize) {
    (coordinate / N_OF_BODY, coordinate % N_OF_BODY)
}

/// Whether a coordinate is an angle; the others are lengths.
pub const fn is_angle(coordinate: usize) -> bool {
    body_and_component(coordinate).1 == 2
}

/// [sin φ, cos φ] of each planar body.
pub fn sines<T: Scalar>(q: &[T]) -> Vec<[T; 2]> {
    let angles: Vec<T> = q.as_chunks::<N_OF_BODY>().0.iter().map(|[_, _, phi]| *phi).collect();
    let mut table = vec![[T::from_f64(0.0); 2]; angles.len()];
    T::sin_cos_of_each(&angles, &mut table);
    table
}
