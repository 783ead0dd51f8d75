//! What depends on parameters alone: the function that computes it, and its names.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::numbers::Numbers;
use super::parts::{LONGEST_WHOLE, sequence};
use crate::mechanics::Derived;
use crate::model::{Model, ParameterId};
use crate::symbolic::coefficient::{Coefficient, CoefficientId, CoefficientNode, Coefficients};

/// The constants of a scene.
pub struct Constants<'a> {
    model: &'a Model,
    parameters: &'a [ParameterId],
    coefficients: &'a Coefficients,
    /// In the order of the vector `c` behind its inputs.
    stored: &'a [CoefficientId],
    n_inputs: usize,
    /// Of all that is computed, ascending: operands have smaller ids than what is computed from them.
    names: BTreeMap<CoefficientId, String>,
}

impl<'a> Constants<'a> {
    pub fn new(model: &'a Model, derived: &'a Derived<'_>) -> Self {
        let stored = derived.constants.coefficients();
        let (parameters, coefficients) = (derived.parameters(), &derived.algebra().coefficients);
        let (n_inputs, names) = (derived.inputs().len(), BTreeMap::new());
        let mut constants = Self { model, parameters, coefficients, stored, n_inputs, names };
        let mut needed = BTreeSet::new();
        stored.iter().for_each(|&id| constants.collect(id, &mut needed));
        let mut taken = BTreeSet::new();
        for id in needed {
            let name = constants.wording(id).map(|wording| wording.text).filter(|name| name.len() <= LONGEST_NAME);
            let mut name = name.unwrap_or_else(|| format!("k{}", id.0));
            if RESERVED.contains(&name.as_str()) {
                name = format!("parameter_{name}");
            }
            while !taken.insert(name.clone()) {
                name.push('_');
            }
            constants.names.insert(id, name);
        }
        constants
    }

    /// Of the constant at this place behind the inputs.
    pub fn name(&self, place: usize) -> String {
        self.names[&self.stored[place]].clone()
    }

