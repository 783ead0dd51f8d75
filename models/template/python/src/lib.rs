//! A vehicle and its scenes, as a Python module.

mod my_mechanism;

use pyo3::prelude::*;

#[pymodule(name = "my_mechanism")]
fn python_module(module: &Bound<'_, PyModule>) -> PyResult<()> {
    ezy_python::add_models(module, &[&my_mechanism::my_mechanism::MODEL])
}
