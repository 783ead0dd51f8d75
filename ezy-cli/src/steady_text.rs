//! What commands tell of a steady motion: where it is, and what becomes of small deviations, as text and as JSON.

use serde_json::{Value, json};

use ezy_core::analysis::{Course, Frame, Spectrum, SteadyMotion};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::rounded;
use ezy_study::report::table::{Table, fixed};
use nalgebra::Complex;

/// Digits of what describes.
const DIGITS: usize = 6;
/// Decimals of coordinates and reactions.
const DECIMALS: usize = 9;
/// Rows of a table; further ones are counted.
const MOST_ROWS: usize = 60;

/// How a scene moves steadily, in a line.
pub(super) fn heading(info: &SceneInfo, motion: &SteadyMotion) -> String {
    let on = match pushed(info, motion) {
        Some((stop, end)) => {
            format!(", on the {end} end of stop `{stop}`; all that follows keeps to it")
        }
        None => String::new(),
    };
    format!("{}/{}: steady {}{on}\n\n", info.model, info.name, course_text(info, motion))
}

/// Name and end of the stop that holds.
fn pushed(info: &SceneInfo, motion: &SteadyMotion) -> Option<(&'static str, &'static str)> {
    let stop = info.stop?;
    // a lower end pushes by a negative multiplier
    let side = -motion.multipliers[stop.row];
    let end = (0..stop.sides.len()).find(|&end| f64::from(stop.sides[end]) * side > 0.0)?;
    Some((stop.name, stop.end(end)))
}

/// How a scene moves steadily, in words.
pub(super) fn course_text(info: &SceneInfo, motion: &SteadyMotion) -> String {
    let body = info.bodies.first().map_or("", |body| &**body);
    let short = |x| rounded(x, DIGITS);
    match motion.course() {
        Course::Rest => "at rest".to_owned(),
        Course::InPlace => "in place, with parts that turn evenly".to_owned(),
        Course::Straight { speed } => format!("straight at {} m/s", short(speed)),
        Course::Circle { speed, turn_rate, radius, .. } => format!(
            "on a circle: turns at {} rad/s; `{body}` at {} m/s, {} m from its centre",
            short(turn_rate),
            short(speed),
            short(radius)
        ),
    }
}

/// Coordinates with their rates, and states.
pub(super) fn state_text(info: &SceneInfo, motion: &SteadyMotion) -> String {
    let state = &motion.state;
    let mut table = Table::new(["coordinate", "value", "unit", "rate", "unit"]);
    let values = info.coordinates.iter().zip(&*info.velocities).zip(state.q.iter().zip(&state.v));
    for ((coordinate, rate), (q, v)) in values.take(MOST_ROWS) {
        table.push([&*coordinate.name, &fixed(*q, DECIMALS), coordinate.unit, &fixed(*v, DECIMALS), rate.unit]);
    }
    let mut text = table.to_string() + &more(state.q.len(), "coordinates");
    if !state.z.is_empty() {
        let mut table = Table::new(["state", "value", "unit"]);
        info.states.iter().zip(&state.z).for_each(|(of, z)| table.push([of.name, &fixed(*z, DECIMALS), of.unit]));
        text += &format!("\n{table}");
    }
    text
}

/// Multipliers of the rows; nothing without rows.
pub(super) fn reactions_text(info: &SceneInfo, motion: &SteadyMotion) -> String {
    if info.rows.is_empty() {
        return String::new();
    }
    let mut table = Table::new(["reaction", "value", "unit"]);
    for (row, value) in info.rows.iter().zip(&motion.multipliers).take(MOST_ROWS) {
        table.push([&*row.name, &fixed(*value, DECIMALS), row.multiplier_unit]);
    }
    format!("\n{table}{}", more(info.rows.len(), "rows"))
}

fn more(n: usize, what: &str) -> String {
    match n.saturating_sub(MOST_ROWS) {
        0 => String::new(),
        more => format!("and {more} more {what}; --json has all\n"),
    }
}

/// As a share of the largest eigenvalue: that of a place is the turn rate to rounding.
const SAME: f64 = 1e-8;

/// How many eigenvalues are ±i times the turn rate of the frame, of circles about other centres: seen from a frame that turns, a place that is
/// moved goes round. None where the place counts.
fn n_of_centres(motion: &SteadyMotion, spectrum: &Spectrum) -> usize {
    let turn = motion.frame.omega.abs();
    let largest = spectrum.eigenvalues.iter().fold(0.0, |largest: f64, s| largest.max(s.norm()));
    let is_turn =
        |s: &&Complex<f64>| (Complex::new(s.re, s.im.abs()) - Complex::new(0.0, turn)).norm() <= SAME * largest;
    let n = spectrum.eigenvalues.iter().filter(is_turn).count();
    if matches!(motion.course(), Course::Circle { .. }) && n == 2 && !motion.free.is_empty() { n } else { 0 }
}

