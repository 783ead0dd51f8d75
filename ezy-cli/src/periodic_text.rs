//! A periodic motion, as text, as JSON and as CSV.

use serde_json::{Value, json};

use super::failure::Failure;
use super::linearize_text::{names_of_rows, rows};
#[cfg(feature = "figures")]
use super::selection::typed;
#[cfg(feature = "figures")]
use super::shown::Drawing;
use super::shown::Shown;
use ezy_core::analysis::{PeriodicMotion, Stability, Trivial};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::{legible, rounded};
#[cfg(feature = "figures")]
use ezy_study::report::figure::Figure;
use ezy_study::report::table::{Table, fixed};

/// Sides of what is drawn for a circle.
#[cfg(feature = "figures")]
const N_OF_CIRCLE: usize = 180;
/// Digits of what describes.
const DIGITS: usize = 9;
/// Decimals of the start.
const DECIMALS: usize = 9;
/// Decimals of multipliers.
const OF_MULTIPLIERS: usize = 6;
/// Rows of a table; further ones are counted.
const MOST_ROWS: usize = 60;
/// Names of what moves most with a multiplier.
const MOST_NAMES: usize = 3;

pub(super) struct Found<'a> {
    pub info: &'a SceneInfo,
    pub motion: &'a PeriodicMotion,
}

impl Shown for Found<'_> {
    fn text(&self) -> String {
        text_of(self.info, self.motion)
    }

    fn json(&self) -> Value {
        json_of(self.info, self.motion)
    }

    fn csv(&self) -> Result<Vec<u8>, Failure> {
        csv_of(self.info, self.motion)
    }

    /// The multipliers in the complex plane.
    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing {
        let title = format!("{}/{}: multipliers", typed(self.info.model), self.info.name);
        let of_modes = self.motion.modes.iter().map(|mode| (mode.eigenvalue.re, mode.eigenvalue.im));
        let (re, im) = of_modes.unzip();
        let circle = |i: usize| (std::f64::consts::TAU * i as f64 / N_OF_CIRCLE as f64).sin_cos();
        let (y, x) = (0..=N_OF_CIRCLE).map(circle).unzip();
        let figure = Figure::equal(&title, "real part", "imaginary part").guide("unit circle", x, y).hinges(
            "multipliers",
            re,
            im,
        );
        Drawing { figure, title, alternative: "multipliers and the unit circle in the complex plane".to_owned() }
    }
}

fn text_of(info: &SceneInfo, motion: &PeriodicMotion) -> String {
    let short = |x| rounded(x, DIGITS);
    let mut text = format!("{}/{}: periodic, T = {} s\n", info.model, info.name, short(motion.period));
    if let Some((distance, angle)) = moved(motion) {
        let body = info.bodies.first().map_or("", |body| &**body);
        text += &format!(
            "in a period `{body}` goes {} m, {} m/s on average, and turns by {} deg\n",
            short(distance),
            short(distance / motion.period),
            fixed(angle.to_degrees(), OF_MULTIPLIERS)
        );
    }
    let mut table = Table::new(["start", "value", "unit", "rate", "unit"]);
    let state = motion.start();
    let values = info.coordinates.iter().zip(&*info.velocities).zip(state.q.iter().zip(&state.v));
    for ((of, rate), (q, v)) in values.take(MOST_ROWS) {
        table.push([&*of.name, &fixed(*q, DECIMALS), of.unit, &fixed(*v, DECIMALS), rate.unit]);
    }
    info.states.iter().zip(&state.z).for_each(|(of, z)| table.push([of.name, &fixed(*z, DECIMALS), of.unit, "", ""]));
    text += &format!("\n{table}");
    if state.q.len() > MOST_ROWS {
        text += &format!("and {} more coordinates; --json has all\n", state.q.len() - MOST_ROWS);
    }
    if !motion.modes.is_empty() {
        let names = names_of_rows(info);
        let mut table = Table::new(["multiplier", "angle [deg]", "moves most"]);
        for mode in &motion.modes {
            let most: Vec<&str> = mode.largest.iter().take(MOST_NAMES).map(|i| names[*i]).collect();
            let mu = mode.eigenvalue;
            table.push([
                fixed(mu.norm(), OF_MULTIPLIERS),
                fixed(mu.arg().to_degrees(), OF_MULTIPLIERS),
                most.join(", "),
            ]);
        }
        text += &format!("\n{table}");
    }
    let words = match motion.stability() {
        Stability::Stable => "stable: small deviations fade",
        Stability::Unstable => "unstable: small deviations grow",
        Stability::Neutral => "neutral: to first order small deviations neither grow nor all fade",
    };
    text += &format!("\n{words}\n");
    if !motion.trivial.is_empty() {
        let n = motion.trivial.len();
        let (multipliers, have) = if n == 1 { ("multiplier", "has") } else { ("multipliers", "have") };
        let mut of: Vec<String> = motion.trivial.iter().map(name).collect();
        // a place has two directions
        of.dedup();
        text += &format!("{n} more {multipliers}, of {}, {have} modulus 1 in any such motion\n", of.join(" and "));
    }
    let steps = if motion.n_steps == 1 { "step" } else { "steps" };
    text + &format!(
        "returns to {:.1e}; found in {} Newton {steps}; multipliers to {:.1e}, by steps of half the length\n",
        motion.monodromy.gap, motion.n_steps, motion.change
    )
}

