//! Python, with the library that its functions take numbers of.

use crate::scalar::{Function, Pair};

use super::Source;
use super::expression::Syntax;
use super::head::title;
use super::kernels::Group;
use super::script::{Marks, Script, indented, names, solves};

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

impl Script for Python {
    fn syntax(&self) -> &dyn Syntax {
        self
    }

    fn marks(&self) -> Marks {
        Marks { first_index: 0, brackets: ['[', ']'], end: "", comment: '#', entry: ["(", "),"] }
    }

    fn begin_of_list(&self, name: &str) -> String {
        format!("{} = [", name.to_uppercase())
    }

    /// Values of lists are floats in every library.
    fn signed(&self, x: f64) -> String {
        format!("{x:?}")
    }

    fn zeros(&self, n: usize, n_columns: Option<usize>, arguments: &[Group]) -> String {
        let like = if arguments.contains(&Group::Coordinates) { "q" } else { arguments[0].letter() };
        match n_columns {
            Some(columns) => format!("zero_matrix({}, {columns}, {like})", n / columns),
            None => format!("zeros({n}, {like})"),
        }
    }

    fn definition(&self, name: &str, results: &[&str], arguments: &[Group], about: &str, lines: &[String]) -> String {
        let (arguments, results) = (names(arguments), results.join(", "));
        format!("\n\ndef {name}({arguments}):\n    \"\"\"{about}\"\"\"\n{}    return {results}\n", indented(lines))
    }
}

impl Python {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let optional = |text: &str, is_there: bool| if is_there { text.to_owned() } else { String::new() };
        [
            format!("\"\"\"{}\n\"\"\"\n{}\n", title(source).join("\n"), self.import),
            self.lists(source),
            format!("\n# time at which the scene starts, s\nSTART_TIME = {:?}\n\n", source.start.t),
            self.helpers.to_owned(),
            optional(self.matrix, source.info.n_rows() > 0),
            optional(self.solved, solves(source)),
            self.functions(source),
            self.solution(source),
        ]
        .concat()
    }
}
