//! The double pendulum: two uniform rods in a row, from a pin.
//!
//! ```text
//!       l1             l2
//!  o ───(upper)─── o ───(lower)───      drawn at upper.phi = lower.phi = 0, the start of `swing`
//!  top           elbow
//! ```
//!
//! Coordinates: `upper.x upper.y upper.phi lower.x lower.y lower.phi`; rows: `top.x top.y elbow.x elbow.y`.
//! Degrees of freedom: 2 at position level, 2 at velocity level. Kinetic and potential energy together are constant.
//! Released level, two equal rods begin with angular accelerations of −9g/(7l) and +3g/(7l).
//! The motion is chaotic: a change of the first angle has grown 12,000 times after 10 s.
//! Source: a standard problem, e.g. Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I" (1993), with rods.
//!
#![doc = include_str!("../../sketches/doublependulum.html")]

use ezy_core::model;

model! {
    /// Two rods that swing about a pin and an elbow.
    pub model DoublePendulum {
        /// length of the upper rod
        param l1: m = 1.0;
        /// length of the lower rod
        param l2: m = 1.0;
        /// mass of the upper rod
        param m1: kg = 1.0;
        /// mass of the lower rod
        param m2: kg = 1.0;
        /// gravity, downwards
        param g: m/s^2 = 9.81;

        body upper { mass: m1, inertia: m1*l1^2/12 }
        body lower { mass: m2, inertia: m2*l2^2/12 }
        hinge top: ground(0, 0) ~ upper(-l1/2, 0);
        hinge elbow: upper(l1/2, 0) ~ lower(-l2/2, 0);
        gravity (0, -g);

        start level { upper angle 0; lower angle 0; at rest; }

        /// Released level and straight.
        scene swing { start level; until 10 s; }
    }
}
