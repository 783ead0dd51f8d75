//! A net of knots and threads that do not stretch, hung from its upper edge: as many meshes as a run asks for.
//!
//! ```text
//!   o top[0]    o top[1]    o top[2]        knot[0,j] is pinned
//!   │           │           │
//!   o───────────o───────────o               knot[1,j]
//!   │           │           │
//!   o───────────o───────────o               knot[2,j]
//! ```
//!
//! Coordinates: x, y, φ of each knot; rows: two for each pin, one for each thread.
//! Degrees of freedom of `rows = 3`, `columns = 3`: 27 − 6 − 6 − 4 = 11, of which 9 are angles of knots, which nothing turns.
//! Every mesh is a closed loop. Kinetic and potential energy together are constant.
//! Source: none; made to have two indices and many loops.
//!
#![doc = include_str!("../../sketches/hangingnet.html")]

use ezy_core::model;

model! {
    /// Knots in rows and columns with rigid threads between them.
    pub model HangingNet {
        /// rows of knots, the pinned one included
        count rows = 3;
        /// columns of knots
        count columns = 3;
        /// side of a mesh
        param a: m = 0.1;
        /// mass of a knot
        param m: kg = 0.01;
        /// inertia of a knot
        param inertia: kg*m^2 = 1e-5;
        /// gravity, downwards
        param g: m/s^2 = 9.81;
        /// speed with which the lower corner is pushed
        param push: m/s = 0.5;

        body knot[rows, columns] { mass: m, inertia: inertia }
        for j in 0..columns { hinge top[j]: ground(j*a, 0) ~ knot[0, j](0, 0); }
        for i in 1..rows {
            for j in 0..columns { rod warp[i, j]: knot[i-1, j](0, 0) ~ knot[i, j](0, 0) length a; }
            for j in 1..columns { rod weft[i, j]: knot[i, j-1](0, 0) ~ knot[i, j](0, 0) length a; }
        }
        for j in 0..columns { output hem[j]: m = knot[rows-1, j].y; }
        gravity (0, -g);

        start flat {
            for i in 0..rows {
                for j in 0..columns { knot[i, j] at (j*a, -i*a) angle 0 rate 0; }
            }
            knot[rows-1, 0] vx push;
        }

        /// Swings from a push at its lower corner.
        scene swing { start flat; until 0.3 s; }
    }
}
