//! A model and its scenes as a page of a textbook, for `cargo doc`: parameters, rows, equations, sparsity, costs.
//!
//! The page is an attribute that only rustdoc reads, so that an editor shows the short text alone. Equations are
//! MathML in one line, which passes through Markdown untouched and needs no script and no style sheet.

mod equations;
mod items;
mod mathml;
mod tables;

use proc_macro2::TokenStream;
use quote::quote;

use super::info::Emitted;
use crate::mechanics::{Equations, Templates};
use crate::model::{Model, Scene};

/// What the page of a model says of one of its scenes.
pub struct Summary {
    name: String,
    type_name: String,
    effects: Vec<String>,
    freedom: [usize; 2],
    /// `None` without an elimination.
    operations: Option<usize>,
}

impl Summary {
    pub fn new(model: &Model, scene: &Scene, type_name: String, equations: &Equations, emitted: &Emitted<'_>) -> Self {
        let count = emitted.accelerations.program.count();
        Self {
            name: scene.name.to_string(),
            type_name,
            effects: scene.effects.iter().map(|effect| model.effects[effect.0].name.to_string()).collect(),
            freedom: freedom(equations),
            operations: emitted.accelerations.is_written().then_some(count.add + count.mul + count.div),
        }
    }
}

/// The page of the module: scenes and effects.
pub fn model(model: &Model, scenes: &[Summary]) -> TokenStream {
    let rows = scenes.iter().map(|scene| {
        let [positions, velocities] = scene.freedom;
        let effects = scene.effects.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let name = format!("[`{}`]({})", scene.name, scene.type_name);
        let operations = scene.operations.map_or_else(|| "sparse solver".to_owned(), |n| n.to_string());
        vec![name, effects, positions.to_string(), velocities.to_string(), operations]
    });
    let heads = ["scene", "effects", "freedom of positions", "of velocities", "operations"];
    let mut page = Page::default();
    page.section("Scenes", tables::markdown(&heads, rows));
    page.paragraph(
        "Operations: additions, multiplications and divisions of one evaluation of the accelerations.".into(),
    );
    let effects = model.effects.iter().filter(|effect| !effect.documentation.trim().is_empty());
    let effects = effects.map(|effect| vec![format!("`{}`", effect.name), effect.documentation.clone()]);
    page.section("Effects", tables::markdown(&["effect", "what it is"], effects));
    page.attribute()
}

/// Said of a scene without elimination.
pub const SOLVED_SPARSE: &str = "Many rows meet in one body: the sparse backend solves the equations of motion.";

/// The page of a scene: parameters, rows, equations, sparsity, elimination, costs.
pub fn scene(model: &Model, equations: &Equations, emitted: &Emitted<'_>) -> TokenStream {
    let [positions, velocities] = freedom(equations);
    let mut page = Page::default();
    page.paragraph(format!("Freedom: {positions} of positions, {velocities} of velocities."));
    page.section("Parameters", tables::parameters(model, &equations.parameters, &equations.symbols));
    page.section("Inputs", tables::inputs(model, &equations.inputs, &equations.symbols));
    page.section("Rows", tables::rows(equations));
    equations::write(&mut page, equations, emitted.names);
    page.section("Outputs", tables::outputs(model, equations, emitted.names));
    page.section("Sparsity of the Jacobian", tables::sparsity(model, equations));
    if emitted.accelerations.is_written() {
        page.section("Order of elimination", tables::elimination(equations, &emitted.accelerations.order));
        page.section("Operations", tables::operations(emitted));
    } else {
        page.paragraph(SOLVED_SPARSE.into());
    }
    page.attribute()
}

/// The page of a scene with counts: equations of each item, for all of its members.
pub fn repeated(model: &Model, templates: &Templates<'_>) -> TokenStream {
    let mut page = Page::default();
    let solved = "Its sizes are numbers of a run: it is solved by the sparse backend, at a cost that grows with the number of \
                  bodies. Each equation holds for all members of its item.";
    page.paragraph(solved.to_owned());
    page.section("Counts", tables::counts(model));
    page.section("Parameters", tables::parameters(model, &templates.parameters, &templates.symbols));
    page.section("Inputs", tables::inputs(model, &templates.inputs, &templates.symbols));
    items::write(&mut page, model, templates);
    page.attribute()
}

/// Coordinates less position rows, velocities less all rows.
fn freedom(equations: &Equations) -> [usize; 2] {
    let n_q = equations.force.len();
    [equations.constraints.n_position_rows, equations.constraints.rows.len()].map(|n| n_q.saturating_sub(n))
}

/// Paragraphs of Markdown.
#[derive(Default)]
struct Page(Vec<String>);

impl Page {
    fn heading(&mut self, title: &str) {
        self.paragraph(format!("# {title}"));
    }

    fn paragraph(&mut self, line: String) {
        self.0.extend([String::new(), line]);
    }

    /// A heading with lines that belong together; nothing when there are none.
    fn section(&mut self, title: &str, lines: Vec<String>) {
        if !lines.is_empty() {
            self.heading(title);
            self.0.push(String::new());
            self.0.extend(lines);
        }
    }

    fn attribute(&self) -> TokenStream {
        let page = self.0.join("\n");
        quote!(#[cfg_attr(doc, doc = #page)])
    }
}
