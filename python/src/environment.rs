//! The classes `Environment` and `VectorEnvironment`, which are written in Python and part of each module.

use crate::error::{EzyError, StoppedError};
use ezy_core::record::find_name;
use pyo3::exceptions::{PyAttributeError, PyImportError};
use pyo3::ffi::c_str;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use std::ffi::CString;

/// Classes of Gymnasium's kind take Gymnasium to be made, and the time to import it: they are made once one is asked for.
static MODULE: PyOnceLock<Py<PyModule>> = PyOnceLock::new();

const CLASSES: [&str; 2] = ["Environment", "VectorEnvironment"];

/// An attribute that the module does not have yet.
pub(crate) fn attribute(py: Python<'_>, package: &str, name: &str, known: &[String]) -> PyResult<Py<PyAny>> {
    if CLASSES.contains(&name) {
        let module = MODULE.get_or_try_init(py, || module(py, package, name))?;
        return module.getattr(py, name);
    }
    let known = known.iter().map(String::as_str).chain(CLASSES);
    let error = find_name("name", name, known).err();
    let why = error.map_or_else(|| format!("`{name}` is not known"), |error| error.to_string());
    Err(PyAttributeError::new_err(format!("module `{package}`: {why}")))
}

fn module(py: Python<'_>, package: &str, asked_for: &str) -> PyResult<Py<PyModule>> {
    if let Err(error) = py.import("gymnasium") {
        let missing =
            PyImportError::new_err(format!("{package}.{asked_for} takes Gymnasium: `pip install gymnasium` ({error})"));
        missing.set_cause(py, Some(error));
        return Err(missing);
    }
    // a name of its own for each package: of the same name Python would run the text again in the module of the other
    let name = CString::new(format!("{package}._environment"))?;
    let code = c_str!(include_str!("environment.py"));
    let module = PyModule::from_code(py, code, c"ezy-python/src/environment.py", &name)?;
    module.setattr("EzyError", py.get_type::<EzyError>())?;
    module.setattr("StoppedError", py.get_type::<StoppedError>())?;
    for class in CLASSES {
        // where it is found again, by pickle too
        module.getattr(class)?.setattr("__module__", package)?;
    }
    Ok(module.unbind())
}
