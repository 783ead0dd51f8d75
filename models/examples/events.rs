//! Events: when a ball is highest, and where it lands.
//!
//! `cargo run --example events`

use ezy_core::prelude::*;

model! {
    pub model Throw {
        body ball { mass: 1, inertia: 1 }
        gravity (0, -10);
        event top: ball.vy = 0;
        event landing: ball.y < 0;
        start up { ball at (0, 0) velocity (3, 12); }
        scene flight { start up; until 60 s; until landing; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let run = Simulation::new(&throw::Flight::default()).run()?;
    for found in run.events() {
        println!("{} at {:.9} s, x = {:.9} m", found.event.name, found.state.t, found.state.q[0]);
    }
    println!("{}", run.outcome);
    Ok(())
}
