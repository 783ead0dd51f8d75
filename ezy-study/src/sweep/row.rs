//! A case as a row of a table.

use super::finished::{Ended, Finished};
use super::plan::{Plan, Value};
use ezy_core::record;
use std::fmt::Write as _;

/// A case with its values, its numbers and its outcome.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Number of the case.
    pub index: u64,
    /// Values of the plan, then what is kept; NaN where there is none.
    pub cells: Vec<Cell>,
}

/// Rows that come in pieces.
pub(super) type Pieces<'a> = dyn Iterator<Item = std::io::Result<Vec<Row>>> + 'a;

/// Content of a row at one column.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// NaN where there is none.
    Number(f64),
    /// A whole number.
    Count(u64),
    /// A word or a message.
    Text(String),
}

/// A column of a table of results.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// `case`, `m0`, `max:seat.vx`, …
    pub name: String,
    /// Unit; empty where there is none.
    pub unit: String,
    /// What its cells are.
    pub kind: Kind,
}

/// What the cells of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `f64`; empty where there is none.
    Number,
    /// Whole.
    Count,
    /// Words, messages.
    Text,
}

/// Columns behind those that are kept: when the run ended, its steps, how it ended, and why where that is not as it should be.
const LAST_COLUMNS: [(&str, &str, Kind); 4] =
    [("end", "s", Kind::Number), ("steps", "", Kind::Count), ("outcome", "", Kind::Text), ("message", "", Kind::Text)];

impl Kind {
    const ALL: [(Self, &str); 3] = [(Self::Number, "number"), (Self::Count, "count"), (Self::Text, "text")];

    /// As it is written in `sweep.json`.
    pub(super) fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    pub(super) fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, known)| *known == name).map(|(kind, _)| *kind)
    }
}

impl Column {
    fn new(name: &str, unit: &str, kind: Kind) -> Self {
        Self { name: name.to_owned(), unit: unit.to_owned(), kind }
    }
}

/// The columns of a sweep: the number of the case, its values, what is kept, and how the run ended.
pub(super) fn columns(plan: &Plan, units: &[String], kept: &[record::Column]) -> Vec<Column> {
    let mut all = vec![Column::new("case", "", Kind::Count)];
    let varied = plan.names().into_iter().zip(units).zip(plan.values(0));
    all.extend(varied.map(|((name, unit), value)| match value {
        Value::Number(_) => Column::new(name, unit, Kind::Number),
        Value::Word(_) => Column::new(name, "", Kind::Text),
    }));
    all.extend(kept.iter().map(|kept| Column::new(&kept.name, &kept.unit, Kind::Number)));
    all.extend(LAST_COLUMNS.map(|(name, unit, kind)| Column::new(name, unit, kind)));
    all
}

impl Row {
    /// The row of a case that ran, or of one that was refused for `why`. `n_kept`: how many numbers are kept of a run.
    pub(super) fn new(index: u64, values: &[Value<'_>], n_kept: usize, run: Result<Finished, String>) -> Self {
        let mut cells = Vec::with_capacity(values.len() + n_kept + LAST_COLUMNS.len());
        cells.extend(values.iter().map(|value| match value {
            Value::Number(x) => Cell::Number(*x),
            Value::Word(word) => Cell::Text((*word).to_owned()),
        }));
        let run = run.unwrap_or_else(|why| Finished {
            numbers: vec![f64::NAN; n_kept],
            t: f64::NAN,
            n_steps: 0,
            outcome: Ended::Refused,
            message: why,
            unwritten: None,
        });
        cells.extend(run.numbers.into_iter().map(Cell::Number));
        cells.extend([
            Cell::Number(run.t),
            Cell::Count(run.n_steps),
            Cell::Text(run.outcome.to_string()),
            Cell::Text(run.message),
        ]);
        Self { index, cells }
    }

    /// Whether the run is complete, and nothing speaks against its result.
    pub fn is_good(&self) -> bool {
        let outcome = self.cells.len().checked_sub(2).map(|i| &self.cells[i]);
        matches!(outcome, Some(Cell::Text(outcome)) if outcome == "end" || outcome.starts_with("event:"))
    }

    /// Whether the case could start.
    pub(super) fn has_run(&self) -> bool {
        let end = self.cells.len().checked_sub(LAST_COLUMNS.len()).map(|i| &self.cells[i]);
        matches!(end, Some(Cell::Number(t)) if !t.is_nan())
    }

    /// The row as a line of CSV. Numbers are as short as gives back the same `f64`.
    pub(super) fn write_line(&self, line: &mut String) {
        // writing to a string cannot fail
        _ = write!(line, "{}", self.index);
        for cell in &self.cells {
            line.push(',');
            _ = match cell {
                Cell::Number(x) if x.is_nan() => Ok(()),
                Cell::Number(x) => write!(line, "{x:?}"),
                Cell::Count(n) => write!(line, "{n}"),
                Cell::Text(text) => line.write_str(&quoted(text)),
            };
        }
        line.push('\n');
    }
}

impl Row {
    /// A row of CSV of these columns; `None` when it is none.
    pub(super) fn of_record(record: &csv::StringRecord, columns: &[Column]) -> Option<Self> {
        let (index, rest) = (record.get(0)?.parse().ok()?, record.iter().skip(1));
        let cell = |(text, column): (&str, &Column)| match column.kind {
            Kind::Number if text.is_empty() => Some(Cell::Number(f64::NAN)),
            Kind::Number => text.parse().ok().map(Cell::Number),
            Kind::Count => text.parse().ok().map(Cell::Count),
            Kind::Text => Some(Cell::Text(text.to_owned())),
        };
        let cells = rest.zip(&columns[1..]).map(cell).collect::<Option<Vec<_>>>()?;
        (record.len() == columns.len()).then_some(Self { index, cells })
    }
}

/// Names with units as the first line of CSV.
pub(super) fn heading(columns: &[Column]) -> String {
    let names = columns.iter().map(|column| match column.unit.as_str() {
        "" => quoted(&column.name),
        unit => quoted(&format!("{} [{unit}]", column.name)),
    });
    names.collect::<Vec<_>>().join(",") + "\n"
}

/// A text in quotes where it needs them; on one line, so that a line is a row.
fn quoted(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    if text.contains(['"', ',']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_row_is_one_line_that_a_reader_takes_apart() {
        let mut line = String::new();
        let values = [Value::Number(0.1), Value::Word("rk4")];
        let why = "stopped: \"pin\", at 3\nsteps".to_owned();
        Row::new(7, &values, 2, Err(why)).write_line(&mut line);
        assert_eq!(line, "7,0.1,rk4,,,,0,refused,\"stopped: \"\"pin\"\", at 3 steps\"\n");
        let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(line.as_bytes());
        let record = reader.records().next().unwrap().unwrap();
        assert_eq!(record.iter().next_back(), Some("stopped: \"pin\", at 3 steps"));
    }
}
