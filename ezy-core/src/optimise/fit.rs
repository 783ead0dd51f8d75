//! Values of free quantities from measured columns.

use super::least_squares::{self, FitEnd, residuals};
use super::model::{Model, Runs};
use super::statistics::{Statistics, statistics};
use super::student::two_sided_quantile;
use super::{Free, Measured, OptimiseError};
use crate::integrate::Tolerance;
use crate::simulate::Run;
use std::fmt::{self, Display};

/// A fit: the values of free quantities with which runs come nearest to measured columns, in the sense of least squares.
///
/// The runs are the caller's, so that anything may be free: parameters, start values, inputs. They have to record the measured times.
///
/// ```
/// use ezy_core::optimise::{Fit, Free, Measured};
/// use ezy_core::prelude::*;
///
/// model! {
///     pub model Cart {
///         param k: N/m = 8;
///         body cart { mass: 2, inertia: 1 }
///         slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
///         spring ground(0, 0) ~ cart(0, 0): stiffness k;
///         start aside { cart at (0.1, 0) velocity (0, 0); }
///         scene swing { start aside; until 1 s; }
///     }
/// }
/// // x = 0.1 cos(2t), measured to millimetres
/// let data = Measured::new([0.25, 0.5, 0.75, 1.0]).column("cart.x", [0.088, 0.054, 0.007, -0.042]);
/// let free = [Free::new("k", 5.0).within(0.0, f64::INFINITY)];
/// let fitted = Fit::new(free, &data, |values| {
///     let scene = cart::Swing { k: values[0], ..Default::default() };
///     Simulation::new(&scene).at(data.times().to_vec()).run()
/// })
/// .solve()?;
/// let k = &fitted.estimates[0];
/// assert!(k.interval.0 < 8.0 && 8.0 < k.interval.1, "{fitted}");
/// # Ok::<(), ezy_core::optimise::OptimiseError>(())
/// ```
pub struct Fit<'f> {
    model: Model<'f>,
}

/// Probability with which an interval holds the true value.
const CONFIDENCE: f64 = 0.95;

impl<'f> Fit<'f> {
    /// A fit of `free` to `data`; `run` makes a run with given values, in the order of `free`. Runs that fail, or stop before their end,
    /// are steps that are not taken. Runs are made on all cores.
    pub fn new<E: Display>(
        free: impl Into<Vec<Free>>,
        data: &'f Measured,
        run: impl Fn(&[f64]) -> Result<Run, E> + Sync + 'f,
    ) -> Self {
        let model =
            Model { free: free.into(), data, runs: Runs::new(run), derivatives: None, tolerance: Tolerance::DEFAULT };
        Self { model }
    }

    /// Relative error of the runs: their tolerance, from which the steps of differences follow. Without it that of
    /// [`Simulation::new`](crate::simulate::Simulation::new), 1e-9.
    #[must_use]
    pub fn tolerance(mut self, relative: f64) -> Self {
        self.model.tolerance = relative;
        self
    }

    /// Derivatives of the measured values by each free quantity in place of differences of runs: one column for each quantity, with one
    /// number for each measured value, as [`sensitivities_at`](super::sensitivities_at) gives them. `None` asks for differences.
    #[must_use]
    pub fn derivatives(mut self, derivatives: impl Fn(&[f64]) -> Option<Vec<Vec<f64>>> + Sync + 'f) -> Self {
        self.model.derivatives = Some(Box::new(derivatives));
        self
    }

