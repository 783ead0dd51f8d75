//! What a picture of a scene shows.

use super::{List, Name};

/// A point, a constraint or a force of a scene, as a picture shows it: where it is fixed to bodies.
///
/// [`Derived::element_values`](super::Derived::element_values) has its numbers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ElementInfo {
    /// The word of the language that declares it: `point`, `hinge`, `skate`, `spring`, …
    pub kind: &'static str,
    /// Name in the model file; empty for a force.
    pub name: Name,
    /// Its points.
    pub points: List<LocalVector>,
    /// Its directions; their length has no meaning.
    pub directions: List<LocalVector>,
    /// Bodies that it names without a point; `None` is the ground.
    pub bodies: List<Option<usize>>,
    /// Its settings that are not zero, as the model names them: `("stiffness", "k")`.
    pub settings: &'static [(&'static str, &'static str)],
    /// What is known of a force: the body on which it acts, and what it is.
    pub load: Option<(usize, LoadKind)>,
}

/// A point or a direction in the axes of a body, from its centre of mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LocalVector {
    /// Index of the body; `None` is the ground.
    pub body: Option<usize>,
    /// x and y as the model names them: `b`, `-d/2`, `0`; empty where they depend on the index of a `for`, which says nothing in a
    /// picture of one member.
    pub text: [&'static str; 2],
}

/// What acts on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadKind {
    /// x and y along the axes of the ground, N.
    Force,
    /// About the axis that points to the viewer, N m.
    Torque,
}

impl ElementInfo {
    /// Numbers that [`Derived::element_values`](super::Derived::element_values) writes for it: x and y of each point and
    /// direction, then the load.
    pub fn n_values(&self) -> usize {
        let n_load = match self.load {
            Some((_, LoadKind::Force)) => 2,
            Some((_, LoadKind::Torque)) => 1,
            None => 0,
        };
        2 * (self.points.len() + self.directions.len()) + n_load
    }
}
