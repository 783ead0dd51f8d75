//! The class `Environment`, which is written in Python and part of each module.

use crate::error::{EzyError, StoppedError};
use ezy_core::record::find_name;
use pyo3::exceptions::{PyAttributeError, PyImportError};
use pyo3::ffi::c_str;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use std::ffi::CString;

/// A class of Gymnasium's kind takes Gymnasium to be made, and the time to import it: it is made once it is asked for.
static ENVIRONMENT: PyOnceLock<Py<PyAny>> = PyOnceLock::new();

/// An attribute that the module does not have yet.
pub(crate) fn attribute(py: Python<'_>, package: &str, name: &str, known: &[String]) -> PyResult<Py<PyAny>> {
    if name == "Environment" {
        return ENVIRONMENT.get_or_try_init(py, || class(py, package)).map(|class| class.clone_ref(py));
    }
    let known = known.iter().map(String::as_str).chain(["Environment"]);
    let error = find_name("name", name, known).err();
    let why = error.map_or_else(|| format!("`{name}` is not known"), |error| error.to_string());
    Err(PyAttributeError::new_err(format!("module `{package}`: {why}")))
}

fn class(py: Python<'_>, package: &str) -> PyResult<Py<PyAny>> {
    if let Err(error) = py.import("gymnasium") {
        let missing =
            PyImportError::new_err(format!("{package}.Environment takes Gymnasium: `pip install gymnasium` ({error})"));
        missing.set_cause(py, Some(error));
        return Err(missing);
    }
    // a name of its own for each package: of the same name Python would run the text again in the module of the other
    let name = CString::new(format!("{package}._environment"))?;
    let code = c_str!(include_str!("environment.py"));
    let module = PyModule::from_code(py, code, c"ezy-python/src/environment.py", &name)?;
    module.setattr("EzyError", py.get_type::<EzyError>())?;
    module.setattr("StoppedError", py.get_type::<StoppedError>())?;
    let class = module.getattr("Environment")?;
    // where it is found again, by pickle too
    class.setattr("__module__", package)?;
    Ok(class.unbind())
}
