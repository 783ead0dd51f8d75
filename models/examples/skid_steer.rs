//! A skid-steer robot: four wheels that cannot be steered and slip whenever it turns.
//!
//! `cargo run --example skid_steer` prints how it turns; `cargo run --example skid_steer -- list` is its command line.

use ezy_core::prelude::*;
use std::process::ExitCode;

model! {
    /// A robot whose wheels slip lengthwise and sideways; those of one side turn together.
    pub model SkidSteer {
        param m: kg = 40;
        param i: kg*m^2 = 3;
        /// centre of mass to the front wheels, to the rear wheels, and half the distance of the sides
        param a: m = 0.25;
        param b: m = 0.35;
        param w: m = 0.3;
        param mu = 0.6;
        param g: m/s^2 = 9.81;
        /// below this slip the friction fades
        param smooth: m/s = 0.02;
        input left: m/s = 0.6;
        input right: m/s = 1.0;

        body chassis { mass: m, inertia: i }
        point FL = chassis(a, w);
        point FR = chassis(a, -w);
        point RL = chassis(-b, w);
        point RR = chassis(-b, -w);

        // what a wheel carries, and how it slips: its point against the circumference of the wheel
        let front = m*g*b/(a + b)/2;
        let rear = m*g*a/(a + b)/2;
        let ahead = (cos(chassis.phi), sin(chassis.phi));
        let fl = FL.v - left*ahead;
        let fr = FR.v - right*ahead;
        let rl = RL.v - left*ahead;
        let rr = RR.v - right*ahead;
        force at FL: -mu*front * fl/sqrt(dot(fl, fl) + smooth^2);
        force at FR: -mu*front * fr/sqrt(dot(fr, fr) + smooth^2);
        force at RL: -mu*rear * rl/sqrt(dot(rl, rl) + smooth^2);
        force at RR: -mu*rear * rr/sqrt(dot(rr, rr) + smooth^2);

        output speed: m/s = dot(chassis.v, ahead);
        output drift: m/s = cross(ahead, chassis.v);
        start standing { chassis at (0, 0) angle 0; at rest; }
        scene turning { start standing; until 10 s; }
    }
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    if std::env::args().len() > 1 {
        return Ok(ezy_cli::main(&[&skid_steer::MODEL]));
    }
    let scene = skid_steer::Turning::default();
    let run = Simulation::new(&scene).method(Method::dop853(1e-10)).outputs().run()?;
    let [speed, drift, rate] = ["output.speed", "output.drift", "chassis.omega"].map(|name| run.last().get(name));
    let (speed, drift, rate) = (speed?, drift?, rate?);
    println!("wheels: 0.6 m/s on the left, 1 m/s on the right");
    println!("robot: {speed:.6} m/s ahead, {drift:.6} m/s to the left, {rate:.6} rad/s");
    println!("without slip it would turn with {:.6} rad/s", (1.0 - 0.6) / (2.0 * scene.w));
    println!("centre of the turn: {:.4} m ahead, {:.4} m to the left", -drift / rate, speed / rate);
    Ok(ExitCode::SUCCESS)
}
