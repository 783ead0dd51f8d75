//! Long expressions in lines: at the signs of a sum, outside of parentheses where there are some.

use super::print::{Break, Printed};

impl Printed {
    /// Lines of at most so many signs, where there are signs of sums to break at.
    pub fn text_lines(&self, width: usize) -> Vec<String> {
        let ends = self.ends(width, usize::MAX);
        cut(&self.text, ends.iter().map(|end| end.text)).into_iter().map(str::to_owned).collect()
    }

    /// The same lines; parentheses that go on close and open again unseen.
    pub fn latex_lines(&self, width: usize) -> Vec<String> {
        let ends = self.ends(width, usize::MAX);
        let lines = cut(&self.latex, ends.iter().map(|end| end.latex)).into_iter().enumerate();
        let open = |i: Option<usize>| i.and_then(|i| ends.get(i)).map_or(0, |end| end.n_open);
        let line = |(i, line): (usize, &str)| {
            let (before, after) = (open(i.checked_sub(1)), open(Some(i)));
            // behind nothing a sign would stand as close as that of a number
            let gap = if i > 0 && line.starts_with(['+', '-']) { "{} " } else { "" };
            format!("{}{gap}{line}{}", "\\left.".repeat(before), "\\right.".repeat(after))
        };
        lines.map(line).collect()
    }

    /// Lines outside of parentheses, whose marks enclose what is within.
    pub fn mathml_lines(&self, width: usize) -> Vec<String> {
        let ends = self.ends(width, 0);
        let ends = ends.iter().map(|end| end.mathml);
        // a sign that begins a line would stand as close as that of a number
        let line = |(i, line): (usize, &str)| match line.strip_prefix("<mo>") {
            Some(rest) if i > 0 => format!("<mrow><mo form=\"infix\">{rest}</mrow>"),
            _ => format!("<mrow>{line}</mrow>"),
        };
        cut(&self.mathml, ends).into_iter().enumerate().map(line).collect()
    }

    /// Each line ends at the last of its outermost places.
    fn ends(&self, width: usize, deepest: usize) -> Vec<Break> {
        let mut ends = Vec::new();
        let mut start = 0;
        let is_within = |start: usize, end: usize| self.text[start..end].trim().chars().count() <= width;
        while !is_within(start, self.text.len()) {
            let places = || self.breaks.iter().filter(|at| at.text > start && at.depth <= deepest);
            let fitting =
                places().filter(|at| is_within(start, at.text)).min_by_key(|at| (at.depth, usize::MAX - at.text));
            let Some(end) = fitting.or_else(|| places().min_by_key(|at| at.text)) else { break };
            ends.push(*end);
            start = end.text;
        }
        ends
    }
}

fn cut(text: &str, ends: impl Iterator<Item = usize>) -> Vec<&str> {
    let mut start = 0;
    let mut lines = Vec::new();
    for end in ends.chain([text.len()]) {
        lines.push(text[start..end].trim());
        start = end;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::print::{Names, print};
    use crate::symbolic::{Algebra, SumId, Symbol};

    const WIDTH: usize = 30;

    struct Letters;

    impl Names for Letters {
        fn symbol(&self, symbol: Symbol) -> Printed {
            let name = format!("symbol{}", symbol.0);
            Printed::atom(name.clone(), name.clone(), name)
        }
        fn parameter(&self, index: usize) -> Printed {
            let name = format!("p{index}");
            Printed::atom(name.clone(), name.clone(), name)
        }
    }

    /// Sums of sums, with signs.
    fn nested(a: &mut Algebra, first: u32, depth: u32) -> SumId {
        let mut sum = a.symbol(Symbol(first));
        for i in 1..6 {
            let mut term = a.symbol(Symbol(first + i));
            if depth > 0 {
                let inner = nested(a, first + 10 * (i + 1), depth - 1);
                let squared = a.power(inner, 2);
                term = a.mul(term, squared);
            }
            sum = if i % 2 == 0 { a.add(sum, term) } else { a.sub(sum, term) };
        }
        sum
    }

    #[test]
    fn invariant_lines_without_their_breaks_are_the_expression() {
        for depth in 0..2 {
            let mut algebra = Algebra::default();
            let sum = nested(&mut algebra, 1, depth);
            let printed = print(&algebra, &Letters, sum);
            let text = printed.text_lines(WIDTH);
            assert!(text.len() > 1);
            assert_eq!(text.join(" "), printed.text);
            let latex = printed.latex_lines(WIDTH);
            let joined = latex.join(" ").replace("\\right. \\left.", " ").replace(" {} ", " ");
            assert_eq!(
                joined.split_whitespace().collect::<Vec<_>>(),
                printed.latex.split_whitespace().collect::<Vec<_>>()
            );
            assert_eq!(latex.len(), text.len());
            let mathml = printed.mathml_lines(WIDTH).concat().replace(" form=\"infix\"", "");
            let mathml = mathml.replace("<mrow>", "").replace("</mrow>", "");
            assert_eq!(mathml, printed.mathml.replace("<mrow>", "").replace("</mrow>", ""));
        }
    }

    #[test]
    fn analytic_line_ends_outside_of_parentheses_where_it_can() {
        let mut sum = Printed::atom("aaaa", "aaaa", "");
        sum.push_break();
        sum.push(" + bbbb*(cccc", " + bbbb*(cccc", "");
        sum.breaks.push(Break { depth: 1, n_open: 1, text: 17, latex: 17, mathml: 0 });
        sum.push(" - dddd)", " - dddd)", "");
        assert_eq!(sum.text_lines(20), ["aaaa", "+ bbbb*(cccc - dddd)"]);
        assert_eq!(sum.text_lines(12), ["aaaa", "+ bbbb*(cccc", "- dddd)"]);
        assert_eq!(sum.latex_lines(12)[1..], ["{} + bbbb*(cccc\\right.", "\\left.{} - dddd)"]);
        assert_eq!(sum.text_lines(100), ["aaaa + bbbb*(cccc - dddd)"]);
    }
}