    /// The method that writes the vector `c` behind its inputs.
    pub fn method(&self) -> TokenStream {
        let is_long = self.names.len() > LONGEST_WHOLE;
        let places = is_long.then(|| self.names.keys().enumerate().map(|(place, &id)| (id, place)).collect());
        let writer = Values { constants: self, places };
        let computed = self.names.keys().filter(|&&id| !writer.is_literal(id)).map(|&id| {
            let (name, value) = (writer.operand(id), writer.value(id));
            if is_long { quote!(#name = #value;) } else { quote!(let #name = #value;) }
        });
        let computed: Vec<TokenStream> = computed.collect();
        let computed = if is_long {
            let (n, zero, computed) = (self.names.len(), Numbers::Any.literal(0.0), sequence(computed));
            quote!(let mut k = [#zero; #n]; #computed)
        } else {
            quote!(#(#computed)*)
        };
        let writes = self.stored.iter().enumerate().map(|(i, &id)| {
            let (value, i) = (writer.operand(id), self.n_inputs + i);
            quote!(c[#i] = #value;)
        });
        let writes = sequence(writes);
        let (n_parameters, n_fixed) = (self.parameters.len(), self.n_inputs + self.stored.len());
        quote! {
            fn constants(&self, parameters: &[T], c: &mut [T]) {
                let parameters = ezy::array::<#n_parameters, T>(parameters);
                let c = ezy::array_mut::<#n_fixed, T>(c);
                #computed
                #writes
            }
        }
    }

    /// A constant in words of its parameters; none where that is long or could be read in two ways.
    fn wording(&self, id: CoefficientId) -> Option<Wording> {
        let operand = |id: CoefficientId| match self.names.get(&id) {
            Some(name) if name.starts_with('k') && name[1..].parse::<u32>().is_ok() => None,
            _ => self.wording(id).filter(|wording| wording.text.len() <= LONGEST_NAME),
        };
        match self.coefficients.node(id) {
            CoefficientNode::Number(x) => {
                let known = [(0.5, "half"), (1.0, "one"), (2.0, "two"), (3.0, "three"), (4.0, "four")];
                let (_, word) = known.iter().find(|(number, _)| number == x)?;
                Some(Wording { text: (*word).to_owned(), shape: Shape::Product })
            }
            CoefficientNode::Pi => Some(Wording { text: "pi".to_owned(), shape: Shape::Product }),
            CoefficientNode::Parameter(index) => {
                let parameter = self.model.parameters.get(*index).map(|parameter| &parameter.name);
                let name = parameter.or_else(|| {
                    let count = self.model.counts.get(*index - self.model.parameters.len());
                    count.map(|count| &count.name)
                })?;
                Some(Wording { text: name.to_string().replace("r#", "parameter_"), shape: Shape::Product })
            }
            CoefficientNode::Add(a, b) => sum(&operand(a.id)?, &operand(b.id)?, [a.negative, b.negative]),
            CoefficientNode::Mul(a, b) if a == b => square(&operand(*a)?),
            CoefficientNode::Mul(a, b) => product(&operand(*a)?, &operand(*b)?),
            CoefficientNode::Div(a, b) => quotient(&operand(*a)?, &operand(*b)?),
            CoefficientNode::Call(function, arguments) => match &arguments[..] {
                [x] if !x.negative => {
                    let text = format!("{}_{}", function.name(), operand(x.id)?.text);
                    Some(Wording { text, shape: Shape::Product })
                }
                _ => None,
            },
        }
    }

    fn collect(&self, id: CoefficientId, needed: &mut BTreeSet<CoefficientId>) {
        if !needed.insert(id) {
            return;
        }
        let operands: Vec<CoefficientId> = match self.coefficients.node(id) {
            CoefficientNode::Number(_) | CoefficientNode::Pi | CoefficientNode::Parameter(_) => Vec::new(),
            CoefficientNode::Add(a, b) => vec![a.id, b.id],
            CoefficientNode::Mul(a, b) | CoefficientNode::Div(a, b) => vec![*a, *b],
            CoefficientNode::Call(_, arguments) => arguments.iter().map(|a| a.id).collect(),
        };
        for operand in operands {
            self.collect(operand, needed);
        }
    }
}

/// Longer names of constants give way to a number.
const LONGEST_NAME: usize = 28;

/// Arguments of kernels and what a pattern cannot name, which temporaries must not shadow.
pub const RESERVED: [&str; 17] = [
    "t", "c", "k", "q", "v", "a", "m", "lambda", "residual", "delta", "out", "passed", "MODEL", "None", "Some", "Ok",
    "Err",
];

/// A name, and what it is read as.
struct Wording {
    text: String,
    shape: Shape,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Shape {
    Product,
    Quotient,
    Sum,
}

/// None where the order of the parts is not plain.
fn sum(x: &Wording, y: &Wording, negative: [bool; 2]) -> Option<Wording> {
    if x.shape == Shape::Sum || y.shape == Shape::Sum {
        return None;
    }
    let text = match negative {
        [false, false] => format!("{}_plus_{}", x.text, y.text),
        [false, true] => format!("{}_minus_{}", x.text, y.text),
        [true, false] => format!("{}_minus_{}", y.text, x.text),
        [true, true] => return None,
    };
    Some(Wording { text, shape: Shape::Sum })
}

fn square(x: &Wording) -> Option<Wording> {
    (x.shape == Shape::Product).then(|| Wording { text: format!("{}_squared", x.text), shape: Shape::Product })
}

fn product(x: &Wording, y: &Wording) -> Option<Wording> {
    let (text, shape) = match (x.shape, y.shape) {
        (Shape::Product, Shape::Product) => (format!("{}_{}", x.text, y.text), Shape::Product),
        (Shape::Product, Shape::Quotient) => (over(&x.text, &y.text), Shape::Quotient),
        (Shape::Quotient, Shape::Product) => (over(&y.text, &x.text), Shape::Quotient),
        _ => return None,
    };
    Some(Wording { text, shape })
}

fn quotient(x: &Wording, y: &Wording) -> Option<Wording> {
    let of_products = x.shape == Shape::Product && y.shape == Shape::Product;
    of_products.then(|| Wording { text: format!("{}_over_{}", x.text, y.text), shape: Shape::Quotient })
}

/// A factor before a quotient, within its numerator.
fn over(factor: &str, quotient: &str) -> String {
    match quotient.strip_prefix("one_over_") {
        Some(divisor) => format!("{factor}_over_{divisor}"),
        None => format!("{factor}_{quotient}"),
    }
}

/// What is computed, and where it is.
struct Values<'a> {
    constants: &'a Constants<'a>,
    /// Places in an array, where there are too many for names of their own.
    places: Option<BTreeMap<CoefficientId, usize>>,
}

impl Values<'_> {
    /// Whether it is written where it is read.
    fn is_literal(&self, id: CoefficientId) -> bool {
        matches!(self.constants.coefficients.node(id), CoefficientNode::Number(_) | CoefficientNode::Pi)
    }

    fn value(&self, id: CoefficientId) -> TokenStream {
        let of = self.constants;
        match of.coefficients.node(id) {
            CoefficientNode::Number(x) => Numbers::Any.literal(*x),
            CoefficientNode::Pi => quote!(T::PI),
            CoefficientNode::Parameter(index) => match of.model.parameters.get(*index) {
                Some(_) => {
                    let place = of.parameters.iter().position(|id| id.0 == *index).unwrap_or(0);
                    quote!(parameters[#place])
                }
                None => {
                    let field = &of.model.counts[*index - of.model.parameters.len()].name;
                    quote!(T::from_f64(self.#field as f64))
                }
            },
            CoefficientNode::Add(a, b) => {
                let (x, y) = (self.operand(a.id), self.operand(b.id));
                match (a.negative, b.negative) {
                    (false, false) => quote!(#x + #y),
                    (false, true) => quote!(#x - #y),
                    (true, false) => quote!(#y - #x),
                    (true, true) => quote!(-(#x + #y)),
                }
            }
            CoefficientNode::Mul(a, b) => {
                let (x, y) = (self.operand(*a), self.operand(*b));
                quote!(#x * #y)
            }
            CoefficientNode::Div(a, b) => {
                let (x, y) = (self.operand(*a), self.operand(*b));
                quote!(#x / #y)
            }
            CoefficientNode::Call(function, arguments) => {
                let arguments: Vec<TokenStream> = arguments.iter().map(|k| self.signed(k)).collect();
                Numbers::Any.call(*function, &arguments)
            }
        }
    }

    fn signed(&self, k: &Coefficient) -> TokenStream {
        let operand = self.operand(k.id);
        if k.negative { quote!(-#operand) } else { operand }
    }

    fn operand(&self, id: CoefficientId) -> TokenStream {
        if self.is_literal(id) {
            return self.value(id);
        }
        if let Some(places) = &self.places {
            let place = places[&id];
            return quote!(k[#place]);
        }
        let name = Ident::new(&self.constants.names[&id], Span::mixed_site());
        quote!(#name)
    }
}
