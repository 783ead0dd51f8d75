//! Margins, resonance and bandwidth of a transfer function, from the zeros of G(−s) G(s) − γ² and of G(s) − G(−s).

use super::realization::Realization;
use super::root::sign_change;
use super::spectrum::Spectrum;
use super::tolerances::transfer::{BRACKET, MAX_LEVELS, MET, ON_AXIS, POLISH, WIDTH};
use super::transfer::Transfer;
use nalgebra::{Complex, DMatrix, DVector};
use std::convert::Infallible;
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// A value at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtFrequency {
    /// The value: a factor, an angle in rad, or a magnitude.
    pub value: f64,
    /// ω, rad/s.
    pub omega: f64,
}

impl Transfer {
    /// The gain margin of the open loop G with the feedback u = −y: the factor nearest to one by which G may be multiplied until the loop is
    /// at the limit of stability, 1/|G| where G(iω) is real and negative. Where the loop is unstable as it is, it is no margin.
    pub fn gain_margin(&self) -> Option<AtFrequency> {
        let factor = |omega: f64| Some(-self.at_frequency(omega)?.re.recip()).filter(|factor| *factor > 0.0);
        let margins = self.real_at().into_iter().filter_map(|omega| Some(AtFrequency { value: factor(omega)?, omega }));
        margins.min_by(|a, b| a.value.ln().abs().total_cmp(&b.value.ln().abs()))
    }

    /// The phase margin of the open loop G with the feedback u = −y, rad: the angle of least size by which G may lag until the loop is at the
    /// limit of stability, π + arg G where |G(iω)| = 1. Below zero the loop lags too much by it.
    pub fn phase_margin(&self) -> Option<AtFrequency> {
        let angle = |omega: f64| Some((-self.at_frequency(omega)?).arg());
        let margins =
            self.crossings(1.0).into_iter().filter_map(|omega| Some(AtFrequency { value: angle(omega)?, omega }));
        margins.min_by(|a, b| a.value.abs().total_cmp(&b.value.abs()))
    }

    /// The poles of the loop that u = −y closes; none where it has no solution, G = −1 for large s.
    pub fn closed_loop(&self) -> Option<Spectrum> {
        let mut one_more = self.realization.clone();
        one_more.d += 1.0;
        Spectrum::of(&one_more.zero_dynamics().filter(|zeros| zeros.relative_degree == 0)?.matrix)
    }

    /// The largest magnitude |G(iω)| where that exceeds those for ω → 0 and ω → ∞. None, too, where a pole lies on the imaginary axis: nothing
    /// bounds the magnitude there.
    ///
    /// # Source
    /// Bruinsma, Steinbuch (1990), A fast algorithm to compute the H∞-norm of a transfer function matrix.
    pub fn resonance(&self) -> Option<AtFrequency> {
        if self.poles.n_zero + self.poles.n_neutral() > 0 {
            return None;
        }
        let magnitude = |omega: f64| self.at_frequency(omega).map_or(0.0, Complex::norm);
        let better = |best: AtFrequency, omega: f64| match magnitude(omega) {
            value if value > best.value => AtFrequency { value, omega },
            _ => best,
        };
        let ends = magnitude(0.0).max(self.realization.d.abs());
        let of_poles = self.poles.eigenvalues.iter().flat_map(|p| [p.norm(), p.im.abs()]).filter(|omega| *omega > 0.0);
        let mut best = of_poles.fold(AtFrequency { value: ends, omega: 0.0 }, better);
        for _ in 0..MAX_LEVELS {
            let above = self.crossings(best.value * (1.0 + MET));
            let last = best;
            best = above.windows(2).map(|pair| (pair[0] * pair[1]).sqrt()).fold(best, better);
            if best == last {
                break;
            }
        }
        let is_inside = best.omega > 0.0 && best.value > ends * (1.0 + MET);
        is_inside.then(|| self.at_stationary_point(best, ends))
    }

    /// The frequency where the slope of the magnitude vanishes, between those beside the largest value where it is a little less.
    fn at_stationary_point(&self, best: AtFrequency, ends: f64) -> AtFrequency {
        // above the ends, so that there is such a frequency on both sides
        let beside = self.crossings((best.value * (1.0 - BRACKET)).max(0.5 * (best.value + ends)));
        let below = beside.iter().copied().rfind(|omega| *omega < best.omega);
        let above = beside.iter().copied().find(|omega| *omega > best.omega);
        let slope = |omega: f64| self.logarithmic_slope(omega).re;
        let (Some(a), Some(b)) = (below, above) else { return best };
        if !(slope(a) > 0.0 && slope(b) < 0.0) {
            return best;
        }
        let Ok([a, b]) = sign_change([a, b], [a, b].map(slope), WIDTH * b, |omega| Ok::<_, Infallible>(slope(omega)));
        let omega = 0.5 * (a + b);
        self.at_frequency(omega).map_or(best, |g| AtFrequency { value: g.norm(), omega })
    }

