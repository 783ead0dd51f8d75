//! Models, and scenes that are not made yet.

use crate::error::wrong;
use crate::scene::PyScene;
use ezy_core::model::{ModelInfo, ParameterInfo, SceneEntry};
use ezy_core::record::find_name;
use pyo3::exceptions::PyAttributeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use std::collections::BTreeMap;

/// A model: its scenes are attributes.
#[pyclass(frozen, subclass, module = "ezy")]
pub(crate) struct Model {
    info: &'static ModelInfo,
}

impl Model {
    pub(crate) fn new(info: &'static ModelInfo) -> Self {
        Self { info }
    }

    /// As it is typed.
    pub(crate) fn module_name(&self) -> String {
        self.info.name.to_lowercase()
    }

    pub(crate) fn names(&self) -> impl Iterator<Item = &'static str> + Clone + use<> {
        self.info.scenes.iter().map(|entry| entry.name)
    }

    pub(crate) fn scene(&self, name: &str) -> PyResult<SceneType> {
        let i = find_name("scene", name, self.names()).map_err(|error| PyAttributeError::new_err(error.to_string()))?;
        Ok(SceneType { model: self.info, entry: &self.info.scenes[i] })
    }
}

#[pymethods]
impl Model {
    /// Name of the model.
    #[getter]
    fn name(&self) -> &'static str {
        self.info.name
    }

    /// What the model file says of it.
    #[getter(__doc__)]
    fn documentation(&self) -> &'static str {
        self.info.documentation
    }

    /// Its scenes, in declared order.
    #[getter]
    fn scenes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        PyList::new(py, self.names())
    }

    fn __getattr__(&self, name: &str) -> PyResult<SceneType> {
        self.scene(name)
    }

    fn __dir__(&self) -> Vec<&'static str> {
        self.names().chain(["name", "scenes"]).collect()
    }

    fn __repr__(&self) -> String {
        format!("<model {}: {}>", self.info.name, self.names().collect::<Vec<_>>().join(", "))
    }
}

/// A scene without parameters yet; called with some, it makes the scene.
#[pyclass(frozen, subclass, module = "ezy")]
pub(crate) struct SceneType {
    model: &'static ModelInfo,
    entry: &'static SceneEntry,
}

type Declared = BTreeMap<String, (f64, String, String)>;

fn declared(all: &[ParameterInfo]) -> Declared {
    let of = |of: &ParameterInfo| (of.name.to_owned(), (of.default, of.unit.to_owned(), of.documentation.to_owned()));
    all.iter().map(of).collect()
}

#[pymethods]
impl SceneType {
    /// Name of the scene.
    #[getter]
    fn name(&self) -> &'static str {
        self.entry.name
    }

    /// Name, default, unit and meaning of each parameter.
    #[getter]
    fn parameters(&self) -> Declared {
        declared((self.entry.info)().parameters)
    }

    /// Name, default, unit and meaning of each input.
    #[getter]
    fn inputs(&self) -> Declared {
        declared((self.entry.info)().inputs)
    }

    /// Names and defaults of the counts.
    #[getter]
    fn counts(&self) -> BTreeMap<&'static str, usize> {
        (self.entry.info)().counts().iter().map(|count| (count.name, count.default)).collect()
    }

    /// The scene with these parameters and counts.
    #[pyo3(signature = (**parameters))]
    fn __call__(&self, parameters: Option<&Bound<'_, PyDict>>) -> PyResult<PyScene> {
        let mut scene = (self.entry.new)();
        let info = (self.entry.info)();
        let counts = info.counts();
        let names = info.parameters.iter().map(|known| known.name).chain(counts.iter().map(|known| known.name));
        for (name, value) in parameters.into_iter().flatten() {
            let name: String = name.extract()?;
            let i = find_name("parameter", &name, names.clone()).map_err(wrong)?;
            let number = |wanted: &str| wrong(format!("`{name}` takes {wanted}, but was given {value}"));
            match i.checked_sub(info.parameters.len()) {
                None => {
                    let value: f64 = value.extract().map_err(|_| number("a number"))?;
                    scene.set_parameter(i, value);
                }
                Some(i) => {
                    let n: usize = value.extract().map_err(|_| number("a whole number from 1 on"))?;
                    if n == 0 {
                        return Err(number("a whole number from 1 on"));
                    }
                    scene.set_count(i, n);
                }
            }
        }
        Ok(PyScene::new(self.model, self.entry, scene.into()))
    }

    fn __repr__(&self) -> String {
        format!("<scene {}.{}>", self.model.name.to_lowercase(), self.entry.name)
    }
}
