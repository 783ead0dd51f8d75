//! What depends on parameters alone: the function that computes it, and its names.

mod wording;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::loops::{looped, whole};
use super::members::{self, OfMembers};
use super::numbers::Numbers;
use super::parts::{LONGEST_WHOLE, sequence};
use crate::mechanics::Derived;
use crate::mechanics::kernels::Pass;
use crate::model::whole::{IndexId, Whole};
use crate::model::{DeclaredSwitch, Model, ParameterId};
use crate::symbolic::coefficient::{Coefficient, CoefficientId, CoefficientNode, Coefficients};
use wording::{Shape, Wording, product, quotient, square, sum};

/// The constants of a scene.
pub struct Constants<'a> {
    model: &'a Model,
    parameters: &'a [ParameterId],
    /// Stand behind them.
    switches: &'a [DeclaredSwitch],
    coefficients: &'a Coefficients,
    /// In the order of the vector `c` behind its inputs and first-order states.
    stored: &'a [CoefficientId],
    /// Inputs and first-order states.
    n_inputs: usize,
    /// Of all that is computed, ascending: operands have smaller ids than what is computed from them.
    names: BTreeMap<CoefficientId, String>,
    /// The innermost `for` that a constant depends on; none of those that depend on no index.
    innermost: BTreeMap<CoefficientId, IndexId>,
    /// What depends on indices.
    members: Vec<OfMembers>,
    /// Of the stored: place among those that depend on no index, or on the same innermost one.
    positions: Vec<usize>,
}

