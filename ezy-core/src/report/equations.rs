//! The equations of a scene, composed from the printed expressions of [`SceneInfo`].
//!
//! Symbols and signs: `docs/notation.md`. Nothing is typed in here but the form of the equations; every entry
//! comes from the expression that is compiled.

use crate::model::{Abbreviation, Formula, SceneInfo};

pub use super::matrix::bracketed;
use super::matrix::{Cell, Listing, Matrix, Names, equation_lines};

/// One equation in the three renderings.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equation {
    /// What it is, in words: `position constraint`.
    pub name: &'static str,
    /// Plain text, several aligned lines.
    pub text: String,
    /// LaTeX, to stand in display mode.
    pub latex: String,
    /// A `<math>` element.
    pub mathml: String,
}

/// Matrices of more columns are listed by rows: three bodies still fit on a page.
const WIDEST_MATRIX: usize = 9;

const ZERO: Formula = Formula { text: "0", latex: "0", mathml: "<mrow><mn>0</mn></mrow>" };
const C: Formula = Formula { text: "C", latex: "C", mathml: "<mi>C</mi>" };
const C_Q: Formula = Formula { text: "C_q", latex: "C_q", mathml: "<msub><mi>C</mi><mi>q</mi></msub>" };
const H: Formula = Formula { text: "h", latex: "h", mathml: "<mi>h</mi>" };
const S: Formula = Formula { text: "S", latex: "S", mathml: "<mi>S</mi>" };
const S_V: Formula = Formula {
    text: "S v + s_t",
    latex: "S v + s_t",
    mathml: "<mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub>",
};
const S_TERM: Formula = Formula { text: "s", latex: "s", mathml: "<mi>s</mi>" };
const M: Formula = Formula { text: "M", latex: "M", mathml: "<mi>M</mi>" };
pub(super) const DIAGONAL: Formula =
    Formula { text: "diag M", latex: "\\mathrm{diag}\\,M", mathml: "<mtext>diag </mtext><mi>M</mi>" };
const F: Formula = Formula { text: "F", latex: "F", mathml: "<mi>F</mi>" };
const A: Formula = Formula { text: "a", latex: "a", mathml: "<mi>a</mi>" };
const Q: Formula = Formula { text: "q", latex: "q", mathml: "<mi>q</mi>" };
const V_ENERGY: Formula = Formula { text: "V", latex: "V", mathml: "<mi>V</mi>" };
const V: Formula = Formula { text: "v", latex: "v", mathml: "<mi>v</mi>" };
const C_Q_T: Formula =
    Formula { text: "C_q^T", latex: "C_q^T", mathml: "<msubsup><mi>C</mi><mi>q</mi><mi>T</mi></msubsup>" };
const S_T: Formula = Formula { text: "S^T", latex: "S^T", mathml: "<msup><mi>S</mi><mi>T</mi></msup>" };
const LAMBDA_C: Formula =
    Formula { text: "lambda_C", latex: "\\lambda_C", mathml: "<msub><mi>λ</mi><mi>C</mi></msub>" };
const LAMBDA_S: Formula =
    Formula { text: "lambda_S", latex: "\\lambda_S", mathml: "<msub><mi>λ</mi><mi>S</mi></msub>" };
const MINUS_H: Formula = Formula { text: "-h", latex: "-h", mathml: "<mrow><mo>−</mo><mi>h</mi></mrow>" };
const MINUS_S: Formula = Formula { text: "-s", latex: "-s", mathml: "<mrow><mo>−</mo><mi>s</mi></mrow>" };

