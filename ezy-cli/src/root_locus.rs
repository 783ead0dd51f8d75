//! `linearize --vary`: a root locus as text, JSON, CSV and figure.

use serde_json::{Value, json};

use super::failure::Failure;
use super::progress::Progress;
#[cfg(feature = "figures")]
use super::shown::Drawing;
use super::shown::{Forms, Shown};
use super::steady::{Request, failed};
use super::steady_arguments::LinearizeArguments;
use super::value::parse_number;
use super::vary::{Target, Variation, target};
use ezy_core::analysis::{CriticalValue, Instability, Locus};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::{legible, rounded};
use ezy_study::report::table::{Table, fixed};

/// Digits of critical values: as many as are found.
const DIGITS: usize = 11;
/// Decimals of real parts.
const DECIMALS: usize = 6;

/// Computes a root locus, writes its files and prints it.
pub(super) fn print_locus(
    request: &Request,
    arguments: &LinearizeArguments,
    variation: &Variation,
) -> Result<(), Failure> {
    let LinearizeArguments { out, plot, json, .. } = arguments;
    let Variation { name, values } = variation;
    let info = request.info();
    let target = target(name, &info)?;
    if target == Target::Setting {
        return Err(Failure::wrong_use(format!(
            "--vary {name}: a linearization has no {name}; vary a parameter, an input or a start value"
        )));
    }
    let forms = Forms::new("root loci", out.as_deref(), plot.as_deref(), *json)?;
    let number =
        |value: &String| parse_number(value).map_err(|why| Failure::wrong_use(format!("--vary {name}: {why}")));
    let values = values.iter().map(number).collect::<Result<Vec<f64>, _>>()?;
    let progress = Progress::of_cases(values.len() as u64);
    let mut n_done = 0;
    let spectrum = |value: f64| {
        n_done += 1;
        // critical values between them take some more
        progress.tell_cases(n_done.min(values.len() as u64), values.len() as u64);
        let at = |failure: Failure| {
            let message = format!("{name} = {}: {}", legible(value), failure.message());
            if matches!(failure, Failure::Use(_)) { Failure::Use(message) } else { Failure::Stopped(message) }
        };
        let (_, linear) = request.linearized(Some((name, &format!("{value:?}")))).map_err(at)?;
        linear.spectrum().map_err(|error| at(failed(error)))
    };
    let locus = match target {
        // between whole numbers there is nothing to look for
        Target::Count(_) => Locus::without_critical_values(&values, spectrum)?,
        _ => Locus::of(&values, spectrum)?,
    };
    drop(progress);
    let varied = Varied { path: request.path(), name, unit: unit(name, &info), locus: &locus };
    forms.show(&varied)
}

/// The unit of what varies.
pub(super) fn unit<'i>(name: &str, info: &'i SceneInfo) -> &'i str {
    let declared = info.parameters.iter().chain(info.inputs).map(|known| (known.name, known.unit));
    let states = info.states.iter().map(|known| (known.name, known.unit));
    let starts = info.coordinates.iter().chain(&*info.velocities).map(|known| (&*known.name, known.unit));
    declared.chain(states).chain(starts).find(|(known, _)| *known == name).map_or("", |(_, unit)| unit)
}

struct Varied<'a> {
    path: String,
    name: &'a str,
    unit: &'a str,
    locus: &'a Locus,
}

impl Varied<'_> {
    fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.to_owned() } else { format!("{} [{}]", self.name, self.unit) }
    }
}

