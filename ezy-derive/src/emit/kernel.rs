//! Programs as Rust statements.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::function::Path;
use crate::mechanics::symbols::{Meaning, Symbols};
use crate::symbolic::program::{Node, NodeId, Program};
use crate::symbolic::{Function, Symbol};
use crate::work;

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
                quote!(ezy::#name)
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
    let (live, names, taken, passed) = (program.live(), BTreeMap::new(), BTreeSet::new(), BTreeMap::new());
    let sources = Sources { place, other };
    let mut writer = Writer { numbers, program, symbols, sources, live, fused, taken_in, names, taken, passed };
    let statements = match Parts::new(&writer) {
        None => writer.in_one(),
        Some(parts) => writer.in_parts(&parts),
    };
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

/// Where inputs are found.
struct Sources<'a> {
    /// Coordinates and velocities.
    place: &'a dyn Fn(usize) -> TokenStream,
    other: &'a dyn Fn(Symbol) -> TokenStream,
}

struct Writer<'a> {
    numbers: Numbers,
    program: &'a Program,
    symbols: &'a Symbols,
    sources: Sources<'a>,
    live: Vec<NodeId>,
    /// What [`fused`] found.
    fused: BTreeMap<NodeId, NodeId>,
    /// The products in it.
    taken_in: BTreeSet<NodeId>,
    names: BTreeMap<NodeId, Ident>,
    taken: BTreeSet<String>,
    /// Places of the values that a part passes to later ones.
    passed: BTreeMap<NodeId, usize>,
}

/// A long kernel in parts. Each `let` opens a scope, and rustc overflows its stack on some thousand scopes in each other.
struct Parts {
    /// The nodes that each part computes, ascending.
    homes: Vec<Vec<NodeId>>,
    /// The inputs that each part reads.
    inputs: Vec<BTreeSet<NodeId>>,
    /// What later parts or the outputs read, by part.
    passed: Vec<BTreeSet<NodeId>>,
}

/// A kernel of so many statements stays in one piece. rustc 1.95 with debug information overflows its stack at some 3,000.
pub const LONGEST_WHOLE: usize = 1500;
/// Statements of a part of a longer one.
const LONGEST_PART: usize = 300;

