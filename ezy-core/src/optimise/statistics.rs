//! What the residuals and their derivatives at the end of a fit say of its values.

use nalgebra::{DMatrix, DVector};

/// Linear statistics of a fit.
pub(super) struct Statistics {
    /// s: root of the residual sum over the degrees of freedom.
    pub residual_deviation: f64,
    /// By quantity; infinite where the data do not determine it.
    pub standard_errors: Vec<f64>,
    /// Correlation of each two values; NaN where one of them is not determined.
    pub correlation: Vec<Vec<f64>>,
    /// Sets of quantities that the data do not determine separately.
    pub undetermined: Vec<Vec<usize>>,
}

/// A quantity takes part in a direction when its component is larger than this.
const TAKES_PART: f64 = 0.1;
/// So many times their error, derivatives are told from zero.
const ABOVE_THE_ERROR: f64 = 10.0;

/// The statistics of residuals `r` with derivatives `columns`, each with the size of changes of its quantity. `error` is the error of the
/// derivatives, in parts of `magnitude`, the norm of the predicted values.
///
/// Cov = s² (JᵀJ)⁻¹ with s² = rᵀr/(n − m) (Seber and Wild, "Nonlinear Regression" (1989), 2.1.2), by the singular values of J with
/// columns of length one. A singular value within the error of the derivatives is zero: its direction is not determined.
pub(super) fn statistics(r: &[f64], columns: &[Vec<f64>], scales: &[f64], magnitude: f64, error: f64) -> Statistics {
    let (n, m) = (r.len(), columns.len());
    let degrees_of_freedom = n.saturating_sub(m).max(1);
    let residual_deviation = (r.iter().map(|r| r * r).sum::<f64>() / degrees_of_freedom as f64).sqrt();

    let norms: Vec<f64> = columns.iter().map(|column| DVector::from_column_slice(column).norm()).collect();
    let influence = |j: usize| norms[j] * scales[j];
    let magnitude = (0..m).map(influence).fold(magnitude, f64::max);
    // error of the column of length one
    let relative_error = |j: usize| ABOVE_THE_ERROR * error * magnitude / influence(j);
    let (seen, unseen): (Vec<usize>, Vec<usize>) = (0..m).partition(|&j| influence(j) > 0.0 && relative_error(j) < 1.0);
    let mut undetermined: Vec<Vec<usize>> = unseen.iter().map(|j| vec![*j]).collect();
    let mut covariance = DMatrix::from_element(m, m, f64::INFINITY);

    if !seen.is_empty() {
        let unit = DMatrix::from_fn(n, seen.len(), |i, k| columns[seen[k]][i] / norms[seen[k]]);
        let decomposed = unit.svd(false, true);
        let v = decomposed.v_t.map_or_else(|| DMatrix::identity(seen.len(), seen.len()), |v_t| v_t.transpose());
        let mut inverse = DMatrix::zeros(seen.len(), seen.len());
        let mut is_lost = vec![false; seen.len()];
        for (k, singular) in decomposed.singular_values.iter().enumerate() {
            let direction = v.column(k);
            let of_direction =
                direction.iter().zip(&seen).map(|(v, j)| (v * relative_error(*j)).powi(2)).sum::<f64>().sqrt();
            if *singular > of_direction {
                inverse += direction * direction.transpose() / (singular * singular);
                continue;
            }
            let part: Vec<usize> = (0..seen.len()).filter(|&i| direction[i].abs() > TAKES_PART).collect();
            part.iter().for_each(|&i| is_lost[i] = true);
            undetermined.push(part.into_iter().map(|i| seen[i]).collect());
        }
        for (a, &i) in seen.iter().enumerate() {
            for (b, &j) in seen.iter().enumerate() {
                if !(is_lost[a] || is_lost[b]) {
                    covariance[(i, j)] = residual_deviation.powi(2) * inverse[(a, b)] / (norms[i] * norms[j]);
                }
            }
        }
    }
    let standard_errors: Vec<f64> = (0..m).map(|j| covariance[(j, j)].sqrt()).collect();
    let correlation = |i: usize, j: usize| match (i == j, standard_errors[i] * standard_errors[j]) {
        (_, product) if !product.is_finite() => f64::NAN,
        (true, _) => 1.0,
        (_, product) => covariance[(i, j)] / product,
    };
    let correlation = (0..m).map(|i| (0..m).map(|j| correlation(i, j)).collect()).collect();
    Statistics { residual_deviation, standard_errors, correlation, undetermined }
}
