//! Whole numbers of a model: counts, indices of `for`, and what is computed from them.

/// Index into [`super::Model::counts`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CountId(pub usize);
/// Index into [`super::Model::indices`]; of two `for` in each other the inner one has the larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct IndexId(pub usize);

/// Index into [`super::Model::quotients`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct QuotientId(pub usize);

/// A whole number that is known when a run begins, or in a pass of a `for`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Whole {
    Number(i64),
    Count(CountId),
    Index(IndexId),
    Sum(Box<Whole>, Box<Whole>),
    Difference(Box<Whole>, Box<Whole>),
    Product(Box<Whole>, Box<Whole>),
    /// By a number above zero, rounded down: the member in the middle is `link[n/2]`.
    Quotient(Box<Whole>, i64),
}

/// Values of counts and indices by their ids; `None` for an index that has none now.
pub struct Values<'a> {
    pub counts: &'a [i64],
    pub indices: &'a [(IndexId, i64)],
}

/// Names of counts and indices by their ids.
pub struct WholeNames<'a> {
    pub counts: &'a [String],
    pub indices: &'a [String],
}

impl Whole {
    /// `None` where an index has no value, or beyond 64 bits.
    pub fn evaluate(&self, values: &Values<'_>) -> Option<i64> {
        let both = |a: &Self, b: &Self| Some((a.evaluate(values)?, b.evaluate(values)?));
        match self {
            Self::Number(number) => Some(*number),
            Self::Count(id) => values.counts.get(id.0).copied(),
            Self::Index(id) => values.indices.iter().find(|(other, _)| other == id).map(|(_, value)| *value),
            Self::Sum(a, b) => both(a, b).and_then(|(a, b)| a.checked_add(b)),
            Self::Difference(a, b) => both(a, b).and_then(|(a, b)| a.checked_sub(b)),
            Self::Product(a, b) => both(a, b).and_then(|(a, b)| a.checked_mul(b)),
            Self::Quotient(a, b) => a.evaluate(values)?.checked_div_euclid(*b),
        }
    }

    pub fn depends_on(&self, index: IndexId) -> bool {
        match self {
            Self::Number(_) | Self::Count(_) => false,
            Self::Index(id) => *id == index,
            Self::Sum(a, b) | Self::Difference(a, b) | Self::Product(a, b) => {
                a.depends_on(index) || b.depends_on(index)
            }
            Self::Quotient(a, _) => a.depends_on(index),
        }
    }

    /// The index of the innermost `for` that it depends on.
    pub fn innermost(&self) -> Option<IndexId> {
        match self {
            Self::Number(_) | Self::Count(_) => None,
            Self::Index(id) => Some(*id),
            Self::Sum(a, b) | Self::Difference(a, b) | Self::Product(a, b) => a.innermost().max(b.innermost()),
            Self::Quotient(a, _) => a.innermost(),
        }
    }

    /// As written: `i-1`.
    pub fn text(&self, names: &WholeNames<'_>) -> String {
        let in_product = |part: &Self| match part {
            Self::Sum(..) | Self::Difference(..) => format!("({})", part.text(names)),
            _ => part.text(names),
        };
        match self {
            Self::Number(number) => number.to_string(),
            Self::Count(id) => names.counts[id.0].clone(),
            Self::Index(id) => names.indices[id.0].clone(),
            Self::Sum(a, b) => format!("{}+{}", a.text(names), b.text(names)),
            Self::Difference(a, b) => match **b {
                Self::Sum(..) | Self::Difference(..) => format!("{}-({})", a.text(names), b.text(names)),
                _ => format!("{}-{}", a.text(names), b.text(names)),
            },
            Self::Product(a, b) => match **b {
                Self::Quotient(..) => format!("{}*({})", in_product(a), b.text(names)),
                _ => format!("{}*{}", in_product(a), in_product(b)),
            },
            Self::Quotient(a, b) => format!("{}/{b}", in_product(a)),
        }
    }

    pub fn sum(a: Self, b: Self) -> Self {
        match (a, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a.saturating_add(b)),
            (a, Self::Number(0)) => a,
            (Self::Number(0), b) => b,
            (a, b) => Self::Sum(Box::new(a), Box::new(b)),
        }
    }

    pub fn difference(a: Self, b: Self) -> Self {
        match (a, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a.saturating_sub(b)),
            (a, Self::Number(0)) => a,
            (a, b) => Self::Difference(Box::new(a), Box::new(b)),
        }
    }

    pub fn product(a: Self, b: Self) -> Self {
        match (a, b) {
            (Self::Number(a), Self::Number(b)) => Self::Number(a.saturating_mul(b)),
            (a, Self::Number(1)) | (Self::Number(1), a) => a,
            (a, b) => Self::Product(Box::new(a), Box::new(b)),
        }
    }

    /// `None` where the divisor is no number above zero.
    pub fn quotient(a: Self, b: Self) -> Option<Self> {
        match (a, b) {
            (a, Self::Number(1)) => Some(a),
            (Self::Number(a), Self::Number(b)) if b > 0 => Some(Self::Number(a.div_euclid(b))),
            (a, Self::Number(b)) if b > 0 => Some(Self::Quotient(Box::new(a), b)),
            _ => None,
        }
    }
}
