//! The knife edge on an incline: a body on a blade below its centre of mass, on a plane that falls along x.
//!
//! ```text
//!  ═══(blade)═══  → x, downhill        drawn at blade.phi = 0
//! ```
//!
//! Coordinates: `blade.x blade.y blade.phi`; row: `edge`.
//! Degrees of freedom: 3 at position level, 2 at velocity level. Kinetic and potential energy together are constant.
//! The rate Ω is constant, and the blade does not run downhill: it goes sideways on a cycloid. Closed form, with
//! s = g sin α: v = v0 + (s/Ω)(sin φ − sin φ0), ẋ = v cos φ, ẏ = v sin φ; the edge takes the force m (v Ω + s sin φ).
//! Source: Neimark and Fufaev, "Dynamics of Nonholonomic Systems" (1972); Bloch, "Nonholonomic Mechanics and Control",
//! section 1.6; the default numbers are those of the benchmark of scipy_dae.
//!
#![doc = include_str!("../../sketches/knifeedge.html")]

use ezy_core::model;

model! {
    /// A blade that turns on an inclined plane.
    pub model KnifeEdge {
        /// mass
        param m: kg = 1.25;
        /// moment of inertia
        param j: kg*m^2 = 0.13;
        /// gravity
        param g: m/s^2 = 9.81;
        /// inclination of the plane
        param alpha: rad = pi/4;

        body blade { mass: m, inertia: j }
        skate edge: at blade(0, 0) along blade(1, 0);
        gravity (g*sin(alpha), 0);

        start turning { blade at (0, 0) angle 0 velocity (0, 0) rate pi/3; }

        /// From rest along the blade, turning steadily: one period of the cycloid.
        scene cycloid { start turning; until 6 s; }
    }
}
