//! Transfer functions as text and as JSON.

use serde_json::{Value, json};

use super::steady_text::{heading, motion_json};
use ezy_core::analysis::{AtFrequency, Spectrum, SteadyMotion, Transfer};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::rounded;
use ezy_study::report::table::{Table, fixed};
use nalgebra::Complex;

/// Digits of poles, zeros and what is told of them.
const DIGITS: usize = 6;

/// The unit of the magnitude: that of the output over that of the input.
pub(super) fn unit(info: &SceneInfo, of: &Transfer) -> String {
    let output = info.outputs.iter().find(|known| *known.name == *of.output).map_or("1", |known| known.unit);
    let input = info.inputs.iter().find(|known| known.name == of.input).map_or("1", |known| known.unit);
    match (output, input) {
        (output, "1") => output.to_owned(),
        (output, input) => format!("{output} per {input}"),
    }
}

pub(super) fn text_of(info: &SceneInfo, motion: &SteadyMotion, transfers: &[Transfer]) -> String {
    let parts: Vec<String> = transfers.iter().map(|of| part(info, of)).collect();
    heading(info, motion) + &parts.join("\n")
}

fn part(info: &SceneInfo, of: &Transfer) -> String {
    let unseen = match of.n_unseen {
        0 => String::new(),
        1 => "; 1 mode of the scene is not seen".to_owned(),
        n => format!("; {n} modes of the scene are not seen"),
    };
    let mut text = format!(
        "{} → {}: {}, {}{unseen}\n",
        of.input,
        of.output,
        counted(n_of(&of.poles), "pole"),
        counted(n_of(&of.zeros), "zero")
    );
    if of.gain == 0.0 {
        return text + "the output does not respond to the input\n";
    }
    if n_of(&of.poles) + n_of(&of.zeros) > 0 {
        let head = ["", "real [1/s]", "imag [1/s]", "damping ratio", "modulus [rad/s]"];
        let mut table = Table::new(head);
        for (kind, spectrum) in [("pole", &of.poles), ("zero", &of.zeros)] {
            for s in all(spectrum) {
                let ratio = if s.norm() > 0.0 { fixed(-s.re / s.norm(), DIGITS) } else { String::new() };
                table.push([kind.to_owned(), fixed(s.re, DIGITS), fixed(s.im, DIGITS), ratio, fixed(s.norm(), DIGITS)]);
            }
        }
        text += &format!("\n{table}\n");
    }
    for [name, value] in lines(&unit(info, of), of) {
        text += &format!("{name:<14}{value}\n");
    }
    text
}

/// What is told below the table: a name and a value each.
fn lines(unit: &str, of: &Transfer) -> Vec<[String; 2]> {
    let short = |x: f64| rounded(x, DIGITS);
    let hz = |omega: f64| format!("{} rad/s, {} Hz", short(omega), short(omega / std::f64::consts::TAU));
    let decibels = |x: f64| format!("{} dB", short(20.0 * x.log10()));
    let unstable = match of.poles.n_unstable() {
        0 => "",
        _ => " (the response does not settle to it: a pole is unstable)",
    };
    let static_gain = match of.static_gain() {
        Some(gain) => format!("{} {unit}{unstable}", short(gain)),
        None => "none, zero is a pole: a constant input moves the output on and on".to_owned(),
    };
    let power = match of.relative_degree() {
        0 => String::new(),
        1 => "/s".to_owned(),
        degree => format!("/s^{degree}"),
    };
    let resonance = match of.resonance() {
        Some(AtFrequency { value, omega }) => format!("{} {unit} at {}", short(value), hz(omega)),
        None if of.poles.n_zero + of.poles.n_neutral() > 0 => {
            "none, a pole on the imaginary axis: the magnitude has no bound".to_owned()
        }
        None => "none, the magnitude is largest at one end of the frequencies".to_owned(),
    };
    let bandwidth = match (of.bandwidth(), of.static_gain()) {
        (Some(omega), _) => format!("{} (-3 dB from the static gain)", hz(omega)),
        (None, Some(gain)) if gain != 0.0 => "none, the magnitude never falls by 3 dB".to_owned(),
        (None, _) => "none, without a static gain".to_owned(),
    };
    let gain_margin = match of.gain_margin() {
        Some(AtFrequency { value, omega }) => format!("{}, {}, at {}", short(value), decibels(value), hz(omega)),
        None => "none, the response is real and negative at no frequency".to_owned(),
    };
    let phase_margin = match of.phase_margin() {
        Some(AtFrequency { value, omega }) => format!("{} deg at {}", short(value.to_degrees()), hz(omega)),
        None => "none, the magnitude is 1 at no frequency".to_owned(),
    };
    let closed = match of.closed_loop() {
        None => "has no solution".to_owned(),
        Some(poles) => match (poles.n_unstable(), poles.n_zero + poles.n_neutral()) {
            (0, 0) => "is stable".to_owned(),
            (0, n) => format!("is neutral: {} on the imaginary axis", counted(n, "pole")),
            (n, _) => format!("is unstable: {} to the right of the imaginary axis", counted(n, "pole")),
        },
    };
    [
        ("static gain", static_gain),
        ("high end", format!("{}{power} for large s", short(of.gain))),
        ("resonance", resonance),
        ("bandwidth", bandwidth),
        ("gain margin", gain_margin),
        ("phase margin", phase_margin),
        ("feedback", format!("of the negative output, input = -output: the loop {closed}")),
    ]
    .map(|(name, value)| [name.to_owned(), value])
    .into()
}

fn n_of(spectrum: &Spectrum) -> usize {
    spectrum.eigenvalues.len() + spectrum.n_zero
}

/// With those that are zero behind the others.
fn all(spectrum: &Spectrum) -> impl Iterator<Item = Complex<f64>> {
    let zeros = std::iter::repeat_n(Complex::from(0.0), spectrum.n_zero);
    spectrum.eigenvalues.iter().copied().chain(zeros)
}

fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

pub(super) fn json_of(info: &SceneInfo, motion: &SteadyMotion, transfers: &[Transfer]) -> Value {
    let pairs = |spectrum: &Spectrum| all(spectrum).map(|s| [s.re, s.im]).collect::<Vec<_>>();
    let at = |of: Option<AtFrequency>| of.map(|of| json!({ "value": of.value, "frequency": of.omega }));
    let degrees = |of: AtFrequency| AtFrequency { value: of.value.to_degrees(), ..of };
    let responses = transfers.iter().map(|of| {
        json!({
            "input": of.input,
            "output": of.output,
            "unit": unit(info, of),
            "poles": pairs(&of.poles),
            "zeros": pairs(&of.zeros),
            "not_seen": of.n_unseen,
            "gain": of.gain,
            "relative_degree": of.relative_degree(),
            "static_gain": of.static_gain(),
            "resonance": at(of.resonance()),
            "bandwidth": of.bandwidth(),
            "gain_margin": at(of.gain_margin()),
            "phase_margin_deg": at(of.phase_margin().map(degrees)),
            "closed_loop_poles": of.closed_loop().map(|poles| pairs(&poles)),
        })
    });
    json!({
        "model": info.model,
        "scene": info.name,
        "steady": motion_json(info, motion),
        "responses": responses.collect::<Vec<_>>(),
    })
}
