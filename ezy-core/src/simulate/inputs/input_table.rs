//! An input given by a table of times and values.

/// Values at given times, with straight lines between them; before the first time the first value holds, after the last
/// one the last. Two values at one time are a jump.
///
/// ```
/// use ezy_core::simulate::InputTable;
///
/// let ramp = InputTable::new(vec![0.0, 2.0], vec![0.0, 10.0])?;
/// assert_eq!(ramp.at(0.5), 2.5);
/// let switched = InputTable::held(vec![0.0, 1.0], vec![5.0, -5.0])?;
/// assert_eq!((switched.at(0.999), switched.at(1.0)), (5.0, -5.0));
/// # Ok::<(), ezy_core::simulate::TableError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct InputTable {
    times: Vec<f64>,
    values: Vec<f64>,
}

/// A table that cannot be used.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// No row, or more times than values, or the other way round.
    #[error("the table has {n_times} times and {n_values} values; give as many values as times, and at least one")]
    Lengths {
        /// Number of times.
        n_times: usize,
        /// Number of values.
        n_values: usize,
    },
    /// A number is NaN or infinite.
    #[error("row {row} of the table is {value} at t = {t} s; give finite numbers")]
    NotFinite {
        /// Counted from one.
        row: usize,
        /// Its time, s.
        t: f64,
        /// Its value.
        value: f64,
    },
    /// Times go back.
    #[error("row {row} of the table is at {t} s, before the row above it; sort the rows by time")]
    Backwards {
        /// Counted from one.
        row: usize,
        /// Its time, s.
        t: f64,
    },
    /// Of three values at one time the middle one has no meaning.
    #[error(
        "row {row} of the table is the third one at {t} s; a jump has two rows, the value before it and the one behind it"
    )]
    Third {
        /// Counted from one.
        row: usize,
        /// Its time, s.
        t: f64,
    },
}

impl InputTable {
    /// From times in s, ascending, and values in the unit of the input.
    ///
    /// # Errors
    /// [`TableError`] naming the row.
    pub fn new(times: Vec<f64>, values: Vec<f64>) -> Result<Self, TableError> {
        let table = Self::ascending(times, values)?;
        match table.times.windows(3).position(|three| three[0] == three[2]) {
            Some(i) => Err(TableError::Third { row: i + 3, t: table.times[i] }),
            None => Ok(table),
        }
    }

    fn ascending(times: Vec<f64>, values: Vec<f64>) -> Result<Self, TableError> {
        if times.len() != values.len() || times.is_empty() {
            return Err(TableError::Lengths { n_times: times.len(), n_values: values.len() });
        }
        for (i, (&t, &value)) in times.iter().zip(&values).enumerate() {
            if !(t.is_finite() && value.is_finite()) {
                return Err(TableError::NotFinite { row: i + 1, t, value });
            }
            if i > 0 && t < times[i - 1] {
                return Err(TableError::Backwards { row: i + 1, t });
            }
        }
        Ok(Self { times, values })
    }

    /// Time of the first value, s; of a value that is the same at all times, negative infinity.
    pub fn begin(&self) -> f64 {
        self.times[0]
    }

    /// The same, but each value holds until the next time.
    ///
    /// # Errors
    /// [`TableError`] naming the row.
    pub fn held(times: Vec<f64>, values: Vec<f64>) -> Result<Self, TableError> {
        let Self { times, values } = Self::ascending(times, values)?;
        let twice = |x: &[f64]| x.iter().flat_map(|&x| [x, x]).collect::<Vec<f64>>();
        let (times, values) = (twice(&times), twice(&values));
        Ok(Self { times: times[1..].to_vec(), values: values[..values.len() - 1].to_vec() })
    }

    /// The value, when it is the same at all times.
    pub(in crate::simulate) fn constant(&self) -> Option<f64> {
        if let [value] = self.values[..] { Some(value) } else { None }
    }

    /// The value at `t`; at a jump, the one behind it.
    pub fn at(&self, t: f64) -> f64 {
        let (times, values) = (&self.times, &self.values);
        let after = times.partition_point(|&row| row <= t);
        if after == 0 {
            return values[0];
        }
        if after == times.len() {
            return values[after - 1];
        }
        let (t0, t1) = (times[after - 1], times[after]);
        values[after - 1] + (t - t0) / (t1 - t0) * (values[after] - values[after - 1])
    }
}

impl From<f64> for InputTable {
    /// The same value at all times.
    fn from(value: f64) -> Self {
        Self { times: vec![f64::NEG_INFINITY], values: vec![value] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_values_between_beside_and_at_jumps() {
        let table = InputTable::new(vec![1.0, 3.0, 3.0, 4.0], vec![2.0, 6.0, -1.0, 0.0]).unwrap();
        for (t, value) in [(0.0, 2.0), (1.0, 2.0), (2.5, 5.0), (3.0, -1.0), (3.25, -0.75), (4.0, 0.0), (9.0, 0.0)] {
            assert_eq!(table.at(t), value, "at {t}");
        }
        let held = InputTable::held(vec![1.0, 3.0, 4.0], vec![2.0, 6.0, 5.0]).unwrap();
        for (t, value) in [(0.0, 2.0), (2.9, 2.0), (3.0, 6.0), (3.9, 6.0), (4.0, 5.0), (9.0, 5.0)] {
            assert_eq!(held.at(t), value, "held, at {t}");
        }
        assert_eq!(
            (table.constant(), InputTable::from(3.0).constant(), InputTable::from(3.0).at(-1.0)),
            (None, Some(3.0), 3.0)
        );
    }

    #[test]
    fn invariant_tables_that_cannot_be_used_name_the_row() {
        let table = |times: &[f64], values: &[f64]| InputTable::new(times.to_vec(), values.to_vec()).unwrap_err();
        assert_eq!(table(&[0.0], &[]), TableError::Lengths { n_times: 1, n_values: 0 });
        assert_eq!(table(&[], &[]), TableError::Lengths { n_times: 0, n_values: 0 });
        assert_eq!(table(&[0.0, 1.0, 0.5], &[0.0; 3]), TableError::Backwards { row: 3, t: 0.5 });
        assert_eq!(
            table(&[0.0, 1.0], &[0.0, f64::INFINITY]),
            TableError::NotFinite { row: 2, t: 1.0, value: f64::INFINITY }
        );
        assert_eq!(table(&[0.0, 1.0, 1.0, 1.0], &[0.0; 4]), TableError::Third { row: 4, t: 1.0 });
        assert!(matches!(table(&[f64::NAN], &[1.0]), TableError::NotFinite { row: 1, .. }));
    }
}
