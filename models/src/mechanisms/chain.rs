//! A chain of equal uniform rods that hangs from a pin: as many rods as a run asks for.
//!
//! ```text
//!  o ──link[0]── o ──link[1]── o ── … ── o ──link[n-1]── tip      drawn at all angles zero, the start of `swing`
//!  top         pin[1]        pin[2]
//! ```
//!
//! Coordinates: x, y, φ of each of the n rods; rows: two for each of the n hinges.
//! Degrees of freedom: n at position level, n at velocity level. Kinetic and potential energy together are constant without friction.
//! A tree: the solver's cost grows with n.
//! Source: a standard problem of multibody codes, e.g. Featherstone, "Rigid Body Dynamics Algorithms" (2008), ch. 10.
//!
#![doc = include_str!("../../sketches/chain.html")]

use ezy_core::model;

model! {
    /// Rods in a row, hung from one end.
    pub model Chain {
        /// number of rods
        count n = 10;
        /// length of a rod
        param l: m = 1.0;
        /// mass of a rod
        param m: kg = 1.0;
        /// gravity, downwards
        param g: m/s^2 = 9.81;

        body link[n] { mass: m, inertia: m*l^2/12 }
        hinge top: ground(0, 0) ~ link[0](-l/2, 0);
        for i in 1..n {
            hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0);
        }
        point tip = link[n-1](l/2, 0);
        gravity (0, -g);

        /// How low the tip is, as part of the whole length.
        output sag: 1 = -tip.y / (n*l);

        /// Every hinge resists its rate.
        effect friction_in_hinges {
            /// torque at a rate of one
            param d: N*m*s = 0.1;
            torque link[0]: -d * link[0].omega;
            for i in 1..n { torque link[i] ~ link[i-1]: -d * pin[i].rate; }
        }

        start level { for i in 0..n { link[i] angle 0; } at rest; }

        /// Released level and straight.
        scene swing { start level; until 1 s; }
        /// Released level and straight, with friction.
        scene settle { start level; until 1 s; with friction_in_hinges; }
    }
}
