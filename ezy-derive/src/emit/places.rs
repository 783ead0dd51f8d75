//! Where the numbers that a pass reads and writes stand.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::kernel::Binding;
use super::loops::{about, members, whole};
use super::signature::{Order, argument};
use crate::mechanics::Derived;
use crate::mechanics::derived::Straight;
use crate::mechanics::kernels::{Ahead, Entries, Quantity, Slot as Stored};
use crate::model::{BodyId, Component, Coordinate, Model, Slot};

/// How a pass finds its numbers.
#[derive(Clone, Copy)]
pub enum Places<'a> {
    /// Each at an index of its own: of a scene whose bodies are known.
    Fixed,
    /// Of a member, which finds its bodies in `slots` and counts behind the members before.
    Member(&'a [BodyId]),
}

impl Places<'_> {
    /// Index of an entry of the pass.
    pub fn index(self, of: Entries, i: usize) -> TokenStream {
        match self {
            Self::Fixed => quote!(#i),
            Self::Member(slots) if of == Entries::Coordinates => coordinate(slots, i),
            Self::Member(_) => {
                let (counter, i) = (counter(of), Literal::usize_unsuffixed(i));
                quote!(#counter + #i)
            }
        }
    }

    /// Sine and cosine of an angle, where a table has those of all bodies.
    pub fn sines(self, i: usize) -> Option<TokenStream> {
        let Self::Member(slots) = self else { return None };
        let slot = Literal::usize_unsuffixed(place_of_slot(slots, Coordinate::at(i).body));
        let n = Literal::usize_unsuffixed(Component::ALL.len());
        Some(quote!(sines[slots[#slot] / #n]))
    }

    /// A number in the storage of a series, or an order as a number.
    pub fn stored(self, slot: Stored, order: Order) -> TokenStream {
        let Some((array, i)) = Array::of(slot) else {
            return match slot {
                Stored::InverseOrder(ahead) => {
                    let order = order.ahead(ahead).within(Binding::Atom);
                    quote!(T::from_f64(1f64) / T::from_f64(#order as f64))
                }
                Stored::Order(ahead) => {
                    let order = order.ahead(ahead).within(Binding::Atom);
                    quote!(T::from_f64(#order as f64))
                }
                // every other slot is in an array
                _ => quote!(T::from_f64(f64::NAN)),
            };
        };
        let index = match slot {
            // of no member
            Stored::State(..) => quote!(#i),
            _ => self.index(array.of, i),
        };
        match (self, array.ahead) {
            (Self::Fixed, _) => {
                let array = array.ident();
                quote!(#array[#index])
            }
            (Self::Member(_), None) => {
                let field = argument(array.field);
                quote!(#field[#index])
            }
            (Self::Member(_), Some(ahead)) => {
                let (field, n) = (argument(array.field), argument(size(array.of)));
                let order = order.ahead(ahead).within(Binding::Product);
                quote!(#field[#order * #n + #index])
            }
        }
    }
}

/// An array of the storage of a series, of one order where it holds several.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Array {
    field: &'static str,
    ahead: Option<Ahead>,
    of: Entries,
}

impl Array {
    /// Where a slot is, and its index among those of the pass; `None` for orders, which are numbers.
    pub fn of(slot: Stored) -> Option<(Self, usize)> {
        use Entries::{Base, Coordinates, Kept, Products, Rows};
        let (field, ahead, of, i) = match slot {
            Stored::Base(i) => ("base", None, Base, i),
            Stored::Sum(i) => ("sums", None, Products, i),
            Stored::Force(i) => ("force", None, Coordinates, i),
            Stored::Row(i) => ("row", None, Rows, i),
            Stored::Acceleration(i) => ("a", None, Coordinates, i),
            Stored::Multiplier(i) => ("lambda", Some(0), Rows, i),
            Stored::Kept(ahead, i) => ("kept", Some(ahead), Kept, i),
            Stored::State(ahead, i) => ("kept", Some(ahead), Kept, i),
            Stored::Coordinate(ahead, i) => ("q", Some(ahead), Coordinates, i),
            Stored::Left(ahead, i) => ("left", Some(ahead), Products, i),
            Stored::Right(ahead, i) => ("right", Some(ahead), Products, i),
            Stored::Order(_) | Stored::InverseOrder(_) => return None,
        };
        Some((Self { field, ahead, of }, i))
    }

    /// What it is called in a straight line.
    fn ident(self) -> Ident {
        match self.ahead {
            None => argument(self.field),
            Some(ahead) => format_ident!("{}_{}", self.field, ahead),
        }
    }

    /// Opened to be read.
    pub fn opened(self, lengths: &Lengths, order: Order) -> TokenStream {
        let (name, field, n) = (self.ident(), argument(self.field), lengths.of(self.of));
        match self.ahead.map(|ahead| order.ahead(ahead)) {
            None => quote!(let #name = ezy::array::<#n, T>(&store.#field);),
            Some(order) => quote!(let #name = ezy::row::<#n, T>(&store.#field, #order);),
        }
    }

    /// Opened to be written, as `target`.
    pub fn target(self, lengths: &Lengths, order: Order) -> TokenStream {
        let (field, n) = (argument(self.field), lengths.of(self.of));
        match self.ahead.map(|ahead| order.ahead(ahead)) {
            None => quote!(let target = ezy::array_mut::<#n, T>(&mut store.#field);),
            Some(order) => quote!(let target = ezy::row_mut::<#n, T>(&mut store.#field, #order);),
        }
    }
}

/// Lengths of the arrays of a scene whose bodies are known.
pub struct Lengths {
    /// Inputs and constants.
    pub n_fixed: usize,
    entries: [(Entries, usize); 8],
}

/// Products come in groups of so many; `ezy_core::__private::PRODUCT_GROUP`.
const PRODUCT_GROUP: usize = 8;

impl Lengths {
    pub fn new(derived: &Derived<'_>, of: &Straight) -> Self {
        let (n_q, n_c) = (of.equations.mass.len(), of.equations.constraints.rows.len());
        let series = derived.kernels.get(&Quantity::SeriesBegin);
        let [n_products, n_base, n_kept] = OF_SERIES.map(|of| series.map_or(0, |kernel| kernel.n(of)));
        let entries = [
            (Entries::Coordinates, n_q),
            (Entries::Rows, n_c),
            (Entries::QuasiVelocities, of.quasi.as_ref().map_or(0, |quasi| quasi.symbols.len())),
            (Entries::OfTime, of.quasi.as_ref().map_or(0, |quasi| quasi.time_symbols.len())),
            (Entries::Sines, of.quasi.as_ref().map_or(0, |quasi| quasi.sine_symbols.len())),
            (Entries::Products, n_products.next_multiple_of(PRODUCT_GROUP)),
            (Entries::Base, n_base),
            (Entries::Kept, n_kept),
        ];
        Self { n_fixed: derived.n_fixed(), entries }
    }

    pub fn of(&self, entries: Entries) -> usize {
        self.entries.iter().find(|(of, _)| *of == entries).map_or(0, |&(_, n)| n)
    }
}

/// What a series has entries for besides coordinates and rows.
pub const OF_SERIES: [Entries; 3] = [Entries::Products, Entries::Base, Entries::Kept];

/// What the number of entries is called.
pub fn size(of: Entries) -> &'static str {
    match of {
        Entries::Coordinates => "n_q",
        Entries::Rows => "n_c",
        Entries::QuasiVelocities => "n_u",
        Entries::OfTime => "n_of_time",
        Entries::Sines => "n_sines",
        Entries::Products => "n_products",
        Entries::Base => "n_base",
        Entries::Kept => "n_kept",
    }
}

/// What counts the entries of the members before.
pub fn counter(of: Entries) -> Ident {
    argument(match of {
        Entries::Coordinates => "place",
        Entries::Rows => "row_place",
        Entries::QuasiVelocities => "quasi_place",
        Entries::OfTime => "time_place",
        Entries::Sines => "sine_place",
        Entries::Products => "product_place",
        Entries::Base => "base_place",
        Entries::Kept => "kept_place",
    })
}

/// Index of the first body of each array.
pub fn firsts(model: &Model) -> TokenStream {
    let mut behind = quote!(0);
    let firsts = model.arrays.iter().map(|array| {
        let first = about("first", array);
        let declared = quote!(let #first: i64 = #behind;);
        let members = members(model, array);
        behind = quote!(#first + #members);
        declared
    });
    firsts.collect()
}

/// Index of the first coordinate of each body that a pass refers to.
pub fn slot_places(model: &Model, slots: &[BodyId]) -> TokenStream {
    let places = slots.iter().map(|body| {
        let Slot { array, index } = &model.bodies[body.0].slot;
        let lengths = &model.arrays[*array].lengths;
        let place = index.iter().zip(lengths).fold(None, |place: Option<TokenStream>, (index, length)| {
            let (index, length) = (whole(model, index), whole(model, length));
            Some(match place {
                None => index,
                Some(place) => quote!(((#place) * #length + #index)),
            })
        });
        let first = about("first", &model.arrays[*array]);
        let place = place.map(|place| quote!(+ #place));
        let n = Literal::usize_unsuffixed(Component::ALL.len());
        quote!(#n * (#first #place) as usize)
    });
    let n = Literal::usize_unsuffixed(slots.len());
    quote!(let slots: [usize; #n] = [#(#places),*];)
}

fn place_of_slot(slots: &[BodyId], body: BodyId) -> usize {
    slots.iter().position(|slot| *slot == body).unwrap_or(0)
}

/// Place in q of a coordinate of a slot.
pub fn coordinate(slots: &[BodyId], i: usize) -> TokenStream {
    let Coordinate { body, component } = Coordinate::at(i);
    let slot = place_of_slot(slots, body);
    let [slot, component] = [slot, component as usize].map(Literal::usize_unsuffixed);
    quote!(slots[#slot] + #component)
}
