//! `linearize --response`: transfer functions as text, JSON, CSV and Bode plot.

use serde_json::Value;

use super::failure::Failure;
use super::response_text::{json_of, text_of};
#[cfg(feature = "figures")]
use super::selection::typed;
#[cfg(feature = "figures")]
use super::shown::Drawing;
use super::shown::{Forms, Shown};
use super::steady::{Request, failed};
use super::steady_arguments::{LinearizeArguments, Pair};
use ezy_core::analysis::{BodePoint, Linearization, SteadyMotion, Transfer};
use ezy_core::model::SceneInfo;
use ezy_core::record::find_name;
use ezy_core::scalar::legible;

/// Frequencies of a Bode plot, besides those at peaks and notches.
const N_FREQUENCIES: usize = 400;

/// Computes the responses that are asked for, writes their files and prints them.
pub(super) fn print_responses(request: &Request, arguments: &LinearizeArguments) -> Result<(), Failure> {
    let LinearizeArguments { response, frequencies, out, plot, json, .. } = arguments;
    let info = request.info();
    check_names(&request.path(), &info, response)?;
    if frequencies.is_some() && out.is_none() && plot.is_none() {
        return Err(Failure::wrong_use(
            "--frequencies are those of files: give --out FILE.csv or --plot FILE with them",
        ));
    }
    let forms = Forms::new("responses", out.as_deref(), plot.as_deref(), *json)?;
    let (motion, linear) = request.linearized(None)?;
    let transfers = transfers(&linear, response)?;
    let span = frequencies.unwrap_or_else(|| span(&transfers));
    forms.show(&Responses { info: &info, motion: &motion, transfers: &transfers, span })
}

/// That there are such inputs and outputs; where there are none at all, how to declare them.
fn check_names(path: &str, info: &SceneInfo, pairs: &[Pair]) -> Result<(), Failure> {
    let without = |what: &str, such_as: &str| {
        Failure::wrong_use(format!(
            "--response: {path} has no {what}; declare one in the model or in an effect that the scene is run with, such as {such_as}; \
             docs/language.md has more under `{what}`"
        ))
    };
    if info.inputs.is_empty() {
        return Err(without("input", "`input push: N = 0;` with `force at body(0, 0): (push, 0);`"));
    }
    if info.outputs.is_empty() {
        return Err(without("output", "`output place: m = body.x;`"));
    }
    for Pair { input, output } in pairs {
        find_name("input", input, info.inputs.iter().map(|input| input.name))?;
        find_name("output", output, info.outputs.iter().map(|output| &*output.name))?;
    }
    Ok(())
}

fn transfers(linear: &Linearization, pairs: &[Pair]) -> Result<Vec<Transfer>, Failure> {
    pairs.iter().map(|Pair { input, output }| linear.transfer(input, output).map_err(failed)).collect()
}

/// From the lowest to the highest frequency of all.
fn span(transfers: &[Transfer]) -> [f64; 2] {
    let spans = transfers.iter().map(Transfer::span);
    spans.fold([f64::INFINITY, 0.0], |[low, high], [first, last]| [low.min(first), high.max(last)])
}

struct Responses<'a> {
    info: &'a SceneInfo,
    motion: &'a SteadyMotion,
    transfers: &'a [Transfer],
    /// Lowest and highest frequency of files, rad/s.
    span: [f64; 2],
}

impl Responses<'_> {
    fn bode(&self, of: &Transfer) -> Vec<BodePoint> {
        of.bode(&of.frequencies(self.span, N_FREQUENCIES))
    }
}

impl Shown for Responses<'_> {
    fn text(&self) -> String {
        text_of(self.info, self.motion, self.transfers)
    }

    fn json(&self) -> Value {
        json_of(self.info, self.motion, self.transfers)
    }

    /// A row for each pair and frequency.
    fn csv(&self) -> Result<Vec<u8>, Failure> {
        let mut rows = csv::Writer::from_writer(Vec::new());
        let head = ["input", "output", "frequency [rad/s]", "magnitude", "unit", "magnitude [dB]", "phase [deg]"];
        rows.write_record(head).map_err(Failure::stopped)?;
        for of in self.transfers {
            let unit = super::response_text::unit(self.info, of);
            for point in self.bode(of) {
                let numbers = [point.omega, point.magnitude, point.decibels(), point.phase.to_degrees()].map(legible);
                let [omega, magnitude, decibels, phase] = &numbers;
                let row = [of.input, &of.output, omega, magnitude, &unit, decibels, phase];
                rows.write_record(row).map_err(Failure::stopped)?;
            }
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    /// Magnitude and phase over the frequency.
    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing {
        use ezy_study::report::figure::Figure;

        let path = format!("{}/{}", typed(self.info.model), self.info.name);
        let title = match self.transfers {
            [of] => format!("{path}: response of {} to {}", of.output, of.input),
            _ => format!("{path}: responses"),
        };
        let name = |of: &Transfer| {
            if self.transfers.len() > 1 { format!("{} → {}", of.input, of.output) } else { String::new() }
        };
        let curves: Vec<(&Transfer, Vec<BodePoint>)> = self.transfers.iter().map(|of| (of, self.bode(of))).collect();
        let lines = |mut figure: Figure, y: fn(&BodePoint) -> f64| {
            for (of, points) in &curves {
                let (x, y) = points.iter().map(|point| (point.omega, y(point))).unzip();
                figure = figure.line(&name(of), x, y);
            }
            figure
        };
        let figure = lines(Figure::log_x(&title, "frequency [rad/s]", "magnitude [dB]"), BodePoint::decibels);
        let figure = lines(figure.panel("phase [deg]"), |point| point.phase.to_degrees());
        Drawing { figure, title, alternative: "magnitude and phase over the frequency".to_owned() }
    }
}
