//! Matrices of printed expressions, in the three renderings.

use crate::model::Formula;

/// Something that can stand on a side of an equation.
pub(super) trait Cell {
    /// Lines of equal length.
    fn lines(&self) -> Vec<String>;
    fn latex(&self) -> String;
    fn mathml(&self) -> String;
}

impl Cell for Formula {
    fn lines(&self) -> Vec<String> {
        vec![self.text.to_owned()]
    }

    fn latex(&self) -> String {
        self.latex.to_owned()
    }

    fn mathml(&self) -> String {
        self.mathml.to_owned()
    }
}

/// A matrix, if wanted multiplied by another one.
pub(super) struct Matrix {
    rows: Vec<Vec<Formula>>,
    factor: Option<Box<Matrix>>,
}

/// Brackets drawn as borders with ticks at their ends: a fence grows with its rows only where a font for
/// mathematics is installed.
const BRACKETS: &str = "border-left: .08em solid; border-right: .08em solid; padding: .15em .2em; \
    print-color-adjust: exact; background: \
    linear-gradient(currentColor, currentColor) left top / .35em .08em no-repeat, \
    linear-gradient(currentColor, currentColor) left bottom / .35em .08em no-repeat, \
    linear-gradient(currentColor, currentColor) right top / .35em .08em no-repeat, \
    linear-gradient(currentColor, currentColor) right bottom / .35em .08em no-repeat";

/// A matrix in MathML from its rows, `<mtr>` elements, in brackets that are right with any font.
pub fn bracketed(rows: &str) -> String {
    format!("<mspace width=\"0.15em\"/><mtable style=\"{BRACKETS}\">{rows}</mtable><mspace width=\"0.15em\"/>")
}

/// Names to the right of the rows of an equation.
pub(super) struct Names(pub Vec<&'static str>);

impl Matrix {
    pub(super) fn new(rows: impl IntoIterator<Item = Vec<Formula>>) -> Self {
        Self { rows: rows.into_iter().collect(), factor: None }
    }

    pub(super) fn times(self, factor: Matrix) -> Self {
        Self { factor: Some(Box::new(factor)), ..self }
    }

    fn own_lines(&self) -> Vec<String> {
        let n_columns = self.rows.first().map_or(0, Vec::len);
        let width = |j: usize| self.rows.iter().map(|row| row[j].text.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..n_columns).map(width).collect();
        let line = |row: &Vec<Formula>| {
            let cells = row.iter().zip(&widths).map(|(entry, &width)| format!("{:<width$}", entry.text));
            format!("[ {} ]", cells.collect::<Vec<_>>().join("  "))
        };
        self.rows.iter().map(line).collect()
    }
}

impl Cell for Matrix {
    fn lines(&self) -> Vec<String> {
        match &self.factor {
            None => self.own_lines(),
            Some(factor) => side_by_side(&[self.own_lines(), factor.lines()], " "),
        }
    }

    fn latex(&self) -> String {
        let row = |row: &Vec<Formula>| row.iter().map(|entry| entry.latex).collect::<Vec<_>>().join(" & ");
        let rows = self.rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ ");
        let factor = self.factor.as_ref().map(|factor| factor.latex()).unwrap_or_default();
        format!("\\begin{{bmatrix}} {rows} \\end{{bmatrix}}{factor}")
    }

    fn mathml(&self) -> String {
        let row = |row: &Vec<Formula>| {
            row.iter().fold("<mtr>".to_owned(), |cells, entry| cells + "<mtd>" + entry.mathml + "</mtd>") + "</mtr>"
        };
        let rows: String = self.rows.iter().map(row).collect();
        let factor = self.factor.as_ref().map(|factor| factor.mathml()).unwrap_or_default();
        bracketed(&rows) + &factor
    }
}

/// Rows too wide for a matrix: for each its name, then the columns that are not zero with their entries.
pub(super) struct Listing(pub Vec<(&'static str, Vec<(Formula, Formula)>)>);

impl Cell for Listing {
    fn lines(&self) -> Vec<String> {
        let width = self.0.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
        let row = |(name, entries): &(&str, Vec<(Formula, Formula)>)| {
            let entries: Vec<String> =
                entries.iter().map(|(column, entry)| format!("{}: {}", column.text, entry.text)).collect();
            format!("{name:width$}  {}", entries.join(", "))
        };
        self.0.iter().map(row).collect()
    }

    fn latex(&self) -> String {
        let row = |(name, entries): &(&str, Vec<(Formula, Formula)>)| {
            let entries: Vec<String> =
                entries.iter().map(|(column, entry)| format!("{}\\colon {}", column.latex, entry.latex)).collect();
            format!("\\text{{{}}} & {}", name.replace('_', "\\_"), entries.join(",\\; "))
        };
        let rows: Vec<String> = self.0.iter().map(row).collect();
        format!("\\begin{{array}}{{ll}} {} \\end{{array}}", rows.join(" \\\\ "))
    }

    fn mathml(&self) -> String {
        let row = |(name, entries): &(&str, Vec<(Formula, Formula)>)| {
            let entries: Vec<String> =
                entries.iter().map(|(column, entry)| format!("{}<mo>:</mo>{}", column.mathml, entry.mathml)).collect();
            let entries = entries.join("<mo>,</mo><mspace width=\"0.8em\"/>");
            format!("<mtr><mtd><mtext>{name}</mtext></mtd><mtd>{entries}</mtd></mtr>")
        };
        format!("<mtable>{}</mtable>", self.0.iter().map(row).collect::<String>())
    }
}

/// The sides of an equation on one height, joined by `=` in the middle line; names of rows to the right.
pub(super) fn equation_lines(sides: &[&dyn Cell], names: &Names) -> String {
    let blocks: Vec<Vec<String>> = sides.iter().map(|side| side.lines()).collect();
    let names = names.0.iter().map(|name| (*name).to_owned()).collect();
    let lines = side_by_side(&[side_by_side(&blocks, " = "), names], "   ");
    lines.iter().map(|line| line.trim_end().to_owned() + "\n").collect()
}

fn side_by_side(blocks: &[Vec<String>], sign: &str) -> Vec<String> {
    let height = blocks.iter().map(Vec::len).max().unwrap_or(0);
    let middle = (height.max(1) - 1) / 2;
    let mut lines = vec![String::new(); height];
    for (i, block) in blocks.iter().enumerate() {
        let width = block.iter().map(|line| line.chars().count()).max().unwrap_or(0);
        let top = middle - (block.len().max(1) - 1) / 2;
        for (k, line) in lines.iter_mut().enumerate() {
            if i > 0 {
                *line += &if k == middle { sign.to_owned() } else { " ".repeat(sign.len()) };
            }
            let cell = k.checked_sub(top).and_then(|at| block.get(at)).map_or("", String::as_str);
            *line += &format!("{cell:<width$}");
        }
    }
    lines
}
