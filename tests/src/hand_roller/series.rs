//! The Taylor series of the EzyRoller, worked out by hand, in any numbers.
//!
//! Products of body i (`s`, `c` of its angle φ, wheel multiplier μ, hinge multipliers λ₁, λ₂), in this order: s·φ, c·φ, s·x,
//! c·y, s·μ, c·μ, s·λ₁, c·λ₂. Right factors hold m x_m of a coordinate in row m, and a multiplier of order k in row k + 2.

use super::schur::N_FACTORS;
use super::{HandRoller, schur, trig};
use ezy_core::__private::{Pivots, Series, SeriesSize, SeriesStore};
use ezy_core::scalar::Scalar;

/// Products of one body.
const N: usize = 8;
/// The base: s₁, c₁, s₂, c₂, then the factors of G M⁻¹ Gᵀ.
const FACTORS: usize = 4;

fn n<T: Scalar>(x: f64) -> T {
    T::from_f64(x)
}

/// Row `k` of q and everything that follows from it: factors of row `k`, given sines and cosines of that order.
fn write_factors<T: Scalar>(store: &mut SeriesStore<T>, k: usize, trig: [T; 4]) {
    let m = n::<T>(k as f64);
    for body in 0..2 {
        let (s, c) = (trig[2 * body], trig[2 * body + 1]);
        let q = &store.q[6 * k + 3 * body..][..3];
        let at = 2 * N * k + N * body;
        store.left[at..at + N].copy_from_slice(&[s, c, s, c, s, c, s, c]);
        store.right[at..at + 4].copy_from_slice(&[m * q[2], m * q[2], m * q[0], m * q[1]]);
    }
}

impl<T: Scalar> Series<T> for HandRoller {
    fn series_size(&self) -> SeriesSize {
        SeriesSize { n_coordinates: 6, n_rows: 4, n_products: 2 * N, n_base: FACTORS + N_FACTORS, n_kept: 1 }
    }

    fn begin(&self, p: &[T], t: T, store: &mut SeriesStore<T>) -> Pivots {
        let [s1, c1, s2, c2] = trig(&store.q);
        store.base[..FACTORS].copy_from_slice(&[s1, c1, s2, c2]);
        let (w1, w2) = (store.q[8], store.q[11]);
        write_factors(store, 1, [c1 * w1, -s1 * w1, c2 * w2, -s2 * w2]);
        // a multiplier of order −1
        for row in store.right[2 * N..4 * N].chunks_exact_mut(N) {
            row[4..].fill(n(0.0));
        }
        if self.driven {
            let (sin, cos) = (p[9] * t).sin_cos();
            store.kept[0] = p[8] * cos;
            store.kept[1] = -p[8] * p[9] * sin;
        } else {
            store.kept[..2].fill(n(0.0));
        }
        store.force.fill(n(0.0));
        store.force[2] = store.kept[0];
        store.force[5] = -store.kept[0];
        let (b, d) = (p[1], p[3]);
        let (x1, y1, x2, y2) = (store.q[6], store.q[7], store.q[9], store.q[10]);
        store.row.copy_from_slice(&[
            b * c1 * w1 * w1 + d * c2 * w2 * w2,
            b * s1 * w1 * w1 + d * s2 * w2 * w2,
            (x1 * c1 + y1 * s1) * w1,
            (x2 * c2 + y2 * s2) * w2,
        ]);
        schur(p, &store.base).factor(&mut store.base[FACTORS..])
    }

    fn right_side(&self, p: &[T], k: usize, store: &mut SeriesStore<T>) {
        if self.driven && k >= 2 {
            store.kept[k] = -p[9] * p[9] * store.kept[k - 2] / n((k * (k - 1)) as f64);
        }
        let torque = if self.driven { store.kept[k] } else { n(0.0) };
        let (one, two) = store.sums.split_at(N);
        let (b, d) = (p[1], p[3]);
        store.force[0] = one[4];
        store.force[1] = -one[5];
        store.force[2] = torque + b * (one[6] - one[7]);
        store.force[3] = two[4];
        store.force[4] = -two[5];
        store.force[5] = -torque + d * (two[6] - two[7]);
        let m = n::<T>((k + 1) as f64);
        store.row.copy_from_slice(&[
            m * (b * one[0] + d * two[0]),
            -m * (b * one[1] + d * two[1]),
            m * (one[2] - one[3]),
            m * (two[2] - two[3]),
        ]);
    }

    fn solve(&self, p: &[T], k: usize, store: &mut SeriesStore<T>) {
        let SeriesStore { base, force, row, a, lambda, .. } = store;
        schur(p, base).solve(&base[FACTORS..], force, row, a, &mut lambda[4 * k..][..4]);
    }

    fn finish(&self, _p: &[T], k: usize, store: &mut SeriesStore<T>) {
        let order = k + 2;
        let share = n::<T>((order * (order - 1)) as f64);
        for j in 0..6 {
            store.q[6 * order + j] = store.a[j] / share;
        }
        let m = n::<T>(order as f64);
        let trig = |body: usize, store: &SeriesStore<T>| {
            let (s, c) = (store.base[2 * body], store.base[2 * body + 1]);
            let (sums, phi) = (&store.sums[N * body..], store.q[6 * order + 3 * body + 2]);
            (sums[1] / m + c * phi, -sums[0] / m - s * phi)
        };
        let ((s1, c1), (s2, c2)) = (trig(0, store), trig(1, store));
        write_factors(store, order, [s1, c1, s2, c2]);
        let lambda = &store.lambda[4 * k..][..4];
        for body in 0..2 {
            let wheel = lambda[2 + body];
            let right = &mut store.right[2 * N * order + N * body..][..N];
            right[4..].copy_from_slice(&[wheel, wheel, lambda[0], lambda[1]]);
        }
    }
}
