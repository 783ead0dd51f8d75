//! `equilibrium --vary`: a bifurcation diagram as text, JSON, CSV and figure.

use serde_json::{Value, json};

use super::equilibrium_text::with_spectrum;
use super::failure::Failure;
use super::root_locus::unit;
#[cfg(feature = "figures")]
use super::shown::Drawing;
use super::shown::{Forms, Shown};
use super::steady::Request;
use super::steady_arguments::EquilibriumArguments;
#[cfg(feature = "figures")]
use super::steady_text::verdict;
use super::value::parse_number;
use super::vary::{Target, Variation, target};
use ezy_core::analysis::{Bifurcation, BifurcationDiagram, Branch, BranchEnd, BranchPoint};
use ezy_core::model::SceneInfo;
use ezy_core::record::{Column, find_name};
use ezy_core::scalar::{legible, rounded};
use ezy_study::report::table::{Table, fixed};

/// Digits of values at which something happens: as many as are found.
const DIGITS: usize = 11;
/// Decimals of coordinates, and what is seen of them.
const DECIMALS: usize = 6;
const SEEN: f64 = 1e-6;

/// Follows the branches, writes their files and prints what happens on them.
pub(super) fn print_diagram(
    request: &Request,
    arguments: &EquilibriumArguments,
    variation: &Variation,
) -> Result<(), Failure> {
    let EquilibriumArguments { of, out, plot, json, .. } = arguments;
    let info = request.info();
    let name = &variation.name;
    let wrong = |why: String| Failure::wrong_use(format!("--vary {name}: {why}"));
    match target(name, &info)? {
        Target::Count(_) => {
            return Err(wrong("a count has no values between whole numbers; vary it by `linearize --vary`".to_owned()));
        }
        Target::Setting => {
            return Err(wrong(format!("a steady motion has no {name}; vary a parameter, an input or a start value")));
        }
        Target::Parameter(_) | Target::Input | Target::Start => {}
    }
    let columns = columns(&info);
    let of = of.as_ref().map(|of| find_name("column", of, columns.iter().map(|column| &*column.name))).transpose()?;
    let forms = Forms::new("bifurcation diagrams", out.as_deref(), plot.as_deref(), *json)?;
    let values = variation.values.iter().map(|value| parse_number(value)).collect::<Result<Vec<f64>, _>>();
    let values = values.map_err(&wrong)?;
    let [least, most] = [f64::min, f64::max].map(|of| values.iter().copied().reduce(of).unwrap_or_default());
    if least == most {
        return Err(wrong("one value is no range; write NAME=START:END:STEP, such as k=2:20:0.5".to_owned()));
    }
    let step = (most - least) / (values.len() - 1) as f64;
    let diagram = request.diagram(name, [least, most], step)?;
    let drawn = Drawn {
        path: request.path(),
        unit: unit(name, &info),
        of: of.unwrap_or_else(|| widest(&diagram, &columns)),
        columns: &columns,
        info: &info,
        diagram: &diagram,
    };
    forms.show(&drawn)
}

/// Coordinates, velocities and first-order states.
fn columns(info: &SceneInfo) -> Vec<Column> {
    let states = info.states.iter().map(|state| (state.name, state.unit));
    let all = info.coordinates.iter().chain(&*info.velocities).map(|of| (&*of.name, of.unit)).chain(states);
    all.map(|(name, unit)| Column { name: name.to_owned(), unit: unit.to_owned() }).collect()
}

fn values(point: &BranchPoint) -> impl Iterator<Item = f64> {
    let state = &point.motion.state;
    state.q.iter().chain(&state.v).chain(&state.z).copied()
}

