//! What joints bear and which power effects have, as text and as JSON.

use serde_json::{Value, json};

use crate::report::reactions::{JointReaction, Largest, PowerFlow, Reactions};
use crate::report::table::{Table, fixed};
use crate::scalar::legible_time;
use crate::simulate::Run;

/// Decimals of reactions, powers, works and times.
const DECIMALS: usize = 6;
/// Decimals of directions, degrees.
const OF_DEGREES: usize = 2;
/// Joints that the text lists; further ones are counted.
const MAX_LINES: usize = 60;

/// A run, and what its joints bear.
pub(super) struct Borne<'a> {
    /// The scene as it is typed.
    pub path: &'a str,
    pub run: &'a Run,
    pub reactions: &'a Reactions,
}

/// Impacts on a stop in a run.
fn n_impacts(run: &Run) -> usize {
    let hits = run.info().stop.map_or(&[][..], |stop| stop.hits);
    run.events().iter().filter(|occurred| hits.contains(occurred.event)).count()
}

/// Degrees of a direction.
fn degrees(of: &JointReaction) -> Option<f64> {
    of.direction.map(f64::to_degrees)
}

pub(super) fn text_of(borne: &Borne<'_>) -> String {
    let Borne { run, reactions, .. } = borne;
    let (info, from, to) = (run.info(), run.first().t, run.last().t);
    let mut text = format!(
        "{}/{}: reactions and powers from t = {} s to {} s\n\n",
        info.model,
        info.name,
        legible_time(from),
        legible_time(to)
    );
    text += &joints_text(&reactions.joints);
    match n_impacts(run) {
        0 => {}
        1 => text += "the impulse of 1 impact on a stop is left out\n",
        n => text += &format!("the impulses of {n} impacts on a stop are left out\n"),
    }
    text + &powers_text(borne)
}

fn joints_text(joints: &[JointReaction]) -> String {
    if joints.is_empty() {
        return "no constraints, so no reactions\n".to_owned();
    }
    let mut table = Table::new(["joint", "kind", "largest", "direction [deg]", "t [s]", "mean", "rms", "unit"]);
    for of in joints.iter().take(MAX_LINES) {
        let JointReaction { joint, largest: Largest { value, t }, mean, rms, .. } = of;
        let [largest, t, mean, rms] = [*value, *t, *mean, *rms].map(|x| fixed(x, DECIMALS));
        let direction = degrees(of).map_or(String::new(), |degrees| fixed(degrees, OF_DEGREES));
        table.push([
            joint.name.clone(),
            joint.kind.to_owned(),
            largest,
            direction,
            t,
            mean,
            rms,
            joint.unit.to_owned(),
        ]);
    }
    let more = joints.len().saturating_sub(MAX_LINES);
    let more = if more == 0 { String::new() } else { format!("and {more} more; --json has all\n") };
    format!("{table}{more}")
}

fn powers_text(borne: &Borne<'_>) -> String {
    let (powers, balance) = (&borne.reactions.powers, borne.reactions.balance);
    if powers.is_empty() {
        return "\nno force does work\n".to_owned();
    }
    let mut table = Table::new(["power", "delivers at most [W]", "t [s]", "takes at most [W]", "t [s]", "work [J]"]);
    for PowerFlow { name, delivered, absorbed, work } in powers {
        let cells = |largest: &Option<Largest>| match largest {
            Some(Largest { value, t }) => [*value, *t].map(|x| fixed(x, DECIMALS)),
            None => ["none".to_owned(), String::new()],
        };
        let ([delivered, at], [absorbed, then]) = (cells(delivered), cells(absorbed));
        table.push([(*name).to_owned(), delivered, at, absorbed, then, fixed(*work, DECIMALS)]);
    }
    format!(
        "\n{table}sum of works {} J, change of kinetic energy {} J, difference {:.1e} J\n",
        fixed(balance.work, DECIMALS),
        fixed(balance.kinetic, DECIMALS),
        balance.difference()
    )
}

pub(super) fn json_of(borne: &Borne<'_>) -> Value {
    let Borne { path, run, reactions } = borne;
    let joints = reactions.joints.iter().map(|of| {
        let rows: Vec<_> = run.info().rows[of.joint.rows.clone()].iter().map(|row| &row.name).collect();
        json!({
            "name": of.joint.name, "kind": of.joint.kind, "rows": rows, "unit": of.joint.unit, "largest": of.largest.value,
            "t": of.largest.t, "direction_deg": degrees(of), "mean": of.mean, "rms": of.rms,
        })
    });
    let largest = |of: Option<Largest>| of.map(|Largest { value, t }| json!({ "value": value, "t": t }));
    let powers = reactions.powers.iter().map(|flow| {
        json!({
            "name": flow.name, "delivered": largest(flow.delivered), "absorbed": largest(flow.absorbed), "work": flow.work,
        })
    });
    let balance = reactions.balance;
    json!({
        "scene": path,
        "outcome": run.outcome.to_string(),
        "t": run.last().t,
        "joints": joints.collect::<Vec<_>>(),
        "powers": powers.collect::<Vec<_>>(),
        "balance": { "work": balance.work, "kinetic": balance.kinetic, "difference": balance.difference() },
        "impacts_left_out": n_impacts(run),
    })
}