    /// ω, rad/s, up to which the magnitude is at least |G(0)|/√2, −3 dB. None without a static gain, and where the magnitude never falls
    /// so low.
    pub fn bandwidth(&self) -> Option<f64> {
        let level = self.static_gain().map(|gain| gain.abs() * FRAC_1_SQRT_2).filter(|level| *level > 0.0)?;
        self.crossings(level).first().copied()
    }

    /// All ω > 0 with |G(iω)| = `level`, ascending, rad/s: none is missed between two frequencies.
    ///
    /// They are the zeros of G(−s) G(s) − γ² on the imaginary axis.
    pub fn crossings(&self, level: f64) -> Vec<f64> {
        let Realization { a, b, c, d } = &self.realization;
        let (c, d) = (c / level, d / level);
        // G(s), then G(−s) = −cᵀ (s + A)⁻¹ b + d behind it
        let n = a.nrows();
        let mut behind = twice(a, b, &(&c * d));
        behind.a.view_mut((n, 0), (n, n)).copy_from(&(b * c.transpose()));
        behind.b.rows_mut(n, n).scale_mut(d);
        behind.c.rows_mut(n, n).copy_from(&-&c);
        behind.d = d * d - 1.0;
        let left = |omega: f64| Some((self.at_frequency(omega)?.norm() / level).ln());
        self.on_axis(&behind, left, |slope| slope.re)
    }

    /// All ω > 0 where G(iω) is real, ascending. They are the zeros of G(s) − G(−s) on the imaginary axis.
    fn real_at(&self) -> Vec<f64> {
        let Realization { a, b, c, .. } = &self.realization;
        let odd = twice(a, b, c);
        // half a turn is no angle here
        let left = |omega: f64| Some(self.at_frequency(omega)?.arg()).map(|angle| angle - PI * (angle / PI).round());
        self.on_axis(&odd, left, |slope| slope.im)
    }

    /// The zeros of `of` on the upper half of the imaginary axis where `left` vanishes, each improved by Newton steps.
    fn on_axis(
        &self,
        of: &Realization,
        left: impl Fn(f64) -> Option<f64>,
        slope: impl Fn(Complex<f64>) -> f64,
    ) -> Vec<f64> {
        let zeros = of.zero_dynamics().and_then(|zeros| Spectrum::of(&zeros.matrix));
        let on_axis =
            zeros.iter().flat_map(|of| &of.eigenvalues).filter(|s| s.im > 0.0 && s.re.abs() <= ON_AXIS * s.im);
        let mut found: Vec<f64> =
            on_axis.filter_map(|s| improved(s.im, &left, |w| slope(self.logarithmic_slope(w)))).collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() <= ON_AXIS * *b);
        found
    }
}

/// A and −A side by side, with b to both and c from both.
fn twice(a: &DMatrix<f64>, b: &DVector<f64>, c: &DVector<f64>) -> Realization {
    let n = a.nrows();
    let mut both = DMatrix::zeros(2 * n, 2 * n);
    both.view_mut((0, 0), (n, n)).copy_from(a);
    both.view_mut((n, n), (n, n)).copy_from(&-a);
    let stacked = |x: &DVector<f64>| DVector::from_iterator(2 * n, x.iter().chain(x.iter()).copied());
    Realization { a: both, b: stacked(b), c: stacked(c), d: 0.0 }
}

/// `omega` after Newton steps; none where what is left does not vanish.
fn improved(mut omega: f64, left: &impl Fn(f64) -> Option<f64>, slope: impl Fn(f64) -> f64) -> Option<f64> {
    let mut at = left(omega)?;
    for _ in 0..POLISH {
        let next = omega - at / slope(omega);
        // where curves touch, the slope vanishes, and the step leads astray
        match Some(next).filter(|next| (next - omega).abs() <= ON_AXIS * omega).and_then(left) {
            Some(there) if there.abs() < at.abs() => (omega, at) = (next, there),
            _ => break,
        }
    }
    (at.abs() <= MET).then_some(omega)
}
