//! The vehicles of the guide's chapter on stability, with the command line of a crate that `ezy new towed` wrote: a car with a trailer, and a
//! caster. Their numbers are our own.

use ezy_core::model;
use std::process::ExitCode;

model! {
    /// A car on two tyres, and a trailer behind its rear axle.
    pub model Caravan {
        /// from the car's centre of mass to its axles, and to the hitch
        param front: m = 1.2; param rear: m = 1.5; param hitch_at: m = 2.4;
        /// mass and moment of inertia of the car
        param m: kg = 1500; param i: kg*m^2 = 2500;
        /// from the trailer's centre of mass forward to the hitch, and from the hitch back to its axle
        param pole: m = 3; param l: m = 3.3;
        /// mass and moment of inertia of the trailer
        param m_trailer: kg = 1000; param i_trailer: kg*m^2 = 1800;
        /// damping of the hitch
        param damper: N*m*s = 0;
        /// angle of the front wheel
        input steer: rad = 0;

        body car { mass: m, inertia: i }
        body trailer { mass: m_trailer, inertia: i_trailer }
        hinge hitch: car(-hitch_at, 0) ~ trailer(pole, 0);
        point F = car(front, 0);
        force at F along car(0, 1): 9e4 N/rad * (steer - slip_angle(F, car));
        tyre at car(-rear, 0) along car(1, 0): stiffness 1.1e5;
        tyre at trailer(pole - l, 0) along trailer(1, 0): stiffness 6e4;
        torsion car ~ trailer: stiffness 0, angle 0, damping damper;

        output yaw_rate: rad/s = car.omega;
        output hitch_angle: rad = hitch.angle;

        start straight { car at (0, 0) angle 0 velocity (20, 0) rate 0; trailer angle 0; }
        scene tows { start straight; until 10 s; }
    }
}

model! {
    /// A wheel that trails behind its pivot on a sprung carriage.
    pub model Caster {
        /// speed at which the carriage is drawn
        param v: m/s = 3;
        /// from the pivot back to the wheel, and to the centre of mass of the fork
        param trail: m = 0.25; param centre: m = 0.1;
        /// mass and moment of inertia of the fork with its wheel
        param m: kg = 8; param i: kg*m^2 = 0.4;
        /// stiffness and damping of the carriage sideways
        param k: N/m = 60000; param c: N*s/m = 60;

        body carriage { mass: 20, inertia: 1 }
        body fork { mass: m, inertia: i }
        hinge pivot: carriage(0, 0) ~ fork(centre, 0);
        drive tow: carriage.x = v*t;
        constraint level: carriage.phi = 0;
        skate wheel: at fork(centre - trail, 0) along fork(1, 0);
        torsion carriage ~ fork: stiffness 20, angle 0, damping 1;
        force at carriage(0, 0): (0, -k*carriage.y - c*carriage.vy);

        start straight { carriage at (0, 0) angle 0; carriage velocity (v, 0) rate 0; fork angle 0; }
        scene rolls { start straight; until 5 s; }
    }
}

fn main() -> ExitCode {
    ezy_cli::main(&[&caravan::MODEL, &caster::MODEL])
}