impl<'a> Constants<'a> {
    pub fn new(model: &'a Model, derived: &'a Derived<'_>) -> Self {
        let stored = derived.constants.coefficients();
        let (parameters, coefficients) = (derived.parameters(), &derived.algebra().coefficients);
        let (n_inputs, switches, names) = (derived.inputs().len(), derived.switches(), BTreeMap::new());
        let (innermost, members, positions) = (BTreeMap::new(), Vec::new(), Vec::new());
        let mut constants =
            Self { model, parameters, switches, coefficients, stored, n_inputs, names, innermost, members, positions };
        let needed = constants.needed(stored);
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
            let index = constants.own_index(id);
            constants.innermost.extend(index.map(|index| (id, index)));
        }
        let innermost = &constants.innermost;
        constants.members = OfMembers::all(stored.iter().filter_map(|id| Some((*innermost.get(id)?, *id))));
        let mut n_before: BTreeMap<Option<IndexId>, usize> = BTreeMap::new();
        let position = |id| {
            let n = n_before.entry(innermost.get(id).copied()).or_default();
            std::mem::replace(n, *n + 1)
        };
        constants.positions = stored.iter().map(position).collect();
        constants
    }

    /// How many depend on no index.
    pub fn n_single(&self) -> usize {
        self.single().count()
    }

    fn single(&self) -> impl Iterator<Item = CoefficientId> {
        self.stored.iter().copied().filter(|id| !self.innermost.contains_key(id))
    }

    /// Where the constant at this place behind the inputs is in `c`.
    pub fn place(&self, place: usize) -> TokenStream {
        let (id, position) = (self.stored[place], self.positions[place]);
        match self.members.iter().find(|of| self.innermost.get(&id) == Some(&of.index)) {
            Some(of) => of.place(position),
            None => {
                let place = self.n_inputs + position;
                quote!(#place)
            }
        }
    }

    /// What a pass reads of members.
    pub fn members_in(&self, pass: &Pass<'_>) -> Vec<&OfMembers> {
        let read: BTreeSet<CoefficientId> = pass.program.constants().map(|i| self.stored[i]).collect();
        self.members.iter().filter(|of| of.stored.iter().any(|id| read.contains(id))).collect()
    }

    /// The function that knows where the constants of members are.
    pub fn places_of_members(&self) -> Option<TokenStream> {
        members::places(self.model, &self.members, self.n_inputs + self.n_single())
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
        let computed = self.names.keys().filter(|&&id| !writer.is_literal(id) && !self.innermost.contains_key(&id));
        let computed: Vec<TokenStream> = computed.map(|&id| writer.statement(id)).collect();
        let computed = if is_long {
            let (n, zero, computed) = (self.names.len(), Numbers::Any.literal(0.0), sequence(computed));
            quote!(let mut k = [#zero; #n]; #computed)
        } else {
            quote!(#(#computed)*)
        };
        let writes = self.single().enumerate().map(|(i, id)| {
            let (value, i) = (writer.operand(id), self.n_inputs + i);
            quote!(c[#i] = #value;)
        });
        let writes = sequence(writes);
        let (n_parameters, n_fixed) = (self.parameters.len() + self.switches.len(), self.n_inputs + self.n_single());
        let (opening, members) = match &self.members[..] {
            [] => (quote!(let c = ezy::array_mut::<#n_fixed, T>(c);), quote!()),
            all => {
                let members = all.iter().map(|of| self.of_members(of, &writer));
                (quote!(let members = self.members();), quote!(#(#members)*))
            }
        };
        quote! {
            fn constants(&self, parameters: &[T], c: &mut [T]) {
                let parameters = ezy::array::<#n_parameters, T>(parameters);
                #opening
                #computed
                #writes
                #members
            }
        }
    }

    /// What the members of a `for` have, in a loop of its own: it runs once.
    fn of_members(&self, of: &OfMembers, writer: &Values<'_>) -> TokenStream {
        let needed = self.needed(&of.stored);
        let computed = needed.into_iter().filter(|id| self.innermost.contains_key(id)).map(|id| writer.statement(id));
        let writes = of.stored.iter().enumerate().map(|(i, &id)| {
            let (place, value) = (of.place(i), writer.operand(id));
            quote!(c[#place] = #value;)
        });
        let (begin, step) = (of.begin(), of.step());
        let body = quote!(#(#computed)* #(#writes)* #step);
        let pass = looped(self.model, self.model.loops_to(of.index), &|from, to| quote!(#from..#to), body);
        quote!(#begin #pass)
    }

    /// The index of the innermost `for` that a constant depends on, once that of its operands is known.
    fn own_index(&self, id: CoefficientId) -> Option<IndexId> {
        let whole = match self.coefficients.node(id) {
            CoefficientNode::Parameter(place) => self.whole(*place),
            _ => None,
        };
        let of_operands = self.operands(id).into_iter().filter_map(|id| self.innermost.get(&id).copied());
        of_operands.chain(whole.and_then(|whole| whole.innermost())).max()
    }

    /// The whole number at a place among parameters and whole numbers.
    fn whole(&self, place: usize) -> Option<Whole> {
        self.model.whole(place.checked_sub(self.model.parameters.len())?)
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
            CoefficientNode::Conversion { .. } => None,
            CoefficientNode::Parameter(index) => {
                let parameter = self.model.parameters.get(*index).map(|parameter| parameter.name.to_string());
                let name = parameter.or_else(|| match self.whole(*index) {
                    Some(Whole::Count(id)) => Some(self.model.counts[id.0].name.to_string()),
                    Some(Whole::Index(id)) => Some(self.model.indices[id.0].clone()),
                    Some(_) => None,
                    None => self.switches.get(index - self.model.n_values()).map(|switch| switch.name.clone()),
                })?;
                Some(Wording { text: name.replace("r#", "parameter_"), shape: Shape::Product })
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

    /// These and all that they are computed from.
    fn needed(&self, ids: &[CoefficientId]) -> BTreeSet<CoefficientId> {
        let (mut needed, mut rest) = (BTreeSet::new(), ids.to_vec());
        while let Some(id) = rest.pop() {
            if needed.insert(id) {
                rest.extend(self.operands(id));
            }
        }
        needed
    }

    fn operands(&self, id: CoefficientId) -> Vec<CoefficientId> {
        match self.coefficients.node(id) {
            CoefficientNode::Number(_)
            | CoefficientNode::Pi
            | CoefficientNode::Parameter(_)
            | CoefficientNode::Conversion { .. } => Vec::new(),
            CoefficientNode::Add(a, b) => vec![a.id, b.id],
            CoefficientNode::Mul(a, b) | CoefficientNode::Div(a, b) => vec![*a, *b],
            CoefficientNode::Call(_, arguments) => arguments.iter().map(|a| a.id).collect(),
        }
    }
}

/// A number of a unit of this size, in SI units.
fn converted(number: TokenStream, times: f64, over: f64, pi: i32) -> TokenStream {
    let literal = |x: f64| (x != 1.0).then(|| Numbers::Any.literal(x));
    let (times, over) = (literal(times).into_iter(), literal(over).into_iter());
    let by_pi = std::iter::repeat_n(quote!(*T::PI), pi.max(0) as usize);
    let over_pi = std::iter::repeat_n(quote!(/ T::PI), (-pi).max(0) as usize);
    quote!(#number #(* #times)* #(#by_pi)* #(#over_pi)* #(/ #over)*)
}

/// Longer names of constants give way to a number.
const LONGEST_NAME: usize = 28;

/// Arguments of kernels and what a pattern cannot name, which temporaries must not shadow.
pub const RESERVED: [&str; 21] = [
    "t", "c", "k", "q", "v", "a", "m", "lambda", "residual", "delta", "quasi", "q_rate", "of_time", "out", "passed",
    "MODEL", "None", "Some", "Ok", "Err", "sines",
];

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

    /// Computes one; what depends on indices has a name within its loop.
    fn statement(&self, id: CoefficientId) -> TokenStream {
        let (name, value) = (self.operand(id), self.value(id));
        match self.place(id) {
            Some(_) => quote!(#name = #value;),
            None => quote!(let #name = #value;),
        }
    }

    fn place(&self, id: CoefficientId) -> Option<usize> {
        self.places.as_ref().filter(|_| !self.constants.innermost.contains_key(&id)).map(|places| places[&id])
    }

    fn value(&self, id: CoefficientId) -> TokenStream {
        let of = self.constants;
        match of.coefficients.node(id) {
            CoefficientNode::Number(x) => Numbers::Any.literal(*x),
            CoefficientNode::Pi => quote!(T::PI),
            CoefficientNode::Parameter(index) => match of.model.parameters.get(*index) {
                Some(parameter) => {
                    let place = of.parameters.iter().position(|id| id.0 == *index).unwrap_or(0);
                    let unit = parameter.size;
                    converted(quote!(parameters[#place]), unit.times, unit.over, unit.pi)
                }
                None => match of.whole(*index) {
                    Some(value) => {
                        let value = whole(of.model, &value);
                        quote!(T::from_f64(#value as f64))
                    }
                    None => {
                        let place = of.parameters.len() + index - of.model.n_values();
                        quote!(parameters[#place])
                    }
                },
            },
            CoefficientNode::Conversion { times, over, pi } => converted(Numbers::Any.literal(*times), 1.0, *over, *pi),
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
        if let Some(place) = self.place(id) {
            return quote!(k[#place]);
        }
        let name = Ident::new(&self.constants.names[&id], Span::mixed_site());
        quote!(#name)
    }
}
