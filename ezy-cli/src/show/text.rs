//! A scene as text.

use ezy_core::dynamics::described_solver;
use ezy_core::linalg::Backend;
use ezy_core::model::{Direction, EffectInfo, EliminationStep, Equation, EventKind, ParameterInfo, SceneInfo};
use ezy_study::report::table::Table;

use super::{OPERATIONS, freedom, kernels, pattern, pivot, series, with_equations};

pub(super) fn scene(info: &SceneInfo) -> String {
    let mut text = format!("{}/{}\n{}\n", info.model, info.name, info.documentation.trim());
    let [positions, velocities] = freedom(info);
    let [n_position_rows, n_rows] = info.n_rows_at_start();
    text += &format!(
        "\ndegrees of freedom: {positions} in position, {velocities} in velocity\n\
         {} bodies, {n_position_rows} position constraints, {} velocity constraints, {} entries of the Jacobian\n",
        info.bodies.len(),
        n_rows - n_position_rows,
        info.jacobian.n_nonzeros()
    );
    for table in tables(info) {
        text += &format!("\n{table}");
    }
    let written = |equation: &Equation| format!("\n{}\n\n{}", equation.name, indent(equation.text));
    for item in with_equations(info) {
        text += &format!("\n{}\n{}", item.title, indent(&item.equations.iter().map(written).collect::<String>()));
    }
    text += &info.equations.iter().map(written).collect::<String>();
    text += &format!("\n{}\n", series(info));
    if let Some((backend, solver)) = described_solver(info) {
        let kind = if backend == Backend::Dense { "dense" } else { "sparse" };
        return text + &format!("\n{kind} solver: {solver}\n");
    }
    text += &format!("\nsparsity of the Jacobian [C_q; S]: x, y and phi of each body\n\n{}", indent(&sparsity(info)));
    text += &format!("\norder of elimination\n\n{}", indent(&elimination(info)));
    if let Some(of) = info.quasi_velocities {
        let formulas: String = of.formulas.iter().map(|formula| format!("{}\n", formula.text)).collect();
        text += &format!("\nquasi-velocities, in which gauss and dop853 solve\n\n{}", indent(&formulas));
    }
    let mut operations = Table::new(std::iter::once("operations").chain(OPERATIONS));
    for (name, numbers) in kernels(info) {
        operations.push(std::iter::once(name.to_owned()).chain(numbers.map(|n| n.to_string())));
    }
    text + &format!("\n{operations}")
}

