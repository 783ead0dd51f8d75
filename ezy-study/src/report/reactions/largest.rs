//! Where a sampled curve is largest, between its samples too.

use ezy_core::record::Sample;

/// Times between two samples of a run at which it is asked again, near a largest value: the parabola through three of them then has an error
/// of 16⁻³ of that through the samples.
const N_BETWEEN: u32 = 16;

/// Peaks of one curve that are looked at again: samples and parabolas may take one for the largest that is not.
const N_PEAKS: usize = 4;

/// Peaks that differ by less than this part are equal, and the first one is told: the default tolerance of a run.
const EQUAL: f64 = 1e-9;

/// Curvatures on both sides of a smooth peak, and distances of its samples, differ by less than this factor. At a jump or a kink they do not,
/// and no parabola is put through it.
const ALIKE: f64 = 2.0;

/// A largest value and its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Largest {
    /// The value, in the unit of what is largest.
    pub value: f64,
    /// Its time, s.
    pub t: f64,
}

/// A local maximum of a curve, near one of its samples.
#[derive(Debug, Clone, Copy)]
pub(super) struct Peak {
    pub largest: Largest,
    /// The sample.
    i: usize,
}

/// Values over times, as many of both.
pub(super) struct Curve<'a> {
    pub times: &'a [f64],
    pub values: Vec<f64>,
}

impl<'a> Curve<'a> {
    pub(super) fn new(times: &'a [f64], samples: &[Sample<'_>], value: impl Fn(&Sample<'_>) -> f64) -> Self {
        Self { times, values: samples.iter().map(value).collect() }
    }

    /// Where the curve is largest: the first of equal peaks. `None` without values.
    pub(super) fn largest(&self) -> Option<Peak> {
        let peaks = self.peaks();
        let most = peaks.first()?.largest.value;
        let equal = |peak: &&Peak| peak.largest.value >= most - EQUAL * most.abs();
        peaks.iter().filter(equal).min_by(|a, b| a.largest.t.total_cmp(&b.largest.t)).copied()
    }

    /// Times to ask a run for, besides the samples, to find the largest value.
    pub(super) fn times_near_peaks(&self, times: &mut Vec<f64>) {
        for Peak { i, .. } in self.peaks().into_iter().take(N_PEAKS) {
            for j in [i.checked_sub(1), (i + 1 < self.times.len()).then_some(i)].into_iter().flatten() {
                let (t, h) = (self.times[j], self.times[j + 1] - self.times[j]);
                times.extend((0..=N_BETWEEN).map(|k| t + h * f64::from(k) / f64::from(N_BETWEEN)));
            }
        }
    }

    /// Values of another curve over the same times, where a peak of this one is.
    pub(super) fn at_peak(&self, peak: &Peak, values: &Curve<'_>) -> f64 {
        let Peak { largest: Largest { t, .. }, i } = *peak;
        match i.checked_sub(1).filter(|_| i + 1 < self.times.len() && t != self.times[i]) {
            Some(first) => {
                let [slope, curvature] = values.differences(first);
                values.values[first] + (t - self.times[first]) * (slope + (t - self.times[i]) * curvature)
            }
            None => values.values[i],
        }
    }

    /// Mean and root mean square over time, by trapezoids.
    pub(super) fn mean_and_rms(&self) -> [f64; 2] {
        let over_time = |power: i32| {
            let sums = self.times.windows(2).zip(self.values.windows(2));
            sums.map(|(t, f)| 0.5 * (t[1] - t[0]) * (f[0].powi(power) + f[1].powi(power))).sum::<f64>()
        };
        let time = self.times.last().zip(self.times.first()).map_or(0.0, |(last, first)| last - first);
        match self.values.first() {
            Some(_) if time > 0.0 => [over_time(1) / time, (over_time(2) / time).sqrt()],
            Some(value) => [*value, value.abs()],
            None => [0.0; 2],
        }
    }

