//! A scene as JSON.

use serde_json::{Value, json};

use ezy_core::dynamics::described_solver;
use ezy_core::linalg::Backend;
use ezy_core::model::{EventKind, Formula, ParameterInfo, SceneInfo};

use super::{freedom, kernels, with_equations};
use crate::list::counts_json;

pub(super) fn scene(info: &SceneInfo) -> Value {
    let [positions, velocities] = freedom(info);
    let by_coordinate = |entries: &[Formula]| -> Value {
        info.coordinates.iter().zip(entries).map(|(c, entry)| (c.name.to_string(), formula(entry))).collect()
    };
    let operations: Value = kernels(info)
        .into_iter()
        .map(|(name, [mul, add, div, _, trig, calls])| {
            (name, json!({ "mul": mul, "add": add, "div": div, "trig": trig, "calls": calls }))
        })
        .collect();
    let solver = described_solver(info).filter(|of| of.0 == Backend::Sparse);
    json!({
        "model": info.model,
        "scene": info.name,
        "freedom": { "positions": positions, "velocities": velocities },
        "counts": counts_json(info),
        "sparse_solver": solver.map(|of| of.1),
        "templates": list(with_equations(info), |item| json!({
            "title": item.title,
            "equations": list(item.equations, |e| {
                json!({ "name": e.name, "text": e.text, "latex": e.latex, "mathml": e.mathml })
            }),
        })),
        "bodies": &info.bodies[..],
        "coordinates": list(&*info.coordinates, |c| json!(c.name)),
        "parameters": list(info.parameters, declared),
        "inputs": list(info.inputs, declared),
        "states": list(info.states, declared),
        "outputs": list(&*info.outputs, |o| json!({ "name": o.name, "unit": o.unit, "value": formula(&o.formula) })),
        "events": list(info.events, |e| {
            json!({ "name": e.name, "ends": e.kind == EventKind::End, "value": formula(&e.formula) })
        }),
        "stop": info.stop.map(|stop| json!({
            "name": stop.name,
            "distances": list(stop.hits, |end| formula(&end.formula)),
            "restitution": formula(&stop.restitution),
        })),
        "switches": list(info.switches, |switch| {
            json!({ "name": switch.name, "at_start": switch.start, "documentation": switch.documentation })
        }),
        "effects": list(info.effects, |effect| json!(effect.name)),
        "points": list(&*info.points, |point| {
            let [x, y] = [0, 1].map(|i| point.position.as_ref().map(|position| formula(&position[i])));
            json!({ "name": point.name, "x": x, "y": y })
        }),
        "rows": list(info.rows.iter().enumerate(), |(i, row)| json!({
            "name": row.name,
            "kind": row.kind,
            "multiplier_unit": row.multiplier_unit,
            "constraint": formula(&row.constraint),
            "convective_term": formula(&row.convective_term),
            "limit": info.limited_skates.iter().find(|skate| skate.row == i).map(|skate| formula(&skate.limit)),
        })),
        "jacobian": list(info.jacobian.entries(), |(k, i, j)| json!({
            "row": info.rows[i].name,
            "coordinate": info.coordinates[j].name,
            "value": info.jacobian_entries.get(k).map(formula),
        })),
        "mass_matrix": by_coordinate(info.mass_entries),
        "applied_force": by_coordinate(info.force_entries),
        "potential_energy": formula(&info.potential_energy),
        "abbreviations": list(info.abbreviations, |of| {
            json!({ "symbol": formula(&of.symbol), "value": formula(&of.formula) })
        }),
        "elimination": list(info.elimination, |step| json!({
            "rows": list(step.rows, |row| json!(info.rows[*row].name)),
            "constant_pivot": step.constant_pivot,
        })),
        "quasi_velocities": info.quasi_velocities.map(|of| list(of.formulas, formula)),
        "operations": operations,
    })
}

fn list<T>(items: impl IntoIterator<Item = T>, value: impl FnMut(T) -> Value) -> Value {
    items.into_iter().map(value).collect()
}

fn declared(number: &ParameterInfo) -> Value {
    json!({ "name": number.name, "unit": number.unit, "default": number.default })
}

fn formula(formula: &Formula) -> Value {
    json!({ "text": formula.text, "latex": formula.latex, "mathml": formula.mathml })
}
