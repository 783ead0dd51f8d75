//! The road train: a steered tractor with as many trailers as a run asks for, each hitched behind the axle ahead of it.
//!
//! ```text
//!        axle[1]  coupling[1]  axle[0]     hitch  rear_axle   kingpin
//!  … ───────┼──(trailer[1])──o────┼──(trailer[0])──o─────┼──(tractor)──o  (steer)
//! ```
//!
//! Coordinates: x, y, φ of `steer`, `tractor` and the n trailers; rows: two for each of the n + 1 joints, one for each of the
//! n + 2 axles, `steering`.
//! Degrees of freedom: n + 3 at position level, 1 at velocity level. With the steering locked the kinetic energy is constant, and the
//! axles settle on circles about one centre: R0 = L/tan δ, then R² + c² − l² from axle to axle, with c from an axle back to
//! the hitch and l from the hitch back to the next axle. In reverse the train jack-knifes.
//! Source: Laumond, IROS 1986; Rouchon, Fliess, Lévine, Martin, ECC 1993. The numbers are our own.
//!
#![doc = include_str!("../../sketches/roadtrain.html")]

use ezy_core::model;

model! {
    /// A steered tractor and a row of equal trailers.
    pub model RoadTrain {
        /// number of trailers
        count n = 5;
        /// steered axle, ahead of the tractor's rear axle
        param wheelbase: m = 1.0;
        /// tractor's centre of mass, ahead of its rear axle
        param centre: m = 0.4;
        /// hitch, behind the rear axle of the tractor or the axle of a trailer
        param c: m = 0.2;
        /// axle of a trailer, behind its hitch
        param l: m = 0.9;
        /// mass of the tractor
        param m_tractor: kg = 6.0;
        /// moment of inertia of the tractor
        param i_tractor: kg*m^2 = 0.9;
        /// mass of a trailer, centred on its axle
        param m: kg = 2.0;
        /// moment of inertia of a trailer
        param i: kg*m^2 = 0.3;
        /// mass of the steered axle
        param m_steer: kg = 0.4;
        /// moment of inertia of the steered axle
        param i_steer: kg*m^2 = 0.01;

        body steer { mass: m_steer, inertia: i_steer }
        body tractor { mass: m_tractor, inertia: i_tractor }
        body trailer[n] { mass: m, inertia: i }

        hinge kingpin: tractor(wheelbase - centre, 0) ~ steer(0, 0);
        hinge hitch: tractor(-centre - c, 0) ~ trailer[0](l, 0);
        for k in 1..n { hinge coupling[k]: trailer[k-1](-c, 0) ~ trailer[k](l, 0); }
        skate steered_axle: at steer(0, 0) along steer(1, 0);
        skate rear_axle: at tractor(-centre, 0) along tractor(1, 0);
        for k in 0..n { skate axle[k]: at trailer[k](0, 0) along trailer[k](1, 0); }

        /// The steering angle is prescribed.
        effect steering {
            /// mean angle
            param delta: rad = 0.2;
            /// amplitude of a swing about the mean
            param swing: rad = 0.0;
            /// angular frequency of the swing
            param nu: rad/s = 0.5;
            drive steering: kingpin.angle = delta + swing*sin(nu*t);
        }

        start straight {
            tractor at (0, 0) angle 0 velocity (2, _);
            for k in 0..n { trailer[k] angle 0; }
        }

        /// Enters a circle with locked steering.
        scene circling { start straight; until 30 s; with steering; }
    }
}
