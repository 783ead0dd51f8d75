//! The monitors of a run, as JSON and as text.

use serde_json::{Value, json};

use ezy_core::simulate::{ConditionPeak, EnergyError, LeastPivot, Monitors, Peak, Run, SoftestImpact};
use ezy_study::report::table::fixed;

/// The monitors as JSON; of a run that could not start the same keys, all `null`.
pub(super) fn monitors_json(monitors: Option<&Monitors>) -> Value {
    let peak = |pick: fn(&Monitors) -> &Option<Peak>| {
        let peak = monitors.and_then(|monitors| pick(monitors).as_ref());
        peak.map(|Peak { value, t, row }| json!({ "value": value, "t": t, "row": row }))
    };
    let energy = monitors.and_then(|m| m.energy);
    let condition = monitors.and_then(|m| m.condition.as_ref());
    let steps_s = monitors.and_then(|m| m.steps_s);
    json!({
        "position_residual": peak(|m| &m.position_residual),
        "velocity_residual": peak(|m| &m.velocity_residual),
        "position_drift": peak(|m| &m.position_drift),
        "velocity_drift": peak(|m| &m.velocity_drift),
        "energy": energy.map(|EnergyError { joules, relative, t }| {
            json!({ "balance": joules, "relative": relative, "t": t })
        }),
        "smallest_pivot": monitors.and_then(|m| m.pivot).map(|LeastPivot { value, t }| json!({ "value": value, "t": t })),
        "condition": condition.map(|ConditionPeak { at_start, largest, pivot, unknown, t, rounding }| json!({
            "at_start": at_start, "largest": largest, "t": t, "smallest_pivot": pivot, "pivot_of": unknown, "rounding": rounding,
        })),
        "softest_impact": monitors.and_then(|m| m.softest_impact).map(|SoftestImpact { speed, t }| json!({ "speed": speed, "t": t })),
        "shortest_step": steps_s.map(|[shortest, _]| shortest),
        "longest_step": steps_s.map(|[_, longest]| longest),
    })
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
        softest_impact,
        steps_s,
    } = &run.monitors;
    let pair = |title: &str, [positions, velocities]: [&Option<Peak>; 2]| {
        let told = [("positions", positions), ("velocities", velocities)];
        let told =
            told.into_iter().filter_map(|(what, peak)| peak.as_ref().map(|peak| format!("{what} {}", peak_text(peak))));
        let told = told.collect::<Vec<_>>();
        if told.is_empty() { String::new() } else { format!("  {title}: {}\n", told.join(", ")) }
    };
    let mut text = pair("constraint residual", [position_residual, velocity_residual]);
    text += &pair("removed by projection", [position_drift, velocity_drift]);
    text += &match energy {
        Some(EnergyError { joules, relative, t }) => {
            format!(
                "  energy balance: {joules:.1e} J, {relative:.1e} of the energy turned over (t = {} s)\n",
                fixed(*t, 6)
            )
        }
        None => String::new(),
    };
    if let Some(LeastPivot { value, t }) = pivot {
        text += &format!("  smallest relative pivot: {value:.1e} (t = {} s)\n", fixed(*t, 6));
    }
    if let Some(ConditionPeak { at_start, largest, pivot, t, .. }) = condition {
        text += &format!(
            "  condition of the equations: {largest:.1e} (t = {} s, smallest pivot {pivot:.1e}), at the start {at_start:.1e}\n",
            fixed(*t, 6)
        );
    }
    if let Some(SoftestImpact { speed, t }) = softest_impact {
        text += &format!("  softest impact: {speed:.1e} (t = {} s)\n", fixed(*t, 6));
    }
    if let Some([shortest, longest]) = steps_s {
        text += &format!("  steps: {shortest:.1e} s to {longest:.1e} s, {} rejected\n", run.cost.rejected);
    }
    if text.is_empty() { text } else { format!("largest of the run:\n{text}") }
}

fn peak_text(Peak { value, t, row }: &Peak) -> String {
    if *value == 0.0 { "0".to_owned() } else { format!("{value:.1e} ({row}, t = {} s)", fixed(*t, 6)) }
}
