//! Exceptions with the text of EZY.

use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::fmt::Display;

create_exception!(
    ezy,
    EzyError,
    PyValueError,
    "A name, value or setting that cannot be used; the text says how to mend it."
);
create_exception!(
    ezy,
    StoppedError,
    EzyError,
    "A run that ended before its time; its attribute `run` has everything up to there."
);

pub(crate) fn wrong(error: impl Display) -> PyErr {
    EzyError::new_err(error.to_string())
}