impl Shown for Varied<'_> {
    fn text(&self) -> String {
        let head = [&*self.heading(), "largest real [1/s]", "its imag [1/s]", "unstable", "zero"];
        let mut table = Table::new(head);
        for (value, spectrum) in &self.locus.points {
            let first = spectrum.eigenvalues.first();
            let [re, im] = [first.map(|s| s.re), first.map(|s| s.im)]
                .map(|x| x.map_or_else(|| "none".to_owned(), |x| fixed(x, DECIMALS)));
            let [unstable, zero] = [spectrum.n_unstable(), spectrum.n_zero].map(|n| n.to_string());
            table.push([legible(*value), re, im, unstable, zero]);
        }
        let mut text = format!("{}: eigenvalues over {}\n\n{table}\n", self.path, self.name);
        let mut n_unstable: Vec<usize> = self.locus.points.iter().map(|(_, spectrum)| spectrum.n_unstable()).collect();
        n_unstable.dedup();
        if let [n] = n_unstable[..] {
            text += &format!("no critical value: {n} unstable at all of these values\n");
        }
        for CriticalValue { value, kind, n_unstable: [below, above] } in &self.locus.critical {
            let kind = match kind {
                Instability::Oscillation { omega } => format!(
                    "an oscillation of {} rad/s, {} Hz",
                    rounded(*omega, DIGITS),
                    rounded(omega / std::f64::consts::TAU, DECIMALS)
                ),
                Instability::Divergence => "a divergence, without oscillation,".to_owned(),
            };
            let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
            text += &format!(
                "critical {} = {}{unit}: {kind} {}; {below} unstable below, {above} above\n",
                self.name,
                rounded(*value, DIGITS),
                if below < above { "begins to grow" } else { "grows no more" },
            );
        }
        text
    }

    fn json(&self) -> Value {
        let eigenvalues = |spectrum: &ezy_core::analysis::Spectrum| -> Vec<[f64; 2]> {
            spectrum.eigenvalues.iter().map(|s| [s.re, s.im]).collect()
        };
        let points = self.locus.points.iter().map(|(value, spectrum)| {
            json!({
                "value": value,
                "eigenvalues": eigenvalues(spectrum),
                "zeros": { "count": spectrum.n_zero, "jordan_blocks": spectrum.zero_blocks },
                "unstable": spectrum.n_unstable(),
            })
        });
        let critical = self.locus.critical.iter().map(|of| {
            let (kind, omega) = match of.kind {
                Instability::Oscillation { omega } => ("oscillation", Some(omega)),
                Instability::Divergence => ("divergence", None),
            };
            json!({ "value": of.value, "kind": kind, "omega": omega, "unstable_below": of.n_unstable[0], "unstable_above": of.n_unstable[1] })
        });
        json!({
            "scene": self.path,
            "name": self.name,
            "unit": self.unit,
            "points": points.collect::<Vec<_>>(),
            "critical": critical.collect::<Vec<_>>(),
        })
    }

    /// A row for each value and eigenvalue that is not zero.
    fn csv(&self) -> Result<Vec<u8>, Failure> {
        let mut rows = csv::Writer::from_writer(Vec::new());
        rows.write_record([&*self.heading(), "real [1/s]", "imaginary [1/s]"]).map_err(Failure::stopped)?;
        for (value, spectrum) in &self.locus.points {
            for s in &spectrum.eigenvalues {
                rows.write_record([*value, s.re, s.im].map(legible)).map_err(Failure::stopped)?;
            }
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    /// Real and imaginary parts over the value, with the critical values marked.
    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing {
        use super::drawing_of_columns::axis;
        use ezy_study::report::figure::Figure;
        use nalgebra::Complex;

        let all = |part: fn(&Complex<f64>) -> f64| -> (Vec<f64>, Vec<f64>) {
            let points = self.locus.points.iter();
            points.flat_map(|(value, of)| of.eigenvalues.iter().map(move |s| (*value, part(s)))).unzip()
        };
        let critical = |imaginary: bool| -> (Vec<f64>, Vec<f64>) {
            let omega = |kind: Instability| match kind {
                Instability::Oscillation { omega } if imaginary => omega,
                _ => 0.0,
            };
            self.locus.critical.iter().map(|of| (of.value, omega(of.kind))).unzip()
        };
        let (re, im) = (all(|s| s.re), all(|s| s.im));
        let ([re_critical, im_critical], title) = ([false, true].map(critical), format!("{}: root locus", self.path));
        let ends = [self.locus.points.first(), self.locus.points.last()].into_iter().flatten();
        let (x, zero): (Vec<f64>, Vec<f64>) = ends.map(|(value, _)| (*value, 0.0)).unzip();
        let figure = Figure::plane(&title, &axis(self.name, self.unit), &axis("real part", "1/s"))
            .guide("", x, zero)
            .cloud("eigenvalues", re.0, re.1)
            .hinges(if self.locus.critical.is_empty() { "" } else { "critical" }, re_critical.0, re_critical.1)
            .panel(&axis("imaginary part", "1/s"))
            .cloud("", im.0, im.1)
            .hinges("", im_critical.0, im_critical.1);
        Drawing { figure, title, alternative: format!("eigenvalues over {}", self.name) }
    }
}
