//! A scene as JSON.

use crate::model::{
    Abbreviation, EliminationStep, EventInfo, EventKind, Formula, InputInfo, OutputInfo, ParameterInfo, PointInfo,
    RowInfo, SceneInfo, StopInfo, TemplateInfo,
};

use super::{freedom, kernels, with_equations};
use crate::cli::json::Json;
use crate::cli::list::counts_json;

pub(super) fn scene(info: &SceneInfo) -> Json {
    let [positions, velocities] = freedom(info).map(|n| Json::Count(n as u64));
    let by_coordinate = |entries: &[Formula]| {
        Json::object(info.coordinates.iter().zip(entries).map(|(c, entry)| (c.name, formula(entry))))
    };
    let operations = kernels(info).map(|(name, [mul, add, div, _, trig, calls])| {
        let counts = [mul, add, div, trig, calls].map(|n| Json::Count(n as u64));
        (name, Json::object(["mul", "add", "div", "trig", "calls"].into_iter().zip(counts)))
    });
    Json::object([
        ("model", Json::text(info.model)),
        ("scene", Json::text(info.name)),
        ("freedom", Json::object([("positions", positions), ("velocities", velocities)])),
        ("counts", counts_json(info)),
        ("templates", Json::list(with_equations(info).map(template))),
        ("bodies", Json::list(info.bodies.iter().map(|body| Json::text(*body)))),
        ("coordinates", Json::list(info.coordinates.iter().map(|c| Json::text(c.name)))),
        ("parameters", Json::list(info.parameters.iter().map(parameter))),
        ("inputs", Json::list(info.inputs.iter().map(input))),
        ("outputs", Json::list(info.outputs.iter().map(output))),
        ("events", Json::list(info.events.iter().map(event))),
        ("stop", info.stop.as_ref().map_or(Json::Null, stop)),
        ("effects", Json::list(info.effects.iter().map(|effect| Json::text(effect.name)))),
        ("points", Json::list(info.points.iter().map(point))),
        ("rows", Json::list(info.rows.iter().enumerate().map(|(i, of)| row(of, limit(info, i))))),
        ("jacobian", Json::list(info.jacobian.entries().map(|entry| jacobian_entry(info, entry)))),
        ("mass_matrix", by_coordinate(info.mass_entries)),
        ("applied_force", by_coordinate(info.force_entries)),
        ("potential_energy", formula(&info.potential_energy)),
        ("abbreviations", Json::list(info.abbreviations.iter().map(abbreviation))),
        ("elimination", Json::list(info.elimination.iter().map(|step| elimination(info, step)))),
        ("operations", Json::object(operations)),
    ])
}

fn formula(formula: &Formula) -> Json {
    let [text, latex, mathml] = [formula.text, formula.latex, formula.mathml].map(Json::text);
    Json::object([("text", text), ("latex", latex), ("mathml", mathml)])
}

fn abbreviation(of: &Abbreviation) -> Json {
    Json::object([("symbol", formula(&of.symbol)), ("value", formula(&of.formula))])
}

fn parameter(p: &ParameterInfo) -> Json {
    Json::object([("name", Json::text(p.name)), ("unit", Json::text(p.unit)), ("default", Json::Number(p.default))])
}

fn input(p: &InputInfo) -> Json {
    Json::object([("name", Json::text(p.name)), ("unit", Json::text(p.unit)), ("default", Json::Number(p.default))])
}

fn output(o: &OutputInfo) -> Json {
    Json::object([("name", Json::text(o.name)), ("unit", Json::text(o.unit)), ("value", formula(&o.formula))])
}

fn event(e: &EventInfo) -> Json {
    let ends = e.kind == EventKind::End;
    Json::object([("name", Json::text(e.name)), ("ends", Json::Bool(ends)), ("value", formula(&e.formula))])
}

fn stop(stop: &StopInfo) -> Json {
    let distances = stop.hits.iter().map(|end| formula(&end.formula));
    Json::object([
        ("name", Json::text(stop.name)),
        ("distances", Json::list(distances)),
        ("restitution", formula(&stop.restitution)),
    ])
}

fn point(point: &PointInfo) -> Json {
    let [x, y] = point.position.map_or([Json::Null, Json::Null], |position| [&position[0], &position[1]].map(formula));
    Json::object([("name", Json::text(point.name)), ("x", x), ("y", y)])
}

/// Limit of constraint `i`.
fn limit(info: &SceneInfo, i: usize) -> Json {
    info.stick_slip.filter(|stick_slip| stick_slip.row == i).map_or(Json::Null, |stick_slip| formula(&stick_slip.limit))
}

fn row(row: &RowInfo, limit: Json) -> Json {
    Json::object([
        ("name", Json::text(row.name)),
        ("kind", Json::text(row.kind)),
        ("multiplier_unit", Json::text(row.multiplier_unit)),
        ("constraint", formula(&row.constraint)),
        ("convective_term", formula(&row.convective_term)),
        ("limit", limit),
    ])
}

fn jacobian_entry(info: &SceneInfo, (k, i, j): (usize, usize, usize)) -> Json {
    Json::object([
        ("row", Json::text(info.rows[i].name)),
        ("coordinate", Json::text(info.coordinates[j].name)),
        ("value", info.jacobian_entries.get(k).map_or(Json::Null, formula)),
    ])
}

fn template(template: &TemplateInfo) -> Json {
    let equations = template.equations.iter().map(|e| {
        let [text, latex, mathml] = [e.text, e.latex, e.mathml].map(Json::text);
        Json::object([("name", Json::text(e.name)), ("text", text), ("latex", latex), ("mathml", mathml)])
    });
    Json::object([("title", Json::text(template.title)), ("equations", Json::list(equations))])
}

fn elimination(info: &SceneInfo, step: &EliminationStep) -> Json {
    let rows = step.rows.iter().map(|row| Json::text(info.rows[*row].name));
    Json::object([("rows", Json::list(rows)), ("constant_pivot", Json::Bool(step.constant_pivot))])
}
