//! Start values that gave way to the constraints.

use crate::model::{CoordinateInfo, Name};
use crate::scalar::rounded;

/// A start value that was given, but may change ([`near_position`], [`give_way`]), and did.
///
/// [`near_position`]: crate::model::Start::near_position
/// [`give_way`]: crate::model::Start::give_way
#[derive(Debug, Clone, PartialEq)]
pub struct MovedValue {
    /// Name of the coordinate or velocity.
    pub name: Name,
    /// `m`, `rad`, `m/s` or `rad/s`.
    pub unit: &'static str,
    /// The value that was given.
    pub given: f64,
    /// The value with which the constraints are met.
    pub got: f64,
}

impl MovedValue {
    /// Of a coordinate or velocity of a start, and of what was assembled from it.
    pub(super) fn of(coordinate: &CoordinateInfo, given: f64, got: f64) -> Self {
        Self { name: coordinate.name.clone(), unit: coordinate.unit, given, got }
    }

    /// `rod.phi near 1.2 rad`
    pub(super) fn asked(&self) -> String {
        format!("{} near {} {}", self.name, told(self.given), self.unit)
    }

    /// `rod.phi = -1.2 rad`
    pub(super) fn reached(&self) -> String {
        format!("{} = {} {}", self.name, told(self.got), self.unit)
    }
}

/// With so many digits that a value which is given again only gets its last ones.
fn told(x: f64) -> String {
    rounded(x, 8)
}

/// `rod.phi from 1.2 rad to -1.2 rad`
impl std::fmt::Display for MovedValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { name, unit, given, got } = self;
        write!(f, "{name} from {} {unit} to {} {unit}", told(*given), told(*got))
    }
}
