//! Expressions as text, LaTeX and MathML, built together from one expression.

use super::coefficient::{Coefficient, CoefficientId, CoefficientNode};
use super::sum::{Algebra, Atom, AtomId, MonomialId, SumId, Symbol};
use crate::function::Function;

/// One expression in three notations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Printed {
    pub text: String,
    pub latex: String,
    pub mathml: String,
    level: Level,
    /// Where a line may end.
    pub(super) breaks: Vec<Break>,
}

/// A place between two terms of a sum, or two items of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Break {
    /// Where a line ends first: 0.
    pub depth: usize,
    /// Parentheses that are open there.
    pub n_open: usize,
    /// Bytes before it in each notation.
    pub text: usize,
    pub latex: usize,
    pub mathml: usize,
}

/// A number of more signs is written with a power of ten: a double has 17 digits, a sign, a point and some zeros.
const LONGEST_NUMBER: usize = 24;

/// How tightly the outermost operation binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Power,
    Atom,
}

/// Names of symbols and parameters.
pub trait Names {
    fn symbol(&self, symbol: Symbol) -> Printed;
    fn parameter(&self, index: usize) -> Printed;
    /// What stands for a coefficient, and whether it is what its negative is called.
    fn coefficient(&self, id: CoefficientId) -> Option<(bool, Printed)> {
        let _ = id;
        None
    }
    /// What stands for a sum within another expression, if it shall not be `written_out`.
    fn abbreviation(&self, sum: SumId, written_out: &Printed) -> Option<Printed> {
        let _ = (sum, written_out);
        None
    }
}

impl Printed {
    pub fn atom(text: impl Into<String>, latex: impl Into<String>, mathml: impl Into<String>) -> Self {
        Self { text: text.into(), latex: latex.into(), mathml: mathml.into(), level: Level::Atom, breaks: Vec::new() }
    }

    fn number(x: f64) -> Self {
        let (text, short) = (format!("{x}"), format!("{x:e}"));
        match short.split_once('e') {
            Some((digits, power)) if text.len() > LONGEST_NUMBER => Self::atom(
                short.clone(),
                format!("{digits} \\cdot 10^{{{power}}}"),
                format!("<mrow><mn>{digits}</mn><mo>·</mo><msup><mn>10</mn><mn>{power}</mn></msup></mrow>"),
            ),
            _ => Self::atom(text.clone(), text.clone(), format!("<mn>{text}</mn>")),
        }
    }

    fn in_parentheses(self) -> Self {
        let mut out = Self::atom("(", "\\left(", "<mrow><mo>(</mo>");
        out.append(&self, 1);
        out.push(")", "\\right)", "<mo>)</mo></mrow>");
        out
    }

    /// Writes signs behind.
    pub fn push(&mut self, text: &str, latex: &str, mathml: &str) {
        self.text += text;
        self.latex += latex;
        self.mathml += mathml;
    }

    /// A line may end here.
    pub fn push_break(&mut self) {
        self.breaks.push(Break {
            depth: 0,
            n_open: 0,
            text: self.text.len(),
            latex: self.latex.len(),
            mathml: self.mathml.len(),
        });
    }

    /// Writes an expression behind, within so many pairs of parentheses that begin here.
    fn append(&mut self, other: &Self, n_open: usize) {
        let [text, latex, mathml] = [self.text.len(), self.latex.len(), self.mathml.len()];
        self.breaks.extend(other.breaks.iter().map(|at| Break {
            depth: at.depth + n_open,
            n_open: at.n_open + n_open,
            text: at.text + text,
            latex: at.latex + latex,
            mathml: at.mathml + mathml,
        }));
        self.push(&other.text, &other.latex, &other.mathml);
    }

    /// Writes an item of a list behind, in which lines end last.
    pub fn append_item(&mut self, item: &Self) {
        let n = self.breaks.len();
        self.append(item, 0);
        self.breaks[n..].iter_mut().for_each(|at| at.depth += 1);
    }

    fn at_least(self, level: Level) -> Self {
        if self.level < level { self.in_parentheses() } else { self }
    }
}

/// A sum as an expression; zero prints as 0.
pub fn print(algebra: &Algebra, names: &impl Names, sum: SumId) -> Printed {
    Printer { algebra, names, defined: None }.sum(sum)
}

/// What a name stands for, without that name.
pub fn print_definition(algebra: &Algebra, names: &impl Names, sum: SumId) -> Printed {
    Printer { algebra, names, defined: algebra.as_coefficient(sum).map(|k| k.id) }.sum(sum)
}

