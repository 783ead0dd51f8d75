//! Programs as Rust statements.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote};

use super::constants::{Constants, RESERVED};
use super::numbers::Numbers;
use super::parts::{LONGEST_WHOLE, Parts, Writing};
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::symbolic::Symbol;
use crate::symbolic::program::{Node, NodeId, Program};
use crate::work;

/// What symbols and constants of a scene are called.
#[derive(Clone, Copy)]
pub struct Vocabulary<'a> {
    pub symbols: &'a Symbols,
    pub constants: &'a Constants<'a>,
    /// Outputs are computed where their operands are, not where they are written. Series have many outputs: their operands
    /// would fill the registers, which costs up to 2 % more instructions of a step.
    pub outputs_early: bool,
}

/// Statements of a kernel and the expression of each output.
pub struct Body {
    pub statements: TokenStream,
    pub outputs: Vec<Expression>,
}

/// How tightly the outermost operator of an expression binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// An expression of emitted code.
#[derive(Debug, Clone)]
pub struct Expression {
    tokens: TokenStream,
    binding: Binding,
}

impl Expression {
    pub fn atom(tokens: TokenStream) -> Self {
        Self { tokens, binding: Binding::Atom }
    }

    pub fn sum(tokens: TokenStream) -> Self {
        Self { tokens, binding: Binding::Sum }
    }

    /// In brackets if its outermost operator binds less tightly.
    pub fn within(&self, binding: Binding) -> TokenStream {
        let tokens = &self.tokens;
        if self.binding < binding { quote!((#tokens)) } else { tokens.clone() }
    }
}

impl ToTokens for Expression {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.tokens.to_tokens(tokens);
    }
}

/// Writes a program, with coordinates and velocities at the indices that `place` says; `other` says where inputs besides those
/// and time are found, `sines` where sine and cosine of a coordinate stand if they are known.
pub fn body(
    numbers: Numbers,
    program: &Program,
    vocabulary: Vocabulary<'_>,
    place: &dyn Fn(usize) -> TokenStream,
    other: &dyn Fn(Symbol) -> TokenStream,
    sines: &dyn Fn(usize) -> Option<TokenStream>,
) -> Body {
    let (live, sources) = (program.live(), Sources { place, other, sines });
    let in_one = Writing::new(numbers, program, &live, vocabulary.outputs_early);
    let is_long = live.iter().filter(|&&id| in_one.is_statement(id)).count() > LONGEST_WHOLE;
    let writing = if is_long { Writing::new(numbers, program, &live, true) } else { in_one };
    let parts = is_long.then(|| Parts::new(program, &live, &writing));
    let (names, taken, passed) = (BTreeMap::new(), BTreeSet::new(), BTreeMap::new());
    let scope = live.clone();
    let mut writer = Writer { numbers, program, vocabulary, sources, live, scope, writing, names, taken, passed };
    let statements = match parts {
        None => writer.in_one(),
        Some(parts) => writer.in_parts(&parts),
    };
    let outputs = program.outputs().iter().map(|output| writer.operand(output.node)).collect();
    Body { statements, outputs }
}

/// Where inputs are found.
struct Sources<'a> {
    /// Coordinates and velocities.
    place: &'a dyn Fn(usize) -> TokenStream,
    other: &'a dyn Fn(Symbol) -> TokenStream,
    sines: &'a dyn Fn(usize) -> Option<TokenStream>,
}

struct Writer<'a> {
    numbers: Numbers,
    program: &'a Program,
    vocabulary: Vocabulary<'a>,
    sources: Sources<'a>,
    live: Vec<NodeId>,
    /// What is computed in the function or closure at hand.
    scope: Vec<NodeId>,
    writing: Writing,
    names: BTreeMap<NodeId, Ident>,
    taken: BTreeSet<String>,
    /// Places of the values that a part passes to later ones.
    passed: BTreeMap<NodeId, usize>,
}

