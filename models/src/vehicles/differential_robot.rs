//! The differential-drive robot: a chassis on two wheels of one axle, each with its own motor.
//!
//! ```text
//!  ▬ left
//!  │     w
//!  A ───────(chassis)        drawn at chassis.phi = 0; a castor ahead carries no force in the plane
//!  │   a
//!  ▬ right
//! ```
//!
//! Coordinates: x, y, φ of `chassis`, `left`, `right`, where φ of a wheel is the angle by which it has rolled forwards;
//! rows: `left_end`, `right_end` with two components each, `axle`, `left_rolling`, `right_rolling`; at prescribed speeds:
//! `left_motor`, `right_motor`.
//! Degrees of freedom: 5 at position level, 2 at velocity level; at prescribed speeds 3 and 0. A wheel's inertia about its axle counts
//! for rolling; that about the vertical is part of the chassis. The speed of A is r (ω1 + ω2)/2 and the rate of the chassis
//! r (ω2 − ω1)/(2w) with ω1, ω2 of the left and right wheel. With a = 0, steady torques from rest lead round a circle of
//! radius w (τ2 + τ1)/(τ2 − τ1) · J/(w² M) with M = m + 2 m_w + 2 I_w/r², J = j + 2 w² (m_w + I_w/r²).
//! Source: Campion, Bastin, d'Andréa-Novel, IEEE Trans. Robotics and Automation 12 (1996), type (2, 0). Numbers are our own.
//!
#![doc = include_str!("../../sketches/differentialrobot.html")]

use ezy_core::model;

model! {
    /// A chassis on two driven wheels.
    pub model DifferentialRobot {
        /// half the distance of the wheels
        param w: m = 0.2;
        /// radius of a wheel
        param r: m = 0.05;
        /// chassis's centre of mass, ahead of the axle
        param a: m = 0.0;
        /// mass of the chassis
        param m: kg = 4.0;
        /// moment of inertia of the chassis
        param j: kg*m^2 = 0.08;
        /// mass of a wheel
        param m_wheel: kg = 0.3;
        /// moment of inertia of a wheel about its axle
        param i_wheel: kg*m^2 = 0.0004;

        body chassis { mass: m, inertia: j }
        body left { mass: m_wheel, inertia: i_wheel }
        body right { mass: m_wheel, inertia: i_wheel }

        point A = chassis(-a, 0);

        hinge left_end: chassis(-a, w) ~ left(0, 0);
        hinge right_end: chassis(-a, -w) ~ right(0, 0);
        skate axle: at A along chassis(1, 0);
        roll left_rolling: at chassis(-a, w) along chassis(1, 0) = r * left.omega;
        roll right_rolling: at chassis(-a, -w) along chassis(1, 0) = r * right.omega;

        /// Steady torques of the motors on the wheels.
        effect torques {
            /// torque on the left wheel
            param left_torque: N*m = 0.02;
            /// torque on the right wheel
            param right_torque: N*m = 0.03;
            torque left: left_torque;
            torque right: right_torque;
        }

        /// Electric motors at steady voltages, in place of given torques.
        effect motors {
            /// voltage of the left motor
            param left_voltage: V = 6.0;
            /// voltage of the right motor
            param right_voltage: V = 7.0;
            /// resistance of a winding
            param resistance: ohm = 1.5;
            /// inductance of a winding
            param inductance: H = 0.02;
            /// torque of a motor per current, and voltage per rate
            param k: N*m/A = 0.06;
            /// current of the left motor
            state left_current: A = 0 rate (left_voltage - resistance*left_current - k*left.omega)/inductance;
            /// current of the right motor
            state right_current: A = 0 rate (right_voltage - resistance*right_current - k*right.omega)/inductance;
            /// energy that the batteries supply
            state supplied: J = 0 rate left_voltage*left_current + right_voltage*right_current;
            /// heat of the windings
            state heat: J = 0 rate resistance*(left_current^2 + right_current^2);
            torque left: k * left_current;
            torque right: k * right_current;
        }

        /// Torque of the bearings against the motion of the wheels.
        effect bearings {
            /// torque per rate
            param c: N*m*s = 0.005;
            torque left: -c * left.omega;
            torque right: -c * right.omega;
        }

        /// The speeds of the wheels are prescribed.
        effect speeds {
            /// rate of the left wheel
            param left_rate: rad/s = 8.0;
            /// rate of the right wheel
            param right_rate: rad/s = 10.0;
            drive left_motor: left.phi = left_rate * t;
            drive right_motor: right.phi = right_rate * t;
        }

        start standing { chassis at (a, 0) angle 0; left angle 0; right angle 0; at rest; }
        start moving { chassis at (a, 0) angle 0; }

        /// From rest, by steady torques.
        scene circle { start standing; until 5 s; with torques; }
        /// From rest, by steady torques against the bearings.
        scene cruise { start standing; until 60 s; with torques, bearings; }
        /// From rest, by electric motors against the bearings.
        scene electric { start standing; until 5 s; with motors, bearings; }
        /// At prescribed speeds.
        scene prescribed { start moving; until 10 s; with speeds; }
    }
}