/// What the scene declares; tables without rows are left out, and lists of members where there are counts.
fn tables(info: &SceneInfo) -> Vec<Table> {
    let mut tables = Vec::new();
    let mut put = |heads: [&str; 5], rows: Vec<[&str; 5]>| {
        let used = heads.iter().filter(|head| !head.is_empty()).count();
        if !rows.is_empty() {
            let mut table = Table::new(heads[..used].iter().copied());
            for row in rows {
                let cells: Vec<Vec<String>> = row[..used].iter().map(|cell| in_lines(cell)).collect();
                for i in 0..cells.iter().map(Vec::len).max().unwrap_or(0) {
                    table.push(cells.iter().map(|lines| lines.get(i).cloned().unwrap_or_default()));
                }
            }
            tables.push(table);
        }
    };
    let counts: Vec<String> =
        info.repeats.iter().flat_map(|repeats| repeats.values.iter()).map(ToString::to_string).collect();
    let counts = info.counts().iter().zip(&counts).map(|(c, value)| [c.name, value, c.documentation.trim(), "", ""]);
    put(["count", "value", "what it is", "", ""], counts.collect());
    let declared = |numbers: &'static [ParameterInfo]| {
        let number = |p: &'static ParameterInfo| {
            [p.name, p.default_text, p.unit, p.effect.unwrap_or("-"), p.documentation.trim()]
        };
        numbers.iter().map(number).collect()
    };
    put(["parameter", "value", "unit", "effect", "what it is"], declared(info.parameters));
    put(["input", "until it is set", "unit", "effect", "what it is"], declared(info.inputs));
    put(["state", "at the start", "unit", "effect", "what it is"], declared(info.states));
    let effects = info.effects.iter().map(|e: &EffectInfo| [e.name, e.documentation.trim(), "", "", ""]);
    put(["effect", "what it is", "", "", ""], effects.collect());
    let outputs = info.outputs.iter().map(|o| [&*o.name, o.unit, o.formula.text, o.documentation.trim(), ""]);
    put(["output", "unit", "formula", "what it is", ""], outputs.collect());
    let events = info.events.iter().map(|e| {
        let follows = if e.kind == EventKind::End { "ends the run" } else { "is recorded" };
        // what is found by itself has no name but its formula
        let name = if e.name == e.formula.text { "-" } else { e.name };
        [name, passes(e.direction), e.formula.text, follows, e.documentation.trim()]
    });
    put(["event", "passes zero", "value", "what follows", "what it is"], events.collect());
    let ends = info.stop.iter().flat_map(|stop| stop.hits.iter().map(move |end| (stop, end)));
    let ends = ends.map(|(stop, end)| [stop.name, end.formula.text, stop.restitution.text, "", ""]);
    put(["stop", "keeps from below zero", "restitution", "", ""], ends.collect());
    let values: Vec<String> = info.switches.iter().map(|switch| switch.start.to_string()).collect();
    let switches = info.switches.iter().zip(&values);
    let switches = switches.map(|(switch, value)| [switch.name, value, switch.documentation, "", ""]);
    put(["switch", "at the start", "what it is", "", ""], switches.collect());
    if info.repeats.is_some() {
        return tables;
    }
    let coordinates = info.coordinates.iter().zip(&*info.velocities).map(|(c, v)| [&*c.name, c.unit, &*v.name, "", ""]);
    put(["coordinate", "unit", "velocity", "", ""], coordinates.collect());
    let rows = info.rows.iter().enumerate().map(|(i, row)| {
        let level = if i < info.n_position_rows { "position" } else { "velocity" };
        let limit = info.limited_skates.iter().find(|skate| skate.row == i).map_or("", |skate| skate.limit.text);
        [&*row.name, row.kind, level, row.multiplier_unit, limit]
    });
    let limit = if info.limited_skates.is_empty() { "" } else { "slides beyond" };
    put(["row", "word", "level", "unit of its multiplier", limit], rows.collect());
    tables
}

/// A cell that is wider goes on in the next row.
const WIDEST_CELL: usize = 60;

fn in_lines(cell: &str) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in cell.split_whitespace() {
        let last = lines.len() - 1;
        if lines[last].is_empty() || lines[last].chars().count() + word.chars().count() < WIDEST_CELL {
            let gap = if lines[last].is_empty() { "" } else { " " };
            lines[last] += &format!("{gap}{word}");
        } else {
            lines.push(format!("  {word}"));
        }
    }
    lines
}

const fn passes(direction: Direction) -> &'static str {
    match direction {
        Direction::Rising => "upwards",
        Direction::Falling => "downwards",
        Direction::Either => "both ways",
    }
}

fn indent(text: &str) -> String {
    text.lines().map(|line| format!("  {line}").trim_end().to_owned() + "\n").collect()
}

fn sparsity(info: &SceneInfo) -> String {
    let mut table = Table::new(std::iter::once("row").chain(info.bodies.iter().map(|body| &**body)));
    for (row, signs) in info.rows.iter().zip(pattern(info)) {
        table.push(std::iter::once(row.name.to_string()).chain(signs));
    }
    table.to_string()
}

fn elimination(info: &SceneInfo) -> String {
    let step = |(i, step): (usize, &EliminationStep)| {
        let rows = step.rows.iter().map(|row| &*info.rows[*row].name).collect::<Vec<_>>().join(", ");
        format!("{}. {rows}: {}\n", i + 1, pivot(step))
    };
    info.elimination.iter().enumerate().map(step).collect()
}
