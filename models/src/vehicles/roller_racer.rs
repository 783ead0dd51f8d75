//! The roller racer: a seat on one axle, a handle on another, moved by the angle between them.
//!
//! ```text
//!      a         b       h     c
//!  A ──────(seat)─── B ────(handle)── C        drawn stretched: handle.phi = seat.phi
//!  rear axle       hinge            front axle
//! ```
//!
//! Coordinates: `seat.x seat.y seat.phi handle.x handle.y handle.phi`; rows: `B.x B.y rear front`.
//! Degrees of freedom: 4 at position level, 2 at velocity level. Without actuation and losses the kinetic energy is constant.
//! With h = 0 and c < 0 the front axle trails the hinge, as a caster does; with c > 0 it is the twistcar, whose rider
//! works against a spring.
//! Source: Krishnaprasad and Tsakiris, Dynamical Systems 16 (2001); Chakon and Or, J. Nonlinear Science 27 (2017), for the
//! twistcar; Bizyaev, Regular and Chaotic Dynamics 22 (2017), for the free motion. The numbers are our own.
//!
#![doc = include_str!("../../sketches/rollerracer.html")]

use ezy_core::model;

model! {
    /// Two hinged bodies, each on one axle, rowed by a torque between them.
    pub model RollerRacer {
        /// rear axle, behind the seat's centre of mass
        param a: m = 0.3;
        /// hinge, ahead of the seat's centre of mass
        param b: m = 0.2;
        /// handle's centre of mass, beyond the hinge
        param h: m = 0.0;
        /// front axle, beyond the handle's centre of mass
        param c: m = -0.1;
        /// mass of seat and rider
        param m1: kg = 2.0;
        /// moment of inertia of seat and rider
        param i1: kg*m^2 = 0.05;
        /// mass of the handle
        param m2: kg = 0.3;
        /// moment of inertia of the handle
        param i2: kg*m^2 = 0.004;

        body seat { mass: m1, inertia: i1 }
        body handle { mass: m2, inertia: i2 }
        point A = seat(-a, 0);
        point C = handle(c, 0);

        hinge B: seat(b, 0) ~ handle(-h, 0);
        skate rear: at A along seat(1, 0);
        skate front: at C along handle(1, 0);

        /// The rider turns the handle to and fro.
        effect rowing {
            /// amplitude of the torque on the handle
            param m0: N*m = 0.3;
            /// its mean
            param mean: N*m = 0.0;
            /// angular frequency
            param omega: rad/s = 4.0;
            /// phase at t = 0
            param phase: rad = 0.0;
            torque handle ~ seat: mean + m0 * sin(omega*t + phase);
        }

        /// A spring with a damper at the hinge.
        effect spring {
            /// stiffness
            param k: N*m = 0.8;
            /// damping
            param damping: N*m*s = 0.05;
            /// angle of the handle without torque
            param angle: rad = 0.0;
            torsion seat ~ handle: stiffness k, angle angle, damping damping;
        }

        /// Both wheels roll against a steady resistance.
        effect rolling_resistance {
            /// resistance of each wheel
            param resistance: N = 0.2;
            /// speed at which it has grown to seven tenths
            param knee: m/s = 0.01;
            friction at A along seat(1, 0): force resistance, speed knee;
            friction at C along handle(1, 0): force resistance, speed knee;
        }

        start moving { seat at (a, 0) angle 0 velocity (1, _) rate 0.5; handle angle 0.8; }
        start standing { seat at (a, 0) angle 0; handle angle 0.3; at rest; }

        /// Rolls freely.
        scene coast { start moving; until 10 s; }
        /// From rest, rowed.
        scene rowed { start standing; until 5 s; with rowing; }
        /// From rest, rowed against rolling resistance.
        scene rowed_on_tarmac { start standing; until 30 s; with rowing, rolling_resistance; }
        /// Rowed against a spring.
        scene twistcar { start moving; until 8 s; with rowing, spring; }
        /// Rolls out.
        scene rolling_out { start moving; until 2 s; with rolling_resistance; }
    }
}
