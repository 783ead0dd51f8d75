//! A motion as columns of numbers: of a run, or of a file that `run --out` wrote.

use std::fs::File;
use std::path::Path;

use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model::Scene;
use ezy_core::record::{Column, LimitedReader, UnknownName, columns, find_name};
use ezy_core::simulate::Run;

use super::failure::Failure;

/// Columns with their values, all of one length; the first is time.
#[derive(Debug)]
pub(super) struct MotionTable {
    /// What tells it from others.
    pub name: String,
    pub columns: Vec<Column>,
    /// By column.
    pub values: Vec<Vec<f64>>,
}

impl MotionTable {
    /// All columns of a run, then the points of the scene: `A.x`, `A.y`.
    pub(super) fn of_run(name: String, scene: &dyn Scene, run: &Run) -> Result<Self, Failure> {
        let wanted = run.first().wanted;
        let mut columns = columns(run.info(), wanted);
        let mut values: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
        for sample in run.samples() {
            values.iter_mut().zip(sample.numbers()).for_each(|(column, number)| column.push(number));
        }
        let system = System::new(scene, Backend::Auto).map_err(Failure::wrong_use)?;
        let info = scene.info();
        let mut places = vec![0.0; 2 * info.points.len()];
        let mut of_points: Vec<Vec<f64>> = vec![Vec::new(); places.len()];
        for sample in run.samples() {
            scene.points(system.fixed(), sample.t, sample.coordinates, &mut places);
            of_points.iter_mut().zip(&places).for_each(|(column, place)| column.push(*place));
        }
        let names = info.points.iter().flat_map(|point| ["x", "y"].map(|axis| format!("{}.{axis}", point.name)));
        for (name, numbers) in names.zip(of_points) {
            if !columns.iter().any(|column| column.name == name) {
                columns.push(Column { name, unit: "m".to_owned() });
                values.push(numbers);
            }
        }
        Ok(Self { name, columns, values })
    }

    /// Reads a file that `run --out` wrote: a row of names with units, rows of numbers, lines that begin with `#` left out.
    pub(super) fn of_file(path: &Path) -> Result<Self, Failure> {
        let wrong = |what: &dyn std::fmt::Display| Failure::wrong_use(format!("`{}`: {what}", path.display()));
        let file = File::open(path).map_err(|error| wrong(&error))?;
        let mut rows =
            csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(LimitedReader::new(file));
        let headings = rows.headers().map_err(|error| wrong(&error))?.clone();
        let columns: Vec<Column> = headings.iter().map(column).collect();
        if columns.first().is_none_or(|column| column.name != "t") {
            return Err(wrong(&"its first column is not time, `t [s]`; give a file of `run --out`"));
        }
        let mut values: Vec<Vec<f64>> = vec![Vec::new(); columns.len()];
        for (i, row) in rows.records().enumerate() {
            let row = row.map_err(|error| wrong(&error))?;
            for (k, text) in row.iter().enumerate() {
                let name = &columns[k].name;
                let number = text
                    .parse()
                    .map_err(|_| wrong(&format!("row {}, column `{name}`: `{text}` is no number", i + 1)))?;
                values[k].push(number);
            }
        }
        if values[0].is_empty() {
            return Err(wrong(&"it has no rows"));
        }
        if let Some(i) = values[0].windows(2).position(|pair| pair[1] < pair[0]) {
            return Err(wrong(&format!("row {}: time runs backwards", i + 2)));
        }
        Ok(Self { name: path.display().to_string(), columns, values })
    }

    /// Times, s.
    pub(super) fn times(&self) -> &[f64] {
        &self.values[0]
    }

    /// A column at a time, by straight lines between rows; of two rows at one time the first. `None` outside of the motion.
    pub(super) fn at(&self, column: usize, t: f64) -> Option<f64> {
        let (times, values) = (self.times(), &self.values[column]);
        let next = times.partition_point(|known| *known < t);
        match (next, times.get(next)?) {
            (_, known) if *known == t => Some(values[next]),
            (0, _) => None,
            (_, known) => {
                let part = (t - times[next - 1]) / (known - times[next - 1]);
                Some(values[next - 1] + part * (values[next] - values[next - 1]))
            }
        }
    }

    /// Place of a column.
    pub(super) fn index(&self, name: &str) -> Result<usize, UnknownName> {
        find_name("column", name, self.columns.iter().map(|column| column.name.as_str()))
    }

    /// Places of the columns that a name, or a pattern with `*` and `?`, means; time is no match of a pattern.
    pub(super) fn select(&self, pattern: &str) -> Result<Vec<usize>, UnknownName> {
        if !pattern.contains(['*', '?']) {
            return Ok(vec![self.index(pattern)?]);
        }
        let is_match = |i: &usize| matches(pattern, &self.columns[*i].name);
        let found: Vec<usize> = (1..self.columns.len()).filter(is_match).collect();
        if found.is_empty() { self.index(pattern).map(|i| vec![i]) } else { Ok(found) }
    }
}

/// Name and unit of `name [unit]`; the name of an array's member may hold brackets of its own.
fn column(heading: &str) -> Column {
    let parts = heading.strip_suffix(']').and_then(|heading| heading.rsplit_once(" ["));
    let (name, unit) = parts.unwrap_or((heading, ""));
    Column { name: name.to_owned(), unit: unit.to_owned() }
}

/// Whether `text` is what `pattern` says, where `*` is any text and `?` any letter.
fn matches(pattern: &str, text: &str) -> bool {
    let (pattern, text): (Vec<char>, Vec<char>) = (pattern.chars().collect(), text.chars().collect());
    // ends[j]: the pattern so far matches the first j letters
    let mut ends = vec![false; text.len() + 1];
    ends[0] = true;
    for letter in pattern {
        let before = ends.clone();
        for j in 0..ends.len() {
            ends[j] = match letter {
                '*' => before[j] || (j > 0 && ends[j - 1]),
                _ => j > 0 && before[j - 1] && (letter == '?' || letter == text[j - 1]),
            };
        }
    }
    ends[text.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_patterns_match_as_in_a_shell() {
        let cases =
            [("*.phi", "seat.phi", true), ("*.phi", "seat.phi2", false), ("seat.?", "seat.x", true), ("*", "", true)];
        for (pattern, text, expected) in
            cases.into_iter().chain([("a*b*c", "a1b2b3c", true), ("seat.?", "seat.vx", false)])
        {
            assert_eq!(matches(pattern, text), expected, "{pattern} {text}");
        }
    }

    #[test]
    fn analytic_heading_of_an_array_member_keeps_its_index() {
        let of = |heading| column(heading);
        assert_eq!(of("link[3].x [m]"), Column { name: "link[3].x".to_owned(), unit: "m".to_owned() });
        assert_eq!(of("residual.position"), Column { name: "residual.position".to_owned(), unit: String::new() });
    }
}
