//! Reads printed expressions back and computes them.

use std::marker::PhantomData;

use crate::function::Function;

/// How a notation writes what is more than a number, a sign or a sum.
pub trait Notation: Sized {
    /// Between factors.
    const TIMES: &'static str;
    const OPEN: &'static str;
    const CLOSE: &'static str;
    /// Around an exponent.
    const EXPONENT: [&'static str; 2];
    /// A fraction, a root, a call or a name.
    fn primary(reader: &mut Reader<'_, Self>) -> f64;
}

/// `sin(x1)^2/p0`
pub struct Text;

/// `\frac{\sin^{2}{x_{1}}}{p_{0}}`
pub struct Latex;

/// What is left to read.
pub struct Reader<'a, N> {
    left: &'a str,
    name: &'a dyn Fn(char, usize) -> f64,
    notation: PhantomData<N>,
}

/// The value of an expression; `name` knows x₁ and p₀.
pub fn value_of<N: Notation>(text: &str, name: &dyn Fn(char, usize) -> f64) -> f64 {
    let mut reader = Reader::<N> { left: text, name, notation: PhantomData };
    let value = reader.sum();
    assert!(reader.left.is_empty(), "`{}` is left of `{text}`", reader.left);
    value
}

impl<N: Notation> Reader<'_, N> {
    fn takes(&mut self, what: &str) -> bool {
        let rest = self.left.strip_prefix(what);
        self.left = rest.unwrap_or(self.left);
        rest.is_some()
    }

    fn expect(&mut self, what: &str) {
        assert!(self.takes(what), "`{what}` in front of `{}`", self.left);
    }

    fn digits(&mut self) -> &str {
        let end = self.left.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.left.len());
        let (digits, rest) = self.left.split_at(end);
        self.left = rest;
        digits
    }

    fn word(&mut self) -> String {
        let end = self.left.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.left.len());
        // `atan2` alone ends in a digit
        let end = if self.left.starts_with("atan2") { 5 } else { end };
        let (word, rest) = self.left.split_at(end);
        self.left = rest;
        word.to_owned()
    }

    fn sum(&mut self) -> f64 {
        let mut total = if self.takes("-") { -self.product() } else { self.product() };
        loop {
            if self.takes(" + ") {
                // a part that is a sum itself may begin with a sign
                total += if self.takes("-") { -self.product() } else { self.product() };
            } else if self.takes(" - ") {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.power();
        loop {
            if self.takes(N::TIMES) {
                product *= self.power();
            } else if self.takes("/") {
                product /= self.power();
            } else {
                return product;
            }
        }
    }

    fn power(&mut self) -> f64 {
        let base = if self.takes(N::OPEN) {
            let value = self.sum();
            self.expect(N::CLOSE);
            value
        } else if self.left.starts_with(|c: char| c.is_ascii_digit()) {
            let end = self.left.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(self.left.len());
            let (number, rest) = self.left.split_at(end);
            self.left = rest;
            number.parse().unwrap_or_else(|error| panic!("`{number}`: {error}"))
        } else {
            N::primary(self)
        };
        self.exponent().map_or(base, |n| base.powi(n))
    }

    fn exponent(&mut self) -> Option<i32> {
        let [open, close] = N::EXPONENT;
        self.takes(open).then(|| {
            let n = self.digits().parse().expect("an exponent is a whole number");
            self.expect(close);
            n
        })
    }

    /// Up to the closing sign.
    fn arguments(&mut self, close: &str) -> Vec<f64> {
        let mut arguments = vec![self.sum()];
        while self.takes(", ") {
            arguments.push(self.sum());
        }
        self.expect(close);
        arguments
    }

    fn index(&mut self) -> usize {
        self.digits().parse().expect("a name has an index")
    }
}

fn function(name: &str) -> Function {
    use Function::{Abs, Acos, Asin, Atan2, Cos, Exp, Ln, Max, Min, Pow, Sign, Sin, Sqrt, Tan, Tanh};
    let all = [Sin, Cos, Tan, Asin, Acos, Atan2, Sqrt, Exp, Ln, Tanh, Abs, Min, Max, Sign, Pow];
    *all.iter().find(|function| function.name() == name).unwrap_or_else(|| panic!("`{name}` is no function"))
}

impl Notation for Text {
    const TIMES: &'static str = "*";
    const OPEN: &'static str = "(";
    const CLOSE: &'static str = ")";
    const EXPONENT: [&'static str; 2] = ["^", ""];

    fn primary(reader: &mut Reader<'_, Self>) -> f64 {
        let word = reader.word();
        if word == "pi" {
            return std::f64::consts::PI;
        }
        if reader.takes("(") {
            let arguments = reader.arguments(")");
            return function(&word).evaluate(&arguments);
        }
        assert_eq!(word.len(), 1, "`{word}` in front of `{}`", reader.left);
        let letter = word.chars().next().unwrap_or(' ');
        let i = reader.index();
        (reader.name)(letter, i)
    }
}

impl Notation for Latex {
    const TIMES: &'static str = " \\, ";
    const OPEN: &'static str = "\\left(";
    const CLOSE: &'static str = "\\right)";
    const EXPONENT: [&'static str; 2] = ["^{", "}"];

    fn primary(reader: &mut Reader<'_, Self>) -> f64 {
        if reader.takes("\\pi") {
            return std::f64::consts::PI;
        }
        if reader.takes("\\frac{") {
            let top = reader.arguments("}")[0];
            reader.expect("{");
            return top / reader.arguments("}")[0];
        }
        if reader.takes("\\sqrt{") {
            return reader.arguments("}")[0].sqrt();
        }
        if reader.takes("\\") {
            let mut word = reader.word();
            if word == "operatorname" {
                reader.expect("{");
                word = reader.word();
                reader.expect("}");
            }
            let n = reader.exponent();
            let arguments = if reader.takes("{") {
                reader.arguments("}")
            } else {
                reader.expect("\\left(");
                reader.arguments("\\right)")
            };
            let value = function(&word).evaluate(&arguments);
            return n.map_or(value, |n| value.powi(n));
        }
        let letter = reader.left.chars().next().unwrap_or(' ');
        reader.expect(&letter.to_string());
        reader.expect("_{");
        let i = reader.index();
        reader.expect("}");
        (reader.name)(letter, i)
    }
}
