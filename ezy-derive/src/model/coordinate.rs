//! The coordinates of a body: what they are called, whether they are lengths or angles, and where they stand in q.

use super::BodyId;
use super::dimension::Dimension;

/// x, y or φ of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Component {
    X,
    Y,
    Phi,
}

/// A coordinate of a body. Those of a body stand together in q, bodies in declared order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coordinate {
    pub body: BodyId,
    pub component: Component,
}

impl Component {
    /// In the order in which they stand in q.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Phi];

    /// Its name in the model file, or that of its velocity.
    pub const fn name(self, rate: bool) -> &'static str {
        match (self, rate) {
            (Self::X, false) => "x",
            (Self::Y, false) => "y",
            (Self::Phi, false) => "phi",
            (Self::X, true) => "vx",
            (Self::Y, true) => "vy",
            (Self::Phi, true) => "omega",
        }
    }

    pub const fn is_angle(self) -> bool {
        matches!(self, Self::Phi)
    }

    pub const fn unit(self) -> &'static str {
        if self.is_angle() { "rad" } else { "m" }
    }

    /// Of the coordinate, or of its velocity.
    pub const fn dimension(self, rate: bool) -> Dimension {
        match (self.is_angle(), rate) {
            (true, false) => Dimension::ANGLE,
            (true, true) => Dimension::ANGULAR_VELOCITY,
            (false, false) => Dimension::LENGTH,
            (false, true) => Dimension::VELOCITY,
        }
    }

    /// Its entry of M.
    pub fn inertia<T>(self, mass: T, moment: T) -> T {
        if self.is_angle() { moment } else { mass }
    }
}

impl Coordinate {
    /// The coordinates of a body.
    pub fn of(body: BodyId) -> [Self; Component::ALL.len()] {
        Component::ALL.map(|component| Self { body, component })
    }

    /// What stands at a place of q.
    pub const fn at(place: usize) -> Self {
        let n = Component::ALL.len();
        Self { body: BodyId(place / n), component: Component::ALL[place % n] }
    }

    /// Its place in q.
    pub const fn place(self) -> usize {
        Component::ALL.len() * self.body.0 + self.component as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_places_of_coordinates_count_on() {
        let coordinates = (0..4).map(BodyId).flat_map(Coordinate::of);
        for (place, coordinate) in coordinates.enumerate() {
            assert_eq!((coordinate.place(), Coordinate::at(place)), (place, coordinate));
        }
        assert!(Coordinate::at(5).component.is_angle() && !Coordinate::at(6).component.is_angle());
    }
}
