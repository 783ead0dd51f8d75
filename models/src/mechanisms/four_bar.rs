//! The four-bar: crank, coupler and rocker on a base, a closed loop.
//!
//! ```text
//!        B ──(coupler)── C
//!        │               │
//!     (crank)         (rocker)       drawn upright, the start of every scene
//!        │               │
//!        A ─ ─  base ─ ─ D
//! ```
//!
//! Coordinates: x, y, φ of `crank`, `coupler`, `rocker`; rows: `A B C D` with two components each.
//! Degrees of freedom: 1 at position level, 1 at velocity level; driven: none. Undriven: kinetic and potential energy are constant.
//! The default bars are a parallelogram. Whenever it lies flat the rows lose a rank and the motion could branch off; on the
//! branch that stays a parallelogram it is one pendulum with moment of inertia 5/3 kg·m² and m g l = 19.62 N·m.
//! Runs lead over flat positions by steps that begin and end well away from them.
//! Source: A02 of the multibody benchmark of A Coruña (2005) with N = 1, after Bayo and Avello, Nonlinear Dynamics 5 (1994).
//!
#![doc = include_str!("../../sketches/fourbar.html")]

use ezy_core::model;

model! {
    /// A closed loop of three bars on a base.
    pub model FourBar {
        /// distance of the two bearings
        param base: m = 1.0;
        /// length of the crank
        param l1: m = 1.0;
        /// length of the coupler
        param l2: m = 1.0;
        /// length of the rocker
        param l3: m = 1.0;
        /// mass of the crank
        param m1: kg = 1.0;
        /// mass of the coupler
        param m2: kg = 1.0;
        /// mass of the rocker
        param m3: kg = 1.0;
        /// gravity, downwards
        param g: m/s^2 = 9.81;

        body crank { mass: m1, inertia: m1*l1^2/12 }
        body coupler { mass: m2, inertia: m2*l2^2/12 }
        body rocker { mass: m3, inertia: m3*l3^2/12 }

        hinge A: ground(0, 0) ~ crank(-l1/2, 0);
        hinge B: crank(l1/2, 0) ~ coupler(-l2/2, 0);
        hinge C: coupler(l2/2, 0) ~ rocker(l3/2, 0);
        hinge D: ground(base, 0) ~ rocker(-l3/2, 0);
        gravity (0, -g);

        /// The angle of the crank is prescribed.
        effect motor {
            /// angle at t = 0
            param angle: rad = pi/2;
            /// mean angular velocity
            param omega: rad/s = 0.0;
            /// amplitude of a swing about the mean
            param swing: rad = 0.5;
            /// angular frequency of the swing
            param nu: rad/s = 3.0;
            drive motor: crank.phi = angle + omega*t + swing*sin(nu*t);
        }

        start falling { crank angle pi/2 rate -1; coupler near angle 0; rocker near angle pi/2; }
        start upright { coupler near angle 0; rocker near angle pi/2; }

        /// Falls from upright with 1 m/s and turns on.
        scene turning { start falling; until 20 s; }
        /// The crank is swung to and fro.
        scene driven { start upright; until 2 s; with motor; }
    }
}
