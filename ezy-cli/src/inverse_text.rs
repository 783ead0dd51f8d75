//! What a prescribed motion takes, as text, JSON, CSV and figure.

use std::path::Path;

use serde_json::{Value, json};

use super::failure::Failure;
use super::inverse_values::{MULTIPLIER, Series, Values, integral, largest, root_mean_square};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::{legible, legible_time, rounded};
use ezy_study::report::table::{Table, fixed};

/// Decimals of values, powers and works.
const DECIMALS: usize = 9;
/// Digits of times.
const DIGITS: usize = 6;

/// Works and energy that differ by more than this share of what is turned over are told: a thousand tolerances of a run.
const NOTABLE: f64 = 1e-6;

/// What was found.
pub(super) struct Found<'a> {
    pub path: String,
    pub info: &'a SceneInfo,
    pub values: &'a Values,
    /// Samples for each row of the file.
    pub n_between: usize,
}

/// Works that add up to the change of the energy, J.
struct Balance {
    work: f64,
    change: f64,
    /// What all other forces took.
    taken: f64,
}

impl Balance {
    fn difference(&self) -> f64 {
        self.work - self.change - self.taken
    }
}

/// The largest value and when it is, then the smallest.
fn ends(times: &[f64], values: &[f64]) -> [(f64, f64); 2] {
    let negative: Vec<f64> = values.iter().map(|value| -value).collect();
    let place = |values: &[f64]| largest(values).map_or((f64::NAN, f64::NAN), |(i, value)| (value, times[i]));
    let (least, at) = place(&negative);
    [place(values), (-least, at)]
}

fn magnitudes(values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| value.abs()).collect()
}

