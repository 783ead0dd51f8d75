//! Where the numbers of a recurrence are found and written.

use rustc_hash::FxHashMap;

use crate::mechanics::symbols::Symbols;
use crate::symbolic::Symbol;

/// A number of a step. `Ahead` counts orders from the present one, k: what belongs to order k + 2 is 2 ahead.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Slot {
    /// A value at the start of the step, or of the factors of K.
    Base(usize),
    /// The sum of a product.
    Sum(usize),
    /// A coefficient that later orders read.
    Kept(Ahead, usize),
    /// A coefficient of q.
    Coordinate(Ahead, usize),
    /// f of the present order.
    Force(usize),
    /// r of the present order.
    Row(usize),
    /// a of the present order.
    Acceleration(usize),
    /// λ of the present order.
    Multiplier(usize),
    /// A coefficient of the left factor of a product.
    Left(Ahead, usize),
    /// A coefficient of the right factor of a product.
    Right(Ahead, usize),
    /// The order as a number.
    Order(Ahead),
    /// Its reciprocal.
    InverseOrder(Ahead),
}

/// Orders after the present one.
pub type Ahead = usize;

/// Symbols that stand for slots.
#[derive(Debug, Default)]
pub struct Slots {
    symbols: FxHashMap<Slot, Symbol>,
    slots: FxHashMap<Symbol, Slot>,
}

impl Slots {
    pub fn symbol(&mut self, symbols: &mut Symbols, slot: Slot) -> Symbol {
        let symbol = *self.symbols.entry(slot).or_insert_with(|| symbols.new_named(name(slot)));
        self.slots.insert(symbol, slot);
        symbol
    }

    pub fn slot(&self, symbol: Symbol) -> Option<Slot> {
        self.slots.get(&symbol).copied()
    }
}

/// What the temporary that holds it is called.
fn name(slot: Slot) -> String {
    let order = |ahead| ["", "_next", "_ahead"].get(ahead).copied().unwrap_or("_far");
    match slot {
        Slot::Base(i) => format!("base_{i}"),
        Slot::Sum(i) => format!("convolved_{i}"),
        Slot::Kept(ahead, i) => format!("kept_{i}{}", order(ahead)),
        Slot::Coordinate(ahead, i) => format!("q_{i}{}", order(ahead)),
        Slot::Force(i) => format!("force_{i}"),
        Slot::Row(i) => format!("row_{i}"),
        Slot::Acceleration(i) => format!("a_{i}"),
        Slot::Multiplier(i) => format!("lambda_{i}"),
        Slot::Left(ahead, i) => format!("left_{i}{}", order(ahead)),
        Slot::Right(ahead, i) => format!("right_{i}{}", order(ahead)),
        Slot::Order(ahead) => format!("order{}", order(ahead)),
        Slot::InverseOrder(ahead) => format!("inverse_order{}", order(ahead)),
    }
}
