//! A Segway: an inverted pendulum on a wheel, with a motor between them and a controller that balances.
//!
//! `cargo run --example segway` prints how it rides; `cargo run --example segway -- list` is its command line.

use ezy_core::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::process::ExitCode;

model! {
    /// Seen from the side: a wheel on the floor, and a rider above its axle.
    pub model Segway {
        param r: m = 0.25;
        /// axle to the rider's centre of mass
        param l: m = 0.9;
        param m_wheel: kg = 10;
        param m_rider: kg = 75;
        param i_rider: kg*m^2 = 15;
        param g: m/s^2 = 9.81;
        param tilt: deg = 5;

        body wheel { mass: m_wheel, inertia: m_wheel*r^2/2 }
        body rider { mass: m_rider, inertia: i_rider }
        slot floor: ground(0, r) ~ wheel(0, 0) along ground(1, 0);
        constraint rolling: wheel.x = -r*wheel.phi;
        hinge axle: wheel(0, 0) ~ rider(-l, 0);
        gravity (0, -g);

        input motor: N*m = 0;
        torque wheel ~ rider: motor;
        output lean: deg = pi/2 - rider.phi;
        start tilted { wheel at (0, r); rider angle pi/2 - tilt; at rest; }
        scene balance { start tilted; until 12 s; }
    }
}

use segway::Balance;

/// N·m per rad of lean, per rad/s, per m from the goal and per m/s.
pub const GAINS: [f64; 4] = [900.0, 300.0, 30.0, 70.0];
/// Where it shall stand, m.
pub const GOAL: f64 = 2.0;

/// The wheel goes where the rider leans to; to go forwards, it first lets the rider lean forwards. `part` of the gains.
pub fn controller(part: f64, goal: f64) -> impl FnMut(&Now<Balance>, &mut Inputs<Balance>) {
    move |now, set| {
        let (lean, rate) = (FRAC_PI_2 - now.rider.phi, -now.rider.omega);
        let seen = [lean, rate, (now.wheel.x - goal).clamp(-1.0, 1.0), now.wheel.vx];
        let push: f64 = seen.iter().zip(GAINS).map(|(x, gain)| x * gain).sum();
        set.motor = -part * push;
    }
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    if std::env::args().len() > 1 {
        return Ok(ezy_cli::main(&[&segway::MODEL]));
    }
    let scene = Balance::default();
    let run = Simulation::new(&scene).method(Method::rk4(2e-3)).outputs().every(2.0).control(controller(1.0, GOAL));
    println!("t [s]   place [m]   lean [deg]   motor [N m]");
    for s in run.run()?.samples() {
        println!(
            "{:4}   {:9.4}   {:10.4}   {:11.4}",
            s.t,
            s.get("wheel.x")?,
            s.get("output.lean")?,
            s.get("input.motor")?
        );
    }
    Ok(ExitCode::SUCCESS)
}