impl Found<'_> {
    fn work(&self, series: &Series) -> f64 {
        integral(&self.values.times, &series.powers)
    }

    /// None where forces differ between rows that hold and rows that do not: samples do not tell which do.
    fn balance(&self) -> Option<Balance> {
        if !self.info.switches.is_empty() {
            return None;
        }
        let Values { times, series, others, energies } = self.values;
        let (first, last) = (energies.first()?, energies.last()?);
        Some(Balance {
            work: series.iter().map(|series| self.work(series)).sum(),
            change: last - first,
            taken: -integral(times, others),
        })
    }

    pub(super) fn text(&self) -> String {
        let Values { times, series, .. } = self.values;
        let [first, last] = [times.first(), times.last()].map(|t| legible_time(t.copied().unwrap_or_default()));
        let is_of_drives = series.iter().all(|series| series.name.starts_with(MULTIPLIER));
        let what = if is_of_drives { "multipliers" } else { "inputs in place of the drives" };
        let mut text = format!("{}: {what} from t = {first} s to {last} s\n\n", self.path);
        let mut table = Table::new(["name", "unit", "largest", "at [s]", "smallest", "at [s]", "root mean square"]);
        let mut powers = Table::new(["power of", "largest [W]", "at [s]", "smallest [W]", "at [s]", "work [J]"]);
        let number = |x: f64| fixed(x, DECIMALS);
        for series in series {
            let [(most, most_at), (least, least_at)] = ends(times, &series.values);
            let [most_at, least_at] = [most_at, least_at].map(|t| rounded(t, DIGITS));
            let mean = number(root_mean_square(times, &series.values));
            table.push([&*series.name, series.unit, &number(most), &most_at, &number(least), &least_at, &mean]);
            let [(most, most_at), (least, least_at)] = ends(times, &series.powers);
            let [most_at, least_at] = [most_at, least_at].map(|t| rounded(t, DIGITS));
            let work = number(self.work(series));
            powers.push([&*series.name, &number(most), &most_at, &number(least), &least_at, &work]);
        }
        text += &format!("{table}\n{powers}\n");
        if let Some(balance) = self.balance() {
            text += &format!(
                "work {} J = change of energy {} J + taken by other forces {} J; difference {:.1e} J\n",
                number(balance.work),
                number(balance.change),
                number(balance.taken),
                balance.difference(),
            );
            let turned_over: f64 = series.iter().map(|series| integral(times, &magnitudes(&series.powers))).sum();
            if balance.difference().abs() > NOTABLE * turned_over.max(balance.change.abs()) {
                text += "remark: works and energy differ: powers change much between samples, as beside a singular position; take a smaller --every\n";
            }
        }
        if is_of_drives {
            text += "signs of multipliers: docs/notation.md; --by INPUT finds an input in place of a drive\n";
        }
        text
    }

    /// `stopped`: why there is no more.
    pub(super) fn json(&self, stopped: Option<&str>) -> Value {
        let Values { times, series, .. } = self.values;
        let of = |values: &[f64]| {
            let [(most, most_at), (least, least_at)] = ends(times, values);
            json!({ "largest": most, "largest_at": most_at, "smallest": least, "smallest_at": least_at })
        };
        let values = series.iter().map(|series| {
            let mut value = of(&series.values);
            value["name"] = json!(series.name);
            value["unit"] = json!(series.unit);
            value["root_mean_square"] = json!(root_mean_square(times, &series.values));
            value["power"] = of(&series.powers);
            value["work"] = json!(self.work(series));
            value
        });
        let balance = self.balance().map(|balance| {
            let Balance { work, change, taken } = balance;
            json!({ "work": work, "change_of_energy": change, "taken_by_others": taken, "difference": balance.difference() })
        });
        json!({
            "model": self.info.model,
            "scene": self.info.name,
            "from": times.first(),
            "to": times.last(),
            "values": values.collect::<Vec<_>>(),
            "balance": balance,
            "stopped": stopped,
        })
    }

    /// Samples that are rows of the file: the end is one.
    fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        let n = self.values.times.len();
        (0..n).filter(move |i| i % self.n_between == 0 || i + 1 == n)
    }

    /// Time and values.
    pub(super) fn csv(&self) -> Result<Vec<u8>, Failure> {
        let Values { times, series, .. } = self.values;
        let mut rows = csv::Writer::from_writer(Vec::new());
        let heading = |series: &Series| match series.unit {
            "" => series.name.clone(),
            unit => format!("{} [{unit}]", series.name),
        };
        let head = std::iter::once("t [s]".to_owned()).chain(series.iter().map(heading));
        rows.write_record(head).map_err(Failure::stopped)?;
        for i in self.rows() {
            let numbers = std::iter::once(times[i]).chain(series.iter().map(|series| series.values[i]));
            rows.write_record(numbers.map(legible)).map_err(Failure::stopped)?;
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    #[cfg(not(feature = "figures"))]
    #[allow(clippy::unused_self, reason = "drawn, if at all")]
    pub(super) fn draw(&self, _: &Path) -> Result<(), Failure> {
        super::drawing::check()
    }

    /// A panel for the values of each unit, and one for the powers.
    #[cfg(feature = "figures")]
    pub(super) fn draw(&self, path: &Path) -> Result<(), Failure> {
        use super::drawing_of_columns::{axis, quantity, write};
        use ezy_study::report::figure::Figure;

        let Values { times, series, .. } = self.values;
        let title = format!("{}: what its motion takes", self.path);
        let mut units: Vec<&str> = Vec::new();
        series.iter().for_each(|of| {
            if !units.contains(&of.unit) {
                units.push(of.unit)
            }
        });
        let mut figure: Option<Figure> = None;
        for unit in units {
            let here: Vec<&Series> = series.iter().filter(|series| series.unit == unit).collect();
            let label = match here[..] {
                [one] => axis(&one.name, unit),
                _ => axis(quantity(unit), unit),
            };
            let mut panel = match figure {
                Some(figure) => figure.panel(&label),
                None => Figure::time_series(&title, "time [s]", &label),
            };
            for series in here {
                panel = panel.line(&series.name, times.clone(), series.values.clone());
            }
            figure = Some(panel);
        }
        let Some(figure) = figure else { return Ok(()) };
        let mut figure = figure.panel(&axis("power", "W"));
        for series in series {
            figure = figure.line(&series.name, times.clone(), series.powers.clone());
        }
        let names: Vec<&str> = series.iter().map(|series| &*series.name).collect();
        write(&figure, &title, &format!("{} and powers over time", names.join(", ")), path)
    }
}
