//! Dense linear algebra by the book, for numbers to compare with.

#[derive(Debug, Clone)]
pub struct Matrix {
    pub rows: Vec<Vec<f64>>,
}

impl Matrix {
    pub fn zeros(n: usize) -> Self {
        Self { rows: vec![vec![0.0; n]; n] }
    }

    /// The solution by elimination with row pivoting; `None` when a column has no pivot.
    pub fn solve(&self, right_side: &[f64]) -> Option<Vec<f64>> {
        let columns = self.solve_all(right_side.iter().map(|&b| vec![b]).collect())?;
        Some(columns.into_iter().map(|row| row[0]).collect())
    }

    /// ‖K‖∞ ‖K⁻¹‖∞; infinite when there is no inverse.
    pub fn condition(&self) -> f64 {
        let n = self.rows.len();
        let unit = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        let Some(inverse) = self.solve_all(unit) else { return f64::INFINITY };
        norm(&self.rows) * norm(&inverse)
    }

    /// Solutions for several right sides, the columns of `b`.
    fn solve_all(&self, b: Vec<Vec<f64>>) -> Option<Vec<Vec<f64>>> {
        let (mut rows, mut x) = (self.rows.clone(), b);
        let n = rows.len();
        for k in 0..n {
            let best = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs()))?;
            rows.swap(k, best);
            x.swap(k, best);
            if rows[k][k] == 0.0 {
                return None;
            }
            for i in k + 1..n {
                let factor = rows[i][k] / rows[k][k];
                if factor != 0.0 {
                    subtract(&mut rows, i, k, factor);
                    subtract(&mut x, i, k, factor);
                }
            }
        }
        for k in (0..n).rev() {
            x[k].iter_mut().for_each(|entry| *entry /= rows[k][k]);
            for (i, row) in rows[..k].iter().enumerate() {
                let factor = row[k];
                if factor != 0.0 {
                    subtract(&mut x, i, k, factor);
                }
            }
        }
        Some(x)
    }
}

/// Row i −= factor · row k.
fn subtract(rows: &mut [Vec<f64>], i: usize, k: usize, factor: f64) {
    let (k_row, i_row) = if k < i {
        let (above, below) = rows.split_at_mut(i);
        (&above[k], &mut below[0])
    } else {
        let (above, below) = rows.split_at_mut(k);
        (&below[0], &mut above[i])
    };
    i_row.iter_mut().zip(k_row).for_each(|(x, y)| *x -= factor * y);
}

fn norm(rows: &[Vec<f64>]) -> f64 {
    rows.iter().map(|row| row.iter().map(|x| x.abs()).sum()).fold(0.0, f64::max)
}
