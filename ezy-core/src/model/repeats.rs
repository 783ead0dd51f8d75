//! Scenes with counts: numbers of a run that say how often bodies, constraints and forces are repeated.

use super::{Equation, List, RowInfo};
use crate::memory::readable;

/// A count: a whole number, at least one, that can be changed without compiling again.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CountInfo {
    /// Name in the model file and of the field.
    pub name: &'static str,
    /// Declared value.
    pub default: usize,
    /// Doc comment of the declaration.
    pub documentation: &'static str,
}

/// Place of a coordinate that a template refers to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SlotCoordinate {
    /// Index into the bodies that the template refers to.
    pub slot: usize,
    /// 0 for x, 1 for y, 2 for the angle.
    pub component: usize,
}

/// One scalar row of a template.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RowTemplate {
    /// What follows the name of the item: `.x`, or nothing.
    pub suffix: &'static str,
    /// What every member shares; its name is that of the template.
    pub row: RowInfo,
    /// Whether it is a position constraint.
    pub position: bool,
    /// Coordinates of the entries of the row of G, in the order in which the kernel writes them.
    pub entries: &'static [SlotCoordinate],
}

/// Equations that all members of one repeated item share, written with its index.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TemplateInfo {
    /// Name of the item without its index, `pin`; empty for a force.
    pub name: &'static str,
    /// The word that declares it: `hinge`, `body`, …
    pub word: &'static str,
    /// The ranges of its indices as written, outermost first: `i in 1..n`. Empty outside `for`.
    pub ranges: &'static [&'static str],
    /// `hinge pin, i in 1..n`
    pub title: &'static str,
    /// Its rows.
    pub rows: &'static [RowTemplate],
    /// With the indices of the item in them.
    pub equations: &'static [Equation],
}

/// Additional data of a scene with counts: sizes of this run, and equations by template.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Repeats {
    /// The counts in declared order.
    pub counts: &'static [CountInfo],
    /// Their present values.
    pub values: List<usize>,
    /// Equations of each item, in declared order.
    pub templates: &'static [TemplateInfo],
    /// Why the scene cannot be set up with these counts. Its other descriptions are then meaningless.
    pub fault: Option<LayoutFault>,
}

/// Largest number of bodies and members of each `for` together: some gigabytes.
pub(crate) const LARGEST_N_MEMBERS: usize = 4_000_000;

/// A count beyond it is a slip, and is refused before anything is set up.
pub(crate) const LARGEST_COUNT: usize = 1_000_000;

/// Counts that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum LayoutFault {
    /// A count is zero.
    #[error("count `{name}` is 0; give it at least 1")]
    NoMembers {
        /// Name of the count.
        name: &'static str,
    },
    /// A count is too large by itself.
    #[error("count `{name}` is {count}; give it at most {LARGEST_COUNT}")]
    LargeCount {
        /// Name of the count.
        name: &'static str,
        /// Its value.
        count: usize,
    },
    /// Too many bodies and members.
    #[error(
        "the counts ask for {n_members} bodies and repeated items; at most {LARGEST_N_MEMBERS} are set up: give a \
         smaller count"
    )]
    TooManyMembers {
        /// Members asked for, as far as they were counted.
        n_members: usize,
    },
    /// The machine has less memory than bodies and members need.
    #[error(
        "the counts ask for {n_members} bodies and repeated items, which need about {}; the machine has {} left: give a \
         smaller count", readable(*.needed), readable(*.available)
    )]
    Memory {
        /// Members asked for.
        n_members: usize,
        /// Bytes that they need in a run.
        needed: u64,
        /// Bytes that the machine has left.
        available: u64,
    },
    /// An item refers to a member that its array does not have.
    #[error(
        "{item} uses `{array}` at the index {index}, but its indices go from 0 to {}: change the range of the `for`, \
         the index or the count", length.saturating_sub(1)
    )]
    IndexOutOfRange {
        /// The item with its indices: hinge `pin[0]`.
        item: String,
        /// The array.
        array: &'static str,
        /// The index that it does not have.
        index: i64,
        /// Its number of members along this index.
        length: usize,
    },
}
