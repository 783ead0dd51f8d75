//! Symbols of the numbers that a recurrence reads.

use rustc_hash::FxHashMap;

use crate::mechanics::kernels::{Read, Slot};
use crate::mechanics::symbols::Symbols;
use crate::symbolic::Symbol;
use crate::symbolic::program::Program;

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

    /// What a program reads of them, ascending by symbol.
    pub fn reads(&self, program: &Program) -> Vec<(Symbol, Read)> {
        let read = |symbol| Some((symbol, Read::Slot(self.slot(symbol)?)));
        let mut reads: Vec<(Symbol, Read)> = program.inputs().into_iter().filter_map(read).collect();
        reads.sort_unstable_by_key(|&(symbol, _)| symbol);
        reads
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
        Slot::State(ahead, i) => format!("z_{i}{}", order(ahead)),
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