impl Writer<'_> {
    fn in_one(&mut self) -> TokenStream {
        let mut statements = TokenStream::new();
        for id in self.live.clone() {
            statements.extend(self.statement(id));
        }
        statements
    }

    /// Closures one after the other, which pass values through an array.
    fn in_parts(&mut self, parts: &Parts) -> TokenStream {
        let (zero, n_passed) = (self.numbers.literal(0.0), parts.n_passed());
        let mut statements = quote!(let mut passed = [#zero; #n_passed];);
        for part in &parts.0 {
            self.names.clear();
            self.taken.clear();
            self.scope.clone_from(&part.computed);
            let mut inside = TokenStream::new();
            for &id in part.inputs.iter().chain(&part.computed) {
                inside.extend(self.statement(id));
            }
            for &id in &part.passed {
                let (i, name) = (self.passed.len(), self.operand(id));
                inside.extend(quote!(passed[#i] = #name;));
                self.passed.insert(id, i);
            }
            statements.extend(self.numbers.part(&inside));
        }
        self.names.clear();
        statements
    }

    /// A node that is needed.
    fn find(&self, wanted: &Node) -> Option<NodeId> {
        self.program.find(wanted).filter(|id| self.live.binary_search(id).is_ok())
    }

    fn statement(&mut self, id: NodeId) -> TokenStream {
        work::count(1);
        let value = match self.program.node(id) {
            _ if !self.writing.is_statement(id) || self.names.contains_key(&id) => return TokenStream::new(),
            Node::Constant(i) => {
                let place = self.vocabulary.constants.place(*i);
                quote!(c[#place])
            }
            Node::Input(_) if self.is_only_turned(id) => {
                self.declare(id, self.suggestion(id));
                return TokenStream::new();
            }
            Node::Input(symbol) => match self.vocabulary.symbols.meaning(*symbol) {
                Meaning::Time => {
                    self.names.insert(id, Ident::new("t", Span::call_site()));
                    return TokenStream::new();
                }
                Meaning::Coordinate(i) => {
                    let i = (self.sources.place)(i);
                    quote!(q[#i])
                }
                Meaning::Velocity(i) => {
                    let i = (self.sources.place)(i);
                    quote!(v[#i])
                }
                Meaning::Input(i) => quote!(c[#i]),
                Meaning::Named(_) => (self.sources.other)(*symbol),
            },
            Node::Sin(angle) | Node::Cos(angle) => return self.trigonometry(id, *angle),
            _ => self.expression(id).into_token_stream(),
        };
        let name = self.declare(id, self.suggestion(id));
        quote!(let #name = #value;)
    }

    /// Where sine and cosine of an angle stand, if they are known.
    fn known_sines(&self, angle: NodeId) -> Option<TokenStream> {
        let Node::Input(symbol) = self.program.node(angle) else { return None };
        let Meaning::Coordinate(i) = self.vocabulary.symbols.meaning(*symbol) else { return None };
        (self.sources.sines)(i)
    }

    /// Whether it is an angle of which sine and cosine are known, and nothing else is read.
    fn is_only_turned(&self, id: NodeId) -> bool {
        let reads = |user: &Node| !matches!(user, Node::Sin(_) | Node::Cos(_)) && user.operands().contains(&id);
        let is_output = || self.program.outputs().iter().any(|output| output.node == id);
        self.known_sines(id).is_some() && !self.live.iter().any(|&user| reads(self.program.node(user))) && !is_output()
    }

    /// Angles of other sines and cosines to come that depend on nothing that is not known here.
    fn partners(&self, angle: NodeId) -> Vec<NodeId> {
        let to_come = self.scope.iter().filter(|&id| !self.names.contains_key(id));
        let mut angles = vec![angle];
        for &id in to_come {
            if let Node::Sin(other) | Node::Cos(other) = *self.program.node(id)
                && angles.len() < ANGLES_AT_ONCE
                && !angles.contains(&other)
                && self.known_sines(other).is_none()
                && self.is_at_hand(other)
            {
                angles.push(other);
            }
        }
        angles
    }

    /// Whether it is known here, or follows from what is read by sums and products.
    fn is_at_hand(&self, id: NodeId) -> bool {
        match self.program.node(id) {
            _ if self.names.contains_key(&id) => true,
            Node::Input(_) | Node::Constant(_) | Node::Literal(_) => true,
            node @ (Node::Add(..) | Node::Sub(..) | Node::Mul(..) | Node::Neg(_)) => {
                node.operands().iter().all(|&operand| self.is_at_hand(operand))
            }
            _ => false,
        }
    }

    /// What an angle at hand follows from, and the angle.
    fn statements_of(&mut self, id: NodeId) -> TokenStream {
        let mut statements = TokenStream::new();
        if !self.names.contains_key(&id) {
            for operand in self.program.node(id).operands() {
                statements.extend(self.statements_of(operand));
            }
            statements.extend(self.statement(id));
        }
        statements
    }

    /// Names for sine and cosine of an angle, as far as they are needed.
    fn both(&mut self, angle: NodeId) -> TokenStream {
        let label = self.angle_label(angle);
        let [sin, cos] =
            [(Node::Sin(angle), "sin"), (Node::Cos(angle), "cos")].map(|(node, function)| match self.find(&node) {
                Some(node) => self.declare(node, format!("{function}_{label}")).into_token_stream(),
                None => quote!(_),
            });
        quote!((#sin, #cos))
    }

    fn angle_label(&self, angle: NodeId) -> String {
        self.label(angle).filter(|label| label.len() < LONGEST_NAME).unwrap_or_else(|| angle.0.to_string())
    }

    /// One call for a sine and cosine of the same angle, and of others.
    fn trigonometry(&mut self, id: NodeId, angle: NodeId) -> TokenStream {
        let angles = match (self.numbers, self.known_sines(angle)) {
            (Numbers::Any, None) => self.partners(angle),
            _ => Vec::new(),
        };
        if angles.len() > 1 {
            let read: TokenStream = angles.iter().map(|&angle| self.statements_of(angle)).collect();
            let arguments: Vec<_> = angles.iter().map(|&angle| self.operand(angle).into_token_stream()).collect();
            let both: Vec<TokenStream> = angles.iter().map(|&angle| self.both(angle)).collect();
            return quote!(#read let [#(#both),*] = T::sin_cos_of([#(#arguments),*]););
        }
        let (sin, cos) = (self.find(&Node::Sin(angle)), self.find(&Node::Cos(angle)));
        let (number, argument) = (self.numbers.name(), self.operand(angle));
        let label = self.angle_label(angle);
        if let Some(known) = self.known_sines(angle) {
            let mut name = |node: Option<NodeId>, function| match node {
                Some(node) => self.declare(node, format!("{function}_{label}")).into_token_stream(),
                None => quote!(_),
            };
            let (sin, cos) = (name(sin, "sin"), name(cos, "cos"));
            return quote!(let [#sin, #cos] = #known;);
        }
        match (sin, cos) {
            (Some(sin), Some(cos)) => {
                let sin = self.declare(sin, format!("sin_{label}"));
                let cos = self.declare(cos, format!("cos_{label}"));
                quote!(let (#sin, #cos) = #number::sin_cos(#argument);)
            }
            (Some(sin), None) => {
                let sin = self.declare(sin, format!("sin_{label}"));
                quote!(let #sin = #number::sin(#argument);)
            }
            (None, _) => {
                let cos = self.declare(id, format!("cos_{label}"));
                quote!(let #cos = #number::cos(#argument);)
            }
        }
    }

    fn suggestion(&self, id: NodeId) -> String {
        let kind = match self.program.node(id) {
            Node::Input(symbol) if self.program.name(id).is_none() => {
                return self.vocabulary.symbols.code_name(*symbol);
            }
            Node::Constant(i) => return self.vocabulary.constants.name(*i),
            Node::Add(..) => "sum",
            Node::Sub(..) => "difference",
            Node::Mul(..) => "product",
            Node::Div(..) => "quotient",
            _ => "value",
        };
        let name = self.program.name(id).map(str::to_owned);
        let name = name.or_else(|| self.joined(id).filter(|name| name.len() < LONGEST_NAME));
        name.or_else(|| self.program.hint(id).map(str::to_owned)).unwrap_or_else(|| format!("{kind}_{}", id.0))
    }

    /// An operation by its operands.
    fn joined(&self, id: NodeId) -> Option<String> {
        let (a, sign, b) = match self.program.node(id) {
            Node::Mul(a, b) if a == b => return Some(format!("{}_squared", self.label(*a)?)),
            Node::Mul(a, b) => (a, "", b),
            Node::Div(a, b) => (a, "over_", b),
            Node::Add(a, b) => (a, "plus_", b),
            Node::Sub(a, b) => (a, "minus_", b),
            _ => return None,
        };
        Some(format!("{}_{sign}{}", self.label(*a)?, self.label(*b)?))
    }

    /// What an operand is called within the name of an operation: its name if that says what it is, or its factors if it
    /// is a product in place.
    fn label(&self, id: NodeId) -> Option<String> {
        let name = self.names.get(&id).map(Ident::to_string).filter(|name| !name.ends_with(&format!("_{}", id.0)));
        name.or_else(|| match self.program.node(id) {
            Node::Mul(..) => self.joined(id),
            Node::Literal(bits) if f64::from_bits(*bits) == 1.0 => Some("one".to_owned()),
            _ => None,
        })
    }

    fn declare(&mut self, id: NodeId, suggestion: String) -> Ident {
        let mut name = suggestion;
        while RESERVED.contains(&name.as_str()) || !self.taken.insert(name.clone()) {
            name.push('_');
        }
        let ident = Ident::new(&name, Span::mixed_site());
        self.names.insert(id, ident.clone());
        ident
    }

    /// A node where it is read.
    fn operand(&self, id: NodeId) -> Expression {
        if !self.writing.is_statement(id) {
            return self.expression(id);
        }
        let name = self.names.get(&id).map(|name| quote!(#name));
        let value = name.or_else(|| self.passed.get(&id).map(|i| quote!(passed[#i])));
        Expression::atom(value.into_token_stream())
    }

    /// A node from its operands.
    fn expression(&self, id: NodeId) -> Expression {
        let (tokens, binding) = match self.program.node(id) {
            Node::Literal(bits) => (self.numbers.literal(f64::from_bits(*bits)), Binding::Atom),
            Node::Add(a, b) | Node::Sub(a, b) if self.writing.fused.contains_key(&id) => {
                (self.fuse(id, *a, *b), Binding::Atom)
            }
            Node::Add(a, b) => self.infix(*a, quote!(+), *b, Binding::Sum),
            Node::Sub(a, b) => self.infix(*a, quote!(-), *b, Binding::Sum),
            Node::Mul(a, b) => self.infix(*a, quote!(*), *b, Binding::Product),
            Node::Div(a, b) => self.infix(*a, quote!(/), *b, Binding::Product),
            Node::Neg(a) => {
                let a = self.operand(*a).within(Binding::Sign);
                (quote!(-#a), Binding::Sign)
            }
            Node::Call(function, arguments) => {
                let arguments: Vec<TokenStream> =
                    arguments.iter().map(|&a| self.operand(a).into_token_stream()).collect();
                (self.numbers.call(*function, &arguments), Binding::Atom)
            }
            // these have names
            Node::Input(_) | Node::Constant(_) | Node::Sin(_) | Node::Cos(_) => return self.operand(id),
        };
        Expression { tokens, binding }
    }

    /// `a + b` or `a − b` with the product among them.
    fn fuse(&self, id: NodeId, a: NodeId, b: NodeId) -> TokenStream {
        let product = self.writing.fused[&id];
        let Node::Mul(x, y) = *self.program.node(product) else { return TokenStream::new() };
        let (x, y, first, last) = (self.operand(x), self.operand(y), self.operand(a), self.operand(b));
        let (minus_x, minus_last) = (x.within(Binding::Sign), last.within(Binding::Sign));
        match (self.program.node(id), product == b) {
            (Node::Sub(..), true) => quote!(T::fused(-#minus_x, #y, #first)),
            (Node::Sub(..), false) => quote!(T::fused(#x, #y, -#minus_last)),
            (_, true) => quote!(T::fused(#x, #y, #first)),
            (_, false) => quote!(T::fused(#x, #y, #last)),
        }
    }

    fn infix(&self, a: NodeId, operator: TokenStream, b: NodeId, binding: Binding) -> (TokenStream, Binding) {
        let tighter = if binding == Binding::Sum { Binding::Product } else { Binding::Sign };
        let (a, b) = (self.operand(a).within(binding), self.operand(b).within(tighter));
        (quote!(#a #operator #b), binding)
    }
}

/// Angles whose sines are computed by one call.
const ANGLES_AT_ONCE: usize = 4;

/// Names of operations are shorter; longer ones give way to a number.
const LONGEST_NAME: usize = 28;

/// The value that takes note of each pivot, from pivots and thresholds in turns.
pub fn pivots(rows: &[Vec<usize>], pivots: &[Expression]) -> TokenStream {
    let seen = rows.iter().zip(pivots.chunks(2)).map(|(rows, pair)| {
        let (pivot, threshold) = (&pair[0], &pair[1]);
        quote!(.see(&[#(#rows),*], T::least_ratio(#pivot, #threshold)))
    });
    quote!(ezy::Pivots::new()#(#seen)*)
}
