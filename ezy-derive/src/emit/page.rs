//! A model and its scenes as a page of a textbook, for `cargo doc`: parameters, rows, equations, sparsity, costs.
//!
//! The page is an attribute that only rustdoc reads, so that an editor shows the short text alone. Equations are
//! MathML in one line, which passes through Markdown untouched and needs no script and no style sheet.

mod equations;
mod mathml;
mod tables;

use proc_macro2::TokenStream;
use quote::quote;

use super::info::Emitted;
use crate::mechanics::Equations;
use crate::model::{Model, Scene};

/// What the page of a model says of one of its scenes.
pub struct Summary {
    name: String,
    type_name: String,
    effects: Vec<String>,
    freedom: [usize; 2],
    operations: usize,
}

impl Summary {
    pub fn new(model: &Model, scene: &Scene, type_name: String, equations: &Equations, emitted: &Emitted<'_>) -> Self {
        let count = emitted.accelerations.program.count();
        Self {
            name: scene.name.to_string(),
            type_name,
            effects: scene.effects.iter().map(|effect| model.effects[effect.0].name.to_string()).collect(),
            freedom: freedom(equations),
            operations: count.add + count.mul + count.div,
        }
    }
}

/// The page of the module: scenes, then parameters.
pub fn model(model: &Model, scenes: &[Summary]) -> TokenStream {
    let rows = scenes.iter().map(|scene| {
        let [positions, velocities] = scene.freedom;
        let effects = scene.effects.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let name = format!("[`{}`]({})", scene.name, scene.type_name);
        vec![name, effects, positions.to_string(), velocities.to_string(), scene.operations.to_string()]
    });
    let mut page = vec![String::new(), "# Scenes".into(), String::new()];
    let heads = ["scene", "effects", "freedom of positions", "of velocities", "operations"];
    page.extend(tables::markdown(&heads, rows));
    page.extend([
        String::new(),
        "Operations: additions, multiplications and divisions of one evaluation of the accelerations.".into(),
    ]);
    let effects = model.effects.iter().filter(|effect| !effect.documentation.trim().is_empty());
    let effects: Vec<_> =
        effects.map(|effect| vec![format!("`{}`", effect.name), effect.documentation.clone()]).collect();
    if !effects.is_empty() {
        page.extend([String::new(), "# Effects".into(), String::new()]);
        page.extend(tables::markdown(&["effect", "what it is"], effects));
    }
    attribute(&page)
}

/// The page of a scene: parameters, rows, equations, sparsity, elimination, costs.
pub fn scene(model: &Model, equations: &Equations, emitted: &Emitted<'_>) -> TokenStream {
    let [positions, velocities] = freedom(equations);
    let mut page = vec![
        String::new(),
        format!("Freedom: {positions} of positions, {velocities} of velocities."),
        String::new(),
        "# Parameters".into(),
        String::new(),
    ];
    page.extend(tables::parameters(model, equations));
    page.extend([String::new(), "# Rows".into(), String::new()]);
    page.extend(tables::rows(equations));
    page.extend(equations::sections(equations));
    page.extend([String::new(), "# Sparsity of the Jacobian".into(), String::new()]);
    page.extend(tables::sparsity(model, equations));
    page.extend([String::new(), "# Order of elimination".into(), String::new()]);
    page.extend(tables::elimination(equations, &emitted.accelerations.order));
    page.extend([String::new(), "# Operations".into(), String::new()]);
    page.extend(tables::operations(emitted));
    attribute(&page)
}

/// Coordinates less position rows, velocities less all rows.
fn freedom(equations: &Equations) -> [usize; 2] {
    let n_q = equations.force.len();
    [equations.constraints.n_position_rows, equations.constraints.rows.len()].map(|n| n_q.saturating_sub(n))
}

fn attribute(lines: &[String]) -> TokenStream {
    let page = lines.join("\n");
    quote!(#[cfg_attr(doc, doc = #page)])
}
