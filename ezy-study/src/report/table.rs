//! Tables as aligned text and as HTML.

use std::fmt;

use super::page::escape;
use super::typeset::typeset;

/// Letters of a cell that is read as a sentence.
const SENTENCE: usize = 28;

/// A table with a head. Columns that hold numbers in most of their cells are flushed right.
///
/// ```
/// use ezy_study::report::table::Table;
///
/// let table = Table::new(["step [s]", "gap [J]"]).row(["0.01", "2.8e-1"]).row(["0.001", "2.7e-2"]);
/// assert!(table.to_string().starts_with("step [s]  gap [J]\n--------  -------\n    0.01   2.8e-1\n"));
/// ```
#[derive(Debug, Clone, Default)]
pub struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    pub fn new<S: Into<String>>(head: impl IntoIterator<Item = S>) -> Self {
        Self { head: head.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Adds a row.
    #[must_use]
    pub fn row<S: Into<String>>(mut self, cells: impl IntoIterator<Item = S>) -> Self {
        self.push(cells);
        self
    }

    /// Adds a row in place.
    pub fn push<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }

    /// The table as one HTML element, with its head marked as such; `caption` says what it holds. Numbers are as people write them.
    /// Columns of sentences are marked, so that a narrow page can put them below the others.
    pub fn html(&self, caption: &str) -> String {
        let has_sentences: Vec<bool> = (0..self.head.len()).map(|i| self.has_sentences(i)).collect();
        let n_short = has_sentences.iter().filter(|has| !**has).count();
        let attributes = |i: usize| match self.head.get(i) {
            Some(head) if has_sentences[i] => format!(" class=\"sentence\" data-head=\"{}\"", escape(head)),
            _ if self.is_numeric(i) => " class=\"number\"".to_owned(),
            _ => String::new(),
        };
        let row = |tag: &str, cells: &[String]| -> String {
            let name = tag.split(' ').next().unwrap_or(tag);
            let cell =
                |(i, cell): (usize, &String)| format!("<{tag}{}>{}</{name}>", attributes(i), escape(&typeset(cell)));
            format!("<tr>{}</tr>\n", cells.iter().enumerate().map(cell).collect::<String>())
        };
        let head = row("th scope=\"col\"", &self.head);
        let body: String = self.rows.iter().map(|cells| row("td", cells)).collect();
        let caption = escape(&typeset(caption));
        let words = if n_short < self.head.len() {
            format!(" class=\"words\" style=\"--short: {}\"", n_short.max(1))
        } else {
            String::new()
        };
        format!(
            "<table{words}>\n<caption>{caption}</caption>\n<thead>{head}</thead>\n<tbody>\n{body}</tbody>\n</table>\n"
        )
    }

    fn has_sentences(&self, column: usize) -> bool {
        self.rows.iter().any(|row| row.get(column).is_some_and(|cell| cell.chars().count() > SENTENCE))
    }

    fn is_numeric(&self, column: usize) -> bool {
        let numbers = self.rows.iter().filter(|row| row.get(column).is_some_and(|cell| cell.parse::<f64>().is_ok()));
        2 * numbers.count() > self.rows.len()
    }

    fn widths(&self) -> Vec<usize> {
        let mut widths: Vec<usize> = self.head.iter().map(|cell| cell.chars().count()).collect();
        for row in &self.rows {
            for (width, cell) in widths.iter_mut().zip(row) {
                *width = (*width).max(cell.chars().count());
            }
        }
        widths
    }
}

/// No decimal of a number of this size is known.
const WHOLE: f64 = 1e15;

/// A number with `digits` decimals, with an exponent from 1e15 on; what rounds to zero has no sign.
///
/// ```
/// use ezy_study::report::table::fixed;
///
/// assert_eq!([fixed(-1e-9, 3), fixed(2e300, 3)], ["0.000", "2.000e300"]);
/// ```
pub fn fixed(value: f64, digits: usize) -> String {
    if value.abs() >= WHOLE {
        return format!("{value:.digits$e}");
    }
    let text = format!("{value:.digits$}");
    match text.strip_prefix('-') {
        Some(magnitude) if magnitude.chars().all(|c| matches!(c, '0' | '.')) => magnitude.to_owned(),
        _ => text,
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let widths = self.widths();
        let numeric: Vec<bool> = (0..widths.len()).map(|i| self.is_numeric(i)).collect();
        let rule: Vec<String> = widths.iter().map(|w| "-".repeat(*w)).collect();
        for cells in [&self.head, &rule].into_iter().chain(&self.rows) {
            let mut line = String::new();
            for (i, (cell, &width)) in cells.iter().zip(&widths).enumerate() {
                line += if i > 0 { "  " } else { "" };
                line += &if numeric[i] { format!("{cell:>width$}") } else { format!("{cell:<width$}") };
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_html_table_escapes_cells_and_marks_its_head() {
        let html = Table::new(["a < b", "c"]).row(["1 & 2", "3"]).html("numbers");
        assert!(
            html.contains("<th scope=\"col\">a &lt; b</th>")
                && html.contains("<td>1 &amp; 2</td><td class=\"number\">3</td>"),
            "{html}"
        );
    }
}
