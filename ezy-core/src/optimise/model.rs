//! What a run predicts at the measured times, and how that changes with the free quantities.

use super::{Free, Measured, OptimiseError};
use crate::simulate::Run;
use rayon::prelude::*;
use std::fmt::Display;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Makes a run with given values; the text says why there is none.
type RunWith<'f> = Box<dyn Fn(&[f64]) -> Result<Run, String> + Sync + 'f>;
/// Derivatives of the predicted values by each free quantity; `None` where they cannot be computed.
type Derivatives<'f> = Box<dyn Fn(&[f64]) -> Option<Vec<Vec<f64>>> + Sync + 'f>;

/// Runs with given values, counted.
pub(super) struct Runs<'f> {
    run: RunWith<'f>,
    n_runs: AtomicU64,
    n_failed: AtomicU64,
    last_failure: Mutex<String>,
}

impl<'f> Runs<'f> {
    pub(super) fn new<E: Display>(run: impl Fn(&[f64]) -> Result<Run, E> + Sync + 'f) -> Self {
        Self {
            run: Box::new(move |values| run(values).map_err(|error| error.to_string())),
            n_runs: AtomicU64::new(0),
            n_failed: AtomicU64::new(0),
            last_failure: Mutex::default(),
        }
    }

    /// The run, if it came to its end, and what `read` finds in it.
    pub(super) fn read<T>(&self, values: &[f64], read: impl Fn(&Run) -> Result<T, String>) -> Option<T> {
        self.n_runs.fetch_add(1, Ordering::Relaxed);
        let complete = |run: Run| if run.outcome.reached_end() { Ok(run) } else { Err(format!("it {}", run.outcome)) };
        match (self.run)(values).and_then(complete).and_then(|run| read(&run)) {
            Ok(found) => Some(found),
            Err(reason) => {
                self.n_failed.fetch_add(1, Ordering::Relaxed);
                if let Ok(mut last) = self.last_failure.lock() {
                    *last = reason;
                }
                None
            }
        }
    }

    pub(super) fn n_runs(&self) -> usize {
        self.n_runs.load(Ordering::Relaxed) as usize
    }

    pub(super) fn n_failed(&self) -> usize {
        self.n_failed.load(Ordering::Relaxed) as usize
    }

    pub(super) fn last_failure(&self) -> String {
        self.last_failure.lock().map_or(String::new(), |last| last.clone())
    }
}

/// Predictions of measured values.
pub(super) struct Model<'f> {
    pub free: Vec<Free>,
    pub data: &'f Measured,
    pub runs: Runs<'f>,
    pub derivatives: Option<Derivatives<'f>>,
    /// Relative error of the runs.
    pub tolerance: f64,
}

/// A sample belongs to a measurement when their times agree to this part of the time, or of a second.
const SAME_TIME: f64 = 1e-9;

impl Model<'_> {
    /// The predicted values, over σ; `None` when the run fails.
    pub(super) fn predicted(&self, values: &[f64]) -> Option<Vec<f64>> {
        self.runs.read(values, |run| self.of_run(run).map_err(|error| error.to_string()))
    }

    /// As [`Model::predicted`] with the start values, and why there is no prediction.
    pub(super) fn at_start(&self) -> Result<Vec<f64>, OptimiseError> {
        let start: Vec<f64> = self.free.iter().map(|free| free.start).collect();
        // a name or time that is missing is the caller's, and says more than the failure of a run
        let asked = Mutex::new(None);
        let found = self.runs.read(&start, |run| {
            self.of_run(run).map_err(|error| {
                let reason = error.to_string();
                asked.lock().map(|mut asked| *asked = Some(error)).unwrap_or_default();
                reason
            })
        });
        found.ok_or_else(|| match asked.into_inner() {
            Ok(Some(error)) => error,
            _ => OptimiseError::Start { reason: self.runs.last_failure() },
        })
    }

    fn of_run(&self, run: &Run) -> Result<Vec<f64>, OptimiseError> {
        let times: Vec<f64> = run.samples().map(|sample| sample.t).collect();
        let mut predicted = Vec::with_capacity(self.data.n_values());
        for column in self.data.names() {
            let values = run.column(column)?;
            for point in self.data.points().filter(|point| point.column.name == column) {
                let near = SAME_TIME * point.t.abs().max(1.0);
                let i = times.partition_point(|t| *t < point.t - near);
                match times.get(i) {
                    Some(t) if *t <= point.t + near => predicted.push(values[i] / point.column.sigma),
                    _ => return Err(OptimiseError::NoSample { t: point.t, column: column.to_owned() }),
                }
            }
        }
        Ok(predicted)
    }

    /// Derivatives of the predicted values by each free quantity, over σ.
    pub(super) fn jacobian(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let exact = self.derivatives.as_ref().and_then(|derivatives| derivatives(values));
        match exact {
            Some(mut columns) => {
                for column in &mut columns {
                    self.data.points().zip(column).for_each(|(point, d)| *d /= point.column.sigma);
                }
                columns
            }
            None => self.by_differences(values),
        }
    }

    /// Step of a central difference of runs with relative error ε, for a quantity of size s: the error ε/h of the runs and that of the
    /// formula, h² f‴/6, are smallest together at h ≈ ε^(1/3) s, when the prediction changes over s. Both are then about ε^(2/3).
    /// (Press et al., "Numerical Recipes" (2007), 5.7.)
    pub(super) fn step(&self, i: usize, value: f64) -> f64 {
        self.tolerance.cbrt() * self.free[i].scale_at(value)
    }

    /// Central differences; beside a bound, and where a run fails, differences to one side. Without any run the column is zero.
    pub(super) fn by_differences(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let moved = |i: usize, by: f64| {
            let Free { lower, upper, .. } = self.free[i];
            let mut moved = values.to_vec();
            moved[i] = (values[i] + by).clamp(lower, upper);
            (moved[i], self.predicted(&moved))
        };
        let of_quantity = |i: usize| {
            let h = self.step(i, values[i]);
            let ((above, after), (below, before)) = rayon::join(|| moved(i, h), || moved(i, -h));
            let here = || self.predicted(values);
            let (above, after, below, before) = match (after, before) {
                (Some(after), None) => (above, Some(after), values[i], here()),
                (None, Some(before)) => (values[i], here(), below, Some(before)),
                (after, before) => (above, after, below, before),
            };
            match (after, before) {
                (Some(after), Some(before)) => {
                    after.iter().zip(before).map(|(after, before)| (after - before) / (above - below)).collect()
                }
                _ => vec![0.0; self.data.n_values()],
            }
        };
        (0..values.len()).into_par_iter().map(of_quantity).collect()
    }

    /// Relative error of a derivative by differences, to the order of magnitude.
    pub(super) fn derivative_error(&self) -> f64 {
        self.tolerance.cbrt().powi(2)
    }
}
