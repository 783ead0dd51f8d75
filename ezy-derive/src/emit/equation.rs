//! Equations between matrices of printed expressions, as text, LaTeX and MathML.

use proc_macro2::TokenStream;
use quote::quote;

use crate::symbolic::print::Printed;

/// One equation in the three notations.
#[derive(Debug, Clone)]
pub struct Equation {
    /// What it is: `position constraint`.
    pub name: &'static str,
    text: String,
    latex: String,
    /// What stands within `<math>`.
    pub mathml: String,
}

/// What stands on a side of an equation.
#[derive(Debug, Clone)]
pub enum Side {
    One(Printed),
    Matrix(Vec<Vec<Printed>>),
    /// A matrix times a column.
    Product(Vec<Vec<Printed>>, Vec<Printed>),
    /// Rows too wide for a matrix: of each what is not zero, with its column.
    Listing(Vec<(String, Vec<(Printed, Printed)>)>),
}

/// Matrices of more columns are listed by rows: three bodies still fit on a page.
pub const WIDEST_MATRIX: usize = 9;

/// Columns of text are aligned up to this width.
const WIDEST_COLUMN: usize = 100;

/// Signs of a line of an entry, so that with its row's name it fits on a page.
const WIDEST_LINE: usize = 76;

/// How far later lines of an expression stand to the right.
const INDENT: &str = "    ";

/// Round brackets drawn by the browser's borders: a fence grows with its rows only where a font for mathematics is
/// installed.
const BORDER: &str = "border: solid; border-width: 0 .09em";

impl Equation {
    /// Sides joined by equality signs; names of rows stand behind the last side.
    pub fn new(name: &'static str, sides: &[Side], rows: &[String]) -> Self {
        let blocks: Vec<Vec<String>> = sides.iter().map(Side::lines).collect();
        let names = match sides.last() {
            Some(Side::Matrix(entries)) => {
                let of_row = |(name, row): (&String, &Vec<Printed>)| {
                    let later = row.iter().map(|entry| indented(entry).len()).max().unwrap_or(1) - 1;
                    std::iter::once(name.clone()).chain(std::iter::repeat_n(String::new(), later)).collect::<Vec<_>>()
                };
                rows.iter().zip(entries).flat_map(of_row).collect()
            }
            _ => rows.to_vec(),
        };
        let lines = side_by_side(&[side_by_side(&blocks, " = "), names], "   ");
        let latex: Vec<String> = sides.iter().map(Side::latex).collect();
        let n = sides.len();
        let mathml = sides.iter().enumerate().map(|(i, side)| side.mathml(if i + 1 == n { rows } else { &[] }));
        Self {
            name,
            text: lines.iter().map(|line| line.trim_end().to_owned() + "\n").collect(),
            latex: latex.join(" = "),
            mathml: mathml.collect::<Vec<_>>().join("<mo>=</mo>"),
        }
    }

    /// Symbols and what they stand for, under each other.
    pub fn definitions(name: &'static str, list: &[(Printed, Printed)]) -> Self {
        let width = list.iter().map(|(symbol, _)| symbol.text.chars().count()).max().unwrap_or(0);
        let text = list.iter().map(|(symbol, value)| {
            let gap = format!("\n{:width$}   ", "");
            format!("{:width$} = {}\n", symbol.text, indented(value).join(&gap))
        });
        let latex: Vec<String> = list
            .iter()
            .map(|(symbol, value)| {
                format!("{} &= {}", symbol.latex, value.latex_lines(WIDEST_LINE).join(" \\\\ & \\quad "))
            })
            .collect();
        let rows =
            list.iter().map(|(symbol, value)| vec![symbol.mathml.clone(), "<mo>=</mo>".to_owned(), mathml_of(value)]);
        Self {
            name,
            text: text.collect(),
            latex: format!("\\begin{{aligned}} {} \\end{{aligned}}", latex.join(" \\\\ ")),
            mathml: format!("<mtable>{}</mtable>", cells(rows)),
        }
    }

