//! A workspace as text, JSON and CSV.

use serde_json::{Value, json};

use super::failure::Failure;
#[cfg(feature = "figures")]
use super::shown::Drawing;
use super::shown::Shown;
use ezy_core::analysis::{AssemblyBranch, Axis, Limit, Singularity, Workspace};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::{legible, rounded};
use ezy_study::report::table::{Table, fixed};

/// Digits of values at which a mechanism is singular: as many as are found.
const DIGITS: usize = 11;
/// Decimals of other coordinates.
const DECIMALS: usize = 6;
/// Digits of singular values.
const SHORT: usize = 4;
/// Coordinates beside a singular position; --json has all.
const MOST_COORDINATES: usize = 5;

pub(super) struct Reached<'a> {
    pub path: String,
    pub info: &'a SceneInfo,
    pub workspace: &'a Workspace,
    /// Places of the coordinates that are held.
    pub held: Vec<usize>,
    /// Place of the coordinate that the figure shows.
    pub of: usize,
}

fn limit(limit: Limit) -> &'static str {
    match limit {
        Limit::Range => "end of the values",
        Limit::DeadCentre => "dead centre",
        Limit::Lost => "no solution beyond",
        Limit::TooLong => "goes on",
    }
}

fn word(kind: Singularity) -> &'static str {
    match kind {
        Singularity::DeadCentre => "dead centre",
        Singularity::ChangePoint => "change point",
    }
}

impl<'a> Reached<'a> {
    pub(super) fn new(path: String, info: &'a SceneInfo, workspace: &'a Workspace, of: Option<usize>) -> Self {
        let place = |axis: &Axis| info.coordinates.iter().position(|c| *c.name == *axis.name);
        let held: Vec<usize> = workspace.axes.iter().filter_map(place).collect();
        let mut shown = Self { path, info, workspace, held, of: 0 };
        shown.of = of.or_else(|| shown.others().first().copied()).unwrap_or_default();
        shown
    }

    /// Coordinates that are not held and change: angles first, those that change most before others.
    fn others(&self) -> Vec<usize> {
        let spread = |i: usize| {
            let positions = self.workspace.branches.iter().flat_map(|branch| &branch.positions);
            let values = || positions.clone().flatten().map(|q| q[i]);
            values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
        };
        let is_seen = |spread: f64| spread > 0.5 * 0.1_f64.powi(DECIMALS as i32);
        let free = (0..self.info.n_coordinates()).filter(|i| !self.held.contains(i)).map(|i| (i, spread(i)));
        let mut free: Vec<(i8, usize, f64)> = free
            .filter(|(_, spread)| is_seen(*spread))
            .map(|(i, spread)| (i8::from(!self.info.coordinates[i].is_angle()), i, spread))
            .collect();
        free.sort_by(|a, b| a.0.cmp(&b.0).then(b.2.total_cmp(&a.2)).then(a.1.cmp(&b.1)));
        free.into_iter().map(|(_, i, _)| i).collect()
    }

    pub(super) fn head(&self, i: usize) -> String {
        let coordinate = &self.info.coordinates[i];
        format!("{} [{}]", coordinate.name, coordinate.unit)
    }

    /// The values of the axes at a place.
    pub(super) fn place(&self, i: usize) -> Vec<f64> {
        match &self.workspace.axes[..] {
            [x, y] => vec![x.values[i / y.values.len()], y.values[i % y.values.len()]],
            axes => axes.iter().map(|axis| axis.values[i]).collect(),
        }
    }

    fn text_over_one(&self) -> String {
        let Self { path, workspace, held, .. } = self;
        let (name, n) = (&workspace.axes[0].name, workspace.branches.len());
        let ways = if n == 1 { "way of assembly" } else { "ways of assembly" };
        let mut table = Table::new(["branch", &format!("from {}", self.head(held[0])), "", "to", "", "best at"]);
        for (i, branch) in workspace.branches.iter().enumerate() {
            let Some([first, last]) = &branch.ends else { continue };
            let best = self.extreme(branch, &branch.smallest_singular_value, f64::max);
            let best = best.map_or_else(String::new, |(i, _)| rounded(self.place(i)[0], DIGITS));
            let [from, to] = [first, last].map(|end| rounded(end.value, DIGITS));
            table.push([(i + 1).to_string(), from, limit(first.limit).into(), to, limit(last.limit).into(), best]);
        }
        let mut text = format!("{path}: {n} {ways} over {name}\n\n{table}");
        if workspace.singular.is_empty() {
            return text + "\nno singular position\n";
        }
        let mut shown = self.others();
        shown.truncate(MOST_COORDINATES);
        let head = [format!("singular at {}", self.head(held[0])), "what".to_owned()];
        let mut table = Table::new(head.into_iter().chain(shown.iter().map(|i| self.head(*i))));
        for singular in &workspace.singular {
            let first = [rounded(singular.value, DIGITS), word(singular.kind).to_owned()];
            table.push(first.into_iter().chain(shown.iter().map(|i| fixed(singular.q[*i], DECIMALS))));
        }
        text += &format!("\n{table}");
        text
    }

