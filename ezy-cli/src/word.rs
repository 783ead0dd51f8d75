//! Options that take one of the words for a choice of `ezy-core`.

use clap::ValueEnum;
use clap::builder::PossibleValue;

use ezy_core::dynamics::{Metric, Projection};
use ezy_core::integrate::MethodKind;
use ezy_study::sweep::{Design, Format};

/// A choice, as an option takes it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Word<T>(pub T);

/// Choices that have words.
pub(super) trait Choice: Copy + 'static {
    /// All of them, in the order of the help.
    const ALL: &'static [Word<Self>];

    /// The word and its help.
    fn word(self) -> (&'static str, &'static str);
}

impl<T: Choice> ValueEnum for Word<T> {
    fn value_variants<'a>() -> &'a [Self] {
        T::ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let (word, help) = self.0.word();
        Some(PossibleValue::new(word).help(help))
    }
}

const fn words<T: Copy, const N: usize>(choices: &[T]) -> [Word<T>; N] {
    let mut words = [Word(choices[0]); N];
    let mut i = 1;
    while i < N {
        words[i] = Word(choices[i]);
        i += 1;
    }
    words
}

impl Choice for MethodKind {
    const ALL: &'static [Word<Self>] = &words::<_, { Self::ALL.len() }>(Self::ALL);

    fn word(self) -> (&'static str, &'static str) {
        (self.name(), self.info().summary)
    }
}

impl Choice for Projection {
    const ALL: &'static [Word<Self>] =
        &[Word(Self::Both), Word(Self::Positions), Word(Self::Velocities), Word(Self::None)];

    fn word(self) -> (&'static str, &'static str) {
        match self {
            Self::Both => ("both", "Positions, then velocities at the projected positions"),
            Self::Positions => ("positions", "Positions only"),
            Self::Velocities => ("velocities", "Velocities only"),
            Self::None => ("none", "Nothing: the constraints may drift"),
        }
    }
}

impl Choice for Metric {
    const ALL: &'static [Word<Self>] = &[Word(Self::Mass), Word(Self::Euclidean)];

    fn word(self) -> (&'static str, &'static str) {
        match self {
            Self::Mass => ("mass", "Weighted by the masses: never adds kinetic energy"),
            _ => ("euclidean", "Unweighted: adds metres to radians; for comparison"),
        }
    }
}

impl Choice for Design {
    const ALL: &'static [Word<Self>] = &[Word(Self::LatinHypercube), Word(Self::Random)];

    fn word(self) -> (&'static str, &'static str) {
        let help = match self {
            Self::LatinHypercube => {
                "Latin hypercube: each range is cut into as many parts as there are samples, each part has one"
            }
            Self::Random => "Independent and uniform",
        };
        (self.name(), help)
    }
}

impl Choice for Format {
    const ALL: &'static [Word<Self>] = &[Word(Self::Csv), Word(Self::Parquet)];

    fn word(self) -> (&'static str, &'static str) {
        let help = match self {
            Self::Csv => "Text",
            Self::Parquet => "Columns of numbers, for DuckDB, Polars, pandas; needs the feature `parquet`",
        };
        (self.name(), help)
    }
}
