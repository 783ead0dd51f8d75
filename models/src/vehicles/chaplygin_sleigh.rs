//! The Chaplygin sleigh: one body on a blade (or a wheel) that does not slip sideways.
//!
//! ```text
//!         a
//!  A ═══───────(sleigh)        drawn at sleigh.phi = 0
//!  blade    centre of mass
//! ```
//!
//! Coordinates: `sleigh.x sleigh.y sleigh.phi`; row: `blade`.
//! Degrees of freedom: 3 at position level, 2 at velocity level. On a level plane the kinetic energy is constant, and yet each motion
//! ends straight, with the centre of mass ahead of the blade: running backwards is unstable.
//! Closed form, with k² = (j + m a²)/m, c² = v0² + k² ω0², r = a c/k², τ = r t + artanh(v0/c): speed of the blade
//! v = c tanh τ, rate ω = ±(c/k) sech τ; the blade takes the force m (v ω + a ω̇).
//! Source: Chaplygin (1911), Carathéodory (1933); Bloch, "Nonholonomic Mechanics and Control", section 1.7.
//!
#![doc = include_str!("../../sketches/chaplyginsleigh.html")]

use ezy_core::model;

model! {
    /// A body on one blade.
    pub model ChaplyginSleigh {
        /// centre of mass, ahead of the blade
        param a: m = 1.0;
        /// mass
        param m: kg = 1.0;
        /// moment of inertia about the centre of mass
        param j: kg*m^2 = 1.0;

        body sleigh { mass: m, inertia: j }
        point A = sleigh(-a, 0);
        skate blade: at A along sleigh(1, 0);

        /// The plane falls along x.
        effect incline {
            /// gravity along the plane
            param slope: m/s^2 = 1.0;
            gravity (slope, 0);
        }

        start turning { sleigh at (a, 0) angle 0 velocity (0.1, _) rate 0.2; }

        /// On a level plane.
        scene coast { start turning; until 10 s; }
        /// On an inclined plane.
        scene downhill { start turning; until 10 s; with incline; }
    }
}
