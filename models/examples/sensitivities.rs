//! Derivatives of a motion by a parameter and by a start value.
//!
//! `cargo run --example sensitivities`

use ezy_core::prelude::*;

model! {
    pub model Cart {
        param k: N/m = 8;
        body cart { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ cart(0, 0): stiffness k;
        start aside { cart at (0.1, 0) velocity (0, 0); }
        scene swing { start aside; until 1 s; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = cart::Swing::default();
    let start = System::new(&scene, Backend::Auto)?.scene_start();
    let mut run = Sensitivities::new(&scene, &start, ["k", "cart.x"], Method::dop853(1e-12))?;
    run.advance(1.0)?;
    let [by_stiffness, by_start] = run.tangents();
    println!("x = {:.9} m", run.state().q[0]);
    println!("dx/dk = {:.9} m^2/N", by_stiffness.q[0]); // −0.1 sin(2) / 8
    println!("dx/dx0 = {:.9}", by_start.q[0]); // cos(2)
    Ok(())
}
