//! A scene as a fragment of LaTeX: text, tables and displayed equations; needs the package `amsmath`.

use ezy_core::model::{EliminationStep, Equation, ParameterInfo, SceneInfo};

use super::{OPERATIONS, freedom, kernels, pattern, pivot, with_equations};

/// A line of the source has so many signs, where it has spaces.
const WIDEST_LINE: usize = 100;

pub(super) fn scene(info: &SceneInfo) -> String {
    content(info).lines().map(|line| wrapped(line) + "\n").collect()
}

/// A line of the source on several ones, which LaTeX reads as one. Comments remain as they are.
fn wrapped(line: &str) -> String {
    if line.starts_with('%') {
        return line.to_owned();
    }
    let mut lines = vec![String::new()];
    for word in line.split(' ') {
        let last = lines.len() - 1;
        if lines[last].is_empty() || lines[last].chars().count() + word.chars().count() < WIDEST_LINE {
            lines[last] += &format!("{word} ");
        } else {
            lines.push(format!("  {word} "));
        }
    }
    lines.iter().map(|line| line.trim_end()).collect::<Vec<_>>().join("\n")
}

fn content(info: &SceneInfo) -> String {
    let [positions, velocities] = freedom(info);
    let mut text = format!("% {}/{}; \\usepackage{{amsmath}}\n", info.model, info.name);
    text += &format!("\\section*{{{}/{}}}\n\n", plain(info.model), plain(info.name));
    text += &format!("{}\n\n", plain(info.documentation.trim()));
    text += &format!("Degrees of freedom: {positions} in position, {velocities} in velocity.\n");
    text += &declared(info);
    for item in with_equations(info) {
        text += &format!("\n\\subsection*{{{}}}\n", plain(item.title));
        text += &item.equations.iter().map(display).collect::<String>();
    }
    text += &info.equations.iter().map(display).collect::<String>();
    let outputs: Vec<String> =
        info.outputs.iter().map(|o| format!("\\text{{{}}} &= {}", plain(&o.name), o.formula.latex)).collect();
    if !outputs.is_empty() {
        text += &format!("\nOutputs:\n\\begin{{align*}}\n{}\n\\end{{align*}}\n", outputs.join(" \\\\\n"));
    }
    if !info.has_elimination() {
        return text;
    }
    let heads = std::iter::once("row".to_owned()).chain(info.bodies.iter().map(|body| plain(body)));
    let rows = info.rows.iter().zip(pattern(info)).map(|(row, signs)| {
        std::iter::once(plain(&row.name)).chain(signs.into_iter().map(|sign| format!("\\texttt{{{sign}}}"))).collect()
    });
    text += "\nSparsity of the Jacobian, $x$, $y$ and $\\varphi$ of each body:\n";
    text += &tabular(&heads.collect::<Vec<_>>(), rows);
    if !info.elimination.is_empty() {
        let steps: String = info.elimination.iter().map(|step| elimination(info, step)).collect();
        text += &format!("\nOrder of elimination:\n\\begin{{enumerate}}\n{steps}\\end{{enumerate}}\n");
    }
    if let Some(of) = info.quasi_velocities {
        let formulas: Vec<String> = of.formulas.iter().map(|formula| format!("${}$", formula.latex)).collect();
        text += &format!("\nQuasi-velocities: {}.\n", formulas.join(", "));
    }
    let heads = std::iter::once("operations").chain(OPERATIONS).map(str::to_owned).collect::<Vec<_>>();
    let rows = kernels(info)
        .into_iter()
        .map(|(name, numbers)| std::iter::once(name.to_owned()).chain(numbers.map(|n| n.to_string())).collect());
    text + "\n" + &tabular(&heads, rows)
}

fn display(equation: &Equation) -> String {
    let title = format!("{}{}", equation.name[..1].to_uppercase(), &equation.name[1..]);
    format!("\n% {}\n{title}:\n\\[\n{}\n\\]\n", equation.name, equation.latex.replace(" \\\\ ", " \\\\\n"))
}

fn elimination(info: &SceneInfo, step: &EliminationStep) -> String {
    let rows = step.rows.iter().map(|row| plain(&info.rows[*row].name)).collect::<Vec<_>>().join(", ");
    format!("\\item {rows}: {}\n", pivot(step))
}

/// Parameters, inputs, states, effects and rows.
fn declared(info: &SceneInfo) -> String {
    let mut text = String::new();
    let mut put = |heads: &[&str], rows: Vec<Vec<String>>| {
        if !rows.is_empty() {
            text += &format!("\n{}", tabular(&heads.iter().map(|head| (*head).to_owned()).collect::<Vec<_>>(), rows));
        }
    };
    let parameters = info.parameters.iter().map(|p| {
        let effect = plain(p.effect.unwrap_or(""));
        vec![
            format!("${}$", p.symbol.latex),
            plain(p.default_text),
            unit(p.unit),
            effect,
            plain(p.documentation.trim()),
        ]
    });
    put(&["parameter", "value", "unit", "effect", "what it is"], parameters.collect());
    let numbers = |numbers: &[ParameterInfo]| {
        let number = |p: &ParameterInfo| {
            vec![format!("${}$", p.symbol.latex), plain(p.default_text), unit(p.unit), plain(p.documentation.trim())]
        };
        numbers.iter().map(number).collect()
    };
    put(&["input", "until it is set", "unit", "what it is"], numbers(info.inputs));
    put(&["state", "at the start", "unit", "what it is"], numbers(info.states));
    let effects = info.effects.iter().map(|e| vec![plain(e.name), plain(e.documentation.trim())]);
    put(&["effect", "what it is"], effects.collect());
    if info.repeats.is_some() {
        return text;
    }
    let rows = info.rows.iter().enumerate().map(|(i, row)| {
        let level = if i < info.n_position_rows { "position" } else { "velocity" };
        vec![plain(&row.name), plain(row.kind), level.to_owned(), unit(row.multiplier_unit)]
    });
    put(&["row", "word", "level", "unit of its multiplier"], rows.collect());
    text
}

fn tabular(heads: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let rows: String = rows.into_iter().map(|row| format!("{} \\\\\n", row.join(" & "))).collect();
    let columns = "l".repeat(heads.len());
    format!(
        "\\begin{{center}}\\begin{{tabular}}{{{columns}}}\n{} \\\\ \\hline\n{rows}\\end{{tabular}}\\end{{center}}\n",
        heads.join(" & ")
    )
}

/// Text with LaTeX's special characters escaped.
fn plain(text: &str) -> String {
    text.chars()
        .map(|sign| match sign {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{sign}"),
            '\\' => "\\textbackslash{}".to_owned(),
            '^' => "\\^{}".to_owned(),
            '~' => "\\~{}".to_owned(),
            _ => sign.to_string(),
        })
        .collect()
}

/// `kg*m^2` as kg·m².
fn unit(written: &str) -> String {
    let factors = written.replace('*', "\\cdot ");
    if factors.is_empty() { String::new() } else { format!("$\\mathrm{{{factors}}}$") }
}
