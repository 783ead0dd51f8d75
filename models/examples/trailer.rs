//! A trailer that is backed along a line: a controller steers the tractor so that it does not jack-knife.
//!
//! `cargo run --example trailer` prints the way back; `cargo run --example trailer -- list` is its command line.

use ezy_core::prelude::*;
use std::process::ExitCode;

model! {
    /// A tractor with a steered axle, and a trailer that is hitched to its rear axle.
    pub model Trailer {
        /// between the axles of the tractor; from its rear axle to that of the trailer
        param wheelbase: m = 3;
        param l: m = 5;
        param speed: m/s = 1;
        /// hitch angle and place of the trailer's axle at the start
        param bend: deg = 10;
        param aside: m = 2;

        body steer { mass: 100, inertia: 5 }
        body tractor { mass: 2000, inertia: 3000 }
        body trailer { mass: 1500, inertia: 3000 }
        point A = tractor(-wheelbase/2, 0);
        point B = trailer(-l/2, 0);

        hinge kingpin: tractor(wheelbase/2, 0) ~ steer(0, 0);
        hinge hitch: A ~ trailer(l/2, 0);
        skate steered: at steer(0, 0) along steer(1, 0);
        skate driven: at A along tractor(1, 0);
        skate towed: at B along trailer(1, 0);
        roll reverse: at A along tractor(1, 0) = -speed;

        input moment: N*m = 0;
        torque steer ~ tractor: moment;
        output bent: deg = tractor.phi - trailer.phi;
        output steering: deg = kingpin.angle;
        output off: m = B.y;
        start askew { trailer at (0, aside) angle 0; tractor angle bend; steer angle bend; }
        scene back { start askew; until 60 s; }
    }
}

use trailer::Back;

/// N·m per rad and per rad/s of the steered axle.
const STIFFNESS: f64 = 2000.0;
const DAMPING: f64 = 200.0;

/// Steers so that the hitch angle tends to `wanted(off, heading of the trailer)`, with a rate of 1/s.
pub fn bending<'s>(
    scene: &'s Back,
    wanted: impl Fn(f64, f64) -> f64 + 's,
) -> impl FnMut(&Now<Back>, &mut Inputs<Back>) + 's {
    move |now, set| {
        let bent = now.tractor.phi - now.trailer.phi;
        let off = now.trailer.y - scene.l / 2.0 * now.trailer.phi.sin();
        // d(bent)/dt = speed (sin(bent)/l − tan(steering)/wheelbase)
        let rate = -(bent - wanted(off, now.trailer.phi));
        let steering = (scene.wheelbase * (bent.sin() / scene.l - rate / scene.speed)).atan().clamp(-0.7, 0.7);
        let (angle, turning) = (now.steer.phi - now.tractor.phi, now.steer.omega - now.tractor.omega);
        set.moment = STIFFNESS * (steering - angle) - DAMPING * turning;
    }
}

/// Bends the train towards the line y = 0: the farther away, the more the trailer shall head for it.
pub fn to_the_line(off: f64, heading: f64) -> f64 {
    (1.5 * (heading - (0.15 * off).clamp(-0.5, 0.5))).clamp(-0.6, 0.6)
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    if std::env::args().len() > 1 {
        return Ok(ezy_cli::main(&[&trailer::MODEL]));
    }
    let scene = Back::default();
    let run = Simulation::new(&scene).method(Method::rk4(0.01)).outputs().every(10.0);
    println!("t [s]   off the line [m]   hitch [deg]   steering [deg]");
    for s in run.control(bending(&scene, to_the_line)).run()?.samples() {
        let [off, bent, steering] = ["off", "bent", "steering"].map(|name| s.get(&format!("output.{name}")));
        println!("{:4}   {:15.4}   {:11.4}   {:14.4}", s.t, off?, bent?, steering?);
    }
    Ok(ExitCode::SUCCESS)
}