/// The angle that changes most, where none does the turn rate, or else the column.
fn widest(diagram: &BifurcationDiagram, columns: &[Column]) -> usize {
    let mut ends = vec![[f64::INFINITY, f64::NEG_INFINITY]; columns.len()];
    for point in diagram.branches.iter().flat_map(|branch| &branch.points) {
        ends.iter_mut().zip(values(point)).for_each(|([least, most], x)| {
            (*least, *most) = (least.min(x), most.max(x));
        });
    }
    let spread = |i: &usize| ends[*i][1] - ends[*i][0];
    let largest = |unit: &str| {
        let all = (0..columns.len()).filter(|i| unit.is_empty() || columns[*i].unit == unit);
        all.max_by(|a, b| spread(a).total_cmp(&spread(b)).then(b.cmp(a))).filter(|i| spread(i) > SEEN)
    };
    largest("rad").or_else(|| largest("rad/s")).or_else(|| largest("")).unwrap_or_default()
}

struct Drawn<'a> {
    path: String,
    unit: &'a str,
    columns: &'a [Column],
    /// Place of the one that is shown.
    of: usize,
    info: &'a SceneInfo,
    diagram: &'a BifurcationDiagram,
}

/// What happens at a point, in a word.
fn word(bifurcation: Bifurcation) -> &'static str {
    match bifurcation {
        Bifurcation::Fold => "fold",
        Bifurcation::BranchPoint => "branch point",
        Bifurcation::Oscillation { .. } => "oscillation",
        Bifurcation::Divergence => "divergence",
    }
}

fn end_word(end: BranchEnd) -> &'static str {
    match end {
        BranchEnd::Range => "end of the values",
        BranchEnd::Closed => "closes",
        BranchEnd::BranchPoint => "branch point",
        BranchEnd::Lost => "no solution beyond",
        BranchEnd::Switch => "a stop or a skate changes",
        BranchEnd::TooLong => "goes on",
    }
}

impl Drawn<'_> {
    fn heading(&self) -> String {
        let name = &self.diagram.name;
        if self.unit.is_empty() { name.clone() } else { format!("{name} [{}]", self.unit) }
    }

    fn shown(&self, point: &BranchPoint) -> f64 {
        values(point).nth(self.of).unwrap_or(f64::NAN)
    }
}

