//! MATLAB and GNU Octave: one function, which returns the others.

use crate::scalar::{Function, Pair};

use super::Source;
use super::expression::Syntax;
use super::head::{List, file_name, lists, title};
use super::kernels::{Group, Kernel};
use super::statements::{Place, body};

/// The language.
#[derive(Debug)]
pub(super) struct Matlab;

impl Syntax for Matlab {
    fn number(&self, x: f64) -> String {
        if x.fract() == 0.0 && x < 1e15 { format!("{x}") } else { format!("{x:?}") }
    }

    fn not_finite(&self, is_nan: bool) -> String {
        if is_nan { "NaN" } else { "Inf" }.to_owned()
    }

    fn pi(&self) -> String {
        "pi".to_owned()
    }

    fn function(&self, function: Function) -> String {
        let names = ["sin", "cos", "tan", "asin", "acos", "sqrt", "exp", "log", "tanh", "abs", "sign"];
        names[function as usize].to_owned()
    }

    fn pair(&self, pair: Pair, first: &str, second: &str) -> String {
        let name = match pair {
            Pair::Power => return format!("({first})^({second})"),
            Pair::Atan2 => "atan2",
            Pair::Min => "min",
            Pair::Max => "max",
        };
        format!("{name}({first}, {second})")
    }

    fn element(&self, vector: &str, i: usize) -> String {
        format!("{vector}({})", i + 1)
    }
}

const SOLVED: &str = "
function [acceleration, multiplier] = solved(mass, jacobian, force, right_side)
    % Accelerations and multipliers from M, G, F and the right side of G a.
    n = numel(mass);
    matrix = [diag(mass), jacobian'; jacobian, zeros(numel(right_side))];
    solution = matrix \\ [force; right_side];
    acceleration = solution(1:n);
    multiplier = solution(n+1:end);
end
";

impl Matlab {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let name = file_name(&source.info);
        let comment = |line: &String| format!("% {line}").trim_end().to_owned() + "\n";
        let mut text = format!("function scene = {name}()\n");
        text += &title(source).iter().map(comment).collect::<String>();
        text += &format!("%\n% scene = {name}(); c = scene.constants(scene.values(scene.list.parameters));\n");
        text += &lists(source).iter().map(list).collect::<String>();
        text += &format!("\n% time at which the scene starts, s\nscene.start_time = {};\n", source.start.t);
        text += "\nscene.values = @(of) cell2mat(of(:, 3));\n";
        let kernels = || source.kernels.all().map(|kernel| kernel.name);
        let solved = source.kernels.accelerations.is_none().then_some("accelerations");
        text += &kernels().chain(solved).map(|name| format!("scene.{name} = @{name};\n")).collect::<String>();
        text += "end\n";
        text += &source.kernels.all().map(|kernel| self.function_of(source, kernel)).collect::<String>();
        if solved.is_some() {
            text += &accelerations(source);
        }
        text
    }

    fn function_of(&self, source: &Source<'_>, kernel: &Kernel) -> String {
        let body = body(self, &source.info, &source.kernels, kernel);
        let mut lines: Vec<String> = body.named.iter().map(|(name, value)| format!("{name} = {value};")).collect();
        for (returned, entries) in kernel.returned.iter().zip(&body.returned) {
            let (name, n) = (returned.name, returned.values.len());
            lines.push(match returned.n_columns {
                Some(columns) => format!("{name} = zeros({}, {columns});", n / columns),
                None => format!("{name} = zeros({n}, 1);"),
            });
            lines.extend(entries.iter().map(|(place, value)| format!("{name}({}) = {value};", index(*place))));
        }
        let names: Vec<&str> = kernel.returned.iter().map(|returned| returned.name).collect();
        function(kernel.name, &names, &kernel.arguments, kernel.about, &lines)
    }
}

/// The accelerations of a scene without a generated elimination.
fn accelerations(source: &Source<'_>) -> String {
    let arguments = source.kernels.variables.of_motion();
    let list = names(&arguments);
    let (helper, lines) = match source.info.n_rows() {
        0 => (
            "",
            vec![
                format!("acceleration = applied_force({list}) ./ mass_matrix(c);"),
                "multiplier = zeros(0, 1);".to_owned(),
            ],
        ),
        _ => (
            SOLVED,
            vec![
                format!("right_side = -convective_term({list});"),
                format!("jacobian = velocity_jacobian({list});"),
                format!(
                    "[acceleration, multiplier] = solved(mass_matrix(c), jacobian, applied_force({list}), right_side);"
                ),
            ],
        ),
    };
    let results = ["acceleration", "multiplier"];
    helper.to_owned() + &function("accelerations", &results, &arguments, "Accelerations and multipliers.", &lines)
}

fn function(name: &str, results: &[&str], arguments: &[Group], about: &str, lines: &[String]) -> String {
    let results = match results {
        [one] => (*one).to_owned(),
        _ => format!("[{}]", results.join(", ")),
    };
    let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
    format!("\nfunction {results} = {name}({})\n    % {about}\n{lines}end\n", names(arguments))
}

fn names(arguments: &[Group]) -> String {
    arguments.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ")
}

fn index((row, column): Place) -> String {
    column.map_or_else(|| (row + 1).to_string(), |column| format!("{}, {}", row + 1, column + 1))
}

/// A list of names, units and values.
fn list(list: &List) -> String {
    let quoted = |text: &str| format!("'{}'", text.replace('\'', "''"));
    let mut text = format!(
        "\n% {}: name, unit{}\nscene.list.{} = {{\n",
        list.about,
        if list.has_values { ", value" } else { "" },
        list.name
    );
    for entry in &list.entries {
        let comment =
            if entry.documentation.is_empty() { String::new() } else { format!(" % {}", entry.documentation) };
        let value = if list.has_values { format!(", {}", entry.value) } else { String::new() };
        text += &format!("    {}, {}{value}{comment}\n", quoted(&entry.name), quoted(&entry.unit));
    }
    text + "};\n"
}