/// Distance, m, and turn, rad, over a period, where nothing depends on place or heading.
fn moved(motion: &PeriodicMotion) -> Option<(f64, f64)> {
    let [x, y, angle] = motion.monodromy.moved;
    let is_free = motion.trivial.iter().any(|of| matches!(of, Trivial::Place | Trivial::Heading));
    is_free.then(|| (x.hypot(y), angle))
}

fn name(trivial: &Trivial) -> String {
    match trivial {
        Trivial::Place => "place".to_owned(),
        Trivial::Heading => "heading".to_owned(),
        Trivial::Time => "time".to_owned(),
        Trivial::Angle(name) => format!("`{name}`"),
    }
}

fn json_of(info: &SceneInfo, motion: &PeriodicMotion) -> Value {
    let names = names_of_rows(info);
    let state = motion.start();
    let values = state.q.iter().chain(&state.v).chain(&state.z);
    let start: serde_json::Map<_, _> =
        names.iter().zip(values).map(|(name, value)| ((*name).to_owned(), (*value).into())).collect();
    let multipliers = motion.modes.iter().map(|mode| {
        let mu = mode.eigenvalue;
        json!({
            "real": mu.re, "imaginary": mu.im, "modulus": mu.norm(), "angle_deg": mu.arg().to_degrees(),
            "largest": mode.largest.iter().map(|i| names[*i]).collect::<Vec<_>>(),
        })
    });
    json!({
        "model": info.model,
        "scene": info.name,
        "period": motion.period,
        "start": start,
        "moved": { "x": motion.monodromy.moved[0], "y": motion.monodromy.moved[1], "phi": motion.monodromy.moved[2] },
        "mean_speed": moved(motion).map(|(distance, _)| distance / motion.period),
        "multipliers": multipliers.collect::<Vec<_>>(),
        "trivial": motion.trivial.iter().map(name).collect::<Vec<_>>(),
        "verdict": match motion.stability() {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Neutral => "neutral",
        },
        "names": names,
        "monodromy": rows(&motion.monodromy.matrix),
        "basis": rows(&motion.monodromy.basis),
        "gap": motion.monodromy.gap,
        "change": motion.change,
        "newton_steps": motion.n_steps,
    })
}

/// A row for each state.
fn csv_of(info: &SceneInfo, motion: &PeriodicMotion) -> Result<Vec<u8>, Failure> {
    let mut rows = csv::Writer::from_writer(Vec::new());
    let coordinates = info.coordinates.iter().chain(&*info.velocities).map(|c| format!("{} [{}]", c.name, c.unit));
    let states = info.states.iter().map(|state| format!("{} [{}]", state.name, state.unit));
    let head = std::iter::once("t [s]".to_owned()).chain(coordinates).chain(states);
    rows.write_record(head).map_err(Failure::stopped)?;
    for state in &motion.states {
        let numbers = std::iter::once(&state.t).chain(&state.q).chain(&state.v).chain(&state.z);
        rows.write_record(numbers.map(|x| legible(*x))).map_err(Failure::stopped)?;
    }
    rows.into_inner().map_err(Failure::stopped)
}