impl Shown for Drawn<'_> {
    fn text(&self) -> String {
        let Self { path, columns, of, diagram, .. } = self;
        let column = &columns[*of];
        let n = diagram.branches.len();
        let mut text =
            format!("{path}: {n} {} over {}\n", if n == 1 { "branch" } else { "branches" }, self.diagram.name);
        for (i, branch) in diagram.branches.iter().enumerate() {
            let of = format!("{} [{}]", column.name, column.unit);
            let mut table = Table::new([&*self.heading(), &of, "what", "unstable before", "after"]);
            let last = branch.points.len().saturating_sub(1);
            for (j, point) in branch.points.iter().enumerate() {
                let what = match (point.bifurcation, j) {
                    (Some(Bifurcation::Oscillation { omega }), _) => {
                        format!("oscillation of {} rad/s", rounded(omega, DIGITS))
                    }
                    (Some(bifurcation), _) => word(bifurcation).to_owned(),
                    (None, 0) => end_word(branch.ends[0]).to_owned(),
                    (None, j) if j == last => end_word(branch.ends[1]).to_owned(),
                    (None, _) => continue,
                };
                let count = |j: Option<usize>| {
                    let point = j.and_then(|j| branch.points.get(j));
                    point.map_or_else(String::new, |point| point.spectrum.n_unstable().to_string())
                };
                let value = rounded(point.value, DIGITS);
                let q = fixed(self.shown(point), DECIMALS);
                table.push([value, q, what, count(j.checked_sub(1)), count(Some(j + 1))]);
            }
            text += &format!("\nbranch {}, {} points\n{table}", i + 1, branch.points.len());
        }
        if !diagram.is_complete {
            text += "\nthere are more branches than were followed; take a narrower range\n";
        }
        if diagram.branches.iter().any(|branch| branch.ends.contains(&BranchEnd::TooLong)) {
            text += "\na branch goes on beyond its last point; take a narrower range or a longer step\n";
        }
        text
    }

    fn json(&self) -> Value {
        let Self { path, info, diagram, .. } = self;
        let point = |point: &BranchPoint| {
            let mut value = with_spectrum(info, &point.motion, &point.spectrum);
            value["value"] = point.value.into();
            value["bifurcation"] = point.bifurcation.map(word).into();
            if let Some(Bifurcation::Oscillation { omega }) = point.bifurcation {
                value["omega"] = omega.into();
            }
            value
        };
        let branch = |branch: &Branch| {
            json!({
                "ends": branch.ends.map(end_word),
                "points": branch.points.iter().map(point).collect::<Vec<_>>(),
            })
        };
        json!({
            "scene": path,
            "name": diagram.name,
            "unit": self.unit,
            "complete": diagram.is_complete,
            "branches": diagram.branches.iter().map(branch).collect::<Vec<_>>(),
        })
    }

    /// A row for each point.
    fn csv(&self) -> Result<Vec<u8>, Failure> {
        let mut rows = csv::Writer::from_writer(Vec::new());
        let columns = self.columns.iter().map(|column| format!("{} [{}]", column.name, column.unit));
        let head = ["branch".to_owned(), self.heading(), "bifurcation".to_owned(), "unstable".to_owned()];
        rows.write_record(head.into_iter().chain(columns)).map_err(Failure::stopped)?;
        for (i, branch) in self.diagram.branches.iter().enumerate() {
            for point in &branch.points {
                let first = [
                    (i + 1).to_string(),
                    legible(point.value),
                    point.bifurcation.map_or("", word).to_owned(),
                    point.spectrum.n_unstable().to_string(),
                ];
                rows.write_record(first.into_iter().chain(values(point).map(legible))).map_err(Failure::stopped)?;
            }
        }
        rows.into_inner().map_err(Failure::stopped)
    }

    /// The coordinate over the value: a line for what is stable or neutral, dashes for what is not, rings where something happens.
    #[cfg(feature = "figures")]
    fn drawing(&self) -> Drawing {
        use super::drawing_of_columns::axis;
        use ezy_study::report::figure::Figure;

        let column = &self.columns[self.of];
        let title = format!("{}: bifurcation diagram", self.path);
        let figure = Figure::plane(&title, &axis(&self.diagram.name, self.unit), &axis(&column.name, &column.unit));
        let place = |point: &BranchPoint| (point.value, self.shown(point));
        // in one line each, with a gap where it is the other
        let lines = |unstable: bool| -> (Vec<f64>, Vec<f64>) {
            let mut line = Vec::new();
            for branch in &self.diagram.branches {
                for pair in branch.points.windows(2) {
                    let decided = pair.iter().find(|point| point.bifurcation.is_none()).unwrap_or(&pair[1]);
                    if (verdict(&decided.motion, &decided.spectrum) == "unstable") == unstable {
                        line.extend([place(&pair[0]), place(&pair[1])]);
                    } else {
                        line.push((f64::NAN, f64::NAN));
                    }
                }
                line.push((f64::NAN, f64::NAN));
            }
            line.into_iter().unzip()
        };
        let (stable, unstable) = (lines(false), lines(true));
        let has = |line: &(Vec<f64>, Vec<f64>)| line.0.iter().any(|x| !x.is_nan());
        let mut figure = figure.line(if has(&stable) { "stable or neutral" } else { "" }, stable.0, stable.1);
        figure = figure.line(if has(&unstable) { "unstable" } else { "" }, unstable.0, unstable.1);
        let points = self.diagram.branches.iter().flat_map(|branch| &branch.points);
        let (x, y): (Vec<f64>, Vec<f64>) = points.filter(|point| point.bifurcation.is_some()).map(place).unzip();
        let name = if x.is_empty() { "" } else { "bifurcation" };
        let alternative = format!("{} over {}", column.name, self.diagram.name);
        Drawing { figure: figure.hinges(name, x, y), title, alternative }
    }
}
