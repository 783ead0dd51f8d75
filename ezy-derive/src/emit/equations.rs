//! The equations of a scene, from the coordinates to the equations of motion. Signs: `docs/notation.md`. Nothing is typed in
//! here but the form of the equations; every entry is the expression that is compiled.

use std::ops::Range;

use super::abbreviations::Abbreviations;
use super::equation::{Equation, Side, WIDEST_MATRIX};
use crate::mechanics::symbols::Symbols;
use crate::mechanics::{Equations, ForceTemplate, RowTemplate, Templates};
use crate::model::{InputId, Loop, Model};
use crate::symbolic::SumId;
use crate::symbolic::print::{Names, Printed, print, print_definition};
use crate::symbolic::spelling;

/// A symbol of the equations that is no letter.
struct Symbol(&'static str, &'static str, &'static str);

const C_Q: Symbol = Symbol("C_q", "C_q", "<msub><mi>C</mi><mi>q</mi></msub>");
const C_Q_T: Symbol = Symbol("C_q^T", "C_q^T", "<msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup>");
const S_T: Symbol = Symbol("S^T", "S^T", "<msup><mi>S</mi><mi>T</mi></msup>");
const S_V: Symbol = Symbol("S v + s_t", "S v + s_t", "<mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub>");
const LAMBDA_C: Symbol = Symbol("lambda_C", "\\lambda_C", "<msub><mi>λ</mi><mi>C</mi></msub>");
const LAMBDA_S: Symbol = Symbol("lambda_S", "\\lambda_S", "<msub><mi>λ</mi><mi>S</mi></msub>");
const MINUS_H: Symbol = Symbol("-h", "-h", "<mrow><mo>−</mo><mi>h</mi></mrow>");
const MINUS_S: Symbol = Symbol("-s", "-s", "<mrow><mo>−</mo><mi>s</mi></mrow>");
const DIAGONAL: Symbol = Symbol("diag M", "\\mathrm{diag}\\,M", "<mtext>diag </mtext><mi>M</mi>");
const ZERO: Symbol = Symbol("0", "0", "<mn>0</mn>");

impl From<Symbol> for Printed {
    fn from(Symbol(text, latex, mathml): Symbol) -> Self {
        Self::atom(text, latex, mathml)
    }
}

impl From<Symbol> for Side {
    fn from(symbol: Symbol) -> Self {
        Self::One(symbol.into())
    }
}

fn letter(name: &str) -> Printed {
    Printed::atom(name, name, format!("<mi>{name}</mi>"))
}

/// A letter and what it is.
fn definition(name: &'static str, symbol: &str, value: Side, rows: &[String]) -> Equation {
    Equation::new(name, &[Side::One(letter(symbol)), value], rows)
}

/// Every equation of a scene; what it does not have is left out.
pub fn of_scene(equations: &Equations, names: &Abbreviations<'_>) -> Vec<Equation> {
    let constraints = &equations.constraints;
    let (n_h, n_c) = (constraints.n_position_rows, constraints.rows.len());
    let print = |&sum: &SumId| names.print(sum);
    let column = |sums: &[SumId]| Side::column(sums.iter().map(print));
    let symbols = &equations.symbols;
    let mut list = vec![
        definition("coordinates", "q", Side::column(symbols.coordinate_names().iter().cloned()), &[]),
        definition("velocities", "v", Side::column(symbols.velocity_names().iter().cloned()), &[]),
    ];
    if !equations.points.is_empty() {
        let points = equations.points.iter();
        let points = points.map(|point| (spelling::name(&point.name), column(&point.position).within()));
        list.push(Equation::definitions("points", &points.collect::<Vec<_>>()));
    }
    let row_names =
        |rows: Range<usize>| -> Vec<String> { constraints.rows[rows].iter().map(|row| row.name.clone()).collect() };
    if n_h > 0 {
        let rows = row_names(0..n_h);
        let residual = [ZERO.into(), Side::One(letter("C")), column(&constraints.position)];
        list.push(Equation::new("position constraint", &residual, &rows));
        list.push(jacobian("Jacobian of the position constraint", C_Q.into(), equations, names, 0..n_h));
        let h = column(&constraints.convective[..n_h]);
        list.push(definition("convective term of the position constraint", "h", h, &rows));
    }
    if n_c > n_h {
        let rows = row_names(n_h..n_c);
        let residual = [ZERO.into(), S_V.into(), column(&constraints.velocity[n_h..])];
        list.push(Equation::new("velocity constraint", &residual, &rows));
        list.push(jacobian("Jacobian of the velocity constraint", letter("S"), equations, names, n_h..n_c));
        let s = column(&constraints.convective[n_h..]);
        list.push(definition("convective term of the velocity constraint", "s", s, &rows));
    }
    let coordinates: Vec<String> = symbols.coordinate_names().iter().map(|name| name.text.clone()).collect();
    let masses = [DIAGONAL.into(), column(&equations.mass_entries)];
    list.push(Equation::new("mass matrix", &masses, &coordinates));
    list.push(definition("applied force", "F", column(&equations.force), &coordinates));
    if !equations.potential.is_zero() {
        list.push(definition("potential energy", "V", Side::One(names.print(equations.potential)), &[]));
    }
    list.extend(rates(&equations.inputs, &equations.rates, symbols, |sum| names.print(sum)));
    let definitions = names.definitions();
    if !definitions.is_empty() {
        list.push(Equation::definitions("abbreviations", &definitions));
    }
    list.push(motion(n_h > 0, n_c > n_h));
    list
}

/// Some rows of G: a matrix, or what is not zero in each row when it is wide.
fn jacobian(
    name: &'static str,
    symbol: Printed,
    equations: &Equations,
    names: &Abbreviations<'_>,
    rows: Range<usize>,
) -> Equation {
    let (constraints, n_q) = (&equations.constraints, equations.force.len());
    let row_names = || constraints.rows[rows.clone()].iter().map(|row| row.name.clone());
    let entries = constraints.jacobian[rows.clone()].iter();
    if n_q <= WIDEST_MATRIX {
        let dense = entries.clone().map(|entries| {
            let mut row: Vec<Printed> = (0..n_q).map(|_| ZERO.into()).collect();
            entries.iter().for_each(|&(column, entry)| row[column] = names.print(entry));
            row
        });
        let matrix = Side::Matrix(dense.collect());
        if matrix.fits() {
            return Equation::new(name, &[Side::One(symbol), matrix], &row_names().collect::<Vec<_>>());
        }
    }
    let coordinates = equations.symbols.coordinate_names();
    let listed = row_names().zip(entries).map(|(name, entries)| {
        (name, entries.iter().map(|&(column, entry)| (coordinates[column].clone(), names.print(entry))).collect())
    });
    Equation::new(name, &[Side::One(symbol), Side::Listing(listed.collect())], &[])
}

/// `[M C_qᵀ Sᵀ; C_q 0 0; S 0 0] [a; λ_C; λ_S] = [F; −h; −s]`, without the blocks that the scene does not have.
fn motion(position: bool, velocity: bool) -> Equation {
    fn kept<T>(block: [T; 3], position: bool, velocity: bool) -> Vec<T> {
        let kept = block.into_iter().zip([true, position, velocity]);
        kept.filter_map(|(entry, kept)| kept.then_some(entry)).collect()
    }
    let zero = || ZERO.into();
    let rows = [[letter("M"), C_Q_T.into(), S_T.into()], [C_Q.into(), zero(), zero()], [letter("S"), zero(), zero()]];
    let rows = rows.map(|row| kept(row, position, velocity));
    let matrix = kept(rows, position, velocity);
    let unknowns = kept([letter("a"), LAMBDA_C.into(), LAMBDA_S.into()], position, velocity);
    let right = kept([letter("F"), MINUS_H.into(), MINUS_S.into()], position, velocity);
    Equation::new("equations of motion", &[Side::Product(matrix, unknowns), Side::column(right)], &[])
}

/// `d/dt z = …` of each first-order state, which are the last of the inputs.
fn rates(inputs: &[InputId], rates: &[SumId], symbols: &Symbols, print: impl Fn(SumId) -> Printed) -> Option<Equation> {
    let states = inputs[inputs.len() - rates.len()..].iter().filter_map(|&id| symbols.input(id));
    let definitions =
        states.zip(rates).map(|(state, &rate)| (spelling::time_derivative(&symbols.symbol(state)), print(rate)));
    let definitions: Vec<_> = definitions.collect();
    (!definitions.is_empty()).then(|| Equation::definitions("rates of the first-order states", &definitions))
}

/// The same of a scene with counts.
pub fn rates_of(templates: &Templates<'_>) -> Option<Equation> {
    let Templates { algebra, symbols, inputs, rates, .. } = templates;
    let sums: Vec<SumId> = rates.iter().map(|(rate, _)| *rate).collect();
    self::rates(inputs, &sums, symbols, |sum| print(algebra, symbols, sum))
}

/// The equations of motion of a scene with counts.
pub fn motion_of(templates: &Templates<'_>) -> Equation {
    let has = |position: bool| templates.rows.iter().any(|row| row.is_position() == position);
    motion(has(true), has(false))
}

/// The `let` values that equations of a scene with counts call by their names.
pub fn lets_of(templates: &Templates<'_>) -> Option<Equation> {
    let Templates { algebra, symbols, .. } = templates;
    let named = symbols.lets().iter().filter(|of| of.coefficient.is_some());
    let definitions = named.map(|of| (of.name.clone(), print_definition(algebra, symbols, of.value)));
    let definitions: Vec<_> = definitions.collect();
    (!definitions.is_empty()).then(|| Equation::definitions("abbreviations", &definitions))
}

/// The equations of an item of a scene with counts, which all of its members share.
pub struct OfItems<'a> {
    pub model: &'a Model,
    pub templates: &'a Templates<'a>,
}

