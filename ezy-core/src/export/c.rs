//! C99, which C++ reads, too.

use crate::scalar::{Function, Pair};

use super::Source;
use super::expression::Syntax;
use super::head::{List, file_name, lists, title};
use super::kernels::{Group, Kernel};
use super::statements::body;

/// The language.
#[derive(Debug)]
pub(super) struct C;

impl Syntax for C {
    fn number(&self, x: f64) -> String {
        format!("{x:?}")
    }

    fn not_finite(&self, is_nan: bool) -> String {
        if is_nan { "NAN" } else { "INFINITY" }.to_owned()
    }

    fn pi(&self) -> String {
        format!("{:?}", std::f64::consts::PI)
    }

    fn function(&self, function: Function) -> String {
        let names = ["sin", "cos", "tan", "asin", "acos", "sqrt", "exp", "log", "tanh", "fabs", "ezy_sign"];
        names[function as usize].to_owned()
    }

    fn pair(&self, pair: Pair, first: &str, second: &str) -> String {
        let name = match pair {
            Pair::Atan2 => "atan2",
            Pair::Min => "fmin",
            Pair::Max => "fmax",
            Pair::Power => "pow",
        };
        format!("{name}({first}, {second})")
    }

    fn element(&self, vector: &str, i: usize) -> String {
        format!("{vector}[{i}]")
    }
}

/// What functions call. Names are those of the file, so that several files can be one program.
const SIGN: &str = "
static inline double ezy_sign(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : x; }
";

/// Gaussian elimination with row exchanges.
pub(super) const SOLVE: &str = include_str!("solve.c");

impl C {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let prefix = file_name(&source.info);
        let title =
            title(source).iter().map(|line| format!(" * {line}").trim_end().to_owned() + "\n").collect::<String>();
        let mut text = format!(
            "/*\n{title} *\n * Results are written into the last arguments; a matrix has its rows one behind the other.\n */\n"
        );
        text += "#include <math.h>\n\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n";
        text += &format!("\ntypedef struct {{ const char *name; const char *unit; double value; }} {prefix}_entry;\n");
        text += &lists(source).iter().map(|of| list(&prefix, of)).collect::<String>();
        text += &format!(
            "\n/* time at which the scene starts, s */\nconst double {prefix}_start_time = {:?};\n",
            source.start.t
        );
        let functions: String = source.kernels.all().map(|kernel| self.function_of(source, &prefix, kernel)).collect();
        if functions.contains("ezy_sign(") {
            text += SIGN;
        }
        text += &functions;
        if source.kernels.accelerations.is_none() {
            text += &accelerations(source, &prefix);
        }
        text + "\n#ifdef __cplusplus\n}\n#endif\n"
    }

    fn function_of(&self, source: &Source<'_>, prefix: &str, kernel: &Kernel) -> String {
        let body = body(self, &source.info, &source.kernels, kernel);
        let mut lines = unused(&kernel.arguments, &body.read);
        lines.extend(body.named.iter().map(|(name, value)| format!("const double {name} = {value};")));
        for (returned, entries) in kernel.returned.iter().zip(&body.returned) {
            let (name, n) = (returned.name, returned.values.len());
            if n == 0 {
                lines.push(format!("(void){name};"));
            }
            if entries.len() < n {
                lines.push(format!("for (int i = 0; i < {n}; i++) {name}[i] = 0.0;"));
            }
            let place = |(row, column): (usize, Option<usize>)| {
                column.map_or(row, |column| row * returned.n_columns.unwrap_or_default() + column)
            };
            lines.extend(entries.iter().map(|(at, value)| format!("{name}[{}] = {value};", place(*at))));
        }
        let results: Vec<String> =
            kernel.returned.iter().map(|of| format!("{} /* {} */", of.name, of.values.len())).collect();
        function(prefix, kernel.name, &kernel.arguments, &results, kernel.about, &lines)
    }
}

/// Arguments that a function does not read cause no warning.
fn unused(arguments: &[Group], read: &[Group]) -> Vec<String> {
    arguments.iter().filter(|group| !read.contains(group)).map(|group| format!("(void){};", group.letter())).collect()
}

fn accelerations(source: &Source<'_>, prefix: &str) -> String {
    let arguments = source.kernels.variables.of_motion();
    let (n_v, n_c) = (source.info.n_velocities(), source.info.n_rows());
    let n = n_v + n_c;
    let list = arguments.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ");
    let mut lines = vec![
        format!("double mass[{n_v}];"),
        format!("{prefix}_mass_matrix(c, mass);"),
        format!("{prefix}_applied_force({list}, acceleration);"),
    ];
    lines.extend([
        format!("double jacobian[{}], matrix[{}] = {{0}}, solution[{n}];", n_v * n_c, n * n),
        format!("{prefix}_velocity_jacobian({list}, jacobian);"),
        format!("{prefix}_convective_term({list}, multiplier);"),
        format!("for (int i = 0; i < {n_v}; i++) {{"),
        format!("    matrix[i * {n} + i] = mass[i];"),
        "    solution[i] = acceleration[i];".to_owned(),
        format!("    for (int j = 0; j < {n_c}; j++) {{"),
        format!("        matrix[i * {n} + {n_v} + j] = jacobian[j * {n_v} + i];"),
        format!("        matrix[({n_v} + j) * {n} + i] = jacobian[j * {n_v} + i];"),
        "    }".to_owned(),
        "}".to_owned(),
        format!("for (int j = 0; j < {n_c}; j++) solution[{n_v} + j] = -multiplier[j];"),
        format!("ezy_solve({n}, matrix, solution);"),
        format!("for (int i = 0; i < {n_v}; i++) acceleration[i] = solution[i];"),
        format!("for (int j = 0; j < {n_c}; j++) multiplier[j] = solution[{n_v} + j];"),
    ]);
    let results = [format!("acceleration /* {n_v} */"), format!("multiplier /* {n_c} */")];
    let about = "Accelerations and multipliers; not finite where rows depend on each other.";
    format!("\n{SOLVE}") + &function(prefix, "accelerations", &arguments, &results, about, &lines)
}

fn function(
    prefix: &str,
    name: &str,
    arguments: &[Group],
    results: &[String],
    about: &str,
    lines: &[String],
) -> String {
    let arguments = arguments.iter().map(|group| match group {
        Group::Time => "double t".to_owned(),
        _ => format!("const double *{}", group.letter()),
    });
    let all: Vec<String> = arguments.chain(results.iter().map(|name| format!("double *{name}"))).collect();
    let lines: String = lines.iter().map(|line| format!("    {line}\n")).collect();
    format!("\n/* {about} */\nvoid {prefix}_{name}({}) {{\n{lines}}}\n", all.join(", "))
}

/// A list of names, units and values.
fn list(prefix: &str, list: &List) -> String {
    let n = list.entries.len();
    let mut text = format!(
        "\n/* {}: name, unit{} */\nconst {prefix}_entry {prefix}_list_of_{}[{n}] = {{\n",
        list.about,
        if list.has_values { ", value" } else { "" },
        list.name
    );
    for entry in &list.entries {
        let comment =
            if entry.documentation.is_empty() { String::new() } else { format!(" /* {} */", entry.documentation) };
        text += &format!("    {{{:?}, {:?}, {:?}}},{comment}\n", entry.name, entry.unit, entry.value);
    }
    text + "};\n"
}
