//! Inputs, numbers and times from Python.

use crate::error::wrong;
use ezy_core::simulate::InputTable;
use pyo3::prelude::*;
use pyo3::types::PyMapping;

/// Name and value of each entry.
fn entries<'py>(given: Option<&Bound<'py, PyMapping>>) -> PyResult<Vec<(String, Bound<'py, PyAny>)>> {
    given.map_or(Ok(Vec::new()), |given| given.items()?.extract())
}

/// Name and number of each entry.
pub(crate) fn numbers(given: Option<&Bound<'_, PyMapping>>) -> PyResult<Vec<(String, f64)>> {
    let of = |(name, value): (String, Bound<'_, PyAny>)| {
        let value = value.extract().map_err(|_| wrong(format!("`{name}` takes a number, but was given {value}")))?;
        Ok((name, value))
    };
    entries(given)?.into_iter().map(of).collect()
}

/// A constant, or a pair of times and values: the input is linear between them and keeps the last value.
pub(crate) fn tables(given: Option<&Bound<'_, PyMapping>>) -> PyResult<Vec<(String, InputTable)>> {
    let of = |(name, value): (String, Bound<'_, PyAny>)| {
        if let Ok(value) = value.extract::<f64>() {
            return Ok((name, InputTable::from(value)));
        }
        let (times, values): (Vec<f64>, Vec<f64>) = value.extract().map_err(|_| {
            wrong(format!("input `{name}` takes a number, or times and values, such as ([0, 1], [0.0, 0.3]), but was given {value}"))
        })?;
        let table = InputTable::new(times, values).map_err(|error| wrong(format!("input `{name}`: {error}")))?;
        Ok((name, table))
    };
    entries(given)?.into_iter().map(of).collect()
}
