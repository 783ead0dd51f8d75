//! Programs as Rust statements.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::function::Path;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::symbolic::program::{Node, NodeId, Program};
use crate::symbolic::{Function, Symbol};

/// The numbers that a kernel computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    F64,
    /// Any `T` that is a `Scalar`.
    Any,
}

impl Numbers {
    /// Their type.
    pub fn name(self) -> TokenStream {
        match self {
            Self::F64 => quote!(f64),
            Self::Any => quote!(T),
        }
    }

    /// A number; what overflowed while numbers were folded has no literal.
    pub fn literal(self, x: f64) -> TokenStream {
        let number = if x.is_nan() {
            quote!(f64::NAN)
        } else if x.is_infinite() {
            quote!(f64::INFINITY)
        } else {
            quote!(#x)
        };
        self.convert(number)
    }

    /// From an expression that is an `f64`.
    pub fn convert(self, x: TokenStream) -> TokenStream {
        match self {
            Self::F64 => x,
            Self::Any => quote!(T::from_f64(#x)),
        }
    }

    /// A call of a function of the model language.
    pub fn call(self, function: Function, arguments: &[TokenStream]) -> TokenStream {
        let ident = |segment: &str| Ident::new(segment, Span::call_site());
        let path = match (self, function.path()) {
            (Self::F64, Path::OfKernel(name)) => {
                let name = ident(name);
                quote!(::ezy_core::kernel::#name)
            }
            (_, Path::OfNumber(name) | Path::OfKernel(name)) => {
                let (number, name) = (self.name(), ident(name));
                quote!(#number::#name)
            }
        };
        quote!(#path(#(#arguments),*))
    }
}

/// Statements of a kernel and the expression of each output.
pub struct Body {
    pub statements: TokenStream,
    pub outputs: Vec<TokenStream>,
}

/// Writes a program; `other` says where inputs besides time, coordinates and velocities are found.
pub fn body(numbers: Numbers, program: &Program, symbols: &Symbols, other: &dyn Fn(Symbol) -> TokenStream) -> Body {
    body_at(numbers, program, symbols, &|i| quote!(#i), other)
}

/// As [`body`], with coordinates and velocities at the indices that `place` says.
pub fn body_at(
    numbers: Numbers,
    program: &Program,
    symbols: &Symbols,
    place: &dyn Fn(usize) -> TokenStream,
    other: &dyn Fn(Symbol) -> TokenStream,
) -> Body {
    let fused = match numbers {
        Numbers::F64 => BTreeMap::new(),
        Numbers::Any => fused(program),
    };
    let taken_in = fused.values().copied().collect();
    let (live, names, taken) = (program.live(), BTreeMap::new(), BTreeSet::new());
    let mut writer = Writer { numbers, program, symbols, live, fused, taken_in, names, taken };
    let mut statements = TokenStream::new();
    for id in writer.live.clone() {
        statements.extend(writer.statement(id, place, other));
    }
    let outputs = program.outputs().iter().map(|output| writer.operand(output.node)).collect();
    Body { statements, outputs }
}

/// Sums and differences that take in the product among their operands, each with that product: one which nothing else
/// reads and which has no name.
fn fused(program: &Program) -> BTreeMap<NodeId, NodeId> {
    let uses = program.uses();
    let free =
        |id: &NodeId| matches!(program.node(*id), Node::Mul(..)) && uses[id.0] == 1 && program.name(*id).is_none();
    let products = program.live().into_iter().filter_map(|id| match program.node(id) {
        Node::Add(a, b) | Node::Sub(a, b) => [*b, *a].into_iter().find(free).map(|product| (id, product)),
        _ => None,
    });
    products.collect()
}

struct Writer<'a> {
    numbers: Numbers,
    program: &'a Program,
    symbols: &'a Symbols,
    live: Vec<NodeId>,
    /// What [`fused`] found.
    fused: BTreeMap<NodeId, NodeId>,
    /// The products in it.
    taken_in: BTreeSet<NodeId>,
    names: BTreeMap<NodeId, Ident>,
    taken: BTreeSet<String>,
}

impl Writer<'_> {
    fn statement(
        &mut self,
        id: NodeId,
        place: &dyn Fn(usize) -> TokenStream,
        other: &dyn Fn(Symbol) -> TokenStream,
    ) -> TokenStream {
        let value = match self.program.node(id) {
            Node::Constant(_) | Node::Literal(_) => return TokenStream::new(),
            Node::Input(symbol) => match self.symbols.meaning(*symbol) {
                Meaning::Time => {
                    self.names.insert(id, Ident::new("t", Span::call_site()));
                    return TokenStream::new();
                }
                Meaning::Coordinate(i) => {
                    let i = place(i);
                    quote!(q[#i])
                }
                Meaning::Velocity(i) => {
                    let i = place(i);
                    quote!(v[#i])
                }
                Meaning::Input(i) => quote!(c[#i]),
                Meaning::Index(_) | Meaning::Named(_) => other(*symbol),
            },
            Node::Sin(angle) | Node::Cos(angle) => return self.trigonometry(id, *angle),
            Node::Mul(..) if self.taken_in.contains(&id) => return TokenStream::new(),
            Node::Add(a, b) | Node::Sub(a, b) if self.fused.contains_key(&id) => self.fuse(id, *a, *b),
            Node::Add(a, b) => self.infix(*a, &quote!(+), *b),
            Node::Sub(a, b) => self.infix(*a, &quote!(-), *b),
            Node::Mul(a, b) => self.infix(*a, &quote!(*), *b),
            Node::Div(a, b) => self.infix(*a, &quote!(/), *b),
            Node::Neg(a) => {
                let a = self.operand(*a);
                quote!(-#a)
            }
            Node::Call(function, arguments) => {
                let arguments: Vec<TokenStream> = arguments.iter().map(|&a| self.operand(a)).collect();
                self.numbers.call(*function, &arguments)
            }
        };
        let name = self.declare(id, self.suggestion(id));
        quote!(let #name = #value;)
    }

    /// One call for a sine and cosine of the same angle.
    fn trigonometry(&mut self, id: NodeId, angle: NodeId) -> TokenStream {
        if self.names.contains_key(&id) {
            return TokenStream::new();
        }
        let find = |wanted: &Node| self.program.find(wanted).filter(|other| self.live.binary_search(other).is_ok());
        let (sin, cos) = (find(&Node::Sin(angle)), find(&Node::Cos(angle)));
        let (number, argument) = (self.numbers.name(), self.operand(angle));
        let label = match self.program.node(angle) {
            Node::Input(symbol) => self.symbols.code_name(*symbol),
            _ => angle.0.to_string(),
        };
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
        if let Some(name) = self.program.name(id) {
            return name.to_owned();
        }
        let kind = match self.program.node(id) {
            Node::Input(symbol) => return self.symbols.code_name(*symbol),
            Node::Add(..) => "sum",
            Node::Sub(..) => "difference",
            Node::Mul(..) => "product",
            Node::Div(..) => "quotient",
            _ => "value",
        };
        format!("{kind}_{}", id.0)
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

    fn operand(&self, id: NodeId) -> TokenStream {
        match self.program.node(id) {
            Node::Constant(i) => {
                let i = self.symbols.n_inputs() + i;
                quote!(c[#i])
            }
            Node::Literal(bits) => self.numbers.literal(f64::from_bits(*bits)),
            _ => {
                let name = self.names.get(&id);
                quote!(#name)
            }
        }
    }

    /// `a + b` or `a − b` with the product among them.
    fn fuse(&self, id: NodeId, a: NodeId, b: NodeId) -> TokenStream {
        let product = self.fused[&id];
        let Node::Mul(x, y) = *self.program.node(product) else { return TokenStream::new() };
        let (x, y, first, last) = (self.operand(x), self.operand(y), self.operand(a), self.operand(b));
        match (self.program.node(id), product == b) {
            (Node::Sub(..), true) => quote!(T::fused(-#x, #y, #first)),
            (Node::Sub(..), false) => quote!(T::fused(#x, #y, -#last)),
            (_, true) => quote!(T::fused(#x, #y, #first)),
            (_, false) => quote!(T::fused(#x, #y, #last)),
        }
    }

    fn infix(&self, a: NodeId, operator: &TokenStream, b: NodeId) -> TokenStream {
        let (a, b) = (self.operand(a), self.operand(b));
        quote!(#a #operator #b)
    }
}

/// Arguments of kernels, which temporaries must not shadow.
const RESERVED: [&str; 10] = ["t", "c", "q", "v", "a", "m", "lambda", "residual", "delta", "out"];

/// What takes note of each pivot, from pivots and thresholds in turns.
pub fn pivots_seen(rows: &[Vec<usize>], pivots: &[TokenStream]) -> Vec<TokenStream> {
    let of_pivot = rows.iter().zip(pivots.chunks(2)).map(|(rows, pair)| {
        let (pivot, threshold) = (&pair[0], &pair[1]);
        quote!(.see(&[#(#rows),*], T::least_ratio(#pivot, #threshold)))
    });
    of_pivot.collect()
}
