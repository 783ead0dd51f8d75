//! Equations that the program prints fit on a page.

use crate::{ezy, text};
use ezy_core::model::{Equation, Formula, SceneInfo};
use ezy_models::registry::MODELS;

/// Signs of a line.
const WIDEST: usize = 120;

#[test]
fn invariant_no_line_of_equations_is_wider_than_a_page() {
    for model in MODELS {
        for format in ["text", "latex"] {
            let done = ezy(&["show", model.name, "--format", format]);
            assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
            for line in text(&done.stdout).lines() {
                assert!(line.chars().count() <= WIDEST, "{}, {format}: {line}", model.name);
            }
        }
    }
}

/// Text without spaces, and without the brackets of a matrix and what stands outside of them.
fn joined_text(equation: &Equation) -> String {
    let within = |line: &str| -> String {
        let line = line.split_once("[ ").map_or(line, |(_, rest)| rest);
        line.split_once(" ]").map_or(line, |(cells, _)| cells).to_owned()
    };
    equation.text.lines().flat_map(|line| within(line).chars().filter(|c| *c != ' ').collect::<Vec<_>>()).collect()
}

/// LaTeX without what breaks lines.
fn joined_latex(latex: &str) -> String {
    let marks = ["\\right. \\\\ & \\quad \\left.{} ", " \\\\ & \\quad {}", "\\begin{aligned} & ", " \\end{aligned}"];
    marks.iter().fold(latex.to_owned(), |latex, mark| latex.replace(mark, "")).replace(' ', "")
}

/// Single expressions of a scene, with the equation that holds them.
fn expressions(info: &SceneInfo) -> Vec<(&'static str, &Formula)> {
    let n = info.n_position_rows;
    let of_rows = info.rows.iter().enumerate().flat_map(|(i, row)| {
        let names = match i < n {
            true => ["position constraint", "convective term of the position constraint"],
            false => ["velocity constraint", "convective term of the velocity constraint"],
        };
        [(names[0], &row.constraint), (names[1], &row.convective_term)]
    });
    let entries = info.jacobian.entries().filter_map(|(k, row, _)| {
        let name = if row < n { "Jacobian of the position constraint" } else { "Jacobian of the velocity constraint" };
        Some((name, info.jacobian_entries.get(k)?))
    });
    let forces = info.force_entries.iter().map(|entry| ("applied force", entry));
    let masses = info.mass_entries.iter().map(|entry| ("mass matrix", entry));
    let abbreviations = info.abbreviations.iter().map(|of| ("abbreviations", &of.formula));
    of_rows.chain(entries).chain(forces).chain(masses).chain(abbreviations).collect()
}

#[test]
fn cross_equations_without_their_breaks_hold_every_expression() {
    let mut n_broken = 0;
    for model in MODELS {
        for entry in model.scenes {
            let info = (entry.info)();
            for (name, expression) in expressions(&info) {
                // a scene with counts has equations of items
                let Some(equation) = info.equations.iter().find(|equation| equation.name == name) else { continue };
                let whole = expression.text.replace(' ', "");
                assert!(joined_text(equation).contains(&whole), "{}/{}, {name}: {whole}", model.name, entry.name);
                let whole = joined_latex(expression.latex);
                let found = joined_latex(equation.latex);
                assert!(found.contains(&whole), "{}/{}, {name}: {whole}\n{found}", model.name, entry.name);
                n_broken += usize::from(!equation.latex.replace(' ', "").contains(&expression.latex.replace(' ', "")));
            }
        }
    }
    assert!(n_broken > 20, "{n_broken}");
}
