//! Julia, for numbers of any type.

use crate::scalar::{Function, Pair};

use super::Source;
use super::expression::Syntax;
use super::head::{List, file_name, lists, title};
use super::kernels::{Group, Kernel};
use super::statements::{Place, body};

/// The language.
#[derive(Debug)]
pub(super) struct Julia;

impl Syntax for Julia {
    fn number(&self, x: f64) -> String {
        format!("{x:?}")
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
            Pair::Atan2 => "atan",
            Pair::Min => "min",
            Pair::Max => "max",
        };
        format!("{name}({first}, {second})")
    }

    fn element(&self, vector: &str, i: usize) -> String {
        format!("{vector}[{}]", i + 1)
    }
}

const SOLVED: &str = "
# accelerations and multipliers from M, G, F and the right side of G a
function solved(mass, jacobian, force, right_side)
    n, n_rows = length(mass), length(right_side)
    matrix = [Diagonal(mass) transpose(jacobian); jacobian zeros(n_rows, n_rows)]
    solution = matrix \\ [force; right_side]
    return solution[1:n], solution[n+1:end]
end
";

impl Julia {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let mut text: String =
            title(source).iter().map(|line| format!("# {line}").trim_end().to_owned() + "\n").collect();
        let name = file_name(&source.info);
        let module = name[..1].to_uppercase() + &name[1..];
        text += &format!("module {module}\n\nusing LinearAlgebra\n");
        text += &lists(source).iter().map(list).collect::<String>();
        text += &format!("\n# time at which the scene starts, s\nconst START_TIME = {:?}\n", source.start.t);
        text += "\n# the values of a list, such as PARAMETERS\nvalues(of) = [value for (_, _, value) in of]\n";
        text += &source.kernels.all().map(|kernel| self.function_of(source, kernel)).collect::<String>();
        if source.kernels.accelerations.is_none() {
            text += &accelerations(source);
        }
        text + "\nend\n"
    }

    fn function_of(&self, source: &Source<'_>, kernel: &Kernel) -> String {
        let body = body(self, &source.info, &source.kernels, kernel);
        let types = kernel.arguments.iter().map(|group| match group {
            Group::Time => "typeof(t)".to_owned(),
            _ => format!("eltype({})", group.letter()),
        });
        let mut lines = vec![format!("T = float(promote_type({}))", types.collect::<Vec<_>>().join(", "))];
        lines.extend(body.named.iter().map(|(name, value)| format!("{name} = {value}")));
        for (returned, entries) in kernel.returned.iter().zip(&body.returned) {
            let (name, n) = (returned.name, returned.values.len());
            lines.push(match returned.n_columns {
                Some(columns) => format!("{name} = zeros(T, {}, {columns})", n / columns),
                None => format!("{name} = zeros(T, {n})"),
            });
            lines.extend(entries.iter().map(|(place, value)| format!("{name}[{}] = {value}", index(*place))));
        }
        let names: Vec<&str> = kernel.returned.iter().map(|returned| returned.name).collect();
        lines.push(format!("return {}", names.join(", ")));
        function(kernel.name, &kernel.arguments, kernel.about, &lines)
    }
}

/// The accelerations of a scene without a generated elimination.
fn accelerations(source: &Source<'_>) -> String {
    let arguments = source.kernels.variables.of_motion();
    let list = names(&arguments);
    let (helper, line) = match source.info.n_rows() {
        0 => ("", format!("return applied_force({list}) ./ mass_matrix(c), zeros(0)")),
        _ => (
            SOLVED,
            format!(
                "return solved(mass_matrix(c), velocity_jacobian({list}), applied_force({list}), -convective_term({list}))"
            ),
        ),
    };
    helper.to_owned() + &function("accelerations", &arguments, "Accelerations and multipliers.", &[line])
}

fn function(name: &str, arguments: &[Group], about: &str, lines: &[String]) -> String {
    let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
    format!("\n# {about}\nfunction {name}({})\n{lines}end\n", names(arguments))
}

fn names(arguments: &[Group]) -> String {
    arguments.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ")
}

fn index((row, column): Place) -> String {
    column.map_or_else(|| (row + 1).to_string(), |column| format!("{}, {}", row + 1, column + 1))
}

/// A list of names, units and values.
fn list(list: &List) -> String {
    let mut text = format!(
        "\n# {}: name, unit{}\nconst {} = [\n",
        list.about,
        if list.has_values { ", value" } else { "" },
        list.name.to_uppercase()
    );
    for entry in &list.entries {
        let comment =
            if entry.documentation.is_empty() { String::new() } else { format!(" # {}", entry.documentation) };
        let value = if list.has_values { format!(", {:?}", entry.value) } else { String::new() };
        text += &format!("    ({:?}, {:?}{value}),{comment}\n", entry.name, entry.unit);
    }
    text + "]\n"
}
