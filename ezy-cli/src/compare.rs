//! The command `compare`.

use std::path::Path;

use serde_json::json;

use super::Models;
use super::arguments::CompareArguments;
use super::drawing;
use super::failure::{Failure, print};
use super::json::print_json;
use super::motion_table::MotionTable;
use super::runs::Runs;
use ezy_core::record::Column;
use ezy_study::report::table::{Table, fixed};

/// The difference of one column of two motions.
struct Difference<'a> {
    column: &'a Column,
    /// By time of the first motion, as far as the second goes.
    #[cfg_attr(not(feature = "figures"), allow(dead_code, reason = "drawn, if at all"))]
    values: Vec<f64>,
    /// The largest, and when.
    largest: f64,
    t: f64,
    at_end: f64,
    /// Largest magnitude of the column in both motions.
    size: f64,
}

pub(super) fn compare(models: Models<'_>, arguments: &CompareArguments) -> Result<(), Failure> {
    if let Some(out) = &arguments.out {
        drawing::check()?;
        drawing::check_name(out)?;
    }
    let is_motion = |word: &&String| is_file(word) || word.contains('/');
    let (sides, patterns): (Vec<&String>, Vec<&String>) = arguments.what.iter().partition(is_motion);
    let runs = Runs { variations: &arguments.vary, every: arguments.every, n_scenes: sides.len() };
    let mut motions = Vec::new();
    for side in &sides {
        if is_file(side) {
            motions.push(MotionTable::of_file(Path::new(side))?);
        } else if let Some(stopped) = runs.motions(models, side, &arguments.motion, &mut motions)? {
            return Err(stopped);
        }
    }
    let [first, second] = &motions[..] else {
        return Err(Failure::wrong_use(format!(
            "two motions are compared, and there are {}; give two files of `run --out`, two scenes, or one scene with two values, such \
             as --vary method=rk4,dop853",
            motions.len()
        )));
    };
    // names of two runs of one scene say only how they differ
    let subject = if let [scene] = sides[..] { format!("{scene}: ") } else { String::new() };
    let differences = differences(first, second, &patterns)?;
    match arguments.json {
        true => print_json(&as_json(first, second, &differences))?,
        false => print(&format!("{subject}{}", as_text(first, second, &differences)))?,
    }
    arguments.out.as_deref().map_or(Ok(()), |out| {
        draw(
            &format!("{subject}{} and {}", first.name, second.name),
            [first, second],
            &differences,
            !patterns.is_empty(),
            out,
        )
    })
}

/// Whether a word is a file and no scene.
fn is_file(word: &str) -> bool {
    Path::new(word).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// Differences of the columns that both motions have, over the times that both have.
fn differences<'a>(
    first: &'a MotionTable,
    second: &MotionTable,
    patterns: &[&String],
) -> Result<Vec<Difference<'a>>, Failure> {
    let all = "*".to_owned();
    let patterns = if patterns.is_empty() { &[&all][..] } else { patterns };
    let mut columns: Vec<usize> = Vec::new();
    for pattern in patterns {
        columns.extend(first.select(pattern)?);
    }
    let mut seen = std::collections::HashSet::new();
    columns.retain(|i| seen.insert(*i));
    if !first.times().iter().any(|t| second.at(0, *t).is_some()) {
        return Err(Failure::wrong_use(format!("{} and {} have no time in common", first.name, second.name)));
    }
    let mut found = Vec::new();
    for i in columns {
        let column = &first.columns[i];
        let Some(k) = second.columns.iter().position(|other| other.name == column.name) else { continue };
        if second.columns[k].unit != column.unit {
            let (one, other) = (&column.unit, &second.columns[k].unit);
            return Err(Failure::wrong_use(format!("column `{}` is in {one} here and in {other} there", column.name)));
        }
        let both = |t: f64, a: f64| Some([t, a, second.at(k, t)?]);
        let pairs = first.times().iter().zip(&first.values[i]).filter_map(|(t, a)| both(*t, *a));
        let pairs: Vec<[f64; 3]> = pairs.collect();
        let difference = |[_, a, b]: &[f64; 3]| b - a;
        // of equal ones the first; what is no number is the largest of all
        let order = |one: &&[f64; 3], other: &&[f64; 3]| difference(one).abs().total_cmp(&difference(other).abs());
        let (Some(most), Some(last)) = (pairs.iter().rev().max_by(order), pairs.last()) else { continue };
        found.push(Difference {
            column,
            largest: difference(most).abs(),
            t: most[0],
            at_end: difference(last),
            size: pairs.iter().fold(0.0, |size, [_, a, b]| a.abs().max(b.abs()).max(size)),
            values: pairs.iter().map(difference).collect(),
        });
    }
    match found.is_empty() {
        true => {
            Err(Failure::wrong_use(format!("{} and {} have none of these columns in common", first.name, second.name)))
        }
        false => Ok(found),
    }
}

