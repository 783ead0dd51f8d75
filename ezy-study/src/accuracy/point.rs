//! One setting of one method: its errors and its cost.

use std::time::Duration;

use super::errors::{Comparison, compare};
use super::reference::Reference;
use super::runs::{NoRun, Runs};
use super::trajectory::Trajectory;
use super::variant::Variant;
use ezy_core::integrate::Method;
use ezy_core::simulate::{Cost, Run, processor_time};

/// One setting of one method with one projection.
#[derive(Debug, Clone)]
pub struct Point {
    /// The method with its setting.
    pub method: Method,
    /// What is projected.
    pub variant: Variant,
    /// The outcome.
    pub result: PointResult,
}

/// Outcome of a setting.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum PointResult {
    /// Measured.
    Measured(Box<Measured>),
    /// The run does not reach the end; why.
    Stopped(String),
    /// The budget was used up, or would have been exceeded.
    NotRun,
    /// The measurement was interrupted before.
    Interrupted,
}

/// Errors and cost of a setting.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// Errors against the reference.
    pub error: Comparison,
    /// Largest |C| over the grid.
    pub position_residual: f64,
    /// Largest residual of all rows at velocity level over the grid.
    pub velocity_residual: f64,
    /// Largest |kinetic + potential − work| over the grid, less its value at the start, J.
    pub energy_balance: f64,
    /// Counts of a run that keeps its two ends.
    pub cost: Cost,
    /// Shortest processor time of such a run, s.
    pub seconds_min: f64,
    /// Median processor time of such runs, s.
    pub seconds_median: f64,
    /// Number of timed runs.
    pub n_timed: usize,
    /// Processor time of the run with a sample at every time of the grid, and works, s. It includes the cost of dense output.
    pub seconds_on_grid: f64,
}

/// Time for repeated runs of one setting, s, and their smallest and largest number.
const REPEAT_S: f64 = 0.02;
const MIN_REPEATS: usize = 7;
const MAX_REPEATS: usize = 101;
/// Longer runs, s, are timed less often: one run of a second is as informative as many of a millisecond.
const LONG_S: f64 = 0.1;

/// Number of timed runs for a run of this many seconds.
pub(super) fn repeats(seconds: f64) -> usize {
    if seconds > LONG_S {
        return ((MIN_REPEATS as f64 * LONG_S / seconds) as usize).max(1);
    }
    ((REPEAT_S / seconds) as usize).clamp(MIN_REPEATS, MAX_REPEATS)
}

/// Runs a setting on the grid, which also warms up, then repeatedly for its time.
pub(super) fn measure(
    runs: &Runs<'_>,
    method: Method,
    variant: Variant,
    reference: &Reference,
    until: Duration,
) -> PointResult {
    let measured = || -> Result<Measured, NoRun> {
        let run = runs.on_grid(method, variant, until)?;
        let error = compare(&Trajectory::of(&run), &reference.trajectory, &reference.scales);
        let error = error.ok_or_else(|| NoRun::Stopped("has samples at other times than the reference".to_owned()))?;
        if !error.is_finite() {
            return Err(NoRun::Stopped("has errors that are not finite".to_owned()));
        }
        let first = runs.bare(method, variant)?.cost;
        let (mut seconds, mut shortest) = (vec![first.processor_seconds], first.processor_seconds);
        while seconds.len() < repeats(shortest) && processor_time() < until {
            let again = runs.bare(method, variant)?.cost.processor_seconds;
            seconds.push(again);
            shortest = shortest.min(again);
        }
        seconds.sort_by(f64::total_cmp);
        Ok(Measured {
            error,
            position_residual: largest(&run, |sample| sample.position_residual),
            velocity_residual: largest(&run, |sample| sample.velocity_residual),
            energy_balance: largest(&run, |sample| sample.energy.balance),
            cost: first,
            seconds_min: shortest,
            seconds_median: seconds[seconds.len() / 2],
            n_timed: seconds.len(),
            seconds_on_grid: run.cost.processor_seconds,
        })
    };
    match measured() {
        Ok(measured) => PointResult::Measured(Box::new(measured)),
        Err(NoRun::Overtime) => PointResult::NotRun,
        Err(NoRun::Interrupted) => PointResult::Interrupted,
        Err(why) => PointResult::Stopped(why.to_string()),
    }
}

fn largest(run: &Run, pick: fn(&ezy_core::record::Sample<'_>) -> f64) -> f64 {
    run.samples().map(|sample| pick(&sample).abs()).fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
}

impl Point {
    /// What was measured, if it was.
    pub fn measured(&self) -> Option<&Measured> {
        match &self.result {
            PointResult::Measured(measured) => Some(measured),
            _ => None,
        }
    }

    /// `measured`, why it stopped, `not run` or `interrupted`.
    pub fn outcome(&self) -> &str {
        match &self.result {
            PointResult::Measured(_) => "measured",
            PointResult::Stopped(reason) => reason,
            PointResult::NotRun => "not run",
            PointResult::Interrupted => "interrupted",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_short_runs_are_timed_seven_times_at_least_and_long_ones_once() {
        assert_eq!([1e-9, 1e-3, 0.05, 0.1, 0.35, 2.0].map(repeats), [101, 20, 7, 7, 2, 1]);
    }
}
