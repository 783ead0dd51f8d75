//! The monitors of a run, as JSON and as text.

use crate::report::table::fixed;
use crate::simulate::{ConditionPeak, EnergyError, LeastPivot, Monitors, Peak, Run};

use super::json::Json;

/// The monitors as JSON; of a run that could not start the same keys, all `null`.
pub(super) fn monitors_json(monitors: Option<&Monitors>) -> Json {
    let peak = |pick: fn(&Monitors) -> Option<Peak>| monitors.and_then(pick).map_or(Json::Null, peak_json);
    let step = |i: usize| monitors.and_then(|m| m.steps_s).map_or(Json::Null, |steps_s| Json::Number(steps_s[i]));
    Json::object([
        ("position_residual", peak(|m| m.position_residual)),
        ("velocity_residual", peak(|m| m.velocity_residual)),
        ("position_drift", peak(|m| m.position_drift)),
        ("velocity_drift", peak(|m| m.velocity_drift)),
        ("energy", monitors.and_then(|m| m.energy).map_or(Json::Null, energy_json)),
        ("smallest_pivot", monitors.and_then(|m| m.pivot).map_or(Json::Null, pivot_json)),
        ("condition", monitors.and_then(|m| m.condition).map_or(Json::Null, condition_json)),
        ("shortest_step", step(0)),
        ("longest_step", step(1)),
    ])
}

fn peak_json(Peak { value, t, row }: Peak) -> Json {
    Json::object([("value", Json::Number(value)), ("t", Json::Number(t)), ("row", Json::text(row))])
}

fn energy_json(EnergyError { joules, relative, t }: EnergyError) -> Json {
    Json::object([("balance", Json::Number(joules)), ("relative", Json::Number(relative)), ("t", Json::Number(t))])
}

fn pivot_json(LeastPivot { value, t }: LeastPivot) -> Json {
    Json::object([("value", Json::Number(value)), ("t", Json::Number(t))])
}

fn condition_json(ConditionPeak { at_start, largest, pivot, unknown, t }: ConditionPeak) -> Json {
    Json::object([
        ("at_start", Json::Number(at_start)),
        ("largest", Json::Number(largest)),
        ("t", Json::Number(t)),
        ("smallest_pivot", Json::Number(pivot)),
        ("pivot_of", unknown.map_or(Json::Null, Json::text)),
    ])
}

/// The monitors as lines of text.
pub(super) fn monitors_text(run: &Run) -> String {
    let Monitors {
        position_residual,
        velocity_residual,
        position_drift,
        velocity_drift,
        energy,
        pivot,
        condition,
        steps_s,
    } = run.monitors;
    let pair = |title: &str, [positions, velocities]: [Option<Peak>; 2]| {
        let told = [("positions", positions), ("velocities", velocities)];
        let told = told.into_iter().filter_map(|(what, peak)| peak.map(|peak| format!("{what} {}", peak_text(peak))));
        let told = told.collect::<Vec<_>>();
        if told.is_empty() { String::new() } else { format!("  {title}: {}\n", told.join(", ")) }
    };
    let mut text = pair("constraint residual", [position_residual, velocity_residual]);
    text += &pair("removed by projection", [position_drift, velocity_drift]);
    text += &match energy {
        Some(EnergyError { joules, relative, t }) => {
            format!(
                "  energy balance: {joules:.1e} J, {relative:.1e} of the energy turned over (t = {} s)\n",
                fixed(t, 6)
            )
        }
        None => String::new(),
    };
    if let Some(LeastPivot { value, t }) = pivot {
        text += &format!("  smallest relative pivot: {value:.1e} (t = {} s)\n", fixed(t, 6));
    }
    if let Some(ConditionPeak { at_start, largest, pivot, t, .. }) = condition {
        text += &format!(
            "  condition of the equations: {largest:.1e} (t = {} s, smallest pivot {pivot:.1e}), at the start {at_start:.1e}\n",
            fixed(t, 6)
        );
    }
    if let Some([shortest, longest]) = steps_s {
        text += &format!("  steps: {shortest:.1e} s to {longest:.1e} s, {} rejected\n", run.cost.rejected);
    }
    if text.is_empty() { text } else { format!("largest of the run:\n{text}") }
}

fn peak_text(Peak { value, t, row }: Peak) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e} ({row}, t = {} s)", fixed(t, 6)) }
}
