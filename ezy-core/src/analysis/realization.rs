//! Linear equations with one input and one output: minimal realizations, the matrix of their zeros, their values.

use super::tolerances::transfer::{MAX_SWEEPS, NEGLIGIBLE};
use nalgebra::{Complex, DMatrix, DVector};

/// x' = A x + b u, y = cᵀ x + d u.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Realization {
    pub a: DMatrix<f64>,
    pub b: DVector<f64>,
    pub c: DVector<f64>,
    pub d: f64,
}

/// The zeros of a transfer function: G(s) is `gain` s^−`relative_degree` for large s, and its zeros are the eigenvalues of `matrix`.
pub(super) struct ZeroDynamics {
    pub gain: f64,
    pub relative_degree: usize,
    pub matrix: DMatrix<f64>,
}

impl Realization {
    /// The part that the input moves and the output sees, with A in upper Hessenberg form and b = β e₁.
    ///
    /// # Cost
    /// O(n³): two reductions by reflections.
    ///
    /// # Source
    /// Paige (1981), Properties of numerical algorithms related to computing controllability, for the staircase.
    pub(super) fn minimal(&self) -> Self {
        let (scaled, [of_b, of_c]) = self.scaled();
        let mut minimal = scaled.dual().controllable().dual().controllable();
        minimal.b /= of_b;
        minimal.c /= of_c;
        minimal.d = self.d;
        minimal
    }

    /// Aᵀ, c, b, d: the same transfer function.
    fn dual(&self) -> Self {
        Self { a: self.a.transpose(), b: self.c.clone(), c: self.b.clone(), d: self.d }
    }

    /// With states in balanced units, and with b and c, times the two factors, as large as A. All factors are powers of two: nothing is rounded.
    ///
    /// A is balanced alone first: before, its norm is that of the units of the states, and b and c of that size would choose these units.
    fn scaled(&self) -> (Self, [f64; 2]) {
        let mut scaled = self.clone();
        let mut factors = [1.0; 2];
        balance(&mut scaled, false);
        scaled.scale_ends(&mut factors);
        balance(&mut scaled, true);
        scaled.scale_ends(&mut factors);
        scaled.d *= factors[0] * factors[1];
        (scaled, factors)
    }

    /// Makes b and c as large as A; their factors go into `factors`.
    fn scale_ends(&mut self, factors: &mut [f64; 2]) {
        let size = self.size();
        for (vector, factor) in [&mut self.b, &mut self.c].into_iter().zip(factors) {
            let by = power_of_two(size / vector.norm());
            *vector *= by;
            *factor *= by;
        }
    }

    /// The norm of A, what others are compared with; 1 where that is zero.
    fn size(&self) -> f64 {
        let size = self.a.norm();
        if size > 0.0 { size } else { 1.0 }
    }

    /// The states that the input moves, in the basis b, A b, A² b, … made orthonormal.
    fn controllable(&self) -> Self {
        let mut part = self.clone();
        let (n, least) = (self.a.nrows(), NEGLIGIBLE * self.size());
        let mut n_moved = 0;
        while n_moved < n {
            let column = match n_moved {
                0 => part.b.clone(),
                k => part.a.view((k, k - 1), (n - k, 1)).column(0).into_owned(),
            };
            if column.norm() <= least {
                break;
            }
            part.reflect(n_moved, &Reflection::onto(column, 0));
            n_moved += 1;
        }
        part.keep(n_moved);
        // exactly Hessenberg, without what rounding left below
        for j in 0..n_moved {
            for i in j + 2..n_moved {
                part.a[(i, j)] = 0.0;
            }
            if j > 0 {
                part.b[j] = 0.0;
            }
        }
        part
    }

    /// Changes the states from `first` on by a reflection.
    fn reflect(&mut self, first: usize, by: &Reflection) {
        let n = by.vector.nrows();
        by.apply(&mut self.a.rows_mut(first, n));
        self.a.transpose_mut();
        by.apply(&mut self.a.rows_mut(first, n));
        self.a.transpose_mut();
        by.apply(&mut self.b.rows_mut(first, n));
        by.apply(&mut self.c.rows_mut(first, n));
    }

    /// Keeps the first `n` states.
    fn keep(&mut self, n: usize) {
        self.a = self.a.view((0, 0), (n, n)).into_owned();
        self.b = self.b.rows(0, n).into_owned();
        self.c = self.c.rows(0, n).into_owned();
    }

    /// The invariant zeros as eigenvalues; none where the output does not depend on the input.
    ///
    /// Where d = 0, a reflection makes c = γ eₙ: what keeps the output at zero keeps xₙ at zero, and 0 = xₙ' is the next output, with the other
    /// states. Where d ≠ 0, the output is kept at zero by u = −cᵀ x/d.
    ///
    /// # Source
    /// Emami-Naeini, Van Dooren (1982), Computation of zeros of linear multivariable systems, for one input and one output.
    pub(super) fn zero_dynamics(&self) -> Option<ZeroDynamics> {
        let (mut left, [of_b, of_c]) = self.scaled();
        let least = NEGLIGIBLE * left.size();
        let mut gain = 1.0 / of_b / of_c;
        let mut relative_degree = 0;
        while left.d.abs() <= least {
            let n = left.a.nrows().checked_sub(1)?;
            if left.c.norm() <= least {
                return None;
            }
            left.reflect(0, &Reflection::onto(left.c.clone(), n));
            gain *= left.c[n];
            relative_degree += 1;
            left.d = left.b[n];
            let row = left.a.row(n).transpose();
            left.keep(n);
            left.c = row.rows(0, n).into_owned();
        }
        left.a -= &left.b * left.c.transpose() / left.d;
        balance(&mut left, false);
        Some(ZeroDynamics { gain: gain * left.d, relative_degree, matrix: left.a })
    }