/// Statements that declare nothing, in parts where they are many.
pub fn sequence(statements: impl IntoIterator<Item = TokenStream>) -> TokenStream {
    let statements: Vec<TokenStream> = statements.into_iter().collect();
    if statements.len() <= LONGEST_WHOLE {
        return quote!(#(#statements)*);
    }
    statements.chunks(LONGEST_PART).map(|part| quote!((|| { #(#part)* })();)).collect()
}

impl Parts {
    fn new(writer: &Writer<'_>) -> Option<Self> {
        let program = writer.program;
        let is_input = |id: NodeId| matches!(program.node(id), Node::Input(_));
        let is_computed = |id: &NodeId| {
            let stands_alone = matches!(program.node(*id), Node::Constant(_) | Node::Literal(_) | Node::Input(_));
            !stands_alone && !writer.taken_in.contains(id)
        };
        let computed: Vec<NodeId> = writer.live.iter().copied().filter(is_computed).collect();
        if computed.len() <= LONGEST_WHOLE {
            return None;
        }
        let mut homes: Vec<Vec<NodeId>> = computed.chunks(LONGEST_PART).map(<[NodeId]>::to_vec).collect();
        let mut home: BTreeMap<NodeId, usize> = BTreeMap::new();
        for (part, ids) in homes.iter().enumerate() {
            for &id in ids {
                home.entry(id).or_insert(part);
                // a sine and a cosine are found together
                if let Some(partner) = writer.partner(id) {
                    home.entry(partner).or_insert(part);
                }
            }
        }
        homes.iter_mut().enumerate().for_each(|(part, ids)| ids.retain(|id| home[id] == part));
        let last = homes.len() - 1;
        let mut inputs = vec![BTreeSet::new(); homes.len()];
        let mut passed = vec![BTreeSet::new(); homes.len()];
        for (part, ids) in homes.iter().enumerate() {
            for operand in ids.iter().flat_map(|&id| writer.operands(id)) {
                if is_input(operand) {
                    inputs[part].insert(operand);
                } else if let Some(&home) = home.get(&operand).filter(|home| **home < part) {
                    passed[home].insert(operand);
                }
            }
        }
        for output in program.outputs() {
            if is_input(output.node) {
                inputs[last].insert(output.node);
                passed[last].insert(output.node);
            } else if let Some(&home) = home.get(&output.node) {
                passed[home].insert(output.node);
            }
        }
        Some(Self { homes, inputs, passed })
    }
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
        let n_passed: usize = parts.passed.iter().map(BTreeSet::len).sum();
        let zero = self.numbers.literal(0.0);
        let mut statements = quote!(let mut passed = [#zero; #n_passed];);
        for ((home, inputs), passed) in parts.homes.iter().zip(&parts.inputs).zip(&parts.passed) {
            self.names.clear();
            self.taken.clear();
            let mut part = TokenStream::new();
            for &id in inputs.iter().chain(home) {
                part.extend(self.statement(id));
            }
            for &id in passed {
                let (i, name) = (self.passed.len(), self.operand(id));
                part.extend(quote!(passed[#i] = #name;));
                self.passed.insert(id, i);
            }
            statements.extend(quote!((|| { #part })();));
        }
        self.names.clear();
        statements
    }

    /// The cosine of a sine's angle, and the reverse, where it is needed.
    fn partner(&self, id: NodeId) -> Option<NodeId> {
        match *self.program.node(id) {
            Node::Sin(angle) => self.find(&Node::Cos(angle)),
            Node::Cos(angle) => self.find(&Node::Sin(angle)),
            _ => None,
        }
    }

    /// A node that is needed.
    fn find(&self, wanted: &Node) -> Option<NodeId> {
        self.program.find(wanted).filter(|id| self.live.binary_search(id).is_ok())
    }

    /// What a statement reads.
    fn operands(&self, id: NodeId) -> Vec<NodeId> {
        let operands = self.program.node(id).operands().into_iter();
        let read = |operand| match self.fused.get(&id) {
            Some(&product) if product == operand => self.program.node(product).operands(),
            _ => vec![operand],
        };
        operands.flat_map(read).collect()
    }

    fn statement(&mut self, id: NodeId) -> TokenStream {
        work::count(1);
        let value = match self.program.node(id) {
            Node::Constant(_) | Node::Literal(_) => return TokenStream::new(),
            Node::Input(symbol) => match self.symbols.meaning(*symbol) {
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
                Meaning::Index(_) | Meaning::Named(_) => (self.sources.other)(*symbol),
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
        let (sin, cos) = (self.find(&Node::Sin(angle)), self.find(&Node::Cos(angle)));
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
            Node::Mul(a, b) => match (self.label(*a), self.label(*b)) {
                (Some(a), Some(b)) if a.len() + b.len() < LONGEST_NAME => return format!("{a}_{b}"),
                _ => "product",
            },
            Node::Div(..) => "quotient",
            _ => "value",
        };
        format!("{kind}_{}", id.0)
    }

    /// What an operand is called within the name of a product: `c[3]` is `c3`.
    fn label(&self, id: NodeId) -> Option<String> {
        match self.program.node(id) {
            Node::Constant(i) => Some(format!("c{}", self.symbols.n_inputs() + i)),
            _ => self.names.get(&id).map(Ident::to_string),
        }
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
                let name = self.names.get(&id).map(|name| quote!(#name));
                let value = name.or_else(|| self.passed.get(&id).map(|i| quote!(passed[#i])));
                quote!(#value)
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

/// Products with longer names are numbered.
const LONGEST_NAME: usize = 24;

/// Arguments of kernels, which temporaries must not shadow.
const RESERVED: [&str; 11] = ["t", "c", "q", "v", "a", "m", "lambda", "residual", "delta", "out", "passed"];

/// The value that takes note of each pivot, from pivots and thresholds in turns.
pub fn pivots(rows: &[Vec<usize>], pivots: &[TokenStream]) -> TokenStream {
    let seen = rows.iter().zip(pivots.chunks(2)).map(|(rows, pair)| {
        let (pivot, threshold) = (&pair[0], &pair[1]);
        quote!(.see(&[#(#rows),*], T::least_ratio(#pivot, #threshold)))
    });
    quote!(ezy::Pivots::new()#(#seen)*)
}
