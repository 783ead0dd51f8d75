//! Which cases a sweep runs.

use super::samples::Samples;
use ezy_core::record::{UnknownName, find_name};

/// The cases of a sweep: each of a list with each sample with each point of a grid. The values of a case are a function of its number
/// alone, so that machines share a sweep by sharing its numbers. The last axis of the grid runs fastest.
///
/// ```
/// use ezy_study::sweep::{Design, Plan, Samples};
///
/// let plan = Plan::new()
///     .samples(Samples::new(Design::LatinHypercube, 100, 1).over("m1", 40.0, 60.0))
///     .grid("m0", [1.0, 2.0, 3.0])
///     .words("method", ["rk4", "dop853"]);
/// assert_eq!(plan.n_cases()?, 600);
/// assert_eq!(plan.names(), ["m1", "m0", "method"]);
/// # Ok::<(), ezy_study::sweep::PlanError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plan {
    pub(super) factors: Vec<Factor>,
}

/// One of the sets whose product the cases are.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Factor {
    /// Rows of numbers, one after the other.
    List {
        names: Vec<String>,
        numbers: Vec<f64>,
    },
    Samples(Samples),
    Grid {
        name: String,
        values: Vec<f64>,
    },
    Words {
        name: String,
        words: Vec<String>,
    },
}

/// Of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value<'p> {
    /// Of a parameter, a start value, an input, a tolerance.
    Number(f64),
    /// The name of a method.
    Word(&'p str),
}

/// Why a plan cannot be carried out.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// Nothing is varied.
    #[error("nothing is varied; give at least one value or sample")]
    Nothing,
    /// Without any value.
    #[error("`{name}` has no value; give at least one")]
    Empty {
        /// What is varied.
        name: String,
    },
    /// Varied twice.
    #[error("`{name}` is varied twice; give all its values at once")]
    Twice {
        /// What is varied.
        name: String,
    },
    /// A value is none.
    #[error("`{name}` gets the value {value}, which is not finite")]
    NotFinite {
        /// What is varied.
        name: String,
        /// NaN or an infinity.
        value: f64,
    },
    /// A row of a list has another length than the list has names.
    #[error("a list has {n_numbers} numbers, which is no multiple of its {n_names} names")]
    Ragged {
        /// Numbers of all rows.
        n_numbers: usize,
        /// Numbers of one row.
        n_names: usize,
    },
    /// More than [`Plan::LARGEST`].
    #[error("the plan has more than {limit:.0e} cases", limit = Plan::LARGEST as f64)]
    TooMany,
}

impl Factor {
    pub(super) fn n(&self) -> u64 {
        match self {
            Self::List { names, numbers } => (numbers.len() / names.len().max(1)) as u64,
            Self::Samples(samples) => samples.n,
            Self::Grid { values, .. } => values.len() as u64,
            Self::Words { words, .. } => words.len() as u64,
        }
    }

    fn names(&self) -> Vec<&str> {
        match self {
            Self::List { names, .. } => names.iter().map(String::as_str).collect(),
            Self::Samples(samples) => samples.ranges.iter().map(|(name, ..)| name.as_str()).collect(),
            Self::Grid { name, .. } | Self::Words { name, .. } => vec![name],
        }
    }

    fn push_values<'p>(&'p self, i: u64, values: &mut Vec<Value<'p>>) {
        // the number of values fits into memory, so that the index does
        match self {
            Self::List { names, numbers } => {
                let row = &numbers[i as usize * names.len()..][..names.len()];
                values.extend(row.iter().map(|x| Value::Number(*x)));
            }
            Self::Samples(samples) => {
                values.extend((0..samples.ranges.len()).map(|k| Value::Number(samples.value(i, k))));
            }
            Self::Grid { values: all, .. } => values.push(Value::Number(all[i as usize])),
            Self::Words { words, .. } => values.push(Value::Word(&words[i as usize])),
        }
    }

    fn check(&self) -> Result<(), PlanError> {
        let name = |i: usize| self.names().get(i).map_or_else(|| "list".to_owned(), |name| (*name).to_owned());
        if let Self::List { names, numbers } = self
            && (names.is_empty() || numbers.len() % names.len() != 0)
        {
            return Err(PlanError::Ragged { n_numbers: numbers.len(), n_names: names.len() });
        }
        if self.n() == 0 || self.names().is_empty() {
            return Err(PlanError::Empty { name: name(0) });
        }
        let not_finite = |(i, value): (usize, f64)| PlanError::NotFinite { name: name(i), value };
        let numbers: Vec<(usize, f64)> = match self {
            Self::List { names, numbers } => numbers.iter().enumerate().map(|(i, x)| (i % names.len(), *x)).collect(),
            Self::Samples(Samples { ranges, .. }) => {
                ranges.iter().enumerate().flat_map(|(i, (_, low, high))| [(i, *low), (i, *high)]).collect()
            }
            Self::Grid { values, .. } => values.iter().map(|x| (0, *x)).collect(),
            Self::Words { .. } => Vec::new(),
        };
        numbers.into_iter().find(|(_, x)| !x.is_finite()).map_or(Ok(()), |found| Err(not_finite(found)))
    }
}

impl Plan {
    /// Cases of one plan at most: up to here every whole number is an `f64`, as programs read that know no other numbers.
    pub const LARGEST: u64 = 1 << 53;

    /// Without cases.
    pub fn new() -> Self {
        Self::default()
    }

