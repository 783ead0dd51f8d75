//! What joints bear and which power effects have, as text and as JSON.

use serde_json::{Value, json};

use ezy_core::scalar::legible_time;
use ezy_core::simulate::Run;
use ezy_study::report::reactions::{ElementFlow, ElementFlows, JointReaction, Largest, PowerFlow, Reactions};
use ezy_study::report::table::{Table, fixed};

/// Decimals of reactions, powers, works and times.
const DECIMALS: usize = 6;
/// Decimals of directions, degrees.
const OF_DEGREES: usize = 2;
/// Joints, and forces, that the text lists; further ones are counted.
const MAX_LINES: usize = 60;
const DELIVERS: &str = "delivers at most [W]";
const TAKES: &str = "takes at most [W]";

/// A run, and what its joints bear.
pub(super) struct Borne<'a> {
    /// The scene as it is typed.
    pub path: &'a str,
    pub run: &'a Run,
    pub reactions: &'a Reactions,
    pub elements: &'a ElementFlows,
}

/// Groups of [`SceneInfo::effects`](ezy_core::model::SceneInfo::effects) that are no forces.
#[cfg(feature = "figures")]
const OF_CONSTRAINTS: [&str; 2] = ["drives", "stops"];

impl<'a> Borne<'a> {
    /// Powers of effects; without that of the forces with a potential together where each is told.
    pub(super) fn effects(&self) -> &'a [PowerFlow] {
        self.elements.besides(&self.reactions.powers)
    }

    /// Powers at the samples, each once: of the forces and of the constraints that move; of effects where no force is told.
    #[cfg(feature = "figures")]
    pub(super) fn power_curves(&self) -> Vec<(&'a str, Vec<f64>)> {
        let Self { run, elements, .. } = *self;
        let is_told = |flow: &PowerFlow| elements.all.is_empty() || OF_CONSTRAINTS.contains(&flow.name);
        let effects = self.effects().iter().enumerate().filter(|(_, flow)| is_told(flow));
        let effects = effects.map(|(i, flow)| (flow.name, run.samples().map(|sample| sample.power[i]).collect()));
        let n = run.samples().len();
        let forces = elements.all.iter().enumerate();
        let forces = forces.map(|(i, of)| (of.element.name, (0..n).map(|k| elements.powers(k)[i]).collect()));
        effects.chain(forces).collect()
    }
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
    format!("{table}{}", more(joints.len()))
}

fn powers_text(borne: &Borne<'_>) -> String {
    let (powers, balance) = (borne.effects(), borne.reactions.balance);
    if borne.reactions.powers.is_empty() {
        return "\nno force does work\n".to_owned();
    }
    let mut text = String::new();
    if !powers.is_empty() {
        let mut table = Table::new(["effect", DELIVERS, "t [s]", TAKES, "t [s]", "work [J]"]);
        for PowerFlow { name, delivered, absorbed, work } in powers {
            let ([delivered, at], [absorbed, then]) = (cells(*delivered), cells(*absorbed));
            table.push([(*name).to_owned(), delivered, at, absorbed, then, fixed(*work, DECIMALS)]);
        }
        text += &format!("\n{table}");
    }
    if !borne.elements.all.is_empty() {
        text += &format!("\n{}", elements_text(&borne.elements.all));
    }
    format!(
        "{text}sum of works {} J, change of kinetic energy {} J, difference {:.1e} J\n",
        fixed(balance.work, DECIMALS),
        fixed(balance.kinetic, DECIMALS),
        balance.difference()
    )
}

/// A largest power and its time.
fn cells(largest: Option<Largest>) -> [String; 2] {
    match largest {
        Some(Largest { value, t }) => [value, t].map(|x| fixed(x, DECIMALS)),
        None => ["none".to_owned(), String::new()],
    }
}

fn elements_text(elements: &[ElementFlow]) -> String {
    let mut table = Table::new(["force", "effect", DELIVERS, "t [s]", TAKES, "t [s]", "work [J]"]);
    for ElementFlow { element, delivered, absorbed, work } in elements.iter().take(MAX_LINES) {
        let ([delivered, at], [absorbed, then]) = (cells(*delivered), cells(*absorbed));
        let effect = element.effect.unwrap_or_default().to_owned();
        table.push([element.name.to_owned(), effect, delivered, at, absorbed, then, fixed(*work, DECIMALS)]);
    }
    format!("{table}{}", more(elements.len()))
}

/// What is said of lines beyond the most.
fn more(n: usize) -> String {
    match n.saturating_sub(MAX_LINES) {
        0 => String::new(),
        more => format!("and {more} more; --json has all\n"),
    }
}

pub(super) fn json_of(borne: &Borne<'_>) -> Value {
    let Borne { path, run, reactions, elements } = borne;
    let joints = reactions.joints.iter().map(|of| {
        let rows: Vec<_> = run.info().rows[of.joint.rows.clone()].iter().map(|row| &row.name).collect();
        json!({
            "name": of.joint.name, "kind": of.joint.kind, "rows": rows, "unit": of.joint.unit, "largest": of.largest.value,
            "t": of.largest.t, "direction_deg": degrees(of), "mean": of.mean, "rms": of.rms,
        })
    });
    let largest = |of: Option<Largest>| of.map(|Largest { value, t }| json!({ "value": value, "t": t }));
    let powers = borne.effects().iter().map(|flow| {
        json!({
            "name": flow.name, "delivered": largest(flow.delivered), "absorbed": largest(flow.absorbed), "work": flow.work,
        })
    });
    let elements = elements.all.iter().map(|ElementFlow { element, delivered, absorbed, work }| {
        json!({
            "name": element.name, "kind": element.kind, "effect": element.effect, "delivered": largest(*delivered),
            "absorbed": largest(*absorbed), "work": work,
        })
    });
    let balance = reactions.balance;
    json!({
        "scene": path,
        "outcome": run.outcome.to_string(),
        "t": run.last().t,
        "joints": joints.collect::<Vec<_>>(),
        "powers": powers.collect::<Vec<_>>(),
        "elements": elements.collect::<Vec<_>>(),
        "balance": { "work": balance.work, "kinetic": balance.kinetic, "difference": balance.difference() },
        "impacts_left_out": n_impacts(run),
    })
}
