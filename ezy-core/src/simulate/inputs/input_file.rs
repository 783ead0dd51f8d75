//! Inputs from a CSV file.

use crate::model::SceneInfo;
use crate::record::{LimitedReader, UnknownName, input_index};
use crate::simulate::{InputTable, TableError};
use std::io::Read;

/// An input file that cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum InputFileError {
    /// It is no table.
    #[error("the file of inputs cannot be read: {0}")]
    Csv(#[from] csv::Error),
    /// It does not say when.
    #[error("the file of inputs has no column `t`; its first row names the columns, such as `t [s],torque [N*m]`")]
    NoTime,
    /// It does not set anything.
    #[error(
        "the file of inputs has no column of an input; its first row names the columns, such as `t [s],torque [N*m]`"
    )]
    NoInputs,
    /// Two columns are for the same.
    #[error("the file of inputs has two columns `{name}`; leave one of them")]
    Twice {
        /// Name of the input, or `t`.
        name: String,
    },
    /// A column is no input of the scene.
    #[error("the file of inputs: {0}")]
    UnknownName(#[from] UnknownName),
    /// A column is in another unit than the input, or than the time.
    #[error("column `{name}` of the file of inputs is in {found}, but must be in {unit}; convert the column")]
    Unit {
        /// Name of the input, or `t`.
        name: String,
        /// Unit in the file.
        found: String,
        /// Unit of the input, or `s`.
        unit: &'static str,
    },
    /// A field is no number.
    #[error("row {row} of the file of inputs has `{text}` for `{name}`; write a number")]
    Number {
        /// Counted from one, without the row of names.
        row: usize,
        /// Name of the column.
        name: String,
        /// What stands there.
        text: String,
    },
    /// The rows are no table.
    #[error("the file of inputs: {0}")]
    Table(#[from] TableError),
}

/// A column of the file, named `torque`, `torque [N*m]` or `input.torque [N*m]`.
struct Heading<'f> {
    index: usize,
    name: &'f str,
    unit: Option<&'f str>,
}

/// Reads the inputs of a scene, to be handed to [`Simulation::input`](crate::simulate::Simulation::input): a column `t` in s and
/// one for each input, with straight lines between rows; two rows at one time are a jump.
///
/// Of a file that a run wrote, the columns of inputs are read, and each value holds until the next row, as it did there. Of inputs by
/// acceleration, value and rate are read from the first row.
/// Lines that begin with `#` are left out. Files of up to 512 MiB are read, and rows of up to 16 MiB.
///
/// # Errors
/// [`InputFileError`] naming column and row.
pub fn read_inputs(file: impl Read, info: &SceneInfo) -> Result<Vec<(String, InputTable)>, InputFileError> {
    let mut rows =
        csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(LimitedReader::new(file));
    let names = rows.headers()?.clone();
    let time = names.iter().position(|name| parts(name).0 == "t").ok_or(InputFileError::NoTime)?;
    let of_a_run = names.iter().any(|name| name.starts_with(PREFIX));
    let columns = names.iter().enumerate().filter(|&(i, name)| i != time && (!of_a_run || name.starts_with(PREFIX)));
    let headings: Vec<Heading<'_>> = columns
        .map(|(index, name)| {
            let (name, unit) = parts(name);
            Heading { index, name: name.strip_prefix(PREFIX).unwrap_or(name), unit }
        })
        .collect();
    if headings.is_empty() {
        return Err(InputFileError::NoInputs);
    }
    let of_time = Heading { index: time, name: "t", unit: parts(&names[time]).1 };
    check_unit(&of_time, "s")?;
    for (i, heading) in headings.iter().enumerate() {
        if heading.name == "t" || headings[..i].iter().any(|other| other.name == heading.name) {
            return Err(InputFileError::Twice { name: heading.name.to_owned() });
        }
        check_unit(heading, info.inputs[input_index(info, heading.name)?].unit)?;
    }
    let (mut times, mut values) = (Vec::new(), vec![Vec::new(); headings.len()]);
    for (i, row) in rows.records().enumerate() {
        let row = row?;
        let number = |index: usize, name: &str| {
            let text = row.get(index).unwrap_or_default();
            let error = || InputFileError::Number { row: i + 1, name: name.to_owned(), text: text.to_owned() };
            text.parse::<f64>().map_err(|_| error())
        };
        times.push(number(time, "t")?);
        for (values, heading) in values.iter_mut().zip(&headings) {
            values.push(number(heading.index, heading.name)?);
        }
    }
    let table = if of_a_run { InputTable::held } else { InputTable::new };
    let tables = headings.iter().zip(values).map(|(heading, values)| {
        let start = values.first().filter(|_| of_a_run && is_integrated(info, heading.name));
        let table = start.map_or_else(|| table(times.clone(), values.clone()), |value| Ok(InputTable::from(*value)));
        Ok((heading.name.to_owned(), table?))
    });
    tables.collect()
}

/// Whether a run integrated the input, so that its start says all.
fn is_integrated(info: &SceneInfo, name: &str) -> bool {
    let parts = info.integrated_inputs.iter().flat_map(|first| SceneInfo::integrated_places(*first));
    parts.into_iter().any(|i| info.inputs[i].name == name)
}

fn check_unit(heading: &Heading<'_>, unit: &'static str) -> Result<(), InputFileError> {
    match heading.unit.filter(|found| *found != unit) {
        None => Ok(()),
        Some(found) => Err(InputFileError::Unit { name: heading.name.to_owned(), found: found.to_owned(), unit }),
    }
}

/// What the columns of inputs begin with in the file of a run.
const PREFIX: &str = "input.";

/// Name and unit of `name [unit]`.
fn parts(heading: &str) -> (&str, Option<&str>) {
    match heading.split_once('[') {
        Some((name, unit)) => (name.trim(), Some(unit.trim_end_matches(']').trim())),
        None => (heading.trim(), None),
    }
}