/// Every equation of a scene, from the coordinates to the equations of motion in matrix form; what a scene
/// does not have (position constraints, velocity constraints) is left out. Of a scene with counts only the equations of motion:
/// the others are those of `report::templates`.
pub fn equations(info: &SceneInfo) -> Vec<Equation> {
    let n_h = info.n_position_rows;
    if info.repeats.is_some() {
        return vec![motion(n_h > 0, info.n_rows() > n_h)];
    }
    let (position_rows, velocity_rows) = info.rows.split_at(n_h);
    let none = || Names(Vec::new());
    let mut list = vec![
        equation("coordinates", &[&Q, &column(info.coordinates.iter().map(|c| c.symbol))], none()),
        equation("velocities", &[&V, &column(info.coordinates.iter().map(|c| c.velocity_symbol))], none()),
    ];
    if !info.points.is_empty() {
        list.push(points(info));
    }
    if !position_rows.is_empty() {
        let names = || Names(position_rows.iter().map(|row| row.name).collect());
        let c = column(position_rows.iter().map(|row| row.constraint));
        let h = column(position_rows.iter().map(|row| row.convective_term));
        list.push(equation("position constraint", &[&C, &c, &ZERO], names()));
        list.push(jacobian("Jacobian of the position constraint", &C_Q, info, 0..n_h));
        list.push(equation("convective term of the position constraint", &[&H, &h], names()));
    }
    if !velocity_rows.is_empty() {
        let names = || Names(velocity_rows.iter().map(|row| row.name).collect());
        let s_v = column(velocity_rows.iter().map(|row| row.constraint));
        let s = column(velocity_rows.iter().map(|row| row.convective_term));
        list.push(equation("velocity constraint", &[&S_V, &s_v, &ZERO], names()));
        list.push(jacobian("Jacobian of the velocity constraint", &S, info, n_h..info.n_rows()));
        list.push(equation("convective term of the velocity constraint", &[&S_TERM, &s], names()));
    }
    list.push(mass_matrix(info));
    list.push(equation("applied force", &[&F, &column(info.force_entries.iter().copied())], none()));
    if info.potential_energy.text != "0" {
        list.push(equation("potential energy", &[&V_ENERGY, &info.potential_energy], none()));
    }
    if !info.abbreviations.is_empty() {
        list.push(abbreviations(info));
    }
    list.push(motion(!position_rows.is_empty(), !velocity_rows.is_empty()));
    list
}

/// `[M C_qᵀ Sᵀ; C_q 0 0; S 0 0] [a; λ_C; λ_S] = [F; −h; −s]`, without the blocks of rows that the scene does not have.
fn motion(position: bool, velocity: bool) -> Equation {
    let kept = |block: [Formula; 3]| -> Vec<Formula> {
        block.into_iter().zip([true, position, velocity]).filter_map(|(entry, kept)| kept.then_some(entry)).collect()
    };
    let rows = [[M, C_Q_T, S_T], [C_Q, ZERO, ZERO], [S, ZERO, ZERO]].map(kept);
    let matrix =
        Matrix::new(rows.into_iter().zip([true, position, velocity]).filter_map(|(row, kept)| kept.then_some(row)));
    let product = matrix.times(column(kept([A, LAMBDA_C, LAMBDA_S])));
    equation("equations of motion", &[&product, &column(kept([F, MINUS_H, MINUS_S]))], Names(Vec::new()))
}

pub(super) fn equation(name: &'static str, sides: &[&dyn Cell], names: Names) -> Equation {
    let text = equation_lines(sides, &names);
    let latex = sides.iter().map(|side| side.latex()).collect::<Vec<_>>().join(" = ");
    let mathml = sides.iter().map(|side| side.mathml()).collect::<Vec<_>>().join("<mo>=</mo>");
    Equation { name, text, latex, mathml: format!("<math display=\"block\">{mathml}</math>") }
}

pub(super) fn column(entries: impl IntoIterator<Item = Formula>) -> Matrix {
    Matrix::new(entries.into_iter().map(|entry| vec![entry]))
}