    /// Each of `values` with all there is.
    #[must_use]
    pub fn grid(mut self, name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        self.factors.push(Factor::Grid { name: name.into(), values: values.into_iter().collect() });
        self
    }

    /// Each of `words` with all there is: names of methods, say.
    #[must_use]
    pub fn words<W: Into<String>>(mut self, name: impl Into<String>, words: impl IntoIterator<Item = W>) -> Self {
        self.factors.push(Factor::Words { name: name.into(), words: words.into_iter().map(Into::into).collect() });
        self
    }

    /// Each sample with all there is.
    #[must_use]
    pub fn samples(mut self, samples: Samples) -> Self {
        self.factors.push(Factor::Samples(samples));
        self
    }

    /// Each row of a list with all there is; `numbers` holds one row after the other, each with a number for each name.
    #[must_use]
    pub fn list<N: Into<String>>(mut self, names: impl IntoIterator<Item = N>, numbers: Vec<f64>) -> Self {
        self.factors.push(Factor::List { names: names.into_iter().map(Into::into).collect(), numbers });
        self
    }

    /// Number of cases.
    ///
    /// # Errors
    /// [`PlanError`] when the plan cannot be carried out.
    pub fn n_cases(&self) -> Result<u64, PlanError> {
        if self.factors.is_empty() {
            return Err(PlanError::Nothing);
        }
        self.factors.iter().try_for_each(Factor::check)?;
        let names = self.names();
        if let Some(i) = (1..names.len()).find(|i| names[..*i].contains(&names[*i])) {
            return Err(PlanError::Twice { name: names[i].to_owned() });
        }
        let n = self.factors.iter().try_fold(1, |n: u64, factor| n.checked_mul(factor.n()));
        n.filter(|n| *n <= Self::LARGEST).ok_or(PlanError::TooMany)
    }

    /// What is varied, in the order of [`Plan::values`].
    pub fn names(&self) -> Vec<&str> {
        self.factors.iter().flat_map(Factor::names).collect()
    }

    /// The values of case `index` of a plan that can be carried out.
    pub fn values(&self, index: u64) -> Vec<Value<'_>> {
        let mut rest = index;
        let mut digits: Vec<u64> = Vec::with_capacity(self.factors.len());
        for factor in self.factors.iter().rev() {
            digits.push(rest % factor.n());
            rest /= factor.n();
        }
        let mut values = Vec::new();
        self.factors.iter().zip(digits.iter().rev()).for_each(|(factor, i)| factor.push_values(*i, &mut values));
        values
    }

    /// The axes of a plan that is a grid of numbers alone: names and values.
    pub fn axes(&self) -> Option<Vec<(&str, &[f64])>> {
        let axis = |factor: &'_ Factor| matches!(factor, Factor::Grid { .. });
        self.factors.iter().all(axis).then(|| {
            let axes = self.factors.iter().filter_map(|factor| match factor {
                Factor::Grid { name, values } => Some((name.as_str(), &values[..])),
                _ => None,
            });
            axes.collect()
        })
    }

    /// Place of a name.
    pub(super) fn index(&self, name: &str) -> Result<usize, UnknownName> {
        find_name("value of the plan", name, self.names().into_iter())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Design;
    use super::*;

    #[test]
    fn analytic_cases_are_the_product_with_the_last_axis_fastest() {
        let plan =
            Plan::new().list(["a", "b"], vec![1.0, 2.0, 3.0, 4.0]).grid("x", [5.0, 6.0, 7.0]).words("w", ["u", "v"]);
        assert_eq!(plan.n_cases(), Ok(12));
        assert_eq!(plan.names(), ["a", "b", "x", "w"]);
        let expected = (0..2).flat_map(|i| (0..3).flat_map(move |j| (0..2).map(move |k| (i, j, k))));
        for (n, (i, j, k)) in expected.enumerate() {
            let [a, b] = [[1.0, 2.0], [3.0, 4.0]][i].map(Value::Number);
            let values = [a, b, Value::Number([5.0, 6.0, 7.0][j]), Value::Word(["u", "v"][k])];
            assert_eq!(plan.values(n as u64), values);
        }
    }

    #[test]
    fn invariant_plan_that_cannot_be_carried_out_says_why() {
        let refused = |plan: Plan| plan.n_cases().unwrap_err().to_string();
        let samples = |n| Samples::new(Design::Random, n, 0);
        for (plan, expected) in [
            (Plan::new(), "nothing is varied"),
            (Plan::new().grid("a", []), "`a` has no value"),
            (Plan::new().grid("a", [1.0]).samples(samples(3).over("a", 0.0, 1.0)), "`a` is varied twice"),
            (Plan::new().grid("a", [1.0, f64::NAN]), "`a` gets the value NaN"),
            (Plan::new().samples(samples(3).over("a", 0.0, f64::INFINITY)), "`a` gets the value inf"),
            (Plan::new().list(["a", "b"], vec![1.0]), "no multiple of its 2 names"),
            (Plan::new().list(["a"; 0], vec![1.0]), "no multiple of its 0 names"),
            (Plan::new().samples(samples(3)), "`list` has no value"),
            (Plan::new().samples(samples(1 << 60).over("a", 0.0, 1.0)), "more than 9e15 cases"),
        ] {
            let found = refused(plan);
            assert!(found.contains(expected), "{found}");
        }
    }
}