    /// The integral over time: trapezoids, less what the curvature bends them by where it is alike on both sides of an interval. At a jump or a
    /// kink they stay trapezoids.
    pub(super) fn integral(&self) -> f64 {
        let n = self.times.len();
        let curvature =
            |first: Option<usize>| first.filter(|first| first + 2 < n).map(|first| self.differences(first)[1]);
        let parts = (1..n).map(|j| {
            let h = self.times[j] - self.times[j - 1];
            let bent = match [j.checked_sub(2), Some(j - 1)].map(curvature) {
                [Some(a), Some(b)] if are_alike(a, b) => 0.5 * (a + b),
                [Some(_), Some(_)] | [None, None] => 0.0,
                // at an end of the run there is one side
                [Some(one), None] | [None, Some(one)] => one,
            };
            // the divided difference is half of f''
            h * (0.5 * (self.values[j - 1] + self.values[j]) - h * h * bent / 6.0)
        });
        parts.sum()
    }

    /// The local maxima, the largest first.
    fn peaks(&self) -> Vec<Peak> {
        let f = &self.values;
        let is_peak = |i: &usize| (*i == 0 || f[i - 1] <= f[*i]) && f.get(i + 1).is_none_or(|next| *next <= f[*i]);
        let mut peaks: Vec<Peak> = (0..f.len()).filter(is_peak).map(|i| Peak { largest: self.vertex(i), i }).collect();
        peaks.sort_by(|a, b| b.largest.value.total_cmp(&a.largest.value));
        peaks
    }

    /// The vertex of the parabola through a local maximum and its neighbours; the sample itself at an end, a jump or a kink.
    fn vertex(&self, i: usize) -> Largest {
        let sample = Largest { value: self.values[i], t: self.times[i] };
        let Some(first) = i.checked_sub(1).filter(|_| self.is_smooth(i)) else { return sample };
        let [slope, curvature] = self.differences(first);
        let t = 0.5 * (self.times[first] + self.times[i] - slope / curvature);
        let value = self.values[first] + (t - self.times[first]) * (slope + (t - self.times[i]) * curvature);
        // of a plateau the quotient is rounding
        if value.is_finite() && (self.times[first]..=self.times[i + 1]).contains(&t) {
            Largest { value, t }
        } else {
            sample
        }
    }

    /// Whether curvatures around a sample are negative and alike, in steps of time that are alike.
    fn is_smooth(&self, i: usize) -> bool {
        let n = self.times.len();
        if i == 0 || i + 1 >= n {
            return false;
        }
        let range = i.saturating_sub(2)..(i + 3).min(n);
        let steps = self.times[range.clone()].windows(2).map(|pair| pair[1] - pair[0]);
        let curvatures = (range.start..range.end - 2).map(|first| -self.differences(first)[1]);
        let all_alike = |values: &mut dyn Iterator<Item = f64>| {
            let [least, most] = values.fold([f64::INFINITY, 0.0_f64], |[a, b], x| [a.min(x), b.max(x)]);
            least > 0.0 && most < ALIKE * least
        };
        all_alike(&mut { steps }) && all_alike(&mut { curvatures })
    }

    /// The divided differences of first and second order at three samples.
    fn differences(&self, first: usize) -> [f64; 2] {
        let (t, f) = (&self.times[first..], &self.values[first..]);
        let [slope, next] = [0, 1].map(|k| (f[k + 1] - f[k]) / (t[k + 1] - t[k]));
        [slope, (next - slope) / (t[2] - t[0])]
    }
}

