//! The tables of a page, in Markdown.

use crate::emit::abbreviations::Abbreviations;
use crate::mechanics::Equations;
use crate::mechanics::kernels::{Kernels, Quantity};
use crate::mechanics::symbols::Symbols;
use crate::model::{BodyId, Coordinate, InputId, Model, Parameter, ParameterId};
use crate::symbolic::print::{Names, Printed};

/// An expression within a line of text.
fn inline(expression: &str) -> String {
    format!("<math>{expression}</math>")
}

/// A table with a head, nothing when it has no rows; line breaks and bars within cells are kept harmless.
pub fn markdown(heads: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> Vec<String> {
    let line = |cells: Vec<String>| {
        let cells = cells.iter().map(|cell| cell.trim().replace('|', "\\|").replace('\n', " "));
        format!("| {} |", cells.collect::<Vec<_>>().join(" | "))
    };
    let head = line(heads.iter().map(|head| (*head).to_owned()).collect());
    let rule = line(vec!["---".to_owned(); heads.len()]);
    let rows: Vec<String> = rows.into_iter().map(line).collect();
    if rows.is_empty() { rows } else { [head, rule].into_iter().chain(rows).collect() }
}

/// Symbol, name, default with unit, effect, meaning.
pub fn parameters(model: &Model, parameters: &[ParameterId], symbols: &Symbols) -> Vec<String> {
    let rows = parameters.iter().map(|id| declared(model, &model.parameters[id.0], &symbols.parameter(id.0)));
    markdown(&["", "parameter", "default", "effect", "what it is"], rows)
}

/// The same of what is set while the scene runs.
pub fn inputs(model: &Model, inputs: &[InputId], symbols: &Symbols) -> Vec<String> {
    markdown(&["", "input", "until it is set", "effect", "what it is"], declared_inputs(model, inputs, symbols))
}

/// The same of what has a rate of its own.
pub fn states(model: &Model, states: &[InputId], symbols: &Symbols) -> Vec<String> {
    markdown(&["", "state", "at the start", "effect", "what it is"], declared_inputs(model, states, symbols))
}

fn declared_inputs(model: &Model, ids: &[InputId], symbols: &Symbols) -> Vec<Vec<String>> {
    let row = |&id: &InputId| {
        let symbol = symbols.symbol(symbols.input(id)?);
        Some(declared(model, &model.inputs[id.0], &symbol))
    };
    ids.iter().filter_map(row).collect()
}

fn declared(model: &Model, parameter: &Parameter, symbol: &Printed) -> Vec<String> {
    let effect = parameter.effect.map(|effect| format!("`{}`", model.effects[effect.0].name)).unwrap_or_default();
    let value = match parameter.unit.as_str() {
        "" => parameter.default_text.clone(),
        written => format!("{} {}", parameter.default_text, unit(written)),
    };
    vec![inline(&symbol.mathml), format!("`{}`", parameter.name), value, effect, parameter.documentation.clone()]
}

/// What the scene computes when it is asked.
pub fn outputs(model: &Model, equations: &Equations, names: &Abbreviations<'_>) -> Vec<String> {
    let rows = equations.outputs.iter().map(|&(i, value)| {
        let output = &model.outputs[i];
        let formula = inline(&names.print(value).mathml);
        vec![format!("`{}{}`", output.name, output.suffix), formula, unit(&output.unit), output.documentation.clone()]
    });
    markdown(&["output", "", "unit", "what it is"], rows)
}

/// What the counts of a model are.
pub fn counts(model: &Model) -> Vec<String> {
    let rows = model.counts.iter();
    let rows = rows.map(|c| vec![format!("`{}`", c.name), c.default.to_string(), c.documentation.clone()]);
    markdown(&["count", "default", "what it is"], rows)
}

/// A unit as it is printed: `kg*m^2` as kg·m².
pub fn unit(written: &str) -> String {
    let powers = [("^-1", "⁻¹"), ("^-2", "⁻²"), ("^2", "²"), ("^3", "³"), ("^4", "⁴"), ("*", "·")];
    powers.iter().fold(written.to_owned(), |text, (sign, printed)| text.replace(sign, printed))
}

/// Rows with the words that declared them.
pub fn rows(equations: &Equations) -> Vec<String> {
    let constraints = &equations.constraints;
    let rows = constraints.rows.iter().enumerate().map(|(i, row)| {
        let level = if i < constraints.n_position_rows { "position" } else { "velocity" };
        [&format!("`{}`", row.name), row.kind, level, &unit(&row.unit)].map(str::to_owned).to_vec()
    });
    markdown(&["row", "word", "level", "unit of its multiplier"], rows)
}

/// What says how a row takes part that is switched on and off.
pub fn switches(model: &Model, equations: &Equations) -> Vec<String> {
    let symbols = &equations.symbols;
    let rows = symbols.switches().iter().enumerate().map(|(i, of)| {
        let symbol = symbols.parameter(model.n_values() + i);
        vec![inline(&symbol.mathml), of.start.to_string(), of.documentation.to_owned()]
    });
    markdown(&["", "at the start", "what it is"], rows)
}

/// A line for each row, three signs for each body: which of x, y, φ the row reads.
pub fn sparsity(model: &Model, equations: &Equations) -> Vec<String> {
    let constraints = &equations.constraints;
    let bodies: Vec<String> = model.bodies.iter().map(|body| body.name.to_string()).collect();
    let widest = constraints.rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
    let head: String = bodies.iter().map(|body| format!("  {body:<3}")).collect();
    let line = |(row, name): (&Vec<_>, &str)| {
        let cells = bodies.iter().enumerate().map(|(i, body)| {
            let reads = |at: Coordinate| row.iter().any(|&(column, _)| column == at.place());
            let signs: String =
                Coordinate::of(BodyId(i)).into_iter().map(|at| if reads(at) { 'x' } else { '.' }).collect();
            format!("  {signs:<width$}", width = body.chars().count().max(3))
        });
        format!("{name:widest$}{}", cells.collect::<String>().trim_end())
    };
    let lines = constraints.jacobian.iter().zip(constraints.rows.iter().map(|row| row.name.as_str())).map(line);
    if constraints.rows.is_empty() {
        return Vec::new();
    }
    let mut table = vec!["Columns: x, y and φ of each body.".into(), String::new(), "```text".into()];
    table.push(format!("{:widest$}{head}", ""));
    table.extend(lines);
    table.push("```".into());
    table
}

/// The blocks in their order, and what their pivots depend on.
pub fn elimination(equations: &Equations, order: &[(Vec<usize>, bool)]) -> Vec<String> {
    let step = |(i, (rows, constant)): (usize, &(Vec<usize>, bool))| {
        let names = rows.iter().map(|&row| format!("`{}`", equations.constraints.rows[row].name));
        let pivot = if *constant { "pivot of parameters alone, computed once" } else { "pivot of the state" };
        format!("{}. {}: {pivot}", i + 1, names.collect::<Vec<_>>().join(", "))
    };
    order.iter().enumerate().map(step).collect()
}

/// Counts of the two generated solutions.
pub fn operations(kernels: &Kernels<'_>) -> Vec<String> {
    let solutions = [("accelerations and multipliers", Quantity::Accelerations), ("projection", Quantity::Correction)];
    let rows = solutions.map(|(name, quantity)| {
        let count = kernels[&quantity].count();
        let numbers = [count.mul, count.add, count.div, count.trig, count.calls];
        std::iter::once(name.to_owned()).chain(numbers.map(|n| n.to_string())).collect()
    });
    markdown(&["", "multiplications", "additions", "divisions", "sines and cosines", "other functions"], rows)
}
