//! Inputs, numbers and times from Python.

use crate::error::wrong;
use ezy_core::simulate::InputTable;
use numpy::{AllowTypeChange, PyArrayLikeDyn};
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

/// Name and numbers of each entry.
pub(crate) fn lists(given: &Bound<'_, PyMapping>) -> PyResult<Vec<(String, Vec<f64>)>> {
    let of = |(name, values): (String, Bound<'_, PyAny>)| {
        let numbers: Option<PyArrayLikeDyn<'_, f64, AllowTypeChange>> = values.extract().ok();
        match numbers.as_ref().map(|numbers| numbers.as_array()).filter(|numbers| numbers.ndim() <= 1) {
            Some(numbers) => Ok((name, numbers.iter().copied().collect())),
            None => Err(wrong(format!("`{name}` takes numbers, such as [1, 2, 3], but was given {values}"))),
        }
    };
    entries(Some(given))?.into_iter().map(of).collect()
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

/// Numbers by name, for the members of a batch.
pub(crate) type Numbers = Vec<(String, Values)>;

/// A number for all members of a batch, or one for each.
pub(crate) enum Values {
    Same(f64),
    Each(Vec<f64>),
}

impl Values {
    /// That of member `i`.
    pub(crate) fn at(&self, i: usize) -> f64 {
        match self {
            Self::Same(value) => *value,
            Self::Each(values) => values[i],
        }
    }
}

/// Name and numbers of each entry, for `n` members.
pub(crate) fn numbers_of_members(given: Option<&Bound<'_, PyMapping>>, n: usize) -> PyResult<Numbers> {
    let of = |(name, value): (String, Bound<'_, PyAny>)| {
        let fault =
            |what: &str| wrong(format!("`{name}` takes a number, or an array of {n} numbers, but was given {what}"));
        let values: PyArrayLikeDyn<'_, f64, AllowTypeChange> =
            value.extract().map_err(|_| fault(&value.to_string()))?;
        let values = values.as_array();
        let values = match *values.shape() {
            [] => Values::Same(values.sum()),
            [length] if length == n => Values::Each(values.iter().copied().collect()),
            ref shape => return Err(fault(&format!("one of the shape {shape:?}"))),
        };
        Ok((name, values))
    };
    entries(given)?.into_iter().map(of).collect()
}
