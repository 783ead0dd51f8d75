//! A frame on a rear wheel, with a fork that steers its front wheel.
//!
//! ```text
//!       l          l    trail
//!  R ───────(frame)─────F──o        R, F wheels   o hinge `head`, drawn straight
//! ```
//!
//! Coordinates: `frame.x frame.y frame.phi fork.x fork.y fork.phi`; rows: `head.x head.y rear front`.
//! Degrees of freedom: 4 at position level, 2 at velocity level: it rolls, and it steers.
//!
//! This is a vehicle to start from: change it, or write your own in its place. All words of the language, with what they mean, are in
//! `docs/language.md` of EZY.

use ezy_core::model;

model! {
    /// A frame on a rear wheel, with a fork that steers its front wheel.
    pub model MyMechanism {
        // Parameters have a unit and a value. A run can change each: `--set l=0.6`.
        /// from the frame's centre of mass to the rear wheel, and to the head
        param l: m = 0.5;
        /// from the head back to where the front wheel touches the ground
        param trail: m = 0.05;
        /// mass of frame and rider
        param m: kg = 80.0;
        /// their moment of inertia
        param i: kg*m^2 = 6.0;

        // Bodies move in the plane: x, y of the centre of mass and the angle phi; vx, vy and omega are their rates.
        body frame { mass: m, inertia: i }
        body fork { mass: 2, inertia: 0.04 }

        // Points are given in the axes of a body, from its centre of mass.
        point R = frame(-l, 0);
        point F = fork(-trail, 0);

        // A hinge joins two points. A skate is a wheel: its point does not move across the direction.
        hinge head: frame(l, 0) ~ fork(0, 0);
        skate rear: at R along frame(1, 0);
        skate front: at F along fork(1, 0);

        // Forces without an effect act in every scene.
        torsion frame ~ fork: stiffness 0, damping 0.5;

        // An effect acts in the scenes that name it, and costs nothing in the others.
        /// The air holds it back.
        effect air {
            /// force per square of the speed
            param k: N*s^2/m^2 = 0.3;
            drag at frame(0, 0): quadratic k;
        }

        /// Hands turn the fork.
        effect hands {
            // Inputs are set while the scene runs: by `--input`, from a file, or by a controller.
            /// torque of the hands on the fork
            input steer: N*m = 0.0;
            // Outputs are recorded beside the coordinates.
            output steering: deg = head.angle;
            output speed: m/s = dot(frame.v, (cos(frame.phi), sin(frame.phi)));
            torque fork ~ frame: steer;
        }

        // A start gives what is known. The constraints give the rest; what they leave open changes from 0 as little as possible.
        start aside { frame at (0, 1) angle 0 velocity (5, _); fork angle 0.1; }

        /// It rolls out against the air.
        scene coast { start aside; until 10 s; with air; }
        /// Somebody steers: set `steer`.
        scene ridden { start aside; until 10 s; with air, hands; }
    }
}
