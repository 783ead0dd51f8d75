//! The equations of a scene, from the coordinates to the equations of motion. Signs: `docs/notation.md`.

use std::ops::Range;

use super::Page;
use super::mathml::{WIDEST_MATRIX, column, display, letter, lines, matrix, named_column, sub, zero};
use crate::emit::abbreviations::Abbreviations;
use crate::mechanics::Equations;
use crate::symbolic::SumId;
use crate::symbolic::print::Printed;
use crate::symbolic::spelling;

/// Headings and displayed equations; what the scene does not have is left out.
pub fn write(page: &mut Page, equations: &Equations, names: &Abbreviations<'_>) {
    let printer = Printer { equations, names };
    let constraints = &equations.constraints;
    let n_h = constraints.n_position_rows;
    let n_c = constraints.rows.len();
    let of = |printed: &[Printed]| column(printed.iter().map(|p| p.mathml.clone()));

    page.heading("Coordinates and velocities");
    let positions = of(equations.symbols.coordinate_names()) + "<mo>,</mo><mspace width=\"1em\"/>" + &letter("v");
    page.paragraph(display(&[letter("q"), positions, of(equations.symbols.velocity_names())]));
    if !equations.points.is_empty() {
        page.heading("Points");
        page.paragraph(display(&[printer.points()]));
    }
    if n_h > 0 {
        page.heading("Position constraint");
        page.paragraph(printer.residual(letter("C"), 0..n_h, &constraints.position));
        page.paragraph(printer.jacobian(&sub("C", "q"), 0..n_h));
        page.paragraph(display(&[letter("h"), printer.column(&constraints.convective[..n_h])]));
    }
    if n_c > n_h {
        page.heading("Velocity constraint");
        let rows = format!("{}{}<mo>+</mo>{}", letter("S"), letter("v"), sub("s", "t"));
        page.paragraph(printer.residual(rows, n_h..n_c, &constraints.velocity[n_h..]));
        page.paragraph(printer.jacobian(&letter("S"), n_h..n_c));
        page.paragraph(display(&[letter("s"), printer.column(&constraints.convective[n_h..])]));
    }
    page.heading("Mass matrix");
    page.paragraph(printer.mass());
    page.heading("Applied force");
    page.paragraph(display(&[letter("F"), printer.column(&equations.force)]));
    if !equations.potential.is_zero() {
        page.heading("Potential energy");
        page.paragraph(display(&[letter("V"), printer.entry(equations.potential)]));
    }
    let definitions = names.definitions();
    if !definitions.is_empty() {
        page.heading("Abbreviations");
        let rows = definitions.into_iter().map(|(symbol, value)| vec![symbol.mathml + "<mo>=</mo>" + &value.mathml]);
        page.paragraph(display(&[lines(rows)]));
    }
    page.heading("Equations of motion");
    page.paragraph(motion(n_h > 0, n_c > n_h));
}

struct Printer<'a> {
    equations: &'a Equations,
    names: &'a Abbreviations<'a>,
}

impl Printer<'_> {
    fn entry(&self, sum: SumId) -> String {
        self.names.print(sum).mathml
    }

    fn column(&self, sums: &[SumId]) -> String {
        column(sums.iter().map(|&sum| self.entry(sum)))
    }

    fn points(&self) -> String {
        lines(self.equations.points.iter().map(|point| {
            let position = self.column(&point.position);
            vec![format!("{}<mo>=</mo>{position}", spelling::name(&point.name).mathml)]
        }))
    }

    /// Rows that are zero, with their names behind.
    fn residual(&self, symbol: String, rows: Range<usize>, sums: &[SumId]) -> String {
        let names: Vec<&str> = self.equations.constraints.rows[rows].iter().map(|row| row.name.as_str()).collect();
        let entries: Vec<String> = sums.iter().map(|&sum| self.entry(sum)).collect();
        display(&[zero(), symbol, named_column(&entries, &names)])
    }

    /// Some rows of G: as a matrix, or row by row when it is wide.
    fn jacobian(&self, symbol: &str, rows: Range<usize>) -> String {
        let constraints = &self.equations.constraints;
        let n_q = self.equations.force.len();
        if n_q <= WIDEST_MATRIX {
            let dense = rows.map(|i| {
                let mut row = vec![zero(); n_q];
                constraints.jacobian[i].iter().for_each(|&(column, entry)| row[column] = self.entry(entry));
                row
            });
            return display(&[symbol.to_owned(), matrix(dense)]);
        }
        let coordinates = self.equations.symbols.coordinate_names();
        let listed = rows.map(|i| {
            let entries = constraints.jacobian[i]
                .iter()
                .map(|&(column, entry)| format!("{}<mo>:</mo>{}", coordinates[column].mathml, self.entry(entry)));
            let entries = entries.collect::<Vec<_>>().join("<mo>,</mo><mspace width=\"0.8em\"/>");
            vec![format!("<mtext>{}</mtext>", constraints.rows[i].name), entries]
        });
        display(&[symbol.to_owned(), lines(listed)])
    }

    fn mass(&self) -> String {
        let entries: Vec<String> = self.equations.mass_entries.iter().map(|&mass| self.entry(mass)).collect();
        let listed = entries.join("<mo>,</mo>");
        display(&[letter("M"), format!("<mi>diag</mi><mo>(</mo>{listed}<mo>)</mo>")])
    }
}

/// `[M C_qᵀ Sᵀ; C_q 0 0; S 0 0] [a; λ_C; λ_S] = [F; −h; −s]`, without the blocks that the scene does not have.
fn motion(position: bool, velocity: bool) -> String {
    fn kept<T>(block: [T; 3], position: bool, velocity: bool) -> impl Iterator<Item = T> {
        block.into_iter().zip([true, position, velocity]).filter_map(|(entry, kept)| kept.then_some(entry))
    }
    let minus = |name: &str| format!("<mrow><mo>−</mo><mi>{name}</mi></mrow>");
    let c_q_transposed = "<msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup>".to_owned();
    let s_transposed = "<msup><mi>S</mi><mi>T</mi></msup>".to_owned();
    let rows =
        [[letter("M"), c_q_transposed, s_transposed], [sub("C", "q"), zero(), zero()], [letter("S"), zero(), zero()]];
    let rows = kept(rows, position, velocity).map(|row| kept(row, position, velocity).collect());
    let unknowns = column(kept([letter("a"), sub("λ", "C"), sub("λ", "S")], position, velocity));
    let right = column(kept([letter("F"), minus("h"), minus("s")], position, velocity));
    display(&[matrix(rows) + &unknowns, right])
}
