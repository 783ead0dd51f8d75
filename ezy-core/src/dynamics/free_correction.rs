//! Corrections of a start: given values stay, the others take the residual away.

use super::System;
use super::assembly::Assembly;
use super::factors::Solver;
use super::max_abs;
use super::system::sparse;
use super::tolerances::start::{DAMPING, FOLLOWED, LARGEST_DENSE_START, RANK_TOLERANCE};
use crate::linalg::{HAS_SPARSE, singular_values, weights, write_diagonal};
use crate::model::SceneRef;
use nalgebra::{DMatrix, DVector};

impl<P: SceneRef> Assembly<'_, P> {
    /// Change of the velocities (or, in their axes, of the coordinates) that are not given, smallest in the mass matrix, that removes the
    /// residual of the first `n_rows` rows in the buffer to first order, in the least-squares sense.
    pub(super) fn free_correction(&mut self, t: f64, q: &[f64], n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        let System { scene, fixed, factors, residual, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        let finite = residual[..n_rows].iter().chain(jacobian).all(|x| x.is_finite());
        if !finite || n_rows == 0 || given.iter().all(|given| *given) {
            return None;
        }
        if self.starts_sparse() { self.sparse_correction(n_rows, given) } else { self.dense_correction(n_rows, given) }
    }

    /// First-order change of what is not given that follows when something else changes the residual of the first rows, as
    /// many as `residual` has, by `residual`; smallest in the mass matrix. Zero where nothing is free.
    pub(crate) fn free_tangent(&mut self, t: f64, q: &[f64], residual: &[f64], given: &[bool]) -> Vec<f64> {
        self.system.residual[..residual.len()].copy_from_slice(residual);
        self.free_correction(t, q, residual.len(), given).unwrap_or_else(|| vec![0.0; given.len()])
    }

    /// What follows in the same way of what the first of `given` leaves free, and what that cannot take away of what the next one does. None where
    /// something is left.
    pub(super) fn following(&mut self, t: f64, q: &[f64], residual: &[f64], given: &[Vec<bool>]) -> Option<Vec<f64>> {
        let (rounding, largest) = (f64::EPSILON * max_abs(residual), FOLLOWED * max_abs(residual));
        let (mut tangent, mut left) = (vec![0.0; self.system.info.n_velocities()], residual.to_vec());
        // the second pass takes what the damping of sparse corrections leaves
        for given in given.iter().flat_map(|given| [given; 2]) {
            if max_abs(&left) <= rounding {
                break;
            }
            let change = self.free_tangent(t, q, &left, given);
            self.add_change(t, q, &change, &mut left);
            tangent.iter_mut().zip(&change).for_each(|(tangent, change)| *tangent += change);
        }
        (max_abs(&left) <= largest).then_some(tangent)
    }

    /// Adds to the residual of the first rows, as many as `residual` has, what a change of the state makes of it: G times that.
    pub(super) fn add_change(&mut self, t: f64, q: &[f64], change: &[f64], residual: &mut [f64]) {
        let System { scene, info, fixed, factors, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        let n_rows = residual.len();
        for (k, row, column) in info.jacobian.entries().filter(|entry| entry.1 < n_rows) {
            residual[row] += jacobian[k] * change[column];
        }
    }

    pub(super) fn starts_sparse(&self) -> bool {
        HAS_SPARSE && self.system.info.n_velocities() > LARGEST_DENSE_START
    }

    /// By `[W Gᵀ; G −D] [δ; μ] = [0; −r]`, with D a small share of `G W⁻¹ Gᵀ`: what is given has no entries in G, and rows beyond the first
    /// `n_rows` have none either. Where the system has sparse factors, which need positive masses, these are made anew for it.
    fn sparse_correction(&mut self, n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        let System { info, mass, solver, factors, residual, .. } = &mut *self.system;
        let weight = weights(mass);
        let mut own;
        let kkt = match solver {
            Solver::Sparse(kkt) => kkt.as_mut(),
            Solver::Dense | Solver::Generated => {
                own = sparse(info, &weight).ok()?;
                own.as_mut()
            }
        };
        let (n_v, n_c) = (info.n_velocities(), info.n_rows());
        let is_left_out = |row: usize, column: usize| row >= n_rows || given[column];
        factors.forget();
        let jacobian = &mut factors.jacobian;
        info.jacobian.entries().filter(|e| is_left_out(e.1, e.2)).for_each(|(k, ..)| jacobian[k] = 0.0);
        let mut damping = vec![0.0; n_c];
        write_diagonal(info.jacobian.entries(), &weight, jacobian, &mut damping);
        damping.iter_mut().for_each(|d| *d *= DAMPING);
        kkt.factor_damped(jacobian, &damping).ok()?;
        let (mut delta, mut rows) = (vec![0.0; n_v], vec![0.0; n_c]);
        rows.iter_mut().zip(&residual[..n_rows]).for_each(|(s, r)| *s = -r);
        kkt.solve(&mut delta, &mut rows);
        Some(delta)
    }

    /// By singular values over the free coordinates, rows in units of their sizes. What has mass takes away what massless
    /// coordinates cannot, as little as possible in the mass matrix; these take the rest.
    fn dense_correction(&self, n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        let sizes = &self.system.geometry.sizes;
        let unit = |column: usize| match (self.system.mass[column] > 0.0, self.system.geometry.turns[column]) {
            (true, _) => self.system.mass[column].sqrt(),
            (false, true) => self.system.geometry.length,
            (false, false) => 1.0,
        };
        let free = (0..given.len()).filter(|&i| !given[i]);
        let (heavy, massless): (Vec<usize>, Vec<usize>) = free.partition(|&i| self.system.mass[i] > 0.0);
        let slopes = |columns: &[usize]| {
            let mut G = DMatrix::<f64>::zeros(n_rows, columns.len());
            for (k, row, column) in self.system.info.jacobian.entries().filter(|e| e.1 < n_rows) {
                if let Ok(i) = columns.binary_search(&column) {
                    G[(row, i)] += self.system.factors.jacobian[k] / unit(column) / sizes[row];
                }
            }
            G
        };
        let rows = self.system.residual[..n_rows].iter().zip(sizes);
        let mut residual = DVector::from_iterator(n_rows, rows.map(|(r, size)| r / size));
        let (mut G, G_massless) = (slopes(&heavy), slopes(&massless));
        let mut step = vec![0.0; given.len()];
        let mut assign = |columns: &[usize], x: &DVector<f64>| {
            columns.iter().zip(x.iter()).for_each(|(&column, x)| step[column] = -x / unit(column));
        };
        if massless.is_empty() {
            assign(&heavy, &least_norm(G, &residual)?);
            return Some(step);
        }
        let full = G.clone();
        let reached = range(G_massless.clone())?;
        G -= &reached * reached.tr_mul(&G);
        let beyond = &residual - &reached * reached.tr_mul(&residual);
        if !heavy.is_empty() {
            let x = least_norm(G, &beyond)?;
            residual -= full * &x;
            assign(&heavy, &x);
        }
        assign(&massless, &least_norm(G_massless, &residual)?);
        Some(step)
    }
}

/// Shortest x that brings G x closest to `r`.
fn least_norm(G: DMatrix<f64>, r: &DVector<f64>) -> Option<DVector<f64>> {
    let svd = singular_values(G, true, true)?;
    let cutoff = cutoff(&svd.singular_values);
    svd.solve(r, cutoff).ok()
}

/// Orthonormal columns that span what G reaches.
fn range(G: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let svd = singular_values(G, true, false)?;
    let cutoff = cutoff(&svd.singular_values);
    let columns: Vec<usize> = (0..svd.singular_values.len()).filter(|&i| svd.singular_values[i] > cutoff).collect();
    Some(svd.u?.select_columns(&columns))
}

fn cutoff(singular_values: &DVector<f64>) -> f64 {
    (RANK_TOLERANCE * singular_values.max()).max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A stone that nothing holds.
        pub model Stone {
            body stone { mass: 2, inertia: 1 }
            start high { stone at (0, 5) angle 0; at rest; }
            scene falls { start high; until 1 s; }
        }
    }

    #[test]
    fn analytic_nothing_follows_where_there_are_no_rows() {
        let scene = stone::Falls::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        assert_eq!(system.assembly().free_tangent(0.0, &[0.0, 5.0, 0.0], &[], &[true, true, false]), [0.0; 3]);
    }
}