    /// Finds the values, by the method of Levenberg and Marquardt, and their errors.
    ///
    /// Bounds are kept by a smooth transformation (that of MINUIT). Intervals follow from derivatives at the values that were found, as if
    /// the runs depended on them linearly; σ of the data weigh, and the size of the errors follows from the residuals.
    ///
    /// # Errors
    /// [`OptimiseError`] when data, bounds, columns or the run with the start values cannot be used.
    /// # Cost
    /// Two runs for each free quantity in each step, on all cores, and one besides.
    pub fn solve(self) -> Result<Fitted, OptimiseError> {
        let Self { model } = self;
        let (n, m) = (model.data.n_values(), model.free.len());
        model.data.checked()?;
        model.free.iter().try_for_each(Free::checked)?;
        match m {
            0 => return Err(OptimiseError::NothingFree),
            _ if n <= m => return Err(OptimiseError::TooFewValues { n_values: n, n_free: m }),
            _ => {}
        }
        model.at_start()?;
        let (values, end) = least_squares::solve(&model);
        let predicted =
            model.predicted(&values).ok_or_else(|| OptimiseError::Start { reason: model.runs.last_failure() })?;
        let r = residuals(&model, &predicted);
        let scales: Vec<f64> = model.free.iter().zip(&values).map(|(free, x)| free.scale_at(*x)).collect();
        let magnitude = norm(&predicted);
        let found = statistics(&r, &model.jacobian(&values), &scales, magnitude, model.derivative_error());
        let Statistics { residual_deviation, standard_errors, correlation, undetermined } = found;
        let quantile = two_sided_quantile(CONFIDENCE, n - m);
        let estimates =
            model.free.iter().zip(&values).zip(&standard_errors).map(|((free, &value), &standard_error)| {
                let half = quantile * standard_error;
                let at_bound = free.is_at_bound(value);
                Estimate {
                    name: free.name.clone(),
                    value,
                    standard_error,
                    interval: (value - half, value + half),
                    at_bound,
                }
            });
        let named = |set: &Vec<usize>| set.iter().map(|&j| model.free[j].name.clone()).collect();
        Ok(Fitted {
            estimates: estimates.collect(),
            correlation,
            sum_of_squares: r.iter().map(|r| r * r).sum(),
            residual_deviation,
            degrees_of_freedom: n - m,
            undetermined: undetermined.iter().map(named).collect(),
            n_runs: model.runs.n_runs(),
            n_failed: model.runs.n_failed(),
            end,
        })
    }
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// One value that a fit found.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Estimate {
    /// Name of the free quantity.
    pub name: String,
    /// The value of least squares.
    pub value: f64,
    /// Its standard error; infinite when the data do not determine it.
    pub standard_error: f64,
    /// Interval that holds the true value with a probability of 95 %, when errors are independent and normal.
    pub interval: (f64, f64),
    /// Whether it is at a bound: then the bound and not the data says what it is, and the interval means nothing.
    pub at_bound: bool,
}

/// The result of a fit. As text it is a table with remarks.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Fitted {
    /// The values, in the order of the free quantities.
    pub estimates: Vec<Estimate>,
    /// Correlation of each two values; NaN where one is not determined.
    pub correlation: Vec<Vec<f64>>,
    /// Sum of the squared residuals, each over the σ of its column.
    pub sum_of_squares: f64,
    /// Standard deviation of the residuals, each over the σ of its column: near 1 when σ was right.
    pub residual_deviation: f64,
    /// Measured values less free quantities.
    pub degrees_of_freedom: usize,
    /// Sets of quantities of which the data determine only a combination, or, of a single one, nothing.
    pub undetermined: Vec<Vec<String>>,
    /// Runs that were made, those for differences included.
    pub n_runs: usize,
    /// Runs of them that failed.
    pub n_failed: usize,
    /// Why it ended.
    pub end: FitEnd,
}

impl Fitted {
    /// What a reader of the values has to know besides.
    pub fn remarks(&self) -> Vec<String> {
        let quoted = |names: &[String]| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>();
        let mut remarks: Vec<String> = self.undetermined.iter().map(|names| match &quoted(names)[..] {
            [only] => format!("the data do not determine {only}: the measured columns do not depend on it; hold it, or measure what does"),
            names => format!(
                "the data do not determine {} separately: a change of one makes up for the others; hold one of them, or measure more",
                names.join(" and ")
            ),
        }).collect();
        for estimate in self.estimates.iter().filter(|estimate| estimate.at_bound) {
            remarks.push(format!(
                "`{}` is at a bound, where its interval means nothing; move the bound, or hold the value",
                estimate.name
            ));
        }
        if self.end != FitEnd::Converged {
            remarks.push(format!("the fit {}", self.end));
        }
        if self.n_failed > 0 {
            remarks.push(format!("{} of {} runs failed; their values were not taken", self.n_failed, self.n_runs));
        }
        remarks
    }
}

impl Display for Fitted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for Estimate { name, value, standard_error, interval: (lower, upper), .. } in &self.estimates {
            writeln!(f, "{name} = {value:.6} ± {standard_error:.2e} (95 %: {lower:.6} to {upper:.6})")?;
        }
        writeln!(
            f,
            "residuals: {:.3e} with {} degrees of freedom; {} runs",
            self.residual_deviation, self.degrees_of_freedom, self.n_runs
        )?;
        self.remarks().iter().try_for_each(|remark| writeln!(f, "remark: {remark}"))
    }
}