    /// G(s) = cᵀ (s − A)⁻¹ b + d where A is upper Hessenberg; none where s is an eigenvalue.
    ///
    /// # Cost
    /// O(n²).
    pub(super) fn at(&self, s: Complex<f64>) -> Option<Complex<f64>> {
        let n = self.a.nrows();
        let mut matrix = self.a.map(|x| Complex::new(-x, 0.0));
        (0..n).for_each(|i| matrix[(i, i)] += s);
        let mut x = self.b.map(|x| Complex::new(x, 0.0));
        for k in 0..n {
            // below the diagonal there is one entry alone
            if k + 1 < n {
                if matrix[(k + 1, k)].norm_sqr() > matrix[(k, k)].norm_sqr() {
                    (k..n).for_each(|j| matrix.swap((k, j), (k + 1, j)));
                    x.swap_rows(k, k + 1);
                }
                let factor = matrix[(k + 1, k)] / matrix[(k, k)];
                for j in k..n {
                    let above = matrix[(k, j)];
                    matrix[(k + 1, j)] -= factor * above;
                }
                let above = x[k];
                x[k + 1] -= factor * above;
            }
        }
        for k in (0..n).rev() {
            let known: Complex<f64> = (k + 1..n).map(|j| matrix[(k, j)] * x[j]).sum();
            x[k] = (x[k] - known) / matrix[(k, k)];
        }
        let value = x.iter().zip(&self.c).map(|(x, c)| x * *c).sum::<Complex<f64>>() + self.d;
        (value.re.is_finite() && value.im.is_finite()).then_some(value)
    }
}

/// I − 2 w wᵀ / wᵀ w.
struct Reflection {
    vector: DVector<f64>,
}

impl Reflection {
    /// Takes `x` onto the axis `to`.
    fn onto(mut x: DVector<f64>, to: usize) -> Self {
        // the sign that adds
        x[to] += x.norm().copysign(x[to]);
        let norm = x.norm();
        Self { vector: if norm > 0.0 { x / norm } else { x } }
    }

    fn apply<C: nalgebra::Dim, S>(&self, rows: &mut nalgebra::Matrix<f64, nalgebra::Dyn, C, S>)
    where
        S: nalgebra::StorageMut<f64, nalgebra::Dyn, C>,
    {
        for mut column in rows.column_iter_mut() {
            let along = 2.0 * self.vector.iter().zip(column.iter()).map(|(w, x)| w * x).sum::<f64>();
            column.iter_mut().zip(&self.vector).for_each(|(x, w)| *x -= along * w);
        }
    }
}

/// The power of two nearest to a positive number; 1 for what is none.
fn power_of_two(x: f64) -> f64 {
    if x.is_finite() && x > 0.0 { x.log2().round().exp2() } else { 1.0 }
}

/// Gives the states units, by powers of two, in which rows and columns of A, or of `[A b; cᵀ 0]` where `with_ends`, are alike in size.
///
/// Entries below n ε of the largest one are ignored: as rounding of a zero they would choose the unit. Units may therefore differ by some 1e7 from
/// balanced ones: beyond that, entries that matter are ignored, too.
///
/// # Source
/// Parlett, Reinsch (1969), Balancing a matrix for calculation of eigenvalues and eigenvectors.
fn balance(of: &mut Realization, with_ends: bool) {
    let Realization { a, b, c, .. } = of;
    let n = a.nrows();
    let end = |x: f64| if with_ends { x } else { 0.0 };
    let largest = a.amax().max(end(b.amax())).max(end(c.amax()));
    let least = f64::EPSILON * n as f64 * largest;
    let counted = |x: f64| if x.abs() > least { x.abs() } else { 0.0 };
    for _ in 0..MAX_SWEEPS {
        let mut is_balanced = true;
        for i in 0..n {
            let others = || (0..n).filter(|&j| j != i);
            let row = others().map(|j| counted(a[(i, j)])).sum::<f64>() + counted(end(b[i]));
            let column = others().map(|j| counted(a[(j, i)])).sum::<f64>() + counted(end(c[i]));
            let by = power_of_two((column / row).sqrt());
            if by == 1.0 || row == 0.0 || column == 0.0 {
                continue;
            }
            is_balanced = false;
            a.row_mut(i).scale_mut(by);
            a.column_mut(i).scale_mut(1.0 / by);
            b[i] *= by;
            c[i] /= by;
        }
        if is_balanced {
            break;
        }
    }
}
