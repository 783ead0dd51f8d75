//! Inputs, numbers and times from Python.

use crate::error::wrong;
use ezy_core::simulate::InputTable;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Name and number of each entry.
pub(crate) fn numbers(given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, f64)>> {
    let of = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        let value = value.extract().map_err(|_| wrong(format!("`{name}` takes a number, but was given {value}")))?;
        Ok((name, value))
    };
    given.into_iter().flatten().map(of).collect()
}

/// A constant, or a pair of times and values: the input is linear between them and keeps the last value.
pub(crate) fn tables(given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, InputTable)>> {
    let of = |(name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        if let Ok(value) = value.extract::<f64>() {
            return Ok((name, InputTable::from(value)));
        }
        let (times, values): (Vec<f64>, Vec<f64>) = value.extract().map_err(|_| {
            wrong(format!("input `{name}` takes a number, or times and values, such as ([0, 1], [0.0, 0.3]), but was given {value}"))
        })?;
        let table = InputTable::new(times, values).map_err(|error| wrong(format!("input `{name}`: {error}")))?;
        Ok((name, table))
    };
    given.into_iter().flatten().map(of).collect()
}
