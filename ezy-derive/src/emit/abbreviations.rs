//! Long expressions within others get a symbol, as in a textbook: `u_1 = …` below the equation. Those that the model file names by a `let` keep
//! that name.

use std::cell::RefCell;

use crate::mechanics::Equations;
use crate::symbolic::print::{Names, Printed, print};
use crate::symbolic::{SumId, Symbol, spelling};

/// A sum that takes more signs is not written out within another expression: three fit on a line.
const LONG: usize = 40;

/// Symbols in the order in which printing meets what they stand for.
pub struct Abbreviations<'a> {
    equations: &'a Equations,
    letter: &'static str,
    sums: RefCell<Vec<SumId>>,
}

impl<'a> Abbreviations<'a> {
    /// None yet; the letter is one with which no number of the scene begins.
    pub fn new(equations: &'a Equations) -> Self {
        let symbols = &equations.symbols;
        let parameters = equations.parameters.iter().map(|id| symbols.parameter(id.0).text);
        let inputs = equations.inputs.iter().filter_map(|&id| Some(symbols.symbol(symbols.input(id)?).text));
        let lets = equations.lets.iter().map(|(name, _)| name.clone());
        let taken: Vec<String> = parameters.chain(inputs).chain(lets).collect();
        let free = |letter: &&str| !taken.iter().any(|name| name.starts_with(letter));
        let letter = ["u", "w", "z", "k", "h"].into_iter().find(free).unwrap_or("abbreviation_");
        Self { equations, letter, sums: RefCell::default() }
    }

    pub fn print(&self, sum: SumId) -> Printed {
        print(&self.equations.algebra, self, sum)
    }

    /// Every symbol that was used so far, with what it stands for.
    pub fn definitions(&self) -> Vec<(Printed, Printed)> {
        let mut definitions = Vec::new();
        // what is printed may use further symbols
        loop {
            let next = self.sums.borrow().get(definitions.len()).copied();
            let Some(sum) = next else { return definitions };
            definitions.push((self.name_of(sum, definitions.len()), self.print(sum)));
        }
    }

    fn name_of(&self, sum: SumId, i: usize) -> Printed {
        match self.equations.lets.iter().find(|(_, value)| *value == sum) {
            Some((name, _)) => spelling::name(name),
            None => spelling::name(&format!("{}{}", self.letter, i + 1)),
        }
    }
}

impl Names for Abbreviations<'_> {
    fn symbol(&self, symbol: Symbol) -> Printed {
        self.equations.symbols.symbol(symbol)
    }

    fn parameter(&self, index: usize) -> Printed {
        self.equations.symbols.parameter(index)
    }

    fn abbreviation(&self, sum: SumId, written_out: &Printed) -> Option<Printed> {
        let is_named =
            self.equations.lets.iter().any(|(name, value)| *value == sum && written_out.text.len() > name.len());
        if !is_named && written_out.text.chars().count() <= LONG {
            return None;
        }
        let mut sums = self.sums.borrow_mut();
        let i = sums.iter().position(|&known| known == sum).unwrap_or_else(|| {
            sums.push(sum);
            sums.len() - 1
        });
        Some(self.name_of(sum, i))
    }
}
