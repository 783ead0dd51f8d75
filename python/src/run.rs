//! Runs as NumPy arrays by name.

use crate::error::wrong;
use crate::notebook::PyAnimation;
use ezy_core::integrate::Method;
use ezy_core::model::Scene;
use ezy_core::record::{Column, columns, find_name};
use ezy_core::simulate::Run;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A finished run: a mapping from the names of columns to arrays with a number for each sample.
#[pyclass(frozen, name = "Run", module = "ezy", mapping)]
pub(crate) struct PyRun {
    run: Run,
    scene: Arc<dyn Scene>,
    method: Method,
    columns: Vec<Column>,
    /// Column after column.
    values: Vec<Py<PyArray1<f64>>>,
}

impl PyRun {
    pub(crate) fn new(run: Run, scene: Arc<dyn Scene>, method: Method) -> Self {
        let columns = columns(run.info(), run.first().wanted);
        let n = run.samples().len();
        let mut numbers: Vec<Vec<f64>> = columns.iter().map(|_| Vec::with_capacity(n)).collect();
        for sample in run.samples() {
            numbers.iter_mut().zip(sample.numbers()).for_each(|(column, x)| column.push(x));
        }
        let values =
            Python::attach(|py| numbers.into_iter().map(|column| PyArray1::from_vec(py, column).unbind()).collect());
        Self { run, scene, method, columns, values }
    }

    fn names(&self) -> impl Iterator<Item = &str> + Clone {
        self.columns.iter().map(|column| column.name.as_str())
    }
}

#[pymethods]
impl PyRun {
    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyArray1<f64>>> {
        let i = find_name("column", name, self.names()).map_err(wrong)?;
        Ok(self.values[i].clone_ref(py))
    }

    fn __len__(&self) -> usize {
        self.columns.len()
    }

    fn __contains__(&self, name: &str) -> bool {
        self.names().any(|known| known == name)
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        Ok(self.keys(py)?.try_iter()?.into_any())
    }

    /// Names of the columns.
    fn keys<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.names())
    }

    /// Names and arrays.
    fn items<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.names().zip(self.values.iter().map(|values| values.clone_ref(py))))
    }

    /// A dictionary of the arrays: `pandas.DataFrame(run.to_dict())`.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        self.names().zip(&self.values).try_for_each(|(name, values)| all.set_item(name, values.clone_ref(py)))?;
        Ok(all)
    }

    /// Times of the samples, s.
    #[getter]
    fn t(&self, py: Python<'_>) -> Py<PyArray1<f64>> {
        self.values[0].clone_ref(py)
    }

    /// Units of the columns, by name.
    #[getter]
    fn units(&self) -> BTreeMap<&str, &str> {
        self.columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect()
    }

    /// How it ended.
    #[getter]
    fn outcome(&self) -> String {
        self.run.outcome.to_string()
    }

    /// Times, s, and names of the events.
    #[getter]
    fn events(&self) -> Vec<(f64, &'static str)> {
        self.run.events().iter().map(|of| (of.state.t, of.event.name)).collect()
    }

    /// Steps, evaluations and seconds of a processor that it took.
    #[getter]
    fn cost(&self) -> BTreeMap<&'static str, f64> {
        let cost = &self.run.cost;
        let counts = [("steps", cost.steps), ("rejected", cost.rejected), ("evaluations", cost.evaluations)];
        let counts = counts.into_iter().map(|(name, n)| (name, n as f64));
        counts.chain([("processor_seconds", cost.processor_seconds)]).collect()
    }

    /// With `estimate=True` the largest error of positions, velocities and so on, each in its unit; a text where there is no estimate.
    #[getter]
    fn estimate<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        match &self.run.error_estimate {
            None => Ok(None),
            Some(Err(why)) => Ok(Some(why.to_string().into_pyobject(py)?.into_any())),
            Some(Ok(estimate)) => {
                let all = PyDict::new(py);
                for of in &estimate.errors {
                    all.set_item(format!("{} [{}]", of.quantity, of.unit), of.largest)?;
                }
                all.set_item("amplification", estimate.amplification)?;
                Ok(Some(all.into_any()))
            }
        }
    }

    /// An animation of the run, with a frame for each sample. A notebook shows it, and `save(path)` writes it.
    fn animation(&self, py: Python<'_>) -> PyResult<PyAnimation> {
        py.detach(|| PyAnimation::new(&*self.scene, &self.run, self.method))
    }

    fn __repr__(&self) -> String {
        let info = self.run.info();
        let n = self.run.samples().len();
        format!("<run of {}/{}: {n} samples, {}>", info.model, info.name, self.run.outcome)
    }
}