    fn text_over_two(&self) -> String {
        let Self { path, workspace, .. } = self;
        let [x, y] = [&workspace.axes[0], &workspace.axes[1]];
        let Some(branch) = workspace.branches.first() else { return String::new() };
        let n = branch.positions.len();
        let reached: Vec<usize> = (0..n).filter(|i| branch.positions[*i].is_some()).collect();
        let share = 100.0 * reached.len() as f64 / n.max(1) as f64;
        let (first, second) = (&x.name, &y.name);
        let mut text =
            format!("{path}: {} of {n} places of {first} and {second} are reached ({share:.1} %)\n", reached.len());
        if reached.is_empty() {
            return text + "give values around those of the start, or another start by --start\n";
        }
        let mut table = Table::new(["coordinate", "unit", "least reached", "greatest reached"]);
        for (k, axis) in workspace.axes.iter().enumerate() {
            let of = |fold: fn(f64, f64) -> f64| reached.iter().map(|i| self.place(*i)[k]).reduce(fold);
            let [least, most] = [of(f64::min), of(f64::max)].map(|x| rounded(x.unwrap_or(f64::NAN), DIGITS));
            table.push([&*axis.name, self.info.coordinates[self.held[k]].unit, &least, &most]);
        }
        text += &format!("\n{table}");
        let at = |k: usize| self.head(self.held[k]);
        let mut table = Table::new(["", "value", &format!("at {}", at(0)), &format!("and {}", at(1))]);
        let values = &branch.smallest_singular_value;
        let rows = [
            ("smallest singular value, least", self.extreme(branch, values, f64::min)),
            ("smallest singular value, greatest", self.extreme(branch, values, f64::max)),
            ("transmission, least", self.extreme(branch, &branch.transmission, f64::min)),
            ("transmission, greatest", self.extreme(branch, &branch.transmission, f64::max)),
        ];
        for (what, found) in rows {
            let Some((i, value)) = found else { continue };
            let place = self.place(i).into_iter().map(|x| rounded(x, DIGITS));
            table.push([what.to_owned(), rounded(value, SHORT)].into_iter().chain(place));
        }
        text + &format!("\n{table}")
    }

    /// Where values are extreme.
    fn extreme(&self, branch: &AssemblyBranch, of: &[f64], better: fn(f64, f64) -> f64) -> Option<(usize, f64)> {
        let reached = of.iter().copied().enumerate().filter(|(i, _)| branch.positions[*i].is_some());
        reached.reduce(|a, b| if better(a.1, b.1) == a.1 { a } else { b })
    }

    fn named(&self, q: &[f64]) -> Value {
        self.info.coordinates.iter().zip(q).map(|(c, q)| (c.name.to_string(), json!(q))).collect()
    }
}

impl Shown for Reached<'_> {
    fn text(&self) -> String {
        if self.held.len() == 1 { self.text_over_one() } else { self.text_over_two() }
    }

    fn json(&self) -> Value {
        let Self { path, workspace, .. } = self;
        let branch = |branch: &AssemblyBranch| {
            let ends = branch.ends.as_ref().map(|ends| {
                let end = |end: &ezy_core::analysis::ReachEnd| {
                    json!({ "value": end.value, "limit": limit(end.limit), "state": self.named(&end.q) })
                };
                ends.iter().map(end).collect::<Vec<_>>()
            });
            let positions = branch.positions.iter().map(|q| q.as_ref().map(|q| self.named(q))).collect::<Vec<_>>();
            json!({
                "ends": ends,
                "smallest_singular_value": branch.smallest_singular_value,
                "transmission": branch.transmission,
                "positions": positions,
            })
        };
        let axes = workspace.axes.iter().zip(&self.held).map(|(axis, held)| {
            json!({ "name": axis.name, "unit": self.info.coordinates[*held].unit, "values": axis.values })
        });
        let singular = workspace.singular.iter().map(|singular| {
            json!({ "value": singular.value, "kind": word(singular.kind), "state": self.named(&singular.q) })
        });
        json!({
            "scene": path,
            "axes": axes.collect::<Vec<_>>(),
            "branches": workspace.branches.iter().map(branch).collect::<Vec<_>>(),
            "singular": singular.collect::<Vec<_>>(),
        })
    }

    /// A row for each place of each branch; cells of places that are not reached are empty.
    fn csv(&self) -> Result<Vec<u8>, Failure> {
        let mut rows = csv::Writer::from_writer(Vec::new());
        let others: Vec<usize> = (0..self.info.n_coordinates()).filter(|i| !self.held.contains(i)).collect();
        let head = ["branch".to_owned()].into_iter().chain(self.held.iter().map(|i| self.head(*i)));
        let condition = ["reachable", "smallest singular value", "transmission"].map(str::to_owned);
        let head = head.chain(condition).chain(others.iter().map(|i| self.head(*i)));
        rows.write_record(head).map_err(Failure::stopped)?;
        for (number, branch) in self.workspace.branches.iter().enumerate() {
            for (i, q) in branch.positions.iter().enumerate() {
                let cell = |x: f64| if x.is_nan() { String::new() } else { legible(x) };
                let condition = [branch.smallest_singular_value[i], branch.transmission[i]].map(cell);
                let reachable = String::from(if q.is_some() { "1" } else { "0" });
                let place = self.place(i).into_iter().map(legible);
                let row = [(number + 1).to_string()].into_iter().chain(place).chain([reachable]).chain(condition);
                let others = others.iter().map(|i| q.as_ref().map_or_else(String::new, |q| legible(q[*i])));
                rows.write_record(row.chain(others)).map_err(Failure::stopped)?;
            }
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing {
        self.drawn()
    }
}
