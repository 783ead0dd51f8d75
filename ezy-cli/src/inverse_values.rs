//! What a prescribed motion takes: values and powers at the samples of a run, and what they are over time.

use super::interruption::Interruption;
use ezy_core::analysis::{AnalysisError, InverseDynamics};
use ezy_core::dynamics::{State, System};
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::Sample;
use ezy_core::simulate::Run;

/// What the names of multipliers begin with, as in files of `run`.
pub(super) const MULTIPLIER: &str = "lambda.";

/// A force of a drive, or an input, at the samples.
pub(super) struct Series {
    pub name: String,
    pub unit: &'static str,
    /// In its unit.
    pub values: Vec<f64>,
    /// W.
    pub powers: Vec<f64>,
}

/// Everything that was found, at times in s.
pub(super) struct Values {
    pub times: Vec<f64>,
    pub series: Vec<Series>,
    /// Power of everything else, W.
    pub others: Vec<f64>,
    /// Kinetic and potential energy, J.
    pub energies: Vec<f64>,
}

/// What the values are of.
pub(super) enum Wanted<'s> {
    /// Multipliers of these rows.
    Rows(Vec<usize>),
    /// These inputs, in place of drives.
    Inputs(Vec<usize>, Box<InverseDynamics<&'s dyn Scene>>),
}

impl Wanted<'_> {
    fn series(&self, info: &SceneInfo) -> Vec<Series> {
        let of = |name, unit| Series { name, unit, values: Vec::new(), powers: Vec::new() };
        match self {
            Self::Rows(rows) => {
                let rows = rows.iter().map(|&row| &info.rows[row]);
                rows.map(|row| of(format!("{MULTIPLIER}{}", row.name), row.multiplier_unit)).collect()
            }
            Self::Inputs(inputs, _) => {
                let inputs = inputs.iter().map(|&i| &info.inputs[i]);
                inputs.map(|input| of(input.name.to_owned(), input.unit)).collect()
            }
        }
    }
}

impl Values {
    /// The values at all samples, or until one has none, with the reason.
    pub(super) fn of<'s>(
        run: &Run,
        system: &mut System<&'s dyn Scene>,
        wanted: &mut Wanted<'s>,
        interruption: Interruption,
    ) -> (Self, Option<AnalysisError>) {
        let series = wanted.series(run.info());
        let mut all = Self { times: Vec::new(), series, others: Vec::new(), energies: Vec::new() };
        for sample in run.samples() {
            if interruption.is_asked() {
                break;
            }
            if let Err(error) = all.add(system, wanted, &sample) {
                return (all, Some(error));
            }
        }
        (all, None)
    }

    fn add<'s>(
        &mut self,
        system: &mut System<&'s dyn Scene>,
        wanted: &mut Wanted<'s>,
        sample: &Sample<'_>,
    ) -> Result<(), AnalysisError> {
        let state = State {
            t: sample.t,
            q: sample.coordinates.to_vec(),
            v: sample.velocities.to_vec(),
            z: sample.states.to_vec(),
            work: Vec::new(),
        };
        // what was found before is near
        let found: Vec<(usize, f64)> = match wanted {
            Wanted::Inputs(inputs, _) if !self.times.is_empty() => {
                inputs.iter().map(|&i| (i, system.fixed()[i])).collect()
            }
            _ => Vec::new(),
        };
        system.inputs_mut().copy_from_slice(sample.inputs);
        found.into_iter().for_each(|(i, value)| system.inputs_mut()[i] = value);
        system.place_states(&state.z);
        let (values, others, powers) = match wanted {
            Wanted::Rows(rows) => {
                let values = rows.iter().map(|&row| sample.multipliers[row]).collect::<Vec<_>>();
                let power = |left_out: &[usize]| {
                    let mut multipliers = sample.multipliers.to_vec();
                    left_out.iter().for_each(|&row| multipliers[row] = 0.0);
                    total_power(system, &state, &multipliers)
                };
                let (others, powers) = powers_of(rows, power);
                (values, others, powers)
            }
            Wanted::Inputs(inputs, inverse) => {
                let required = inverse.along(system, &state, sample.accelerations)?;
                let power = |left_out: &[usize]| {
                    let kept = system.inputs_mut().to_vec();
                    left_out.iter().for_each(|&i| system.inputs_mut()[i] = 0.0);
                    let power = total_power(system, &state, &required.multipliers);
                    system.inputs_mut().copy_from_slice(&kept);
                    power
                };
                let (others, powers) = powers_of(inputs, power);
                (required.inputs, others, powers)
            }
        };
        self.times.push(state.t);
        self.others.push(others);
        self.energies.push(sample.energy.kinetic + sample.energy.potential);
        for ((series, value), power) in self.series.iter_mut().zip(values).zip(powers) {
            series.values.push(value);
            series.powers.push(power);
        }
        Ok(())
    }
}

/// Of the power without some of these: that without all, and how much less it is without each.
fn powers_of(these: &[usize], mut power: impl FnMut(&[usize]) -> f64) -> (f64, Vec<f64>) {
    let all = power(&[]);
    (power(these), these.iter().map(|&i| all - power(&[i])).collect())
}

