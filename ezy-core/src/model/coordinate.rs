//! Where the coordinates of a body stand in q, and which of them are angles: asked here and nowhere else.

/// Every body has x, y and φ, which stand together.
pub(crate) const N_OF_BODY: usize = 3;

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