/// Whether small deviations grow: the word for it.
pub(super) fn verdict(motion: &SteadyMotion, spectrum: &Spectrum) -> &'static str {
    match (spectrum.n_unstable(), spectrum.n_neutral() - n_of_centres(motion, spectrum).min(spectrum.n_neutral())) {
        (1.., _) => "unstable",
        (0, 0) if !spectrum.eigenvalues.is_empty() => "stable",
        _ => "neutral",
    }
}

pub(super) fn verdict_text(motion: &SteadyMotion, spectrum: &Spectrum) -> String {
    let (n_unstable, n_neutral) = (spectrum.n_unstable(), spectrum.n_neutral());
    match verdict(motion, spectrum) {
        "unstable" => format!("unstable: {} with a positive real part", counted(n_unstable)),
        "neutral" if spectrum.eigenvalues.is_empty() => {
            "neutral by the linear part: all eigenvalues are zero; nonlinear terms decide".to_owned()
        }
        "neutral" => format!(
            "neutral by the linear part: {} on the imaginary axis, none to the right of it; nonlinear terms decide",
            counted(n_neutral)
        ),
        _ if n_of_centres(motion, spectrum) > 0 => {
            "stable, besides the zeros and the pair ±i times the turn rate, which is that of circles about other centres".to_owned()
        }
        _ if spectrum.n_zero > 0 => {
            "stable, besides the zeros: all other eigenvalues have a negative real part".to_owned()
        }
        _ => "stable: all eigenvalues have a negative real part".to_owned(),
    }
}

fn counted(n: usize) -> String {
    format!("{n} {}", if n == 1 { "eigenvalue" } else { "eigenvalues" })
}

/// What the zeros are.
pub(super) fn zeros_text(motion: &SteadyMotion, spectrum: &Spectrum) -> String {
    let SteadyMotion { free, .. } = motion;
    let Spectrum { n_zero, zero_blocks, .. } = spectrum;
    let blocks: Vec<String> = zero_blocks.iter().map(usize::to_string).collect();
    let blocks = match &blocks[..] {
        [] => return "no eigenvalue is zero: there is no other steady motion next to this one".to_owned(),
        [block] => format!("one Jordan block of {block}"),
        _ => format!("Jordan blocks of {}", blocks.join(", ")),
    };
    let mut text = format!("{} {} zero, in {blocks}", counted(*n_zero), if *n_zero == 1 { "is" } else { "are" });
    if !free.is_empty() {
        text += &format!(": there are steady motions next to this one, with other values of {}", free.join(", "));
    }
    match zero_blocks.iter().max() {
        Some(1) => text + "\nsuch a deviation neither grows nor fades",
        Some(2) => {
            text + "\nin a block of 2 a deviation grows evenly with time, as a place does with another speed or heading"
        }
        Some(n) => text + &format!("\nin a block of {n} a deviation grows as time to the power of {}", n - 1),
        None => text,
    }
}

/// The motion with its names, and what becomes of small deviations.
pub(super) fn motion_json(info: &SceneInfo, motion: &SteadyMotion) -> Value {
    let SteadyMotion { state, frame: Frame { vx, vy, omega }, .. } = motion;
    let (kind, [speed, turn_rate, radius], centre) = match motion.course() {
        Course::Rest => ("rest", [Some(0.0), Some(0.0), None], None),
        Course::InPlace => ("in place", [Some(0.0), Some(0.0), None], None),
        Course::Straight { speed } => ("straight", [Some(speed), Some(0.0), None], None),
        Course::Circle { speed, turn_rate, radius, centre } => {
            ("circle", [Some(speed), Some(turn_rate), Some(radius)], Some(centre))
        }
    };
    let named = |names: Vec<&str>, values: &[f64]| -> Value {
        names.into_iter().zip(values).map(|(name, value)| (name.to_owned(), json!(value))).collect()
    };
    let coordinates = || info.coordinates.iter().map(|c| &*c.name).collect::<Vec<_>>();
    json!({
        "kind": kind,
        "speed": speed,
        "turn_rate": turn_rate,
        "radius": radius,
        "centre": centre,
        "frame": { "vx": vx, "vy": vy, "omega": omega },
        "t": state.t,
        "state": named(coordinates(), &state.q),
        "rate": named(coordinates(), &state.v),
        "acceleration": named(coordinates(), &motion.accelerations),
        "states": named(info.states.iter().map(|state| state.name).collect(), &state.z),
        "multipliers": named(info.rows.iter().map(|row| &*row.name).collect(), &motion.multipliers),
        "stop": pushed(info, motion).map(|(stop, end)| json!({ "name": stop, "end": end })),
        "free": motion.free,
        "newton_steps": motion.n_steps,
    })
}
