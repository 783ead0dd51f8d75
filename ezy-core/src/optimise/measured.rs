//! Measured columns over time.

use super::OptimiseError;
use crate::record::LimitedReader;
use std::io::Read;

/// Measured columns at common times. Where a value is NaN nothing was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    times_s: Vec<f64>,
    pub(super) columns: Vec<MeasuredColumn>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct MeasuredColumn {
    pub name: String,
    pub values: Vec<f64>,
    /// Standard deviation of the values, in their unit.
    pub sigma: f64,
}

/// One measured value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<'m> {
    pub t: f64,
    pub column: &'m MeasuredColumn,
    pub value: f64,
}

impl Measured {
    /// Times of the measurement, s, without a column yet.
    pub fn new(times_s: impl Into<Vec<f64>>) -> Self {
        Self { times_s: times_s.into(), columns: Vec::new() }
    }

    /// Adds a column with the name that it has in a run: `rod.phi`, `output.height`; one value for each time, in the unit of the run.
    #[must_use]
    pub fn column(mut self, name: impl Into<String>, values: impl Into<Vec<f64>>) -> Self {
        self.columns.push(MeasuredColumn { name: name.into(), values: values.into(), sigma: 1.0 });
        self
    }

    /// Standard deviation of a column's values, in its unit: residuals are divided by it. Columns without it count as they are, which
    /// is right for one column, or for several in one unit with like errors. A name that is not measured changes nothing.
    #[must_use]
    pub fn sigma(mut self, name: &str, sigma: f64) -> Self {
        self.columns.iter_mut().filter(|column| column.name == name).for_each(|column| column.sigma = sigma);
        self
    }

    /// Reads CSV: a row of names with `t` first, as `run --out` writes them with or without units, then rows of numbers; an empty field
    /// was not measured. Lines that begin with `#` are left out.
    ///
    /// ```
    /// use ezy_core::optimise::Measured;
    ///
    /// let data = Measured::read("t [s],rod.phi [rad]\n0,0.1\n0.5,\n1,0.3\n".as_bytes())?;
    /// assert_eq!((data.times(), data.n_values()), (&[0.0, 0.5, 1.0][..], 2));
    /// # Ok::<(), ezy_core::optimise::OptimiseError>(())
    /// ```
    ///
    /// # Errors
    /// [`OptimiseError::Data`] with the row and column that cannot be read.
    pub fn read(source: impl Read) -> Result<Self, OptimiseError> {
        let wrong = |what: String| OptimiseError::Data(what);
        let mut rows =
            csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(LimitedReader::new(source));
        let headings = rows.headers().map_err(|error| wrong(error.to_string()))?.clone();
        let bare = |heading: &str| {
            heading
                .strip_suffix(']')
                .and_then(|h| h.rsplit_once(" ["))
                .map_or(heading.to_owned(), |(name, _)| name.to_owned())
        };
        let names: Vec<String> = headings.iter().map(bare).collect();
        if names.first().is_none_or(|name| name != "t") {
            return Err(wrong("its first column is not time; name it `t` or `t [s]`, and give seconds".to_owned()));
        }
        let mut values: Vec<Vec<f64>> = vec![Vec::new(); names.len()];
        for (i, row) in rows.records().enumerate() {
            let row = row.map_err(|error| wrong(error.to_string()))?;
            for ((text, name), column) in row.iter().zip(&names).zip(&mut values) {
                let gap = (text.is_empty() && name != "t").then_some(f64::NAN);
                let number = gap.or_else(|| text.parse().ok().filter(|x: &f64| x.is_finite()));
                column.push(number.ok_or_else(|| {
                    wrong(format!(
                        "row {}, column `{name}`: `{text}` is no number; write one, or leave it empty",
                        i + 1
                    ))
                })?);
            }
        }
        let mut all = names.into_iter().zip(values);
        let times = all.next().map_or(Vec::new(), |(_, times)| times);
        Ok(all.fold(Self::new(times), |data, (name, values)| data.column(name, values)))
    }

    /// Times of the measurement, s: what the runs of a fit have to record ([`Simulation::at`](crate::simulate::Simulation::at)).
    pub fn times(&self) -> &[f64] {
        &self.times_s
    }

    /// Names of the columns.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|column| column.name.as_str())
    }

    /// Only the columns that `keep` names.
    #[must_use]
    pub fn only(mut self, keep: impl Fn(&str) -> bool) -> Self {
        self.columns.retain(|column| keep(&column.name));
        self
    }

    /// Number of measured values.
    pub fn n_values(&self) -> usize {
        self.points().count()
    }

    /// The measured values: column by column, in the order of time. Derivatives and residuals have this order.
    pub(super) fn points(&self) -> impl Iterator<Item = Point<'_>> {
        self.columns.iter().flat_map(|column| {
            let at = self.times_s.iter().zip(&column.values).filter(|(_, value)| !value.is_nan());
            at.map(move |(t, value)| Point { t: *t, column, value: *value })
        })
    }

    /// Refuses lengths that differ, times and weights that are none.
    pub(super) fn checked(&self) -> Result<(), OptimiseError> {
        for MeasuredColumn { name, values, sigma } in &self.columns {
            if values.len() != self.times_s.len() {
                return Err(OptimiseError::Data(format!(
                    "column `{name}` has {} values at {} times; give one value for each time, NaN where none was measured",
                    values.len(),
                    self.times_s.len()
                )));
            }
            if !(*sigma > 0.0 && sigma.is_finite()) {
                return Err(OptimiseError::Sigma { column: name.clone(), sigma: *sigma });
            }
        }
        if let Some(t) = self.times_s.iter().find(|t| !t.is_finite()) {
            return Err(OptimiseError::Data(format!("a time is {t}; give finite seconds")));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_measurement_that_cannot_be_read_is_refused_with_its_place() {
        for (text, place) in [
            ("time,x\n0,1\n", "first column"),
            ("t,x\n0,1\n1,red\n", "row 2, column `x`"),
            ("t,x\n,1\n", "row 1, column `t`"),
        ] {
            let message = Measured::read(text.as_bytes()).unwrap_err().to_string();
            assert!(message.contains(place), "{message}");
        }
        assert!(Measured::new([0.0, 1.0]).column("x", [1.0]).checked().is_err());
        assert!(Measured::new([0.0]).column("x", [1.0]).sigma("x", 0.0).checked().is_err());
    }
}
