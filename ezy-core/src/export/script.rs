//! What languages without declarations of types have in common: Python, Julia, MATLAB.

use super::Source;
use super::expression::Syntax;
use super::head::{Entry, List, lists};
use super::kernels::{Group, Kernel};
use super::statements::body;

/// What stands around a text.
pub(super) struct Marks {
    /// Index of a first element.
    pub first_index: usize,
    /// Around an index.
    pub brackets: [char; 2],
    /// Behind a statement.
    pub end: &'static str,
    /// Before a comment.
    pub comment: char,
    /// Around an entry of a list.
    pub entry: [&'static str; 2],
}

pub(super) trait Script: Syntax {
    fn marks(&self) -> Marks;

    /// A text in quotes.
    fn quoted(&self, text: &str) -> String {
        format!("{text:?}")
    }

    /// The line that begins the list of this name; [`Script::end_of_list`] ends it.
    fn begin_of_list(&self, name: &str) -> String;

    fn end_of_list(&self) -> &'static str {
        "]"
    }

    /// A vector, or a matrix, of zeros for what depends on `arguments`.
    fn zeros(&self, n: usize, n_columns: Option<usize>, arguments: &[Group]) -> String;

    /// A function with its statements.
    fn definition(&self, name: &str, results: &[&str], arguments: &[Group], about: &str, lines: &[String]) -> String;

    /// All lists of a file.
    fn lists(&self, source: &Source<'_>) -> String {
        lists(source).iter().map(|list| self.list(list)).collect()
    }

    fn list(&self, list: &List) -> String {
        let Marks { comment, entry: [open, close], .. } = self.marks();
        let value = if list.has_values { ", value" } else { "" };
        let head = format!("\n{comment} {}: name, unit{value}\n{}\n", list.about, self.begin_of_list(list.name));
        let line = |entry: &Entry| {
            let value = if list.has_values { format!(", {}", self.signed(entry.value)) } else { String::new() };
            let about = match entry.documentation.as_str() {
                "" => String::new(),
                text => format!(" {comment} {text}"),
            };
            format!("    {open}{}, {}{value}{close}{about}\n", self.quoted(&entry.name), self.quoted(&entry.unit))
        };
        head + &list.entries.iter().map(line).collect::<String>() + self.end_of_list() + "\n"
    }

    /// A number with its sign.
    fn signed(&self, x: f64) -> String {
        format!("{}{}", if x.is_sign_negative() { "-" } else { "" }, self.number(x.abs()))
    }

    /// All functions but that of [`Script::solution`].
    fn functions(&self, source: &Source<'_>) -> String {
        source.kernels.all().map(|kernel| self.kernel(source, kernel)).collect()
    }

    fn kernel(&self, source: &Source<'_>, kernel: &Kernel) -> String {
        let Marks { first_index, brackets: [open, close], end, .. } = self.marks();
        let body = body(self.syntax(), &source.info, &source.kernels, kernel);
        let mut lines: Vec<String> = body.named.iter().map(|(name, value)| format!("{name} = {value}{end}")).collect();
        for (returned, entries) in kernel.returned.iter().zip(&body.returned) {
            let name = returned.name;
            let zeros = self.zeros(returned.values.len(), returned.n_columns, &kernel.arguments);
            lines.push(format!("{name} = {zeros}{end}"));
            lines.extend(entries.iter().map(|&((row, column), ref value)| {
                let column = column.map_or_else(String::new, |column| format!(", {}", column + first_index));
                format!("{name}{open}{}{column}{close} = {value}{end}", row + first_index)
            }));
        }
        let results: Vec<&str> = kernel.returned.iter().map(|returned| returned.name).collect();
        self.definition(kernel.name, &results, &kernel.arguments, kernel.about, &lines)
    }

    fn syntax(&self) -> &dyn Syntax;

    /// The accelerations of a scene without a generated elimination, by the function `solved` of the file; nothing in others.
    fn solution(&self, source: &Source<'_>) -> String {
        if !solves(source) {
            return String::new();
        }
        let (arguments, end) = (source.kernels.variables.of_motion(), self.marks().end);
        let list = names(&arguments);
        let lines = [
            format!("mass = mass_matrix(c){end}"),
            format!("force = applied_force({list}){end}"),
            format!("jacobian = velocity_jacobian({list}){end}"),
            format!("right_side = -convective_term({list}){end}"),
            self.solve(),
        ];
        let results = ["acceleration", "multiplier"];
        self.definition("accelerations", &results, &arguments, "Accelerations and multipliers.", &lines)
    }

    /// The statement that calls `solved` with `mass, jacobian, force, right_side`.
    fn solve(&self) -> String {
        format!("acceleration, multiplier = solved(mass, jacobian, force, right_side){}", self.marks().end)
    }
}

/// Whether the file solves a full matrix.
pub(super) fn solves(source: &Source<'_>) -> bool {
    source.kernels.accelerations.is_none()
}

/// Arguments as they are listed.
pub(super) fn names(arguments: &[Group]) -> String {
    arguments.iter().map(|group| group.letter()).collect::<Vec<_>>().join(", ")
}

/// Lines, each further in.
pub(super) fn indented(lines: &[String]) -> String {
    lines.iter().map(|line| format!("    {line}\n")).collect()
}
