//! A row of n four-bar linkages that share their cranks: as many closed loops as a run asks for.
//!
//! ```text
//!   o──coupler[0]──o──coupler[1]──o      the start: upright, the joints on top move to the right at 1 m/s
//!   │              │              │
//! crank[0]      crank[1]       crank[2]
//!   │              │              │
//!   o foot[0]      o foot[1]      o foot[2]
//! ```
//!
//! Coordinates: x, y, φ of n + 1 cranks and n couplers; rows: two for each of the 3 n + 1 hinges.
//! Degrees of freedom: 1 at position level, 1 at velocity level. Kinetic and potential energy together are constant.
//! Whenever the cranks lie level the rows lose rank and the freedom would be n + 1; with parallel cranks the motion is that
//! of a pendulum, `φ'² = 1 + 2 ω² (1 − cos φ)` with φ from the upright, `ω² = g (3 n + 1)/2 / ((n + 1)/3 + n) / l`.
//! Source: problem A02 of the benchmark library of IFToMM's technical committee for multibody dynamics; Bayo, Avello (1994).
//!
#![doc = include_str!("../../sketches/nfourbar.html")]

use ezy_core::model;

model! {
    /// Parallelograms side by side.
    pub model NFourBar {
        /// number of loops
        count n = 2;
        /// length of every rod
        param l: m = 1.0;
        /// mass of every rod
        param m: kg = 1.0;
        /// gravity, downwards
        param g: m/s^2 = 9.81;

        body crank[n+1] { mass: m, inertia: m*l^2/12 }
        body coupler[n] { mass: m, inertia: m*l^2/12 }
        for i in 0..n+1 { hinge foot[i]: ground(i*l, 0) ~ crank[i](-l/2, 0); }
        for i in 0..n {
            hinge left[i]: crank[i](l/2, 0) ~ coupler[i](-l/2, 0);
            hinge right[i]: crank[i+1](l/2, 0) ~ coupler[i](l/2, 0);
        }
        gravity (0, -g);

        start upright {
            for i in 0..n+1 { crank[i] angle pi/2; }
            for i in 0..n { coupler[i] angle 0; }
            crank[0] rate -1;
        }

        /// Falls over to the right, up to shortly before the cranks lie level.
        scene fall { start upright; until 0.5 s; }
    }
}
