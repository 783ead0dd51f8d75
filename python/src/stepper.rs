//! Scenes that are stepped from outside.

use crate::error::{StoppedError, wrong};
use crate::inputs::numbers;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::{find_name, input_index};
use ezy_core::simulate::{Checkpoint, Stepper};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, PoisonError};

/// A scene in fixed steps. Inputs hold until they are set again.
#[pyclass(name = "Stepper", module = "ezy")]
pub(crate) struct PyStepper {
    /// Locked because Python may call from any thread.
    stepper: Mutex<Stepper<'static, Arc<dyn Scene>>>,
    places: Places,
}

/// Where a number of a stepper is.
#[derive(Clone, Copy)]
pub(crate) enum Place {
    Time,
    Coordinate(usize),
    Velocity(usize),
    Output(usize),
    Input(usize),
}

/// The names that a stepper can be asked for, in this order, and their places.
pub(crate) struct Places {
    names: Vec<String>,
    places: Vec<Place>,
    by_name: HashMap<String, Place>,
}

impl Places {
    pub(crate) fn new(info: &SceneInfo) -> Self {
        let mut all = vec![("t".to_owned(), Place::Time)];
        all.extend(info.coordinates.iter().enumerate().map(|(i, c)| (c.name.to_string(), Place::Coordinate(i))));
        all.extend(info.velocities.iter().enumerate().map(|(i, c)| (c.name.to_string(), Place::Velocity(i))));
        all.extend(info.outputs.iter().enumerate().map(|(i, o)| (o.name.to_string(), Place::Output(i))));
        all.extend(info.inputs.iter().enumerate().map(|(i, o)| (o.name.to_owned(), Place::Input(i))));
        // of two that share a name the first is meant, as in the columns of a run
        let by_name = all.iter().rev().cloned().collect();
        let (names, places) = all.into_iter().unzip();
        Self { names, places, by_name }
    }

    pub(crate) fn find(&self, name: &str) -> PyResult<Place> {
        if let Some(place) = self.by_name.get(name) {
            return Ok(*place);
        }
        let known = self.names.iter().map(String::as_str);
        Ok(self.places[find_name("name", name, known).map_err(wrong)?])
    }
}

/// The present value at a place.
pub(crate) fn value(stepper: &mut Stepper<'static, Arc<dyn Scene>>, place: Place) -> f64 {
    match place {
        Place::Time => stepper.state().t,
        Place::Coordinate(i) => stepper.state().q[i],
        Place::Velocity(i) => stepper.state().v[i],
        Place::Output(i) => stepper.outputs()[i],
        Place::Input(i) => stepper.inputs()[i],
    }
}

/// Names of coordinates, velocities and outputs.
pub(crate) fn names(info: &SceneInfo) -> BTreeMap<&'static str, Vec<String>> {
    let of = |all: &mut dyn Iterator<Item = String>| all.collect::<Vec<_>>();
    BTreeMap::from([
        ("q", of(&mut info.coordinates.iter().map(|c| c.name.to_string()))),
        ("v", of(&mut info.velocities.iter().map(|c| c.name.to_string()))),
        ("outputs", of(&mut info.outputs.iter().map(|c| c.name.to_string()))),
    ])
}

/// Where a stepper was: from there the same steps lead to the same bits.
#[pyclass(frozen, name = "Checkpoint", module = "ezy")]
pub(crate) struct PyCheckpoint {
    checkpoint: Checkpoint,
}

impl PyStepper {
    pub(crate) fn new(stepper: Stepper<'static, Arc<dyn Scene>>) -> Self {
        let places = Places::new(stepper.info());
        Self { stepper: Mutex::new(stepper), places }
    }

    /// `&mut self` excludes others: there is nothing to wait for.
    fn inner(&mut self) -> &mut Stepper<'static, Arc<dyn Scene>> {
        self.stepper.get_mut().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl PyStepper {
    /// Sets inputs by name, takes `n` steps, and returns the time, s.
    #[pyo3(signature = (n=1, **inputs))]
    fn step(&mut self, py: Python<'_>, n: u64, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<f64> {
        self.set(inputs)?;
        let stepper = self.inner();
        py.detach(|| stepper.step(n)).map_err(|error| StoppedError::new_err(error.to_string()))?;
        Ok(self.inner().state().t)
    }

    /// Sets inputs by name; none of them where one cannot be set.
    #[pyo3(signature = (**inputs))]
    fn set(&mut self, inputs: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        let info = Arc::clone(self.inner().info());
        let of = |(name, value): (String, f64)| {
            if !value.is_finite() {
                return Err(wrong(format!("input `{name}` takes a finite number, but was given {value}")));
            }
            Ok((input_index(&info, &name).map_err(wrong)?, value))
        };
        let all = numbers(inputs.map(|all| all.as_mapping()))?.into_iter().map(of).collect::<PyResult<Vec<_>>>()?;
        all.into_iter().for_each(|(i, value)| self.inner().inputs_mut()[i] = value);
        Ok(())
    }

    /// Goes back to the start, with these values by name if there are any.
    #[pyo3(signature = (start=None))]
    fn reset(&mut self, start: Option<&Bound<'_, PyMapping>>) -> PyResult<()> {
        let start = numbers(start)?;
        if start.is_empty() {
            self.inner().reset();
            return Ok(());
        }
        let given: Vec<(&str, f64)> = start.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        self.inner().reset_with(&given).map_err(wrong)
    }

    /// The present value of a coordinate, velocity, output or input, or of the time `t`, by its name.
    fn __getitem__(&mut self, name: &str) -> PyResult<f64> {
        let place = self.places.find(name)?;
        Ok(value(self.inner(), place))
    }

    /// Where it is now.
    fn save(&mut self) -> PyCheckpoint {
        PyCheckpoint { checkpoint: self.inner().save() }
    }

    /// Goes to where it was saved.
    fn restore(&mut self, checkpoint: &PyCheckpoint) -> PyResult<()> {
        self.inner().restore(&checkpoint.checkpoint).map_err(wrong)
    }

    /// Time, s.
    #[getter]
    fn t(&mut self) -> f64 {
        self.inner().state().t
    }

    /// Coordinates, in the order of `names`.
    #[getter]
    fn q<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.inner().state().q)
    }

    /// Velocities.
    #[getter]
    fn v<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, &self.inner().state().v)
    }

    /// Outputs, with the present inputs.
    #[getter]
    fn outputs<'py>(&mut self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.inner().outputs())
    }

    /// Present inputs by name.
    #[getter]
    fn inputs(&mut self) -> BTreeMap<&'static str, f64> {
        let info = Arc::clone(self.inner().info());
        info.inputs.iter().map(|input| input.name).zip(self.inner().inputs().iter().copied()).collect()
    }

    /// Names of coordinates, velocities and outputs.
    #[getter]
    fn names(&mut self) -> BTreeMap<&'static str, Vec<String>> {
        names(self.inner().info())
    }

    fn __repr__(&mut self) -> String {
        let info = Arc::clone(self.inner().info());
        format!("<stepper of {}/{} at t = {} s>", info.model, info.name, self.inner().state().t)
    }
}
