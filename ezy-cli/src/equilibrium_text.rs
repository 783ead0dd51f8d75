//! Equilibria, as text and as JSON.

use serde_json::{Value, json};

use super::steady::N_STARTS;
use super::steady_text::{heading, motion_json, reactions_text, state_text, verdict, verdict_text, zeros_text};
use ezy_core::analysis::{AnalysisError, Rest, Rests, Spectrum, SteadyMotion};
use ezy_core::model::SceneInfo;
use ezy_study::report::table::{Table, fixed};

/// Digits of coordinates in the table of all rests.
const SHOWN_DIGITS: usize = 6;

/// Coordinates in the table of all rests.
const MAX_COLUMNS: usize = 6;

/// The stability of a rest without linear equations.
const UNKNOWN: &str = "unknown";

/// One steady motion with its reactions.
pub(super) fn motion_text(info: &SceneInfo, motion: &SteadyMotion, spectrum: &Spectrum) -> String {
    let found = heading(info, motion) + &state_text(info, motion) + &reactions_text(info, motion);
    let steps = if motion.n_steps == 1 { "step" } else { "steps" };
    format!(
        "{found}\n{}\n{}\nfound in {} Newton {steps}\n",
        verdict_text(motion, spectrum),
        zeros_text(motion, spectrum),
        motion.n_steps
    )
}

/// A line for each rest.
pub(super) fn rests_text(info: &SceneInfo, rests: &Rests, spectra: &[Result<Spectrum, AnalysisError>]) -> String {
    let n = rests.found.len();
    let lost = match rests.n_lost {
        0 => String::new(),
        1 => "; 1 led to none".to_owned(),
        n => format!("; {n} led to none"),
    };
    let mut text = format!(
        "{}/{}: {n} {} found from {N_STARTS} starts{lost}\n",
        info.model,
        info.name,
        if n == 1 { "rest" } else { "rests" }
    );
    if n == 0 {
        return text;
    }
    // angles say where a mechanism of bodies is; without any, all coordinates
    let moves = |i: &usize| {
        let mut values = rests.found.iter().map(|rest| rest.motion.state.q[*i]);
        let first = values.next().unwrap_or_default();
        values.any(|value| fixed(value, SHOWN_DIGITS) != fixed(first, SHOWN_DIGITS))
    };
    let angles = (0..info.n_coordinates()).filter(|i| info.coordinates[*i].is_angle());
    let mut shown: Vec<usize> = angles.filter(|i| n == 1 || moves(i)).collect();
    if shown.is_empty() {
        shown = (0..info.n_coordinates()).filter(|i| n == 1 || moves(i)).collect();
    }
    let left_out = shown.len().saturating_sub(MAX_COLUMNS);
    shown.truncate(MAX_COLUMNS);
    let names = shown.iter().map(|i| format!("{} [{}]", info.coordinates[*i].name, info.coordinates[*i].unit));
    let mut table = Table::new(names.chain(["stability", "unstable", "free", "starts"].map(str::to_owned)));
    for (rest, spectrum) in rests.found.iter().zip(spectra) {
        let values = shown.iter().map(|i| fixed(rest.motion.state.q[*i], SHOWN_DIGITS));
        let [stability, n_unstable] = match spectrum {
            Ok(spectrum) => [verdict(&rest.motion, spectrum).to_owned(), spectrum.n_unstable().to_string()],
            Err(_) => [UNKNOWN, "-"].map(str::to_owned),
        };
        let of_rest = [stability, n_unstable, rest.motion.free.len().to_string(), rest.n_starts.to_string()];
        table.push(values.chain(of_rest));
    }
    text += &format!("\n{table}");
    let n_unknown = spectra.iter().filter(|spectrum| spectrum.is_err()).count();
    if let Some(error) = spectra.iter().find_map(|spectrum| spectrum.as_ref().err()) {
        text += &format!("no linear equations about {n_unknown} of them: {error}\n");
    }
    if left_out > 0 {
        text += &format!("and {left_out} more coordinates; --json has all\n");
    }
    text
}

/// All rests.
pub(super) fn rests_json(info: &SceneInfo, rests: &Rests, spectra: &[Result<Spectrum, AnalysisError>]) -> Value {
    let of = |(rest, spectrum): (&Rest, &Result<Spectrum, AnalysisError>)| {
        let mut value = match spectrum {
            Ok(spectrum) => with_spectrum(info, &rest.motion, spectrum),
            Err(error) => json!({
                "steady": motion_json(info, &rest.motion),
                "verdict": UNKNOWN,
                "error": error.to_string(),
            }),
        };
        value["starts"] = rest.n_starts.into();
        value
    };
    json!({
        "model": info.model,
        "scene": info.name,
        "starts": N_STARTS,
        "lost": rests.n_lost,
        "rests": rests.found.iter().zip(spectra).map(of).collect::<Vec<_>>(),
    })
}

/// A motion and its eigenvalues, by the names that `linearize` uses.
pub(super) fn with_spectrum(info: &SceneInfo, motion: &SteadyMotion, spectrum: &Spectrum) -> Value {
    json!({
        "steady": motion_json(info, motion),
        "eigenvalues": spectrum.eigenvalues.iter().map(|s| json!({ "real": s.re, "imaginary": s.im })).collect::<Vec<_>>(),
        "zeros": { "count": spectrum.n_zero, "jordan_blocks": spectrum.zero_blocks },
        "unstable": spectrum.n_unstable(),
        "neutral": spectrum.n_neutral(),
        "verdict": verdict(motion, spectrum),
    })
}