fn as_json(first: &MotionTable, second: &MotionTable, differences: &[Difference<'_>]) -> serde_json::Value {
    let columns = differences.iter().map(|of| {
        json!({
            "name": of.column.name, "unit": of.column.unit, "largest": of.largest, "t": of.t, "at_end": of.at_end,
            "size": of.size,
        })
    });
    json!({ "first": first.name, "second": second.name, "columns": columns.collect::<Vec<_>>() })
}

fn as_text(first: &MotionTable, second: &MotionTable, differences: &[Difference<'_>]) -> String {
    let mut table = Table::new(["column", "largest difference", "t [s]", "at the end", "largest value", "unit"]);
    for of in differences {
        let numbers = [of.at_end, of.size].map(|x| format!("{x:.2e}"));
        table.push([
            &of.column.name,
            &format!("{:.2e}", of.largest),
            &fixed(of.t, 6),
            &numbers[0],
            &numbers[1],
            &of.column.unit,
        ]);
    }
    let text = format!("{} less {}\n\n{table}", second.name, first.name);
    let lacking = |here: &MotionTable, there: &MotionTable| -> Vec<String> {
        let known = |name: &str| there.columns.iter().any(|column| column.name == name);
        here.columns.iter().filter(|column| !known(&column.name)).map(|column| column.name.clone()).collect()
    };
    let alone: Vec<String> = [(first, second), (second, first)].into_iter().flat_map(|(a, b)| lacking(a, b)).collect();
    let alone = if alone.is_empty() { String::new() } else { format!("in one of them alone: {}\n", alone.join(", ")) };
    let same = first.times() == second.times();
    let interpolated = if same { "" } else { "times differ: the second motion is interpolated by straight lines\n" };
    format!("{text}{alone}{interpolated}")
}

/// Both motions and their difference: columns that were asked for, or the one with the largest relative difference.
#[cfg(feature = "figures")]
fn draw(
    title: &str,
    [first, second]: [&MotionTable; 2],
    differences: &[Difference<'_>],
    are_chosen: bool,
    out: &Path,
) -> Result<(), Failure> {
    use super::drawing_of_columns::{axis, write};
    use ezy_study::report::figure::Figure;

    let relative = |of: &Difference<'_>| if of.size > 0.0 { of.largest / of.size } else { 0.0 };
    let most = differences.iter().max_by(|a, b| relative(a).total_cmp(&relative(b)));
    let shown = differences.iter().filter(|of| are_chosen || most.is_some_and(|most| std::ptr::eq(most, *of)));
    let mut figure: Option<Figure> = None;
    for of in shown {
        let Column { name, unit } = of.column;
        let label = axis(name, unit);
        let figure_here = match figure {
            Some(figure) => figure.panel(&label),
            None => Figure::time_series(title, "time [s]", &label),
        };
        let of_second = second.values[second.index(name)?].clone();
        let times = first.times().iter().copied().filter(|t| second.at(0, *t).is_some()).collect();
        let both = figure_here
            .line(&first.name, first.times().to_vec(), first.values[first.index(name)?].clone())
            .line(&second.name, second.times().to_vec(), of_second);
        figure = Some(both.panel(&axis("difference", unit)).line("", times, of.values.clone()));
    }
    let Some(figure) = figure else { return Ok(()) };
    write(&figure, title, &format!("{title}, and their difference"), out)?;
    print(&format!("{}\n", out.display()))
}

#[cfg(not(feature = "figures"))]
fn draw(_: &str, _: [&MotionTable; 2], _: &[Difference<'_>], _: bool, _: &Path) -> Result<(), Failure> {
    drawing::check()
}
