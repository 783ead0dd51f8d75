//! Ways to assemble a mechanism over held coordinates.

use super::position_rows::{Condition, PositionRows};
use crate::model::SceneRef;

/// A way to assemble a mechanism: positions that follow from the held coordinates alone.
///
/// The lists have an entry for each value of one axis, or each place of two, the first axis slowest.
#[derive(Debug, Clone, PartialEq)]
pub struct AssemblyBranch {
    /// All coordinates, `n_q`; none where the place is not reachable.
    pub positions: Vec<Option<Vec<f64>>>,
    /// Smallest singular value of the Jacobian of the position rows by the coordinates that are not held, lengths in lengths of the mechanism
    /// and rows scaled to one: zero in a singular position. NaN where the place is not reachable.
    pub smallest_singular_value: Vec<f64>,
    /// The largest move of the other coordinates when the held ones move by one, both in rad and in lengths of the mechanism: infinite in
    /// a singular position. NaN where the place is not reachable.
    pub transmission: Vec<f64>,
    /// The least and the greatest value that is reached, over one coordinate.
    pub ends: Option<[ReachEnd; 2]>,
}

/// An end of the values that are reached.
#[derive(Debug, Clone, PartialEq)]
pub struct ReachEnd {
    /// The value of the coordinate that is held.
    pub value: f64,
    /// All coordinates there, `n_q`.
    pub q: Vec<f64>,
    /// Whether there are values beyond it.
    pub limit: Limit,
}

/// Why there are no values beyond an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// None were asked for.
    Range,
    /// The coordinate turns back: two ways of assembly meet.
    DeadCentre,
    /// No position was found beyond it: rows that have no value there, for one.
    Lost,
    /// The branch goes on, beyond the steps that are made at most.
    TooLong,
}

/// A position in which the held coordinates do not determine the others.
#[derive(Debug, Clone, PartialEq)]
pub struct SingularPosition {
    /// Value of the coordinate that is held.
    pub value: f64,
    /// All coordinates, `n_q`.
    pub q: Vec<f64>,
    /// What happens there.
    pub kind: Singularity,
}

/// What happens in a singular position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Singularity {
    /// The coordinate turns back: it reaches no further, and two ways of assembly meet.
    DeadCentre,
    /// The mechanism can go on in another way, as a parallelogram does where all bars are in line.
    ChangePoint,
}

impl AssemblyBranch {
    pub(super) fn new<P: SceneRef>(
        rows: &PositionRows<'_, P>,
        held: &[usize],
        positions: Vec<Option<Vec<f64>>>,
        ends: Option<[ReachEnd; 2]>,
    ) -> Self {
        let conditions = positions.iter().map(|q| q.as_ref().map_or(Condition::NONE, |q| rows.condition(q, held)));
        let (smallest_singular_value, transmission) = conditions.map(|c| (c.smallest, c.transmission)).unzip();
        Self { positions, smallest_singular_value, transmission, ends }
    }
}
