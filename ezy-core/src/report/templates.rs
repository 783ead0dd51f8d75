//! The equations of a scene with counts: those that all members of one item share.

use super::equations::{DIAGONAL, Equation, column, equation};
use super::matrix::{Matrix, Names};
use crate::model::{Formula, Repeats, RowTemplate, SlotCoordinate, TemplateInfo};

/// One item of the model file with its equations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct TemplateEquations {
    /// `hinge pin, i in 1..n`
    pub title: String,
    /// With the indices of the item in them.
    pub equations: Vec<Equation>,
}

const C: Formula = Formula { text: "C", latex: "C", mathml: "<mi>C</mi>" };
const S_V: Formula = Formula {
    text: "S v + s_t",
    latex: "S v + s_t",
    mathml: "<mi>S</mi><mi>v</mi><mo>+</mo><msub><mi>s</mi><mi>t</mi></msub>",
};
const ZERO: Formula = Formula { text: "0", latex: "0", mathml: "<mrow><mn>0</mn></mrow>" };
const H: Formula = Formula { text: "h", latex: "h", mathml: "<mi>h</mi>" };
const S: Formula = Formula { text: "s", latex: "s", mathml: "<mi>s</mi>" };
const G_T: Formula = Formula { text: "G^T", latex: "G^T", mathml: "<msup><mi>G</mi><mi>T</mi></msup>" };
const F: Formula = Formula { text: "F", latex: "F", mathml: "<mi>F</mi>" };

/// The equations of every item that has some, in declared order.
pub(crate) fn templates(repeats: &Repeats) -> Vec<TemplateEquations> {
    let all = repeats.templates.iter().map(of_template);
    all.filter(|template| !template.equations.is_empty()).collect()
}

fn of_template(template: &TemplateInfo) -> TemplateEquations {
    let words = [template.word, template.name].into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>();
    let title = std::iter::once(words.join(" ")).chain(template.ranges.iter().map(|range| (*range).to_owned()));
    let mut equations = Vec::new();
    let (position, velocity): (Vec<&RowTemplate>, Vec<&RowTemplate>) =
        template.rows.iter().partition(|row| row.position);
    for (rows, constraint, convective, names) in [
        (position, C, H, ["position constraint", "its Jacobian", "its convective term"]),
        (velocity, S_V, S, ["velocity constraint", "its Jacobian", "its convective term"]),
    ] {
        if rows.is_empty() {
            continue;
        }
        let of_rows = || Names(rows.iter().map(|row| row.row.name).collect());
        let c = column(rows.iter().map(|row| row.row.constraint));
        equations.push(equation(names[0], &[&constraint, &c, &ZERO], of_rows()));
        let (matrix, coordinates) = jacobian(&rows);
        equations.push(equation(names[1], &[&G_T, &matrix], coordinates));
        let h = column(rows.iter().map(|row| row.row.convective_term));
        equations.push(equation(names[2], &[&convective, &h], of_rows()));
    }
    for (entries, symbol, name) in [(template.masses, DIAGONAL, "mass matrix"), (template.forces, F, "applied force")] {
        if !entries.is_empty() {
            let names = Names(entries.iter().map(|(place, _)| place.symbol.text).collect());
            equations.push(equation(name, &[&symbol, &column(entries.iter().map(|(_, entry)| *entry))], names));
        }
    }
    TemplateEquations { title: title.collect::<Vec<_>>().join(", "), equations }
}

/// The entries by coordinate, one line each: Gᵀ with the coordinates beside it.
fn jacobian(rows: &[&RowTemplate]) -> (Matrix, Names) {
    let mut coordinates: Vec<SlotCoordinate> =
        rows.iter().flat_map(|row| row.entries).map(|(place, _)| *place).collect();
    coordinates.sort_by_key(|place| (place.slot, place.component));
    coordinates.dedup();
    let entry = |row: &RowTemplate, wanted: &SlotCoordinate| {
        row.entries.iter().find(|(place, _)| place == wanted).map_or(ZERO, |(_, entry)| *entry)
    };
    let lines = coordinates.iter().map(|place| rows.iter().map(|row| entry(row, place)).collect());
    (Matrix::new(lines), Names(coordinates.iter().map(|place| place.symbol.text).collect()))
}
