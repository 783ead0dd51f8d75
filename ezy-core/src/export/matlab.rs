//! MATLAB and GNU Octave: one function, which returns the others.

use crate::scalar::Pair;

use super::Source;
use super::expression::Syntax;
use super::head::{file_name, title};
use super::kernels::Group;
use super::script::{Marks, Script, indented, names, solves};

/// The language.
#[derive(Debug)]
pub(super) struct Matlab;

impl Syntax for Matlab {
    fn number(&self, x: f64) -> String {
        if x.fract() == 0.0 && x < 1e15 { format!("{x}") } else { format!("{x:?}") }
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

impl Script for Matlab {
    fn syntax(&self) -> &dyn Syntax {
        self
    }

    fn marks(&self) -> Marks {
        Marks { first_index: 1, brackets: ['(', ')'], end: ";", comment: '%', entry: ["", ""] }
    }

    fn quoted(&self, text: &str) -> String {
        format!("'{}'", text.replace('\'', "''"))
    }

    fn begin_of_list(&self, name: &str) -> String {
        format!("scene.list.{name} = {{")
    }

    fn end_of_list(&self) -> &'static str {
        "};"
    }

    fn zeros(&self, n: usize, n_columns: Option<usize>, _: &[Group]) -> String {
        n_columns.map_or_else(|| format!("zeros({n}, 1)"), |columns| format!("zeros({}, {columns})", n / columns))
    }

    fn definition(&self, name: &str, results: &[&str], arguments: &[Group], about: &str, lines: &[String]) -> String {
        let results = match results {
            [one] => (*one).to_owned(),
            _ => format!("[{}]", results.join(", ")),
        };
        format!("\nfunction {results} = {name}({})\n    % {about}\n{}end\n", names(arguments), indented(lines))
    }

    fn solve(&self) -> String {
        "[acceleration, multiplier] = solved(mass, jacobian, force, right_side);".to_owned()
    }
}

impl Matlab {
    pub(super) fn file(&self, source: &Source<'_>) -> String {
        let name = file_name(&source.info);
        let comment: String =
            title(source).iter().map(|line| format!("% {line}").trim_end().to_owned() + "\n").collect();
        let solution = self.solution(source);
        let solved = (!solution.is_empty()).then_some("accelerations");
        let handles = source.kernels.all().map(|kernel| kernel.name).chain(solved);
        [
            format!("function scene = {name}()\n{comment}"),
            format!("%\n% scene = {name}(); c = scene.constants(scene.values(scene.list.parameters));\n"),
            self.lists(source),
            format!("\n% time at which the scene starts, s\nscene.start_time = {};\n", source.start.t),
            "\nscene.values = @(of) cell2mat(of(:, 3));\n".to_owned(),
            handles.map(|name| format!("scene.{name} = @{name};\n")).collect(),
            "end\n".to_owned(),
            self.functions(source),
            if solves(source) { SOLVED.to_owned() } else { String::new() },
            solution,
        ]
        .concat()
    }
}
