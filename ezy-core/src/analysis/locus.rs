//! Root loci: eigenvalues over a value that varies, and where stability changes.

use super::root::sign_change;
use super::spectrum::Spectrum;
use super::tolerances::locus::WIDTH;
use nalgebra::Complex;

/// The eigenvalues at some values of a quantity, and the critical values between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Locus {
    /// Values in ascending order, each with its eigenvalues.
    pub points: Vec<(f64, Spectrum)>,
    /// Where the number of unstable eigenvalues changes, in ascending order.
    pub critical: Vec<CriticalValue>,
}

/// A value at which an eigenvalue, or a pair, crosses the imaginary axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CriticalValue {
    /// The value.
    pub value: f64,
    /// What begins or ends there.
    pub kind: Instability,
    /// Number of unstable eigenvalues below and above it.
    pub n_unstable: [usize; 2],
}

/// How a motion becomes unstable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Instability {
    /// A pair of eigenvalues ±iω crosses the axis: flutter, weave, sway.
    Oscillation {
        /// ω, rad/s.
        omega: f64,
    },
    /// A real eigenvalue crosses zero: capsizing, buckling.
    Divergence,
}

impl Locus {
    /// The eigenvalues `spectrum` gives at each of `values`. Between neighbouring values at which different numbers of them are unstable, the
    /// critical values are found to 1e-12 of the larger one, and to what rounding of the eigenvalues makes of it. Eigenvalues that cross the
    /// axis and come back between two values are not seen.
    ///
    /// # Errors
    /// Those of `spectrum`.
    ///
    /// # Cost
    /// One call for each value, and about fifteen for each critical value.
    pub fn of<E>(values: &[f64], mut spectrum: impl FnMut(f64) -> Result<Spectrum, E>) -> Result<Self, E> {
        let Self { points, .. } = Self::without_critical_values(values, &mut spectrum)?;
        let mut critical = Vec::new();
        for i in 1..points.len() {
            between(&points, i, &mut spectrum, &mut critical)?;
        }
        critical.sort_by(|a: &CriticalValue, b| a.value.total_cmp(&b.value));
        Ok(Self { points, critical })
    }

    /// The eigenvalues alone, of a quantity that has no values between those given: a number of bodies.
    ///
    /// # Errors
    /// Those of `spectrum`.
    pub fn without_critical_values<E>(
        values: &[f64],
        mut spectrum: impl FnMut(f64) -> Result<Spectrum, E>,
    ) -> Result<Self, E> {
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        values.dedup();
        let points = values.into_iter().map(|value| Ok((value, spectrum(value)?))).collect::<Result<Vec<_>, E>>()?;
        Ok(Self { points, critical: Vec::new() })
    }
}

/// Appends the critical values between points `i` − 1 and `i`.
///
/// With the k-th largest real part as f_k, continuous in the value, f_(m+1) changes its sign where the number of unstable eigenvalues passes
/// from m to more.
fn between<E>(
    points: &[(f64, Spectrum)],
    i: usize,
    spectrum: &mut impl FnMut(f64) -> Result<Spectrum, E>,
    critical: &mut Vec<CriticalValue>,
) -> Result<(), E> {
    let counts = [i - 1, i].map(|i| points[i].1.n_unstable());
    let (mut m, most) = (counts[0].min(counts[1]), counts[0].max(counts[1]));
    if m == most {
        return Ok(());
    }
    let rises = counts[0] < counts[1];
    let (stable, unstable) = if rises { (i - 1, i) } else { (i, i - 1) };
    // the next value on the stable side, for a value that is itself critical
    let before = if rises { stable.checked_sub(1) } else { Some(stable + 1).filter(|i| *i < points.len()) };
    let n_zero = points[stable].1.n_zero.min(points[unstable].1.n_zero);
    while m < most {
        let part = |of: &Spectrum| real_part(of, m, n_zero);
        let decided = |&i: &usize| part(&points[i].1) < -rounding(&points[i].1);
        let end = Some(stable).filter(decided).or(before.filter(decided));
        // nowhere is it stable: eigenvalues on the axis leave it, as the root of the value
        let neutral = end.is_none();
        let f = |of: &Spectrum| match part(of) - rounding(of) {
            _ if !neutral => part(of),
            // of zeros alone
            0.0 => -f64::MIN_POSITIVE,
            above => above,
        };
        let end = end.unwrap_or(stable);
        let ends = if rises { [end, unstable] } else { [unstable, end] };
        let width = WIDTH * ends.map(|i| points[i].0.abs()).into_iter().fold(0.0, f64::max);
        let [a, b] =
            sign_change(ends.map(|i| points[i].0), ends.map(|i| f(&points[i].1)), width, |x| Ok(f(&spectrum(x)?)))?;
        let at = spectrum(if rises { b } else { a })?;
        let s = eigenvalue(&at, m, n_zero);
        let (kind, n) = match s.im.abs() > rounding(&at) {
            true => (Instability::Oscillation { omega: s.im.abs() }, 2),
            false => (Instability::Divergence, 1),
        };
        let mut n_unstable = [m, (m + n).min(most)];
        m = n_unstable[1];
        if !rises {
            n_unstable.reverse();
        }
        critical.push(CriticalValue { value: 0.5 * (a + b), kind, n_unstable });
    }
    Ok(())
}

/// Real parts below it say nothing.
fn rounding(of: &Spectrum) -> f64 {
    of.rounding()
}

/// The eigenvalue with the m-th largest real part, from 0 on; of the zeros all but `n_zero` count.
fn eigenvalue(of: &Spectrum, m: usize, n_zero: usize) -> Complex<f64> {
    let zeros = std::iter::repeat_n(Complex::new(0.0, 0.0), of.n_zero.saturating_sub(n_zero));
    let mut all: Vec<Complex<f64>> = of.eigenvalues.iter().copied().chain(zeros).collect();
    all.sort_by(|a, b| b.re.total_cmp(&a.re));
    all.get(m).copied().unwrap_or_default()
}

fn real_part(of: &Spectrum, m: usize, n_zero: usize) -> f64 {
    eigenvalue(of, m, n_zero).re
}
