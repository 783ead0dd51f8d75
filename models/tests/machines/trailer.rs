//! The backed trailer: its hitch angle tends to what is wanted, and folds as the closed form says when nobody steers.

use crate::examples::trailer::trailer::Back;
use crate::examples::trailer::{bending, to_the_line};
use ezy_core::prelude::*;

/// Straight back, d(bent)/dt = speed sin(bent)/l: tan(bent/2) grows as e^(speed t/l).
#[test]
fn analytic_trailer_jack_knifes_when_nobody_steers() {
    let scene = Back { bend: 2.0, ..Default::default() };
    let run = Simulation::new(&scene).method(Method::dop853(1e-11)).outputs().every(1.0).until(15.0);
    let run = run.run().unwrap();
    for s in run.samples() {
        let expected = 2.0 * ((scene.bend.to_radians() / 2.0).tan() * (scene.speed * s.t / scene.l).exp()).atan();
        let bent = s.get("output.bent").unwrap().to_radians();
        // twenty times the start, from a tolerance of 1e-11
        assert!((bent - expected).abs() <= 1e-8, "{}: {bent} {expected}", s.t);
    }
    assert!(run.last().get("output.bent").unwrap() > 35.0, "it folds");
}

#[test]
fn analytic_hitch_angle_tends_to_the_one_that_is_wanted() {
    for wanted in [-0.3, 0.2, 0.5] {
        let scene = Back::default();
        let run = Simulation::new(&scene).method(Method::rk4(0.01)).outputs().until(40.0);
        let run = run.control(bending(&scene, |_, _| wanted)).run().unwrap();
        let last = run.last();
        // by then e^-40 is left of the start
        assert!((last.get("output.bent").unwrap().to_radians() - wanted).abs() < 1e-9, "{wanted}");
        // a steady circle: both bodies turn as fast, each about its own rear axle
        let rate = -scene.speed * wanted.sin() / scene.l;
        let steering = (-rate * scene.wheelbase / scene.speed).atan();
        assert!((last.get("trailer.omega").unwrap() - rate).abs() < 1e-9, "{wanted}");
        assert!((last.get("tractor.omega").unwrap() - rate).abs() < 1e-9, "{wanted}");
        assert!((last.get("output.steering").unwrap().to_radians() - steering).abs() < 1e-8, "{wanted}");
    }
}

#[test]
fn invariant_trailer_is_backed_onto_the_line() {
    for (aside, bend) in [(2.0, 10.0), (-3.0, 10.0), (0.5, -20.0)] {
        let scene = Back { aside, bend, ..Default::default() };
        let run = Simulation::new(&scene).method(Method::rk4(0.01)).outputs().every(0.1);
        let run = run.control(bending(&scene, to_the_line)).run().unwrap();
        assert!(run.column("output.bent").unwrap().iter().all(|bent| bent.abs() < 45.0), "{aside}: it folds");
        // the laws along the line are slower than 0.1/s nowhere: a minute leaves e^-6 of the start
        assert!(run.last().get("output.off").unwrap().abs() < 3.0 * f64::exp(-6.0), "{aside}");
        assert!(run.last().get("trailer.x").unwrap() < -50.0, "{aside}: backwards");
    }
}
