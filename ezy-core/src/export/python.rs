//! Python, with the library that its functions take numbers of.

use crate::scalar::{Function, Pair};

use super::Source;
use super::expression::Syntax;
use super::head::{List, lists, title};
use super::kernels::{Group, Kernel};
use super::statements::{Place, body};

/// A library of Python.
#[derive(Debug)]
pub(super) struct Python {
    import: &'static str,
    /// Its name in the file.
    alias: &'static str,
    /// Sine, cosine, …, in the order of [`Function`].
    functions: [&'static str; 11],
    /// atan2, min, max.
    pairs: [&'static str; 3],
    /// How numbers are written that are not whole.
    has_fractions: bool,
    helpers: &'static str,
    /// A matrix of zeros.
    matrix: &'static str,
    /// The solution of a scene without a generated elimination.
    solved: &'static str,
}

pub(super) const NUMPY: Python = Python {
    import: "import numpy as np",
    alias: "np",
    functions: ["sin", "cos", "tan", "arcsin", "arccos", "sqrt", "exp", "log", "tanh", "abs", "sign"],
    pairs: ["arctan2", "minimum", "maximum"],
    has_fractions: false,
    helpers: "
def values(of):
    \"\"\"The values of a list, such as PARAMETERS, as an array.\"\"\"
    return np.array([value for _, _, value in of])


def zeros(n, like):
    \"\"\"A vector; a column for each column of `like`.\"\"\"
    return np.zeros((n, *np.shape(like)[1:]))
",
    matrix: "

def zero_matrix(n_rows, n_columns, like):
    return np.zeros((n_rows, n_columns, *np.shape(like)[1:]))
",
    solved: "

def solved(mass, jacobian, force, right_side):
    \"\"\"Accelerations and multipliers from M, G, F and the right side of G a.\"\"\"
    n = len(mass)
    matrix = np.block([[np.diag(mass), jacobian.T], [jacobian, np.zeros((len(right_side), len(right_side)))]])
    solution = np.linalg.solve(matrix, np.concatenate([force, right_side]))
    return solution[:n], solution[n:]
",
};

pub(super) const SYMPY: Python = Python {
    import: "import sympy as sp",
    alias: "sp",
    functions: ["sin", "cos", "tan", "asin", "acos", "sqrt", "exp", "log", "tanh", "Abs", "sign"],
    pairs: ["atan2", "Min", "Max"],
    has_fractions: true,
    helpers: "
def symbols(of):
    \"\"\"The names of a list, such as COORDINATES, as real symbols.\"\"\"
    return [sp.Symbol(name, real=True) for name, _, _ in of]


def values(of):
    \"\"\"The values of a list, such as PARAMETERS.\"\"\"
    return [value for _, _, value in of]


def zeros(n, like):
    return sp.zeros(n, 1)
",
    matrix: "

def zero_matrix(n_rows, n_columns, like):
    return sp.zeros(n_rows, n_columns)
",
    solved: "

def solved(mass, jacobian, force, right_side):
    \"\"\"Accelerations and multipliers from M, G, F and the right side of G a.\"\"\"
    n, n_rows = len(mass), len(right_side)
    upper = sp.Matrix.hstack(sp.diag(*mass), jacobian.T)
    lower = sp.Matrix.hstack(jacobian, sp.zeros(n_rows, n_rows))
    solution = sp.Matrix.vstack(upper, lower).LUsolve(sp.Matrix.vstack(force, right_side))
    return solution[:n, :], solution[n:, :]
",
};

pub(super) const CASADI: Python = Python {
    import: "import casadi as ca",
    alias: "ca",
    functions: ["sin", "cos", "tan", "asin", "acos", "sqrt", "exp", "log", "tanh", "fabs", "sign"],
    pairs: ["atan2", "fmin", "fmax"],
    has_fractions: false,
    helpers: "
def symbols(name, of):
    \"\"\"A vector of symbols, one for each name of a list such as COORDINATES.\"\"\"
    return ca.SX.sym(name, len(of))


def values(of):
    \"\"\"The values of a list, such as PARAMETERS.\"\"\"
    return ca.DM([value for _, _, value in of])


def zeros(n, like):
    return ca.SX.zeros(n, 1)
",
    matrix: "

def zero_matrix(n_rows, n_columns, like):
    return ca.SX.zeros(n_rows, n_columns)
",
    solved: "

def solved(mass, jacobian, force, right_side):
    \"\"\"Accelerations and multipliers from M, G, F and the right side of G a.\"\"\"
    n, n_rows = mass.shape[0], right_side.shape[0]
    upper = ca.horzcat(ca.diag(mass), jacobian.T)
    lower = ca.horzcat(jacobian, ca.SX.zeros(n_rows, n_rows))
    solution = ca.solve(ca.vertcat(upper, lower), ca.vertcat(force, right_side))
    return solution[:n], solution[n:]
",
};

impl Syntax for Python {
    fn number(&self, x: f64) -> String {
        match (self.has_fractions, x.fract() == 0.0) {
            (true, true) => format!("{x}"),
            // a whole number would make a float of it
            (true, false) => format!("{}.Rational(\"{x:?}\")", self.alias),
            (false, _) => format!("{x:?}"),
        }
    }

    fn not_finite(&self, is_nan: bool) -> String {
        let infinity = if self.has_fractions { "oo" } else { "inf" };
        format!("{}.{}", self.alias, if is_nan { "nan" } else { infinity })
    }

    fn pi(&self) -> String {
        format!("{}.pi", self.alias)
    }

    fn function(&self, function: Function) -> String {
        format!("{}.{}", self.alias, self.functions[function as usize])
    }

    fn pair(&self, pair: Pair, first: &str, second: &str) -> String {
        let name = match pair {
            Pair::Power => return format!("({first})**({second})"),
            Pair::Atan2 => self.pairs[0],
            Pair::Min => self.pairs[1],
            Pair::Max => self.pairs[2],
        };
        format!("{}.{name}({first}, {second})", self.alias)
    }

    fn element(&self, vector: &str, i: usize) -> String {
        format!("{vector}[{i}]")
    }
}

impl Python {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let mut text = format!("\"\"\"{}\n\"\"\"\n{}\n", title(source).join("\n"), self.import);
        text += &lists(source).iter().map(list).collect::<String>();
        text += &format!("\n# time at which the scene starts, s\nSTART_TIME = {:?}\n\n", source.start.t);
        text += self.helpers;
        let (has_rows, is_solved) = (source.info.n_rows() > 0, source.kernels.accelerations.is_some());
        text += if has_rows { self.matrix } else { "" };
        text += if has_rows && !is_solved { self.solved } else { "" };
        text += &source.kernels.all().map(|kernel| self.function_of(source, kernel)).collect::<String>();
        if !is_solved {
            text += &accelerations(source);
        }
        text
    }

    fn function_of(&self, source: &Source<'_>, kernel: &Kernel) -> String {
        let body = body(self, &source.info, &source.kernels, kernel);
        let mut lines: Vec<String> = body.named.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        let like = if kernel.arguments.contains(&Group::Coordinates) { "q" } else { kernel.arguments[0].letter() };
        for (returned, entries) in kernel.returned.iter().zip(&body.returned) {
            let (name, n) = (returned.name, returned.values.len());
            lines.push(match returned.n_columns {
                Some(columns) => format!("{name} = zero_matrix({}, {columns}, {like})", n / columns),
                None => format!("{name} = zeros({n}, {like})"),
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
    let line = match source.info.n_rows() {
        0 => format!("return applied_force({list}) / mass_matrix(c), zeros(0, q)"),
        _ => format!(
            "return solved(mass_matrix(c), velocity_jacobian({list}), applied_force({list}), -convective_term({list}))"
        ),
    };
    function("accelerations", &arguments, "Accelerations and multipliers.", &[line])
}

fn function(name: &str, arguments: &[Group], about: &str, lines: &[String]) -> String {
    let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
    format!("\n\ndef {name}({}):\n    \"\"\"{about}\"\"\"\n{lines}", names(arguments))
}

fn names(arguments: &[Group]) -> String {
    arguments.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ")
}

fn index((row, column): Place) -> String {
    column.map_or_else(|| row.to_string(), |column| format!("{row}, {column}"))
}

/// A list of names, units and values.
fn list(list: &List) -> String {
    let mut text = format!(
        "\n# {}: name, unit{}\n{} = [\n",
        list.about,
        if list.has_values { ", value" } else { "" },
        list.name.to_uppercase()
    );
    for entry in &list.entries {
        let comment =
            if entry.documentation.is_empty() { String::new() } else { format!("  # {}", entry.documentation) };
        let value = if list.has_values { format!(", {:?}", entry.value) } else { String::new() };
        text += &format!("    ({:?}, {:?}{value}),{comment}\n", entry.name, entry.unit);
    }
    text + "]\n"
}
