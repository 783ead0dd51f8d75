//! First-order states in the storage of a series.

use crate::model::SeriesStore;
use crate::model::series::SeriesSize;
use crate::scalar::Scalar;

/// Where the coefficients of z stand: first among those that are kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct States {
    /// n_z
    n: usize,
    n_kept: usize,
}

impl States {
    pub(super) const fn new(n_z: usize, size: SeriesSize) -> Self {
        Self { n: n_z, n_kept: size.n_kept }
    }

    /// n_z
    pub(super) const fn count(self) -> usize {
        self.n
    }

    /// Order `k` of z.
    pub(super) fn of_order<T>(self, store: &SeriesStore<T>, k: usize) -> &[T] {
        &store.kept[k * self.n_kept..][..self.n]
    }

    /// What z (`n_z`) gains over `s`, from its coefficients up to `order`.
    pub(super) fn increment<T: Scalar>(self, store: &SeriesStore<T>, order: usize, s: T, z: &mut [T]) {
        for (i, z) in z.iter_mut().enumerate() {
            let coefficients = (1..=order).rev().map(|k| store.kept[k * self.n_kept + i]);
            *z = coefficients.fold(T::from_f64(0.0), |sum, x| sum.fused(s, x)) * s;
        }
    }

    /// The derivative of z (`n_z`) after `s`, from its coefficients up to `order`.
    pub(super) fn derivative(self, store: &SeriesStore<f64>, order: usize, s: f64, out: &mut [f64]) {
        for (i, out) in out.iter_mut().enumerate() {
            let terms = (1..=order).rev().map(|k| k as f64 * store.kept[k * self.n_kept + i]);
            *out = terms.fold(0.0, |sum, x| sum * s + x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// z = 2 + 3 s − s² and −1 + s², beside a coefficient that is kept for something else.
    #[test]
    fn analytic_states_are_sums_of_their_coefficients() {
        let size = SeriesSize { n_coordinates: 0, n_rows: 0, n_products: 0, n_base: 0, n_kept: 3 };
        let states = States::new(2, size);
        let mut store = SeriesStore::<f64>::new(size, 2);
        store.kept = vec![2.0, -1.0, 7.0, 3.0, 0.0, 7.0, -1.0, 1.0, 7.0];
        assert_eq!(states.of_order(&store, 1), [3.0, 0.0]);
        let mut z = [9.0; 2];
        states.increment(&store, 2, 0.5, &mut z);
        assert_eq!(z, [1.5 - 0.25, 0.25]);
        states.increment(&store, 1, 0.5, &mut z);
        assert_eq!(z, [1.5, 0.0]);
        states.derivative(&store, 2, 0.5, &mut z);
        assert_eq!(z, [3.0 - 1.0, 1.0]);
    }
}
