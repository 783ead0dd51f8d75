//! A model and its scenes as a page of a textbook, for `cargo doc`: parameters, rows, equations, sparsity, costs.
//!
//! The page is an attribute that only rustdoc reads, so that an editor shows the short text alone. Equations are
//! MathML in one line, which passes through Markdown untouched and needs no script and no style sheet.

mod tables;

use proc_macro2::TokenStream;
use quote::quote;

use super::abbreviations::Abbreviations;
use super::equation::Equation;
use super::equations::{self, OfItems};
use super::templates;
use super::type_names::scene_type;
use crate::mechanics::derived::{Form, Straight};
use crate::mechanics::kernels::{Kernel, Quantity};
use crate::mechanics::{Derived, Equations, Templates};
use crate::model::Model;

/// The page of the module: scenes and effects; none of a model with counts.
pub fn model(model: &Model, scenes: &[Derived<'_>]) -> TokenStream {
    let row = |derived: &Derived<'_>| {
        let Form::Straight(of) = &derived.form else { return None };
        let [positions, velocities] = freedom(&of.equations);
        let count = derived.kernels.get(&Quantity::Accelerations).map(Kernel::count);
        let operations = count.map_or("sparse solver".to_owned(), |of| (of.add + of.mul + of.div).to_string());
        let effects = derived.scene.effects.iter().map(|effect| format!("`{}`", model.effects[effect.0].name));
        let effects = effects.collect::<Vec<_>>().join(", ");
        let name = format!("[`{}`]({})", derived.scene.name, scene_type(&derived.scene));
        Some(vec![name, effects, positions.to_string(), velocities.to_string(), operations])
    };
    let rows: Vec<Vec<String>> = scenes.iter().filter_map(row).collect();
    if rows.is_empty() {
        return TokenStream::new();
    }
    let heads = ["scene", "effects", "degrees of freedom in position", "in velocity", "operations"];
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
pub fn scene(model: &Model, derived: &Derived<'_>, of: &Straight, names: &Abbreviations<'_>) -> TokenStream {
    let equations = &of.equations;
    let [positions, velocities] = freedom(equations);
    let mut page = Page::default();
    page.paragraph(format!("Degrees of freedom: {positions} in position, {velocities} in velocity."));
    page.section("Parameters", tables::parameters(model, &equations.parameters, &equations.symbols));
    let [inputs, states] = model.split_states(&equations.inputs);
    page.section("Inputs", tables::inputs(model, inputs, &equations.symbols));
    page.section("First-order states", tables::states(model, states, &equations.symbols));
    page.section("Rows", tables::rows(equations));
    page.section("Switches", tables::switches(model, equations));
    page.equations(&equations::of_scene(equations, names));
    page.section("Outputs", tables::outputs(model, equations, names));
    page.section("Sparsity of the Jacobian", tables::sparsity(model, equations));
    if derived.kernels.contains_key(&Quantity::Accelerations) {
        page.section("Order of elimination", tables::elimination(equations, &of.elimination));
        page.section("Operations", tables::operations(&derived.kernels));
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
    let [inputs, states] = model.split_states(&templates.inputs);
    page.section("Inputs", tables::inputs(model, inputs, &templates.symbols));
    page.section("First-order states", tables::states(model, states, &templates.symbols));
    let of = OfItems { model, templates };
    for item in templates::all(model, templates) {
        let equations = item.equations(&of);
        if !equations.is_empty() {
            page.heading(&item.title(model));
            page.equations(&equations);
        }
    }
    page.equations(equations::rates_of(templates).as_slice());
    page.equations(&[equations::motion_of(templates)]);
    page.attribute()
}

/// Coordinates less position constraints, velocities less all rows, as they are at the start.
fn freedom(equations: &Equations) -> [usize; 2] {
    let n_q = equations.force.len();
    let constraints = &equations.constraints;
    // a stop is open at the start
    let hold = |n: usize| constraints.rows[..n].iter().filter(|row| row.kind != "stop").count();
    [constraints.n_position_rows, constraints.rows.len()].map(|n| n_q.saturating_sub(hold(n)))
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

    /// Each on a line of its own that scrolls when it is too long.
    fn equations(&mut self, equations: &[Equation]) {
        for Equation { name, mathml, .. } in equations {
            self.heading(&format!("{}{}", name[..1].to_uppercase(), &name[1..]));
            let math = format!("<math display=\"block\">{mathml}</math>");
            self.paragraph(format!("<div style=\"overflow-x: auto; padding: .3em 0\">{math}</div>"));
        }
    }

    fn attribute(&self) -> TokenStream {
        let page = self.0.join("\n");
        quote!(#[cfg_attr(doc, doc = #page)])
    }
}
