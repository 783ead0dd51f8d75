//! Four runs that step together, in lanes: throws at four angles, and how far they go in one second.
//!
//! `cargo run --example ensemble`

use ezy_core::prelude::*;

model! {
    pub model Throw {
        param angle: deg = 45;
        body ball { mass: 1, inertia: 1 }
        gravity (0, -9.81);
        drag at ball(0, 0): quadratic 0.05;
        start thrown { ball at (0, 0) angle 0 velocity 20 * (cos(angle), sin(angle)); }
        scene flight { start thrown; until 1 s; }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scenes = [20.0, 40.0, 60.0, 80.0].map(|angle| throw::Flight { angle });
    let mut starts = Vec::new();
    for scene in &scenes {
        let mut system = System::new(scene, Backend::Auto)?;
        starts.push(system.consistent_start(&system.scene_start())?);
    }
    let mut ensemble = Ensemble::<_, 4>::new(&scenes, std::array::from_fn(|i| &starts[i]), Method::dop853(1e-10))?;
    ensemble.advance(1.0)?;
    for (lane, scene) in scenes.iter().enumerate() {
        let q = ensemble.state(lane).q;
        println!("{} deg: x = {:.6} m, y = {:.6} m", scene.angle, q[0], q[1]);
    }
    Ok(())
}
