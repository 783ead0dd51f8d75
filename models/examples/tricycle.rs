//! The vehicle of the guide (docs/guide, second chapter) with the command line of a crate that `ezy new tricycle` wrote.

use ezy_core::model;
use std::process::ExitCode;

model! {
    /// A frame on a rear wheel, with a fork that steers its front wheel.
    pub model Tricycle {
        /// from the frame's centre of mass to the rear wheel, and to the head
        param l: m = 0.5;
        /// from the head back to where the front wheel touches the ground
        param trail: m = 0.05;
        /// mass of frame and rider
        param m: kg = 80.0;
        /// their moment of inertia
        param i: kg*m^2 = 6.0;

        body frame { mass: m, inertia: i }
        body fork { mass: 2, inertia: 0.04 }

        point R = frame(-l, 0);
        point F = fork(-trail, 0);

        hinge head: frame(l, 0) ~ fork(0, 0);
        skate rear: at R along frame(1, 0);
        skate front: at F along fork(1, 0);

        torsion frame ~ fork: stiffness 0, damping 0.5;

        /// The air holds it back.
        effect air {
            /// force per square of the speed
            param k: N*s^2/m^2 = 0.3;
            drag at frame(0, 0): quadratic k;
        }

        /// Hands turn the fork.
        effect hands {
            /// torque of the hands on the fork
            input steer: N*m = 0.0;
            output steering: deg = head.angle;
            output speed: m/s = dot(frame.v, (cos(frame.phi), sin(frame.phi)));
            torque fork ~ frame: steer;
        }

        start aside { frame at (0, 1) angle 0 velocity (5, _); fork angle 0.1; }

        /// It rolls out against the air.
        scene coast { start aside; until 10 s; with air; }
        /// Somebody steers: set `steer`.
        scene ridden { start aside; until 10 s; with air, hands; }

        /// The road goes down along x.
        effect slope {
            param incline: deg = 3;
            gravity (9.81 m/s^2 * sin(incline), 0);
        }
        start standing { frame at (0, 0) angle 0; fork angle 0; at rest; }
        event bottom: frame.x > 50;
        /// It rolls down until it is at the bottom.
        scene downhill { start standing; until 60 s; until bottom; with air, slope; }
    }
}

fn main() -> ExitCode {
    ezy_cli::main(&[&tricycle::MODEL])
}