struct Printer<'a, N> {
    algebra: &'a Algebra,
    names: &'a N,
    /// The coefficient that is defined, which is not printed by its name.
    defined: Option<CoefficientId>,
}

impl<N: Names> Printer<'_, N> {
    fn sum(&self, sum: SumId) -> Printed {
        let terms = self.algebra.terms(sum);
        if terms.is_empty() {
            return Printed::number(0.0);
        }
        add(terms.iter().map(|&(monomial, k)| self.term(k, monomial)).collect())
    }

    /// A sum within another expression.
    fn inner(&self, sum: SumId) -> Printed {
        let written_out = self.sum(sum);
        self.names.abbreviation(sum, &written_out).unwrap_or(written_out)
    }

    /// Whether it is subtracted; coefficient, plain symbols, then functions: the order in which such terms are written by hand.
    fn term(&self, k: Coefficient, monomial: MonomialId) -> (bool, Printed) {
        let mut factors = self.algebra.monomial(monomial).clone();
        factors.sort_by_key(|&(atom, _)| (!matches!(self.algebra.atom(atom), Atom::Symbol(_)), atom));
        let (mut top, mut bottom) = (Vec::new(), Vec::new());
        let negative = k.negative ^ self.coefficient_factors(k.id, &mut top, &mut bottom);
        for (atom, n) in factors {
            let factor = self.power(atom, n.abs());
            if n > 0 { top.push(factor) } else { bottom.push(factor) }
        }
        (negative, quotient(product(top), bottom))
    }

    fn power(&self, atom: AtomId, n: i32) -> Printed {
        let squared_function = match self.algebra.atom(atom) {
            Atom::Sin(angle) if n > 1 => Some((Function::Sin, angle)),
            Atom::Cos(angle) if n > 1 => Some((Function::Cos, angle)),
            _ => None,
        };
        if let Some((function, angle)) = squared_function {
            return call(function, Some(n), vec![self.inner(*angle)]);
        }
        let base = match self.algebra.atom(atom) {
            Atom::Symbol(symbol) => self.names.symbol(*symbol),
            Atom::Sin(angle) => call(Function::Sin, None, vec![self.inner(*angle)]),
            Atom::Cos(angle) => call(Function::Cos, None, vec![self.inner(*angle)]),
            Atom::Call(function, arguments) => {
                call(*function, None, arguments.iter().map(|&x| self.inner(x)).collect())
            }
            Atom::Group(sum) => self.inner(*sum).at_least(Level::Atom),
        };
        if n == 1 { base } else { raise(base, n) }
    }

    fn coefficient(&self, k: Coefficient) -> Printed {
        add(vec![self.term(k, MonomialId::ONE)])
    }

    /// Splits a coefficient's magnitude into factors above and below the line; whether these are its negative.
    fn coefficient_factors(&self, id: CoefficientId, top: &mut Vec<Printed>, bottom: &mut Vec<Printed>) -> bool {
        let named = if self.defined == Some(id) { None } else { self.names.coefficient(id) };
        if let Some((negative, name)) = named {
            top.push(name);
            return negative;
        }
        let factor = match self.algebra.coefficients.node(id) {
            CoefficientNode::Number(1.0) | CoefficientNode::Conversion { .. } => return false,
            CoefficientNode::Number(x) => Printed::number(*x),
            CoefficientNode::Pi => Printed::atom("pi", "\\pi", "<mi>π</mi>"),
            CoefficientNode::Parameter(index) => self.names.parameter(*index),
            CoefficientNode::Add(a, b) => add([a, b].map(|&k| self.term(k, MonomialId::ONE)).into()),
            CoefficientNode::Mul(a, b) => {
                return self.coefficient_factors(*a, top, bottom) ^ self.coefficient_factors(*b, top, bottom);
            }
            CoefficientNode::Div(a, b) => {
                return self.coefficient_factors(*a, top, bottom) ^ self.coefficient_factors(*b, bottom, top);
            }
            CoefficientNode::Call(function, arguments) => {
                call(*function, None, arguments.iter().map(|&x| self.coefficient(x)).collect())
            }
        };
        top.push(factor);
        false
    }
}

fn add(parts: Vec<(bool, Printed)>) -> Printed {
    let single = parts.len() == 1;
    let mut out = Printed::atom("", "", "");
    out.level = Level::Sum;
    for (i, (negative, part)) in parts.into_iter().enumerate() {
        if single && !negative {
            return part;
        }
        let part = if negative { part.at_least(Level::Product) } else { part };
        let (sign, mark) = match (i, negative) {
            (0, false) => ("", ""),
            (0, true) => ("-", "<mo>−</mo>"),
            (_, false) => (" + ", "<mo>+</mo>"),
            (_, true) => (" - ", "<mo>−</mo>"),
        };
        if i > 0 {
            out.push_break();
        }
        out.push(sign, sign, mark);
        out.append(&part, 0);
    }
    out
}

