//! `ezy show`.

use ezy_core::model::{Formula, Operations, Repeats, SceneInfo};
use ezy_core::report::equations::{Equation, equations};
use ezy_core::report::table::Table;
use ezy_core::report::templates::{TemplateEquations, templates};
use ezy_models::registry::find;

use super::arguments::{Format, ShowArguments};
use super::failure::Failure;
use super::json::Json;
use super::list::counts_json;
use super::output::print;

pub fn show(arguments: &ShowArguments) -> Result<(), Failure> {
    let selection = find(&arguments.path)?;
    let all = selection.model.scenes.iter();
    let chosen = all.filter(|entry| selection.scene.is_none_or(|scene| scene.name == entry.name));
    let infos: Vec<&SceneInfo> = chosen.map(|entry| (entry.info)()).collect();
    let each = |write: fn(&SceneInfo) -> String| infos.iter().map(|info| write(info) + "\n").collect();
    let text: String = match (arguments.format, &infos[..]) {
        (Format::Text, _) => each(scene_text),
        (Format::Latex, _) => each(scene_latex),
        (Format::Json, [info]) if selection.scene.is_some() => format!("{}\n", scene_json(info)),
        (Format::Json, _) => {
            let scenes = Json::list(infos.iter().map(|info| scene_json(info)));
            format!("{}\n", Json::object([("model", Json::text(selection.model.name)), ("scenes", scenes)]))
        }
    };
    print(&text)
}

fn scene_text(info: &SceneInfo) -> String {
    let mut text = format!("{}/{}\n{}\n", info.model, info.name, info.documentation.trim());
    let mut parameters = Table::new(["parameter", "value", "unit", "effect", "what it is"]);
    for p in info.parameters {
        let effect = p.effect.unwrap_or("-");
        parameters.push([p.name, p.default_text, p.unit, effect, p.documentation.trim()]);
    }
    text += &format!("\n{parameters}");
    let written = |equation: &Equation| format!("\n{}\n\n{}", equation.name, indent(&equation.text));
    if let Some(repeats) = &info.repeats {
        text += &sizes_text(info, repeats);
        for template in templates(repeats) {
            text += &format!("\n{}\n", template.title);
            text += &indent(&template.equations.iter().map(written).collect::<String>());
        }
        return text + &equations(info).iter().map(written).collect::<String>();
    }
    text += &equations(info).iter().map(written).collect::<String>();
    text += &format!("\nsparsity of the Jacobian [C_q; S]\n\n{}", indent(&sparsity_text(info)));
    text += &format!("\norder of elimination\n\n{}", indent(&elimination_text(info)));
    let mut operations =
        Table::new(["operations", "mul", "add", "div", "arithmetic in all", "sin and cos", "other calls"]);
    for (name, count) in kernels(info) {
        let numbers = [count.mul, count.add, count.div, count.arithmetic(), count.trig, count.calls];
        operations.push(std::iter::once(name.to_owned()).chain(numbers.map(|n| n.to_string())));
    }
    text + &format!("\n{operations}")
}

/// Counts and what they make; the equations of a scene with counts are told by template.
fn sizes_text(info: &SceneInfo, repeats: &Repeats) -> String {
    let mut counts = Table::new(["count", "value", "what it is"]);
    for (count, value) in repeats.counts.iter().zip(repeats.values) {
        counts.push([count.name, &value.to_string(), count.documentation.trim()]);
    }
    format!(
        "\n{counts}\n{} bodies, {} position rows, {} velocity rows, {} entries of the Jacobian\n",
        info.bodies.len(),
        info.n_position_rows,
        info.n_rows() - info.n_position_rows,
        info.jacobian.n_nonzeros()
    )
}

fn indent(text: &str) -> String {
    text.lines().map(|line| format!("  {line}\n")).collect()
}

fn sparsity_text(info: &SceneInfo) -> String {
    let mut table = Table::new(std::iter::once("row").chain(info.coordinates.iter().map(|c| c.name)));
    for (i, row) in info.rows.iter().enumerate() {
        let mut cells = vec!["."; info.n_coordinates()];
        info.jacobian.entries().filter(|(_, row, _)| *row == i).for_each(|(_, _, column)| cells[column] = "x");
        table.push(std::iter::once(row.name).chain(cells));
    }
    table.to_string()
}

