//! A tractor with two trailers: four bodies in a row, an axle on each.
//!
//! ```text
//!      axle2  hook2   hitch2 axle1  hook1  hitch1 rear   front
//!   ───┼──(second)──o──────┼──(first)───o─────┼──(tractor)──o  (steer)
//! ```
//!
//! Coordinates: x, y, φ of `steer`, `tractor`, `first`, `second`; rows: `kingpin`, `hitch`, `coupling` with two components
//! each, `steered_axle`, `rear_axle`, `first_axle`, `second_axle`; steered: `steering`.
//! Degrees of freedom: 6 at position level, 2 at velocity level; steered: 5 and 1. With the steering locked the kinetic energy is
//! constant, and the axles settle on circles: R0 = L/tan δ, R²(i+1) = R²(i) + c² − l² with c the hitch's distance from the
//! axle ahead of it and l the hitch's distance from the axle behind it. In reverse the trailers jack-knife.
//! Source: Laumond, IROS 1986; Rouchon, Fliess, Lévine, Martin, ECC 1993. The numbers are our own.
//!
#![doc = include_str!("../../sketches/tractortrailers.html")]

use ezy_core::model;

model! {
    /// A steered tractor that pulls two trailers hitched off their axles.
    pub model TractorTrailers {
        /// steered axle, ahead of the tractor's centre of mass
        param front: m = 0.6;
        /// rear axle, behind the tractor's centre of mass
        param rear: m = 0.4;
        /// hitch, behind the tractor's centre of mass
        param hitch1: m = 0.3;
        /// hitch, ahead of the first trailer's centre of mass
        param hook1: m = 0.8;
        /// axle, behind the first trailer's centre of mass
        param axle1: m = 0.1;
        /// hitch, behind the first trailer's centre of mass
        param hitch2: m = 0.2;
        /// hitch, ahead of the second trailer's centre of mass
        param hook2: m = 0.7;
        /// axle, behind the second trailer's centre of mass
        param axle2: m = 0.1;
        /// mass of the steered axle
        param m_steer: kg = 0.4;
        /// moment of inertia of the steered axle
        param i_steer: kg*m^2 = 0.01;
        /// mass of the tractor
        param m_tractor: kg = 6.0;
        /// moment of inertia of the tractor
        param i_tractor: kg*m^2 = 0.9;
        /// mass of the first trailer
        param m_first: kg = 3.0;
        /// moment of inertia of the first trailer
        param i_first: kg*m^2 = 0.4;
        /// mass of the second trailer
        param m_second: kg = 2.0;
        /// moment of inertia of the second trailer
        param i_second: kg*m^2 = 0.25;

        body steer { mass: m_steer, inertia: i_steer }
        body tractor { mass: m_tractor, inertia: i_tractor }
        body first { mass: m_first, inertia: i_first }
        body second { mass: m_second, inertia: i_second }

        point A = tractor(-rear, 0);
        point B = first(-axle1, 0);
        point C = second(-axle2, 0);

        hinge kingpin: tractor(front, 0) ~ steer(0, 0);
        hinge hitch: tractor(-hitch1, 0) ~ first(hook1, 0);
        hinge coupling: first(-hitch2, 0) ~ second(hook2, 0);
        skate steered_axle: at steer(0, 0) along steer(1, 0);
        skate rear_axle: at A along tractor(1, 0);
        skate first_axle: at B along first(1, 0);
        skate second_axle: at C along second(1, 0);

        /// The steering angle is prescribed.
        effect steering {
            /// mean angle
            param delta: rad = 0.35;
            /// rate of the mean angle
            param delta_rate: rad/s = 0.0;
            /// amplitude of a swing about the mean
            param swing: rad = 0.0;
            /// angular frequency of the swing
            param nu: rad/s = 1.0;
            /// phase at t = 0
            param nu_phase: rad = 0.0;
            drive steering: kingpin.angle = delta + delta_rate*t + swing*sin(nu*t + nu_phase);
        }

        /// The driver's torque on the steered axle, against a spring with a damper.
        effect slalom {
            /// amplitude of the torque
            param m0: N*m = 0.8;
            /// its mean
            param mean: N*m = 0.0;
            /// angular frequency
            param omega: rad/s = 1.5;
            /// phase at t = 0
            param phase: rad = 0.0;
            /// stiffness
            param k: N*m = 1.5;
            /// damping
            param c: N*m*s = 0.2;
            torque steer ~ tractor: mean + m0 * sin(omega*t + phase);
            torsion tractor ~ steer: stiffness k, damping c;
        }

        /// A controller turns the steered axle until the last trailer has a heading, against a steady torque on the axle.
        effect autopilot {
            /// wanted heading of the second trailer
            param heading: rad = 0.5;
            /// wanted steering angle per error of the heading
            param kp: 1 = 0.6;
            /// wanted steering angle per integral of that error
            param ki: 1/s = 0.05;
            /// torque per error of the steering angle
            param stiff: N*m/rad = 4.0;
            /// torque per rate of the steering angle
            param damp: N*m*s/rad = 0.6;
            /// torque that pulls the steered axle aside
            param pull: N*m = 0.3;
            /// integral of the error of the heading
            state error_sum: rad*s = 0 rate heading - second.phi;
            output wanted: rad = kp*(heading - second.phi) + ki*error_sum;
            torque steer ~ tractor: stiff*(kp*(heading - second.phi) + ki*error_sum - kingpin.angle) - damp*kingpin.rate + pull;
        }

        /// A steady thrust on the rear axle.
        effect thrust {
            /// thrust
            param f: N = 3.0;
            force at A along tractor(1, 0): f;
        }

        /// Drag on tractor and trailers, at their centres of mass.
        effect resistance {
            /// drag per speed
            param linear: N*s/m = 0.5;
            /// torque per rate
            param angular: N*m*s = 0.1;
            drag at tractor(0, 0): linear linear, angular angular;
            drag at first(0, 0): linear linear, angular angular;
            drag at second(0, 0): linear linear, angular angular;
        }

        start circling {
            steer at (0, 0) velocity (1.5*cos(0.35), _);
            tractor angle 0;
            first angle 0.2;
            second angle -0.1;
        }
        start rolling {
            steer at (0, 0) angle 0.1 velocity (cos(0.1), _) rate 0;
            tractor angle 0;
            first angle 0.2;
            second angle -0.1;
        }

        /// Coasts with locked steering.
        scene locked { start circling; until 30 s; with steering; }
        /// Round a circle with locked steering, under thrust and drag.
        scene towed { start circling; until 30 s; with steering, thrust, resistance; }
        /// An autopilot turns the last trailer to a heading.
        scene piloted { start rolling; until 60 s; with autopilot, thrust, resistance; }
        /// Winds under a swinging torque on the steering.
        scene winding { start rolling; until 12 s; with slalom, thrust, resistance; }
    }
}
