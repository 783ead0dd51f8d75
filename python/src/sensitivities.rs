//! Derivatives of runs by parameters and start values.

use crate::error::wrong;
use ezy_core::record::find_name;
use numpy::{PyArray1, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use std::collections::BTreeMap;

/// A run with the derivatives of coordinates, velocities and first-order states by some quantities, at each sample.
#[pyclass(frozen, name = "Sensitivities", module = "ezy")]
pub(crate) struct PySensitivities {
    scene: String,
    /// Names and units of what is differentiated.
    columns: Vec<(String, String)>,
    /// Names and units of what it is differentiated by.
    by: Vec<(String, String)>,
    t: Vec<f64>,
    /// Sample after sample, a number for each column.
    values: Vec<f64>,
    /// For each of `by` as the values.
    derivatives: Vec<Vec<f64>>,
}

/// A column, or a column and what it is differentiated by.
#[derive(FromPyObject)]
enum Key {
    Value(String),
    Derivative(String, String),
}

impl PySensitivities {
    fn column(&self, name: &str) -> PyResult<usize> {
        find_name("coordinate, velocity or state", name, self.columns.iter().map(|of| of.0.as_str())).map_err(wrong)
    }

    fn numbers<'n>(&self, numbers: &'n [f64], column: usize) -> impl Iterator<Item = f64> + 'n {
        numbers.iter().skip(column).step_by(self.columns.len()).copied()
    }
}

#[pymethods]
impl PySensitivities {
    /// The values of a column by its name; with a pair of names its derivatives: `found["bar.phi", "m0"]`.
    fn __getitem__<'py>(&self, py: Python<'py>, key: Key) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let numbers = match key {
            Key::Value(column) => self.numbers(&self.values, self.column(&column)?),
            Key::Derivative(column, by) => {
                let column = self.column(&column)?;
                let by = find_name("quantity", &by, self.by.iter().map(|of| of.0.as_str())).map_err(wrong)?;
                self.numbers(&self.derivatives[by], column)
            }
        };
        Ok(PyArray1::from_iter(py, numbers))
    }

    /// Derivatives of these columns, all if none are named: an array of samples × columns × quantities.
    #[pyo3(signature = (*columns))]
    fn jacobian<'py>(&self, py: Python<'py>, columns: Vec<String>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let places = match columns.is_empty() {
            true => (0..self.columns.len()).collect(),
            false => columns.iter().map(|name| self.column(name)).collect::<PyResult<Vec<_>>>()?,
        };
        let (n, derivatives) = (self.columns.len(), &self.derivatives);
        let of_sample =
            |sample: usize| places.iter().flat_map(move |i| derivatives.iter().map(move |of| of[sample * n + i]));
        let numbers = PyArray1::from_iter(py, (0..self.t.len()).flat_map(of_sample));
        numbers.reshape([self.t.len(), places.len(), self.by.len()])
    }

    /// Times of the samples, s.
    #[getter]
    fn t<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.t)
    }

    /// Names of the columns: coordinates, velocities and first-order states.
    #[getter]
    fn columns(&self) -> Vec<&str> {
        self.columns.iter().map(|of| of.0.as_str()).collect()
    }

    /// Names of the quantities that it is differentiated by.
    #[getter]
    fn by(&self) -> Vec<&str> {
        self.by.iter().map(|of| of.0.as_str()).collect()
    }

    /// Units of columns and quantities, by name; a derivative has the one over the other.
    #[getter]
    fn units(&self) -> BTreeMap<&str, &str> {
        self.columns.iter().chain(&self.by).map(|(name, unit)| (name.as_str(), unit.as_str())).collect()
    }

    fn __repr__(&self) -> String {
        let by: Vec<&str> = self.by();
        format!("<derivatives of a run of {} by {}: {} samples>", self.scene, by.join(", "), self.t.len())
    }
}

#[cfg(feature = "analysis")]
mod computed {
    use super::{PySensitivities, Samples};
    use crate::error::{StoppedError, wrong};
    use crate::motion::Motion;
    use crate::signals::watched;
    use ezy_core::model::{N_DERIVATIVES, Scene, SceneInfo};
    use ezy_core::record::find_name;
    use ezy_core::simulate::{Sensitivities, SetupError};
    use pyo3::prelude::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Derivatives at all samples, which fill 1.6 GB.
    const MOST_NUMBERS: f64 = 2e8;

    /// Of one run: what more of them hold is not looked at.
    const MOST_SAMPLES: f64 = 1e6;

