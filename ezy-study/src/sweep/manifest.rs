//! What a folder of results is of: written before the first part, compared before a further one.

use super::row::{Column, Kind};
use crate::output;
use serde_json::{Map, Value, json};
use std::io::ErrorKind;
use std::path::Path;
use std::thread;
use std::time::Duration;

/// Everything that the results depend on, by name.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Manifest(pub Map<String, Value>);

/// Name of the file.
pub(super) const FILE: &str = "sweep.json";
const COLUMNS: &str = "columns";
/// What is kept of each run.
pub(super) const KEPT: &str = "kept";
/// Cases of one part.
pub(super) const CASES_PER_PART: &str = "cases per part";

/// How long another program may take to write the same file, in tries of [`PAUSE`].
const N_TRIES: usize = 600;
const PAUSE: Duration = Duration::from_millis(50);

impl Manifest {
    /// What is in a folder; `None` when it has no results.
    ///
    /// # Errors
    /// The error of the system; [`ErrorKind::InvalidData`] when the file is none of a sweep.
    pub(super) fn of_folder(folder: &Path) -> std::io::Result<Option<Self>> {
        let text = match std::fs::read_to_string(folder.join(FILE)) {
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            text => text?,
        };
        match serde_json::from_str(&text) {
            Ok(Value::Object(entries)) => Ok(Some(Self(entries))),
            _ => Err(std::io::Error::new(ErrorKind::InvalidData, format!("`{FILE}` is not that of a sweep"))),
        }
    }

    /// Puts it into a folder, where several programs may do so at once.
    ///
    /// # Errors
    /// The error of the system.
    pub(super) fn put_into(&self, folder: &Path) -> std::io::Result<()> {
        let text = format!("{:#}\n", Value::Object(self.0.clone()));
        for _ in 0..N_TRIES {
            match output::write(&folder.join(FILE), &text) {
                Err(error) if error.kind() == ErrorKind::ResourceBusy => thread::sleep(PAUSE),
                done => return done,
            }
            if Self::of_folder(folder)?.as_ref() == Some(self) {
                return Ok(());
            }
        }
        Err(std::io::Error::new(ErrorKind::ResourceBusy, format!("another program does not finish `{FILE}`")))
    }

    /// What differs from `self` in `other`, as a reader sees it; empty when nothing does.
    pub(super) fn differences(&self, other: &Self) -> Vec<String> {
        let written = |value: Option<&Value>| match value {
            None => "nothing".to_owned(),
            Some(Value::String(text)) => text.clone(),
            Some(value) => value.to_string(),
        };
        let names = self.0.keys().chain(other.0.keys().filter(|name| !self.0.contains_key(*name)));
        let different = names.filter(|name| self.0.get(*name) != other.0.get(*name));
        different
            .map(|name| format!("{name}: {} → {}", written(self.0.get(name)), written(other.0.get(name))))
            .collect()
    }

    /// A whole number.
    pub(super) fn number(&self, name: &str) -> Option<u64> {
        self.0.get(name).and_then(Value::as_u64)
    }

    /// A text.
    pub(super) fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).and_then(Value::as_str)
    }

    /// Whether this was asked for.
    pub(super) fn has_kept(&self, what: &str) -> bool {
        let kept = self.0.get(KEPT).and_then(Value::as_array);
        kept.is_some_and(|kept| kept.iter().any(|kept| kept == what))
    }

    /// The columns of the rows.
    pub(super) fn columns(&self) -> Option<Vec<Column>> {
        let column = |of: &Value| {
            let text = |name: &str| of.get(name).and_then(Value::as_str);
            let (name, unit) = (text("name")?.to_owned(), text("unit")?.to_owned());
            Some(Column { name, unit, kind: Kind::of_name(text("kind")?)? })
        };
        self.0.get(COLUMNS)?.as_array()?.iter().map(column).collect()
    }

    pub(super) fn set_columns(&mut self, columns: &[Column]) {
        let column = |Column { name, unit, kind }: &Column| json!({ "name": name, "unit": unit, "kind": kind.name() });
        self.set(COLUMNS, columns.iter().map(column).collect::<Vec<_>>());
    }

    pub(super) fn set(&mut self, name: &str, value: impl Into<Value>) {
        self.0.insert(name.to_owned(), value.into());
    }
}

/// Values of an axis that are written one by one; of more their hash stands for all.
const MOST_WRITTEN: usize = 10;

/// The values of an axis in short: how many, the ends, and a hash of all.
pub(super) fn digest(numbers: &[f64]) -> Value {
    let bytes = numbers.iter().flat_map(|x| x.to_bits().to_le_bytes());
    // FNV-1a
    let hash =
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3));
    match numbers {
        [first, .., last] if numbers.len() > MOST_WRITTEN => {
            json!(format!("{} values from {first} to {last} ({hash:016x})", numbers.len()))
        }
        few => json!(few),
    }
}
