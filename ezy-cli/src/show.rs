//! The command `show`: what is known of a scene before it runs, in three formats.

mod json;
mod latex;
mod text;

use serde_json::{Value, json};
use std::sync::Arc;

use ezy_core::model::{EliminationStep, SceneInfo, SeriesInfo, TemplateInfo};

use super::Models;
use super::arguments::{Format, ShowArguments};
use super::failure::{Failure, print};
use super::json::print_json;
use super::names::scene_with;
use super::selection::find;
use super::value::Assignment;

pub(super) fn show(models: Models<'_>, arguments: &ShowArguments) -> Result<(), Failure> {
    let selection = find(models, &arguments.path)?;
    let all = selection.model.scenes.iter();
    let chosen = all.filter(|entry| selection.scene.is_none_or(|scene| scene.name == entry.name));
    let info = |entry| {
        let info = scene_with(selection.model, entry, &arguments.set)?.info();
        let is_count = |name: &str| info.counts().iter().any(|count| count.name == name);
        match arguments.set.iter().find(|set| !is_count(&set.name)) {
            Some(Assignment { name, .. }) => Err(Failure::wrong_use(format!(
                "`{name}` is a parameter, and equations are shown for all of its values; --set takes counts here"
            ))),
            None => Ok(info),
        }
    };
    let infos: Vec<Arc<SceneInfo>> = chosen.map(info).collect::<Result<_, _>>()?;
    let text =
        |write: fn(&SceneInfo) -> String| print(&infos.iter().map(|info| write(info) + "\n").collect::<String>());
    match (arguments.format, &infos[..]) {
        (Format::Text, _) => text(text::scene),
        (Format::Latex, _) => text(latex::scene),
        (Format::Json, [info]) if selection.scene.is_some() => print_json(&json::scene(info)),
        (Format::Json, _) => {
            let scenes: Value = infos.iter().map(|info| json::scene(info)).collect();
            print_json(&json!({ "model": selection.model.name, "scenes": scenes }))
        }
    }
}

/// The equations of a scene as a document by itself.
#[cfg(feature = "export")]
pub(super) fn latex_document(info: &SceneInfo) -> String {
    let content = latex::scene(info);
    format!("\\documentclass{{article}}\n\\usepackage{{amsmath}}\n\\begin{{document}}\n{content}\\end{{document}}\n")
}

/// Independent positions and velocities at the start: all less rows that hold, which are independent in a sound scene.
fn freedom(info: &SceneInfo) -> [usize; 2] {
    info.n_rows_at_start().map(|rows| info.n_velocities().saturating_sub(rows))
}

const OPERATIONS: [&str; 6] = ["mul", "add", "div", "arithmetic in all", "sin and cos", "other calls"];

/// The generated solutions with their counts, in the order of [`OPERATIONS`].
fn kernels(info: &SceneInfo) -> Vec<(&'static str, [usize; 6])> {
    let quasi = info.quasi_velocities.map(|of| ("accelerations in quasi-velocities", of.operations));
    let of_rows = [("accelerations", info.acceleration_operations), ("correction", info.correction_operations)];
    of_rows
        .into_iter()
        .chain(quasi)
        .map(|(name, count)| (name, [count.mul, count.add, count.div, count.arithmetic(), count.trig, count.calls]))
        .collect()
}

/// Whether Taylor's method can run the scene, and the cost of one order.
fn series(info: &SceneInfo) -> String {
    match info.series {
        SeriesInfo::Analytic { n_products, operations } => {
            let of = if info.repeats.is_none() { "" } else { " of one member of each row and force" };
            let n_operations = operations.arithmetic();
            format!(
                "Taylor series: {n_products} products of series and {n_operations} operations besides at each order{of}"
            )
        }
        SeriesInfo::NotAnalytic { function } => {
            format!("no Taylor series: a law calls `{function}`; dop853, rk4 and midpoint take the scene")
        }
        _ => "no Taylor series".to_owned(),
    }
}

/// The items of a scene with counts that have equations.
fn with_equations(info: &SceneInfo) -> impl Iterator<Item = &'static TemplateInfo> {
    let items = info.repeats.as_ref().map_or::<&[TemplateInfo], _>(&[], |repeats| repeats.templates);
    items.iter().filter(|item| !item.equations.is_empty())
}

/// For each row and body which of x, y and φ the row reads: `x.x`.
fn pattern(info: &SceneInfo) -> Vec<Vec<String>> {
    let mut signs = vec![vec!['.'; info.n_velocities()]; info.n_rows()];
    info.jacobian.entries().for_each(|(_, row, column)| signs[row][column] = 'x');
    let by_body = |row: Vec<char>| info.velocities_of_bodies().map(|of_body| row[of_body].iter().collect()).collect();
    signs.into_iter().map(by_body).collect()
}

fn pivot(step: &EliminationStep) -> &'static str {
    if step.constant_pivot { "pivot from parameters alone, computed once" } else { "pivot from the state" }
}