/// Whether two curvatures have one sign and less than the factor between them.
fn are_alike(a: f64, b: f64) -> bool {
    a * b > 0.0 && a.abs().max(b.abs()) < ALIKE * a.abs().min(b.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples at 0, 0.1, …, 2 s.
    fn sampled(of: impl Fn(f64) -> f64, check: impl Fn(&Curve<'_>)) {
        let times: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
        check(&Curve { times: &times, values: times.iter().map(|t| of(*t)).collect() });
    }

    #[test]
    fn analytic_parabola_has_its_vertex() {
        sampled(
            |t| 3.0 - 2.0 * (t - 0.777).powi(2),
            |curve| {
                let peak = curve.largest().unwrap();
                let Largest { value, t } = peak.largest;
                assert!((value - 3.0).abs() <= 1e-14 && (t - 0.777).abs() <= 1e-14, "{value} {t}");
                let square = Curve { times: curve.times, values: curve.times.iter().map(|t| t * t).collect() };
                assert!((curve.at_peak(&peak, &square) - 0.777 * 0.777).abs() <= 1e-14);
            },
        );
    }

    /// Beside a jump, on a kink and at an end the sample is the largest.
    #[test]
    fn analytic_no_parabola_is_put_through_a_jump() {
        let at = |of: fn(f64) -> f64, expected: [f64; 2]| {
            sampled(of, |curve| {
                let Largest { value, t } = curve.largest().unwrap().largest;
                assert!((value - expected[0]).abs() <= 1e-14 && (t - expected[1]).abs() <= 1e-14, "{value} {t}");
            });
        };
        at(|t| if t < 0.95 { 0.0 } else { 10.0 - t }, [9.0, 1.0]);
        at(|t| 5.0 - (t - 0.5).abs(), [5.0, 0.5]);
        at(|t| t * t, [4.0, 2.0]);
        at(|_| 7.0, [7.0, 0.0]);
    }

    /// Of equal peaks the first; of peaks that samples confuse, the one whose parabola is higher.
    #[test]
    fn analytic_first_of_equal_peaks_and_the_higher_of_two() {
        let tau = std::f64::consts::TAU;
        sampled(
            |t| (tau * (t - 0.23)).cos(),
            |curve| {
                let Largest { t, .. } = curve.largest().unwrap().largest;
                assert!((t - 0.23).abs() < 0.01, "{t}");
            },
        );
        // the peak at 0.55 s lies between samples, that at 1.5 s on one
        sampled(
            |t| if t < 1.0 { 1.0 - (t - 0.55).powi(2) } else { 0.999 - (t - 1.5).powi(2) },
            |curve| {
                let Largest { value, t } = curve.largest().unwrap().largest;
                assert!((t - 0.55).abs() <= 1e-12 && (value - 1.0).abs() <= 1e-12, "{value} {t}");
            },
        );
    }

    /// Of 1 + t over 2 s: mean 2, mean square 13/3, and trapezoids add 0.1²/6 to it.
    #[test]
    fn analytic_means_of_a_line() {
        sampled(
            |t| 1.0 + t,
            |curve| {
                let [mean, rms] = curve.mean_and_rms();
                let square: f64 = 13.0 / 3.0 + 0.01 / 6.0;
                assert!((mean - 2.0).abs() <= 1e-14 && (rms - square.sqrt()).abs() <= 1e-14, "{mean} {rms}");
            },
        );
    }

    /// Of a parabola it is exact; of a cubic it is too, since the mean curvature of an interval is that of both sides, but where it passes zero
    /// and at the ends: f'' = 6 t there is wrong by h or left out, h³/12 of at most 6 h each, in four intervals of 0.1 s. A jump of 1 is late by half an interval.
    #[test]
    fn analytic_integrals_of_parabola_cubic_and_jump() {
        let close = |of: fn(f64) -> f64, expected: f64, bound: f64| {
            sampled(of, |curve| {
                assert!((curve.integral() - expected).abs() <= bound, "{} {expected}", curve.integral())
            });
        };
        close(|t| 3.0 - 2.0 * (t - 0.777).powi(2), 6.0 - 2.0 * (1.223_f64.powi(3) + 0.777_f64.powi(3)) / 3.0, 1e-14);
        close(|t| (t - 1.0).powi(3), 0.0, 4.0 * 0.1_f64.powi(4) / 2.0);
        close(|t| t.powi(3), 4.0, 4.0 * 0.1_f64.powi(4) / 2.0);
        close(|t| if t < 0.95 { 0.0 } else { 1.0 }, 1.05, 1e-14);
    }

    #[test]
    fn invariant_times_near_peaks_are_those_around_them() {
        sampled(
            |t| -(t - 0.52).powi(2),
            |curve| {
                let mut times = Vec::new();
                curve.times_near_peaks(&mut times);
                let [least, most] = times.iter().fold([2.0_f64, 0.0_f64], |[a, b], t| [a.min(*t), b.max(*t)]);
                assert!((least - 0.4).abs() < 1e-12 && (most - 0.6).abs() < 1e-12 && times.len() == 34, "{times:?}");
            },
        );
    }
}