/// Where the named points are.
fn points(info: &SceneInfo) -> Equation {
    let places = info.points.iter().filter_map(|point| Some((point.name, point.position?)));
    let definition = |(name, [x, y]): (&str, [Formula; 2])| {
        let position = column([x, y]);
        Definition {
            text: [name.to_owned(), format!("({}, {})", x.text, y.text)],
            latex: [format!("\\mathrm{{{}}}", name.replace('_', "\\_")), position.latex()],
            mathml: [format!("<mtext>{name}</mtext>"), position.mathml()],
        }
    };
    definitions("points", &places.map(definition).collect::<Vec<_>>())
}

/// What symbols for long expressions stand for.
fn abbreviations(info: &SceneInfo) -> Equation {
    let definition = |Abbreviation { symbol, formula }: &Abbreviation| {
        let of = |part: fn(&Formula) -> &'static str| [symbol, formula].map(|of| part(of).to_owned());
        Definition { text: of(|f| f.text), latex: of(|f| f.latex), mathml: of(|f| f.mathml) }
    };
    definitions("abbreviations", &info.abbreviations.iter().map(definition).collect::<Vec<_>>())
}

/// A symbol and what it is, in the three renderings.
struct Definition {
    text: [String; 2],
    latex: [String; 2],
    mathml: [String; 2],
}

/// Definitions under each other.
fn definitions(name: &'static str, list: &[Definition]) -> Equation {
    let width = list.iter().map(|d| d.text[0].chars().count()).max().unwrap_or(0);
    let text = list.iter().map(|Definition { text: [symbol, value], .. }| format!("{symbol:width$} = {value}\n"));
    let latex = list.iter().map(|Definition { latex: [symbol, value], .. }| format!("{symbol} &= {value}"));
    let mathml = list.iter().map(|Definition { mathml: [symbol, value], .. }| {
        format!("<mtr><mtd>{symbol}</mtd><mtd><mo>=</mo></mtd><mtd>{value}</mtd></mtr>")
    });
    Equation {
        name,
        text: text.collect(),
        latex: format!("\\begin{{aligned}} {} \\end{{aligned}}", latex.collect::<Vec<_>>().join(" \\\\ ")),
        mathml: format!("<math display=\"block\"><mtable>{}</mtable></math>", mathml.collect::<String>()),
    }
}

fn mass_matrix(info: &SceneInfo) -> Equation {
    let entries = info.mass_entries;
    let n = entries.len();
    if n > WIDEST_MATRIX {
        let names = Names(info.coordinates.iter().map(|c| c.name).collect());
        return equation("mass matrix", &[&DIAGONAL, &column(entries.iter().copied())], names);
    }
    let row = |i: usize| (0..n).map(|j| if i == j { entries[i] } else { ZERO }).collect();
    equation("mass matrix", &[&M, &Matrix::new((0..n).map(row))], Names(Vec::new()))
}