    impl Samples {
        /// Of a run from `start_s` to `until_s`.
        fn times(&self, start_s: f64, until_s: f64) -> PyResult<Vec<f64>> {
            match self {
                Self::At(times) => {
                    let is_sorted = times.is_sorted() && times.iter().all(|t| t.is_finite() && *t >= start_s);
                    let is_within = times.last().is_none_or(|last| *last <= until_s);
                    (is_sorted && is_within).then(|| times.clone()).ok_or_else(|| {
                        wrong(format!("`at` takes times in ascending order, from the start at {start_s} s to the end at {until_s} s"))
                    })
                }
                Self::Every(_) if until_s == start_s => Ok(vec![start_s]),
                Self::Every(_) if !(until_s > start_s && until_s.is_finite()) => Err(wrong(format!(
                    "`until` takes a time from the start at {start_s} s on, but was given {until_s}"
                ))),
                Self::Every(every_s) => {
                    if !(*every_s > 0.0 && every_s.is_finite()) {
                        return Err(wrong(format!("`every` takes a time above 0 s, but was given {every_s}")));
                    }
                    // the last one may be the end, but for rounding
                    let n = ((until_s - start_s) / every_s * (1.0 - 4.0 * f64::EPSILON)).ceil().max(0.0);
                    if n > MOST_SAMPLES {
                        return Err(wrong(format!(
                            "{n:.1e} samples {every_s} s apart lie between the start and the end, and {MOST_SAMPLES:.0e} are possible"
                        )));
                    }
                    Ok((0..n as usize).map(|i| start_s + i as f64 * every_s).chain([until_s]).collect())
                }
            }
        }
    }

    pub(crate) fn sensitivities(
        py: Python<'_>,
        scene: &Arc<dyn Scene>,
        motion: &Motion,
        by: &[String],
        samples: &Samples,
    ) -> PyResult<PySensitivities> {
        if by.is_empty() {
            return Err(wrong(
                "`by` names nothing; give names of parameters and start values, such as [\"m0\", \"bar.phi\"]",
            ));
        }
        let flag = AtomicBool::new(false);
        watched(py, &flag, || {
            let info = scene.info();
            let mut found = PySensitivities {
                scene: format!("{}/{}", info.model, info.name),
                columns: columns(&info),
                by: by.iter().map(|name| quantity(&info, name)).collect::<PyResult<_>>()?,
                t: Vec::new(),
                values: Vec::new(),
                derivatives: Vec::new(),
            };
            for by in by.chunks(N_DERIVATIVES) {
                let by: Vec<&str> = by.iter().map(String::as_str).collect();
                let (system, start) = motion.simulation(Arc::clone(scene)).system_at_start().map_err(wrong)?;
                let times = samples.times(start.t, motion.end(&**scene))?;
                let n_numbers = times.len() as f64 * (found.columns.len() * found.by.len()) as f64;
                if n_numbers > MOST_NUMBERS {
                    return Err(wrong(format!(
                        "{n_numbers:.1e} derivatives are asked for, and {MOST_NUMBERS:.0e} are possible; give fewer samples or quantities"
                    )));
                }
                let mut run = Sensitivities::of_scene(system, &start, &by, motion.method).map_err(of_setup)?;
                found.values.clear();
                let mut of_group = vec![Vec::with_capacity(times.len() * found.columns.len()); by.len()];
                for &t in &times {
                    if flag.load(Ordering::Relaxed) {
                        break;
                    }
                    run.advance_unless(t, &flag).map_err(|error| StoppedError::new_err(error.to_string()))?;
                    let state = run.state();
                    found.values.extend(state.q.iter().chain(&state.v).chain(&state.z));
                    for (of, tangent) in of_group.iter_mut().zip(run.tangents()) {
                        of.extend(tangent.q.iter().chain(&tangent.v).chain(&tangent.z));
                    }
                }
                found.derivatives.extend(of_group);
                found.t = times;
            }
            Ok(found)
        })?
    }

    fn of_setup(error: SetupError) -> PyErr {
        match error {
            SetupError::Motion(error) => StoppedError::new_err(error.to_string()),
            error => wrong(error),
        }
    }

    /// Names and units of coordinates, velocities and first-order states.
    fn columns(info: &SceneInfo) -> Vec<(String, String)> {
        let moving =
            info.coordinates.iter().chain(&*info.velocities).map(|of| (of.name.to_string(), of.unit.to_string()));
        moving.chain(info.states.iter().map(|of| (format!("state.{}", of.name), of.unit.to_owned()))).collect()
    }

    /// Name and unit of a parameter or start value.
    fn quantity(info: &SceneInfo, name: &str) -> PyResult<(String, String)> {
        let parameters = info.parameters.iter().map(|of| (of.name.to_owned(), of.unit.to_owned()));
        let moving = columns(info).into_iter().take(info.n_coordinates() + info.n_velocities());
        let states = info.states.iter().map(|of| (of.name.to_owned(), of.unit.to_owned()));
        let all: Vec<_> = parameters.chain(moving).chain(states).collect();
        let i = find_name("parameter or start value", name, all.iter().map(|of| of.0.as_str())).map_err(wrong)?;
        Ok(all[i].clone())
    }
}

#[cfg(feature = "analysis")]
pub(crate) use computed::sensitivities;

#[cfg(not(feature = "analysis"))]
pub(crate) fn sensitivities(
    _: Python<'_>,
    _: &std::sync::Arc<dyn ezy_core::model::Scene>,
    _: &crate::motion::Motion,
    _: &[String],
    _: &Samples,
) -> PyResult<PySensitivities> {
    Err(crate::analysis::missing())
}

/// Where samples are.
#[cfg_attr(not(feature = "analysis"), expect(dead_code, reason = "sensitivities are of that feature"))]
pub(crate) enum Samples {
    /// Interval, s.
    Every(f64),
    /// Times, s.
    At(Vec<f64>),
}
