//! Long expressions within others get a symbol, as in a textbook: `u_1 = …` below the equation. What the model file names by a `let`
//! keeps that name.

use std::cell::RefCell;

use crate::mechanics::Equations;
use crate::mechanics::symbols::Let;
use crate::symbolic::coefficient::CoefficientId;
use crate::symbolic::print::{Names, Printed, print, print_definition};
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
        let lets = symbols.lets().iter().map(|of| of.name.text.clone());
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
            let name = self.let_of(sum).map_or_else(|| self.numbered(definitions.len()), |of| of.name.clone());
            definitions.push((name, print_definition(&self.equations.algebra, self, sum)));
        }
    }

    fn let_of(&self, sum: SumId) -> Option<&Let> {
        self.equations.symbols.lets().iter().find(|of| of.value == sum)
    }

    /// The symbol of a sum without a name, at this place.
    fn numbered(&self, place: usize) -> Printed {
        let n = self.sums.borrow()[..=place].iter().filter(|&&sum| self.let_of(sum).is_none()).count();
        spelling::name(&format!("{}{n}", self.letter))
    }

    /// The place of a sum among the definitions.
    fn place(&self, sum: SumId) -> usize {
        let mut sums = self.sums.borrow_mut();
        sums.iter().position(|&known| known == sum).unwrap_or_else(|| {
            sums.push(sum);
            sums.len() - 1
        })
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
        let named = self.let_of(sum).filter(|of| written_out.text.len() > of.name.text.len());
        if named.is_none() && written_out.text.chars().count() <= LONG {
            return None;
        }
        let i = self.place(sum);
        Some(named.map_or_else(|| self.numbered(i), |of| of.name.clone()))
    }

    fn coefficient(&self, id: CoefficientId) -> Option<(bool, Printed)> {
        let of = self.equations.symbols.let_of(id)?;
        self.place(of.value);
        self.equations.symbols.coefficient(id)
    }
}
