//! A sweep over a parameter, as CSV: the period of a pendulum over its amplitude.
//!
//! `cargo run --example sweep > periods.csv`

use ezy_core::prelude::*;

model! {
    pub model Pendulum {
        param amplitude: deg = 10;
        body bob { mass: 1, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(0, 1);
        gravity (0, -9.81);
        event turning: bob.omega = 0;
        start aside { bob angle amplitude; at rest; }
        scene swing { start aside; until 10 s; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("amplitude [deg],period [s]");
    for amplitude in (10..=170).step_by(20).map(f64::from) {
        let scene = pendulum::Swing { amplitude };
        let run = Simulation::new(&scene).method(Method::taylor(1e-12)).run()?;
        let [first, second, ..] = run.events() else { return Err("it does not turn back twice".into()) };
        println!("{amplitude},{:.9}", 2.0 * (second.state.t - first.state.t));
    }
    Ok(())
}