    /// The value of `ezy::Equation`.
    pub fn tokens(&self) -> TokenStream {
        let Self { name, text, latex, mathml } = self;
        let mathml = format!("<math display=\"block\">{mathml}</math>");
        quote!(ezy::Equation { name: #name, text: #text, latex: #latex, mathml: #mathml })
    }
}

impl Side {
    pub fn column(entries: impl IntoIterator<Item = Printed>) -> Self {
        Self::Matrix(entries.into_iter().map(|entry| vec![entry]).collect())
    }

    /// Whether its rows fit on a page.
    pub fn fits(&self) -> bool {
        self.lines().iter().all(|line| line.chars().count() <= WIDEST_COLUMN)
    }

    /// As a value within an equation; a column in text as a row.
    pub fn within(&self) -> Printed {
        let text = match self {
            Self::Matrix(rows) => {
                let entries: Vec<&str> = rows.iter().flatten().map(|entry| entry.text.as_str()).collect();
                format!("({})", entries.join(", "))
            }
            _ => self.lines().join(" "),
        };
        Printed::atom(text, self.latex(), self.mathml(&[]))
    }

    fn lines(&self) -> Vec<String> {
        match self {
            Self::One(printed) => indented(printed),
            Self::Matrix(rows) => {
                let rows: Vec<Vec<Vec<String>>> = rows.iter().map(|row| row.iter().map(indented).collect()).collect();
                let widths = widths(&rows);
                let of_row = |row: &Vec<Vec<String>>| -> Vec<String> {
                    let height = row.iter().map(Vec::len).max().unwrap_or(0);
                    let line = |k: usize| {
                        let cell = |(lines, &width): (&Vec<String>, &usize)| {
                            format!("{:<width$}", lines.get(k).map_or("", String::as_str))
                        };
                        format!("[ {} ]", row.iter().zip(&widths).map(cell).collect::<Vec<_>>().join("  "))
                    };
                    (0..height).map(line).collect()
                };
                rows.iter().flat_map(of_row).collect()
            }
            Self::Product(matrix, column) => {
                let column = Self::column(column.iter().cloned());
                side_by_side(&[Self::Matrix(matrix.clone()).lines(), column.lines()], " ")
            }
            Self::Listing(rows) => {
                let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
                let row = |(name, entries): &(String, Vec<(Printed, Printed)>)| {
                    let lines = indented(&listed(entries)).into_iter().enumerate();
                    let line = |(i, line)| format!("{:width$}  {line}", if i == 0 { name } else { "" });
                    lines.map(line).collect::<Vec<_>>()
                };
                rows.iter().flat_map(row).collect()
            }
        }
    }

    fn latex(&self) -> String {
        match self {
            Self::One(printed) => latex_of(printed),
            Self::Matrix(rows) => {
                let row = |row: &Vec<Printed>| row.iter().map(latex_of).collect::<Vec<_>>().join(" & ");
                let rows = rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ ");
                format!("\\begin{{bmatrix}} {rows} \\end{{bmatrix}}")
            }
            Self::Product(matrix, column) => {
                Self::Matrix(matrix.clone()).latex() + &Self::column(column.iter().cloned()).latex()
            }
            Self::Listing(rows) => {
                let row = |(name, entries): &(String, Vec<(Printed, Printed)>)| {
                    let entries = listed(entries).latex_lines(WIDEST_LINE).join(" \\\\ & \\quad ");
                    format!("\\text{{{}}} & {entries}", name.replace('_', "\\_"))
                };
                let rows = rows.iter().map(row).collect::<Vec<_>>().join(" \\\\ ");
                format!("\\begin{{array}}{{ll}} {rows} \\end{{array}}")
            }
        }
    }

    /// Names of rows stand behind a column, whose brackets are then borders of its cells.
    fn mathml(&self, names: &[String]) -> String {
        let of_row = |row: &Vec<Printed>| row.iter().map(mathml_of).collect();
        match self {
            Self::One(printed) => mathml_of(printed),
            Self::Matrix(rows) if names.is_empty() || rows.iter().any(|row| row.len() != 1) => {
                let style = format!("{BORDER}; border-radius: .7em; padding: .1em .2em");
                format!("<mtable style=\"{style}\">{}</mtable>", cells(rows.iter().map(of_row)))
            }
            Self::Matrix(rows) => {
                let last = rows.len().saturating_sub(1);
                let row = |(i, (row, name)): (usize, (&Vec<Printed>, &String))| {
                    let radius = |at_end: bool| if at_end { ".7em" } else { "0" };
                    let (top, bottom) = (radius(i == 0), radius(i == last));
                    let style = format!("{BORDER}; border-radius: {top} {top} {bottom} {bottom}");
                    let name = format!("<mspace width=\"1em\"/><mtext>{name}</mtext>");
                    format!("<mtr><mtd style=\"{style}\">{}</mtd><mtd>{name}</mtd></mtr>", mathml_of(&row[0]))
                };
                format!("<mtable>{}</mtable>", rows.iter().zip(names).enumerate().map(row).collect::<String>())
            }
            Self::Product(matrix, column) => {
                Self::Matrix(matrix.clone()).mathml(&[]) + &Self::column(column.iter().cloned()).mathml(names)
            }
            Self::Listing(rows) => {
                let row = |(name, entries): &(String, Vec<(Printed, Printed)>)| {
                    vec![format!("<mtext>{name}</mtext>"), mathml_of(&listed(entries))]
                };
                format!("<mtable>{}</mtable>", cells(rows.iter().map(row)))
            }
        }
    }
}

/// Lines of text.
fn indented(printed: &Printed) -> Vec<String> {
    let lines = printed.text_lines(WIDEST_LINE).into_iter().enumerate();
    lines.map(|(i, line)| if i == 0 { line } else { INDENT.to_owned() + &line }).collect()
}

/// Widths of columns; cells hold lines.
fn widths(rows: &[Vec<Vec<String>>]) -> Vec<usize> {
    let of = |lines: &Vec<String>| lines.iter().map(|line| line.chars().count()).max().unwrap_or(0);
    let n_columns = rows.first().map_or(0, Vec::len);
    let width = |j: usize| rows.iter().map(|row| of(&row[j])).max().unwrap_or(0).min(WIDEST_COLUMN);
    (0..n_columns).map(width).collect()
}

fn latex_of(printed: &Printed) -> String {
    match &printed.latex_lines(WIDEST_LINE)[..] {
        [line] => line.clone(),
        lines => format!("\\begin{{aligned}} & {} \\end{{aligned}}", lines.join(" \\\\ & \\quad ")),
    }
}

fn mathml_of(printed: &Printed) -> String {
    match &printed.mathml_lines(WIDEST_LINE)[..] {
        [line] => line.clone(),
        lines => {
            let gap = |i: usize| if i == 0 { "" } else { "<mspace width=\"2em\"/>" };
            let row = |(i, line): (usize, &String)| {
                format!("<mtr><mtd style=\"text-align: left\">{}{line}</mtd></mtr>", gap(i))
            };
            format!("<mtable>{}</mtable>", lines.iter().enumerate().map(row).collect::<String>())
        }
    }
}

/// `x: 1, y: 2*b`: columns and what stands there.
fn listed(entries: &[(Printed, Printed)]) -> Printed {
    let mut list = Printed::atom("", "", "");
    for (i, (column, entry)) in entries.iter().enumerate() {
        if i > 0 {
            list.push(", ", ",\\; ", "<mo>,</mo><mspace width=\"0.8em\"/>");
            list.push_break();
        }
        list.append_item(column);
        list.push(": ", "\\colon ", "<mo>:</mo>");
        list.append_item(entry);
    }
    list
}

/// Rows of a table.
fn cells(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let row = |row: Vec<String>| row.iter().map(|cell| format!("<mtd>{cell}</mtd>")).collect::<String>();
    rows.into_iter().map(|cells| format!("<mtr>{}</mtr>", row(cells))).collect()
}

/// Blocks of lines on one height, joined by a sign in the middle line.
fn side_by_side(blocks: &[Vec<String>], sign: &str) -> Vec<String> {
    let height = blocks.iter().map(Vec::len).max().unwrap_or(0);
    // an expression in lines begins where its equation does
    let in_lines = blocks.last().is_some_and(|block| block.get(1).is_some_and(|line| line.starts_with(INDENT)));
    let middle = if in_lines { 0 } else { (height.max(1) - 1) / 2 };
    let mut lines = vec![String::new(); height];
    for (i, block) in blocks.iter().enumerate() {
        let width = block.iter().map(|line| line.chars().count()).max().unwrap_or(0).min(WIDEST_COLUMN);
        let top = middle.saturating_sub((block.len().max(1) - 1) / 2);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn atom(text: &str) -> Printed {
        Printed::atom(text, text, format!("<mi>{text}</mi>"))
    }

    #[test]
    fn analytic_sides_stand_on_one_height_with_names_of_rows_behind() {
        let column = Side::column(["x", "2*y", "z"].map(atom));
        let equation = Equation::new("h", &[Side::One(atom("h")), column], &["a", "b", "c"].map(str::to_owned));
        assert_eq!(equation.text, "    [ x   ]   a\nh = [ 2*y ]   b\n    [ z   ]   c\n");
        assert_eq!(equation.latex, "h = \\begin{bmatrix} x \\\\ 2*y \\\\ z \\end{bmatrix}");
        assert_eq!(equation.mathml.matches("<mtext>").count(), 3, "{}", equation.mathml);
    }

    #[test]
    fn analytic_wide_matrix_is_listed_by_rows() {
        let listing = Side::Listing(vec![("rail".to_owned(), vec![(atom("x"), atom("1")), (atom("y"), atom("2*b"))])]);
        assert_eq!(listing.lines(), ["rail  x: 1, y: 2*b"]);
        assert_eq!(listing.latex(), "\\begin{array}{ll} \\text{rail} & x\\colon 1,\\; y\\colon 2*b \\end{array}");
    }

    #[test]
    fn analytic_long_entry_goes_on_below_with_its_name_beside_the_first_line() {
        let mut long = atom("x");
        for _ in 0..30 {
            long.push_break();
            long.push(" + x", " + x", "<mo>+</mo>");
        }
        let equation = Equation::new(
            "F",
            &[Side::One(atom("F")), Side::column([long.clone(), atom("1")])],
            &["a", "b"].map(str::to_owned),
        );
        let lines: Vec<&str> = equation.text.lines().collect();
        assert!(lines[0].starts_with("    [ x + x") && lines[0].ends_with("]   a"), "{}", equation.text);
        assert!(lines[1].starts_with("F = [     + x") && lines[2].ends_with("]   b"), "{}", equation.text);
        assert!(
            equation.latex.contains("\\begin{aligned} & x + x") && equation.latex.contains(" \\\\ & \\quad {} + x")
        );
        let alone = Equation::new("V", &[Side::One(atom("V")), Side::One(long)], &[]);
        assert!(alone.text.starts_with("V = x + x") && alone.text.contains("\n        + x"), "{}", alone.text);
    }

    #[test]
    fn analytic_long_lines_do_not_widen_the_others() {
        let text: String = std::iter::repeat_n('x', 1000).collect();
        let column = Side::column([atom(&text), atom("1"), atom("1")]);
        let written = Equation::new("F", &[Side::One(atom("F")), column], &[]).text;
        assert!(written.lines().skip(1).all(|line| line.chars().count() <= WIDEST_COLUMN + 10), "{written}");
    }
}
