//! A controller by the names of the model file: a cart is brought to x = 1 m.
//!
//! `cargo run --example controller`

use ezy_core::prelude::*;

model! {
    pub model Cart {
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        input push: N = 0;
        output place: cm = cart.x;
        force at cart(0, 0): (push, 0);
        start here { cart at (0, 0); at rest; }
        scene pushed { start here; until 5 s; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = cart::Pushed::default();
    let run = Simulation::new(&scene)
        .method(Method::rk4(1e-3))
        .outputs()
        .control(|now, set| set.push = (8.0 * (1.0 - now.cart.x) - 8.0 * now.cart.vx).clamp(-4.0, 4.0))
        .run()?;
    println!("{:.3} cm after {} s", run.last().get("output.place")?, run.last().t);
    Ok(())
}