fn elimination_text(info: &SceneInfo) -> String {
    let step = |(i, step): (usize, &ezy_core::model::EliminationStep)| {
        let rows = step.rows.iter().map(|row| info.rows[*row].name).collect::<Vec<_>>().join(", ");
        let pivot =
            if step.constant_pivot { "pivot from parameters alone, computed once" } else { "pivot from the state" };
        format!("{}. {rows}: {pivot}\n", i + 1)
    };
    info.elimination.iter().enumerate().map(step).collect()
}

fn kernels(info: &SceneInfo) -> [(&'static str, Operations); 2] {
    [("accelerations", info.acceleration_operations), ("correction", info.correction_operations)]
}

fn scene_latex(info: &SceneInfo) -> String {
    let display = |e: &Equation| format!("% {}\n\\[\n{}\n\\]\n", e.name, e.latex);
    let mut text = format!("% {}/{}\n", info.model, info.name);
    for template in info.repeats.iter().flat_map(templates) {
        text += &format!("% {}\n", template.title);
        text += &template.equations.iter().map(display).collect::<String>();
    }
    text + &equations(info).iter().map(display).collect::<String>()
}

fn formula_json(formula: &Formula) -> Json {
    let [text, latex, mathml] = [formula.text, formula.latex, formula.mathml].map(Json::text);
    Json::object([("text", text), ("latex", latex), ("mathml", mathml)])
}

fn scene_json(info: &SceneInfo) -> Json {
    let texts = |names: &[&str]| Json::list(names.iter().map(|name| Json::text(*name)));
    let row = |row: &ezy_core::model::RowInfo| {
        Json::object([
            ("name", Json::text(row.name)),
            ("kind", Json::text(row.kind)),
            ("multiplier_unit", Json::text(row.multiplier_unit)),
            ("constraint", formula_json(&row.constraint)),
            ("convective_term", formula_json(&row.convective_term)),
        ])
    };
    let entry = |(k, i, j): (usize, usize, usize)| {
        Json::object([
            ("row", Json::text(info.rows[i].name)),
            ("coordinate", Json::text(info.coordinates[j].name)),
            ("value", info.jacobian_entries.get(k).map_or(Json::Null, formula_json)),
        ])
    };
    let template = |template: TemplateEquations| {
        let equation = |e: &Equation| {
            let [text, latex, mathml] = [&e.text, &e.latex, &e.mathml].map(Json::text);
            Json::object([("name", Json::text(e.name)), ("text", text), ("latex", latex), ("mathml", mathml)])
        };
        let equations = template.equations.iter().map(equation);
        Json::object([("title", Json::text(&template.title)), ("equations", Json::list(equations))])
    };
    let parameter = |p: &ezy_core::model::ParameterInfo| {
        Json::object([("name", Json::text(p.name)), ("unit", Json::text(p.unit)), ("default", Json::Number(p.default))])
    };
    let by_coordinate = |entries: &[Formula]| {
        Json::object(info.coordinates.iter().zip(entries).map(|(c, formula)| (c.name, formula_json(formula))))
    };
    let step = |step: &ezy_core::model::EliminationStep| {
        let rows = step.rows.iter().map(|row| Json::text(info.rows[*row].name));
        Json::object([("rows", Json::list(rows)), ("constant_pivot", Json::Bool(step.constant_pivot))])
    };
    let operations = kernels(info).map(|(name, count)| {
        let counts = [count.mul, count.add, count.div, count.trig, count.calls].map(|n| Json::Count(n as u64));
        (name, Json::object(["mul", "add", "div", "trig", "calls"].into_iter().zip(counts)))
    });
    Json::object([
        ("model", Json::text(info.model)),
        ("scene", Json::text(info.name)),
        ("counts", counts_json(info)),
        ("templates", Json::list(info.repeats.iter().flat_map(templates).map(template))),
        ("bodies", texts(info.bodies)),
        ("coordinates", Json::list(info.coordinates.iter().map(|c| Json::text(c.name)))),
        ("parameters", Json::list(info.parameters.iter().map(parameter))),
        ("rows", Json::list(info.rows.iter().map(row))),
        ("jacobian", Json::list(info.jacobian.entries().map(entry))),
        ("mass_matrix", by_coordinate(info.mass_entries)),
        ("applied_force", by_coordinate(info.force_entries)),
        ("elimination", Json::list(info.elimination.iter().map(step))),
        ("operations", Json::object(operations)),
    ])
}
