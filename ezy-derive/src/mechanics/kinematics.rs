//! Positions, directions and velocities of points fixed to bodies.

use super::expression::Writer;
use crate::model::{BodyId, Component, Direction, Place};
use crate::symbolic::{SumId, Symbol};

/// Components along the ground's axes.
pub type Vector = [SumId; 2];

impl Writer<'_> {
    /// Position of a point, m.
    pub fn position(&mut self, place: &Place) -> Vector {
        let local = [self.write(&place.x), self.write(&place.y)];
        let Some(body) = place.body else { return local };
        // the centre comes first, so that equations print it first
        let centre = [Component::X, Component::Y].map(|component| {
            let symbol = self.symbols.coordinate(body, component);
            self.algebra.symbol(symbol)
        });
        let arm = self.turned(local, Some(body));
        std::array::from_fn(|i| self.algebra.add(centre[i], arm[i]))
    }

    /// Velocity of a point, m/s.
    pub fn velocity(&mut self, place: &Place) -> Vector {
        self.position(place).map(|x| self.time_derivative(x))
    }

    /// Vector from the first point to the second one.
    pub fn gap(&mut self, a: &Place, b: &Place) -> Vector {
        let (a, b) = (self.position(a), self.position(b));
        std::array::from_fn(|i| self.algebra.sub(b[i], a[i]))
    }

    pub fn length(&mut self, a: Vector) -> SumId {
        let square = self.dot(a, a);
        let half = self.algebra.number(0.5);
        self.algebra.pow(square, half)
    }

    /// A direction scaled to length one.
    pub fn unit_direction(&mut self, direction: &Direction) -> Vector {
        let local = [self.write(&direction.x), self.write(&direction.y)];
        let length = self.length(local);
        let local = local.map(|x| self.algebra.div(x, length));
        self.turned(local, direction.body)
    }

    pub fn dot(&mut self, a: Vector, b: Vector) -> SumId {
        let products = [self.algebra.mul(a[0], b[0]), self.algebra.mul(a[1], b[1])];
        self.algebra.add(products[0], products[1])
    }

    /// A vector turned by +90°.
    pub fn across(&mut self, a: Vector) -> Vector {
        [self.algebra.neg(a[1]), a[0]]
    }

    /// d/dt along the motion: ∂/∂t + Σ q̇ᵢ ∂/∂qᵢ. Velocities are held.
    pub fn time_derivative(&mut self, a: SumId) -> SumId {
        let mut parts = vec![self.algebra.diff(a, Symbol::TIME)];
        for i in self.coordinates_of(a) {
            let slope = self.algebra.diff(a, self.symbols.coordinate_at(i));
            let rate = self.algebra.symbol(self.symbols.velocity_at(i));
            parts.push(self.algebra.mul(slope, rate));
        }
        self.algebra.total(&parts)
    }

    /// The coordinates that an expression depends on; at the first call all of them, so that velocities are created in
    /// their order, which is the order in which terms are written.
    fn coordinates_of(&mut self, a: SumId) -> Vec<usize> {
        if !std::mem::replace(&mut self.knows_velocities, true) {
            return (0..self.symbols.n_coordinates()).collect();
        }
        let symbols = self.algebra.symbols_of(a);
        symbols.into_iter().filter_map(|symbol| self.symbols.coordinate_of(symbol)).collect()
    }

    fn turned(&mut self, local: Vector, body: Option<BodyId>) -> Vector {
        let Some(body) = body else { return local };
        let angle = self.symbols.coordinate(body, Component::Phi);
        let angle = self.algebra.symbol(angle);
        let (sin, cos) = self.algebra.sin_cos(angle);
        let [x, y] = local;
        let (xc, ys) = (self.algebra.mul(x, cos), self.algebra.mul(y, sin));
        let (xs, yc) = (self.algebra.mul(x, sin), self.algebra.mul(y, cos));
        [self.algebra.sub(xc, ys), self.algebra.add(xs, yc)]
    }
}
