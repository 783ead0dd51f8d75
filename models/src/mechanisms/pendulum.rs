//! The pendulum: one body on a pin.
//!
//! ```text
//!      l
//!  o ───────(bob)        drawn at bob.phi = 0, the start of `swing`; gravity points down
//!  pin
//! ```
//!
//! Coordinates: `bob.x bob.y bob.phi`; rows: `pin.x pin.y`.
//! Degrees of freedom: 1 at position level, 1 at velocity level. Kinetic and potential energy together are constant, zero in the scenes
//! without a post.
//! The default bob is a point: without moment of inertia the mass matrix is singular, while the motion is not.
//! Source: A01 of the multibody benchmark of A Coruña (2005), later in the IFToMM library; closed form by the elliptic
//! functions of Jacobi: sin(θ/2) = k sn(ωt + K(k), k) with θ from the downward vertical, ω² = g/l, k² = 1/2.
//!
#![doc = include_str!("../../sketches/pendulum.html")]

use ezy_core::model;

model! {
    /// A body that swings about a pin.
    pub model Pendulum {
        /// centre of mass, away from the pin
        param l: m = 1.0;
        /// mass
        param m: kg = 1.0;
        /// moment of inertia about the centre of mass, zero for a point
        param i: kg*m^2 = 0.0;
        /// gravity, downwards
        param g: m/s^2 = 9.81;

        body bob { mass: m, inertia: i }
        hinge pin: ground(0, 0) ~ bob(-l, 0);
        gravity (0, -g);

        /// Where it turns back.
        event turning: bob.omega = 0;

        /// A post below the pin, which the bob runs against.
        effect post {
            /// part of the speed that an impact gives back
            param e = 0.8;
            stop post: bob.x from 0 restitution e;
        }

        start right { bob near angle 0; at rest; }
        start left { bob near angle pi; at rest; }

        /// Released level, on the right of the pin.
        scene swing { start right; until 10 s; }
        /// Released level, on the left of the pin.
        scene mirrored { start left; until 10 s; }
        /// Released level, on the right of the pin, until it hangs below.
        scene quarter { start right; until 10 s; until bob.x < 0; }
        /// Released level, on the right of the pin, against the post.
        scene knocking { start right; until 10 s; with post; }
    }
}
