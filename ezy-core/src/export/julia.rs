//! Julia, for numbers of any type.

use crate::scalar::Pair;

use super::Source;
use super::expression::Syntax;
use super::head::{file_name, title};
use super::kernels::Group;
use super::script::{Marks, Script, indented, names, solves};

/// The language.
#[derive(Debug)]
pub(super) struct Julia;

impl Syntax for Julia {
    fn number(&self, x: f64) -> String {
        format!("{x:?}")
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

impl Script for Julia {
    fn syntax(&self) -> &dyn Syntax {
        self
    }

    fn marks(&self) -> Marks {
        Marks { first_index: 1, brackets: ['[', ']'], end: "", comment: '#', entry: ["(", "),"] }
    }

    fn begin_of_list(&self, name: &str) -> String {
        format!("const {} = [", name.to_uppercase())
    }

    fn zeros(&self, n: usize, n_columns: Option<usize>, arguments: &[Group]) -> String {
        let types = arguments.iter().map(|group| match group {
            Group::Time => "typeof(t)".to_owned(),
            _ => format!("eltype({})", group.letter()),
        });
        let number = format!("float(promote_type({}))", types.collect::<Vec<_>>().join(", "));
        match n_columns {
            Some(columns) => format!("zeros({number}, {}, {columns})", n / columns),
            None => format!("zeros({number}, {n})"),
        }
    }

    fn definition(&self, name: &str, results: &[&str], arguments: &[Group], about: &str, lines: &[String]) -> String {
        let (arguments, results) = (names(arguments), results.join(", "));
        format!("\n# {about}\nfunction {name}({arguments})\n{}    return {results}\nend\n", indented(lines))
    }
}

impl Julia {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let comment: String =
            title(source).iter().map(|line| format!("# {line}").trim_end().to_owned() + "\n").collect();
        let name = file_name(&source.info);
        let module = name[..1].to_uppercase() + &name[1..];
        [
            comment,
            format!("module {module}\n\nusing LinearAlgebra\n"),
            self.lists(source),
            format!("\n# time at which the scene starts, s\nconst START_TIME = {:?}\n", source.start.t),
            "\n# the values of a list, such as PARAMETERS\nvalues(of) = [value for (_, _, value) in of]\n".to_owned(),
            self.functions(source),
            if solves(source) { SOLVED.to_owned() } else { String::new() },
            self.solution(source),
            "\nend\n".to_owned(),
        ]
        .concat()
    }
}
