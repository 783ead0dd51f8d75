//! The smallest singular value with a sign, which changes where a matrix is singular.

use nalgebra::DMatrix;

/// From where signs of determinants are seen: a matrix with at least as many rows as columns, whose columns are independent.
pub(super) struct Orientation {
    q: DMatrix<f64>,
    sign: f64,
}

impl Orientation {
    pub(super) fn of(matrix: DMatrix<f64>) -> Self {
        let qr = matrix.qr();
        Self { q: qr.q(), sign: sign_of_diagonal(&qr.r()) }
    }

    /// The smallest singular value of a matrix nearby, with the sign of the determinant beside that of the first one.
    pub(super) fn smallest(&self, matrix: &DMatrix<f64>) -> f64 {
        let qr = self.q.tr_mul(matrix).qr();
        // of an orthogonal matrix the determinant is ±1
        let sign = qr.q().determinant() * sign_of_diagonal(&qr.r()) * self.sign;
        matrix.singular_values().min() * sign.signum()
    }
}

/// The product of the signs.
fn sign_of_diagonal(r: &DMatrix<f64>) -> f64 {
    r.diagonal().iter().map(|x| x.signum()).product()
}