/// Power of all effects, W.
fn total_power(system: &System<&dyn Scene>, state: &State, multipliers: &[f64]) -> f64 {
    let mut powers = vec![0.0; system.info().n_effects()];
    system.power(state.t, &state.q, &state.v, multipliers, &mut powers);
    powers.iter().sum()
}

/// The largest number and its place; of equal ones the first.
pub(super) fn largest(values: &[f64]) -> Option<(usize, f64)> {
    values.iter().copied().enumerate().reduce(|most, next| if next.1 > most.1 { next } else { most })
}

/// Root of the mean square over time.
pub(super) fn root_mean_square(times: &[f64], values: &[f64]) -> f64 {
    let squares: Vec<f64> = values.iter().map(|value| value * value).collect();
    match times {
        [first, .., last] if last > first => (integral(times, &squares).max(0.0) / (last - first)).sqrt(),
        _ => values.first().map_or(0.0, |value| value.abs()),
    }
}

/// Points of a polynomial.
const N_POINTS: usize = 6;

/// Two samples that are closer than this share of the mean distance are both sides of a jump.
const JUMP: f64 = 1e-3;

/// Nodes and weights on [−1, 1] of Gauss' formula with three points, exact to the fifth degree.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// The integral over ascending times: of each interval that of the polynomial of the fifth degree through the six samples around it, none
/// of which is behind a jump.
pub(super) fn integral(times: &[f64], values: &[f64]) -> f64 {
    let n_intervals = times.len().saturating_sub(1);
    let (Some(first), Some(last)) = (times.first(), times.last()) else { return 0.0 };
    let close = JUMP * (last - first) / n_intervals.max(1) as f64;
    let mut sum = 0.0;
    let mut begin = 0;
    for end in 1..times.len() {
        let is_jump = times[end] - times[end - 1] <= close;
        if is_jump {
            sum += smooth(&times[begin..end], &values[begin..end]);
            sum += 0.5 * (times[end] - times[end - 1]) * (values[end] + values[end - 1]);
            begin = end;
        }
    }
    sum + smooth(&times[begin..], &values[begin..])
}

/// The same without jumps.
fn smooth(times: &[f64], values: &[f64]) -> f64 {
    let n = N_POINTS.min(times.len());
    let mut sum = 0.0;
    for i in 1..times.len() {
        let from = (i).saturating_sub(N_POINTS / 2).min(times.len() - n);
        let (around, at) = (&times[from..from + n], &values[from..from + n]);
        let half = 0.5 * (times[i] - times[i - 1]);
        let middle = 0.5 * (times[i] + times[i - 1]);
        sum += half * GAUSS.iter().map(|(x, weight)| weight * interpolated(around, at, middle + half * x)).sum::<f64>();
    }
    sum
}

/// The polynomial through points, by Neville's scheme.
fn interpolated(times: &[f64], values: &[f64], t: f64) -> f64 {
    let mut p = values.to_vec();
    for order in 1..p.len() {
        for i in 0..p.len() - order {
            let (a, b) = (times[i], times[i + order]);
            p[i] = ((b - t) * p[i] + (t - a) * p[i + 1]) / (b - a);
        }
    }
    p[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of integrals that are exact: rounding of a hundred terms of size one.
    const ROUNDING: f64 = 1e-13;

    #[test]
    fn analytic_integral_of_a_polynomial_of_the_fifth_degree_is_exact() {
        // uneven on purpose
        let times: Vec<f64> = (0..=20).map(|i| (f64::from(i) / 20.0).powf(1.3)).collect();
        let values: Vec<f64> = times.iter().map(|t| 6.0 * t.powi(5) - 2.0 * t).collect();
        assert!(integral(&times, &values).abs() <= ROUNDING);
        for n in [1, 2, 3] {
            let (times, values): (Vec<f64>, Vec<f64>) = times.iter().take(n).map(|t| (*t, 2.0 * t)).unzip();
            assert!((integral(&times, &values) - times[n - 1].powi(2)).abs() <= ROUNDING);
        }
        assert!(integral(&[], &[]) == 0.0);
    }

    #[test]
    fn order_integral_of_a_sine_is_six() {
        let error = |n: u32| {
            let times: Vec<f64> = (0..=n).map(|i| f64::from(i) / f64::from(n)).collect();
            let values: Vec<f64> = times.iter().map(|t| (3.0 * t).sin()).collect();
            (integral(&times, &values) - (1.0 - 3.0_f64.cos()) / 3.0).abs()
        };
        let order = (error(20) / error(40)).log2();
        assert!((5.7..7.3).contains(&order), "{order}");
    }

    #[test]
    fn analytic_jump_does_not_spread() {
        let times = [0.0, 1.0, 2.0, 2.0, 3.0, 4.0];
        let values = [1.0, 1.0, 1.0, 5.0, 5.0, 5.0];
        assert!((integral(&times, &values) - 12.0).abs() <= ROUNDING);
        assert!((root_mean_square(&times, &values) - 13.0_f64.sqrt()).abs() <= ROUNDING);
        assert_eq!(largest(&values), Some((3, 5.0)));
    }
}
