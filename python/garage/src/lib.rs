//! The models of EZY as a Python module.

use pyo3::prelude::*;

/// The models of EZY: vehicles and mechanisms with exact constraints.
#[pymodule]
fn ezy(module: &Bound<'_, PyModule>) -> PyResult<()> {
    ezy_python::add_models(module, ezy_models::registry::MODELS)
}