/// Some rows of G: a matrix, or what is not zero in each row when it is wide.
fn jacobian(name: &'static str, symbol: &Formula, info: &SceneInfo, rows: std::ops::Range<usize>) -> Equation {
    if info.n_coordinates() > WIDEST_MATRIX {
        let entries = |i: usize| {
            let row = info.jacobian.entries().filter(move |&(_, row, _)| row == i);
            row.map(|(k, _, j)| (info.coordinates[j].symbol, info.jacobian_entries[k])).collect()
        };
        let listing = Listing(rows.map(|i| (info.rows[i].name, entries(i))).collect());
        return equation(name, &[symbol, &listing], Names(Vec::new()));
    }
    let mut dense = vec![vec![ZERO; info.n_coordinates()]; info.n_rows()];
    for (k, i, j) in info.jacobian.entries() {
        dense[i][j] = info.jacobian_entries[k];
    }
    let names = Names(info.rows[rows.clone()].iter().map(|row| row.name).collect());
    equation(name, &[symbol, &Matrix::new(dense.drain(rows))], names)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{CoordinateInfo, Operations, PointInfo, RowInfo, SparsityPattern};

    const fn formula(text: &'static str) -> Formula {
        Formula { text, latex: text, mathml: text }
    }

    const fn coordinate(name: &'static str, velocity_name: &'static str) -> CoordinateInfo {
        CoordinateInfo {
            name,
            velocity_name,
            unit: "m",
            symbol: formula(name),
            velocity_symbol: formula(velocity_name),
        }
    }

    /// A sledge that slides along x + 2 y = 0 and is pushed by p.
    const SLEDGE: SceneInfo = SceneInfo {
        model: "Sledge",
        name: "pushed",
        documentation: "",
        bodies: &["sledge"],
        coordinates: &[
            coordinate("sledge.x", "sledge.vx"),
            coordinate("sledge.y", "sledge.vy"),
            coordinate("sledge.phi", "sledge.omega"),
        ],
        points: &[],
        rows: &[RowInfo {
            name: "rail",
            kind: "slot",
            multiplier_unit: "N",
            constraint: formula("sledge.x + 2*sledge.y"),
            convective_term: formula("0"),
        }],
        n_position_rows: 1,
        parameters: &[],
        inputs: &[],
        outputs: &[],
        events: &[],
        stick_slip: None,
        stop: None,
        effects: &[],
        until_s: 1.0,
        n_constants: 0,
        jacobian: SparsityPattern { starts: &[0, 2], columns: &[0, 1] },
        jacobian_entries: &[formula("1"), formula("2")],
        mass_entries: &[formula("m"), formula("m"), formula("i")],
        force_entries: &[formula("p"), formula("0"), formula("0")],
        potential_energy: formula("0"),
        abbreviations: &[],
        elimination: &[],
        acceleration_operations: Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
        correction_operations: Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
        series: crate::model::SeriesInfo::Absent,
        repeats: None,
    };

    fn named(name: &str) -> Equation {
        equations(&SLEDGE).into_iter().find(|e| e.name == name).unwrap()
    }

    #[test]
    fn analytic_jacobian_sledge_fills_zeros() {
        assert_eq!(named("Jacobian of the position constraint").text, "C_q = [ 1  2  0 ]   rail\n");
    }

    #[test]
    fn analytic_points_and_potential_energy_are_shown_when_there_are_some() {
        let x = PointInfo { name: "P", body: Some(0), position: Some([formula("sledge.x"), formula("0")]) };
        let points: &'static [PointInfo] = Box::leak(Box::new([x]));
        let info = SceneInfo { points, potential_energy: formula("m*g*sledge.y"), ..SLEDGE };
        let texts: Vec<String> = equations(&info).into_iter().map(|equation| equation.text).collect();
        assert!(texts.contains(&"P = (sledge.x, 0)\n".to_owned()), "{texts:?}");
        assert!(texts.contains(&"V = m*g*sledge.y\n".to_owned()), "{texts:?}");
    }

    #[test]
    fn analytic_wide_matrix_is_listed_by_rows() {
        let listing = Listing(vec![("rail", vec![(formula("x"), formula("1")), (formula("y"), formula("2*b"))])]);
        assert_eq!(listing.lines(), ["rail  x: 1, y: 2*b"]);
        assert_eq!(listing.latex(), "\\begin{array}{ll} \\text{rail} & x\\colon 1,\\; y\\colon 2*b \\end{array}");
    }

    #[test]
    fn analytic_motion_sledge_without_velocity_rows_has_two_blocks() {
        let motion = named("equations of motion");
        assert_eq!(motion.text, "[ M    C_q^T ] [ a        ] = [ F  ]\n[ C_q  0     ] [ lambda_C ]   [ -h ]\n");
        assert_eq!(
            motion.latex,
            "\\begin{bmatrix} M & C_q^T \\\\ C_q & 0 \\end{bmatrix}\\begin{bmatrix} a \\\\ \\lambda_C \\end{bmatrix} \
             = \\begin{bmatrix} F \\\\ -h \\end{bmatrix}"
        );
        assert!(motion.mathml.starts_with("<math display=\"block\">") && motion.mathml.ends_with("</math>"));
    }
}
