//! Matrices and displayed equations in MathML.

/// Round brackets drawn by the browser's borders: a fence grows with its rows only where a font for mathematics is
/// installed.
const BORDER: &str = "border: solid; border-width: 0 .09em";

/// Matrices wider than this are listed row by row.
pub const WIDEST_MATRIX: usize = 9;

/// A matrix in brackets, from its rows of entries.
pub fn matrix(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    format!("<mtable style=\"{BORDER}; border-radius: .7em; padding: .1em .2em\">{}</mtable>", cells(rows))
}

/// A matrix of one column.
pub fn column(entries: impl IntoIterator<Item = String>) -> String {
    matrix(entries.into_iter().map(|entry| vec![entry]))
}

/// Lines under each other, without brackets.
pub fn lines(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    format!("<mtable>{}</mtable>", cells(rows))
}

/// A matrix of one column with the names of its rows behind: the brackets are borders of its cells.
pub fn named_column(entries: &[String], names: &[&str]) -> String {
    let last = entries.len().saturating_sub(1);
    let row = |(i, (entry, name)): (usize, (&String, &&str))| {
        let radius = |at_end: bool| if at_end { ".7em" } else { "0" };
        let (top, bottom) = (radius(i == 0), radius(i == last));
        let border = format!("{BORDER}; border-radius: {top} {top} {bottom} {bottom}");
        format!(
            "<mtr><mtd style=\"{border}\">{entry}</mtd><mtd><mspace width=\"1em\"/><mtext>{name}</mtext></mtd></mtr>"
        )
    };
    format!("<mtable>{}</mtable>", entries.iter().zip(names).enumerate().map(row).collect::<String>())
}

/// Sides joined by equality signs, on a line of their own that scrolls when it is too long.
pub fn display(sides: &[String]) -> String {
    let sides = sides.join("<mo>=</mo>");
    format!("<div style=\"overflow-x: auto; padding: .3em 0\"><math display=\"block\">{sides}</math></div>")
}

/// An expression within a line of text.
pub fn inline(expression: &str) -> String {
    format!("<math>{expression}</math>")
}

pub fn letter(name: &str) -> String {
    format!("<mi>{name}</mi>")
}

pub fn sub(name: &str, index: &str) -> String {
    format!("<msub><mi>{name}</mi><mi>{index}</mi></msub>")
}

pub fn zero() -> String {
    "<mn>0</mn>".to_owned()
}

fn cells(rows: impl IntoIterator<Item = Vec<String>>) -> String {
    rows.into_iter()
        .map(|row| format!("<mtr>{}</mtr>", row.iter().map(|cell| format!("<mtd>{cell}</mtd>")).collect::<String>()))
        .collect()
}
