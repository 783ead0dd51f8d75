//! Programs as Rust statements.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::function::Path;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::symbolic::program::{Node, NodeId, Program};
use crate::symbolic::{Function, Symbol};

/// Statements of a kernel and the expression of each output.
pub struct Body {
    pub statements: TokenStream,
    pub outputs: Vec<TokenStream>,
}

/// Writes a program; `other` says where inputs besides time, coordinates and velocities are found.
pub fn body(program: &Program, symbols: &Symbols, other: &dyn Fn(Symbol) -> TokenStream) -> Body {
    body_at(program, symbols, &|i| quote!(#i), other)
}

/// As [`body`], with coordinates and velocities at the indices that `place` says.
pub fn body_at(
    program: &Program,
    symbols: &Symbols,
    place: &dyn Fn(usize) -> TokenStream,
    other: &dyn Fn(Symbol) -> TokenStream,
) -> Body {
    let mut writer = Writer { program, symbols, live: program.live(), names: BTreeMap::new(), taken: BTreeSet::new() };
    let mut statements = TokenStream::new();
    for id in writer.live.clone() {
        statements.extend(writer.statement(id, place, other));
    }
    let outputs = program.outputs().iter().map(|output| writer.operand(output.node)).collect();
    Body { statements, outputs }
}

struct Writer<'a> {
    program: &'a Program,
    symbols: &'a Symbols,
    live: Vec<NodeId>,
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
                call(*function, &arguments)
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
        let find = |wanted: &Node| self.live.iter().copied().find(|&other| self.program.node(other) == wanted);
        let (sin, cos) = (find(&Node::Sin(angle)), find(&Node::Cos(angle)));
        let argument = self.operand(angle);
        let label = match self.program.node(angle) {
            Node::Input(symbol) => self.symbols.code_name(*symbol),
            _ => angle.0.to_string(),
        };
        match (sin, cos) {
            (Some(sin), Some(cos)) => {
                let sin = self.declare(sin, format!("sin_{label}"));
                let cos = self.declare(cos, format!("cos_{label}"));
                quote!(let (#sin, #cos) = f64::sin_cos(#argument);)
            }
            (Some(sin), None) => {
                let sin = self.declare(sin, format!("sin_{label}"));
                quote!(let #sin = f64::sin(#argument);)
            }
            (None, _) => {
                let cos = self.declare(id, format!("cos_{label}"));
                quote!(let #cos = f64::cos(#argument);)
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
            Node::Literal(bits) => number(f64::from_bits(*bits)),
            _ => {
                let name = self.names.get(&id);
                quote!(#name)
            }
        }
    }

    fn infix(&self, a: NodeId, operator: &TokenStream, b: NodeId) -> TokenStream {
        let (a, b) = (self.operand(a), self.operand(b));
        quote!(#a #operator #b)
    }
}

/// Arguments of kernels, which temporaries must not shadow.
const RESERVED: [&str; 10] = ["t", "c", "q", "v", "a", "m", "lambda", "residual", "delta", "out"];

/// A number; what overflowed while numbers were folded has no literal.
pub fn number(x: f64) -> TokenStream {
    if x.is_nan() {
        quote!(f64::NAN)
    } else if x.is_infinite() {
        quote!(f64::INFINITY)
    } else {
        quote!(#x)
    }
}

/// A call of a function of the model language.
pub fn call(function: Function, arguments: &[TokenStream]) -> TokenStream {
    let ident = |segment: &str| Ident::new(segment, Span::call_site());
    let path = match function.path() {
        Path::Of64(name) => {
            let name = ident(name);
            quote!(f64::#name)
        }
        Path::OfKernel(name) => {
            let name = ident(name);
            quote!(::ezy_core::kernel::#name)
        }
    };
    quote!(#path(#(#arguments),*))
}
