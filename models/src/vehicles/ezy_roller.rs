//! The EzyRoller (roller racer): a seat and a front bar, each on one wheel, driven by swinging the bar.
//!
//! ```text
//!      a         b        d     c
//!  A ──────(1)──────── B ────(2)──── C        (1) seat, (2) bar, drawn stretched: bar.phi = seat.phi
//!  rear wheel        hinge       front wheel
//! ```
//!
//! Coordinates: `seat.x seat.y seat.phi bar.x bar.y bar.phi`; rows: `B.x B.y rear front`.
//! Degrees of freedom: 4 at position level, 2 at velocity level. Without a drive the kinetic energy is constant.
//! Source: "Multibody Dynamics B, Assignment 8" (2019), the report this model grew from; the driven roller racer is that
//! of Krishnaprasad and Tsakiris, Dynamical Systems 16 (2001).
//!
//! | scene | what happens |
//! |---|---|
//! | [`Coast`](ezy_roller::Coast) | no forces: the bar stands across, the seat moves at 1 m/s |
//! | [`Driven`](ezy_roller::Driven) | from rest, folded, driven by the torque of the rider |
//! | [`DrivenOnTarmac`](ezy_roller::DrivenOnTarmac) | driven, with rolling resistance |
//! | [`Drift`](ezy_roller::Drift) | driven, with a rear wheel that slips and rolls with resistance |
//! | [`Skid`](ezy_roller::Skid) | driven, with a rear wheel on ice that holds and slides by turns |
//! | [`Ridden`](ezy_roller::Ridden) | in the hands of a rider, who sets `torque` |
//!
//! Each page of a scene has its parameters and equations; [`MODEL`](ezy_roller::MODEL) is what a command line takes. [`study`](crate::study)
//! computes what the report stated.
//!
#![doc = include_str!("../../sketches/ezyroller.html")]

use ezy_core::model;

model! {
    /// A seat on a rear wheel, steered and driven by swinging a front bar on its own wheel.
    pub model EzyRoller {
        /// rear wheel A, behind the seat's centre of mass
        param a: m = 0.2;
        /// hinge B, ahead of the seat's centre of mass
        param b: m = 0.6;
        /// front wheel C, beyond the bar's centre of mass
        param c: m = 0.1;
        /// bar's centre of mass, beyond the hinge
        param d: m = 0.1;
        /// mass of seat and rider
        param m1: kg = 46.0;
        /// moment of inertia of seat and rider
        param i1: kg*m^2 = 10.0;
        /// mass of the bar
        param m2: kg = 1.0;
        /// moment of inertia of the bar
        param i2: kg*m^2 = 0.005;

        body seat { mass: m1, inertia: i1 }
        body bar { mass: m2, inertia: i2 }

        point A = seat(-a, 0);
        point C = bar(c, 0);

        hinge B: seat(b, 0) ~ bar(-d, 0);
        skate rear: at A along seat(1, 0);
        skate front: at C along bar(1, 0);

        /// The rider swings the bar: a torque between seat and bar.
        effect pump {
            /// largest torque
            param m0: N*m = 2.0;
            /// angular frequency of the torque
            param omega: rad/s = pi;
            torque seat ~ bar: m0 * cos(omega * t);
        }

        /// Drag of the rear wheel, proportional to its speed.
        effect rolling_resistance {
            /// drag per speed
            param k: N*s/m = 0.5;
            force at A: -k * A.v;
        }

        /// The rear wheel lets go: a side force against its slip replaces the skate.
        effect slip {
            /// side force per slip angle
            param cornering: N/rad = 400.0;
            /// speed below which the wheel creeps
            param creep: m/s = 0.1;
            release rear;
            tyre at A along seat(1, 0): stiffness cornering, speed creep;
        }

        /// The rear wheel on ice: it holds sideways up to a force and slides beyond it, with that force as friction.
        effect ice {
            /// largest side force
            param hold: N = 4.0;
            release rear;
            skate rear_on_ice: at A along seat(1, 0) limit hold;
        }

        /// The rider's arms, moved by whoever runs the scene.
        effect rider {
            /// torque that opens the hinge
            input torque: N*m = 0.0;
            /// how far the bar is turned against the seat
            output steering: deg = B.angle;
            output speed: m/s = dot(seat.v, (cos(seat.phi), sin(seat.phi)));
            torque bar ~ seat: torque;
        }

        start folded { seat at (0, 0) angle 0; bar angle pi; at rest; }
        start cross { seat at (a, 0) angle 0; bar angle pi/2; seat velocity (1, _) rate 0; }

        /// No forces: the bar stands across, the seat moves at 1 m/s.
        scene coast { start cross; until 1 s; }
        /// From rest, folded, driven by the rider's torque.
        scene driven { start folded; until 60 s; with pump; }
        /// Driven, with rolling resistance.
        scene driven_on_tarmac { start folded; until 60 s; with pump, rolling_resistance; }
        /// Driven, with a rear wheel that slips and rolls with resistance.
        scene drift { start folded; until 60 s; with pump, rolling_resistance, slip; }
        /// Driven, with a rear wheel on ice that holds and slides by turns.
        scene skid { start folded; until 20 s; with pump, ice; }
        /// At 1 m/s with the bar across, in the hands of a rider: set `torque`.
        scene ridden { start cross; until 10 s; with rider; }
    }
}