fn product(factors: Vec<Printed>) -> Printed {
    let mut powers: Vec<(Printed, i32)> = Vec::new();
    for factor in factors {
        match powers.iter_mut().find(|(base, _)| *base == factor) {
            Some((_, n)) => *n += 1,
            None => powers.push((factor, 1)),
        }
    }
    // a number is written before letters
    powers.sort_by_key(|(base, _)| !base.text.starts_with(|sign: char| sign.is_ascii_digit()));
    let mut factors = powers.into_iter().map(|(base, n)| if n == 1 { base } else { raise(base, n) });
    let Some(first) = factors.next() else { return Printed::number(1.0) };
    let Some(second) = factors.next() else { return first };
    let mut out = first.at_least(Level::Product);
    for factor in std::iter::once(second).chain(factors) {
        out.push("*", " \\, ", "<mspace width=\"0.17em\"/>");
        out.append(&factor.at_least(Level::Power), 0);
    }
    out.level = Level::Product;
    out
}

fn quotient(top: Printed, bottom: Vec<Printed>) -> Printed {
    if bottom.is_empty() {
        return top;
    }
    let bottom = product(bottom);
    Printed {
        latex: format!("\\frac{{{}}}{{{}}}", top.latex, bottom.latex),
        mathml: format!("<mfrac><mrow>{}</mrow><mrow>{}</mrow></mfrac>", top.mathml, bottom.mathml),
        text: format!("{}/{}", top.at_least(Level::Product).text, bottom.at_least(Level::Power).text),
        level: Level::Product,
        breaks: Vec::new(),
    }
}

fn raise(base: Printed, n: i32) -> Printed {
    let base = base.at_least(Level::Atom);
    // an exponent stands above the index, not behind it
    let indexed = base.mathml.strip_prefix("<msub>").and_then(|inner| inner.strip_suffix("</msub>"));
    let mathml = match indexed {
        Some(inner) => format!("<msubsup>{inner}<mn>{n}</mn></msubsup>"),
        None => format!("<msup><mrow>{}</mrow><mn>{n}</mn></msup>", base.mathml),
    };
    Printed {
        text: format!("{}^{n}", base.text),
        latex: format!("{}^{{{n}}}", base.latex),
        mathml,
        level: Level::Power,
        breaks: Vec::new(),
    }
}

fn call(function: Function, power: Option<i32>, arguments: Vec<Printed>) -> Printed {
    let name = function.name();
    let list = |part: fn(&Printed) -> &String, separator: &str| {
        arguments.iter().map(|a| part(a).clone()).collect::<Vec<_>>().join(separator)
    };
    let (text, latex, mathml) = (list(|a| &a.text, ", "), list(|a| &a.latex, ", "), list(|a| &a.mathml, "<mo>,</mo>"));
    if function == Function::Sqrt {
        return Printed::atom(
            format!("sqrt({text})"),
            format!("\\sqrt{{{latex}}}"),
            format!("<msqrt><mrow>{mathml}</mrow></msqrt>"),
        );
    }
    let bare = arguments.len() == 1 && arguments.iter().all(|a| a.level == Level::Atom);
    let latex = if bare { format!("{{{latex}}}") } else { format!("\\left({latex}\\right)") };
    let mathml = if bare {
        format!("<mspace width=\"0.17em\"/>{mathml}")
    } else {
        format!("<mrow><mo>(</mo>{mathml}<mo>)</mo></mrow>")
    };
    let latex_name = match function {
        Function::Sin
        | Function::Cos
        | Function::Tan
        | Function::Exp
        | Function::Ln
        | Function::Tanh
        | Function::Min
        | Function::Max => {
            format!("\\{name}")
        }
        _ => format!("\\operatorname{{{name}}}"),
    };
    let exponent = power.map(|n| format!("^{{{n}}}")).unwrap_or_default();
    let mathml_name = match power {
        Some(n) => format!("<msup><mi>{name}</mi><mn>{n}</mn></msup>"),
        None => format!("<mi>{name}</mi>"),
    };
    Printed {
        text: power.map_or_else(|| format!("{name}({text})"), |n| format!("{name}({text})^{n}")),
        latex: format!("{latex_name}{exponent}{latex}"),
        mathml: format!("<mrow>{mathml_name}<mo>&#x2061;</mo>{mathml}</mrow>"),
        level: Level::Power,
        breaks: Vec::new(),
    }
}