impl OfItems<'_> {
    pub fn print(&self, sum: SumId) -> Printed {
        print(&self.templates.algebra, &self.templates.symbols, sum)
    }

    fn column(&self, sums: &[SumId]) -> Side {
        Side::column(sums.iter().map(|&sum| self.print(sum)))
    }

    /// Masses of the bodies of an array; `body[i].x` and so on are its coordinates.
    pub fn of_bodies(&self, masses: &[SumId], coordinates: &[String]) -> Vec<Equation> {
        vec![Equation::new("mass matrix", &[DIAGONAL.into(), self.column(masses)], coordinates)]
    }

    pub fn of_row(&self, template: &RowTemplate<'_>) -> Vec<Equation> {
        let (constraints, stem) = (&template.constraints, template.row.name.to_string());
        let index = indices(self.model, &template.row.loops);
        let names = constraints.rows.iter().map(|row| {
            let suffix = row.name.strip_prefix(&stem).unwrap_or_default();
            format!("{stem}{index}{suffix}")
        });
        let names: Vec<String> = names.collect();
        let (name, symbol, values, convective) = match template.is_position() {
            true => ("position constraint", letter("C"), &constraints.position, "h"),
            false => ("velocity constraint", S_V.into(), &constraints.velocity, "s"),
        };
        let coordinates = self.templates.symbols.coordinate_names();
        let listed = names.iter().zip(&constraints.jacobian).map(|(name, row)| {
            let entries = row.iter().map(|&(i, entry)| (coordinates[i].clone(), self.print(entry)));
            (name.clone(), entries.collect())
        });
        vec![
            Equation::new(name, &[ZERO.into(), Side::One(symbol), self.column(values)], &names),
            definition("its Jacobian", "G", Side::Listing(listed.collect()), &[]),
            definition("its convective term", convective, self.column(&constraints.convective), &names),
        ]
    }

    pub fn of_force(&self, template: &ForceTemplate<'_>) -> Vec<Equation> {
        let (places, entries): (Vec<usize>, Vec<SumId>) = template.entries.iter().copied().unzip();
        let coordinates = self.templates.symbols.coordinate_names();
        let names: Vec<String> = places.into_iter().map(|i| coordinates[i].text.clone()).collect();
        let mut list = Vec::new();
        if !entries.is_empty() {
            list.push(definition("applied force", "F", self.column(&entries), &names));
        }
        if !template.potential.is_zero() {
            list.push(definition("potential energy", "V", Side::One(self.print(template.potential)), &[]));
        }
        list
    }

    /// Where a point is, or what an output is.
    pub fn of_values(&self, name: &'static str, symbol: &str, values: &[SumId]) -> Vec<Equation> {
        let value = if let [value] = values { Side::One(self.print(*value)) } else { self.column(values) };
        let symbol = Side::One(Printed::atom(
            symbol,
            format!("\\mathrm{{{}}}", symbol.replace('_', "\\_")),
            format!("<mtext>{symbol}</mtext>"),
        ));
        vec![Equation::new(name, &[symbol, value], &[])]
    }
}

/// `[i]`, or nothing outside any `for`.
pub fn indices(model: &Model, loops: &[Loop]) -> String {
    let names: Vec<&str> = loops.iter().map(|around| model.indices[around.index.0].as_str()).collect();
    if names.is_empty() { String::new() } else { format!("[{}]", names.join(",")) }
}
