//! A pendulum: a rod that swings about one end.
//!
//! ```text
//!   ground ──o═════════(rod)═════════    o hinge `pivot`, drawn at angle 0
//! ```
//!
//! Coordinates: `rod.x rod.y rod.phi`; rows: `pivot.x pivot.y`. Degrees of freedom: 1.
//! Without friction the sum of kinetic and potential energy is constant.

use ezy_core::model;

model! {
    /// A rod that swings about one end.
    pub model Pendulum {
        /// length of the rod
        param l: m = 1.0;
        /// its mass
        param mass: kg = 2.0;
        /// acceleration of gravity
        param g: m/s^2 = 9.81;

        body rod { mass: mass, inertia: mass*l^2/12 }
        hinge pivot: ground(0, 0) ~ rod(-l/2, 0);
        gravity (0, -g);

        /// Friction in the hinge, proportional to its speed.
        effect friction {
            /// torque per angular velocity
            param k: N*m*s/rad = 0.3;
            torque rod: -k * rod.omega;
        }

        start level { rod angle 0; at rest; }

        /// It swings for ever.
        scene swing { start level; until 5 s; }
        /// It comes to rest.
        scene damped { start level; until 5 s; with friction; }
    }
}
