//! `linearize --response`: transfer functions as text, JSON, CSV and Bode plot.

use std::path::Path;

use super::animate::write;
use super::drawing;
use super::failure::{Failure, print};
use super::json::print_json;
use super::out_path::check_ending;
use super::response_text::{json_of, text_of};
use super::steady::{Request, failed};
use super::steady_arguments::{LinearizeArguments, Pair};
use crate::analysis::{BodePoint, Linearization, Transfer};
use crate::model::SceneInfo;
use crate::record::find_name;
use crate::scalar::legible;

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
    if let Some(out) = out {
        check_ending(out, "responses", &["csv"])?;
    }
    if let Some(plot) = plot {
        drawing::check()?;
        drawing::check_name(plot)?;
    }
    let (motion, linear) = request.linearized(None)?;
    let transfers = transfers(&linear, response)?;
    let path = request.path();
    if out.is_some() || plot.is_some() {
        let span = frequencies.unwrap_or_else(|| span(&transfers));
        let responses = Responses { path: &path, of: transfers.iter().map(|of| (of, bode(of, span))).collect() };
        if let Some(out) = out {
            write(out, responses.csv(&info)?)?;
        }
        if let Some(plot) = plot {
            responses.draw(plot)?;
        }
    }
    if *json {
        return print_json(&json_of(&info, &motion, &transfers));
    }
    let files: String = [out, plot].into_iter().flatten().map(|path| format!("\n{}", path.display())).collect();
    print(&format!("{}{files}{}", text_of(&info, &motion, &transfers), if files.is_empty() { "" } else { "\n" }))
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

fn bode(of: &Transfer, span: [f64; 2]) -> Vec<BodePoint> {
    of.bode(&of.frequencies(span, N_FREQUENCIES))
}

struct Responses<'a> {
    path: &'a str,
    of: Vec<(&'a Transfer, Vec<BodePoint>)>,
}

impl Responses<'_> {
    /// A row for each pair and frequency.
    fn csv(&self, info: &SceneInfo) -> Result<Vec<u8>, Failure> {
        let mut rows = csv::Writer::from_writer(Vec::new());
        let head = ["input", "output", "frequency [rad/s]", "magnitude", "unit", "magnitude [dB]", "phase [deg]"];
        rows.write_record(head).map_err(Failure::stopped)?;
        for (of, points) in &self.of {
            let unit = super::response_text::unit(info, of);
            for point in points {
                let numbers = [point.omega, point.magnitude, point.decibels(), point.phase.to_degrees()].map(legible);
                let [omega, magnitude, decibels, phase] = &numbers;
                let row = [of.input, &of.output, omega, magnitude, &unit, decibels, phase];
                rows.write_record(row).map_err(Failure::stopped)?;
            }
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    #[cfg(not(feature = "figures"))]
    #[allow(clippy::unused_self, reason = "drawn, if at all")]
    fn draw(&self, _: &Path) -> Result<(), Failure> {
        drawing::check()
    }

    /// Magnitude and phase over the frequency.
    #[cfg(feature = "figures")]
    fn draw(&self, path: &Path) -> Result<(), Failure> {
        use super::drawing_of_columns::write;
        use crate::report::figure::Figure;

        let title = match &self.of[..] {
            [(of, _)] => format!("{}: response of {} to {}", self.path, of.output, of.input),
            _ => format!("{}: responses", self.path),
        };
        let name =
            |of: &Transfer| if self.of.len() > 1 { format!("{} → {}", of.input, of.output) } else { String::new() };
        let lines = |mut figure: Figure, y: fn(&BodePoint) -> f64| {
            for (of, points) in &self.of {
                let (x, y) = points.iter().map(|point| (point.omega, y(point))).unzip();
                figure = figure.line(&name(of), x, y);
            }
            figure
        };
        let figure = lines(Figure::log_x(&title, "frequency [rad/s]", "magnitude [dB]"), BodePoint::decibels);
        let figure = lines(figure.panel("phase [deg]"), |point| point.phase.to_degrees());
        write(&figure, &title, "magnitude and phase over the frequency", path)
    }
}
